//! For people.

use fumetto::ImportedSize;
use fumetto_formats::is_sequence;
use fumetto_scene::limits::PARTICLE_BYTES;
use fumetto_scene::{GridPlan, Light, Matter, Object, Ramp, Scene, Style, VolumeRoom, Width, vortex_bytes};
use indicatif::{BinaryBytes, HumanCount};

use super::{Load, background, duration_secs, hex, is_by_tiles, light_kind, sum};

/// What is in the scene `name`, and what its objects hold.
pub(super) fn of(name: &str, scene: &Scene, loads: &[Load]) -> String {
    let ([width, height], samples) = (scene.output.size, scene.output.antialias);
    let tiles = if is_by_tiles(scene) { ", drawn by tiles" } else { "" };
    let ([first, last], time) = (scene.time.frames, &scene.time);
    let cameras: Vec<&str> = scene.cameras.iter().map(|camera| camera.name.as_str()).collect();
    let lights: Vec<String> = scene.lights.iter().map(light_words).collect();
    let pre_roll = if time.pre_roll > 0.0 {
        format!(", from {} s before frame 0", time.pre_roll)
    } else {
        String::new()
    };
    let lights = if lights.is_empty() { "none".to_owned() } else { lights.join(", ") };
    let mut lines = vec![
        name.to_owned(),
        format!("  picture     {width} x {height} pixels, {samples} x {samples} samples each{tiles}"),
        format!("  frames      {first} to {last}, {} a second: {:.1} s", time.fps, duration_secs(scene)),
        format!(
            "  drawn       every {}, simulated in {}{pre_roll}",
            counted(time.hold, "frame"),
            steps(time.substeps)
        ),
        format!("  cameras     {}", cameras.join(", ")),
        format!("  lights      {lights}"),
        format!("  background  {}", background(scene)),
    ];
    for (object, load) in scene.objects.iter().zip(loads) {
        lines.push(format!(
            "  `{}`: {}{}",
            object.name,
            matter(object),
            if object.visible { "" } else { ", hidden" }
        ));
        lines.extend(load_words(load));
        lines.extend(vortex_words(load.vortices));
        lines.extend(load.grid.as_ref().map(grid_words));
        let surface = load.surface.map(|room| surface_words("surface", room.triangles, load.surface_bytes()));
        lines.extend(surface);
        lines.extend(load.details.iter().map(|room| surface_words("detail", room.triangles, room.bytes())));
        lines.extend(load.volume.as_ref().map(volume_words));
        lines.extend(load.imported.as_ref().map(imported_words));
        lines.push(format!("    style     {}", style_words(&object.style)));
    }
    let sum = sum(loads);
    lines.push(format!("  in all      {}", cost(sum.particles, sum.bytes)));
    lines.join("\n")
}

fn load_words(load: &Load) -> Option<String> {
    match load {
        Load { imported: Some(_), .. } => None,
        Load { paint: Some(room), .. } => Some(format!(
            "    paint     {} volumes, {} on the GPU",
            HumanCount(room.volumes),
            BinaryBytes(room.bytes)
        )),
        Load { triangles: 0, particles, .. } => {
            Some(format!("    particles {}", cost(*particles, particles.saturating_mul(PARTICLE_BYTES))))
        }
        Load { triangles, .. } => Some(format!("    triangles {}", HumanCount(*triangles))),
    }
}

fn vortex_words(vortices: u64) -> Option<String> {
    (vortices > 0).then(|| format!("    vortices  {}", cost(vortices, vortex_bytes(vortices))))
}

fn grid_words(grid: &GridPlan) -> String {
    let [x, y, z] = grid.cells;
    let steps = if grid.sub_steps == 1 { "sub-step" } else { "sub-steps" };
    let bytes = BinaryBytes(grid.bytes());
    format!(
        "    grid      {x} x {y} x {z} cells of {:.3} m, {} {steps} a step, {bytes} on the GPU",
        grid.side, grid.sub_steps
    )
}

fn surface_words(what: &str, triangles: u32, bytes: u64) -> String {
    let (triangles, bytes) = (HumanCount(triangles.into()), BinaryBytes(bytes));
    format!("    {what:<9} at most {triangles} triangles, {bytes} on the GPU")
}

fn volume_words(room: &VolumeRoom) -> String {
    let ([x, y, z], [a, b, c], bytes) = (room.cells, room.light_cells, BinaryBytes(room.bytes()));
    format!("    volume    {x} x {y} x {z} cells, {a} x {b} x {c} of light, {bytes} on the GPU")
}

fn imported_words(size: &ImportedSize) -> String {
    let (voxels, bricks) = (HumanCount(size.voxels), HumanCount(size.bricks.into()));
    format!("    volume    {voxels} voxels in {bricks} bricks, {} on the GPU", BinaryBytes(size.bytes))
}

fn cost(particles: u64, bytes: u64) -> String {
    format!("at most {} at once, {} on the GPU", HumanCount(particles), BinaryBytes(bytes))
}

fn counted(number: u32, what: &str) -> String {
    if number == 1 { what.to_owned() } else { format!("{number} {what}s") }
}

fn steps(substeps: u32) -> String {
    if substeps == 1 { "1 step a frame".to_owned() } else { format!("{substeps} steps a frame") }
}

fn light_words(light: &Light) -> String {
    let shadows = if light.shadow { "" } else { " without shadows" };
    format!("{}{shadows}", light_kind(light))
}

fn matter(object: &Object) -> String {
    match &object.matter {
        Matter::Still(_) => "particles in the scene file".to_owned(),
        Matter::File(path) if is_sequence(path) => format!("particles in {path}, by frame"),
        Matter::File(path) => format!("particles in {path}"),
        Matter::Morph(morph) if morph.changes.len() == 1 => "particles that become others".to_owned(),
        Matter::Morph(morph) => format!("particles that become others {} times", morph.changes.len()),
        Matter::Imported(imported) if is_sequence(&imported.file) => {
            format!("the volumes {}, by frame", imported.file)
        }
        Matter::Imported(imported) => format!("the volume {}", imported.file),
        Matter::Mesh(mesh) if mesh.copies.len() == 1 => format!("the model {}", mesh.model),
        Matter::Mesh(mesh) => format!("{} copies of the model {}", mesh.copies.len(), mesh.model),
        Matter::Paint(paint) if paint.layers() > 1 => format!("paint in {} washes", paint.layers()),
        Matter::Paint(_) => "paint that spreads".to_owned(),
        Matter::Smoke(smoke) => {
            let counted =
                |number: usize, what: &str| format!("{number} {what}{}", if number == 1 { "" } else { "s" });
            let (emitters, forces) =
                (counted(smoke.emitters.len(), "emitter"), counted(smoke.forces.len(), "force"));
            format!("smoke of {emitters}, moved by {forces}")
        }
    }
}

fn style_words(style: &Style) -> String {
    let tones = match &style.ramp {
        Ramp::Tones(tones) => {
            let colours: Vec<String> = tones.iter().map(|tone| hex(tone.colour.to_srgb8())).collect();
            format!("tones {}", colours.join(" "))
        }
        Ramp::Image(ramp) => format!("ramp {}", ramp.path),
        Ramp::Gooch(gooch) => {
            format!("from cool {} to warm {}", hex(gooch.cool.to_srgb8()), hex(gooch.warm.to_srgb8()))
        }
    };
    let ink = match (style.ink.on, style.ink.width) {
        (false, _) => "no ink".to_owned(),
        (true, Width::Px(px)) => format!("ink {} {px} px wide", hex(style.ink.colour.to_srgb8())),
        (true, Width::World(metres)) => format!("ink {} {metres} m wide", hex(style.ink.colour.to_srgb8())),
    };
    format!("{tones}; {ink}; {}", if style.shadow.on { "shadows" } else { "no shadows" })
}

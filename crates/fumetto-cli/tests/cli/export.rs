//! What `fumetto export` writes.

use fumetto_formats::{Model, ModelOptions, read_model, read_particles, read_volume};
use serde_json::Value;

use crate::run::{Folder, SMOKE};

/// With the smoke of `smoke.toml` under a skin in `skin.toml`.
fn folder() -> Folder {
    let folder = Folder::with_smoke();
    let skin = "kind = \"smoke\"\nshape = { surface = { subdivisions = 12 } }";
    folder.put("skin.toml", SMOKE.replace("kind = \"smoke\"", skin));
    folder
}

fn model(folder: &Folder, name: &str) -> Model {
    let read = &mut |beside: &str| Ok(folder.bytes(beside));
    read_model(name, &folder.bytes(name), ModelOptions::default(), read).unwrap()
}

fn lines(out: &str) -> Vec<Value> {
    out.lines().map(|line| serde_json::from_str(line).unwrap()).collect()
}

#[test]
fn meshes_are_the_same_in_all_formats() {
    let folder = folder();
    for name in ["a.glb", "a.obj", "a.ply"] {
        let ran = folder.run(&["export", "skin.toml", "-o", name, "--frame", "4", "--json"]).ends(0);
        let [told, done] = &lines(&ran.out)[..] else { panic!("{}", ran.out) };
        let triangles = told["triangles"].as_u64().unwrap();
        assert!(triangles > 100);
        assert_eq!((told["file"].as_str(), told["frame"].as_u64()), (Some(name), Some(4)));
        assert_eq!(told["objects"][0]["name"], "smoke");
        assert_eq!((done["done"].as_bool(), done["files"].as_u64()), (Some(true), Some(1)));
        if name != "a.ply" {
            let model = model(&folder, name);
            assert_eq!(model.triangle_count(), triangles, "{name}");
            assert_eq!(model.materials[0].name, "smoke");
        }
        ran.says(&[&format!("wrote {name}: {triangles} triangles")]);
    }
    assert_eq!(folder.files(), ["a.glb", "a.mtl", "a.obj", "a.ply", "skin.toml"]);
    assert!(folder.bytes("a.obj").starts_with(b"# Fumetto: metres, +Y up\nmtllib a.mtl\n"));
}

#[test]
fn sequences_hold_drawings_and_may_begin_with_nothing() {
    let folder = folder();
    let ran = folder.run(&["export", "skin.toml", "-o", "s.#.glb", "--frames", "0..3"]).ends(0);
    ran.says(&["wrote s.0.glb: 0 triangles", "wrote s.3.glb"]);
    assert_eq!(folder.bytes("s.2.glb"), folder.bytes("s.3.glb"), "drawn on twos");
    assert_ne!(folder.bytes("s.0.glb"), folder.bytes("s.2.glb"));
    folder.run(&["export", "skin.toml", "-o", "last.glb"]).ends(0);
    folder.run(&["export", "skin.toml", "-o", "five.glb", "--frame", "5"]).ends(0);
    assert_eq!(folder.bytes("last.glb"), folder.bytes("five.glb"), "one file shows the last frame");
}

#[test]
fn particles_are_read_back() {
    let folder = folder();
    folder.run(&["export", "smoke.toml", "-o", "p.csv", "--frame", "3"]).ends(0).says(&["particles"]);
    folder.run(&["export", "smoke.toml", "-o", "p.ply", "--frame", "3", "--what", "particles"]).ends(0);
    let [csv, ply] = ["p.csv", "p.ply"].map(|name| read_particles(name, &folder.bytes(name)).unwrap());
    assert_eq!(csv, ply);
    assert!((12..=14).contains(&csv.particles.len()), "8 at once, and 20 a second: {}", csv.particles.len());
    assert!(csv.particles.iter().all(|particle| particle.radius == 0.5));
}

#[test]
fn objects_without_what_is_asked_for() {
    let folder = folder();
    folder.run(&["export", "smoke.toml", "-o", "a.glb"]).ends(1).says(&[
        "smoke.toml",
        "puffs have none",
        "--what particles",
    ]);
    folder
        .run(&["export", "skin.toml", "-o", "a.glb", "--object", "smoke", "--object", "fog"])
        .ends(2)
        .says(&["--object fog", "it has smoke"]);
    let hidden = folder.run(&["export", "skin.toml", "-o", "a.glb", "--set", "object.smoke.visible=false"]);
    hidden.ends(1).says(&["no object"]);
    assert_eq!(folder.files(), ["skin.toml"]);
}

#[test]
fn volumes_go_through_openvdb_and_back() {
    let folder = Folder::with_smoke();
    let head = "format = 1\ncamera = { eye = [0, 0, 9], target = [0, 0, 0] }\n\
                light = [{ kind = \"sun\", direction = [0, -1, 0] }]\n[[object]]\nname = \"puff\"\n";
    let puff = "kind = \"cloud\"\nparticles = [{ center = [1, 2, 3], radius = 1, mass = 2 }]\n\
                shape = { volume = { cells = 24 } }\n";
    folder.put("puff.toml", format!("{head}{puff}"));
    folder.run(&["export", "puff.toml", "-o", "puff.vdb"]).ends(0).says(&["wrote puff.vdb:", "density"]);
    let written = read_volume("puff.vdb", &folder.bytes("puff.vdb"), &["density"]).unwrap();
    let grid = &written.grids[0];
    let [low, high] = grid.voxels.active_bounds().unwrap();
    let place = |index: [i32; 3]| {
        let matrix = grid.world_from_index;
        [0, 1, 2].map(|axis| matrix[axis][axis] * f64::from(index[axis]) + matrix[3][axis])
    };
    // Around the ball, to within a cell.
    let cell = grid.world_from_index[0][0];
    for (axis, middle) in [1.0, 2.0, 3.0].into_iter().enumerate() {
        assert!((place(low)[axis] - (middle - 1.0)).abs() < 1.01 * cell, "{:?}", place(low));
        assert!((place(high)[axis] - (middle + 1.0)).abs() < 1.01 * cell, "{:?}", place(high));
    }
    assert_eq!(grid.voxels.at([0, 1, 2].map(|axis| (low[axis] + high[axis]) / 2)).0[0], 2.0);

    folder.put("again.toml", format!("{head}kind = \"volume\"\nvolume = \"puff.vdb\""));
    folder.run(&["check", "again.toml"]).ends(0);
    let info = folder.run(&["info", "again.toml"]).ends(0).out;
    assert!(info.contains("the volume puff.vdb") && info.contains("bricks"), "{info}");
    folder.run(&["export", "again.toml", "-o", "again.vdb"]).ends(0);
    let again = read_volume("again.vdb", &folder.bytes("again.vdb"), &["density"]).unwrap();
    assert_eq!(again.grids[0].world_from_index, grid.world_from_index);
    assert_eq!(again.grids[0].voxels.active_count(), grid.voxels.active_count());

    let refused = folder.run(&["export", "smoke.toml", "-o", "smoke.vdb"]);
    refused.ends(1).says(&["no object that is to be written is a volume"]);
    folder.put("broken.toml", format!("{head}kind = \"volume\"\nvolume = \"puff.toml.vdb\""));
    folder.put("puff.toml.vdb", "not OpenVDB");
    let problems = folder.run(&["check", "broken.toml"]).ends(1).out;
    assert!(problems.contains("the volume of `puff`: puff.toml.vdb"), "{problems}");
}

#[test]
fn drawings_are_files_pages_and_animations() {
    let folder = Folder::with_smoke();
    let text = |name: &str| String::from_utf8(folder.bytes(name)).unwrap();
    let ran = folder.run(&["export", "smoke.toml", "-o", "a.svg", "--frame", "4", "--json"]).ends(0);
    let told = &lines(&ran.out)[0];
    assert!(told["shapes"].as_u64().unwrap() > 2 && told["segments"].as_u64().unwrap() > 8, "{told}");
    let svg = text("a.svg");
    for says in [
        r#"viewBox="0 0 64 36""#,
        r#"inkscape:label="tones""#,
        r#"id="tones-smoke-tone-f4f7f9""#,
        r##"fill="#f4f7f9""##,
        r#"id="lines-smoke-silhouette""#,
    ] {
        assert!(svg.contains(says), "{says} is not in {svg}");
    }

    let many = |name: &str| folder.run(&["export", "smoke.toml", "-o", name, "--frames", "2..5"]).ends(0);
    many("b.svg").says(&["wrote b.svg: 4 frames"]);
    assert_eq!(text("b.svg").matches("<animate ").count(), 4);
    many("c.#.svg");
    assert_eq!(text("c.2.svg"), text("c.3.svg"), "drawn on twos");
    many("d.pdf");
    assert!(String::from_utf8_lossy(&folder.bytes("d.pdf")).contains("/Count 4"));

    let plot = ["export", "smoke.toml", "-o", "e.svg", "--plotter", "--width-mm", "210", "--size", "128x72"];
    folder.run(&plot).ends(0);
    let plot = text("e.svg");
    assert!(
        plot.contains(r#"width="210mm""#) && plot.contains("stroke-width") && !plot.contains("paper"),
        "{plot}"
    );
    assert!(!plot.contains(r##"fill="#"##), "{plot}");
}

//! For programs.

use fumetto_scene::{Matter, Object, Ramp, Scene, Shading, Style, SurfaceRoom};
use serde_json::{Value, json};

use super::{Load, background, duration_secs, hex, is_by_tiles, light_kind, sum};

/// What is in the scene `name`, and what its objects hold.
pub(super) fn of(name: &str, scene: &Scene, loads: &[Load]) -> Value {
    let objects: Vec<Value> =
        scene.objects.iter().zip(loads).map(|(object, load)| object_json(object, load)).collect();
    let lights: Vec<Value> = scene
        .lights
        .iter()
        .map(|light| json!({ "kind": light_kind(light), "intensity": light.intensity, "shadow": light.shadow }))
        .collect();
    json!({
        "scene": name,
        "size": scene.output.size,
        "antialias": scene.output.antialias,
        "tiles": is_by_tiles(scene),
        "frames": scene.time.frames,
        "fps": scene.time.fps,
        "seconds": duration_secs(scene),
        "hold": scene.time.hold,
        "substeps": scene.time.substeps,
        "pre_roll": scene.time.pre_roll,
        "cameras": scene.cameras.iter().map(|camera| camera.name.as_str()).collect::<Vec<_>>(),
        "lights": lights,
        "background": background(scene),
        "objects": objects,
        "particles": sum(loads).particles,
        "triangles": sum(loads).triangles,
        "bytes": sum(loads).bytes,
    })
}

fn object_json(object: &Object, load: &Load) -> Value {
    let (kind, emitters, forces, file) = match &object.matter {
        Matter::Still(_) => ("cloud", 0, 0, None),
        Matter::File(path) => ("cloud", 0, 0, Some(path)),
        Matter::Morph(_) => ("cloud", 0, 0, None),
        Matter::Imported(imported) => ("volume", 0, 0, Some(&imported.file)),
        Matter::Mesh(mesh) => ("mesh", 0, 0, Some(&mesh.model)),
        Matter::Paint(_) => ("paint", 0, 0, None),
        Matter::Smoke(smoke) => ("smoke", smoke.emitters.len(), smoke.forces.len(), None),
    };
    let detail = |room: &SurfaceRoom| json!({ "triangles": room.triangles, "bytes": room.bytes() });
    json!({
        "name": object.name,
        "kind": kind,
        "visible": object.visible,
        "emitters": emitters,
        "forces": forces,
        "file": file,
        "particles": load.particles,
        "vortices": load.vortices,
        "grid": load.grid.map(|grid| json!({
            "cells": grid.cells, "side": grid.side, "sub_steps": grid.sub_steps, "bytes": grid.bytes(),
        })),
        "triangles": load.triangles,
        "surface": load.surface.map(|room| json!({ "triangles": room.triangles, "bytes": load.surface_bytes() })),
        "details": load.details.iter().map(detail).collect::<Vec<_>>(),
        "volume": load.volume.map(|room| json!({
            "cells": room.cells, "light_cells": room.light_cells, "bytes": room.bytes(),
        })),
        "imported": load.imported.as_ref().map(|size| json!({
            "voxels": size.voxels, "bricks": size.bricks, "bytes": size.bytes,
        })),
        "paint": load.paint.map(|room| json!({ "volumes": room.volumes, "bytes": room.bytes })),
        "bytes": load.bytes(),
        "style": style_json(&object.style),
    })
}

fn style_json(style: &Style) -> Value {
    let (tones, ramp) = match &style.ramp {
        Ramp::Tones(tones) => (tones.iter().map(|tone| hex(tone.colour.to_srgb8())).collect(), None),
        Ramp::Image(ramp) => (Vec::new(), Some(&ramp.path)),
        Ramp::Gooch(gooch) => ([gooch.cool, gooch.warm].map(|colour| hex(colour.to_srgb8())).to_vec(), None),
    };
    let shading = match style.shading {
        Shading::Auto => "auto",
        Shading::PerPixel => "per-pixel",
        Shading::PreShaded => "pre-shaded",
    };
    json!({
        "tones": tones,
        "ramp": ramp,
        "form": style.form,
        "shading": shading,
        "ink": style.ink.on.then(|| hex(style.ink.colour.to_srgb8())),
        "shadow": style.shadow.on,
    })
}

//! Scenes after the paper's figures, and how many triangles its tables have for these.

use std::io;

use fumetto_scene::{Scene, SceneText};

use crate::{Assets, Engine, Gpu};

/// These scenes name no files.
struct NoFiles;

impl Assets for NoFiles {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Err(io::ErrorKind::NotFound.into())
    }
}

/// Triangles of each surface of a scene at a frame.
fn triangles(engine: &Engine, toml: &str, frame: u32) -> Vec<u32> {
    let text = SceneText { name: "figure", toml, ..Default::default() };
    let (scene, _) = Scene::load(&text, &mut |_| Err("there are no styles".into()))
        .unwrap_or_else(|report| panic!("{}", report.render(false)));
    let mut player = engine.play(scene, Box::new(NoFiles)).expect("the scene can be played");
    engine.seek(&mut player, frame).expect("no file is needed");
    let sizes = engine.surfaces(&player).expect("the device lives");
    assert!(sizes.iter().all(|size| !size.coarsened && !size.cut), "everything fits");
    sizes.iter().map(|size| size.triangles).collect()
}

#[test]
fn clouds_have_about_as_many_triangles_as_the_papers() {
    let engine = Engine::new(pollster::block_on(Gpu::headless()).expect("a Vulkan driver"));
    let scenes = [
        // Table 1, figures 1(a) and 1(b).
        (include_str!("../../../../../../scenes/cloud-detailed.toml"), 2360),
        (include_str!("../../../../../../scenes/cloud-simple.toml"), 352),
    ];
    for (toml, theirs) in scenes {
        let ours = triangles(&engine, toml, 0)[0];
        // Where their particles were is not known.
        assert!((theirs / 2..theirs * 2).contains(&ours), "{ours} triangles, {theirs} in the paper");
    }
}

#[test]
fn the_smoke_keeps_its_number_of_particles_and_about_its_size() {
    let engine = Engine::new(pollster::block_on(Gpu::headless()).expect("a Vulkan driver"));
    let toml = include_str!("../../../../../../scenes/smoke-cel.toml");
    let counts = [160, 200, 239].map(|frame| triangles(&engine, toml, frame)[0]);
    let [least, most] = [counts.iter().min(), counts.iter().max()].map(|count| count.copied().unwrap_or(0));
    assert!(least > 1000 && most < 2 * least, "{counts:?} triangles");
}

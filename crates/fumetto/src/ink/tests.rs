//! Which edges of models are lines in a view, read back and counted.

use std::io;

use fumetto_scene::{EdgeKind, Scene, SceneText};

use crate::{
    Assets, Engine, Gpu, Layer, Shot,
    gpu::read_buffer,
    shapes::mesh::{Candidate, bit},
};

/// A cube of 2 m around the origin.
const CUBE: &str = "v -1 -1 -1\nv 1 -1 -1\nv 1 1 -1\nv -1 1 -1\nv -1 -1 1\nv 1 -1 1\nv 1 1 1\nv -1 1 1\n\
                    f 1 4 3 2\nf 5 6 7 8\nf 1 2 6 5\nf 4 8 7 3\nf 1 5 8 4\nf 2 3 7 6\n";

/// The open box with a stripe, and the cube.
struct Models;

impl Assets for Models {
    fn read(&self, path: &str) -> io::Result<Vec<u8>> {
        match path {
            "box.glb" => Ok(include_bytes!("../../../../scenes/box.glb").to_vec()),
            "cube.obj" => Ok(CUBE.into()),
            _ => Err(io::ErrorKind::NotFound.into()),
        }
    }
}

/// The candidates that are lines in the view of figure 11.4, each with its kind.
fn lines(engine: &mut Engine, object: &str) -> Vec<(EdgeKind, Candidate)> {
    let toml = format!(
        "format = 1\ncamera = {{ eye = [2.2, 3.1, 4.5], target = [0, 0.5, 0], fov = 27 }}\n\
         output = {{ size = [64, 48] }}\n[[object]]\nname = \"model\"\nkind = \"mesh\"\n{object}\n"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let (scene, _) = Scene::load(&text, &mut |_| Err("there are no styles".into()))
        .unwrap_or_else(|report| panic!("{}", report.render(false)));
    let mut player = engine.play(scene, Box::new(Models)).expect("the scene can be played");
    engine.seek(&mut player, 0).expect("there is a frame 0");
    let shot = Shot::of(player.scene());
    engine.layer(&player, &shot, Layer::Ink).expect("the device works");
    let edges = &player.meshes.edges;
    let flags: Vec<u32> = read_buffer(engine.gpu(), &edges.flags).expect("the device works");
    let candidates: Vec<Candidate> = read_buffer(engine.gpu(), &edges.candidates).expect("the device works");
    let kind = |flag: u32| EdgeKind::ALL.into_iter().find(|&kind| flag == 1 << kind as u32);
    let lines = flags.into_iter().zip(candidates);
    lines.filter_map(|(flag, candidate)| kind(flag).map(|kind| (kind, candidate))).collect()
}

/// Silhouettes, creases, boundaries and borders of materials that are edges; then contours.
fn counts(lines: &[(EdgeKind, Candidate)]) -> ([usize; 4], usize) {
    let is_contour = |candidate: &Candidate| candidate.bits & bit::CONTOUR != 0;
    let edges = |kind| lines.iter().filter(|line| line.0 == kind && !is_contour(&line.1)).count();
    (EdgeKind::ALL.map(edges), lines.iter().filter(|line| is_contour(&line.1)).count())
}

#[test]
fn every_view_has_its_lines() {
    let mut engine = Engine::new(pollster::block_on(Gpu::headless()).expect("a Vulkan driver"));

    // `tools/scenes/box.py` counts them: of the nine silhouettes six are creases, which are fifteen less.
    let flat = lines(&mut engine, "model = \"box.glb\"\nsmooth = 0");
    assert_eq!(counts(&flat), ([9, 15, 12, 24], 0));

    // Where the corner is round, the contour runs through triangles: from the floor to the rim.
    let smooth = lines(&mut engine, "model = \"box.glb\"");
    let (edges, contours) = counts(&smooth);
    assert_eq!(edges, [6, 15, 12, 24]);
    assert!((3..=12).contains(&contours), "{contours} pieces of contour");

    let cube = "model = \"cube.obj\"\ntransform = { scale = 0.5 }";
    assert_eq!(counts(&lines(&mut engine, cube)), ([6, 6, 0, 0], 0), "of the creases, depth will hide three");

    // A pen that does not draw leaves its edges to the next.
    let no_silhouettes = "style = { ink = { silhouette = { on = false } } }";
    let plain = lines(&mut engine, &format!("{cube}\n{no_silhouettes}"));
    assert_eq!(counts(&plain), ([0, 12, 0, 0], 0));
    let no_ink = lines(&mut engine, &format!("{cube}\nstyle = {{ ink = {{ on = false }} }}"));
    assert_eq!(no_ink.len(), 0);
}

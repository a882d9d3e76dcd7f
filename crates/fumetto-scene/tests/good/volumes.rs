//! Volumes, made of particles and out of files, and what they cost.

use super::{common::load_with, good, set};
use fumetto_scene::{
    Colour, Imported, Matter, Particle, Profile, Raw, RawNumber, SceneText, Transform, Volume, VolumeNoise,
};

/// The volume `shape` of a ball of radius 1 and one of 0.5, whose middles are 4 m apart.
fn two_puffs(shape: &str) -> (Volume, Vec<Particle>) {
    let scene = good(&format!(
        "format = 1\ncamera = {{ eye = [0, 1, 5], target = [0, 0, 0] }}\n\
         light = [{{ kind = \"sun\", direction = [0, -1, 0] }}]\n\
         object = [{{ name = \"a\", kind = \"cloud\", shape = {{ volume = {{ {shape} }} }}, particles = [\n\
         {{ center = [0, 5, 0], radius = 1 }}, {{ center = [4, 5, 0], radius = 0.5 }} ] }}]"
    ));
    let Matter::Still(particles) = &scene.objects[0].matter else { panic!("a still cloud") };
    (scene.objects[0].shape.volume().unwrap().clone(), particles.clone())
}

#[test]
fn every_key_of_a_volume_reaches_it() {
    let white = Colour { linear: [1.0; 3] };
    let plain = Volume {
        extinction_per_m: 4.0,
        profile: Profile::Constant,
        edge: 0.0,
        size: 1.0,
        noise: None,
        colours: vec![white],
        glow: 0.0,
        soft: 0.0,
        surface: 0.5,
        relief: 0.5,
        shadow: 0.0,
        cells: 128,
        light_cells: 64,
        step_m: None,
        step_cells: 0.5,
        pixels: 1,
        lobe_m: None,
    };
    assert_eq!(two_puffs("").0, plain);
    let noise = VolumeNoise {
        amplitude: 0.4,
        frequency: 3.0,
        octaves: 6,
        persistence: 0.6,
        lacunarity: 2.5,
        seed: 8,
        drift: [0.0, 0.25, 0.0],
        billow: false,
    };
    let other = Volume {
        extinction_per_m: 9.0,
        profile: Profile::Linear,
        edge: 0.25,
        size: 2.0,
        noise: Some(noise),
        colours: vec![Colour { linear: [1.0, 0.5, 0.0] }, white],
        glow: 0.75,
        soft: 0.5,
        surface: 0.25,
        relief: 1.0,
        shadow: 0.6,
        cells: 50,
        light_cells: 20,
        step_m: Some(0.125),
        step_cells: 0.5,
        pixels: 1,
        lobe_m: None,
    };
    let keys = "extinction = 9, profile = \"linear\", edge = 0.25, size = 2, glow = 0.75, soft = 0.5, \
                surface = 0.25, relief = 1, shadow = 0.6, cells = 100, light_cells = 40, step = 0.125, quality = 0.5, \
                colours = [[1, 0.5, 0], \"#ffffff\"], noise = { amplitude = 0.4, frequency = 3, octaves = 6, \
                persistence = 0.6, lacunarity = 2.5, seed = 8, drift = [0, 0.25, 0], billow = false }";
    assert_eq!(two_puffs(keys).0, other);
    assert!(other.drifts() && !plain.drifts());
}

#[test]
fn every_key_of_a_volume_out_of_a_file_reaches_it() {
    let scene = good(
        r#"
        format = 1
        camera = { eye = [0, 1, 5], target = [0, 0, 0] }
        light = [{ kind = "sun", direction = [0, -1, 0] }]
        [[object]]
        name = "plain"
        kind = "volume"
        volume = "smoke.VDB"
        [[object]]
        name = "smoke"
        kind = "volume"
        up = "z"
        transform = { position = [1, 2, 3], rotation = [0, 90, 0], scale = 2 }
        shape = { volume = { lobe = 0.5, quality = 0.5, light_cells = 40 } }
        [object.volume]
        file = "smoke.####.vdb"
        density = "smoke"
        heat = "flame"
        range = [9, 1]
        heat_range = [300, 2000]
        frames = [2, 9]
        loop = true
        [[object]]
        name = "head"
        kind = "volume"
        [object.volume]
        file = "head.img"
        [object.volume.raw]
        size = [3, 4, 5]
        type = "i16"
        order = "big"
        voxel = [1, 2, 3]
        origin = [4, 5, 6]
        skip = 352
        "#,
    );
    let imported = |index: usize| match &scene.objects[index].matter {
        Matter::Imported(imported) => (**imported).clone(),
        other => panic!("{other:?} is not out of a file"),
    };
    let plain = Imported {
        file: "smoke.VDB".into(),
        density: None,
        heat: None,
        range: None,
        heat_range: [0.0, 1.0],
        frames: None,
        repeats: false,
        raw: None,
        z_up: false,
        place: Transform::default(),
    };
    assert_eq!(imported(0), plain);
    let smoke = Imported {
        file: "smoke.####.vdb".into(),
        density: Some("smoke".into()),
        heat: Some("flame".into()),
        range: Some([9.0, 1.0]),
        heat_range: [300.0, 2000.0],
        frames: Some([2, 9]),
        repeats: true,
        raw: None,
        z_up: true,
        place: Transform { position: [1.0, 2.0, 3.0], rotation_deg: [0.0, 90.0, 0.0], scale: [2.0; 3] },
    };
    assert_eq!(imported(1), smoke);
    let raw = Raw {
        size: [3, 4, 5],
        number: RawNumber::I16,
        big_endian: true,
        voxel_m: [1.0, 2.0, 3.0],
        origin_m: [4.0, 5.0, 6.0],
        skip: 352,
    };
    assert_eq!(imported(2), Imported { file: "head.img".into(), raw: Some(raw), ..plain });
    let volume = |index: usize| scene.objects[index].shape.volume().unwrap();
    assert_eq!((volume(0).light_cells, volume(0).step_cells, volume(0).lobe_m), (64, 0.5, None));
    assert_eq!((volume(1).light_cells, volume(1).step_cells, volume(1).lobe_m), (20, 1.0, Some(0.5)));
}

#[test]
fn a_volumes_grids_fit_its_puffs() {
    let room = |keys: &str| {
        let (volume, particles) = two_puffs(keys);
        volume.room(&particles)
    };
    // From -1 to 4.5 along x, 2 m along y and z; 3 cells lie around them.
    let plain = room("cells = 100, light_cells = 50");
    assert_eq!((plain.cells, plain.light_cells), ([100, 39, 39], [50, 20, 20]));
    assert_eq!(plain.bytes(), 100 * 39 * 39 * 12 + 50 * 20 * 20 * 8);
    // Noise reaches as far again: 7 m by 4 m.
    assert_eq!(room("cells = 103, noise = { amplitude = 1 }").cells, [103, 61, 61]);
    assert_eq!(two_puffs("cells = 20").0.moving_room().cells, [20; 3]);
    assert!(two_puffs("").0.room(&[]).fits(), "nothing is no reason to fail");
}

#[test]
fn the_cost_of_a_volume_is_told_beforehand() {
    let set = [set("object.fire.shape", "{ volume = { cells = 100, light_cells = 50 } }")];
    let toml = include_str!("everything.toml");
    let text = SceneText { name: "scene.toml", toml, set: &set, style: None };
    let (scene, _) = load_with(&text, &[]).unwrap();
    let cost = &scene.requirements()[0];
    assert_eq!(cost.volume.map(|room| room.bytes()), Some(1_000_000 * 12 + 125_000 * 8));
    assert_eq!(scene.requirements()[1].volume, None);
}

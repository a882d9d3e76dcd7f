//! Obstacles.

use std::io;

use fumetto_scene::{Scene, SceneText};
use glam::Vec3;

use super::{air_of, velocity_after};
use crate::{
    Assets, Engine, Player,
    particles::{
        Facet, Voxels,
        tests::{Particle, engine, play_smoke, slots_after},
    },
};

/// A box of 2 by 2 by 2.
const CUBE: &str = "v -1 -1 -1\nv 1 -1 -1\nv -1 1 -1\nv 1 1 -1\nv -1 -1 1\nv 1 -1 1\nv -1 1 1\nv 1 1 1\n\
    f 1 3 4 2\nf 5 6 8 7\nf 1 2 6 5\nf 3 7 8 4\nf 1 5 7 3\nf 2 4 8 6\n";

struct OneModel(&'static str);

impl Assets for OneModel {
    fn read(&self, _: &str) -> io::Result<Vec<u8>> {
        Ok(self.0.into())
    }
}

/// Smoke that is blown at a cube of 0.4 m in the middle of a channel.
fn channel(engine: &Engine, model: &'static str, place: [f32; 3]) -> Player {
    let toml = format!(
        "format = 1\ncamera = {{ eye = [0, 0, 5], target = [0, 0, 0] }}\n\
         time = {{ fps = 24, frames = [0, 1000] }}\n\
         [[object]]\nname = \"smoke\"\nkind = \"smoke\"\nsolver = \"grid\"\n\
         grid = {{ box = {{ center = [0, 0, 0], size = [2, 1, 1] }}, cells = 32 }}\n\
         force = [{{ kind = \"wind\", velocity = [1, 0, 0] }}]\n\
         [object.emitter]\nshape = {{ box = {{ center = [-0.8, 0, 0], size = [0.2, 0.3, 0.3] }} }}\n\
         count = 300\nlife = 3\n\
         [[object]]\nname = \"cube\"\nkind = \"mesh\"\nmodel = \"cube.obj\"\nobstacle = true\n\
         transform = {{ scale = 0.2, position = {place:?} }}\n"
    );
    let text = SceneText { name: "test", toml: &toml, ..Default::default() };
    let loaded = Scene::load(&text, &mut |_| Err("there are no styles".into()));
    let (scene, _) = loaded.unwrap_or_else(|report| panic!("{}", report.render(false)));
    engine.play(scene, Box::new(OneModel(model))).expect("the scene fits")
}

#[test]
fn nothing_enters_an_obstacle_in_a_thousand_steps() {
    let engine = engine();
    let mut player = channel(&engine, CUBE, [0.0; 3]);
    let mut passed = 0;
    for step in (50..=1000).step_by(50) {
        let slots: Vec<Particle> = slots_after(&engine, &mut player, step);
        for particle in slots.iter().filter(|particle| !particle.is_dead()) {
            // Half a cell is what a corner is rounded by.
            let deep = 0.2 - particle.position.abs().max_element();
            assert!(deep < 0.5 / 16.0, "{} is inside at step {step}", particle.position);
            passed += u32::from(particle.position.x > 0.4);
        }
    }
    assert!(passed > 100, "smoke flows round it: {passed}");
}

#[test]
fn air_flows_round_an_obstacle_and_not_through_it() {
    let engine = engine();
    let mut player = channel(&engine, CUBE, [0.0; 3]);
    let [u, ..] = velocity_after(&engine, &mut player, 48);
    let (inside, beside) = (u.at(16, 8, 8), u.at(16, 2, 8));
    assert!(inside.abs() < 0.01, "air moves at {inside} m/s in its middle");
    assert!(beside > 1.05, "and at {beside} m/s beside it, quicker than far away");
}

#[test]
fn an_open_obstacle_and_a_buried_emitter_are_told_of() {
    let engine = engine();
    let notes = |model, place| channel(&engine, model, place).notes().join("; ");
    assert_eq!(notes(CUBE, [0.0; 3]), "");
    let without_a_side = CUBE.split("f 2 4 8 6").next().unwrap_or_default();
    assert!(notes(without_a_side, [0.0; 3]).contains("not closed"), "{}", notes(without_a_side, [0.0; 3]));
    assert!(notes(CUBE, [-0.8, 0.0, 0.0]).contains("emitter 1"), "{}", notes(CUBE, [-0.8, 0.0, 0.0]));
}

#[test]
fn distances_and_velocities_are_those_of_the_surface() {
    let engine = engine();
    let keys = "solver = \"grid\"\ngrid = { box = { center = [0, 0, 0], size = [2, 2, 2] }, cells = 32 }\n\
        [object.emitter]\nshape = { point = { center = [0, 0, 0] } }\nrate = 1\n";
    let plan = air_of(&play_smoke(&engine, 1, 24.0, keys)).plan;
    // An octahedron of radius 0.7, which moves.
    let velocity = Vec3::new(1.0, 2.0, 3.0);
    let facets: Vec<Facet> = (0..8)
        .map(|octant: u32| {
            let side = |axis: u32| if octant >> axis & 1 == 0 { 0.7 } else { -0.7 };
            let corners = [Vec3::X * side(0), Vec3::Y * side(1), Vec3::Z * side(2)];
            Facet { corners, velocity }
        })
        .collect();
    let voxels = Voxels::new(&plan, &facets).expect("they are few");
    assert!(!voxels.leaks);
    for z in 0..32_u32 {
        for y in 0..32_u32 {
            for x in 0..32_u32 {
                let place = (Vec3::new(x as f32, y as f32, z as f32) + 0.5) / 16.0 - 1.0;
                let exact = (place.abs().element_sum() - 0.7) / 3.0_f32.sqrt() * 16.0;
                let found = voxels.distances[((z * 32 + y) * 32 + x) as usize];
                // Outside, edges and corners are farther than the faces' planes.
                assert_eq!(found < 0.0, exact < 0.0, "at {place}");
                if exact < 0.0 {
                    assert!((found - exact.max(-4.0)).abs() < 1e-3, "{found} and not {exact} at {place}");
                    assert_eq!(voxels.velocities[((z * 32 + y) * 32 + x) as usize], velocity);
                }
            }
        }
    }
}

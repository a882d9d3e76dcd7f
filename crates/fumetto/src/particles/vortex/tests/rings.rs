//! What is known of vortex rings.

use std::f32::consts::PI;

use glam::{DVec3, Vec3};

use super::{VortexState, leaves, swirl_of, vortices_after};
use crate::particles::tests::{engine, play_smoke};

const STILL: &str = "decay = 0, viscosity = 0, strength = 0, buoyancy = 0, error = 0.005";

/// Rings of 1 m² /s that travel along +x: one for each `at` and `radius`, of `segments` vortices.
fn rings(settings: &str, list: &[(f32, f32)]) -> String {
    let emitter = |&(x, radius): &(f32, f32)| {
        format!(
            "[[object.emitter]]\nshape = {{ disc = {{ center = [{x}, 0, 0], normal = [1, 0, 0], radius = 1 }} }}\n\
             life = 1000\nrings = {{ at = [0], circulation = 1, radius = {radius}, wobble = 0 }}\n"
        )
    };
    format!("vortex = {{ {settings} }}\n{}", list.iter().map(emitter).collect::<String>())
}

fn center(vortices: &[VortexState]) -> Vec3 {
    vortices.iter().map(|vortex| vortex.position).sum::<Vec3>() / vortices.len() as f32
}

#[test]
fn a_ring_travels_as_fast_as_saffman_says() {
    let engine = engine();
    for (radius, core) in [(1.0_f32, 0.1_f32), (2.0, 0.1), (1.0, 0.2)] {
        let settings = format!("{STILL}, segments = 128, core = {core}");
        let mut player = play_smoke(&engine, 1, 24.0, &rings(&settings, &[(0.0, radius)]));
        let start = center(&vortices_after(&engine, &mut player, 1));
        let end = center(&vortices_after(&engine, &mut player, 49));
        let speed = (end.x - start.x) / 2.0;
        // U = Γ/(4πR) (ln(8R/a) - 1/2 + A) with A = 1/12 for the vorticity of this kernel, 2a⁴/(r² + a²)³
        // (Saffman 1970, "The velocity of viscous vortex rings"); a line moves by what it is at its middle,
        // where there is no A.
        let slender = |shift: f32| ((8.0 / core).ln() - 0.5 + shift) / (4.0 * PI * radius);
        assert!((speed / slender(0.0) - 1.0).abs() < 0.01, "{speed} should be {}", slender(0.0));
        assert!(
            (speed / slender(1.0 / 12.0) - 1.0).abs() < 0.04,
            "{speed} should be {}",
            slender(1.0 / 12.0)
        );
        assert!(Vec3::new(0.0, end.y, end.z).length() < 5e-3, "it goes straight: {end}");
    }
}

#[test]
fn by_default_a_ring_is_about_as_fast() {
    let engine = engine();
    let settings = "decay = 0, segments = 48, core = 0.3";
    let mut player = play_smoke(&engine, 1, 24.0, &rings(settings, &[(0.0, 1.0)]));
    let start = center(&vortices_after(&engine, &mut player, 1));
    let end = center(&vortices_after(&engine, &mut player, 49));
    let slender = ((8.0_f32 / 0.3).ln() - 0.5) / (4.0 * PI);
    let speed = (end.x - start.x) / 2.0;
    assert!((speed / slender - 1.0).abs() < 0.05, "{speed} should be {slender}");
}

#[test]
fn a_ring_behind_slips_through_the_one_before_it() {
    let engine = engine();
    let settings = format!("{STILL}, segments = 64, core = 0.1");
    let mut player = play_smoke(&engine, 1, 24.0, &rings(&settings, &[(0.0, 1.0), (0.7, 1.0)]));
    let mut passed = false;
    for step in (24..480).step_by(24) {
        let vortices = vortices_after(&engine, &mut player, step);
        let (behind, before) = vortices.split_at(64);
        let radius = |ring: &[VortexState]| ring[0].position.with_x(0.0).length();
        let gap = center(before).x - center(behind).x;
        if gap > 0.0 {
            assert!(radius(behind) < radius(before), "what is drawn through gets narrower");
        } else {
            passed = true;
            break;
        }
    }
    assert!(passed, "it never overtook");
}

/// Half the sum of position × strength: by it a fluid moves.
fn impulse(vortices: &[VortexState], segments: usize) -> DVec3 {
    let rings = vortices.chunks_exact(segments);
    rings
        .flat_map(|ring| {
            (0..segments).map(move |nth| {
                let at = |nth: usize| ring[nth % segments].position.as_dvec3();
                let piece = 0.5 * (at(nth + 1) - at(nth + segments - 1));
                0.5 * f64::from(ring[nth].circulation) * at(nth).cross(piece)
            })
        })
        .sum()
}

#[test]
fn rings_that_draw_near_keep_their_impulse() {
    let engine = engine();
    let ring = |x: f32, normal: &str| {
        format!(
            "[[object.emitter]]\nshape = {{ disc = {{ center = [{x}, 0, 0], normal = {normal}, radius = 1 }} }}\n\
             life = 1000\nrings = {{ at = [0], circulation = 1, radius = 0.5 }}\n"
        )
    };
    let keys = format!(
        "vortex = {{ {STILL}, segments = 48, core = 0.4 }}\n{}{}",
        ring(-0.8, "[0.4, 1, 0]"),
        ring(0.8, "[-0.4, 1, 0]")
    );
    let mut player = play_smoke(&engine, 1, 48.0, &keys);
    let start = impulse(&vortices_after(&engine, &mut player, 1), 48);
    let end = impulse(&vortices_after(&engine, &mut player, 96), 48);
    assert!(start.y > 0.7, "they rise: {start}");
    assert!(start.distance(end) < 0.02 * start.length(), "{start} became {end}");
}

#[test]
fn circulation_decays_and_cores_spread() {
    let engine = engine();
    let settings = "decay = 0.5, viscosity = 0.01, core = 0.2, segments = 32";
    let mut player = play_smoke(&engine, 1, 24.0, &rings(settings, &[(0.0, 1.0)]));
    let vortices = vortices_after(&engine, &mut player, 48);
    assert!((vortices[0].circulation - (-0.5_f32 * 2.0).exp()).abs() < 1e-4, "{}", vortices[0].circulation);
    let leaves = leaves(engine.gpu(), swirl_of(&player));
    let middle_secs = 47.0 / 24.0;
    assert!((leaves[0].core2 / (0.04 + 4.0 * 0.01 * middle_secs) - 1.0).abs() < 1e-3, "{}", leaves[0].core2);
}

#[test]
fn lift_makes_rings_stronger() {
    let engine = engine();
    let keys = "vortex = { strength = 0, buoyancy = 1, decay = 0 }\n\
                force = [{ kind = \"buoyancy\", acceleration = 2 }, { kind = \"drag\", rate = 1 }]\n\
                [object.emitter]\nshape = { disc = { center = [0, 0, 0], radius = 0.4 } }\nradius = 0.1\n\
                bursts = [{ at = 0, count = 5 }]\nlife = 1000\n";
    let mut player = play_smoke(&engine, 1, 24.0, keys);
    let vortices = vortices_after(&engine, &mut player, 24);
    // The lift times the height of warm air that a ring stands for: its width over the Strouhal number.
    let expected = 2.0 * (2.0 * 0.5 / 0.3);
    assert!((vortices[0].circulation / expected - 1.0).abs() < 1e-3, "{}", vortices[0].circulation);
}

#[test]
fn a_jet_sheds_rings_as_its_speed_and_width_say() {
    let engine = engine();
    let keys = "vortex = { strength = 1, decay = 0, segments = 16 }\n\
                [object.emitter]\nshape = { disc = { center = [0, 0, 0], radius = 0.4 } }\nradius = 0.1\n\
                velocity = [0, 2, 0]\nrate = 10\nlife = 100\n";
    let mut player = play_smoke(&engine, 1, 24.0, keys);
    let vortices = vortices_after(&engine, &mut player, 24 * 10);
    // Strouhal number × speed / width a second, for 10 seconds.
    assert_eq!(vortices.len(), 16 * (0.3_f32 * 2.0 / 1.0 * 10.0) as usize);
    // All of U²/2 a second, in the time from one ring to the next.
    let expected = 2.0 * 2.0 / 2.0 / 0.6;
    assert!((vortices[0].circulation / expected - 1.0).abs() < 1e-3, "{}", vortices[0].circulation);
}

#[test]
fn the_worst_of_winds_does_not_blow_vortices_up() {
    let engine = engine();
    let keys = "vortex = { strength = 5, decay = 0 }\n\
                force = [{ kind = \"turbulence\", speed = 9, scale = 0.4 }, { kind = \"drag\", rate = 20 }]\n\
                [object.emitter]\nshape = { disc = { center = [0, 0, 0], radius = 0.4 } }\n\
                velocity = [0, 9, 0]\nrate = 10\nlife = 4\n";
    let mut player = play_smoke(&engine, 1, 24.0, keys);
    let vortices = vortices_after(&engine, &mut player, 200);
    assert!(vortices.len() > 200, "there are some: {}", vortices.len());
    let strongest = vortices.iter().map(|vortex| vortex.circulation * vortex.length).fold(0.0, f32::max);
    for leaf in leaves(engine.gpu(), swirl_of(&player)) {
        assert!(leaf.position.length() < 100.0, "{}", leaf.position);
        // Eight times its length at birth is the most that a piece gets.
        assert!(leaf.strength.length() <= 8.01 * strongest, "{} of {strongest}", leaf.strength.length());
    }
}

//! What paint is made of, and how it spreads.

use super::{good, smoke, srgb};
use fumetto_scene::{
    Border, Brush, Cells, Drop, Emitter, Growth, Look, Matter, Paint, Pour, Ramp, Spread, Stain, StainRoom,
    Style, Tone, Wash, Width,
};

#[test]
fn every_key_of_paint_reaches_it() {
    let scene = good(include_str!("everything.toml"));
    let Matter::Paint(paint) = &scene.objects[2].matter else { panic!("paint") };
    let growth = |points: &[[f32; 2]]| Growth { points: points.to_vec() };
    let Look::Styled(outside) = paint.outside.as_ref().unwrap() else { panic!("a style") };
    assert_eq!(outside.len(), 3, "one for each object");
    for (style, object) in outside.iter().zip(&scene.objects) {
        let tones = [Tone { colour: srgb(0x1b2148), from: 0.0 }, Tone { colour: srgb(0x5d6cb0), from: 0.5 }];
        let ramp = Ramp::Tones(tones.to_vec());
        assert_eq!(*style, Style { ramp, ..object.style.clone() }, "the rest is the object's own");
    }
    let room = |emitter: &Emitter| StainRoom::new(emitter.capacity(scene.time.step_secs()), 2, 50);
    let rooms: Vec<_> = smoke(&scene).emitters.iter().map(room).collect();
    assert_eq!(rooms[1], StainRoom { particles: 250, rounds: 1 }, "half of the 500 that are alive");
    let expected = Paint {
        drops: vec![
            Drop {
                at: [0.0, 1.0, 0.0],
                time_secs: 0.5,
                radius: growth(&[[0.0, 0.2], [3.0, 2.0]]),
                start_m: 0.1,
            },
            Drop { at: [1.0, 0.0, 0.0], time_secs: 0.0, radius: growth(&[[0.0, 1.0]]), start_m: 0.1 },
        ],
        strokes: vec![Brush {
            path: vec![[0.0; 3], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0]],
            during_secs: [1.0, 3.0],
            radius: growth(&[[0.0, 0.3]]),
            start_m: 0.1 * 0.3,
        }],
        cells: Some(Cells {
            center: [0.0, 1.0, 0.0],
            size: [4.0, 2.0, 3.0],
            cell_m: 0.5,
            depth_m: 0.04,
            speed_m_per_s: 3.0,
            uneven: 0.1,
        }),
        pours: vec![Pour { at: [0.0, 2.0, 0.0], during_secs: [0.5, 4.0], rate_m3_per_s: 0.1 }],
        stains: vec![Stain { from: 0, size: 1.5, ends: true, every: 2, rooms: rooms.clone() }],
        spread: Spread {
            subdivisions: 4,
            stiffness: 9.0,
            elasticity: 7.0,
            friction: 0.5,
            gravity: [0.0, -1.0, 0.0],
            downhill: 3.0,
            grain: 0.3,
            grain_m: 0.7,
        },
        keep: Some([[0.0, 1.0, 0.0], [9.0, 8.0, 7.0]]),
        wash: Some(Wash { steps: 2, spacing: 0.25, colour: srgb(0x3060c0), strength: 0.6, covers: true }),
        border: Some(Border { colour: srgb(0x101418), width: Width::Px(3.0) }),
        inside: Look::Monochrome,
        outside: paint.outside.clone(),
    };
    assert_eq!(*paint, expected);
    // Two drops, two pieces, 8 by 6 cells and stains, in two washes of 162 vertices.
    let volumes = 2 * (52 + rooms.iter().map(StainRoom::volumes).sum::<u64>());
    assert_eq!((paint.volumes(), paint.vertices()), (volumes, volumes * 162));
    assert_eq!(scene.styled_looks().count(), 1);
}

#[test]
fn a_radius_changes_evenly_from_point_to_point() {
    let growth = Growth { points: vec![[1.0, 2.0], [3.0, 4.0], [4.0, 0.0]] };
    let radii = [0.0, 1.0, 2.0, 3.0, 3.5, 4.0, 99.0].map(|secs| growth.at(secs));
    assert_eq!(radii, [2.0, 2.0, 3.0, 4.0, 2.0, 0.0, 0.0]);
    assert_eq!(growth.largest(), 4.0);
}

#[test]
fn there_is_room_for_as_many_stains_as_should_stay() {
    assert_eq!(StainRoom::new(100, 3, 120), StainRoom { particles: 34, rounds: 4 });
    assert_eq!(
        StainRoom::new(100, 1, 7),
        StainRoom { particles: 100, rounds: 1 },
        "a place for each at least"
    );
    assert_eq!(StainRoom::new(0, 1, 7).volumes(), 7);
}

#[test]
fn stiff_paint_takes_smaller_steps() {
    let spread = |stiffness, friction| Spread {
        subdivisions: 4,
        stiffness,
        elasticity: 0.0,
        friction,
        gravity: [0.0; 3],
        downhill: 0.0,
        grain: 0.0,
        grain_m: 1.0,
    };
    let substeps = |stiffness, friction| spread(stiffness, friction).substeps(1.0 / 24.0);
    assert_eq!((substeps(16.0, 1.0), substeps(1600.0, 1.0), substeps(1600.0, 3.0)), (1, 7, 20));
    assert_eq!(spread(16.0, 0.5).damping_per_s(), 4.0);
}

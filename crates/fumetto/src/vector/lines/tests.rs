//! Lines of shapes whose curves are known.

use fumetto_scene::{Camera, InkMethod, Matter, Mesh, Puffs, Shape, Style};
use glam::Vec3;

use super::{solids::PartLook, *};
use crate::shapes::mesh::Triangle;

/// Steps along the section and round the axis.
fn revolved(section: impl Fn(f32) -> ([f32; 2], [f32; 2]), steps: [u32; 2], is_ring: bool) -> Solids {
    let mut solids = Solids::default();
    let [along, around] = steps;
    let rows = if is_ring { along } else { along + 1 };
    for row in 0..rows {
        let ([radius, height], [out, up]) = section(row as f32 / along as f32);
        for step in 0..around {
            let (sin, cos) = (std::f32::consts::TAU * step as f32 / around as f32).sin_cos();
            solids.positions.push(Vec3::new(radius * cos, height, radius * sin));
            solids.normals.push(Vec3::new(out * cos, up, out * sin));
        }
    }
    for row in 0..along {
        for step in 0..around {
            let at = |row: u32, step: u32| (row % rows) * around + step % around;
            let [a, b, c, d] = [at(row, step), at(row, step + 1), at(row + 1, step), at(row + 1, step + 1)];
            for corners in [[a, c, b], [b, c, d]] {
                let place = |corner: u32| solids.positions[corner as usize];
                let normal =
                    (place(corners[1]) - place(corners[0])).cross(place(corners[2]) - place(corners[0]));
                if normal.length_squared() > 1e-16 {
                    let outward: Vec3 = corners.iter().map(|&corner| solids.normals[corner as usize]).sum();
                    let [a, b, c] = corners;
                    let corners = if normal.dot(outward) > 0.0 { [a, b, c] } else { [a, c, b] };
                    solids.triangles.push(Triangle { corners, part: 0 });
                }
            }
        }
    }
    solids.sheets = vec![0; solids.triangles.len()];
    solids.parts.push(PartLook { object: 0, is_double_sided: false, hides: true });
    solids
}

fn sphere(rows: u32) -> Solids {
    let section = |share: f32| {
        let (sin, cos) = (std::f32::consts::PI * share).sin_cos();
        // The poles are one place, and not around it.
        let out = if share == 0.0 || share == 1.0 { 0.0 } else { sin };
        ([out, cos], [out, cos])
    };
    revolved(section, [rows, 2 * rows], false)
}

fn torus(rows: u32) -> Solids {
    let section = |share: f32| {
        let (sin, cos) = (std::f32::consts::TAU * share).sin_cos();
        ([1.0 + 0.4 * cos, 0.4 * sin], [cos, sin])
    };
    revolved(section, [rows, 3 * rows], true)
}

fn moved(mut solids: Solids, by: Vec3, scale: f32) -> Solids {
    solids.positions.iter_mut().for_each(|place| *place = by + scale * *place);
    solids
}

fn both(mut one: Solids, other: Solids) -> Solids {
    let (first, part) = (one.positions.len() as u32, one.parts.len() as u32);
    one.positions.extend(other.positions);
    one.normals.extend(other.normals);
    one.triangles.extend(other.triangles.into_iter().map(|triangle| Triangle {
        corners: triangle.corners.map(|corner| corner + first),
        part: triangle.part + part,
    }));
    one.sheets.extend(other.sheets.iter().map(|sheet| sheet + part));
    one.parts.extend(other.parts.into_iter().map(|look| PartLook { object: look.object + part, ..look }));
    one
}

fn object() -> Object {
    let mut style = Style::default();
    style.ink.method = InkMethod::Vector;
    let mesh =
        Mesh { model: "test.obj".into(), z_up: false, smooth_deg: None, obstacle: false, copies: Vec::new() };
    Object {
        name: "test".to_owned(),
        visible: true,
        matter: Matter::Mesh(mesh),
        shape: Shape::Puffs(Puffs { variants: 1, seed: 0, spheres: 1, tile_px: 16, size: 1.0 }),
        details: Vec::new(),
        style,
        opacity: 1.0,
    }
}

fn sight(eye: [f32; 3]) -> Sight {
    let camera = Camera {
        name: "main".to_owned(),
        eye,
        target: [0.0; 3],
        up: [0.0, 1.0, 0.0],
        fov_deg: 40.0,
        near: None,
    };
    Sight::new(&camera, [800, 600])
}

fn runs(solids: &Solids, sight: &Sight) -> Vec<Run> {
    let object = object();
    let objects = vec![&object; solids.parts.len()];
    let subject =
        Subject { solids, sight, objects: &objects, light: FirstLight::none(), covered: &|_| false };
    subject.runs().into_iter().map(|(.., run)| run).collect()
}

fn length(run: &Run) -> f32 {
    run.stops
        .windows(2)
        .map(|pair| (pair[1].spot.x - pair[0].spot.x).hypot(pair[1].spot.y - pair[0].spot.y))
        .sum()
}

#[test]
fn a_sphere_has_one_ring_on_its_circle() {
    let sight = sight([0.0, 0.0, 4.0]);
    for (rows, most) in [(24, 1.5), (96, 0.12), (256, 0.05)] {
        let runs = runs(&sphere(rows), &sight);
        let told: Vec<_> =
            runs.iter().map(|run| (run.stops[0].spot, run.stops[run.stops.len() - 1].spot)).collect();
        assert_eq!(runs.len(), 1, "{rows}: {told:?}");
        assert!(runs[0].is_closed);
        // The tangent cone of a ball of radius 1 in 4 metres.
        let radius = sight.focal_px / 15.0_f32.sqrt();
        for stop in &runs[0].stops {
            let off = (stop.spot.x - 400.0).hypot(stop.spot.y - 300.0) - radius;
            assert!(off.abs() < most, "{off} at {rows}");
        }
    }
}

#[test]
fn a_torus_has_its_curves_with_cusps() {
    // From above at an angle: the outer contour all round, the rim of the front half from cusp to cusp, and of the
    // hole's far side what that does not hide.
    let sight = sight([0.0, 2.2, 4.0]);
    let mut lengths = Vec::new();
    for rows in [48, 96, 192] {
        let mut runs = runs(&torus(rows), &sight);
        runs.sort_by(|a, b| length(b).total_cmp(&length(a)));
        let told: Vec<_> = runs.iter().map(|run| (length(run), run.is_closed, run.stops[0].spot)).collect();
        let [outer, rim, far] = &runs[..] else { panic!("{rows}: {told:?}") };
        assert!(outer.is_closed && !rim.is_closed && !far.is_closed);
        for run in [rim, far] {
            let [first, last] = [run.stops[0].spot, run.stops[run.stops.len() - 1].spot];
            assert!((first.x + last.x - 800.0).abs() < 8.0 && (first.y - last.y).abs() < 5.0, "{told:?}");
        }
        lengths.push([length(outer), length(rim), length(far)]);
    }
    for pair in lengths.windows(2) {
        for (which, most) in [(0, 0.01), (1, 0.06), (2, 0.06)] {
            assert!((pair[0][which] / pair[1][which] - 1.0).abs() < most, "{lengths:?}");
        }
    }
}

#[test]
fn two_spheres_that_cross_hide_parts_of_each_other() {
    let sight = sight([0.0, 0.0, 6.0]);
    let pair = both(
        moved(sphere(96), Vec3::new(-0.6, 0.0, 0.0), 1.0),
        moved(sphere(96), Vec3::new(0.6, 0.0, 0.0), 1.0),
    );
    let found = runs(&pair, &sight);
    assert_eq!(found.len(), 2);
    for run in &found {
        assert!(!run.is_closed);
        // They cross in the plane in the middle, in a circle of radius 0.8.
        for end in [run.stops[0], run.stops[run.stops.len() - 1]] {
            assert!((end.spot.x - 400.0).abs() < 3.0, "{end:?}");
        }
    }
    let shorter = length(&found[0]).min(length(&found[1])) / length(&found[0]).max(length(&found[1]));
    assert!(shorter > 0.99);
}

#[test]
fn what_lies_behind_is_not_drawn() {
    let sight = sight([0.0, 0.0, 6.0]);
    let behind = moved(sphere(48), Vec3::new(0.0, 0.0, -3.0), 0.5);
    let found = runs(&both(sphere(96), behind.clone()), &sight);
    assert_eq!(found.len(), 1);
    let beside = moved(behind, Vec3::new(2.0, 0.0, 0.0), 1.0);
    assert_eq!(runs(&both(sphere(96), beside), &sight).len(), 2);
}

#[test]
fn a_camera_inside_sees_no_contour() {
    assert!(runs(&sphere(48), &sight([0.0, 0.0, 0.1])).is_empty());
    assert!(runs(&Solids::default(), &sight([0.0, 0.0, 1.0])).is_empty());
}

#[test]
fn strokes_are_closed_outlines_of_few_curves() {
    let (solids, sight, object) = (sphere(256), sight([0.0, 0.0, 4.0]), object());
    let subject = Subject {
        solids: &solids,
        sight: &sight,
        objects: &[&object],
        light: FirstLight::none(),
        covered: &|_| false,
    };
    let strokes = subject.strokes(false);
    assert_eq!(strokes.len(), 1);
    let path = &strokes[0].path;
    let radius = f64::from(sight.focal_px) / 15.0_f64.sqrt();
    let width = 2.0 * 600.0 / 720.0;
    let expected = std::f64::consts::TAU * radius * width;
    assert!(
        (kurbo::Shape::area(path).abs() - expected).abs() < 0.01 * expected,
        "{}",
        kurbo::Shape::area(path)
    );
    assert!(path.segments().count() < 60, "{}", path.segments().count());
    let middles = subject.strokes(true);
    assert!(middles[0].stroke_px.is_some_and(|px| (px - width).abs() < 1e-3));
    assert!(middles[0].path.segments().count() < 24);
}

//! Milliseconds against size.

use std::time::Instant;

use fumetto_scene::Particle;

use super::{
    BENCH, Frame, PoisonError, ROOM, SurfaceRoom, UNFADED, Workspace, meshes, particle, puffs, read, recipe,
    reserved,
};

const RUNS: u32 = 5;

/// A cube of particles whose matter keeps its volume: more of them are smaller.
fn cloud(count: u32) -> Vec<Particle> {
    let side = (count as f32).cbrt();
    (0..count)
        .map(|index| {
            // Spread evenly by the powers of the plastic number's cousin (Roberts 2018).
            let place =
                [0.819_172_5, 0.671_043_6, 0.549_700_5].map(|k| 4.0 * (k * f64::from(index)).fract() as f32);
            particle(place, 4.0 / side, 2.0)
        })
        .collect()
}

fn measure(cloud: &[Particle], cell_m: f32) {
    let bench = BENCH.lock().unwrap_or_else(PoisonError::into_inner);
    let radius_cells = cloud[0].radius / cell_m;
    let cells = ((4.0 + 2.0 * cloud[0].radius) / cell_m) as u32;
    let needed = SurfaceRoom::of([(cloud.len() as u64, radius_cells)], cells);
    let room = SurfaceRoom { vertices: ROOM.vertices, triangles: ROOM.triangles, ..needed };
    let work = Workspace::new(&bench.gpu, room);
    let mesh = meshes(&bench.gpu, room);
    let puffs = puffs(&bench.gpu, cloud, UNFADED);
    let recipe = recipe(cloud.len(), 0.5, cell_m);
    let mut best = f64::INFINITY;
    for _ in 0..RUNS {
        let start = Instant::now();
        let mut frame = Frame::new(&bench.gpu, &bench.pool, "growth");
        bench.surface.record(&mut frame, &puffs, &recipe, (room, &work), (0.0, reserved(&mesh)));
        frame.submit();
        bench.gpu.wait().expect("the device lives");
        best = best.min(start.elapsed().as_secs_f64() * 1e3);
    }
    let read = read(&bench.gpu, &mesh);
    println!(
        "{:7} particles, {cells:3} cells: {best:8.2} ms, {:7} triangles, {:5.1} MB, overflow {}",
        cloud.len(),
        read.triangles.len(),
        needed.bytes() as f64 / 1e6,
        read.overflow
    );
}

#[test]
#[ignore = "measures; run it alone, in a release build, with --nocapture"]
fn growth() {
    for count in [24, 1_000, 10_000, 100_000] {
        measure(&cloud(count), 0.1);
    }
    for cells in [22.0, 64.0, 128.0] {
        let cloud = cloud(24);
        measure(&cloud, (4.0 + 2.0 * cloud[0].radius) / cells);
    }
}

//! Lines of a cel's models and surfaces, as far as nothing else in the picture hides them.

use super::{
    DrawingOptions,
    document::Stroke,
    lines::{FirstLight, Sight, Solids, Spot, Subject},
    seen::Owners,
};
use crate::{
    Player, Shot,
    frame::Plate,
    gpu::{Gpu, GpuError},
};

/// Distances that differ by this share are equal, as in `strip.wgsl`.
const TOLERANCE: f32 = 2e-4;

pub(super) async fn lines(
    gpu: &Gpu,
    (player, shot): (&Player, &Shot),
    plate: &Plate,
    options: &DrawingOptions,
) -> Result<Vec<Stroke>, GpuError> {
    let solids = Solids::read(gpu, player, &plate.members).await?;
    if solids.triangles.is_empty() {
        return Ok(Vec::new());
    }
    let sight = Sight::new(&shot.camera, shot.size);
    let owners = Owners::new(player);
    let per_px = [0, 1].map(|axis| plate.size[axis] as f32 / sight.size_px[axis]);
    // What triangles hide is known better from themselves.
    let covered = |spot: Spot| {
        let at =
            |along: f32, axis: usize| ((along * per_px[axis]).max(0.0) as usize).min(plate.size[axis] - 1);
        let sample = at(spot.y, 1) * plate.size[0] + at(spot.x, 0);
        let id = plate.ids[sample];
        let hides = Owners::is_triangle(id) && owners.part(id).is_some_and(|part| solids.parts[part].hides);
        !hides && plate.depth[sample] / sight.near_m > spot.near * (1.0 + TOLERANCE)
    };
    let drawn = player.drawn();
    let light = FirstLight::of(player.scene());
    let subject = Subject { solids: &solids, sight: &sight, objects: &drawn, light, covered: &covered };
    Ok(subject.strokes(options.plotter))
}

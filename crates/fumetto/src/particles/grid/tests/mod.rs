//! Air against closed forms, on whatever adapter there is.

mod closed;
mod flow;
mod ride;
mod solid;

use glam::UVec3;

use super::Air;
use crate::{Engine, Player, gpu::read_buffer};

fn air_of(player: &Player) -> &Air {
    player.plumes().next().expect("there is smoke").air().expect("it has a grid")
}

/// One number for each place of a list of cells or of faces.
struct Field {
    extent: UVec3,
    values: Vec<f32>,
}

impl Field {
    fn at(&self, x: u32, y: u32, z: u32) -> f32 {
        self.values[((z * self.extent.y + y) * self.extent.x + x) as usize]
    }
}

/// The velocity after `steps` steps.
fn velocity_after(engine: &Engine, player: &mut Player, steps: u32) -> [Field; 3] {
    engine.seek(player, steps).expect("there are no files to miss");
    let air = air_of(player);
    let now = ((u64::from(steps) * u64::from(air.plan.sub_steps)) & 1) as usize;
    [0, 1, 2].map(|axis: usize| Field {
        extent: UVec3::from(air.plan.cells) + 1,
        values: read_buffer(engine.gpu(), &air.velocity[now][axis]).expect("the device lives"),
    })
}

/// Heat (0) or smoke (1) after as many steps as were made.
fn heat_now(engine: &Engine, player: &Player, which: usize) -> Field {
    let air = air_of(player);
    let now = ((player.steps * u64::from(air.plan.sub_steps)) & 1) as usize;
    let both: Vec<[f32; 2]> = read_buffer(engine.gpu(), &air.heat[now]).expect("the device lives");
    Field { extent: air.plan.cells.into(), values: both.into_iter().map(|pair| pair[which]).collect() }
}

/// Makes the air move as `velocity` says of places; as if that were how the last step left it.
fn set_velocity(engine: &Engine, player: &Player, velocity: impl Fn(glam::Vec3) -> glam::Vec3) {
    let air = air_of(player);
    let now = ((player.steps * u64::from(air.plan.sub_steps)) & 1) as usize;
    let extent = UVec3::from(air.plan.cells) + 1;
    for axis in 0..3 {
        let mut values = Vec::with_capacity(extent.element_product() as usize);
        for z in 0..extent.z {
            for y in 0..extent.y {
                for x in 0..extent.x {
                    let mut offset = glam::Vec3::splat(0.5);
                    offset[axis] = 0.0;
                    let place = (glam::Vec3::new(x as f32, y as f32, z as f32) + offset) * air.plan.side;
                    values.push(velocity(glam::Vec3::from(air.plan.origin) + place)[axis]);
                }
            }
        }
        let bytes = bytemuck::cast_slice(&values);
        engine.gpu().queue.write_buffer(&air.velocity[now][axis], 0, bytes);
    }
}

/// How much more leaves each cell than enters it.
fn divergence([u, v, w]: &[Field; 3]) -> Vec<f32> {
    let cells = u.extent - 1;
    let mut all = Vec::new();
    for z in 0..cells.z {
        for y in 0..cells.y {
            for x in 0..cells.x {
                all.push(
                    u.at(x + 1, y, z) - u.at(x, y, z) + v.at(x, y + 1, z) - v.at(x, y, z) + w.at(x, y, z + 1)
                        - w.at(x, y, z),
                );
            }
        }
    }
    all
}

fn root_mean_square(values: &[f32]) -> f64 {
    let sum: f64 = values.iter().map(|&value| f64::from(value) * f64::from(value)).sum();
    (sum / values.len() as f64).sqrt()
}

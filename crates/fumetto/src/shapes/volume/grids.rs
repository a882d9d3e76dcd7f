//! From particles to what is marched: the grids of matter and of light.

use super::{
    bricks::BrickField,
    field::{CellField, Field, view},
    recipe::RecipeUniform,
};
use crate::gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, linear_sampler, shader};

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Volume {
    bounds: ComputePipeline,
    matter: ComputePipeline,
    occupied: ComputePipeline,
    transmit: ComputePipeline,
    transmit_bricks: ComputePipeline,
    linear: wgpu::Sampler,
}

#[repr(C)]
#[derive(Clone, Copy, bytemuck::Pod, bytemuck::Zeroable)]
struct RoomUniform {
    cells: [u32; 3],
    pad: u32,
    light_cells: [u32; 3],
    pad_end: u32,
}

impl Volume {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        use Slot::{Linear, Read, Texture3d, Uniform, Write, WriteIds3d, WriteTexture3d};
        let slots = [Uniform, Uniform, Read, Write];
        let [bounds] = kernels(gpu, shader!("shapes/volume/bounds"), &slots, ["main"]);
        let slots = [Uniform, Read, Read, WriteTexture3d, WriteIds3d];
        let [matter] = kernels(gpu, shader!("shapes/volume/matter"), &slots, ["main"]);
        let [occupied] = kernels(gpu, shader!("shapes/volume/occupied"), &[Read, Write, Texture3d], ["main"]);
        let slots = [Uniform, Uniform, Linear, Read, Read, Texture3d, WriteTexture3d];
        let [transmit] = kernels(gpu, shader!("shapes/volume/transmit"), &slots, ["main"]);
        let [transmit_bricks] = kernels(gpu, shader!("shapes/volume/bricks/transmit"), &slots, ["main"]);
        Self { bounds, matter, occupied, transmit, transmit_bricks, linear: linear_sampler(gpu) }
    }

    /// Fills `field` with the matter of `puffs`, unless it has its own, and with the light that comes through it.
    pub(super) fn record(
        &self,
        frame: &mut Frame<'_>,
        puffs: &wgpu::Buffer,
        lights: &wgpu::Buffer,
        recipe: &RecipeUniform,
        field: &Field,
    ) {
        let recipe = frame.uniform("shapes.volume.recipe", recipe);
        match field {
            Field::Cells(field) => {
                self.record_matter(frame, puffs, &recipe, field);
                self.record_light(frame, lights, &recipe, field);
            }
            Field::Bricks(field) => self.record_light_in_bricks(frame, lights, &recipe, field),
        }
    }

    fn record_matter(
        &self,
        frame: &mut Frame<'_>,
        puffs: &wgpu::Buffer,
        recipe: &wgpu::Buffer,
        field: &CellField,
    ) {
        let room =
            RoomUniform { cells: field.room.cells, pad: 0, light_cells: field.room.light_cells, pad_end: 0 };
        let room = frame.uniform("shapes.volume.room", &room);
        let bindings = [recipe, &room, puffs, &field.grid].map(wgpu::Buffer::as_entire_binding);
        frame.compute("shapes.volume.bounds", &self.bounds, &bindings, [1, 1, 1]);
        let (density, owners) = (view(&field.density), view(&field.owners));
        let [x, y, z] = field.room.cells;
        frame.compute(
            "shapes.volume.matter",
            &self.matter,
            &[
                recipe.as_entire_binding(),
                field.grid.as_entire_binding(),
                puffs.as_entire_binding(),
                wgpu::BindingResource::TextureView(&density),
                wgpu::BindingResource::TextureView(&owners),
            ],
            [x.div_ceil(8), y.div_ceil(8), z.div_ceil(4)],
        );
        frame.compute(
            "shapes.volume.occupied",
            &self.occupied,
            &[
                field.grid.as_entire_binding(),
                field.occupied.as_entire_binding(),
                wgpu::BindingResource::TextureView(&density),
            ],
            field.block_groups(),
        );
    }

    fn record_light(
        &self,
        frame: &mut Frame<'_>,
        lights: &wgpu::Buffer,
        recipe: &wgpu::Buffer,
        field: &CellField,
    ) {
        let (density, transmitted) = (view(&field.density), view(&field.transmitted));
        frame.compute(
            "shapes.volume.transmit",
            &self.transmit,
            &[
                recipe.as_entire_binding(),
                lights.as_entire_binding(),
                wgpu::BindingResource::Sampler(&self.linear),
                field.grid.as_entire_binding(),
                field.occupied.as_entire_binding(),
                wgpu::BindingResource::TextureView(&density),
                wgpu::BindingResource::TextureView(&transmitted),
            ],
            field.room.light_cells.map(|side| side.div_ceil(4)),
        );
    }

    fn record_light_in_bricks(
        &self,
        frame: &mut Frame<'_>,
        lights: &wgpu::Buffer,
        recipe: &wgpu::Buffer,
        field: &BrickField,
    ) {
        let (atlas, transmitted) = (view(&field.atlas), view(&field.transmitted));
        frame.compute(
            "shapes.volume.bricks.transmit",
            &self.transmit_bricks,
            &[
                recipe.as_entire_binding(),
                lights.as_entire_binding(),
                wgpu::BindingResource::Sampler(&self.linear),
                field.grid.as_entire_binding(),
                field.table.as_entire_binding(),
                wgpu::BindingResource::TextureView(&atlas),
                wgpu::BindingResource::TextureView(&transmitted),
            ],
            field.light_sides.map(|side| side.div_ceil(4)),
        );
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(lies_as_its_twin: RoomUniform, "Room" of "shapes/volume/bounds" { cells, light_cells });
}

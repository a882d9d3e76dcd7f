//! Lines of any width around seeds, by jump flooding.

use crate::gpu::{Frame, Gpu, RasterPipeline, RenderPipeline, Target, Transient, shader};

/// `Seed`s of `seed.wgsl`.
pub(super) const SEED_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rg32Uint;

/// Pixels along the side of a tile. Also in `tiles.wgsl`.
const TILE_PX: u32 = 32;

/// The long-lived pipeline.
#[derive(Debug)]
pub(super) struct Flood {
    pipeline: RenderPipeline,
}

/// Tiles of a picture that are wide enough for all lines to lie in.
pub(super) fn tiles(size: [u32; 2]) -> u32 {
    size[0].div_ceil(TILE_PX) * size[1].div_ceil(TILE_PX)
}

impl Flood {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let module = gpu.module(shader!("ink/flood"));
        let pipeline = RasterPipeline { label: "ink.flood", targets: &[SEED_FORMAT], ..Default::default() };
        Self { pipeline: pipeline.build(&module) }
    }

    /// Spreads `seeds`, of a picture of `size`, as far as `radius_px`, in the `tiles` that are not 0.
    pub(super) fn record(
        &self,
        frame: &mut Frame<'_>,
        seeds: Transient,
        size: [u32; 2],
        tiles: &wgpu::Buffer,
        radius_px: f32,
    ) -> Transient {
        let mut flooded = seeds;
        for jump in jumps(radius_px) {
            let next = frame.texture("ink.flood", size, SEED_FORMAT);
            let uniform = frame.uniform("ink.flood.uniform", &[jump, 0, 0, 0]);
            frame.raster(
                "ink.flood",
                &self.pipeline,
                Target::colour(&next, Some(wgpu::Color::TRANSPARENT)),
                &[
                    uniform.as_entire_binding(),
                    tiles.as_entire_binding(),
                    wgpu::BindingResource::TextureView(&flooded),
                ],
                |pass| pass.draw(0..6 * self::tiles(size), 0..1),
            );
            flooded = next;
        }
        flooded
    }
}

/// Halving distances that together reach `radius_px`.
fn jumps(radius_px: f32) -> impl Iterator<Item = u32> {
    let first = (radius_px.ceil() as u32 + 1).next_power_of_two() / 2;
    std::iter::successors(Some(first.max(1)), |jump| (*jump > 1).then_some(jump / 2))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::{TexturePool, read_texture};

    const SIZE: [u32; 2] = [150, 110];

    /// As `outside_px` of `seed.wgsl`, of a seed in the middle of its pixel.
    fn outside_px([place, line]: [u32; 2], [x, y]: [u32; 2]) -> f32 {
        let apart = [(place & 0x3fff) as f32 - x as f32, (place >> 14 & 0x3fff) as f32 - y as f32];
        apart[0].hypot(apart[1]) - (line & 0xffff) as f32 / 64.0
    }

    /// Floods seeds at random places whose lines have one of two widths; answers with them and the flood.
    fn flooded(half_widths: [f32; 2]) -> (Vec<[u32; 2]>, Vec<[u32; 2]>) {
        let gpu = pollster::block_on(Gpu::headless()).expect("a Vulkan driver");
        let pool = TexturePool::default();
        let mut frame = Frame::new(&gpu, &pool, "test");
        let mut state = 7_u32;
        let mut random = move |below: u32| {
            state = state.wrapping_mul(747_796_405).wrapping_add(2_891_336_453);
            (state >> 8) % below
        };
        let seeds: Vec<_> = (0..120)
            .map(|number: usize| {
                let middle = 4 << 28;
                let half_width = (half_widths[number % 2] * 64.0) as u32;
                [random(SIZE[0]) | random(SIZE[1]) << 14 | middle, half_width | 1 << 16]
            })
            .collect();
        let mut texels = vec![[0_u32; 2]; (SIZE[0] * SIZE[1]) as usize];
        for seed in &seeds {
            texels[((seed[0] >> 14 & 0x3fff) * SIZE[0] + (seed[0] & 0x3fff)) as usize] = *seed;
        }
        let texture = frame.texture("test.seeds", SIZE, SEED_FORMAT);
        gpu.queue.write_texture(
            texture.texture().as_image_copy(),
            bytemuck::cast_slice(&texels),
            wgpu::TexelCopyBufferLayout { offset: 0, bytes_per_row: Some(8 * SIZE[0]), rows_per_image: None },
            texture.texture().size(),
        );
        let all = frame.storage("test.tiles", &vec![1_u32; tiles(SIZE) as usize]);
        let radius_px = half_widths[0].max(half_widths[1]);
        let flood = Flood::new(&gpu).record(&mut frame, texture, SIZE, &all, radius_px);
        frame.submit();
        let bytes = read_texture(&gpu, flood.texture()).expect("the device is there");
        (seeds, bytemuck::pod_collect_to_vec(&bytes))
    }

    #[test]
    fn finds_the_nearest_seed() {
        for half_widths in [[1.0, 1.0], [6.0, 6.0], [20.0, 20.0], [3.0, 12.0]] {
            let (seeds, flood) = flooded(half_widths);
            let mut wrong = 0;
            for (index, found) in flood.iter().enumerate() {
                let at = [index as u32 % SIZE[0], index as u32 / SIZE[0]];
                let nearest = seeds.iter().map(|seed| outside_px(*seed, at)).fold(f32::MAX, f32::min);
                // Only what is inside a line counts.
                if nearest < 0.0 {
                    let distance = if found[1] == 0 { f32::MAX } else { outside_px(*found, at) };
                    assert!(
                        distance < nearest + 1.0,
                        "{half_widths:?}: {distance} at {at:?}, should be {nearest}"
                    );
                    wrong += usize::from(distance > nearest + 1e-3);
                }
            }
            assert!(wrong * 200 < flood.len(), "{half_widths:?}: {wrong} pixels are not exact");
        }
    }
}

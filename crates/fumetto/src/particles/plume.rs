//! One object's smoke: its emitters' particles, and the vortices or the air that carry them.

use fumetto_scene::{Force, Smoke};

use super::{
    Emission,
    emission::{Carrier, Motion},
    grid::{Air, Flow},
    vortex::{Span, Swirl, Tree, Vortices},
};
use crate::gpu::{Frame, Gpu};

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Particles {
    vortices: Vortices,
    flow: Flow,
    motion: Motion,
}

/// All that moves of one object.
#[derive(Debug)]
pub(crate) struct Plume {
    /// In the scene's order.
    pub(crate) emissions: Vec<Emission>,
    forces: Vec<Force>,
    seed: u32,
    swirl: Option<Swirl>,
    air: Option<Air>,
    /// Stands in where there are no vortices.
    nothing: Tree,
}

impl Particles {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self { vortices: Vortices::new(gpu), flow: Flow::new(gpu), motion: Motion::new(gpu) }
    }

    /// Advances by the step from `step · dt` to `(step + 1) · dt`.
    pub(crate) fn step(&self, frame: &mut Frame<'_>, plume: &Plume, step: u64, dt: f64) {
        let span = Span { time: step as f64 * dt, dt };
        if let Some(air) = &plume.air {
            self.step_in_air(frame, plume, air, (step, dt));
            return;
        }
        let tree = match &plume.swirl {
            Some(swirl) => {
                self.vortices.step(frame, swirl, &plume.forces, span);
                &swirl.tree
            }
            None => &plume.nothing,
        };
        for emission in &plume.emissions {
            self.motion.step(frame, emission, &plume.forces, Carrier::Tree(tree), span);
        }
    }

    pub(super) fn flow(&self) -> &Flow {
        &self.flow
    }

    pub(super) fn motion(&self) -> &Motion {
        &self.motion
    }

    /// In as many sub-steps as the grid's cells want.
    fn step_in_air(&self, frame: &mut Frame<'_>, plume: &Plume, air: &Air, (step, dt): (u64, f64)) {
        let sub_steps = u64::from(air.plan.sub_steps);
        for number in step * sub_steps..(step + 1) * sub_steps {
            let span = Span::between(number, dt / sub_steps as f64);
            self.flow.step(frame, air, &plume.emissions, (&plume.forces, plume.seed), (number, span));
            let (grid, velocity) = air.after(frame, number + 1);
            for emission in &plume.emissions {
                self.motion.step(frame, emission, &plume.forces, Carrier::Air(&grid, velocity), span);
            }
        }
    }
}

impl Plume {
    pub(crate) fn new(gpu: &Gpu, smoke: &Smoke, seed: u32, step_secs: f64, has_obstacles: bool) -> Self {
        let seeds: Vec<u32> = (0..smoke.emitters.len() as u32)
            .map(|number| seed.wrapping_add(number.wrapping_mul(0x27d4_eb2f)))
            .collect();
        let emissions = smoke.emitters.iter().zip(&seeds);
        Self {
            emissions: emissions
                .map(|(emitter, &seed)| Emission::new(gpu, emitter, seed, step_secs))
                .collect(),
            forces: smoke.forces.clone(),
            seed,
            swirl: Swirl::new(gpu, smoke, &seeds, step_secs),
            air: Air::new(gpu, smoke, step_secs, has_obstacles),
            nothing: Tree::new(gpu, 0),
        }
    }

    /// Back to before the first birth.
    pub(crate) fn reset(&self, frame: &mut Frame<'_>) {
        for emission in &self.emissions {
            emission.reset(frame);
        }
        if let Some(swirl) = &self.swirl {
            swirl.reset(frame);
        }
        if let Some(air) = &self.air {
            air.reset(frame);
        }
    }

    pub(super) fn forces(&self) -> &[Force] {
        &self.forces
    }

    pub(super) fn seed(&self) -> u32 {
        self.seed
    }

    /// What the next step needs beside the particles.
    pub(crate) fn hidden(&self) -> Vec<&wgpu::Buffer> {
        let vortices = self.swirl.iter().map(|swirl| &swirl.vortices);
        vortices.chain(self.air.iter().flat_map(Air::state)).collect()
    }

    /// The air, if it is simulated.
    pub(crate) fn air(&self) -> Option<&Air> {
        self.air.as_ref()
    }

    /// The vortices, if there are any.
    #[cfg(test)]
    pub(super) fn swirl(&self) -> Option<&Swirl> {
        self.swirl.as_ref()
    }
}

//! One object's smoke: its emitters' particles, and the vortices that carry them.

use fumetto_scene::{Force, Smoke};

use super::{
    Emission,
    emission::Motion,
    vortex::{Span, Swirl, Tree, Vortices},
};
use crate::gpu::{Frame, Gpu};

/// Long-lived kernels.
#[derive(Debug)]
pub(crate) struct Particles {
    vortices: Vortices,
    motion: Motion,
}

/// All that moves of one object.
#[derive(Debug)]
pub(crate) struct Plume {
    /// In the scene's order.
    pub(crate) emissions: Vec<Emission>,
    forces: Vec<Force>,
    swirl: Option<Swirl>,
    /// Stands in where there are no vortices.
    nothing: Tree,
}

impl Particles {
    pub(crate) fn new(gpu: &Gpu) -> Self {
        Self { vortices: Vortices::new(gpu), motion: Motion::new(gpu) }
    }

    /// Advances by the step from `step · dt` to `(step + 1) · dt`.
    pub(crate) fn step(&self, frame: &mut Frame<'_>, plume: &Plume, step: u64, dt: f64) {
        let span = Span { time: step as f64 * dt, dt };
        let tree = match &plume.swirl {
            Some(swirl) => {
                self.vortices.step(frame, swirl, &plume.forces, span);
                &swirl.tree
            }
            None => &plume.nothing,
        };
        for emission in &plume.emissions {
            self.motion.step(frame, emission, &plume.forces, tree, span);
        }
    }
}

impl Plume {
    pub(crate) fn new(gpu: &Gpu, smoke: &Smoke, seed: u32, step_secs: f64) -> Self {
        let seeds: Vec<u32> = (0..smoke.emitters.len() as u32)
            .map(|number| seed.wrapping_add(number.wrapping_mul(0x27d4_eb2f)))
            .collect();
        let emissions = smoke.emitters.iter().zip(&seeds);
        Self {
            emissions: emissions
                .map(|(emitter, &seed)| Emission::new(gpu, emitter, seed, step_secs))
                .collect(),
            forces: smoke.forces.clone(),
            swirl: Swirl::new(gpu, smoke, &seeds, step_secs),
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
    }

    /// The vortices, if there are any.
    #[cfg(test)]
    pub(super) fn swirl(&self) -> Option<&Swirl> {
        self.swirl.as_ref()
    }
}

//! Vortex rings, which emitters shed and which carry smoke and each other.
//!
//! ```text
//! rings are born ─▶ tree ─▶ half a step ─▶ tree of the middle ─▶ a whole step
//!                                                         └─▶ the smoke's step
//! ```

mod carry;
mod order;
mod rings;
mod swirl;
mod tree;

use fumetto_scene::Force;

pub(super) use swirl::Swirl;
pub(super) use tree::Tree;

use self::{
    carry::{Carry, Uniforms},
    order::Order,
    rings::Rings,
};
use crate::gpu::{Frame, Gpu};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Vortices {
    rings: Rings,
    order: Order,
    carry: Carry,
}

/// From when on a step lasts how long, in seconds.
#[derive(Clone, Copy, Debug)]
pub(super) struct Span {
    pub(super) time: f64,
    pub(super) dt: f64,
}

impl Span {
    /// The `number`-th of steps that last `dt`: it ends just where the next begins, so that no birth falls between
    /// them.
    pub(super) fn between(number: u64, dt: f64) -> Self {
        let time = number as f64 * dt;
        Self { time, dt: (number + 1) as f64 * dt - time }
    }
}

impl Vortices {
    pub(super) fn new(gpu: &Gpu) -> Self {
        Self { rings: Rings::new(gpu), order: Order::new(gpu), carry: Carry::new(gpu) }
    }

    /// Advances by a step; the tree is then that of its middle.
    pub(super) fn step(&self, frame: &mut Frame<'_>, swirl: &Swirl, forces: &[Force], span: Span) {
        if swirl.tree.places == 0 {
            return;
        }
        for source in &swirl.sources {
            self.rings.record(frame, swirl, source, span);
        }
        self.order.record(frame, swirl, false);
        let uniforms: Vec<_> =
            swirl.sources.iter().map(|source| Uniforms::new(frame, swirl, source, forces, span)).collect();
        for (source, uniforms) in swirl.sources.iter().zip(&uniforms) {
            self.carry.predict(frame, swirl, source, uniforms);
        }
        self.order.record(frame, swirl, true);
        for (source, uniforms) in swirl.sources.iter().zip(&uniforms) {
            self.carry.complete(frame, swirl, source, uniforms);
        }
    }
}

#[cfg(test)]
mod tests;

//! A simulated particle, as the device has it.

use bytemuck::{Pod, Zeroable};
use glam::Vec3;

/// `Particle` of `state.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Debug, PartialEq, Pod, Zeroable)]
pub(crate) struct Particle {
    pub(crate) position: Vec3,
    pub(crate) age: f32,
    pub(crate) velocity: Vec3,
    pub(crate) life: f32,
    pub(crate) carried: Vec3,
    pub(crate) radius: f32,
    pub(crate) mass: f32,
    pub(crate) birth: u32,
    pad: [u32; 2],
}

impl Particle {
    /// An age that is no number is not beyond the end of a life either.
    pub(crate) fn is_dead(&self) -> bool {
        self.age >= self.life
    }

    /// The quantity that is no finite number, if any is.
    pub(crate) fn broken(&self) -> Option<&'static str> {
        [
            ("position", self.position.is_finite()),
            ("velocity", self.velocity.is_finite() && self.carried.is_finite()),
            ("age", self.age.is_finite()),
            ("radius", self.radius.is_finite()),
            ("mass", self.mass.is_finite()),
        ]
        .into_iter()
        .find_map(|(quantity, is_finite)| (!is_finite).then_some(quantity))
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(
        lies_as_its_twin: Particle,
        "Particle" of "particles/step" { position, age, velocity, life, carried, radius, mass, birth }
    );

    #[test]
    fn what_is_no_number_is_named() {
        let whole = Particle { life: 1.0, ..Particle::zeroed() };
        assert_eq!((whole.broken(), whole.is_dead()), (None, false));
        let lost = Particle { carried: Vec3::new(0.0, f32::INFINITY, 0.0), ..whole };
        assert_eq!(lost.broken(), Some("velocity"));
        let timeless = Particle { age: f32::NAN, ..whole };
        assert_eq!((timeless.broken(), timeless.is_dead()), (Some("age"), false));
    }
}

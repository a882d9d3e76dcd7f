//! The shader programs of each room.

mod ink;
mod light;
mod mesh;
mod paint;
mod particles;
mod puffs;
mod surface;
mod tone;
mod volume;

/// Programs: of each its name, then its modules (`src/….wgsl`), what is used before what uses it.
pub(crate) type Programs = &'static [(&'static str, &'static [&'static str])];

pub(crate) const ROOMS: &[Programs] = &[
    ink::PROGRAMS,
    light::PROGRAMS,
    mesh::PROGRAMS,
    paint::PROGRAMS,
    particles::PROGRAMS,
    puffs::PROGRAMS,
    surface::PROGRAMS,
    tone::PROGRAMS,
    volume::PROGRAMS,
];

//! Pictures against closed forms, drawn by whatever adapter there is.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

mod balls;
mod cels;
mod colours;
mod details;
mod edges;
mod errors;
mod exports;
mod hatching;
mod hatching_ways;
mod ink;
mod ink_methods;
mod light;
mod mesh_shadows;
mod meshes;
mod models;
mod multiresolution;
mod occlusion;
mod paint;
mod relief;
mod shading_rows;
mod shadings;
mod shadows;
mod soft_shadows;
mod stage;
mod surface_changes;
mod surface_lines;
mod surface_shadows;
mod surfaces;
mod terminators;
mod time;
mod volumes;

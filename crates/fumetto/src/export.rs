//! What a scene is made of at one moment, for other programs.

use bytemuck::{Pod, Zeroable};
use fumetto_formats::{Group, Image, Solid};
use fumetto_scene::{Colour, Object, Particle, Ramp};

use crate::{
    Engine, Error, Player, Shot,
    assets::load_image,
    gpu::{Gpu, GpuError, read_items},
    player::{PlayedMatter, PlayedModel},
    shapes::{
        mesh::{Reserved, Triangle, unpacked},
        puffs::Puff,
        surface::shortage,
    },
};

/// An object's triangles as they were found.
#[derive(Clone, Debug, PartialEq)]
pub struct Export {
    /// The triangles.
    pub solid: Solid,
    /// What the user should know about them: sentences that name the object.
    pub notes: Vec<String>,
}

/// `Vertex` of `mesh.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Vertex {
    position: [f32; 3],
    normal: u32,
}

/// `Counters` of `counters.wgsl`.
#[repr(C)]
#[derive(Clone, Copy, Pod, Zeroable)]
struct Counters {
    draw: [u32; 4],
    vertices: u32,
    triangles: u32,
    overflow: u32,
    pad: u32,
}

impl Engine {
    /// The triangles of the scene's `object`-th object at the moment that `player` is at; `None` of one that
    /// is drawn without any, as puffs are. Cells that are lengths on the picture are as the scene's first camera
    /// sees them.
    ///
    /// # Errors
    /// When a ramp's picture cannot be read, or the device is lost.
    pub async fn solid_async(&self, player: &Player, object: usize) -> Result<Option<Export>, Error> {
        let scene = player.scene();
        let (Some(described), Some(played)) = (scene.objects.get(object), player.objects.get(object)) else {
            return Ok(None);
        };
        let lit = lit_tone(player, described)?;
        if let PlayedMatter::Model(model) = &played.matter {
            let solid = model_solid(self.gpu(), player, (described, object), model, lit).await?;
            return Ok(Some(Export { solid, notes: Vec::new() }));
        }
        self.look(player, &Shot::of(scene).camera);
        let reserved = player.meshes.reserved.iter().find(|reserved| reserved.object == object);
        let Some(reserved) = reserved else { return Ok(None) };
        Ok(Some(surface_export(self.gpu(), player, described, reserved, lit).await?))
    }

    /// The particles of the scene's `object`-th object at the moment that `player` is at, as they are at their
    /// age; none of a model or a volume out of a file.
    ///
    /// # Errors
    /// When the device is lost.
    pub async fn particles_async(&self, player: &Player, object: usize) -> Result<Vec<Particle>, Error> {
        let Some(played) = player.objects.get(object) else { return Ok(Vec::new()) };
        match &played.matter {
            PlayedMatter::Still(particles) | PlayedMatter::Sequence(_, particles) => Ok(particles.clone()),
            PlayedMatter::Morph(tracks) => {
                let mut particles = tracks.at(player.secs(player.shown.unwrap_or_default()));
                particles.retain(|particle| particle.radius > 0.0);
                Ok(particles)
            }
            PlayedMatter::Model(_) | PlayedMatter::Imported(_) | PlayedMatter::Paint => Ok(Vec::new()),
            PlayedMatter::Smoke(_) => {
                let range = player.puffs.objects[object].range.clone();
                let puffs: Vec<Puff> = read_items(self.gpu(), &player.puffs.puffs, range).await?;
                let size = played.placement.size;
                let there = puffs.iter().filter(|puff| puff.radius > 0.0);
                let particle = |puff: &Puff| Particle {
                    center: puff.center,
                    radius: puff.radius / size,
                    mass: puff.mass,
                };
                Ok(there.map(particle).collect())
            }
        }
    }
}

/// A surface that the device has made.
async fn surface_export(
    gpu: &Gpu,
    player: &Player,
    object: &Object,
    reserved: &Reserved,
    lit: Colour,
) -> Result<Export, GpuError> {
    let counters: Vec<Counters> = read_items(gpu, &reserved.counters, 0..1).await?;
    let Counters { vertices, triangles, overflow, .. } = counters[0];
    let first = reserved.vertices.start;
    let vertices = read_vertices(gpu, player, first..first + vertices).await?;
    let start = reserved.triangles.start;
    let triangles: Vec<Triangle> =
        read_items(gpu, &player.meshes.triangles, start..start + triangles).await?;
    // Where vertices did not fit, the device writes triangles that cover nothing.
    let covers = |[a, b, c]: &[u32; 3]| a != b && b != c && c != a;
    let corners = triangles.iter().map(|triangle| triangle.corners.map(|corner| corner - first));
    let group =
        Group { material: object.name.clone(), colour: lit, triangles: corners.filter(covers).collect() };
    let notes = shortage(overflow).map(|what| format!("the surface of `{}` {what}", object.name));
    Ok(Export { solid: solid(object, &vertices, vec![group]), notes: notes.into_iter().collect() })
}

/// A model with its copies, where its parts now are.
async fn model_solid(
    gpu: &Gpu,
    player: &Player,
    (object, number): (&Object, usize),
    played: &PlayedModel,
    lit: Colour,
) -> Result<Solid, GpuError> {
    let geometry = &player.geometry;
    let range = geometry.vertices(number);
    let (start, end) = (range.start as u32, range.end as u32);
    let vertices = read_vertices(gpu, player, start..end).await?;
    let materials = &played.model.materials;
    let mut groups: Vec<Group> = materials
        .iter()
        .map(|material| {
            let name = if material.name.is_empty() { "plain" } else { &material.name };
            let [r, g, b, _] = material.colour;
            // As `flat.wgsl` does: tones are multiplied by as much of it as the style shows.
            let shown = |own: f32| 1.0 + object.style.material * (own - 1.0);
            let tint = [r, g, b].map(shown);
            let linear = [0, 1, 2].map(|channel| lit.linear[channel] * tint[channel]);
            let material = format!("{}.{name}", object.name);
            Group { material, colour: Colour { linear }, triangles: Vec::new() }
        })
        .collect();
    let placed = played.model.placed(0.0);
    let triangles = &geometry.triangles[geometry.objects[number].start as usize..];
    for triangle in &triangles[..geometry.objects[number].len()] {
        let part = (triangle.part as usize - played.parts.start) % placed.len().max(1);
        let material = played.model.parts[placed[part].part].material;
        groups[material].triangles.push(triangle.corners.map(|corner| corner - start));
    }
    groups.retain(|group| !group.triangles.is_empty());
    Ok(solid(object, &vertices, groups))
}

fn solid(object: &Object, vertices: &[Vertex], groups: Vec<Group>) -> Solid {
    Solid {
        name: object.name.clone(),
        positions: vertices.iter().map(|vertex| vertex.position).collect(),
        normals: vertices.iter().map(|vertex| unpacked(vertex.normal).to_array()).collect(),
        groups,
    }
}

async fn read_vertices(
    gpu: &Gpu,
    player: &Player,
    range: std::ops::Range<u32>,
) -> Result<Vec<Vertex>, GpuError> {
    read_items(gpu, &player.meshes.vertices, range).await
}

/// What a fully lit surface of an object is drawn in.
fn lit_tone(player: &Player, object: &Object) -> Result<Colour, Error> {
    Ok(match &object.style.ramp {
        Ramp::Tones(tones) => tones.last().map_or(Colour { linear: [1.0; 3] }, |tone| tone.colour),
        Ramp::Gooch(gooch) => gooch.colour,
        Ramp::Image(ramp) => lightest(&load_image(player.assets(), &ramp.path)?),
    })
}

/// The last column of a ramp's picture, in its middle row.
fn lightest(image: &Image) -> Colour {
    let end = 4 * ((image.height / 2 + 1) as usize * image.width as usize);
    let pixel = end.checked_sub(4).and_then(|start| image.pixels.get(start..end));
    pixel.map_or(Colour { linear: [1.0; 3] }, |rgba| Colour::from_srgb8([rgba[0], rgba[1], rgba[2]]))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::gpu::layout_test;

    layout_test!(vertices_lie_as_their_twin: Vertex, "Vertex" of "shapes/mesh/place" { position, normal });
}

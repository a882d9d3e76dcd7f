//! Strokes: lines as a hand draws them (Álvarez et al. 2007, section 4).
//!
//! ```text
//! candidates with lines ─▶ pieces ─▶ which ends meet ─▶ order along lines ─▶ joints ─▶ seen? ─▶ smooth ─▶ polygons
//! ```
//!
//! Nothing is read back. Pieces are linked by what tells their ends apart (the two vertices between which an end lies)
//! and put in order by pointer jumping, so that a line of n pieces takes 2 log n rounds over all of them.
//!
//! Nothing is remembered from frame to frame, either: what the hand does comes of where in space a line runs, and
//! closed lines begin at their feet. So a stroke keeps its ways, and a frame is the same however it is reached.

mod chains;
mod paper;
mod polygons;
mod room;
mod style;
#[cfg(test)]
mod tests;
mod textures;

use chains::Chains;
pub(crate) use paper::{TOOTH_SIDE, tooth};
use polygons::Polygons;
use room::StrokeRoom;
pub(crate) use style::{Moment, StrokeStyle, reach_px};
pub(crate) use textures::StrokeTextures;

use crate::{
    gpu::{Compact, Frame, Gpu, Listing, Transient},
    ink::MAX_PENS,
    layers::Layers,
    shapes::{mesh::MeshScene, puffs::Subject},
};

/// Bits of all kinds of edges with strokes, as `edges.wgsl` flags them.
const ALL_STROKES: u32 = 0xf0;

/// The long-lived pipelines, and room for the lines of a scene.
#[derive(Debug)]
pub(crate) struct Strokes {
    chains: Chains,
    polygons: Polygons,
    room: StrokeRoom,
}

/// What strokes are drawn with.
pub(crate) struct Drawing<'a> {
    pub(crate) textures: &'a StrokeTextures,
    pub(crate) styles: [StrokeStyle; MAX_PENS],
    /// Samples along the whole picture's height.
    pub(crate) picture_height: u32,
}

impl Strokes {
    /// With room for the lines of `meshes`.
    pub(crate) fn new(gpu: &Gpu, meshes: &MeshScene) -> Self {
        let room = StrokeRoom::new(gpu, StrokeRoom::needed(meshes));
        Self { chains: Chains::new(gpu), polygons: Polygons::new(gpu), room }
    }

    /// Makes more room, if the lines of `meshes` need it.
    pub(crate) fn make_room(&mut self, gpu: &Gpu, meshes: &MeshScene) {
        let needed = StrokeRoom::needed(meshes);
        if needed > self.room.pieces {
            self.room = StrokeRoom::new(gpu, needed);
        }
    }

    /// Draws into `ink` the strokes of the objects that `members` numbers, along lines that have just been found. `depth`
    /// is that of surfaces and of the lines drawn so far.
    pub(crate) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        compact: &Compact,
        drawing: &Drawing<'_>,
        (layers, members): (&Layers, &[usize]),
        (ink, depth): (&Transient, &Transient),
    ) {
        let styles = frame.uniform("ink.stroke.styles", &drawing.styles);
        for lines in subject.meshes.lines(members) {
            let listing = Listing { items: lines.count, mask: ALL_STROKES, quads: 1 };
            compact.record(frame, lines.flags, listing, lines.list);
            self.chains.record(frame, subject, (lines, layers), (&styles, &drawing.styles), &self.room);
            self.polygons.record(frame, subject, (drawing, &self.room), &styles, layers, (ink, depth));
        }
    }
}

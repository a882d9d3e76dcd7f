//! Puts pieces of lines in order.

use super::{StrokeRoom, StrokeStyle};
use crate::{
    gpu::{ComputePipeline, Frame, Gpu, Slot, kernels, shader},
    ink::MAX_PENS,
    layers::Layers,
    shapes::{mesh::LineScene, puffs::Subject},
};

/// Long-lived kernels.
#[derive(Debug)]
pub(super) struct Chains {
    count: ComputePipeline,
    /// Of models, then of surfaces.
    pieces: [ComputePipeline; 2],
    insert: ComputePipeline,
    pair: ComputePipeline,
    begin: ComputePipeline,
    seek: ComputePipeline,
    orient: ComputePipeline,
    rank: ComputePipeline,
    total: ComputePipeline,
    starts: ComputePipeline,
    place: ComputePipeline,
    /// Of models, then of surfaces.
    see: [ComputePipeline; 2],
    bridge: ComputePipeline,
    smooth: ComputePipeline,
}

impl Chains {
    pub(super) fn new(gpu: &Gpu) -> Self {
        let [uniform, read, write] = [Slot::Uniform, Slot::Read, Slot::Write];
        let [count] = kernels(gpu, shader!("ink/stroke/count"), &[read, write, read], ["main"]);
        let slots = [uniform, read, read, uniform, read, read, read, uniform, uniform, uniform, read, write];
        let [models] = kernels(gpu, shader!("ink/stroke/pieces"), &slots, ["main"]);
        let [surfaces] = kernels(gpu, shader!("ink/stroke/pieces_made"), &slots, ["main"]);
        let pieces = [models, surfaces];
        let slots = [uniform, read, write, write, write];
        let [insert, pair] = kernels(gpu, shader!("ink/stroke/meet"), &slots, ["insert", "pair"]);
        let slots = [uniform, read, read, read, write, write, write];
        let entries = ["begin", "seek", "orient", "rank", "total"];
        let [begin, seek, orient, rank, total] = kernels(gpu, shader!("ink/stroke/chain"), &slots, entries);
        let slots = [uniform, read, write, read, write, write, uniform];
        let [starts] = kernels(gpu, shader!("ink/stroke/starts"), &slots, ["main"]);
        let slots = [uniform, read, read, read, read, read, write];
        let [place] = kernels(gpu, shader!("ink/stroke/place"), &slots, ["main"]);
        let slots = [uniform, read, read, read, write, read, read, uniform, Slot::Depth];
        let [models] = kernels(gpu, shader!("ink/stroke/see"), &slots, ["main"]);
        let [surfaces] = kernels(gpu, shader!("ink/stroke/see_made"), &slots, ["main"]);
        let see = [models, surfaces];
        let slots = [uniform, uniform, uniform, read, read, write];
        let [bridge] = kernels(gpu, shader!("ink/stroke/bridge"), &slots, ["main"]);
        let [smooth] = kernels(gpu, shader!("ink/stroke/smooth"), &slots, ["main"]);
        Self {
            count,
            pieces,
            insert,
            pair,
            begin,
            seek,
            orient,
            rank,
            total,
            starts,
            place,
            see,
            bridge,
            smooth,
        }
    }

    /// Fills `room` with where strokes run along the listed `lines`.
    pub(super) fn record(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (lines, layers): (LineScene<'_>, &Layers),
        (styles, all): (&wgpu::Buffer, &[StrokeStyle; MAX_PENS]),
        room: &StrokeRoom,
    ) {
        self.pieces(frame, subject, lines, styles, room);
        self.meet(frame, room);
        let ranks = self.order(frame, room);
        let passes = all.iter().map(StrokeStyle::passes).max().unwrap_or(0);
        self.place(frame, room, ranks, passes);
        self.follow(frame, subject, (lines, layers), styles, room);
    }

    fn pieces(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        lines: LineScene<'_>,
        styles: &wgpu::Buffer,
        room: &StrokeRoom,
    ) {
        let bindings = [&lines.list.draw, &room.tally, &room.records].map(wgpu::Buffer::as_entire_binding);
        frame.compute("ink.stroke.count", &self.count, &bindings, [1, 1, 1]);
        let meshes = subject.meshes;
        let bindings = [
            subject.view,
            lines.candidates,
            &meshes.vertices,
            subject.pens,
            &lines.list.items,
            &meshes.triangles,
            &meshes.parts,
            styles,
            subject.lights,
            &room.tally,
            &meshes.edges.seams,
            &room.records,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        let pipeline = &self.pieces[usize::from(lines.of_surface)];
        frame.compute_indirect("ink.stroke.pieces", pipeline, &bindings, &room.tally);
    }

    /// Finds which ends meet.
    fn meet(&self, frame: &mut Frame<'_>, room: &StrokeRoom) {
        frame.encoder.clear_buffer(&room.table, 0, None);
        let bindings = [&room.tally, &room.records, &room.table, &room.bucket, &room.partner]
            .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("ink.stroke.insert", &self.insert, &bindings, &room.tally);
        frame.compute_indirect("ink.stroke.pair", &self.pair, &bindings, &room.tally);
    }

    /// Finds the order of pieces along their lines. Answers with which of the two buffers tells.
    fn order(&self, frame: &mut Frame<'_>, room: &StrokeRoom) -> usize {
        let mut written = 0;
        let mut run = |label, pipeline| {
            written = 1 - written;
            let bindings = [
                &room.tally,
                &room.records,
                &room.partner,
                &room.known[1 - written],
                &room.known[written],
                &room.turns,
                &room.totals,
            ]
            .map(wgpu::Buffer::as_entire_binding);
            frame.compute_indirect(label, pipeline, &bindings, &room.tally);
        };
        run("ink.stroke.begin", &self.begin);
        (0..room.rounds()).for_each(|_| run("ink.stroke.seek", &self.seek));
        run("ink.stroke.orient", &self.orient);
        (0..room.rounds()).for_each(|_| run("ink.stroke.rank", &self.rank));
        run("ink.stroke.total", &self.total);
        // The last kernel reads, and writes nothing there.
        1 - written
    }

    fn place(&self, frame: &mut Frame<'_>, room: &StrokeRoom, ranks: usize, passes: u32) {
        let passes = frame.uniform("ink.stroke.passes", &[passes, 0, 0, 0]);
        let bindings =
            [&room.tally, &room.totals, &room.starts, &room.joints, &room.joint_tally, &room.draw, &passes]
                .map(wgpu::Buffer::as_entire_binding);
        frame.compute("ink.stroke.starts", &self.starts, &bindings, [1, 1, 1]);
        let bindings = [
            &room.tally,
            &room.records,
            &room.known[ranks],
            &room.turns,
            &room.totals,
            &room.starts,
            &room.joints,
        ]
        .map(wgpu::Buffer::as_entire_binding);
        frame.compute_indirect("ink.stroke.place", &self.place, &bindings, &room.tally);
    }

    /// Finds what of the lines is seen, and where a hand would draw along them.
    fn follow(
        &self,
        frame: &mut Frame<'_>,
        subject: Subject<'_>,
        (lines, layers): (LineScene<'_>, &Layers),
        styles: &wgpu::Buffer,
        room: &StrokeRoom,
    ) {
        let meshes = subject.meshes;
        let bindings = [
            subject.view,
            lines.candidates,
            &meshes.vertices,
            &room.joints,
            &room.seen,
            &meshes.triangles,
            &meshes.parts,
            &room.joint_tally,
        ];
        let mut bindings: Vec<_> = bindings.iter().map(|buffer| buffer.as_entire_binding()).collect();
        bindings.push(wgpu::BindingResource::TextureView(&layers.depth));
        let pipeline = &self.see[usize::from(lines.of_surface)];
        frame.compute_indirect("ink.stroke.see", pipeline, &bindings, &room.joint_tally);
        let followed = |from, to| {
            [subject.view, styles, &room.joint_tally, &room.joints, from, to]
                .map(wgpu::Buffer::as_entire_binding)
        };
        let bridged = followed(&room.seen, &room.bridged);
        frame.compute_indirect("ink.stroke.bridge", &self.bridge, &bridged, &room.joint_tally);
        let smoothed = followed(&room.bridged, &room.shapes);
        frame.compute_indirect("ink.stroke.smooth", &self.smooth, &smoothed, &room.joint_tally);
    }
}

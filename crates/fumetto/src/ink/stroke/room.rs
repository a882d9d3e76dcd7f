//! What chains are made with: one after another, all lists of lines share it.

use crate::{gpu::Gpu, shapes::mesh::MeshScene};

/// Most pieces of lines that are strokes at once, of one list; what goes beyond is left out. Contours of a model of a
/// million triangles are some thousands.
const MOST_PIECES: u32 = 1 << 17;

/// Joints there is room for, to a piece of a list of many.
const JOINTS: u32 = 2;
/// Pieces of a list of few may be long: there is room for all of them to have as many joints as one may have (257 with
/// its last, see `turn.wgsl`), up to so many joints. They follow 780,000 samples of line.
const LONG_JOINTS: u32 = 257;
const MOST_LONG_JOINTS: u32 = 1 << 17;

/// Buffers of the kernels.
#[derive(Debug)]
pub(super) struct StrokeRoom {
    /// Pieces there is room for.
    pub(super) pieces: u32,
    /// `Record`s of `record.wgsl`.
    pub(super) records: wgpu::Buffer,
    /// Buckets of `meet.wgsl`, and what is in them.
    pub(super) table: wgpu::Buffer,
    pub(super) bucket: wgpu::Buffer,
    pub(super) partner: wgpu::Buffer,
    /// What rounds of jumps read and write in turn.
    pub(super) known: [wgpu::Buffer; 2],
    pub(super) turns: wgpu::Buffer,
    pub(super) totals: wgpu::Buffer,
    pub(super) starts: wgpu::Buffer,
    /// `Joint`s of `joint.wgsl`.
    pub(super) joints: wgpu::Buffer,
    pub(super) seen: wgpu::Buffer,
    pub(super) bridged: wgpu::Buffer,
    /// `Shape`s of `shape.wgsl`.
    pub(super) shapes: wgpu::Buffer,
    /// `Tally`s: of pieces and of joints.
    pub(super) tally: wgpu::Buffer,
    pub(super) joint_tally: wgpu::Buffer,
    /// Arguments of the draw over all joints.
    pub(super) draw: wgpu::Buffer,
}

impl StrokeRoom {
    /// Pieces of lines that `meshes` may have in one list.
    pub(super) fn needed(meshes: &MeshScene) -> u32 {
        let made = meshes.reserved.iter().filter_map(|reserved| reserved.contours.as_ref());
        made.map(|contours| contours.count).fold(meshes.edges.count, u32::max).clamp(64, MOST_PIECES)
    }

    /// Joints that there is room for beside so many pieces.
    fn joints(pieces: u32) -> u32 {
        (JOINTS * pieces).max((LONG_JOINTS * pieces).min(MOST_LONG_JOINTS))
    }

    pub(super) fn new(gpu: &Gpu, pieces: u32) -> Self {
        let buffer = |label, bytes: u64, usage| {
            gpu.device.create_buffer(&wgpu::BufferDescriptor {
                label: Some(label),
                size: bytes,
                usage: wgpu::BufferUsages::STORAGE | usage,
                mapped_at_creation: false,
            })
        };
        let of_pieces =
            |label, bytes: u64| buffer(label, u64::from(pieces) * bytes, wgpu::BufferUsages::COPY_SRC);
        let joints = u64::from(Self::joints(pieces));
        let of_joints = |label, bytes: u64| buffer(label, joints * bytes, wgpu::BufferUsages::COPY_SRC);
        let counts =
            wgpu::BufferUsages::INDIRECT | wgpu::BufferUsages::UNIFORM | wgpu::BufferUsages::COPY_SRC;
        let buckets = u64::from((4 * pieces).next_power_of_two());
        Self {
            pieces,
            records: of_pieces("ink.stroke.records", 64),
            table: buffer("ink.stroke.table", 8 * buckets, wgpu::BufferUsages::COPY_DST),
            bucket: of_pieces("ink.stroke.bucket", 16),
            partner: of_pieces("ink.stroke.partner", 8),
            known: ["ink.stroke.known", "ink.stroke.learnt"].map(|label| of_pieces(label, 32)),
            turns: of_pieces("ink.stroke.turns", 4),
            totals: of_pieces("ink.stroke.totals", 4),
            starts: of_pieces("ink.stroke.starts", 4),
            joints: of_joints("ink.stroke.joints", 48),
            seen: of_joints("ink.stroke.seen", 4),
            bridged: of_joints("ink.stroke.bridged", 4),
            shapes: of_joints("ink.stroke.shapes", 32),
            tally: buffer("ink.stroke.tally", 16, counts),
            joint_tally: buffer("ink.stroke.joint_tally", 16, counts),
            draw: buffer("ink.stroke.draw", 16, counts),
        }
    }

    /// Rounds of jumps after which every piece knows all of its line.
    pub(super) fn rounds(&self) -> u32 {
        self.pieces.next_power_of_two().ilog2()
    }
}

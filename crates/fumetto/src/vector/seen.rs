//! What a cel's samples show: whose they are, and in which colour.

use rustc_hash::FxHashMap;

use super::{fills::Turn, reduce::reduced, regions::Labels};
use crate::{
    Player,
    frame::Plate,
    shapes::{
        mesh::{Geometry, MeshScene},
        puffs::PuffScene,
    },
};

/// Numbers in the id layer with this bit are of triangles. Also in `mesh.wgsl`.
const TRIANGLE_BIT: u32 = 1 << 31;

/// Colours of an object beyond which they are brought to a few: flat tones have fewer, shades that run into each
/// other have thousands.
const MANY: usize = 64;

/// Tones of an object that lie on each other. Of a model in many colours, no one lies under all others.
const MOST_STACKED: usize = 8;

/// What one label stands for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(super) struct Tone {
    pub(super) object: usize,
    /// Straight alpha, encoded.
    pub(super) rgba: [u8; 4],
}

/// A cel's tones.
#[derive(Debug)]
pub(super) struct Tones {
    /// 0 where there is nothing, else a tone's number + 1.
    pub(super) labels: Labels,
    /// In the order in which they are painted.
    pub(super) list: Vec<Tone>,
    /// When each label is painted.
    pub(super) turns: Vec<Turn>,
    /// Opacity of all that is opaque in the cel; the rest is thinner.
    pub(super) opacity: u8,
}

/// Whose puff or triangle a sample's number is.
pub(super) struct Owners<'a> {
    geometry: &'a Geometry,
    meshes: &'a MeshScene,
    puffs: &'a PuffScene,
}

impl<'a> Owners<'a> {
    pub(super) fn new(player: &'a Player) -> Self {
        Self { geometry: &player.geometry, meshes: &player.meshes, puffs: &player.puffs }
    }

    pub(super) fn is_triangle(id: u32) -> bool {
        id & TRIANGLE_BIT != 0
    }

    /// The number of a triangle's part.
    pub(super) fn part(&self, id: u32) -> Option<usize> {
        let number = id & !TRIANGLE_BIT;
        let known = self.geometry.triangles.get(number as usize).map(|triangle| triangle.part);
        let made = || self.meshes.reserved.iter().find(|reserved| reserved.triangles.contains(&number));
        known.or_else(|| made().map(|reserved| reserved.part)).map(|part| part as usize)
    }

    /// The number of the object.
    pub(super) fn object(&self, id: u32) -> Option<usize> {
        if Self::is_triangle(id) {
            return self.part(id).map(|part| self.geometry.parts[part].object as usize);
        }
        let puff = id.checked_sub(1)?;
        self.puffs.objects.iter().position(|object| object.range.contains(&puff))
    }
}

impl Tones {
    pub(super) fn of(plate: &Plate, owners: &Owners<'_>) -> Self {
        let (mut found, samples) = find(plate, owners);
        reduced(&mut found, MANY);
        let opacity = found.iter().map(|(tone, _)| tone.rgba[3]).max().unwrap_or(u8::MAX);
        let far_first = by_distance(plate, &samples, &found);
        // Dark tones lie under light ones.
        let key = |tone: &Tone| (far_first[&tone.object], luminance(tone.rgba), tone.rgba);
        let mut list: Vec<Tone> =
            found.iter().map(|(tone, _)| *tone).filter(|tone| tone.rgba[3] > 0).collect();
        list.sort_by_key(key);
        list.dedup();
        let number: FxHashMap<Tone, u16> = list.iter().copied().zip(1..).collect();
        let final_label: Vec<u16> =
            found.iter().map(|(tone, _)| number.get(tone).copied().unwrap_or_default()).collect();
        let of = samples
            .iter()
            .map(|&sample| sample.checked_sub(1).map_or(0, |found| final_label[found as usize]));
        let is_stack =
            |object: usize| list.iter().filter(|tone| tone.object == object).count() <= MOST_STACKED;
        let turn = |(number, tone): (usize, &Tone)| match (tone.rgba[3] == opacity, is_stack(tone.object)) {
            // Objects come one after the other, and so do their stacks.
            (true, true) => Turn::Stacked { stack: list.len() * far_first[&tone.object], rank: number },
            (true, false) => Turn::Stacked { stack: list.len() * far_first[&tone.object] + number, rank: 0 },
            (false, _) => Turn::Beside,
        };
        let turns = std::iter::once(Turn::Nothing).chain(list.iter().enumerate().map(turn)).collect();
        Self { labels: Labels { size: plate.size, of: of.collect() }, list, turns, opacity }
    }
}

/// All tones as they are found, with their numbers of samples; and for each sample the number of its tone + 1.
fn find(plate: &Plate, owners: &Owners<'_>) -> (Vec<(Tone, usize)>, Vec<u32>) {
    let mut found: Vec<(Tone, usize)> = Vec::new();
    let mut numbers: FxHashMap<Tone, u32> = FxHashMap::default();
    let mut whose: FxHashMap<u32, Option<usize>> = FxHashMap::default();
    // Neighbours are mostly alike.
    let (mut last, mut last_number) = ((0, [0; 4]), 0);
    let sample = |(&id, &rgba): (&u32, &[u8; 4])| {
        if (id, rgba) != last {
            let object = whose.entry(id).or_insert_with(|| owners.object(id));
            let tone = object.filter(|_| rgba[3] > 0).map(|object| Tone { object, rgba });
            last_number = tone.map_or(0, |tone| {
                *numbers.entry(tone).or_insert_with(|| {
                    found.push((tone, 0));
                    found.len() as u32
                })
            });
            last = (id, rgba);
        }
        if let Some(tone) = last_number.checked_sub(1) {
            found[tone as usize].1 += 1;
        }
        last_number
    };
    let samples = plate.ids.iter().zip(&plate.tones).map(sample).collect();
    (found, samples)
}

/// For each object its place in a row from the farthest to the nearest, by the mean of what is seen of it.
fn by_distance(plate: &Plate, samples: &[u32], found: &[(Tone, usize)]) -> FxHashMap<usize, usize> {
    let objects = 1 + found.iter().map(|(tone, _)| tone.object).max().unwrap_or_default();
    let mut sums = vec![(0.0, 0.0); objects];
    for (&sample, &depth) in samples.iter().zip(&plate.depth) {
        if let Some(tone) = sample.checked_sub(1) {
            let sum = &mut sums[found[tone as usize].0.object];
            *sum = (sum.0 + f64::from(depth), sum.1 + 1.0);
        }
    }
    let mut order: Vec<usize> = (0..objects).collect();
    order.sort_by(|&a, &b| {
        let mean = |object: usize| sums[object].0 / f64::max(sums[object].1, 1.0);
        mean(a).total_cmp(&mean(b))
    });
    order.into_iter().zip(0..).collect()
}

/// In thousandths, of encoded channels (Rec. 709's weights).
fn luminance([r, g, b, _]: [u8; 4]) -> u32 {
    213 * u32::from(r) + 715 * u32::from(g) + 72 * u32::from(b)
}

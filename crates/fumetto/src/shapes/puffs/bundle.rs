//! Bundles of balls: what a puff is made of before it becomes a picture.

use fumetto_scene::Puffs;
use glam::{Vec2, Vec3, Vec4};

/// Radius of the ball in the middle, over the puff's radius. Every variant has it, so all are solid
/// there.
const CORE_BALL: f32 = 0.62;

/// Places where erosion first breaks through.
pub(super) const HOLES: u32 = 3;

/// The balls and holes of all variants, one variant after another.
#[derive(Clone, Debug)]
pub(super) struct Bundles {
    /// Middle and radius; the puff's radius is 1 and no ball reaches beyond it.
    pub(super) balls: Vec<Vec4>,
    /// Middle, and the erosion at which the hole opens.
    pub(super) holes: Vec<Vec4>,
    /// Balls of each variant; where there are fewer, the rest have no size.
    pub(super) balls_each: u32,
}

impl Bundles {
    /// The variants of all `kinds`, one kind after another.
    pub(super) fn new(kinds: &[Puffs]) -> Self {
        let balls_each = kinds.iter().map(|kind| kind.spheres).max().unwrap_or(1);
        let mut bundles = Self { balls: Vec::new(), holes: Vec::new(), balls_each };
        for kind in kinds {
            let mut random = Random(kind.seed);
            for _ in 0..kind.variants {
                bundles.add(kind.spheres, &mut random);
            }
        }
        bundles
    }

    fn add(&mut self, spheres: u32, random: &mut Random) {
        self.balls.push(Vec4::new(0.0, 0.0, 0.0, CORE_BALL));
        self.balls.extend((1..spheres).map(|ball| rim_ball(ball - 1, spheres - 1, random)));
        self.balls.extend((spheres..self.balls_each).map(|_| Vec4::ZERO));
        for hole in 0..HOLES {
            let angle = std::f32::consts::TAU * (hole as f32 + random.next()) / HOLES as f32;
            let middle = Vec2::from_angle(angle) * (0.2 + 0.35 * random.next());
            self.holes.push(middle.extend(0.0).extend(0.25 + 0.35 * random.next()));
        }
    }
}

/// One of `count` balls that together bulge from the core on all sides, most of them toward the rim,
/// where they are seen as scallops.
///
/// Directions follow a golden spiral, so that no side is bare; sizes differ, small ones more often, as
/// a hand draws them.
fn rim_ball(index: u32, count: u32, random: &mut Random) -> Vec4 {
    const GOLDEN_ANGLE: f32 = 2.399_963_2;
    let height = 1.0 - 2.0 * (index as f32 + 0.5) / count as f32;
    // Flattened toward the rim: the cosine of latitude is what is seen of a scallop.
    let height = height * height.abs().sqrt();
    let angle = GOLDEN_ANGLE * index as f32 + 1.2 * (random.next() - 0.5);
    let across = (1.0 - height * height).sqrt();
    let direction = Vec3::new(across * angle.cos(), across * angle.sin(), height);
    let size = random.next();
    let radius = 0.2 + 0.24 * size * size;
    let reach = 1.0 - radius - 0.1 * random.next();
    (direction * reach).extend(radius)
}

/// The same numbers from the same seed everywhere (`SplitMix32`).
#[derive(Clone, Debug)]
struct Random(u32);

impl Random {
    fn next(&mut self) -> f32 {
        self.0 = self.0.wrapping_add(0x9e37_79b9);
        let mut bits = self.0;
        bits = (bits ^ (bits >> 16)).wrapping_mul(0x21f0_aaad);
        bits = (bits ^ (bits >> 15)).wrapping_mul(0x735a_2d97);
        bits ^= bits >> 15;
        (bits >> 8) as f32 / (1 << 24) as f32
    }
}

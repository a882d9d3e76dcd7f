//! Which vortex rings come out of an emitter, and how much room they take.

use super::cost::most_alive;
use crate::limits::MIN_VORTEX_ROOM;
use crate::{Burst, Emitter, Force, Rings, Smoke, Vortex};

/// Rings that a jet sheds in the time in which its air crosses its mouth: the Strouhal number of the
/// preferred mode (Crow & Champagne 1971, "Orderly structure in jet turbulence").
const STROUHAL: f32 = 0.3;
/// How far from round the rings of a jet are, as a share of their radius; without it they would stay round
/// for ever, which no ring in air does.
const JET_WOBBLE: f32 = 0.15;
/// Rings of jets alive at once in one object, about: where more would be shed, there are fewer.
const MOST_SHED: f64 = 128.0;
/// Bytes of a vortex: its state, and where it is in the middle of a step.
const VORTEX_BYTES: u64 = 48 + 16;
/// Bytes of a place in the tree: its key, its leaf, and the node above.
const PLACE_BYTES: u64 = 8 + 32 + 80;

/// The rings of one emitter.
#[derive(Clone, Debug, PartialEq)]
pub struct RingPlan {
    /// Rings a second, while `active`.
    pub rate: f32,
    /// Seconds: from, until.
    pub active: [f32; 2],
    /// Single rings, one each.
    pub bursts: Vec<Burst>,
    /// In m²/s.
    pub circulation: f32,
    /// Seconds in which a ring gets its circulation.
    pub forming_secs: f32,
    /// What buoyancy adds to the circulation, in m²/s a second for each m/s² of lift.
    pub growth_m: f32,
    /// In metres.
    pub radius: f32,
    /// How far from round, as a share of the radius.
    pub wobble: f32,
    /// Seconds until a ring is gone.
    pub life_secs: f32,
    /// Most rings alive at once.
    pub capacity: u64,
}

impl Smoke {
    /// The rings of each emitter that has any, simulated in steps of `step_secs`: none by
    /// other solvers than "vortex".
    #[must_use]
    pub fn ring_plans(&self, step_secs: f64) -> Vec<Option<RingPlan>> {
        let plan = |emitter: &Emitter| {
            let vortex = self.vortex.as_ref()?;
            let mut plan = match &emitter.rings {
                Some(rings) => on_demand(emitter, rings),
                None => self.of_jet(emitter, vortex, step_secs)?,
            };
            plan.capacity = most_alive(plan.rate, plan.active, &plan.bursts, plan.life_secs, step_secs);
            (plan.capacity > 0).then_some(plan)
        };
        self.emitters.iter().map(plan).collect()
    }

    /// Most vortex particles alive at once.
    #[must_use]
    pub fn vortices(&self, step_secs: f64) -> u64 {
        let segments = self.vortex.map_or(0, |vortex| u64::from(vortex.segments));
        let plans = self.ring_plans(step_secs).into_iter().flatten();
        plans.fold(0, |sum: u64, plan| sum.saturating_add(plan.capacity)).saturating_mul(segments)
    }

    /// What the shear at an emitter's mouth rolls up to, if it does.
    ///
    /// A jet of speed U sheds circulation at the rate U²/2 (the sheet between it and still air is of
    /// strength U and goes at U/2; Saffman 1992, "Vortex Dynamics"). What is warm but slow sheds rings as a
    /// pool fire puffs, at the speed √(lift × width).
    fn of_jet(&self, emitter: &Emitter, vortex: &Vortex, step_secs: f64) -> Option<RingPlan> {
        let mouth = emitter.mouth();
        let width = 2.0 * mouth.radius;
        let lift = if vortex.buoyancy > 0.0 { self.lift().max(0.0) } else { 0.0 };
        let speed = if vortex.strength > 0.0 { mouth.speed } else { 0.0 };
        let pace = (speed * speed + lift * width).sqrt();
        let share = MOST_SHED / self.emitters.len() as f64;
        if pace == 0.0 || width == 0.0 || share < 1.0 {
            return None;
        }
        let natural = STROUHAL * pace / width;
        let most = share / (f64::from(emitter.life[1]) + step_secs);
        let streams = emitter.count.is_some() || emitter.rate > 0.0;
        let bursts = emitter.bursts.iter().filter(|burst| burst.count > 0 && emitter.count.is_none());
        Some(RingPlan {
            rate: if streams { natural.min(most as f32) } else { 0.0 },
            active: emitter.active,
            bursts: bursts.take(share as usize).map(|burst| Burst { at: burst.at, count: 1 }).collect(),
            circulation: vortex.strength * speed * speed / (2.0 * natural),
            forming_secs: 1.0 / natural,
            growth_m: vortex.buoyancy * width / STROUHAL * mouth.axis[1],
            radius: mouth.radius,
            wobble: JET_WOBBLE,
            life_secs: emitter.life[1],
            capacity: 0,
        })
    }

    /// What lifts a particle when it is born, in m/s².
    pub(crate) fn lift(&self) -> f32 {
        let lift = |force: &Force| match *force {
            Force::Buoyancy { acceleration, .. } => acceleration,
            _ => 0.0,
        };
        self.forces.iter().map(lift).sum()
    }
}

fn on_demand(emitter: &Emitter, rings: &Rings) -> RingPlan {
    RingPlan {
        rate: rings.rate,
        active: emitter.active,
        bursts: rings.at.iter().map(|&at| Burst { at, count: 1 }).collect(),
        circulation: rings.circulation,
        forming_secs: 0.0,
        growth_m: 0.0,
        radius: rings.radius.unwrap_or_else(|| emitter.mouth().radius),
        wobble: rings.wobble,
        life_secs: emitter.life[1],
        capacity: 0,
    }
}

/// Bytes on the GPU for so many vortex particles.
#[must_use]
pub fn vortex_bytes(vortices: u64) -> u64 {
    if vortices == 0 {
        return 0;
    }
    let places = vortices.max(MIN_VORTEX_ROOM).checked_next_power_of_two().unwrap_or(u64::MAX);
    vortices.saturating_mul(VORTEX_BYTES).saturating_add(places.saturating_mul(PLACE_BYTES))
}

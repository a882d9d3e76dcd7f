//! What a scene will cost, told before anything is allocated.

use crate::limits::PARTICLE_BYTES;
use crate::{Burst, Emitter, GridPlan, Matter, Object, Scene, Surface, SurfaceRoom, Time, VolumeRoom};

/// What one object will need.
#[derive(Clone, Debug, PartialEq)]
pub struct ObjectCost {
    /// The object's name.
    pub name: String,
    /// Most particles alive at once; `None` where only a particle file tells.
    pub particles: Option<u64>,
    /// Bytes of simulation state for them.
    pub state_bytes: Option<u64>,
    /// Most vortex particles alive at once.
    pub vortices: u64,
    /// The grid that its air is in, by `solver = "grid"`.
    pub grid: Option<GridPlan>,
    /// Room for its surface; `None` where it has none, and where only a particle file tells.
    pub surface: Option<SurfaceRoom>,
    /// Likewise for its layers of detail.
    pub details: Vec<SurfaceRoom>,
    /// Room for its volume; `None` likewise.
    pub volume: Option<VolumeRoom>,
}

impl Scene {
    /// What every object will need, in the scene's order.
    #[must_use]
    pub fn requirements(&self) -> Vec<ObjectCost> {
        let step_secs = self.time.step_secs();
        let has_obstacles = self.has_obstacles();
        let cost = |object: &Object| {
            let particles = object.capacity(step_secs);
            let state_bytes = particles.map(|particles| particles.saturating_mul(PARTICLE_BYTES));
            let room = |surface| object.surface_room(surface, step_secs);
            let surface = object.shape.surface().and_then(room);
            let details = object.details.iter().filter_map(|detail| room(&detail.surface)).collect();
            let vortices = object.vortices(step_secs);
            let grid = object.grid_plan(step_secs).map(|plan| GridPlan { has_obstacles, ..plan });
            let volume = object.volume_room();
            ObjectCost {
                name: object.name.clone(),
                particles,
                state_bytes,
                vortices,
                grid,
                surface,
                details,
                volume,
            }
        };
        self.objects.iter().map(cost).collect()
    }

    /// Whether an object throws shadows.
    #[must_use]
    pub fn casts(&self, object: &Object) -> bool {
        object.visible && object.style.shadow.on && self.lights.iter().any(|light| light.shadow)
    }
}

impl Time {
    /// Seconds in one step of the simulation.
    #[must_use]
    pub fn step_secs(&self) -> f64 {
        1.0 / (f64::from(self.fps) * f64::from(self.substeps))
    }

    /// Steps of the simulation before frame 0.
    #[must_use]
    pub fn pre_roll_steps(&self) -> u64 {
        (f64::from(self.pre_roll) / self.step_secs()).round() as u64
    }

    /// Steps of the simulation before `frame`.
    #[must_use]
    pub fn steps_before(&self, frame: u32) -> u64 {
        self.pre_roll_steps() + u64::from(frame) * u64::from(self.substeps)
    }
}

impl Object {
    /// Most particles that can be alive at once, simulated in steps of `step_secs`; `None` where
    /// only a particle file tells.
    #[must_use]
    pub fn capacity(&self, step_secs: f64) -> Option<u64> {
        match &self.matter {
            Matter::Still(particles) => Some(particles.len() as u64),
            // Those that come and those that go are there together.
            Matter::Morph(morph) => {
                let counts = morph.all().map(|given| given.listed().map(|particles| particles.len() as u64));
                counts.sum()
            }
            Matter::File(_) => None,
            Matter::Mesh(_) | Matter::Imported(_) | Matter::Paint(_) => Some(0),
            Matter::Smoke(smoke) => {
                let capacities = smoke.emitters.iter().map(|emitter| emitter.capacity(step_secs));
                Some(capacities.fold(0, u64::saturating_add))
            }
        }
    }
}

impl Object {
    /// Most vortex particles that can be alive at once, simulated in steps of `step_secs`.
    #[must_use]
    pub fn vortices(&self, step_secs: f64) -> u64 {
        match &self.matter {
            Matter::Smoke(smoke) => smoke.vortices(step_secs),
            Matter::Still(_)
            | Matter::File(_)
            | Matter::Morph(_)
            | Matter::Mesh(_)
            | Matter::Imported(_)
            | Matter::Paint(_) => 0,
        }
    }

    /// The grid that its air is in, stepped by `step_secs`.
    #[must_use]
    pub fn grid_plan(&self, step_secs: f64) -> Option<GridPlan> {
        let Matter::Smoke(smoke) = &self.matter else { return None };
        smoke.grid_plan(step_secs)
    }

    fn surface_room(&self, surface: &Surface, step_secs: f64) -> Option<SurfaceRoom> {
        match &self.matter {
            Matter::Still(particles) => Some(surface.plan(particles).room),
            Matter::Smoke(smoke) => Some(surface.plan_smoke(smoke, step_secs).room),
            Matter::Morph(morph) => {
                let sets: Option<Vec<_>> = morph.all().map(crate::Given::listed).collect();
                sets.map(|sets| surface.plan_morph(&sets).room)
            }
            Matter::File(_) | Matter::Mesh(_) | Matter::Imported(_) | Matter::Paint(_) => None,
        }
    }

    fn volume_room(&self) -> Option<VolumeRoom> {
        let volume = self.shape.volume()?;
        match &self.matter {
            Matter::Still(particles) => Some(volume.room(particles)),
            Matter::Smoke(_) | Matter::Morph(_) => Some(volume.moving_room()),
            Matter::File(_) | Matter::Mesh(_) | Matter::Imported(_) | Matter::Paint(_) => None,
        }
    }
}

impl Emitter {
    /// Most particles that can be alive at once, simulated in steps of `step_secs`.
    ///
    /// A particle stays for the step in which it dies, so all last one step longer than they live.
    #[must_use]
    pub fn capacity(&self, step_secs: f64) -> u64 {
        if let Some(count) = self.count {
            return count.into();
        }
        let life_secs = self.life[0].max(self.life[1]);
        most_alive(self.rate, self.active, &self.bursts, life_secs, step_secs)
    }
}

/// Most of what is born at a `rate` while `active`, and in `bursts`, that can be alive at once.
pub(super) fn most_alive(
    rate: f32,
    active: [f32; 2],
    bursts: &[Burst],
    life_secs: f32,
    step_secs: f64,
) -> u64 {
    let stay_secs = f64::from(life_secs) + step_secs;
    let active_secs = f64::from(active[1]) - f64::from(active[0]) + step_secs;
    let emitted = f64::from(rate) * stay_secs.min(active_secs.max(0.0));
    // One more, because a fraction carried over from step to step can round up. The cast saturates.
    let flowing = if emitted > 0.0 { emitted.ceil() as u64 + 1 } else { 0 };
    flowing.saturating_add(most_of_bursts(bursts, stay_secs))
}

/// Most of bursts alive at once: of those within `stay_secs` of each other.
fn most_of_bursts(bursts: &[Burst], stay_secs: f64) -> u64 {
    let mut bursts: Vec<(f64, u64)> =
        bursts.iter().map(|burst| (f64::from(burst.at), burst.count.into())).collect();
    bursts.sort_by(|a, b| a.0.total_cmp(&b.0));
    let (mut oldest, mut alive, mut most) = (0, 0_u64, 0);
    for &(at, count) in &bursts {
        alive = alive.saturating_add(count);
        while bursts[oldest].0 + stay_secs < at {
            alive = alive.saturating_sub(bursts[oldest].1);
            oldest += 1;
        }
        most = most.max(alive);
    }
    most
}

/// Paint that particles leave on what they touch.
#[derive(Clone, Debug, PartialEq)]
pub struct Stain {
    /// Number of the smoke among the scene's objects.
    pub from: usize,
    /// A stain's radius over its particle's.
    pub size: f32,
    /// Whether particles end where they touch a model.
    pub ends: bool,
    /// Of so many particles one leaves paint.
    pub every: u32,
    /// For each of the smoke's emitters, how many stains there is room for.
    pub rooms: Vec<StainRoom>,
}

/// Room for the stains of one emitter.
#[derive(Clone, Copy, Debug, Eq, PartialEq)]
pub struct StainRoom {
    /// Particles alive at once that leave any.
    pub particles: u32,
    /// How many stains stay for each of these places, one after the other.
    pub rounds: u32,
}

impl Stain {
    /// How many stains there is room for.
    #[must_use]
    pub fn volumes(&self) -> u64 {
        self.rooms.iter().map(StainRoom::volumes).fold(0, u64::saturating_add)
    }
}

impl StainRoom {
    /// For an emitter that has `capacity` particles at most, of which one in `every` leaves paint, and of whose
    /// stains about `most` stay.
    #[must_use]
    pub fn new(capacity: u64, every: u32, most: u32) -> Self {
        let particles = capacity.div_ceil(every.max(1).into()).max(1);
        let rounds = u64::from(most).div_ceil(particles).max(1);
        let narrow = |count| u32::try_from(count).unwrap_or(u32::MAX);
        Self { particles: narrow(particles), rounds: narrow(rounds) }
    }

    /// How many stains that are.
    #[must_use]
    pub fn volumes(&self) -> u64 {
        u64::from(self.particles) * u64::from(self.rounds)
    }
}

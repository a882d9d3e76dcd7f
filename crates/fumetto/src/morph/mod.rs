//! Clouds that become others, the future work of Álvarez et al. 2007: "animated sequences of its movement and
//! metamorphosis".
//!
//! ```text
//! set of particles ─▶ pairs with those of the next set ─▶ tracks ─▶ particles of a moment
//!                     (pairing.rs)                        slots that
//!                                                         keep who is who
//! ```
//!
//! A particle moves to its partner. Where one has several partners it splits: the others grow out of it. Where
//! several have one partner they merge: the others are absorbed in it.

mod pairing;
mod tracks;

pub(crate) use tracks::Tracks;

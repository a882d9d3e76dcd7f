//! Time goes on: all that moves is simulated, step by step.

use crate::{AirTimes, Engine, Error, Player, gpu::Frame};

/// Steps that are recorded before they are handed to the queue: enough to keep a GPU busy, few enough
/// not to time out one.
const STEPS_A_SUBMIT: u64 = 8;

impl Engine {
    /// Runs the simulation to just after `steps` steps.
    pub(crate) fn advance(&self, player: &mut Player, steps: u64) {
        if steps < player.steps || !player.can_go_on {
            let mut frame = Frame::new(self.gpu(), &self.pool, "particles.reset");
            for plume in player.plumes() {
                plume.reset(&mut frame);
            }
            player.paints.reset(&mut frame);
            frame.submit();
            (player.steps, player.can_go_on) = (0, true);
        }
        let dt = player.scene().time.step_secs();
        while player.steps < steps {
            let end = steps.min(player.steps + STEPS_A_SUBMIT);
            let mut frame = Frame::new(self.gpu(), &self.pool, "particles.steps");
            for step in player.steps..end {
                for plume in player.plumes() {
                    player.place_obstacles(&mut frame, plume, step, dt);
                    self.particles.step(&mut frame, plume, step, dt);
                }
                self.spreading.step(&mut frame, &player.paints, step, dt);
            }
            frame.submit();
            player.steps = end;
        }
    }

    /// Simulates what comes before frame 0, if the way to `frame` leads through it: no more of it than takes as long as
    /// `at_most` frames. Tells whether all of it is done. [`Engine::seek`] does the rest by itself; this is for those who
    /// want to look up meanwhile.
    pub fn pre_roll(&self, player: &mut Player, frame: u32, at_most: u32) -> bool {
        let time = player.scene().time;
        let goes_on = player.can_go_on && player.steps <= time.steps_before(player.held(frame));
        let begin = if goes_on { player.steps } else { 0 };
        let end = time.pre_roll_steps();
        if begin >= end {
            return true;
        }
        let stop = end.min(begin + u64::from(at_most) * u64::from(time.substeps));
        self.advance(player, stop);
        player.shown = None;
        stop == end
    }

    /// Runs one step of all smoke whose air is simulated, and takes the time of each of its stages. Waits for the
    /// device, so in a browser it measures nothing; for measurement only.
    ///
    /// # Errors
    /// When the device is lost.
    pub fn time_air(&self, player: &mut Player) -> Result<AirTimes, Error> {
        let dt = player.scene().time.step_secs();
        let mut times = AirTimes::default();
        for plume in player.plumes() {
            let mut frame = Frame::new(self.gpu(), &self.pool, "particles.obstacles");
            player.place_obstacles(&mut frame, plume, player.steps, dt);
            frame.submit();
            let one = self.particles.timed_step((self.gpu(), &self.pool), plume, player.steps, dt)?;
            times.advect += one.advect;
            times.push += one.push;
            times.pressure += one.pressure;
            times.particles += one.particles;
        }
        player.steps += 1;
        Ok(times)
    }
}

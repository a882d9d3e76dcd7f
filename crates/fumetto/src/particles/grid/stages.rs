//! The stages of a sub-step, one by one; for measurement.

use std::time::Duration;

use web_time::Instant;

use super::Moment;
use crate::{
    gpu::{Frame, Gpu, GpuError, TexturePool},
    particles::{Particles, Plume, emission::Carrier, vortex::Span},
};

/// How long the stages of one step took.
#[derive(Clone, Copy, Debug, Default)]
pub struct AirTimes {
    /// Velocity, heat and smoke are carried.
    pub advect: Duration,
    /// Forces, heat and eddies push.
    pub push: Duration,
    /// Pressure takes divergence away.
    pub pressure: Duration,
    /// Smoke goes with the air.
    pub particles: Duration,
}

impl Particles {
    /// Advances as [`step`](Self::step) does where there is air, and waits after each stage.
    pub(crate) fn timed_step(
        &self,
        (gpu, pool): (&Gpu, &TexturePool),
        plume: &Plume,
        step: u64,
        dt: f64,
    ) -> Result<AirTimes, GpuError> {
        let mut times = AirTimes::default();
        let Some(air) = plume.air() else { return Ok(times) };
        let sub_steps = u64::from(air.plan.sub_steps);
        for number in step * sub_steps..(step + 1) * sub_steps {
            let span = Span::between(number, dt / sub_steps as f64);
            let frame = Frame::new(gpu, pool, "particles.timed");
            let moment = Moment::new(&frame, air, (plume.forces(), plume.seed()), (number, span));
            let time = |record: &dyn Fn(&mut Frame<'_>)| {
                let begin = Instant::now();
                let mut frame = Frame::new(gpu, pool, "particles.timed");
                record(&mut frame);
                frame.submit();
                gpu.wait()?;
                Ok::<_, GpuError>(begin.elapsed())
            };
            let flow = self.flow();
            times.advect += time(&|frame| flow.advect.record(frame, &moment))?;
            times.push += time(&|frame| {
                flow.pushes.record(frame, &moment);
                flow.stir.record(frame, &moment, &plume.emissions);
            })?;
            times.pressure += time(&|frame| {
                flow.hold.record(frame, &moment);
                flow.pressure.record(frame, &moment);
                flow.hold.record(frame, &moment);
            })?;
            times.particles += time(&|frame| {
                let (grid, velocity) = air.after(frame, number + 1);
                for emission in &plume.emissions {
                    self.motion().step(frame, emission, plume.forces(), Carrier::Air(&grid, velocity), span);
                }
            })?;
        }
        Ok(times)
    }
}

use super::At;
use super::paint::GRAIN_SHARE;
use crate::file::{ObjectFile, StainFile};
use crate::fit::did_you_mean;
use crate::{Matter, Object, Stain, StainRoom};

/// Puts into each paint among `objects` what particles leave; a step of the simulation takes `step_secs`.
pub(super) fn stains(at: &At<'_>, files: &[ObjectFile], objects: &mut [Object], step_secs: f64) {
    for (i, file) in files.iter().enumerate().take(objects.len()) {
        let Some(stains) = &file.stain else { continue };
        let at = at.item(i).key("stain");
        let found = stains.as_slice().iter().enumerate();
        let found: Vec<_> =
            found.filter_map(|(i, stain)| stain_of(&at.item(i), stain, objects, step_secs)).collect();
        let Some(Matter::Paint(paint)) = objects.get_mut(i).map(|object| &mut object.matter) else {
            continue;
        };
        let says_grain = file.spread.is_some_and(|spread| spread.grain_size.is_some());
        for (stain, largest_m) in found {
            if !says_grain {
                paint.spread.grain_m = paint.spread.grain_m.max(GRAIN_SHARE * largest_m);
            }
            paint.stains.push(stain);
        }
    }
}

/// With the largest radius of any.
fn stain_of(at: &At<'_>, file: &StainFile, objects: &[Object], step_secs: f64) -> Option<(Stain, f32)> {
    let named = objects.iter().enumerate().find(|(_, object)| object.name == file.from);
    let Some((from, Object { matter: Matter::Smoke(smoke), .. })) = named else {
        let is_smoke = |object: &&Object| matches!(object.matter, Matter::Smoke(_));
        let smokes: Vec<&str> = objects.iter().filter(is_smoke).map(|object| object.name.as_str()).collect();
        let message = match named {
            Some(_) => format!("{:?} is no smoke, so it has no particles that are emitted", file.from),
            None => format!("there is no object {:?}", file.from),
        };
        let help = match &*smokes {
            [] => "stains come from an object of kind = \"smoke\", and the scene has none".to_owned(),
            smokes => did_you_mean(&file.from, smokes),
        };
        at.key("from").error("no-such-smoke", message, help);
        return None;
    };
    let room = |capacity| StainRoom::new(capacity, file.every, file.most);
    let rooms = smoke.emitters.iter().map(|emitter| room(emitter.capacity(step_secs))).collect();
    let radii = smoke.emitters.iter().map(crate::Emitter::largest_radius);
    let largest_m = file.size * radii.fold(0.0, f32::max);
    Some((Stain { from, size: file.size, ends: file.ends, every: file.every, rooms }, largest_m))
}

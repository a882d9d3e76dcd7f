use super::{At, scene::at_most, values::direction};
use crate::file::LightFile;
use crate::limits::MAX_LIGHTS;
use crate::{Cluster, Light, LightKind};

pub(super) fn lights(at: &At<'_>, files: &[LightFile]) -> Vec<Light> {
    at_most(at, "light", files.len(), MAX_LIGHTS, "leave out the weakest");
    if files.is_empty() {
        let help = "add a [[light]], as in: kind = \"sun\", direction = [-0.4, -1.0, -0.3]";
        at.warning("no-light", "the scene has no light, so only the darkest tone is drawn".into(), help);
    }
    files.iter().enumerate().map(|(i, file)| light(&at.item(i), file)).collect()
}

fn light(at: &At<'_>, file: &LightFile) -> Light {
    let light = match *file {
        LightFile::Sun { direction: way, intensity, shadow, cluster } => {
            let kind = LightKind::Sun { direction: direction(&at.key("direction"), way) };
            let cluster =
                cluster.map(|suns| Cluster { lights: suns.lights, reach: suns.angle.to_radians().tan() });
            Light { kind, intensity, shadow, cluster }
        }
        LightFile::Point { position, intensity, shadow, cluster } => {
            let cluster = cluster.map(|lamps| Cluster { lights: lamps.lights, reach: lamps.radius });
            Light { kind: LightKind::Point { position }, intensity, shadow, cluster }
        }
    };
    if light.cluster.is_some() && !light.shadow {
        let message = "this light throws no shadows that `cluster` could make soft".to_owned();
        at.key("cluster").warning("no-shadow", message, "leave out `cluster`, or `shadow = false`");
    }
    light
}

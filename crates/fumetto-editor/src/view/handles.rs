use fumetto_scene::edit::{Document, Path, Value};
use glam::Vec3;

/// Keys that hold a place in the scene.
const PLACES: [&str; 3] = ["center", "position", "target"];

/// More than this many are no longer taken hold of one by one.
const MOST: usize = 2000;

/// A place in the scene file that a hand can move.
#[derive(Clone, Debug, PartialEq)]
pub(crate) struct Handle {
    /// Of the place.
    pub(crate) path: Path,
    pub(crate) at: Vec3,
    /// How far what is there reaches, where that is said too: its path and metres.
    pub(crate) radius: Option<(Path, f32)>,
}

/// The handles of what is selected: of the whole scene those of objects and lights, for the camera's target is in the
/// way of whoever looks at it.
pub(crate) fn handles_of_selected(document: &Document, selected: &Path) -> Vec<Handle> {
    if selected.steps().is_empty() {
        return ["object", "light"].iter().flat_map(|list| handles(document, &selected.key(*list))).collect();
    }
    handles(document, selected)
}

/// All handles of what lies at `path`.
pub(crate) fn handles(document: &Document, path: &Path) -> Vec<Handle> {
    let mut found = Vec::new();
    if let Some(value) = document.get(path) {
        collect(&value, path, &mut found);
    }
    found
}

fn collect(value: &Value, path: &Path, found: &mut Vec<Handle>) {
    match value {
        Value::Table(table) => {
            for (key, inner) in table {
                let here = path.key(key.as_str());
                match place(inner).filter(|_| PLACES.contains(&key.as_str())) {
                    Some(at) if found.len() < MOST => {
                        let radius =
                            table.get("radius").and_then(number).map(|radius| (path.key("radius"), radius));
                        found.push(Handle { path: here, at, radius });
                    }
                    Some(_) => {}
                    None => collect(inner, &here, found),
                }
            }
        }
        Value::Array(items) if place(value).is_none() => {
            for (index, inner) in items.iter().enumerate() {
                collect(inner, &path.index(index), found);
            }
        }
        _ => {}
    }
}

fn place(value: &Value) -> Option<Vec3> {
    match value.as_array()?.as_slice() {
        [x, y, z] => Some(Vec3::new(number(x)?, number(y)?, number(z)?)),
        _ => None,
    }
}

fn number(value: &Value) -> Option<f32> {
    match value {
        Value::Float(number) => Some(*number as f32),
        Value::Integer(number) => Some(*number as f32),
        _ => None,
    }
}

/// A place as a scene file has it: no finer than a hand can move it.
pub(super) fn written(at: Vec3) -> Value {
    Value::Array(at.to_array().map(|metres| Value::Float(rounded(metres))).into())
}

/// To a tenth of a millimetre.
pub(super) fn rounded(metres: f32) -> f64 {
    (f64::from(metres) * 1e4).round() / 1e4
}

/// A ball round all of them, as far as each reaches.
pub(crate) fn ball(handles: &[Handle]) -> Option<(Vec3, f32)> {
    /// Of what does not say how far it reaches, in metres.
    const USUAL: f32 = 0.5;
    let reach = |handle: &Handle| handle.radius.as_ref().map_or(USUAL, |(_, radius)| *radius);
    let low = handles.iter().map(|handle| handle.at - reach(handle)).reduce(Vec3::min)?;
    let high = handles.iter().map(|handle| handle.at + reach(handle)).reduce(Vec3::max)?;
    let centre = 0.5 * (low + high);
    let farthest =
        handles.iter().map(|handle| handle.at.distance(centre) + reach(handle)).fold(0.0, f32::max);
    Some((centre, farthest))
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;

    const SCENE: &str = "
        [[object]]
        name = 'cloud'
        particles = [
          { center = [0, 1, 0], radius = 0.5 },
          { center = [2.0, 1.0, 0.0], radius = 1 },
        ]
        [[object]]
        name = 'house'
        transform = { position = [4.0, 0.0, 0.0] }
    ";

    #[test]
    fn places_are_found_wherever_they_are_written() {
        let document = Document::open(SCENE).unwrap();
        let found = handles(&document, &Path::root().key("object"));
        let paths: Vec<String> = found.iter().map(|handle| handle.path.to_string()).collect();
        let wanted = [
            "object[0].particles[0].center",
            "object[0].particles[1].center",
            "object[1].transform.position",
        ];
        assert_eq!(paths, wanted);
        assert_eq!(found[1].radius, Some(("object[0].particles[1].radius".parse().unwrap(), 1.0)));
    }

    #[test]
    fn a_ball_holds_everything() {
        let document = Document::open(SCENE).unwrap();
        let (centre, radius) = ball(&handles(&document, &"object[0]".parse().unwrap())).unwrap();
        assert!(centre.distance(Vec3::new(1.25, 1.0, 0.0)) < 1e-5, "{centre}");
        assert!((radius - 1.75).abs() < 1e-5);
        assert_eq!(ball(&[]), None);
    }
}

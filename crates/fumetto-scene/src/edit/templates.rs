//! What can be added to a scene, each as a commented piece of TOML that is a sensible start.

use super::{Document, Edit, Item, Path, Step, Value};

/// Something that can be added.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Template {
    /// What it is called in menus.
    pub name: &'static str,
    /// Which array it is an element of: `object`, or `object.force` for one in an object.
    pub list: &'static str,
    /// The kinds of objects that can have it; none for what is not in an object.
    pub kinds: &'static [&'static str],
    /// Its text, which begins with a comment that tells what it is.
    pub text: &'static str,
}

macro_rules! template {
    ($name:literal, $list:literal, $kinds:expr, $file:literal) => {
        Template {
            name: $name,
            list: $list,
            kinds: &$kinds,
            text: include_str!(concat!("../../parts/", $file, ".toml")),
        }
    };
}

/// Everything that can be added.
pub const ALL: [Template; 24] = [
    template!("Smoke", "object", [], "smoke"),
    template!("Cloud", "object", [], "cloud"),
    template!("Volume", "object", [], "volume"),
    template!("Model", "object", [], "mesh"),
    template!("Obstacle", "object", [], "obstacle"),
    template!("Paint", "object", [], "paint"),
    template!("Sun", "light", [], "sun"),
    template!("Point light", "light", [], "point"),
    template!("Camera", "camera", [], "camera"),
    template!("Emitter", "object.emitter", ["smoke"], "emitter"),
    template!("Explosion", "object.emitter", ["smoke"], "explosion"),
    template!("Gravity", "object.force", ["smoke"], "gravity"),
    template!("Buoyancy", "object.force", ["smoke"], "buoyancy"),
    template!("Drag", "object.force", ["smoke"], "drag"),
    template!("Wind", "object.force", ["smoke"], "wind"),
    template!("Turbulence", "object.force", ["smoke"], "turbulence"),
    template!("Vortex", "object.force", ["smoke"], "vortex"),
    template!("Attractor", "object.force", ["smoke"], "attract"),
    template!("Particle", "object.particles", ["cloud"], "particle"),
    template!("Metamorphosis", "object.morph", ["cloud"], "morph"),
    template!("Drop", "object.drop", ["paint"], "drop"),
    template!("Brush stroke", "object.stroke", ["paint"], "stroke"),
    template!("Pour", "object.pour", ["paint"], "pour"),
    template!("Copy", "object.transform", ["mesh"], "copy"),
];

/// The grid that poured paint runs in, for objects that have none.
const CELLS: &str = "center = [0.0, 1.0, 0.0]\nsize = [6.0, 4.0, 6.0]\ncell = 0.1";

/// What can be added to the scene itself.
pub fn for_scene() -> impl Iterator<Item = &'static Template> {
    ALL.iter().filter(|template| template.kinds.is_empty())
}

/// What can be added to an object of this kind.
pub fn for_object(kind: &str) -> impl Iterator<Item = &'static Template> {
    ALL.iter().filter(move |template| template.kinds.contains(&kind))
}

impl Template {
    /// What it is: the comment above it.
    #[must_use]
    pub fn docs(&self) -> &'static str {
        self.text.lines().next().unwrap_or_default().trim_start_matches(['#', ' '])
    }

    /// Where it would be put: `object` is the path of the object that it is added to, if it is for one.
    #[must_use]
    pub fn list_in(&self, object: &Path) -> Path {
        let mut keys = self.list.split('.').map(|key| Step::Key(key.to_owned()));
        match keys.next() {
            Some(first) if self.kinds.is_empty() => Path::from(vec![first]),
            _ => keys.fold(object.clone(), |path, key| path.with(key)),
        }
    }

    /// The edit that adds it behind what there is, with what it needs besides.
    #[must_use]
    pub fn add(&self, document: &Document, object: &Path) -> Edit {
        let list = self.list_in(object);
        let (index, item) = (document.count(&list), Item::Snippet(self.text.to_owned()));
        let mut edits = vec![Edit::Insert { list: list.clone(), index, item }];
        let cells = object.key("cells");
        if let ("object.pour", 0, Ok(table)) = (self.list, document.count(&cells), CELLS.parse()) {
            edits.insert(0, Edit::Set { path: cells, value: Value::Table(table) });
        }
        // Changes of a cloud follow each other.
        let before = |index: usize| document.get(&list.index(index).key("during").index(1));
        let end = index
            .checked_sub(1)
            .and_then(before)
            .and_then(|end| end.as_float().or(end.as_integer().map(|end| end as f64)));
        if let ("object.morph", Some(end)) = (self.list, end) {
            let during = [end + 1.0, end + 3.0].map(Value::Float).to_vec();
            edits.push(Edit::Set { path: list.index(index).key("during"), value: Value::Array(during) });
        }
        Edit::All { label: format!("Add {}", self.name.to_lowercase()), edits }
    }
}

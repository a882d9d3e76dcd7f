//! Materials of OBJ files: the companion format MTL.

use std::io;

use rustc_hash::FxHashMap;

use super::lines::{Statement, linear, numbers, statements};
use crate::Image;
use crate::excerpt::excerpt;
use crate::model::companions::{Companions, Location};
use crate::model::textures::Textures;
use crate::model::{Material, Texture, Wrap};
use crate::notes::Notes;

/// The materials that the libraries define, read into a model as its groups ask for them.
pub(super) struct Library {
    defined: FxHashMap<String, Definition>,
    materials: Vec<Material>,
    known: FxHashMap<Option<String>, usize>,
    textures: Textures,
}

/// What a library says of a material.
#[derive(Clone, Default)]
struct Definition {
    colour: Option<[f32; 3]>,
    opacity: Option<f32>,
    picture: Option<Picture>,
    has_opacity_picture: bool,
}

/// What a `map_` statement names.
#[derive(Clone, Debug, PartialEq)]
struct Picture {
    name: String,
    wrap: Wrap,
    /// Whether it has options that are not understood.
    odd: bool,
}

impl Library {
    /// Reads the libraries called `names`; those that cannot be read are noted.
    pub(super) fn read(names: &[String], companions: &mut Companions<'_>, notes: &mut Notes) -> Self {
        let mut defined = FxHashMap::default();
        for name in names {
            match read_one(name, companions) {
                Ok(bytes) => define(&bytes, &mut defined),
                Err(error) => notes.say(
                    &format!("material library `{}`", excerpt(name.as_bytes())),
                    format!("its materials are missing, for it cannot be read ({error})"),
                ),
            }
        }
        let (materials, known) = (Vec::new(), FxHashMap::default());
        Self { defined, materials, known, textures: Textures::new() }
    }

    /// All materials and pictures that were asked for.
    pub(super) fn finish(self) -> (Vec<Material>, Vec<Image>) {
        (self.materials, self.textures.finish())
    }

    /// The place of the material called `name`, or of the default.
    pub(super) fn material(
        &mut self,
        name: Option<&str>,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> usize {
        let key = name.map(str::to_owned);
        if let Some(&known) = self.known.get(&key) {
            return known;
        }
        // OBJ does not say from where a face is seen, and exporters rely on both sides.
        let mut material = Material { double_sided: true, ..Material::default() };
        if let Some(name) = name {
            name.clone_into(&mut material.name);
            let element = format!("material \"{}\"", excerpt(name.as_bytes()));
            match self.defined.get(name).cloned() {
                Some(definition) => self.fill(&mut material, &definition, &element, companions, notes),
                None => notes.say(&element, "no material library defines it, so it is white"),
            }
        }
        self.materials.push(material);
        let place = self.materials.len() - 1;
        self.known.insert(key, place);
        place
    }

    fn fill(
        &mut self,
        material: &mut Material,
        definition: &Definition,
        element: &str,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) {
        let [r, g, b] = definition.colour.unwrap_or([1.0; 3]).map(linear);
        let alpha = definition.opacity.unwrap_or(1.0);
        material.colour = [r, g, b, alpha];
        if alpha < 1.0 || definition.has_opacity_picture {
            notes.say(
                element,
                "light goes through it in the file; here, it is solid where it is at least half so",
            );
            material.alpha_cutoff = Some(0.5 * alpha);
        }
        if let Some(picture) = &definition.picture {
            if picture.odd {
                notes.say(element, "ignored the options of its picture");
            }
            let location = Location::File(companions.beside(&picture.name));
            let image = self.textures.at(element, location, companions, notes);
            material.texture = image.map(|image| Texture { image, wrap: [picture.wrap; 2] });
        }
    }
}

/// The bytes of a library. Names may have spaces, and one statement may list several names.
fn read_one(names: &str, companions: &mut Companions<'_>) -> io::Result<Vec<u8>> {
    let whole = companions.read(&companions.beside(names));
    if whole.is_ok() || !names.contains(char::is_whitespace) {
        return whole;
    }
    let mut all = Vec::new();
    for name in names.split_whitespace() {
        all.extend(companions.read(&companions.beside(name))?);
        all.push(b'\n');
    }
    Ok(all)
}

/// Adds the materials that a library's text defines.
fn define(bytes: &[u8], defined: &mut FxHashMap<String, Definition>) {
    let mut name = None;
    for statement in statements(bytes) {
        if statement.keyword == "newmtl" {
            defined.insert(statement.rest.to_string(), Definition::default());
            name = Some(statement.rest.to_string());
        } else if let Some(definition) = name.as_ref().and_then(|name| defined.get_mut(name)) {
            definition.take(&statement);
        }
    }
}

impl Definition {
    fn take(&mut self, statement: &Statement<'_>) {
        let values = || numbers(&statement.rest);
        let share = |value: &f32| if value.is_finite() { value.clamp(0.0, 1.0) } else { 1.0 };
        match &*statement.keyword {
            "Kd" => {
                self.colour = match values()[..] {
                    [r, g, b, ..] => Some([r, g, b].map(|channel| share(&channel))),
                    [grey, ..] => Some([share(&grey); 3]),
                    [] => self.colour,
                };
            }
            "d" => self.opacity = values().first().map(share).or(self.opacity),
            "Tr" => self.opacity = values().first().map(|value| 1.0 - share(value)).or(self.opacity),
            "map_Kd" | "map_kd" => self.picture = picture(&statement.rest),
            "map_d" => self.has_opacity_picture = true,
            _ => {}
        }
    }
}

/// What follows `map_Kd`: options that start with a dash and have up to three numbers or a word, then
/// a name that may have spaces.
fn picture(words: &str) -> Option<Picture> {
    let (mut rest, mut wrap, mut odd) = (words, Wrap::Repeat, false);
    while rest.starts_with('-') {
        let (option, after) = word(rest);
        rest = after;
        match option {
            "-clamp" => {
                let (value, after) = word(rest);
                wrap = if value == "on" { Wrap::Clamp } else { Wrap::Repeat };
                rest = after;
            }
            "-blendu" | "-blendv" | "-cc" | "-imfchan" | "-type" => rest = word(rest).1,
            _ => {
                odd = true;
                for _ in 0..3 {
                    let (value, after) = word(rest);
                    if value.parse::<f32>().is_err() || after.is_empty() {
                        break;
                    }
                    rest = after;
                }
            }
        }
    }
    (!rest.is_empty()).then(|| Picture { name: rest.to_owned(), wrap, odd })
}

/// The first word, and what follows it.
fn word(text: &str) -> (&str, &str) {
    let (word, rest) = text.split_once(char::is_whitespace).unwrap_or((text, ""));
    (word, rest.trim_start())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn options_stand_before_a_picture_s_name() {
        let read = |words| picture(words).map(|picture| (picture.name, picture.wrap, picture.odd));
        let plain = |name: &str, wrap, odd| Some((name.to_owned(), wrap, odd));
        assert_eq!(read("wall 1.png"), plain("wall 1.png", Wrap::Repeat, false));
        assert_eq!(read("-clamp on -blendu off a.png"), plain("a.png", Wrap::Clamp, false));
        assert_eq!(read("-s 1 2 3 -o 0.5 my tex.png"), plain("my tex.png", Wrap::Repeat, true));
        assert_eq!(read("-bm 1.0 3"), plain("3", Wrap::Repeat, true));
        assert_eq!(read("-clamp"), None);
        assert_eq!(read(""), None);
    }
}

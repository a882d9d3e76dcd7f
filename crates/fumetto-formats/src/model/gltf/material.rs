//! Colours and pictures (glTF 2.0, section 3.9).

use glam::{Affine2, Vec2};
use gltf_json::material::AlphaMode;
use gltf_json::texture::{Info, Sampler, WrappingMode};
use gltf_json::validation::Checked;
use rustc_hash::FxHashMap;

use super::document::{Document, label};
use crate::excerpt::excerpt;
use crate::model::companions::Companions;
use crate::model::textures::Textures;
use crate::model::{Material, Texture, Wrap};
use crate::notes::Notes;
use crate::{FormatError, Image};

/// Which texture coordinates a material takes, and what becomes of them.
#[derive(Clone, Copy)]
pub(super) struct Uvs {
    /// The number of the attribute.
    pub(super) set: u32,
    /// `KHR_texture_transform`, which is put into the coordinates once and for all.
    pub(super) transform: Affine2,
    /// Whether something is missing without them.
    pub(super) needed: bool,
}

/// What is on a material.
struct Look {
    texture: Option<Texture>,
    uvs: Uvs,
}

/// Reads materials as primitives ask for them, each once.
pub(super) struct Materials<'a> {
    document: &'a Document<'a>,
    materials: Vec<Material>,
    uvs: Vec<Uvs>,
    known: FxHashMap<Option<usize>, usize>,
    textures: Textures,
    /// Images of the document that were read.
    images: FxHashMap<usize, Option<usize>>,
    /// How many bytes of buffers may still be taken for pictures.
    bytes_left: u64,
}

impl<'a> Materials<'a> {
    pub(super) fn new(document: &'a Document<'a>) -> Self {
        Self {
            document,
            materials: Vec::new(),
            uvs: Vec::new(),
            known: FxHashMap::default(),
            textures: Textures::new(),
            images: FxHashMap::default(),
            bytes_left: document.buffer_bytes(),
        }
    }

    /// All materials and pictures that were asked for.
    pub(super) fn finish(self) -> (Vec<Material>, Vec<Image>) {
        (self.materials, self.textures.finish())
    }

    /// The texture coordinates that the material at `place` takes.
    pub(super) fn uvs(&self, place: usize) -> Uvs {
        self.uvs[place]
    }

    /// The place of the material that the document has at `index`, or of the default.
    pub(super) fn at(
        &mut self,
        element: &str,
        index: Option<usize>,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> Result<usize, FormatError> {
        if let Some(&known) = self.known.get(&index) {
            return Ok(known);
        }
        let (material, uvs) = match index {
            Some(index) => self.read(element, index, companions, notes)?,
            None => (Material::default(), Uvs::plain()),
        };
        self.materials.push(material);
        self.uvs.push(uvs);
        let place = self.materials.len() - 1;
        self.known.insert(index, place);
        Ok(place)
    }

    fn read(
        &mut self,
        element: &str,
        index: usize,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> Result<(Material, Uvs), FormatError> {
        let document = self.document;
        let json =
            document.root.materials.get(index).ok_or_else(|| document.absent(element, "material", index))?;
        let element = label("material", index, json.name.as_deref());
        let base = &json.pbr_metallic_roughness;
        let mut colour = base.base_color_factor.0;
        if colour.iter().any(|channel| !channel.is_finite()) {
            return Err(document.wrong(&element, "its colour is not finite; export the model again"));
        }
        let cutoff = json.alpha_cutoff.map_or(0.5, |cutoff| cutoff.0);
        let alpha_cutoff = match json.alpha_mode {
            Checked::Valid(AlphaMode::Mask) => Some(cutoff),
            Checked::Valid(AlphaMode::Blend) => {
                notes.say(
                    &element,
                    "light goes through it in the file; here, it is solid where it is at least half so",
                );
                // Against the texture alone: glass as a whole shall not vanish.
                Some(0.5 * colour[3])
            }
            _ => {
                colour[3] = 1.0;
                None
            }
        };
        let look = match &base.base_color_texture {
            Some(info) => self.look(&element, info, companions, notes)?,
            None => Look { texture: None, uvs: Uvs::plain() },
        };
        let name = json.name.clone().unwrap_or_default();
        let double_sided = json.double_sided;
        Ok((Material { name, colour, texture: look.texture, double_sided, alpha_cutoff }, look.uvs))
    }

    fn look(
        &mut self,
        element: &str,
        info: &Info,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> Result<Look, FormatError> {
        let root = &self.document.root;
        let index = info.index.value();
        let json = root.textures.get(index).ok_or_else(|| self.document.absent(element, "texture", index))?;
        let sampler = json.sampler.and_then(|sampler| root.samplers.get(sampler.value()));
        let image = self.image(element, json.source.value(), companions, notes)?;
        let texture = image.map(|image| Texture { image, wrap: wrap(sampler) });
        let mut uvs = Uvs { set: info.tex_coord, needed: texture.is_some(), ..Uvs::plain() };
        if let Some(json) =
            info.extensions.as_ref().and_then(|extensions| extensions.texture_transform.as_ref())
        {
            uvs.set = json.tex_coord.unwrap_or(uvs.set);
            // The turn is counter-clockwise as seen, while the second coordinate runs downwards.
            let (scale, offset) = (Vec2::from(json.scale.0), Vec2::from(json.offset.0));
            uvs.transform = Affine2::from_scale_angle_translation(scale, -json.rotation.0, offset);
        }
        Ok(Look { texture, uvs })
    }

    /// The place of the picture that the document has at `index`, unless it cannot be read.
    fn image(
        &mut self,
        element: &str,
        index: usize,
        companions: &mut Companions<'_>,
        notes: &mut Notes,
    ) -> Result<Option<usize>, FormatError> {
        if let Some(&known) = self.images.get(&index) {
            return Ok(known);
        }
        let Some(json) = self.document.root.images.get(index) else {
            notes.say(
                element,
                "goes without its picture, which is of a kind that is not known here; export it as PNG",
            );
            return Ok(None);
        };
        let name = label("image", index, json.name.as_deref());
        let image = match (json.buffer_view, &json.uri) {
            (Some(view), _) => {
                let (bytes, _) = self.document.view(&name, view.value())?;
                self.bytes_left = self.bytes_left.checked_sub(bytes.len() as u64).ok_or_else(|| {
                    self.document.wrong(
                        &name,
                        "images take more bytes than there are, so they overlap; export the model again",
                    )
                })?;
                self.textures.within(element, &name, bytes, notes)
            }
            (None, Some(uri)) => match companions.locate(uri) {
                Ok(location) => self.textures.at(element, location, companions, notes),
                Err(problem) => {
                    let uri = excerpt(uri.as_bytes());
                    notes.say(element, format!("goes without its picture, for `{uri}` {problem}"));
                    None
                }
            },
            (None, None) => {
                notes.say(element, format!("goes without its picture, for {name} is empty"));
                None
            }
        };
        self.images.insert(index, image);
        Ok(image)
    }
}

impl Uvs {
    /// The first ones, as they are.
    fn plain() -> Self {
        Self { set: 0, transform: Affine2::IDENTITY, needed: false }
    }
}

fn wrap(sampler: Option<&Sampler>) -> [Wrap; 2] {
    let wrap = |mode: Checked<WrappingMode>| match mode {
        Checked::Valid(WrappingMode::ClampToEdge) => Wrap::Clamp,
        Checked::Valid(WrappingMode::MirroredRepeat) => Wrap::Mirror,
        _ => Wrap::Repeat,
    };
    sampler.map_or_else(Default::default, |sampler| [wrap(sampler.wrap_s), wrap(sampler.wrap_t)])
}

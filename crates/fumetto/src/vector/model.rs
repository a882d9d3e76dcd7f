//! Lines alone, of models and surfaces alone: what of a drawing needs no picture.

use fumetto_formats::Shape;
use fumetto_scene::Object;

use super::{
    document::line_shape,
    lines::{FirstLight, Sight, Solids, Subject},
};
use crate::{Engine, Error, Player, Shot};

/// The models and surfaces of a moment, ready for their lines to be drawn from any camera, on the processor alone.
#[derive(Debug)]
pub struct LineModel {
    solids: Solids,
    objects: Vec<Object>,
    light: FirstLight,
}

impl Engine {
    /// Takes the models and surfaces of the moment that `player` is at off the device. Puffs and volumes are not in
    /// it: they hide nothing, and have no lines.
    ///
    /// # Errors
    /// When the device is lost.
    pub async fn line_model_async(&self, player: &Player) -> Result<LineModel, Error> {
        let scene = player.scene();
        self.look(player, &Shot::of(scene).camera);
        let visible = |&object: &usize| scene.objects[object].visible;
        let members: Vec<usize> = (0..scene.objects.len()).filter(visible).collect();
        Ok(LineModel {
            solids: Solids::read(self.gpu(), player, &members).await?,
            objects: scene.objects.clone(),
            light: FirstLight::of(scene),
        })
    }
}

impl LineModel {
    /// Lines that are in sight, a shape for each kind of each object: outlines, or for plotters the middles of lines.
    #[must_use]
    pub fn shapes(&self, shot: &Shot, plotter: bool) -> Vec<Shape> {
        let objects: Vec<&Object> = self.objects.iter().collect();
        let subject = Subject {
            solids: &self.solids,
            sight: &Sight::new(&shot.camera, shot.size),
            objects: &objects,
            light: self.light,
            covered: &|_| false,
        };
        let strokes = subject.strokes(plotter);
        strokes.into_iter().map(|stroke| line_shape(objects[stroke.object], stroke, 1.0)).collect()
    }
}

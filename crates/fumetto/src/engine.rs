use fumetto_formats::Image;
use fumetto_scene::{Camera, Scene};

use crate::{
    Assets, Error, Layer, Player,
    frame::Painter,
    gpu::{Frame, Gpu, Region, TexturePool, read_texture_async},
    paint::Spreading,
    particles::Particles,
    player::PlayedMatter,
    proof::atlas_pictures,
    shapes::{
        mesh::Place,
        puffs::Present,
        surface::{Sight, Surface, SurfaceSize},
        volume::Volume,
    },
    tiles::Part,
};

/// What the picture is drawn into: sRGB bytes, straight alpha.
pub const PICTURE_FORMAT: wgpu::TextureFormat = wgpu::TextureFormat::Rgba8Unorm;

/// What lives long: the device, the pipelines, and the textures that frames share.
pub struct Engine {
    gpu: Gpu,
    pub(crate) pool: TexturePool,
    pub(crate) particles: Particles,
    present: Present,
    place: Place,
    surface: Surface,
    volume: Volume,
    pub(crate) spreading: Spreading,
    pub(crate) painter: Painter,
}

/// Which picture to take of a scene.
#[derive(Clone, Debug, PartialEq)]
pub struct Shot {
    /// From where.
    pub camera: Camera,
    /// Width and height in pixels.
    pub size: [u32; 2],
    /// Samples along each side of a pixel, 1 (hard edges) to 4.
    pub antialias: u32,
}

impl Shot {
    /// The scene's own: its first camera, size and quality.
    ///
    /// # Panics
    /// When the scene has no camera, which a checked scene always has.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        Self { camera: scene.cameras[0].clone(), size: scene.output.size, antialias: scene.output.antialias }
    }

    /// Width and height in samples.
    pub(crate) fn samples(&self) -> [u32; 2] {
        self.size.map(|pixels| pixels * self.antialias)
    }
}

impl Engine {
    /// Draws on `gpu`. Pipelines are made when a scene first needs them.
    #[must_use]
    pub fn new(gpu: Gpu) -> Self {
        Self {
            particles: Particles::new(&gpu),
            present: Present::new(&gpu),
            place: Place::new(&gpu),
            surface: Surface::new(&gpu),
            volume: Volume::new(&gpu),
            spreading: Spreading::new(&gpu),
            painter: Painter::new(&gpu),
            pool: TexturePool::default(),
            gpu,
        }
    }

    /// The device.
    #[must_use]
    pub fn gpu(&self) -> &Gpu {
        &self.gpu
    }

    /// Takes a scene to its beginning; the files it names come from `assets`.
    ///
    /// # Errors
    /// When a file is missing or broken, or the scene does not fit the device.
    pub fn play(&self, scene: Scene, assets: Box<dyn Assets>) -> Result<Player, Error> {
        let player = Player::new(&self.gpu, scene, assets)?;
        player.upload_still(&self.gpu);
        Ok(player)
    }

    /// Plays a changed scene in place of the one that `player` plays. What moves goes on where it is, unless the
    /// change is to what moves; ask for a frame next. Where this fails, `player` is as it was.
    ///
    /// # Errors
    /// As [`Engine::play`].
    pub fn renew(&self, player: &mut Player, scene: Scene, assets: Box<dyn Assets>) -> Result<(), Error> {
        let mut renewed = self.play(scene, assets)?;
        renewed.take_over(player);
        *player = renewed;
        Ok(())
    }

    /// Draws the moment that `player` is at as `scene` shows it: in another style, say. `player` goes on as if nothing
    /// had been.
    ///
    /// # Errors
    /// As [`Engine::play`], [`Engine::seek`] and [`Engine::draw`].
    pub fn draw_as(
        &mut self,
        player: &mut Player,
        scene: Scene,
        assets: Box<dyn Assets>,
        shot: &Shot,
        target: &wgpu::TextureView,
    ) -> Result<(), Error> {
        let mut other = self.play(scene, assets)?;
        other.take_over(player);
        let shown = player.shown.unwrap_or_default();
        let drawn = self.seek(&mut other, shown).and_then(|()| self.draw(&other, shot, target));
        player.take_over(&mut other);
        drawn
    }

    /// Takes the scene to `frame`, forward from where it is or from the start. On twos, every other
    /// frame looks like the one before it.
    ///
    /// # Errors
    /// When a file of a sequence is missing or broken.
    pub fn seek(&self, player: &mut Player, frame: u32) -> Result<(), Error> {
        let frame = player.held(frame);
        if player.shown == Some(frame) {
            return Ok(());
        }
        player.read_sequences(&self.gpu, frame)?;
        self.advance(player, player.scene().time.steps_before(frame));
        self.present(player, frame);
        Ok(())
    }

    /// Shows `frame`, at which all that is simulated is already.
    pub(crate) fn present(&self, player: &mut Player, frame: u32) {
        player.animate(&self.gpu, frame);
        self.show(player, frame);
        player.shown = Some(frame);
    }

    /// Turns the particles into puffs, puffs into volumes and into those surfaces that look alike from everywhere,
    /// and brings models to their places.
    fn show(&self, player: &mut Player, shown: u32) {
        let secs = player.secs(shown);
        let mut frame = Frame::new(&self.gpu, &self.pool, "shapes.present");
        self.place.record(&mut frame, &player.meshes);
        for object in &player.objects {
            if let PlayedMatter::Smoke(plume) = &object.matter {
                let mut placement = object.placement;
                for emission in &plume.emissions {
                    self.present.record(&mut frame, emission, placement, &player.puffs.puffs);
                    placement.first += emission.capacity();
                    placement.seed = placement.seed.wrapping_add(1);
                }
            }
        }
        player.surfaces.move_on();
        player.surfaces.record(&mut frame, &self.surface, &player.puffs.puffs, None, (secs, &player.meshes));
        player.volumes.record(&mut frame, &self.volume, &player.puffs.puffs, secs);
        self.spreading.measure(&mut frame, &player.paints);
        frame.submit();
    }

    /// Makes the surfaces whose cells are lengths on the picture, unless they are as they are seen by `camera`.
    pub(crate) fn look(&self, player: &Player, camera: &Camera) {
        let (Some(shown), sight) = (player.shown, Sight::of(camera)) else { return };
        if player.surfaces.waits(sight) {
            let moment = (player.secs(shown), &player.meshes);
            let mut frame = Frame::new(&self.gpu, &self.pool, "shapes.look");
            let puffs = &player.puffs.puffs;
            player.surfaces.record(&mut frame, &self.surface, puffs, Some(sight), moment);
            frame.submit();
        }
    }

    /// Draws the moment that `player` is at into `target`, of [`PICTURE_FORMAT`] and the shot's size.
    ///
    /// Nothing is read back and nothing waits.
    ///
    /// # Errors
    /// When the picture is too large for the device.
    pub fn draw(&mut self, player: &Player, shot: &Shot, target: &wgpu::TextureView) -> Result<(), Error> {
        self.check_size(shot)?;
        self.look(player, &shot.camera);
        let part = Part { region: Region::whole(shot.samples()), survey: None };
        self.painter.paint(&self.gpu, &self.pool, player, shot, part, target);
        self.pool.end_frame();
        Ok(())
    }

    /// One of the layers that the moment's picture is made of, all objects together, one sample a pixel.
    ///
    /// # Errors
    /// When the picture is too large for the device, or the device is lost.
    pub async fn layer_async(&mut self, player: &Player, shot: &Shot, layer: Layer) -> Result<Image, Error> {
        let shot = Shot { antialias: 1, ..shot.clone() };
        self.check_size(&shot)?;
        self.look(player, &shot.camera);
        let proof = self.painter.proof(&self.gpu, &self.pool, player, &shot);
        Ok(proof.picture(&self.gpu, layer).await?)
    }

    /// The puff atlas as pictures, each with its name: `normal`, `depth` and `coverage`.
    ///
    /// # Errors
    /// When the device is lost.
    pub async fn atlas_async(&self, player: &Player) -> Result<Vec<(&'static str, Image)>, Error> {
        Ok(atlas_pictures(&self.gpu, &player.puffs.atlas).await?)
    }

    /// How large the surfaces are that the moment shows to the scene's first camera.
    ///
    /// # Errors
    /// When the device is lost.
    pub async fn surfaces_async(&self, player: &Player) -> Result<Vec<SurfaceSize>, Error> {
        self.look(player, &Shot::of(player.scene()).camera);
        Ok(player.surfaces.sizes(&self.gpu, &player.meshes).await?)
    }

    fn check_size(&self, shot: &Shot) -> Result<(), Error> {
        let needed = u64::from(shot.size[0].max(shot.size[1])) * u64::from(shot.antialias);
        let allowed = self.gpu.device.limits().max_texture_dimension_2d;
        if needed > u64::from(allowed) {
            let [width, height] = shot.size;
            return Err(Error::TooLarge { width, height, antialias: shot.antialias, needed, allowed });
        }
        Ok(())
    }

    /// Draws the moment that `player` is at and reads it back. It is drawn at once, and what comes after does not
    /// change it.
    ///
    /// # Errors
    /// When the picture is too large for the device, or the device is lost.
    pub fn picture_async(
        &mut self,
        player: &Player,
        shot: &Shot,
    ) -> impl Future<Output = Result<Image, Error>> + use<> {
        let [width, height] = shot.size;
        let reading = self.check_size(shot).and_then(|()| {
            let texture = picture_texture(&self.gpu, shot.size);
            self.draw(player, shot, &texture.create_view(&wgpu::TextureViewDescriptor::default()))?;
            Ok(read_texture_async(&self.gpu, &texture))
        });
        async move { Ok(Image { width, height, pixels: reading?.await? }) }
    }
}

/// A texture that pictures are drawn into and read back from.
pub(crate) fn picture_texture(gpu: &Gpu, [width, height]: [u32; 2]) -> wgpu::Texture {
    gpu.device.create_texture(&wgpu::TextureDescriptor {
        label: Some("engine.picture"),
        size: wgpu::Extent3d { width, height, depth_or_array_layers: 1 },
        mip_level_count: 1,
        sample_count: 1,
        dimension: wgpu::TextureDimension::D2,
        format: PICTURE_FORMAT,
        usage: wgpu::TextureUsages::RENDER_ATTACHMENT
            | wgpu::TextureUsages::TEXTURE_BINDING
            | wgpu::TextureUsages::COPY_SRC,
        view_formats: &[],
    })
}

#[cfg(test)]
#[expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]
mod tests {
    use super::*;
    use crate::gpu::AT_ONCE;

    #[test]
    fn every_pipeline_can_be_made() {
        AT_ONCE.set(true);
        let engine = Engine::new(pollster::block_on(Gpu::headless()).unwrap());
        engine.gpu.wait().unwrap();
        AT_ONCE.set(false);
    }
}

use egui::{PointerButton, Response, Ui};
use fumetto_scene::Camera;

use super::orbit::Orbit;

/// Degrees that a drag over the whole height of the picture turns.
const TURN_DEG: f32 = 180.0;

/// How much nearer a notch of the wheel, 50 points, goes.
const DOLLY_A_POINT: f32 = 0.002;

/// Which drags move the camera: as in the program that the hand already knows.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, serde::Serialize, serde::Deserialize)]
pub(crate) enum Navigation {
    /// One button is enough: drag to turn, with the right button or Shift to pan, wheel or pinch to go nearer.
    #[default]
    Simple,
    /// Middle button to turn, with Shift to pan, with Ctrl to go nearer.
    Blender,
    /// Alt with the left button to turn, the middle to pan, the right to go nearer.
    Maya,
}

impl Navigation {
    pub(crate) const ALL: [Self; 3] = [Self::Simple, Self::Blender, Self::Maya];

    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Simple => "Simple",
            Self::Blender => "Like Blender",
            Self::Maya => "Like Maya",
        }
    }

    /// Which motion a drag with `button` is.
    fn motion(self, button: PointerButton, keys: egui::Modifiers) -> Option<Motion> {
        use PointerButton::{Middle, Primary, Secondary};
        match (self, button) {
            (Self::Simple, Primary) if keys.shift => Some(Motion::Pan),
            (Self::Simple, Primary) => Some(Motion::Turn),
            (Self::Simple, Secondary | Middle) => Some(Motion::Pan),
            (Self::Blender, Middle) if keys.shift => Some(Motion::Pan),
            (Self::Blender, Middle) if keys.command => Some(Motion::Dolly),
            (Self::Blender, Middle) => Some(Motion::Turn),
            (Self::Maya, Primary) if keys.alt => Some(Motion::Turn),
            (Self::Maya, Middle) if keys.alt => Some(Motion::Pan),
            (Self::Maya, Secondary) if keys.alt => Some(Motion::Dolly),
            _ => None,
        }
    }

    /// Moves `camera` as the pointer over `picture` asks; whether it did.
    pub(crate) fn steer(self, ui: &Ui, picture: &Response, camera: &mut Camera) -> bool {
        let mut moved = false;
        let height = picture.rect.height().max(1.0);
        let keys = ui.input(|input| input.modifiers);
        for button in [PointerButton::Primary, PointerButton::Middle, PointerButton::Secondary] {
            if !picture.dragged_by(button) {
                continue;
            }
            let way = picture.drag_delta() / height;
            moved |= way != egui::Vec2::ZERO;
            let mut orbit = Orbit(camera);
            match self.motion(button, keys) {
                Some(Motion::Turn) => orbit.turn(TURN_DEG * way.x, TURN_DEG * way.y),
                Some(Motion::Pan) => orbit.pan(way.x, way.y),
                Some(Motion::Dolly) => orbit.dolly((2.0 * (way.y - way.x)).exp()),
                None => {}
            }
        }
        if picture.hovered() {
            let (wheel, pinch) = ui.input(|input| (input.smooth_scroll_delta().y, input.zoom_delta()));
            let share = (-DOLLY_A_POINT * wheel).exp() / pinch;
            if (share - 1.0).abs() > 1e-5 {
                Orbit(camera).dolly(share);
                moved = true;
            }
        }
        moved
    }
}

#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Motion {
    Turn,
    Pan,
    Dolly,
}

#[cfg(test)]
mod tests {
    use egui::Modifiers;

    use super::*;

    #[test]
    fn each_way_has_every_motion() {
        for navigation in Navigation::ALL {
            let mut motions = Vec::new();
            for button in [PointerButton::Primary, PointerButton::Middle, PointerButton::Secondary] {
                for keys in [Modifiers::NONE, Modifiers::SHIFT, Modifiers::COMMAND, Modifiers::ALT] {
                    motions.extend(navigation.motion(button, keys));
                }
            }
            assert!(motions.contains(&Motion::Turn) && motions.contains(&Motion::Pan), "{navigation:?}");
        }
    }
}

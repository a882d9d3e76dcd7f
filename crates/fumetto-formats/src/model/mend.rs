//! Triangles as a file has them, made fit to be drawn.

use glam::{DVec3, Vec2, Vec3, Vec4};

use super::{DEFAULT_SMOOTH_DEGREES, ModelOptions, Part, normals};
use crate::notes::Notes;

/// A triangle is without area when it is thinner than this share of its longest side: about what single
/// precision leaves of three points on a line. No picture shows it.
const LEAST_THICKNESS: f64 = 1e-7;

/// Most characters of a part's name: an endless one that thousands of parts share would fill the memory.
const MAX_NAME_CHARS: usize = 200;

/// A part that is not yet known to be in order; its triangles name vertices that exist.
#[derive(Default)]
pub(super) struct Surface {
    pub(super) positions: Vec<Vec3>,
    /// As many as positions, or none.
    pub(super) normals: Vec<Vec3>,
    /// As many as positions, or none.
    pub(super) uvs: Vec<Vec2>,
    /// As many as positions, or none.
    pub(super) colours: Vec<Vec4>,
    pub(super) triangles: Vec<[u32; 3]>,
}

/// What a part is called.
#[derive(Clone, Copy)]
pub(super) struct Label<'a> {
    /// Where it stands in the file, for notes.
    pub(super) element: &'a str,
    pub(super) name: &'a str,
    pub(super) material: usize,
}

impl Surface {
    /// Keeps the vertices at these places, in their order.
    pub(super) fn gather(&mut self, kept: &[u32]) {
        fn pick<T: Copy>(values: &mut Vec<T>, kept: &[u32]) {
            if !values.is_empty() {
                *values = kept.iter().map(|&vertex| values[vertex as usize]).collect();
            }
        }
        pick(&mut self.positions, kept);
        pick(&mut self.normals, kept);
        pick(&mut self.uvs, kept);
        pick(&mut self.colours, kept);
    }

    /// The part that it makes, unless it has no triangle that can be drawn.
    pub(super) fn finish(
        mut self,
        label: Label<'_>,
        options: ModelOptions,
        notes: &mut Notes,
    ) -> Option<Part> {
        self.drop_unfit(label.element, notes);
        if self.triangles.is_empty() {
            notes.say(label.element, "it has no triangles, so it was left out");
            return None;
        }
        self.mend_values(label.element, notes);
        self.give_normals(label.element, options, notes);
        Some(Part {
            name: label.name.chars().take(MAX_NAME_CHARS).collect(),
            material: label.material,
            positions: self.positions.iter().map(Vec3::to_array).collect(),
            normals: self.normals.iter().map(Vec3::to_array).collect(),
            uvs: self.uvs.iter().map(Vec2::to_array).collect(),
            colours: self.colours.iter().map(Vec4::to_array).collect(),
            triangles: self.triangles,
        })
    }

    /// Drops triangles that are nowhere or have no area, and vertices that no triangle needs then.
    fn drop_unfit(&mut self, element: &str, notes: &mut Notes) {
        let all = self.triangles.len();
        let positions = &self.positions;
        let corners = |triangle: &[u32; 3]| triangle.map(|vertex| positions[vertex as usize]);
        self.triangles.retain(|triangle| corners(triangle).iter().all(|corner| corner.is_finite()));
        let somewhere = self.triangles.len();
        self.triangles.retain(|triangle| has_area(corners(triangle)));

        let (nowhere, flat) = (all - somewhere, somewhere - self.triangles.len());
        if nowhere > 0 {
            notes.say(
                element,
                format!("left out {} with a corner that is not a finite place", triangles(nowhere)),
            );
        }
        if flat > 0 {
            notes.say(element, format!("left out {} without area", triangles(flat)));
        }
        if nowhere + flat > 0 {
            let kept = used(&mut self.triangles, self.positions.len());
            self.gather(&kept);
        }
    }

    /// Replaces numbers that are none, which would spread over whole triangles.
    fn mend_values(&mut self, element: &str, notes: &mut Notes) {
        let mut mended = 0;
        for uv in self.uvs.iter_mut().filter(|uv| !uv.is_finite()) {
            *uv = Vec2::ZERO;
            mended += 1;
        }
        for colour in self.colours.iter_mut().filter(|colour| !colour.is_finite()) {
            *colour = Vec4::ONE;
            mended += 1;
        }
        if mended > 0 {
            notes.say(
                element,
                format!("replaced {mended} texture coordinates and colours that are not finite"),
            );
        }
    }

    /// Sees to it that there is a normal of length 1 at every vertex.
    fn give_normals(&mut self, element: &str, options: ModelOptions, notes: &mut Notes) {
        let asked = options.smooth_degrees.filter(|degrees| !degrees.is_nan());
        if asked.is_some() || self.normals.is_empty() {
            let degrees = asked.unwrap_or(DEFAULT_SMOOTH_DEGREES).clamp(0.0, 180.0);
            return normals::compute(self, degrees);
        }
        // In double precision, for the square of a short or a long one leaves the single one's range.
        let unit = |normal: &Vec3| normal.as_dvec3().try_normalize().map(DVec3::as_vec3);
        let known: Vec<Option<Vec3>> = self.normals.iter().map(unit).collect();
        let missing = known.iter().filter(|normal| normal.is_none()).count();
        if missing == 0 {
            self.normals = known.into_iter().flatten().collect();
            return;
        }
        notes.say(element, format!("computed {missing} normals that have no direction"));
        let means = normals::mean(self);
        self.normals = known.into_iter().zip(means).map(|(normal, mean)| normal.unwrap_or(mean)).collect();
    }
}

/// Numbers the vertices of `triangles` anew without gaps, and tells which of the `count` they were.
///
/// Takes time and memory for the triangles, however many more vertices there are.
pub(super) fn used(triangles: &mut [[u32; 3]], count: usize) -> Vec<u32> {
    let corners = 3 * triangles.len();
    if count <= 4 * corners {
        let mut numbers = vec![0; count];
        triangles.as_flattened().iter().for_each(|&vertex| numbers[vertex as usize] = 1);
        let kept: Vec<u32> = (0..count as u32).filter(|&vertex| numbers[vertex as usize] == 1).collect();
        for (number, &vertex) in kept.iter().enumerate() {
            numbers[vertex as usize] = number as u32;
        }
        triangles.as_flattened_mut().iter_mut().for_each(|vertex| *vertex = numbers[*vertex as usize]);
        return kept;
    }
    let mut kept = triangles.as_flattened().to_vec();
    kept.sort_unstable();
    kept.dedup();
    for vertex in triangles.as_flattened_mut() {
        *vertex = kept.partition_point(|other| *other < *vertex) as u32;
    }
    kept
}

/// Whether a triangle covers anything.
fn has_area(corners: [Vec3; 3]) -> bool {
    let [a, b, c] = corners.map(Vec3::as_dvec3);
    let longest = [b - a, c - b, a - c].map(DVec3::length_squared).into_iter().fold(0.0, f64::max);
    (b - a).cross(c - a).length() > LEAST_THICKNESS * longest
}

fn triangles(count: usize) -> String {
    if count == 1 { "1 triangle".to_owned() } else { format!("{count} triangles") }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn vertices_are_numbered_anew_in_both_ways() {
        for count in [8, 1000] {
            let mut triangles = [[7, 2, 3], [2, 7, 5]];
            assert_eq!(used(&mut triangles, count), [2, 3, 5, 7]);
            assert_eq!(triangles, [[3, 0, 1], [0, 3, 2]]);
        }
    }

    #[test]
    fn area_is_told_at_any_size() {
        let corners = [Vec3::ZERO, Vec3::X, Vec3::Y];
        for size in [1e-35, 1e-12, 1.0, 1e30] {
            assert!(has_area(corners.map(|corner| corner * size)), "{size}");
        }
        let line = [Vec3::new(0.1, 0.2, 0.3), Vec3::new(0.2, 0.4, 0.6), Vec3::new(0.4, 0.8, 1.2)];
        assert!(!has_area(line));
        assert!(!has_area([Vec3::ONE, Vec3::ONE, Vec3::X]));
    }
}

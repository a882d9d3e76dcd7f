//! What is hidden is not drawn, and that shows nowhere.

use std::fmt::Write as _;

use crate::{
    balls,
    stage::{BACKGROUND, Picture, Random, Rgb, SIDE, Stage},
};

const OBJECTS: usize = 16;

fn colour(object: usize) -> Rgb {
    [0x10 * object as u8 + 0x08, 0xf0 - 0x0b * object as u8, 0x80 ^ (0x07 * object as u8)]
}

/// Random balls, `each` to an object; `depth` is how far they spread along the line of sight.
fn heap(seed: u64, each: usize, [smallest, largest]: [f32; 2], depth: f32) -> Vec<Vec<[f32; 4]>> {
    let mut random = Random(seed);
    let mut ball = || {
        let z = random.between(-depth, 0.7 * depth);
        // Some reach over the edges of the picture.
        let side = 0.55 * (10.0 - z);
        let [x, y] = [(); 2].map(|()| random.between(-side, side));
        [x, y, z, random.between(smallest, largest)]
    };
    (0..OBJECTS).map(|_| (0..each).map(|_| ball()).collect()).collect()
}

fn drawn(objects: &[Vec<[f32; 4]>]) -> Picture {
    let mut stage = Stage::default();
    for (number, object) in objects.iter().enumerate() {
        let [r, g, b] = colour(number);
        let mut more = String::new();
        write!(more, "style = {{ tones = [\"#{r:02x}{g:02x}{b:02x}\"] }}").unwrap();
        stage = stage.balls(&format!("object{number}"), object, &more);
    }
    stage.picture()
}

/// Asserts that the picture is the one made by looking at every ball for every pixel. Edges may lie a
/// pixel or two elsewhere; a puff that was left out would be missed in the middle of faces.
#[track_caller]
fn assert_all_drawn(objects: &[Vec<[f32; 4]>]) {
    let picture = drawn(objects);
    let mut nearest = vec![(f32::MAX, BACKGROUND); (SIDE * SIDE) as usize];
    for (number, object) in objects.iter().enumerate() {
        for &ball in object {
            splat(&mut nearest, ball, colour(number));
        }
    }
    let expected = |x: u32, y: u32| nearest[(y * SIDE + x) as usize].1;
    let (mut faces, mut wrong) = (0_u32, 0_u32);
    for (x, y) in picture.places().filter(|&(x, y)| (2..SIDE - 2).contains(&x) && (2..SIDE - 2).contains(&y))
    {
        let own = expected(x, y);
        if own != BACKGROUND && (0..25).all(|i| expected(x + i % 5 - 2, y + i / 5 - 2) == own) {
            faces += 1;
            wrong += u32::from(picture.rgb(x, y) != own);
        }
    }
    assert!(faces > SIDE * SIDE / 8, "there are faces to look at: {faces}");
    assert!(wrong * 1000 < faces, "{wrong} of {faces} pixels are wrong");
}

/// Draws one ball into a buffer of the nearest.
fn splat(nearest: &mut [(f32, Rgb)], ball: [f32; 4], colour: Rgb) {
    let scale = SIDE as f32 / (10.0 - ball[2]);
    let [x, y] = [0.5 * SIDE as f32 + ball[0] * scale, 0.5 * SIDE as f32 - ball[1] * scale];
    let reach = ball[3] * scale + 1.0;
    let range = |middle: f32| (middle - reach).max(0.0) as u32..((middle + reach).max(0.0) as u32).min(SIDE);
    for row in range(y) {
        for column in range(x) {
            if let Some(distance) = balls::distance(balls::ray(column, row), ball) {
                let pixel = &mut nearest[(row * SIDE + column) as usize];
                if distance < pixel.0 {
                    *pixel = (distance, colour);
                }
            }
        }
    }
}

#[test]
fn two_thousand_balls_look_as_if_each_were_drawn() {
    for (seed, sizes, depth) in [(1, [0.2, 0.9], 3.0), (2, [0.05, 0.3], 5.0), (3, [0.3, 3.0], 8.0)] {
        assert_all_drawn(&heap(seed, 125, sizes, depth));
    }
}

#[test]
fn balls_close_behind_others_show_where_they_stick_out() {
    // Much the same depth: the hardest case to tell hidden from seen.
    for (seed, depth) in [(4, 0.3), (5, 0.02)] {
        assert_all_drawn(&heap(seed, 125, [0.3, 0.8], depth));
    }
}

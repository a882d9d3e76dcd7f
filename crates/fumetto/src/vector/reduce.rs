//! Very many colours to a few.
//!
//! Heckbert, "Color Image Quantization for Frame Buffer Display", 1982: the box of colours that is the widest is cut
//! where half of its samples lie to either side.

use super::seen::Tone;

/// Colours that very many are brought to: as many steps as a fine ramp has.
const FEW: usize = 32;

/// Brings the tones of each object that has more than `many` to a few. Each comes with its number of samples.
pub(super) fn reduced(found: &mut [(Tone, usize)], many: usize) {
    let objects = found.iter().map(|(tone, _)| tone.object + 1).max().unwrap_or_default();
    for object in 0..objects {
        let mut own: Vec<&mut (Tone, usize)> =
            found.iter_mut().filter(|(tone, _)| tone.object == object).collect();
        if own.len() > many {
            own.sort_by_key(|(tone, _)| *tone);
            reduce(own);
        }
    }
}

fn reduce(tones: Vec<&mut (Tone, usize)>) {
    let mut boxes = vec![tones];
    while boxes.len() < FEW {
        let widest = boxes.iter().enumerate().max_by_key(|(at, tones)| (width(tones).0, usize::MAX - at));
        let Some(at) = widest.map(|(at, _)| at).filter(|&at| width(&boxes[at]).0 > 0) else { break };
        let mut tones = boxes.swap_remove(at);
        let channel = width(&tones).1;
        tones.sort_by_key(|(tone, _)| (tone.rgba[channel], *tone));
        let all: usize = tones.iter().map(|(_, samples)| samples).sum();
        let mut sum = 0;
        let half = tones.iter().position(|(_, samples)| {
            sum += samples;
            2 * sum >= all
        });
        let cut = half.map_or(1, |half| half + 1).clamp(1, tones.len() - 1);
        let rest = tones.split_off(cut);
        boxes.push(tones);
        boxes.push(rest);
    }
    for mut tones in boxes {
        let mean = mean(&tones);
        tones.iter_mut().for_each(|(tone, _)| tone.rgba = mean);
    }
}

/// How far apart colours are along the channel in which they are the farthest, and which that is.
fn width(tones: &[&mut (Tone, usize)]) -> (u8, usize) {
    let apart = |channel: usize| {
        let values = || tones.iter().map(|(tone, _)| tone.rgba[channel]);
        values().max().unwrap_or_default() - values().min().unwrap_or_default()
    };
    let widths = [0, 1, 2, 3].map(|channel| (apart(channel), channel));
    widths.into_iter().max_by_key(|&(width, channel)| (width, 4 - channel)).unwrap_or_default()
}

/// Of all samples.
fn mean(tones: &[&mut (Tone, usize)]) -> [u8; 4] {
    let all: usize = tones.iter().map(|(_, samples)| samples).sum();
    [0, 1, 2, 3].map(|channel| {
        let sum: usize = tones.iter().map(|(tone, samples)| samples * usize::from(tone.rgba[channel])).sum();
        ((sum + all / 2) / all.max(1)) as u8
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn shades_become_steps_and_flat_tones_stay() {
        let tone = |object, grey| (Tone { object, rgba: [grey, grey, grey, 255] }, 10);
        let shades = (0..=255).map(|grey| tone(0, grey));
        let mut found: Vec<_> = shades.chain([tone(1, 3), tone(1, 200)]).collect();
        reduced(&mut found, 64);
        let mut greys: Vec<u8> = found[..256].iter().map(|(tone, _)| tone.rgba[0]).collect();
        assert!(greys.is_sorted());
        greys.dedup();
        assert_eq!(greys.len(), FEW);
        assert!(found[..256].iter().zip(0_u8..=255).all(|((tone, _), grey)| tone.rgba[0].abs_diff(grey) < 8));
        assert_eq!(found[256..], [tone(1, 3), tone(1, 200)]);
    }
}

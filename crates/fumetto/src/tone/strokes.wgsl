// Strokes that shade: where parallel planes cut the form. Every second plane lets go as the form is seen from
// farther away, stroke by stroke, and comes back as it is seen from nearer (Praun et al., "Real-Time Hatching",
// 2001: strokes of a lighter tone and of a coarser scale are among those of a darker and a finer one). Planes
// have no ends or seams and stay where they are, so nothing slides on the form.
//
// How much of the paper strokes cover is exact on average: what is wanted of it decides how wide they are and
// how many of them are there.

// Share of the ranks over which a stroke grows to its width.
const TAPER: f32 = 0.25;

// Cells of the noise that makes a stroke stray, in spacings.
const STRAY: f32 = 7.0;

// Share of its width under which a stroke ends in place of getting thinner; never less than a sample.
const FINEST: f32 = 0.3;

// Samples from stroke to stroke, at least.
const DENSEST: f32 = 2.5;

// How much the style's own direction counts where the form bends no way more than another.
const UNBENT: f32 = 0.4;

// How soon strokes of one axis give way to those of the next: the larger, the sooner.
const REACH: f32 = 3.0;

// A pixel of what is hatched, in the coordinates that strokes stay in.
struct Laid {
    at: vec3f,
    // The same a pixel to the right and below, less `at`.
    right: vec3f,
    below: vec3f,
    // Units of these coordinates to a sample, where the form faces the viewer, and to a metre.
    unit_px: f32,
    unit_m: f32,
    // Samples to a metre.
    px_m: f32,
    // Which way the form bends: see `turns.wgsl`.
    turn: vec2f,
}

// The strokes of one layer around a pixel.
struct Strokes {
    // Along the planes, for noise.
    along: vec2f,
    // Across them.
    at: f32,
    // Units to a sample.
    slope: f32,
    unit_px: f32,
    // In samples.
    width: f32,
    wobble: f32,
    finest: f32,
    // Units to the lattice of noise that ends strokes, and that which makes them stray.
    length: f32,
    stray: f32,
    key: u32,
    is_hard: bool,
}

// Whether a stroke is here, from 0 to 1: where planes are cut at `at`, and a share `part` of the stroke is there.
fn stroke(strokes: Strokes, at: f32, part: f32) -> f32 {
    // The same for a plane at whatever scale it is seen: its place is exact.
    let key = pcg(strokes.key + bitcast<u32>(select(at, 0.0, at == 0.0)));
    var rank = random(key, 1u);
    if strokes.length > 0.0 {
        // A logistic curve has much the same shape as the normal distribution: ranks are spread evenly.
        let noise = steady_grain(strokes.along, strokes.length, key) / GRAIN_DEVIATION;
        rank = 1.0 / (1.0 + exp(-1.702 * noise));
    }
    let grown = clamp((part * (1.0 + TAPER) - rank) / TAPER, 0.0, 1.0);
    let half = 0.5 * strokes.width * grown;
    let stray = strokes.wobble * steady_grain(strokes.along, strokes.stray, key + 1u) / GRAIN_DEVIATION;
    let off = abs((strokes.at - at) / strokes.slope + stray);
    if 2.0 * half < 0.5 * strokes.finest {
        return 0.0;
    }
    let covered = clamp(min(off + 0.5, half) - max(off - 0.5, -half), 0.0, 1.0);
    return select(covered, select(0.0, 1.0, off < half), strokes.is_hard);
}

// How an axis changes across the picture.
fn change_of(axis: vec3f, laid: Laid) -> vec2f {
    return vec2f(dot(axis, laid.right), dot(axis, laid.below));
}

// How much of a pixel the strokes across one axis cover, of which a share `wanted` of the layer's most is wanted;
// only a share `some` of them takes part.
fn axis_cover(style: HatchStyle, number: u32, laid: Laid, wanted: f32, some: f32, thinned: f32) -> f32 {
    let axis = style.axes[number].xyz;
    let beside = across(axis);
    let slope = max(length(change_of(axis, laid)), 1e-12);
    // From stroke to stroke as it should be, in units; the lattice of planes is of powers of two of `unit`.
    let unit = select(1.0, style.spacing_m * laid.unit_m, style.spacing_m > 0.0);
    let spacing = max(max(style.spacing_px * slope, style.spacing_m * laid.unit_m), DENSEST * slope);
    let octave = log2(spacing / unit);
    let whole = ceil(octave - 1e-3);
    let cell = unit * exp2(whole);
    // Of the planes between, this share is there.
    let between = clamp(exp2(whole - octave) - 1.0, 0.0, 1.0);

    let spacing_px = spacing / slope;
    let widest = min(max(style.width_px, style.width_m * laid.px_m), spacing_px);
    let finest = max(FINEST * widest, 1.0);
    let swollen = mix(1.0, wanted, style.swell);
    var width = widest * swollen;
    var part = wanted / max(swollen, 1e-6);
    part *= min(width / finest, 1.0);
    width = max(width, finest);
    // Where planes between are few, the others are wider before they touch.
    let apart = cell / slope;
    let touching = apart * (width / spacing_px - between) / max(1.0 - between, 1e-3);
    width = thinned * select(width, min(touching, apart), width > 0.5 * apart);
    part *= some * (1.0 - style.gaps);

    var strokes: Strokes;
    strokes.along = vec2f(dot(beside[0], laid.at), dot(beside[1], laid.at));
    strokes.at = dot(axis, laid.at);
    strokes.slope = slope;
    strokes.width = width;
    strokes.wobble = style.wobble_px;
    strokes.finest = finest;
    strokes.length = select(0.0, max(style.length_px, 1.0), style.length_px > 0.0) * laid.unit_px;
    strokes.stray = STRAY * max(style.spacing_px, 4.0 * style.scale) * laid.unit_px;
    strokes.key = style.seed + number * 2654435769u;
    strokes.is_hard = (style.look & IS_HARD) != 0u;
    let planes = strokes.at / cell;
    let main = stroke(strokes, round(planes) * cell, part);
    return max(main, stroke(strokes, (floor(planes) + 0.5) * cell, part * between));
}

// How much of a pixel the strokes of one layer cover. Where the form chooses, those two axes count whose strokes run
// most as it bends; between places of one and of the other, strokes of both reach into each other.
fn layer_cover(style: HatchStyle, layer: u32, laid: Laid, wanted: f32, thinned: f32) -> f32 {
    if (style.look & IS_CURVED) == 0u {
        return axis_cover(style, layer, laid, wanted, 1.0, thinned);
    }
    // Where the form bends all ways alike, the style's own direction is as good as any.
    let own = change_of(style.axes[0].xyz, laid);
    let plain = laid.turn + UNBENT * (1.0 - length(laid.turn)) * twice(-own.yx);
    let turned = 2.0 * f32(layer) * style.cross;
    let turn = vec2f(cos(turned) * plain.x - sin(turned) * plain.y, sin(turned) * plain.x + cos(turned) * plain.y);
    var best = vec2u(0u);
    var near = vec2f(-2.0);
    for (var number = 0u; number < AXES; number++) {
        let change = change_of(style.axes[number].xyz, laid);
        let fits = dot(twice(-change.yx), turn / max(length(turn), 1e-6));
        if fits > near.x {
            best = vec2u(number, best.x);
            near = vec2f(fits, near.x);
        } else if fits > near.y {
            best.y = number;
            near.y = fits;
        }
    }
    let some = clamp(0.5 + REACH * (near.x - near.y), 0.5, 1.0);
    let cover = axis_cover(style, best.x, laid, wanted, some, thinned);
    if some == 1.0 {
        return cover;
    }
    return max(cover, axis_cover(style, best.y, laid, wanted, 1.0 - some, thinned));
}

// How much of a pixel all strokes cover, for an amount of light. Layers come one after the other as it gets
// darker; each covers so much of what the others leave free that together they cover what is wanted.
fn hatched(style: HatchStyle, laid: Laid, amount: f32, px: vec2f) -> f32 {
    var dark = clamp((style.light_from - amount) / (style.light_from - style.light_full), 0.0, 1.0);
    if style.levels > 0.0 {
        dark = ceil(dark * style.levels) / style.levels;
    }
    if dark == 0.0 {
        return 0.0;
    }
    let paper = (px + view.first_px) / style.scale;
    let tooth = 0.5 * (grain(paper / 1.7, style.seed) + grain(paper / 3.1, style.seed + 1u));
    let thinned = 1.0 - style.tooth * tooth;
    let widest = max(style.width_px, style.width_m * laid.px_m);
    let apart = max(style.spacing_px, style.spacing_m * laid.px_m);
    let most = min(widest / apart, 0.999);
    let free = 1.0 - dark * (1.0 - pow(1.0 - most, f32(style.layers)));
    var left = 1.0;
    var before = 1.0;
    for (var layer = 0u; layer < style.layers; layer++) {
        let wanted = clamp((1.0 - free / before) / most, 0.0, 1.0);
        if wanted > 0.0 {
            left *= 1.0 - layer_cover(style, layer, laid, wanted, thinned);
        }
        before *= 1.0 - most;
    }
    return 1.0 - left;
}

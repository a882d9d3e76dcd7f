use super::values::colour;
use super::{At, Styles};
use crate::file::{
    BorderFile, BrushFile, CellsFile, DropFile, GrowthFile, LookFile, ObjectFile, PourFile, SpreadFile,
    WashFile, WashModeFile,
};
use crate::fit::did_you_mean;
use crate::limits::{
    DISTANCE, MAX_PAINT_LAYERS, MAX_PAINT_POINTS, MAX_PAINT_POURS, MAX_PAINT_SUBSTEPS, MAX_PAINT_VERTICES,
    MAX_PAINT_VOLUMES, SECONDS,
};
use crate::{Border, Brush, Cells, Drop, Growth, Look, Matter, Object, Paint, Pour, Spread, Style, Wash};

/// A step that is cut into more parts than this is worth a word.
const FEW_SUBSTEPS: u32 = 16;

/// Grain is half as large as the largest radius, unless the file says otherwise.
pub(super) const GRAIN_SHARE: f32 = 0.5;

/// A drop falls with this share of its largest radius, likewise.
const START_SHARE: f32 = 0.1;

/// A step of the simulation takes `step_secs`. How it draws what lies inside and outside is put in later.
pub(super) fn paint(at: &At<'_>, file: &ObjectFile, step_secs: f64) -> Paint {
    let drops = file.drop.as_ref().map_or(&[][..], |drops| drops.as_slice());
    let strokes = file.stroke.as_ref().map_or(&[][..], |strokes| strokes.as_slice());
    let drops: Vec<_> = drops.iter().enumerate().map(|(i, one)| drop(&at.key("drop").item(i), one)).collect();
    let strokes: Vec<_> =
        strokes.iter().enumerate().map(|(i, one)| stroke(&at.key("stroke").item(i), one)).collect();
    let cells = file.cells.map(cells);
    let radii = drops.iter().map(|drop| &drop.radius).chain(strokes.iter().map(|stroke| &stroke.radius));
    let largest = radii.map(Growth::largest).chain(cells.map(|cells| 2.0 * cells.cell_m)).fold(0.0, f32::max);
    let paint = Paint {
        spread: spread(&at.key("spread"), file.spread.unwrap_or_default(), largest, step_secs),
        pours: pours(at, file),
        keep: file.keep.map(|keep| [keep.center, keep.size]),
        wash: file.wash.as_ref().map(|file| wash(&at.key("wash"), file)),
        border: file.border.as_ref().map(|file| border(&at.key("border"), file)),
        inside: Look::Own,
        outside: None,
        stains: Vec::new(),
        drops,
        strokes,
        cells,
    };
    if paint.volumes() == 0 && file.stain.is_none() {
        let message = format!("the paint {:?} has no drop, no stroke, no pour and no stain", file.name);
        at.warning("no-paint", message, "write drop = [{ at = [0, 0, 0], radius = 1.0 }]");
    }
    paint
}

fn drop(at: &At<'_>, file: &DropFile) -> Drop {
    let radius = growth(&at.key("radius"), &file.radius);
    let start_m = file.start.unwrap_or(START_SHARE * radius.largest());
    Drop { at: file.at, time_secs: file.time, radius, start_m }
}

fn stroke(at: &At<'_>, file: &BrushFile) -> Brush {
    if file.path.len() < 2 {
        let message = format!("a stroke needs two places or more, and `path` has {}", file.path.len());
        at.key("path").error("short-path", message, "for a single place write a `drop`");
    }
    rising(&at.key("during"), file.during);
    let radius = growth(&at.key("radius"), &file.radius);
    let start_m = file.start.unwrap_or(START_SHARE * radius.largest());
    Brush { path: file.path.clone(), during_secs: file.during, radius, start_m }
}

fn rising(at: &At<'_>, [from, until]: [f32; 2]) {
    if from >= until {
        let message = format!("`during` runs from {from} s to {until} s");
        at.error("falling-range", message, "write the earlier moment first, as in [1, 3]");
    }
}

fn growth(at: &At<'_>, file: &GrowthFile) -> Growth {
    let points = match file {
        GrowthFile::One(radius) => vec![[0.0, *radius]],
        GrowthFile::Points(points) => points.clone(),
    };
    if points.len() > MAX_PAINT_POINTS {
        let message =
            format!("a radius of {} points, but at most {MAX_PAINT_POINTS} are allowed", points.len());
        at.error("too-many-points", message, "leave out points that lie between others");
    }
    let mut last_secs = f32::NEG_INFINITY;
    for (i, &[secs, metres]) in points.iter().enumerate() {
        if let GrowthFile::Points(_) = file {
            let point = at.item(i);
            point.item(0).within(secs, &SECONDS, "seconds count from when the paint falls");
            point.item(1).within(metres, &DISTANCE, "a radius of 0 makes the paint shrink away");
            if secs <= last_secs {
                let message = format!("{secs} s come after {last_secs} s");
                point.error(
                    "curve-not-rising",
                    message,
                    "order the points by time, each at a time of its own",
                );
            }
        }
        last_secs = secs;
    }
    let growth = Growth { points };
    let largest = growth.largest();
    if largest <= 0.0 || !largest.is_finite() {
        let message = "`radius` is never above 0, so there is never any paint".to_owned();
        at.error("no-radius", message, "give a radius above 0, or points as in [[0, 0.2], [3, 1.5]]");
    } else {
        at.within(largest, &DISTANCE, "it is in metres");
    }
    growth
}

fn cells(file: CellsFile) -> Cells {
    Cells {
        center: file.center,
        size: file.size,
        cell_m: file.cell,
        depth_m: file.depth.unwrap_or(0.1 * file.cell),
        speed_m_per_s: file.speed,
        uneven: file.uneven,
    }
}

fn pours(at: &At<'_>, file: &ObjectFile) -> Vec<Pour> {
    let files = file.pour.as_ref().map_or(&[][..], |pours| pours.as_slice());
    let at_pours = at.key("pour");
    if !files.is_empty() && file.cells.is_none() {
        let message = format!("the paint {:?} is poured, but has no `cells` that hold it", file.name);
        at_pours.error(
            "no-cells",
            message,
            "add cells = { center = [0, 1, 0], size = [4, 2, 4], cell = 0.2 }",
        );
    }
    if files.is_empty() && file.cells.is_some() {
        let message = format!("the paint {:?} has `cells`, but nothing is poured into them", file.name);
        at.key("cells").warning("no-pour", message, "add an [[object.pour]] with `at`, `during` and `rate`");
    }
    let pour = |(i, file): (usize, &PourFile)| {
        let at = at_pours.item(i);
        rising(&at.key("during"), file.during);
        Pour { at: file.at, during_secs: file.during, rate_m3_per_s: file.rate }
    };
    let pours: Vec<_> = files.iter().enumerate().map(pour).collect();
    if let Some(cells) = file.cells {
        for (i, pour) in pours.iter().enumerate() {
            if [0, 2].iter().any(|&axis| (pour.at[axis] - cells.center[axis]).abs() > 0.5 * cells.size[axis])
            {
                let message = "this is poured beside the `cells`, so none of it is seen".to_owned();
                at_pours.item(i).key("at").warning(
                    "pour-beside-cells",
                    message,
                    "move it, or enlarge `cells`",
                );
            }
        }
    }
    pours
}

fn spread(at: &At<'_>, file: SpreadFile, largest_m: f32, step_secs: f64) -> Spread {
    let spread = Spread {
        subdivisions: file.subdivisions,
        stiffness: file.stiffness,
        elasticity: file.elasticity,
        friction: file.friction,
        gravity: file.gravity,
        downhill: file.downhill,
        grain: file.grain,
        grain_m: file.grain_size.unwrap_or((GRAIN_SHARE * largest_m).max(f32::MIN_POSITIVE)),
    };
    let substeps = spread.substeps(step_secs);
    let help = "lower `stiffness`, `elasticity` or `friction`, or raise `time.substeps`";
    if substeps > MAX_PAINT_SUBSTEPS {
        let message = format!(
            "paint this stiff needs every step cut into {substeps} parts not to explode, and at most \
             {MAX_PAINT_SUBSTEPS} are allowed"
        );
        at.key("stiffness").error("too-stiff", message, help);
    } else if substeps > FEW_SUBSTEPS {
        let message =
            format!("paint this stiff would explode, so that every step is cut into {substeps} parts");
        at.key("stiffness").warning("stiff", message, help);
    }
    spread
}

fn wash(at: &At<'_>, file: &WashFile) -> Wash {
    if file.spacing * (file.steps.saturating_sub(1)) as f32 >= 1.0 {
        let message = format!(
            "{} volumes, each smaller by {} of the radius than the one around it, leave the last without any",
            file.steps, file.spacing
        );
        at.key("spacing").error("washes-too-far-apart", message, "lower `spacing` or `steps`");
    }
    Wash {
        steps: file.steps,
        spacing: file.spacing,
        colour: colour(&at.key("colour"), &file.colour),
        strength: file.strength,
        covers: file.mode == WashModeFile::Cover,
    }
}

fn border(at: &At<'_>, file: &BorderFile) -> Border {
    Border { colour: colour(&at.key("colour"), &file.colour), width: file.width.into() }
}

/// Refuses more paint than there is room for, before anything is made of it.
pub(super) fn enough_room(at: &At<'_>, objects: &[Object]) {
    let paints = || {
        objects.iter().filter_map(|object| match &object.matter {
            Matter::Paint(paint) => Some(paint),
            _ => None,
        })
    };
    let sum = |of: fn(&Paint) -> u64| paints().map(of).fold(0, u64::saturating_add);
    let asked = [
        (sum(|paint| paint.layers().into()), MAX_PAINT_LAYERS.into(), "layers", LAYERS_HELP),
        (sum(Paint::volumes), MAX_PAINT_VOLUMES, "volumes", VOLUMES_HELP),
        (sum(Paint::vertices), MAX_PAINT_VERTICES, "vertices", VERTICES_HELP),
        (
            sum(|paint| paint.pours.len() as u64),
            MAX_PAINT_POURS,
            "pours",
            "join those that are near each other",
        ),
    ];
    for (asked, most, what, help) in asked {
        if asked > most {
            let message = format!("all paint together has {asked} {what}, but at most {most} are allowed");
            at.error("too-much-paint", message, help);
        }
    }
}

const LAYERS_HELP: &str = "each wash is one; lower `wash.steps`, or join paints that look the same";

const VOLUMES_HELP: &str = "each drop, piece of a stroke, cell and stain is one, as often as there are washes; enlarge \
     `cell`, or raise `stain.every`";

const VERTICES_HELP: &str = "lower `spread.subdivisions`, or enlarge `cell`";

/// Puts into each paint among `objects` how it draws what lies inside and outside of it.
pub(super) fn looks(at: &At<'_>, files: &[ObjectFile], objects: &mut [Object], styles: &mut Styles<'_>) {
    let own: Vec<Style> = objects.iter().map(|object| object.style.clone()).collect();
    let mut said: Option<&str> = None;
    for (i, (file, object)) in files.iter().zip(objects).enumerate() {
        let Matter::Paint(paint) = &mut object.matter else { continue };
        let at = at.item(i);
        if let Some(file) = &file.inside {
            paint.inside = look(&at.key("inside"), file, &own, styles);
        }
        if let Some(outside) = &file.outside {
            let at = at.key("outside");
            if let Some(other) = said {
                let message =
                    format!("the paint {other:?} says already how what is outside of all paint is drawn");
                at.error("two-outsides", message, "leave `outside` out in all paints but one");
            }
            said = Some(&file.name);
            paint.outside = Some(look(&at, outside, &own, styles));
        }
    }
}

fn look(at: &At<'_>, file: &LookFile, own: &[Style], styles: &mut Styles<'_>) -> Look {
    match file {
        LookFile::Named(name) => match name.as_str() {
            "own" => Look::Own,
            "monochrome" => Look::Monochrome,
            _ => {
                let message = format!("`{}` cannot be {name:?}", at.name());
                let help = did_you_mean(name, &["own", "monochrome"]);
                at.error("unknown-value", message, format!("{help} A table of style keys is possible too"));
                Look::Own
            }
        },
        LookFile::Style(changes) => {
            Look::Styled(own.iter().map(|style| styles.changed(at, changes, style)).collect())
        }
    }
}

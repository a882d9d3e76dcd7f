use super::{
    At, Styles,
    grid::fitting_grid,
    imported::{check_shape, imported},
    mesh::mesh,
    morph::{given, metamorphosis},
    paint::paint,
    shape::{details, shape},
    smoke::smoke,
    volume,
    vortex::few_vortices,
};
use crate::file::{ObjectFile, ObjectKind};
use crate::limits::{MAX_PARTICLES, PARTICLE_BYTES};
use crate::{Given, Matter, Object, Style};

/// A step of the simulation takes `step_secs`.
pub(super) fn object(
    at: &At<'_>,
    file: &ObjectFile,
    scene_style: &Style,
    step_secs: f64,
    styles: &mut Styles<'_>,
) -> Object {
    let style = match &file.style {
        Some(changes) => styles.changed(&at.key("style"), changes, scene_style),
        None => scene_style.clone(),
    };
    let (at_shape, shape_file) = (at.key("shape"), file.shape.as_ref());
    let is_imported = file.kind == ObjectKind::Volume;
    if is_imported {
        check_shape(at, file);
    }
    let shape = shape(&at_shape, shape_file, is_imported, style.height_px);
    let object = Object {
        name: file.name.clone(),
        visible: file.visible,
        matter: matter(at, file, step_secs),
        details: details(&at_shape, shape_file, &shape, &style),
        shape,
        style,
        opacity: file.opacity,
    };
    if let Some(shape) = object.shape.volume() {
        volume::room(&at.key("shape").key("volume"), shape, &object.matter);
    }
    let asked = object.capacity(step_secs).unwrap_or(0);
    if asked > MAX_PARTICLES {
        let bytes = asked.saturating_mul(PARTICLE_BYTES) / 1_000_000;
        let message = format!(
            "object {:?} may hold {asked} particles at once, but at most {MAX_PARTICLES} are allowed",
            file.name
        );
        let source = if file.kind == ObjectKind::Smoke { at.key("emitter") } else { at.key("particles") };
        let source = if source.exists() { source } else { *at };
        let help = format!(
            "they would take {bytes} MB; lower `count`, `rate` or `life`, and enlarge `radius` instead"
        );
        source.error("too-many-particles", message, help);
    }
    few_vortices(at, &object, step_secs);
    fitting_grid(at, &object, step_secs);
    object
}

/// Keys that only some kinds have, with those kinds.
const KEYS: [(&str, &[ObjectKind]); 26] = [
    ("opacity", &[ObjectKind::Smoke, ObjectKind::Cloud, ObjectKind::Mesh, ObjectKind::Volume]),
    ("particles", &[ObjectKind::Cloud]),
    ("morph", &[ObjectKind::Cloud]),
    ("emitter", &[ObjectKind::Smoke]),
    ("force", &[ObjectKind::Smoke]),
    ("solver", &[ObjectKind::Smoke]),
    ("vortex", &[ObjectKind::Smoke]),
    ("grid", &[ObjectKind::Smoke]),
    ("shape", &[ObjectKind::Cloud, ObjectKind::Smoke, ObjectKind::Volume]),
    ("model", &[ObjectKind::Mesh]),
    ("volume", &[ObjectKind::Volume]),
    ("up", &[ObjectKind::Mesh, ObjectKind::Volume]),
    ("smooth", &[ObjectKind::Mesh]),
    ("transform", &[ObjectKind::Mesh, ObjectKind::Volume]),
    ("obstacle", &[ObjectKind::Mesh]),
    ("drop", &[ObjectKind::Paint]),
    ("stroke", &[ObjectKind::Paint]),
    ("pour", &[ObjectKind::Paint]),
    ("cells", &[ObjectKind::Paint]),
    ("stain", &[ObjectKind::Paint]),
    ("spread", &[ObjectKind::Paint]),
    ("keep", &[ObjectKind::Paint]),
    ("wash", &[ObjectKind::Paint]),
    ("border", &[ObjectKind::Paint]),
    ("inside", &[ObjectKind::Paint]),
    ("outside", &[ObjectKind::Paint]),
];

/// Whether objects of `kind` have `key`; those of a kind that is not known have all.
pub(crate) fn is_key_of(key: &str, kind: Option<&str>) -> bool {
    let owners = KEYS.iter().find(|(known, _)| *known == key).map(|(_, kinds)| *kinds);
    let is_known = ObjectKind::ALL.iter().any(|known| kind == Some(kind_name(*known)));
    !is_known || owners.is_none_or(|kinds| kinds.iter().any(|owner| kind == Some(kind_name(*owner))))
}

fn matter(at: &At<'_>, file: &ObjectFile, step_secs: f64) -> Matter {
    for (key, kinds) in KEYS {
        let at = at.key(key);
        if at.exists() && !kinds.contains(&file.kind) {
            let message = format!("`{key}` is no key of kind {:?}", kind_name(file.kind));
            let owners: Vec<_> = kinds.iter().map(|&kind| format!("kind = {:?}", kind_name(kind))).collect();
            at.error("wrong-kind", message, format!("write {}, or leave this out", owners.join(" or ")));
        }
    }
    match file.kind {
        ObjectKind::Cloud => cloud(at, file),
        ObjectKind::Smoke => Matter::Smoke(smoke(at, file)),
        ObjectKind::Mesh => Matter::Mesh(mesh(at, file)),
        ObjectKind::Volume => Matter::Imported(Box::new(imported(at, file))),
        ObjectKind::Paint => Matter::Paint(paint(at, file, step_secs)),
    }
}

fn kind_name(kind: ObjectKind) -> &'static str {
    match kind {
        ObjectKind::Smoke => "smoke",
        ObjectKind::Cloud => "cloud",
        ObjectKind::Mesh => "mesh",
        ObjectKind::Volume => "volume",
        ObjectKind::Paint => "paint",
    }
}

fn cloud(at: &At<'_>, file: &ObjectFile) -> Matter {
    let whose = format!("the cloud {:?}", file.name);
    let given = given(&at.key("particles"), file.particles.as_ref(), &whose);
    match (&file.morph, given) {
        (Some(changes), given) if !changes.is_empty() => Matter::Morph(metamorphosis(at, given, changes)),
        (_, Given::Listed(particles)) => Matter::Still(particles),
        (_, Given::File(path)) => Matter::File(path),
    }
}

/// The name among `names` that `wrong` is likely a slip of: at most a third of its letters off, or the
/// beginning or end of the name.
pub(crate) fn nearest<'n>(wrong: &str, names: impl IntoIterator<Item = &'n str>) -> Option<&'n str> {
    // Comparing takes the product of both lengths, and nobody slips into a text this long.
    if wrong.len() > 64 {
        return None;
    }
    let wrong = wrong.to_lowercase();
    let distance = |name: &str| {
        let part = wrong.len() >= 3 && (name.starts_with(&wrong) || name.ends_with(&wrong));
        if part { 1 } else { strsim::damerau_levenshtein(&wrong, name) }
    };
    let nearest = names.into_iter().map(|name| (distance(name), name)).min_by_key(|(distance, _)| *distance);
    nearest.filter(|(distance, name)| *distance <= name.len().max(3) / 3).map(|(_, name)| name)
}

/// A help line for an unknown name: the nearest known one, or all of them.
pub(crate) fn did_you_mean(wrong: &str, names: &[&str]) -> String {
    match nearest(wrong, names.iter().copied()) {
        Some(name) => format!("did you mean `{name}`?"),
        None => format!("known here: {}", list(names, "and")),
    }
}

/// "`a`, `b` and `c`".
pub(crate) fn list(names: &[&str], and: &str) -> String {
    let quoted: Vec<String> = names.iter().map(|name| format!("`{name}`")).collect();
    match quoted.split_last() {
        Some((last, rest)) if !rest.is_empty() => format!("{} {and} {last}", rest.join(", ")),
        _ => quoted.concat(),
    }
}

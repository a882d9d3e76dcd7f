/// The name of a file that lies beside `name` and holds a part of it: `smoke.0001.png` and `normal`
/// give `smoke.0001.normal.png`.
pub(crate) fn with_part(name: &str, part: &str) -> String {
    match name.rsplit_once('.') {
        Some((stem, extension)) => format!("{stem}.{part}.{extension}"),
        None => format!("{name}.{part}"),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn parts_go_before_the_extension() {
        assert_eq!(with_part("out.d/smoke.0001.png", "normal"), "out.d/smoke.0001.normal.png");
    }
}

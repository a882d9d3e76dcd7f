//! Pieces of a stranger's file, made fit to stand in a message of one line.

/// Longest excerpt in characters: a number or a column's name is shorter, a wrong file's line is not.
const MAX_CHARS: usize = 40;

/// Most names that one list shows.
const MAX_NAMES: usize = 8;

/// Longest path in characters: its end tells which file it is.
const MAX_PATH_CHARS: usize = 160;

/// `bytes` as text without control characters, cut to a readable length.
pub(crate) fn excerpt(bytes: &[u8]) -> String {
    cut(bytes, MAX_CHARS)
}

/// The same for a path.
pub(crate) fn excerpt_path(path: &str) -> String {
    cut(path.as_bytes(), MAX_PATH_CHARS)
}

fn cut(bytes: &[u8], max_chars: usize) -> String {
    // Four bytes a character is UTF-8's most, so nothing that would be shown is cut off here.
    let text = String::from_utf8_lossy(&bytes[..bytes.len().min(4 * (max_chars + 1))]);
    let printable = |c: char| if c.is_control() { char::REPLACEMENT_CHARACTER } else { c };
    let mut shown: String = text.chars().take(max_chars).map(printable).collect();
    if text.chars().nth(max_chars).is_some() {
        shown.push('…');
    }
    shown
}

/// Names in backquotes, separated by commas; "no columns" if there are none.
pub(crate) fn list<'a>(names: impl ExactSizeIterator<Item = &'a str>) -> String {
    let total = names.len();
    let shown: Vec<_> = names.take(MAX_NAMES).map(|name| format!("`{}`", excerpt(name.as_bytes()))).collect();
    match total {
        0 => "no columns".to_owned(),
        _ if total > MAX_NAMES => format!("{} and {} more", shown.join(", "), total - MAX_NAMES),
        _ => shown.join(", "),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_excerpt_is_short_and_printable() {
        assert_eq!(excerpt(b"0.25"), "0.25");
        assert_eq!(excerpt(b"a\x1b[31mb\n"), "a\u{fffd}[31mb\u{fffd}");
        assert_eq!(excerpt(&[0xff; 3]), "\u{fffd}\u{fffd}\u{fffd}");
        assert_eq!(excerpt("é".repeat(1000).as_bytes()), "é".repeat(40) + "…");
    }

    #[test]
    fn a_list_names_the_first_and_counts_the_rest() {
        assert_eq!(list([].into_iter()), "no columns");
        assert_eq!(list(["a", "b"].into_iter()), "`a`, `b`");
        assert_eq!(list(["a"; 10].into_iter()), format!("{} and 2 more", ["`a`"; 8].join(", ")));
    }
}

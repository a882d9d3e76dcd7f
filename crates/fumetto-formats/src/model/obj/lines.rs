//! The statements of OBJ and MTL files: a keyword, then words.

use std::borrow::Cow;

/// A statement without its comments.
pub(super) struct Statement<'a> {
    /// The line, from 1, in which it starts.
    pub(super) line: u64,
    pub(super) keyword: Cow<'a, str>,
    /// What follows the keyword, without spaces around it.
    pub(super) rest: Cow<'a, str>,
}

/// The statements of a file. Those of other encodings than UTF-8 are read, too: they are in names only.
pub(super) fn statements(bytes: &[u8]) -> impl Iterator<Item = Statement<'_>> {
    let mut lines = bytes.split(|&byte| byte == b'\n').zip(1_u64..);
    std::iter::from_fn(move || {
        let (bytes, line) = lines.next()?;
        let mut bytes = Cow::Borrowed(bytes.trim_ascii_end());
        // A backslash joins two lines.
        while bytes.last() == Some(&b'\\') {
            let joined = bytes.to_mut();
            joined.pop();
            joined.push(b' ');
            let Some((next, _)) = lines.next() else { break };
            joined.extend(next.trim_ascii_end());
        }
        Some((bytes, line))
    })
    .filter_map(|(bytes, line)| match bytes {
        Cow::Borrowed(bytes) => {
            let (keyword, rest) = split(bytes)?;
            let text = String::from_utf8_lossy;
            Some(Statement { line, keyword: text(keyword), rest: text(rest) })
        }
        Cow::Owned(bytes) => {
            let (keyword, rest) = split(&bytes)?;
            let text = |bytes| Cow::Owned(String::from_utf8_lossy(bytes).into_owned());
            Some(Statement { line, keyword: text(keyword), rest: text(rest) })
        }
    })
}

/// A line's keyword and the rest of it, unless it is empty or a comment.
fn split(line: &[u8]) -> Option<(&[u8], &[u8])> {
    let line = line.trim_ascii();
    if line.is_empty() || line[0] == b'#' {
        return None;
    }
    let end = line.iter().position(u8::is_ascii_whitespace).unwrap_or(line.len());
    Some((&line[..end], line[end..].trim_ascii()))
}

/// The numbers that `words` start with; a comment may follow them.
pub(super) fn numbers(words: &str) -> Vec<f32> {
    words.split_ascii_whitespace().map_while(|word| word.parse().ok()).collect()
}

/// The linear value of an sRGB one (IEC 61966-2-1), clamped to what a screen shows.
pub(super) fn linear(srgb: f32) -> f32 {
    let srgb = srgb.clamp(0.0, 1.0);
    if srgb <= 0.04045 { srgb / 12.92 } else { ((srgb + 0.055) / 1.055).powf(2.4) }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn statements_know_their_line() {
        let text = b"# c\r\n\r\n v 1 2\t3 \r\nf 1 \\\r\n2 3\ng caf\xe9\nlast\\";
        let all: Vec<_> = statements(text)
            .map(|statement| (statement.line, statement.keyword.into_owned(), statement.rest.into_owned()))
            .collect();
        let expected = [(3, "v", "1 2\t3"), (4, "f", "1  2 3"), (6, "g", "caf\u{fffd}"), (7, "last", "")];
        let expected: Vec<_> =
            expected.into_iter().map(|(line, word, rest)| (line, word.to_owned(), rest.to_owned())).collect();
        assert_eq!(all, expected);
    }

    #[test]
    fn srgb_becomes_linear() {
        assert_eq!(linear(0.0), 0.0);
        assert_eq!(linear(1.0), 1.0);
        assert!((linear(188.0 / 255.0) - 0.5029).abs() < 1e-4);
    }
}

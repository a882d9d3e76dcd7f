//! What programs call things: ids that are the same in every frame, and no two alike.

use std::collections::BTreeMap;

/// Ids that one document has used.
#[derive(Debug, Default)]
pub(super) struct Ids {
    used: BTreeMap<String, u32>,
}

impl Ids {
    /// The id of what is called `name` in what has the id `above`.
    pub(super) fn id(&mut self, above: &str, name: &str) -> String {
        let slug = slug(name);
        let id = if above.is_empty() { slug } else { format!("{above}-{slug}") };
        // An id begins with a letter.
        let id =
            if id.starts_with(|first: char| first.is_ascii_alphabetic()) { id } else { format!("n{id}") };
        let count = self.used.entry(id.clone()).or_default();
        *count += 1;
        if *count == 1 {
            return id;
        }
        let numbered = format!("{id}_{count}");
        self.used.entry(numbered.clone()).or_insert(1);
        numbered
    }
}

/// Letters and digits of ASCII, in lower case; all else by its number.
fn slug(name: &str) -> String {
    let mut slug = String::new();
    for letter in name.chars() {
        match letter {
            'a'..='z' | '0'..='9' => slug.push(letter),
            'A'..='Z' => slug.push(letter.to_ascii_lowercase()),
            ' ' | '-' | '_' | '.' | '#' => slug.push('-'),
            _ => slug.push_str(&format!("u{:x}", u32::from(letter))),
        }
    }
    let trimmed = slug.trim_matches('-');
    if trimmed.is_empty() { "unnamed".to_owned() } else { trimmed.to_owned() }
}

/// A name as XML may hold it: other characters than these cannot even be escaped (XML 1.0, section 2.2).
pub(super) fn printable(name: &str) -> String {
    let allowed = |letter: char| matches!(letter, '\t' | '\n' | '\r' | ' '..='\u{d7ff}' | '\u{e000}'..='\u{fffd}' | '\u{10000}'..);
    name.chars().map(|letter| if allowed(letter) { letter } else { '\u{fffd}' }).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ids_are_plain_and_no_two_alike() {
        let mut ids = Ids::default();
        assert_eq!(ids.id("", "Big cloud"), "big-cloud");
        assert_eq!(ids.id("", "big-cloud"), "big-cloud_2");
        assert_eq!(ids.id("", "big cloud_2"), "big-cloud-2");
        assert_eq!(ids.id("lines", "雲"), "lines-u96f2");
        assert_eq!(ids.id("", "7 \"><&"), "n7-u22u3eu3cu26");
        assert_eq!(ids.id("", ""), "unnamed");
    }

    #[test]
    fn what_xml_cannot_hold_is_replaced() {
        assert_eq!(printable("a\0b\u{b}<\u{ffff}"), "a\u{fffd}b\u{fffd}<\u{fffd}");
    }
}

use std::str::FromStr;

/// A key of the scene and its new value, as TOML; what they mean is the scene's business.
#[derive(Clone, Debug, Eq, PartialEq)]
pub(crate) struct Setting {
    pub(crate) path: String,
    pub(crate) value: String,
}

impl FromStr for Setting {
    type Err = String;

    fn from_str(text: &str) -> Result<Self, String> {
        match text.split_once('=') {
            Some((path, value)) if !path.trim().is_empty() => {
                Ok(Self { path: path.trim().to_owned(), value: value.trim().to_owned() })
            }
            _ => Err("write a key, `=` and its value, as in camera.fov=30".to_owned()),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_first_equals_sign_divides() {
        let setting = Setting { path: "style.ink".into(), value: "{ on = false }".into() };
        assert_eq!("style.ink={ on = false }".parse(), Ok(setting.clone()));
        assert_eq!("style.ink = { on = false }".parse(), Ok(setting));
    }

    #[test]
    fn a_setting_needs_a_key() {
        assert!("camera.fov".parse::<Setting>().is_err());
        assert!("=3".parse::<Setting>().is_err());
    }
}

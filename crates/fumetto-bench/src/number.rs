//! Numbers as people read and write them.

/// A size such as `300`, `20k` or `1M`.
pub(crate) fn parse_size(text: &str) -> Result<u32, String> {
    let (digits, factor) = match text.as_bytes().last() {
        Some(b'k') => (&text[..text.len() - 1], 1_000),
        Some(b'M') => (&text[..text.len() - 1], 1_000_000),
        _ => (text, 1),
    };
    let size = digits.parse::<u32>().ok().and_then(|number| number.checked_mul(factor));
    size.filter(|size| *size > 0).ok_or_else(|| "write a number above 0, such as 300, 20k or 1M".to_owned())
}

/// With commas between thousands.
pub(crate) fn thousands(number: u32) -> String {
    let digits = number.to_string();
    let mut text = String::new();
    for (index, digit) in digits.chars().enumerate() {
        if index > 0 && (digits.len() - index).is_multiple_of(3) {
            text.push(',');
        }
        text.push(digit);
    }
    text
}

/// Milliseconds to three digits, which is more than repeats from run to run.
pub(crate) fn millis(value: f64) -> String {
    let decimals = match value {
        ..9.995 => 2,
        ..99.95 => 1,
        _ => 0,
    };
    format!("{value:.decimals$}")
}

/// The `p` in `time ~ size^p` between two measurements: 0 is constant, 1 linear, 2 quadratic.
pub(crate) fn growth_exponent(small: (u32, f64), large: (u32, f64)) -> f64 {
    (large.1 / small.1).ln() / (f64::from(large.0) / f64::from(small.0)).ln()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn growth_exponents_tell_constant_linear_and_quadratic_apart() {
        let close = |a: f64, b: f64| (a - b).abs() < 1e-12;
        assert!(close(growth_exponent((1_000, 3.0), (5_000, 3.0)), 0.0));
        assert!(close(growth_exponent((1_000, 3.0), (5_000, 15.0)), 1.0));
        assert!(close(growth_exponent((1_000, 3.0), (10_000, 300.0)), 2.0));
        assert!(close(growth_exponent((100, 8.0), (400, 4.0)), -0.5));
    }

    #[test]
    fn sizes_may_end_in_k_or_m() {
        assert_eq!(parse_size("300"), Ok(300));
        assert_eq!(parse_size("20k"), Ok(20_000));
        assert_eq!(parse_size("1M"), Ok(1_000_000));
        for wrong in ["", "k", "0", "-1", "1.5k", "9000M", "1 k", "é"] {
            assert!(parse_size(wrong).is_err(), "{wrong:?}");
        }
    }

    #[test]
    fn thousands_are_set_apart() {
        assert_eq!(
            [1, 999, 1_000, 20_000, 1_000_000].map(thousands),
            ["1", "999", "1,000", "20,000", "1,000,000"]
        );
    }

    #[test]
    fn milliseconds_have_three_digits() {
        assert_eq!(
            [0.1234, 9.996, 12.34, 99.96, 1234.5].map(millis),
            ["0.12", "10.0", "12.3", "100", "1234"]
        );
    }
}

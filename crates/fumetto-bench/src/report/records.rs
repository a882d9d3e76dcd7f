//! The figures for programs: one line for each variant and size.

use super::Report;
use crate::measure::Made;

/// The whole report as CSV.
pub(super) fn csv(report: &Report) -> anyhow::Result<Vec<u8>> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    writer.write_record([
        "subsystem",
        "variant",
        "size",
        "median_ms",
        "min_ms",
        "runs",
        "triangles",
        "bytes",
        "adapter",
    ])?;
    for table in &report.tables {
        for row in &table.rows {
            for (variant, samples) in table.variants.iter().zip(&row.samples) {
                let made = |count: fn(&Made) -> u64| {
                    samples.made.as_ref().map_or_else(String::new, |made| count(made).to_string())
                };
                writer.write_record([
                    table.subsystem.name,
                    variant,
                    &row.size.to_string(),
                    &format!("{:.4}", samples.median_ms()),
                    &format!("{:.4}", samples.min_ms()),
                    &samples.runs().to_string(),
                    &made(|made| made.triangles.into()),
                    &made(|made| made.bytes),
                    &report.adapter,
                ])?;
            }
        }
    }
    Ok(writer.into_inner()?)
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;
    use crate::report::tests::report;

    #[test]
    fn every_variant_and_size_is_a_line() {
        let text = String::from_utf8(csv(&report()).unwrap()).unwrap();
        let lines: Vec<_> = text.lines().collect();
        assert_eq!(lines.len(), 5);
        assert_eq!(lines[0], "subsystem,variant,size,median_ms,min_ms,runs,triangles,bytes,adapter");
        assert_eq!(lines[3], "draw,body,10000,20.0000,20.0000,1,,,\"Card, of cards\"");
    }
}

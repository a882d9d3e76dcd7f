//! The figures at a glance: milliseconds against size, both logarithmic, where a power law is a straight
//! line and its exponent the slope.

use std::ops::Range;

use anyhow::anyhow;
use plotters::{chart::SeriesLabelPosition, prelude::*};

use super::Table;
use crate::number::{millis, thousands};

/// Okabe and Ito's colours, which colour-blind readers can tell apart too, less the yellow that is too
/// pale for lines.
const COLOURS: [RGBColor; 7] = [
    RGBColor(0, 0, 0),
    RGBColor(0, 114, 178),
    RGBColor(213, 94, 0),
    RGBColor(0, 158, 115),
    RGBColor(204, 121, 167),
    RGBColor(86, 180, 233),
    RGBColor(230, 159, 0),
];

type Points = Vec<(f64, f64)>;

/// A plot of a table with at least one row.
pub(super) fn svg(table: &Table, adapter: &str) -> anyhow::Result<String> {
    let mut text = String::new();
    // plotters' error types borrow from the backend; only their words are wanted.
    draw(&mut text, table, adapter).map_err(|error| anyhow!("the plot cannot be drawn: {error}"))?;
    Ok(text)
}

fn draw(text: &mut String, table: &Table, adapter: &str) -> Result<(), Box<dyn std::error::Error>> {
    let lines: Vec<_> = (0..table.variants.len()).map(|variant| points(table, variant)).collect();
    let all = || lines.iter().flatten();
    let (sizes, times) = (span(all().map(|point| point.0)), span(all().map(|point| point.1)));

    let root = SVGBackend::with_string(text, (960, 640)).into_drawing_area();
    root.fill(&WHITE)?;
    let mut chart = ChartBuilder::on(&root)
        .caption(format!("{}: {}", table.subsystem.name, adapter), ("sans-serif", 18))
        .margin(16)
        .x_label_area_size(44)
        .y_label_area_size(64)
        .build_cartesian_2d(sizes.clone().log_scale(), times.clone().log_scale())?;
    chart
        .configure_mesh()
        .max_light_lines(1)
        .x_desc(table.subsystem.counted)
        .y_desc("milliseconds")
        .x_label_formatter(&|size| thousands(*size as u32))
        .y_label_formatter(&|ms| millis(*ms))
        .draw()?;

    let guide = linear_guide(&lines, sizes.end, times.end);
    chart.draw_series(DashedLineSeries::new(guide, 4, 4, BLACK.mix(0.4).stroke_width(1)))?;
    for ((line, name), colour) in lines.iter().zip(&table.variants).zip(COLOURS.into_iter().cycle()) {
        chart
            .draw_series(LineSeries::new(line.iter().copied(), colour.stroke_width(2)).point_size(3))?
            .label(*name)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 20, y)], colour.stroke_width(2)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::LowerRight)
        .background_style(WHITE.mix(0.85))
        .border_style(BLACK.mix(0.3))
        .draw()?;
    root.present()?;
    Ok(())
}

fn points(table: &Table, variant: usize) -> Points {
    table.rows.iter().map(|row| (f64::from(row.size), row.samples[variant].median_ms())).collect()
}

/// From below the least to above the greatest, so that no point sits on the frame.
fn span(values: impl Iterator<Item = f64> + Clone) -> Range<f64> {
    let least = values.clone().fold(f64::INFINITY, f64::min);
    let greatest = values.fold(0.0, f64::max);
    least / 1.3..greatest * 1.3
}

/// Linear growth from the dearest variant's first point to where it leaves the plot: lines that are no
/// steeper grow no faster.
fn linear_guide(lines: &[Points], last_size: f64, most_ms: f64) -> Points {
    let firsts = lines.iter().filter_map(|line| line.first());
    let Some(&(size, ms)) = firsts.max_by(|a, b| a.1.total_cmp(&b.1)) else { return Vec::new() };
    // plotters would bend a line that leaves the plot along its edge.
    let factor = (last_size / size).min(most_ms / ms);
    vec![(size, ms), (size * factor, ms * factor)]
}

#[cfg(test)]
mod tests {
    #![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

    use super::*;
    use crate::report::tests::report;

    #[test]
    fn a_plot_names_variants_and_axes() {
        let text = svg(&report().tables[0], "Some Card").unwrap();
        for word in ["Some Card", "puffs", "milliseconds", "body", "body+ink", "1,000", "10,000"] {
            assert!(text.contains(word), "{word}");
        }
    }

    #[test]
    fn the_guide_is_linear_and_stays_inside() {
        let lines = [vec![(10.0, 1.0), (1000.0, 2.0)], vec![(10.0, 4.0), (1000.0, 40.0)]];
        assert_eq!(linear_guide(&lines, 1000.0, 40.0), [(10.0, 4.0), (100.0, 40.0)]);
        assert_eq!(linear_guide(&lines, 50.0, 40.0), [(10.0, 4.0), (50.0, 20.0)]);
    }

    #[test]
    fn one_size_is_enough_for_a_plot() {
        let mut report = report();
        report.tables[0].rows.truncate(1);
        assert!(svg(&report.tables[0], "Some Card").unwrap().contains("polyline"));
    }
}

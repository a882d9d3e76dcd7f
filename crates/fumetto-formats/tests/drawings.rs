//! Drawings as SVG and PDF, read by a reader that others use.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use fumetto_formats::{Drawing, Folder, Image, Item, Paper, Shape, write_animated_svg, write_pdf, write_svg};
use kurbo::{Circle, Rect};
use proptest::prelude::*;
use resvg::{tiny_skia, usvg};

fn shape(name: &str, outline: &impl kurbo::Shape, colour: [u8; 3]) -> Shape {
    Shape { name: name.to_owned(), path: outline.to_path(0.01), colour, opacity: 1.0, stroke_px: None }
}

/// A red square with a blue disc on it, in a layer that is half transparent.
fn drawing(name: &str) -> Drawing {
    let mut group = Folder::group(name);
    group.items.push(Item::Shape(shape("square", &Rect::new(10.0, 10.0, 30.0, 30.0), [255, 0, 0])));
    group.items.push(Item::Shape(shape(name, &Circle::new((20.0, 20.0), 5.0), [0, 0, 255])));
    let mut layer = Folder::layer("tones");
    layer.opacity = 0.5;
    layer.items.push(Item::Folder(group));
    Drawing { size_px: [40, 40], width_mm: None, paper: Paper::Colour([255; 3]), layers: vec![layer] }
}

fn svg(drawing: &Drawing) -> String {
    let mut bytes = Vec::new();
    write_svg(drawing, &mut bytes).unwrap();
    String::from_utf8(bytes).unwrap()
}

fn rendered(svg: &str) -> tiny_skia::Pixmap {
    let tree = usvg::Tree::from_str(svg, &usvg::Options::default()).unwrap();
    let size = tree.size().to_int_size();
    let mut pixels = tiny_skia::Pixmap::new(size.width(), size.height()).unwrap();
    resvg::render(&tree, tiny_skia::Transform::identity(), &mut pixels.as_mut());
    pixels
}

fn pixel(pixels: &tiny_skia::Pixmap, x: u32, y: u32) -> [u8; 3] {
    let pixel = pixels.pixel(x, y).unwrap();
    [pixel.red(), pixel.green(), pixel.blue()]
}

#[test]
fn shapes_of_one_folder_do_not_show_through_each_other() {
    let pixels = rendered(&svg(&drawing("cloud")));
    assert_eq!(pixel(&pixels, 5, 5), [255; 3]);
    assert_eq!(pixel(&pixels, 12, 12), [255, 128, 128]);
    assert_eq!(pixel(&pixels, 20, 20), [128, 128, 255]);
}

#[test]
fn layers_are_inkscapes() {
    let svg = svg(&drawing("cloud"));
    for says in [
        r#"id="tones" inkscape:groupmode="layer" inkscape:label="tones" opacity="0.5""#,
        r#"id="tones-cloud" inkscape:label="cloud""#,
        r##"id="tones-cloud-square" inkscape:label="square" fill="#ff0000" d="m10 10"##,
    ] {
        assert!(svg.contains(says), "{says} is not in {svg}");
    }
}

#[test]
fn sizes_are_in_millimetres_where_asked_for() {
    let svg = svg(&Drawing { width_mm: Some(210.0), size_px: [400, 300], ..drawing("a") });
    assert!(svg.contains(r#"width="210mm" height="157.5mm" viewBox="0 0 400 300""#), "{svg}");
}

#[test]
fn papers_lie_behind() {
    let gradient = Paper::Gradient((0..=16).map(|step| [step * 15, 0, 0]).collect());
    let pixels = rendered(&svg(&Drawing { paper: gradient, layers: Vec::new(), ..drawing("a") }));
    let column: Vec<u8> = (0..40).map(|y| pixel(&pixels, 20, y)[0]).collect();
    assert!(column.is_sorted() && column[0] < 8 && column[39] > 230, "{column:?}");
    let image = Image { width: 1, height: 1, pixels: vec![10, 20, 30, 255] };
    let drawing = Drawing { paper: Paper::Image(image), layers: Vec::new(), ..drawing("a") };
    let text = svg(&drawing);
    assert!(text.contains("data:image/png;base64,") && text.contains("xMidYMid slice"), "{text}");
    assert!(!svg(&Drawing { paper: Paper::Clear, ..drawing }).contains("paper"));
}

#[test]
fn frames_take_turns() {
    let mut bytes = Vec::new();
    let frames = [(3, drawing("a")), (4, drawing("a")), (5, drawing("a"))];
    write_animated_svg(&frames, 0.25, &mut bytes).unwrap();
    let svg = String::from_utf8(bytes).unwrap();
    assert_eq!(svg.matches("<animate ").count(), 3);
    for says in [
        r#"id="frame-0004" inkscape:groupmode="layer" inkscape:label="frame 0004" display="none""#,
        r#"keyTimes="0;0.33333;0.66667" values="none;inline;none" dur="0.75s""#,
        r#"id="frame-0005-tones-a-square""#,
    ] {
        assert!(svg.contains(says), "{says} is not in {svg}");
    }
    // A reader that knows no time shows the first.
    assert_eq!(pixel(&rendered(&svg), 20, 20), [128, 128, 255]);
    assert!(write_animated_svg(&[], 1.0, &mut Vec::new()).is_err());
}

#[test]
fn what_cannot_be_shown_is_refused() {
    let nowhere = |mut drawing: Drawing| {
        let broken = Rect::new(0.0, f64::NAN, 1.0, 1.0);
        drawing.layers[0].items.push(Item::Shape(shape("broken", &broken, [0; 3])));
        drawing
    };
    for bad in [
        Drawing { size_px: [0, 3], ..drawing("a") },
        Drawing { width_mm: Some(f64::NAN), ..drawing("a") },
        nowhere(drawing("a")),
    ] {
        assert!(write_svg(&bad, &mut Vec::new()).is_err());
        assert!(write_pdf(&[bad], &mut Vec::new()).is_err());
    }
    assert!(write_pdf(&[], &mut Vec::new()).is_err());
}

#[test]
fn a_pdf_has_a_page_for_each_drawing_and_lists_layers() {
    let mut bytes = Vec::new();
    let big = Drawing { width_mm: Some(127.0), ..drawing("cloud") };
    write_pdf(&[drawing("cloud"), big], &mut bytes).unwrap();
    let text = String::from_utf8_lossy(&bytes);
    assert!(text.starts_with("%PDF-") && text.trim_end().ends_with("%%EOF"));
    for says in
        ["/Count 2", "/MediaBox [0 0 30 30]", "/MediaBox [0 0 360 360]", "/Name (tones)", "/OCProperties"]
    {
        assert!(text.contains(says), "{says} is not in {text}");
    }
}

proptest! {
    #[test]
    fn any_name_gives_well_formed_xml(name in any::<String>()) {
        let svg = svg(&drawing(&name));
        prop_assert!(usvg::roxmltree::Document::parse(&svg).is_ok(), "{svg}");
        prop_assert!(usvg::Tree::from_str(&svg, &usvg::Options::default()).is_ok());
    }
}

//! SVG, with the layers that Inkscape knows.

use std::io::{self, Write};

use base64::{Engine as _, engine::general_purpose::STANDARD};
use quick_xml::{
    Writer,
    events::{BytesDecl, Event},
};

use super::{
    Drawing, Folder, Item, Paper, Shape,
    names::{Ids, printable},
    path_data::path_data,
};
use crate::{Image, WriteError, write_png};

/// Writes a drawing as SVG.
///
/// # Errors
/// When `out` refuses the bytes, or the drawing has a size or a path that cannot be shown.
pub fn write_svg(drawing: &Drawing, out: impl Write) -> Result<(), WriteError> {
    drawing.check()?;
    let mut sheet = Sheet::new(out)?;
    sheet.document(drawing, |sheet| drawing.layers.iter().try_for_each(|layer| sheet.folder("", layer)))?;
    Ok(())
}

/// Writes drawings as one SVG that shows them in turn, over and over, each for as many seconds. Each is a layer
/// with the number beside it; paper and size are the first's.
///
/// # Errors
/// As [`write_svg`], and when there is no drawing or no time to show one.
pub fn write_animated_svg(frames: &[(u32, Drawing)], secs: f64, out: impl Write) -> Result<(), WriteError> {
    let Some((_, first)) = frames.first().filter(|_| secs > 0.0 && secs.is_finite()) else {
        return Err(WriteError::Drawing { problem: "there is no drawing in it, or no time to show one" });
    };
    frames.iter().try_for_each(|(_, drawing)| drawing.check())?;
    let mut sheet = Sheet::new(out)?;
    sheet.document(first, |sheet| {
        (0..).zip(frames).try_for_each(|(index, (number, drawing))| {
            sheet.frame((*number, drawing), (index, frames.len()), secs)
        })
    })?;
    Ok(())
}

/// A document that is being written.
struct Sheet<W: Write> {
    writer: Writer<W>,
    ids: Ids,
}

impl<W: Write> Sheet<W> {
    fn new(out: W) -> io::Result<Self> {
        let mut writer = Writer::new_with_indent(out, b' ', 1);
        writer.write_event(Event::Decl(BytesDecl::new("1.0", Some("UTF-8"), None)))?;
        Ok(Self { writer, ids: Ids::default() })
    }

    fn open(&mut self, element: &str, attributes: &[(&str, String)]) -> io::Result<()> {
        let named = attributes.iter().map(|(name, value)| (*name, value.as_str()));
        let start = quick_xml::events::BytesStart::new(element).with_attributes(named);
        self.writer.write_event(Event::Start(start))
    }

    fn close(&mut self, element: &str) -> io::Result<()> {
        self.writer.write_event(Event::End(quick_xml::events::BytesEnd::new(element)))
    }

    fn empty(&mut self, element: &str, attributes: &[(&str, String)]) -> io::Result<()> {
        let named = attributes.iter().map(|(name, value)| (*name, value.as_str()));
        self.writer.create_element(element).with_attributes(named).write_empty().map(drop)
    }

    /// The root with the paper, and what `fill` adds.
    fn document(
        &mut self,
        drawing: &Drawing,
        fill: impl FnOnce(&mut Self) -> io::Result<()>,
    ) -> Result<(), WriteError> {
        let [width, height] = drawing.size_px;
        let length = |px: u32| match drawing.width_mm {
            Some(_) => format!("{}mm", rounded(f64::from(px) / drawing.px_a_mm())),
            None => px.to_string(),
        };
        self.open(
            "svg",
            &[
                ("xmlns", "http://www.w3.org/2000/svg".to_owned()),
                ("xmlns:inkscape", "http://www.inkscape.org/namespaces/inkscape".to_owned()),
                ("width", length(width)),
                ("height", length(height)),
                ("viewBox", format!("0 0 {width} {height}")),
            ],
        )?;
        self.paper(drawing)?;
        fill(self)?;
        self.close("svg")?;
        self.writer.get_mut().write_all(b"\n")?;
        Ok(())
    }

    fn paper(&mut self, drawing: &Drawing) -> Result<(), WriteError> {
        if drawing.paper == Paper::Clear {
            return Ok(());
        }
        let id = self.ids.id("", "paper");
        let [width, height] = drawing.size_px.map(|side| side.to_string());
        let size = [("width", width), ("height", height)];
        let rect = |fill: String| [&size[..], &[("fill", fill)]].concat();
        self.open("g", &layer_attributes(&id, "paper"))?;
        match &drawing.paper {
            Paper::Clear => {}
            Paper::Colour(colour) => self.empty("rect", &rect(hex(*colour)))?,
            Paper::Gradient(colours) => {
                let gradient = self.ids.id(&id, "gradient");
                self.gradient(&gradient, colours)?;
                self.empty("rect", &rect(format!("url(#{gradient})")))?;
            }
            Paper::Image(image) => {
                let covers = ("preserveAspectRatio", "xMidYMid slice".to_owned());
                self.empty("image", &[&size[..], &[covers, ("href", data_url(image)?)]].concat())?;
            }
        }
        Ok(self.close("g")?)
    }

    /// From the top edge to the bottom edge.
    fn gradient(&mut self, id: &str, colours: &[[u8; 3]]) -> io::Result<()> {
        let end = |name, value: &str| (name, value.to_owned());
        self.open(
            "linearGradient",
            &[("id", id.to_owned()), end("x1", "0"), end("y1", "0"), end("x2", "0"), end("y2", "1")],
        )?;
        for (index, colour) in colours.iter().enumerate() {
            let offset = rounded(index as f64 / (colours.len() - 1).max(1) as f64);
            self.empty("stop", &[("offset", offset), ("stop-color", hex(*colour))])?;
        }
        self.close("linearGradient")
    }

    fn folder(&mut self, above: &str, folder: &Folder) -> io::Result<()> {
        let id = self.ids.id(above, &folder.name);
        let mut attributes = if folder.is_layer {
            layer_attributes(&id, &folder.name)
        } else {
            vec![("id", id.clone()), ("inkscape:label", printable(&folder.name))]
        };
        if folder.opacity < 1.0 {
            attributes.push(("opacity", rounded(folder.opacity.into())));
        }
        self.open("g", &attributes)?;
        for item in &folder.items {
            match item {
                Item::Folder(folder) => self.folder(&id, folder)?,
                Item::Shape(shape) => self.shape(&id, shape)?,
            }
        }
        self.close("g")
    }

    fn shape(&mut self, above: &str, shape: &Shape) -> io::Result<()> {
        let id = self.ids.id(above, &shape.name);
        let mut attributes = vec![("id", id), ("inkscape:label", printable(&shape.name))];
        let opacity = |name| (shape.opacity < 1.0).then(|| (name, rounded(shape.opacity.into())));
        match shape.stroke_px {
            None => {
                attributes.push(("fill", hex(shape.colour)));
                attributes.extend(opacity("fill-opacity"));
            }
            Some(width) => {
                attributes.push(("fill", "none".to_owned()));
                attributes.push(("stroke", hex(shape.colour)));
                attributes.push(("stroke-width", rounded(width)));
                attributes.push(("stroke-linecap", "round".to_owned()));
                attributes.push(("stroke-linejoin", "round".to_owned()));
                attributes.extend(opacity("stroke-opacity"));
            }
        }
        attributes.push(("d", path_data(&shape.path)));
        self.empty("path", &attributes)
    }

    /// A drawing that is shown while it is its turn, the `index`-th of `count`. Where nothing moves, as on paper,
    /// the first is seen.
    fn frame(
        &mut self,
        (number, drawing): (u32, &Drawing),
        (index, count): (usize, usize),
        secs: f64,
    ) -> io::Result<()> {
        let name = format!("frame {number:04}");
        let id = self.ids.id("", &name);
        let mut attributes = layer_attributes(&id, &name);
        if index > 0 {
            attributes.push(("display", "none".to_owned()));
        }
        self.open("g", &attributes)?;
        if count > 1 {
            let at = |index: usize| rounded(index as f64 / count as f64);
            let (times, values) = match index {
                0 => (format!("0;{}", at(1)), "inline;none"),
                last if last + 1 == count => (format!("0;{}", at(index)), "none;inline"),
                _ => (format!("0;{};{}", at(index), at(index + 1)), "none;inline;none"),
            };
            self.empty(
                "animate",
                &[
                    ("attributeName", "display".to_owned()),
                    ("calcMode", "discrete".to_owned()),
                    ("keyTimes", times),
                    ("values", values.to_owned()),
                    ("dur", format!("{}s", rounded(secs * count as f64))),
                    ("repeatCount", "indefinite".to_owned()),
                ],
            )?;
        }
        drawing.layers.iter().try_for_each(|layer| self.folder(&id, layer))?;
        self.close("g")
    }
}

fn layer_attributes(id: &str, name: &str) -> Vec<(&'static str, String)> {
    vec![
        ("id", id.to_owned()),
        ("inkscape:groupmode", "layer".to_owned()),
        ("inkscape:label", printable(name)),
    ]
}

fn hex([r, g, b]: [u8; 3]) -> String {
    format!("#{r:02x}{g:02x}{b:02x}")
}

/// With five digits after the point at most.
fn rounded(number: f64) -> String {
    let text = format!("{number:.5}");
    text.trim_end_matches('0').trim_end_matches('.').to_owned()
}

fn data_url(image: &Image) -> Result<String, WriteError> {
    let mut png = Vec::new();
    write_png(image, &mut png)?;
    Ok(format!("data:image/png;base64,{}", STANDARD.encode(png)))
}

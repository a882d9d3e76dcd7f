//! PDF: a page for each drawing, with the layers that viewers list.

mod marks;
mod resources;

use std::io::Write;

use flate2::{Compression, write::ZlibEncoder};
use pdf_writer::{Content, Filter, Finish as _, Name, Pdf, Rect, Ref, TextStr, types::FunctionShadingType};

use self::{marks::draw, resources::Resources};
use super::{Drawing, Folder, Item, Paper, names::printable};
use crate::{Image, WriteError};

/// Points of PDF to a millimetre.
const POINTS_A_MM: f64 = 72.0 / 25.4;

/// Writes drawings as the pages of a PDF.
///
/// # Errors
/// When `out` refuses the bytes, when there is no drawing, or one has a size or a path that cannot be shown.
pub fn write_pdf(pages: &[Drawing], mut out: impl Write) -> Result<(), WriteError> {
    if pages.is_empty() {
        return Err(WriteError::Drawing { problem: "there is no drawing in it" });
    }
    pages.iter().try_for_each(Drawing::check)?;
    let mut book = Book { pdf: Pdf::new(), next: Ref::new(1), layers: Vec::new() };
    let [catalog, tree] = [book.reference(), book.reference()];
    let mut kids = Vec::with_capacity(pages.len());
    for drawing in pages {
        kids.push(book.page(drawing, tree)?);
    }
    book.pdf.pages(tree).kids(kids.iter().copied()).count(kids.len() as i32);
    book.catalog(catalog, tree);
    out.write_all(&book.pdf.finish())?;
    Ok(())
}

/// A document that is being written.
struct Book {
    pdf: Pdf,
    next: Ref,
    /// Optional content groups: what viewers call layers.
    layers: Vec<Ref>,
}

impl Book {
    fn reference(&mut self) -> Ref {
        self.next.bump()
    }

    fn catalog(&mut self, id: Ref, tree: Ref) {
        let mut catalog = self.pdf.catalog(id);
        catalog.pages(tree);
        let mut properties = catalog.insert(Name(b"OCProperties")).dict();
        properties.insert(Name(b"OCGs")).array().items(self.layers.iter().copied());
        let mut shown = properties.insert(Name(b"D")).dict();
        shown.insert(Name(b"Order")).array().items(self.layers.iter().copied());
    }

    fn page(&mut self, drawing: &Drawing, tree: Ref) -> Result<Ref, WriteError> {
        let points_a_px = POINTS_A_MM / drawing.px_a_mm();
        let [width, height] = drawing.size_px.map(|side| (f64::from(side) * points_a_px) as f32);
        let mut content = Content::new();
        let mut resources = Resources::default();
        // PDF counts from the bottom.
        content.transform([points_a_px as f32, 0.0, 0.0, -points_a_px as f32, 0.0, height]);
        self.paper(drawing, &mut content, &mut resources)?;
        for layer in &drawing.layers {
            self.folder(layer, drawing.size_px, &mut content, &mut resources)?;
        }
        let [page, body] = [self.reference(), self.reference()];
        let packed = packed(&content.finish())?;
        self.pdf.stream(body, &packed).filter(Filter::FlateDecode);
        let mut dict = self.pdf.page(page);
        dict.parent(tree).media_box(Rect::new(0.0, 0.0, width, height)).contents(body);
        resources.write(dict.resources());
        dict.finish();
        Ok(page)
    }

    fn paper(
        &mut self,
        drawing: &Drawing,
        content: &mut Content,
        resources: &mut Resources,
    ) -> Result<(), WriteError> {
        let [width, height] = drawing.size_px.map(|side| side as f32);
        match &drawing.paper {
            Paper::Clear => {}
            Paper::Colour(colour) => {
                let [r, g, b] = colour.map(|channel| f32::from(channel) / 255.0);
                content.set_fill_rgb(r, g, b).rect(0.0, 0.0, width, height).fill_nonzero();
            }
            Paper::Gradient(colours) => {
                let shading = self.gradient(colours, height);
                resources.shading = Some(shading);
                content.save_state().rect(0.0, 0.0, width, height).clip_nonzero().end_path();
                content.shading(Name(b"Paper")).restore_state();
            }
            Paper::Image(image) => {
                let object = self.image(image)?;
                let name = resources.object(object);
                // As much of it as covers the paper; its own square counts from the bottom.
                let (w, h) = (image.width as f32, image.height as f32);
                let scale = (width / w).max(height / h);
                let (left, bottom) = (0.5 * (width - scale * w), 0.5 * (height + scale * h));
                content.save_state().rect(0.0, 0.0, width, height).clip_nonzero().end_path();
                content.transform([scale * w, 0.0, 0.0, -scale * h, left, bottom]);
                content.x_object(Name(name.as_bytes())).restore_state();
            }
        }
        Ok(())
    }

    /// Colours at equal distances from the top to the bottom, as a table.
    fn gradient(&mut self, colours: &[[u8; 3]], height: f32) -> Ref {
        let [shading, table] = [self.reference(), self.reference()];
        let mut function = self.pdf.sampled_function(table, colours.as_flattened());
        function.domain([0.0, 1.0]).range([0.0, 1.0, 0.0, 1.0, 0.0, 1.0]);
        function.size([colours.len() as i32]).bits_per_sample(8);
        function.finish();
        let mut dict = self.pdf.function_shading(shading);
        dict.shading_type(FunctionShadingType::Axial).color_space().device_rgb();
        dict.coords([0.0, 0.0, 0.0, height]).function(table).extend([true, true]).finish();
        shading
    }

    /// Without its transparency: there is nothing below paper.
    fn image(&mut self, image: &Image) -> Result<Ref, WriteError> {
        let rgb: Vec<u8> =
            image.pixels.chunks_exact(4).flat_map(|rgba| [rgba[0], rgba[1], rgba[2]]).collect();
        let id = self.reference();
        let packed = packed(&rgb)?;
        let mut object = self.pdf.image_xobject(id, &packed);
        object.filter(Filter::FlateDecode);
        object.width(image.width as i32).height(image.height as i32);
        object.color_space().device_rgb();
        object.bits_per_component(8).finish();
        Ok(id)
    }

    /// What is transparent as one is a group of its own, so that its parts do not show through each other.
    fn folder(
        &mut self,
        folder: &Folder,
        size_px: [u32; 2],
        content: &mut Content,
        resources: &mut Resources,
    ) -> Result<(), WriteError> {
        if folder.is_layer {
            let layer = self.reference();
            self.pdf
                .indirect(layer)
                .dict()
                .pair(Name(b"Type"), Name(b"OCG"))
                .pair(Name(b"Name"), TextStr(&printable(&folder.name)));
            self.layers.push(layer);
            let name = resources.layer(layer);
            content.begin_marked_content_with_properties(Name(b"OC")).properties_named(Name(name.as_bytes()));
        }
        if folder.opacity < 1.0 {
            let (mut inner, mut named) = (Content::new(), Resources::default());
            self.items(folder, size_px, &mut inner, &mut named)?;
            let group = self.group(inner, &named, size_px)?;
            let state = self.opacity(folder.opacity, resources);
            let object = resources.object(group);
            content.save_state().set_parameters(Name(state.as_bytes()));
            content.x_object(Name(object.as_bytes())).restore_state();
        } else {
            self.items(folder, size_px, content, resources)?;
        }
        if folder.is_layer {
            content.end_marked_content();
        }
        Ok(())
    }

    fn items(
        &mut self,
        folder: &Folder,
        size_px: [u32; 2],
        content: &mut Content,
        resources: &mut Resources,
    ) -> Result<(), WriteError> {
        for item in &folder.items {
            match item {
                Item::Folder(folder) => self.folder(folder, size_px, content, resources)?,
                Item::Shape(shape) if shape.opacity < 1.0 => {
                    let state = self.opacity(shape.opacity, resources);
                    content.save_state().set_parameters(Name(state.as_bytes()));
                    draw(shape, content);
                    content.restore_state();
                }
                Item::Shape(shape) => draw(shape, content),
            }
        }
        Ok(())
    }

    /// The name of an opacity in `resources`.
    fn opacity(&mut self, opacity: f32, resources: &mut Resources) -> String {
        resources.state(opacity, || {
            let id = self.next.bump();
            self.pdf.ext_graphics(id).non_stroking_alpha(opacity).stroking_alpha(opacity);
            id
        })
    }

    /// A transparency group of what is drawn by `content`.
    fn group(&mut self, content: Content, named: &Resources, size_px: [u32; 2]) -> Result<Ref, WriteError> {
        let id = self.reference();
        let packed = packed(&content.finish())?;
        let [width, height] = size_px.map(|side| side as f32);
        let mut object = self.pdf.form_xobject(id, &packed);
        object.filter(Filter::FlateDecode);
        object.bbox(Rect::new(0.0, 0.0, width, height));
        object.group().transparency().isolated(true).color_space().device_rgb();
        named.write(object.resources());
        object.finish();
        Ok(id)
    }
}

fn packed(bytes: &[u8]) -> Result<Vec<u8>, WriteError> {
    let mut encoder = ZlibEncoder::new(Vec::new(), Compression::default());
    encoder.write_all(bytes)?;
    Ok(encoder.finish()?)
}

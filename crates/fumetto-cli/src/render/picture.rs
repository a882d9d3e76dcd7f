use std::fs::File;
use std::io;
use std::path::Path;

use fumetto::Print;
use fumetto_formats::{Image, WriteError, write_png, write_png_bands};

use fumetto_disk::{self as disk, Draft};

/// A picture on its way into a file.
pub(crate) enum Picture {
    Drawn(Image),
    /// Too large to be drawn at once, or to be held.
    Tiles(Box<Print>),
    /// It has been written to this file.
    Written(String),
}

/// Draws the next tile of a print; answers with rows that are complete.
pub(crate) type DrawTile<'a> = &'a mut dyn FnMut(&mut Print) -> anyhow::Result<Option<Image>>;

impl Picture {
    /// Writes it to the file `name`. One of tiles is drawn only now; whether it is `opaque` has to be known
    /// before.
    pub(crate) fn write(
        &mut self,
        name: &str,
        (size, opaque): ([u32; 2], bool),
        draw_tile: DrawTile<'_>,
    ) -> anyhow::Result<()> {
        let path = Path::new(name);
        match self {
            Self::Drawn(image) => disk::write(path, |draft| write_png(image, draft)),
            Self::Written(earlier) => disk::write(path, |draft| copy(earlier, draft)),
            Self::Tiles(print) => {
                let mut draft = Draft::new(path)?;
                write_png_bands(size, opaque, &mut draft, || next_band(print, draw_tile)).map_err(
                    |error: anyhow::Error| match error.downcast::<WriteError>() {
                        Ok(error) => anyhow::Error::new(error).context(format!("cannot write {name}")),
                        Err(other) => other,
                    },
                )?;
                draft.publish()?;
                *self = Self::Written(name.to_owned());
                Ok(())
            }
        }
    }
}

fn next_band(print: &mut Print, draw_tile: DrawTile<'_>) -> anyhow::Result<Option<Image>> {
    while !print.is_done() {
        if let Some(band) = draw_tile(print)? {
            return Ok(Some(band));
        }
    }
    Ok(None)
}

fn copy(from: &str, to: &mut Draft) -> io::Result<()> {
    io::copy(&mut File::open(from)?, to).map(drop)
}

//! Numbers out of buffers (glTF 2.0, section 3.6.2).

use gltf_json::accessor::{ComponentType, sparse};
use gltf_json::validation::Checked;

use super::document::{Document, part};
use crate::FormatError;

/// Items of one kind, which were seen to lie within their buffers.
pub(super) struct Accessor<'a> {
    /// How many items there are.
    pub(super) count: usize,
    /// What the numbers of an item are.
    pub(super) component: ComponentType,
    /// How many numbers an item has; columns of matrices lie together without gaps, as none is read
    /// that would have them.
    pub(super) width: usize,
    normalised: bool,
    /// Without any, all numbers are zero.
    base: Option<Items<'a>>,
    sparse: Option<Sparse<'a>>,
}

/// Items at even distances.
struct Items<'a> {
    bytes: &'a [u8],
    stride: usize,
}

/// Items that stand for some of the base's.
struct Sparse<'a> {
    count: usize,
    /// Which ones, in increasing order.
    places: Items<'a>,
    place: ComponentType,
    items: Items<'a>,
}

impl<'a> Document<'a> {
    /// The accessor at `index`, which `element` needs.
    pub(super) fn accessor(&self, element: &str, index: usize) -> Result<Accessor<'_>, FormatError> {
        let json = self.root.accessors.get(index).ok_or_else(|| self.absent(element, "accessor", index))?;
        let (Checked::Valid(component), Checked::Valid(kind)) = (json.component_type, json.type_) else {
            let problem = format!("accessor {index} holds numbers of no known kind; export the model again");
            return Err(self.wrong(element, problem));
        };
        let count = usize::try_from(json.count.0).unwrap_or(usize::MAX);
        let component = component.0;
        let width = kind.multiplicity();
        let within = format!("{element}: accessor {index}");
        let base = match json.buffer_view {
            Some(view) => {
                let offset = json.byte_offset.unwrap_or_default().0;
                Some(self.items(&within, view.value(), offset, count, component.size() * width)?)
            }
            None => None,
        };
        // Items of no bytes have to be believed; a file that is worth its length does not claim more.
        if base.is_none() && json.count.0 > self.buffer_bytes() {
            let problem = format!(
                "it promises {} items without bytes for them, in a file whose buffers have {}; export the model again",
                json.count.0,
                self.buffer_bytes()
            );
            return Err(self.wrong(&within, problem));
        }
        let size = component.size() * width;
        let sparse = json.sparse.as_ref().map(|json| self.sparse(&within, json, count, size)).transpose()?;
        let normalised = json.normalized;
        Ok(Accessor { count, component, width, normalised, base, sparse })
    }

    /// `count` items of `size` bytes from `offset` in a buffer view, if the view holds so many.
    fn items(
        &self,
        element: &str,
        view: usize,
        offset: u64,
        count: usize,
        size: usize,
    ) -> Result<Items<'_>, FormatError> {
        let (bytes, stride) = self.view(element, view)?;
        let stride = stride.unwrap_or(size);
        if stride == 0 {
            return Err(
                self.wrong(element, format!("buffer view {view} has a stride of 0; export the model again"))
            );
        }
        let needed = match count {
            0 => Some(0),
            _ => {
                (count as u64 - 1).checked_mul(stride as u64).and_then(|bytes| bytes.checked_add(size as u64))
            }
        };
        let bytes = needed.and_then(|needed| part(bytes, offset, needed)).ok_or_else(|| {
            self.wrong(
                element,
                format!(
                    "it promises {count} items, but buffer view {view} holds only {}; the file is cut off or damaged, so \
                     export or copy it again",
                    room(bytes.len(), offset, stride, size)
                ),
            )
        })?;
        Ok(Items { bytes, stride })
    }

    fn sparse(
        &self,
        element: &str,
        json: &sparse::Sparse,
        total: usize,
        size: usize,
    ) -> Result<Sparse<'_>, FormatError> {
        let count = usize::try_from(json.count.0).unwrap_or(usize::MAX);
        let Checked::Valid(place) = json.indices.component_type else {
            return Err(
                self.wrong(element, "its sparse indices are of no known kind; export the model again")
            );
        };
        let place = place.0;
        let indices = &json.indices;
        let places =
            self.items(element, indices.buffer_view.value(), indices.byte_offset.0, count, place.size())?;
        let values = &json.values;
        let items = self.items(element, values.buffer_view.value(), values.byte_offset.0, count, size)?;
        self.take_items(element, count)?;
        let sparse = Sparse { count, places, place, items };
        let mut before = None;
        for i in 0..count {
            let place = sparse.place(i);
            if before.is_some_and(|before| place <= before) || place >= total {
                return Err(self.wrong(
                    element,
                    format!(
                        "its sparse index {place} does not follow the one before, or is past the last item; \
                         export the model again"
                    ),
                ));
            }
            before = Some(place);
        }
        Ok(sparse)
    }
}

/// How many items fit.
fn room(bytes: usize, offset: u64, stride: usize, size: usize) -> u64 {
    let left = (bytes as u64).saturating_sub(offset);
    left.checked_sub(size as u64).map_or(0, |left| left / stride as u64 + 1)
}

impl Accessor<'_> {
    /// Whether its items are of this kind.
    pub(super) fn is(&self, width: usize, components: &[ComponentType]) -> bool {
        self.width == width && components.contains(&self.component)
    }

    /// The first `N` numbers of an item: integers as what they stand for where they are normalised, as
    /// they are elsewhere, and 0 where the item has fewer.
    pub(super) fn vector<const N: usize>(&self, index: usize) -> [f32; N] {
        let item = self.item(index);
        let size = self.component.size();
        std::array::from_fn(|number| {
            let bytes = item.get(number * size..(number + 1) * size).filter(|_| number < self.width);
            bytes.map_or(0.0, |bytes| real(bytes, self.component, self.normalised))
        })
    }

    /// An item as a number of something.
    pub(super) fn index(&self, index: usize) -> u32 {
        whole(self.item(index), self.component)
    }

    fn item(&self, index: usize) -> &[u8] {
        let size = self.component.size() * self.width;
        let replaced = self.sparse.as_ref().and_then(|sparse| sparse.find(index));
        match (replaced, &self.base, &self.sparse) {
            (Some(at), _, Some(sparse)) => sparse.items.at(at, size),
            (_, Some(base), _) => base.at(index, size),
            _ => &[],
        }
    }
}

impl Items<'_> {
    fn at(&self, index: usize, size: usize) -> &[u8] {
        let start = index * self.stride;
        self.bytes.get(start..start + size).unwrap_or_default()
    }
}

impl Sparse<'_> {
    fn place(&self, i: usize) -> usize {
        whole(self.places.at(i, self.place.size()), self.place) as usize
    }

    /// Where the item for the base's at `index` is, if there is one.
    fn find(&self, index: usize) -> Option<usize> {
        let (mut low, mut high) = (0, self.count);
        while low < high {
            let middle = low.midpoint(high);
            if self.place(middle) < index { low = middle + 1 } else { high = middle }
        }
        (low < self.count && self.place(low) == index).then_some(low)
    }
}

/// An unsigned integer; 0 for bytes that are not there.
fn whole(bytes: &[u8], component: ComponentType) -> u32 {
    let read = match component {
        ComponentType::U8 => bytes.first().map(|&byte| u32::from(byte)),
        ComponentType::U16 => bytes.first_chunk().map(|&bytes| u32::from(u16::from_le_bytes(bytes))),
        ComponentType::U32 => bytes.first_chunk().map(|&bytes| u32::from_le_bytes(bytes)),
        ComponentType::I8 | ComponentType::I16 | ComponentType::F32 => None,
    };
    read.unwrap_or(0)
}

/// A number; integers are divided as glTF 2.0, section 3.6.2.2 has it, if they are normalised.
fn real(bytes: &[u8], component: ComponentType, normalised: bool) -> f32 {
    let (value, most) = match component {
        ComponentType::F32 => return bytes.first_chunk().map_or(0.0, |&bytes| f32::from_le_bytes(bytes)),
        ComponentType::I8 => {
            (bytes.first().map_or(0.0, |&byte| f32::from(byte.cast_signed())), f32::from(i8::MAX))
        }
        ComponentType::I16 => (
            bytes.first_chunk().map_or(0.0, |&bytes| f32::from(i16::from_le_bytes(bytes))),
            f32::from(i16::MAX),
        ),
        ComponentType::U8 => (whole(bytes, component) as f32, f32::from(u8::MAX)),
        ComponentType::U16 => (whole(bytes, component) as f32, f32::from(u16::MAX)),
        ComponentType::U32 => (whole(bytes, component) as f32, u32::MAX as f32),
    };
    if normalised { (value / most).max(-1.0) } else { value }
}

//! What the statements of an OBJ file add up to.

use glam::{Vec2, Vec3, Vec4};
use rustc_hash::FxHashMap;

use super::groups::{Corner, Group, Vertices};
use super::lines::{Statement, linear, numbers, statements};
use super::polygon::triangulate;
use crate::excerpt::{excerpt, list};
use crate::model::MAX_MODEL_TRIANGLES;
use crate::notes::Notes;
use crate::{FormatError, Position};

/// Statements that have nothing to say about what is drawn.
const SILENT: [&str; 9] =
    ["s", "mg", "lod", "bevel", "c_interp", "d_interp", "shadow_obj", "trace_obj", "vp"];

/// All shapes of a file.
pub(super) struct Shapes {
    pub(super) vertices: Vertices,
    pub(super) groups: Vec<Group>,
    /// The names of groups and materials.
    pub(super) names: Vec<String>,
    /// The material libraries that the file names.
    pub(super) libraries: Vec<String>,
}

impl Shapes {
    pub(super) fn read(file: &str, bytes: &[u8], notes: &mut Notes) -> Result<Self, FormatError> {
        let mut reader = Reader::new(file);
        for statement in statements(bytes) {
            reader.take(&statement)?;
        }
        reader.say(notes);
        let Reader { vertices, groups, names, libraries, .. } = reader;
        Ok(Self { vertices, groups, names: names.all, libraries: libraries.all })
    }
}

/// The state between statements.
struct Reader<'a> {
    file: &'a str,
    vertices: Vertices,
    groups: Vec<Group>,
    /// Where the group of a name and a material is.
    known: FxHashMap<(usize, Option<usize>), usize>,
    current: Option<usize>,
    names: Names,
    name: usize,
    material: Option<usize>,
    libraries: Names,
    triangles: u64,
    corners: Vec<Corner>,
    /// Faces with fewer than three corners, lines and points.
    left_out: usize,
    ignored: Vec<String>,
}

impl<'a> Reader<'a> {
    fn new(file: &'a str) -> Self {
        let mut names = Names::default();
        Self {
            file,
            name: names.place(""),
            names,
            vertices: Vertices::default(),
            groups: Vec::new(),
            known: FxHashMap::default(),
            current: None,
            material: None,
            libraries: Names::default(),
            triangles: 0,
            corners: Vec::new(),
            left_out: 0,
            ignored: Vec::new(),
        }
    }

    fn take(&mut self, statement: &Statement<'_>) -> Result<(), FormatError> {
        let rest = &*statement.rest;
        match &*statement.keyword {
            "v" => self.position(statement)?,
            "vt" => {
                let coordinates = numbers(rest);
                let [u, ref more @ ..] = coordinates[..] else { return Err(self.too_few(statement, 1)) };
                // OBJ counts from the bottom.
                self.vertices.uvs.push(Vec2::new(u, 1.0 - more.first().copied().unwrap_or(0.0)));
            }
            "vn" => {
                let normal = numbers(rest);
                let [x, y, z, ..] = normal[..] else { return Err(self.too_few(statement, 3)) };
                self.vertices.normals.push(Vec3::new(x, y, z));
            }
            "f" => self.face(statement)?,
            "o" | "g" => {
                self.name = self.names.place(rest);
                self.current = None;
            }
            "usemtl" => {
                self.material = Some(self.names.place(rest));
                self.current = None;
            }
            "mtllib" => {
                self.libraries.place(rest);
            }
            "l" | "p" => self.left_out += 1,
            keyword if SILENT.contains(&keyword) => {}
            keyword => {
                if self.ignored.len() < 10 && !self.ignored.iter().any(|other| other == keyword) {
                    self.ignored.push(keyword.to_owned());
                }
            }
        }
        Ok(())
    }

    fn position(&mut self, statement: &Statement<'_>) -> Result<(), FormatError> {
        let values = numbers(&statement.rest);
        let [x, y, z, ref more @ ..] = values[..] else { return Err(self.too_few(statement, 3)) };
        // A weight may stand between a place and its colour.
        let colour = match *more {
            [r, g, b] | [_, r, g, b, ..] => Some(Vec4::new(linear(r), linear(g), linear(b), 1.0)),
            _ => None,
        };
        let vertices = &mut self.vertices;
        if colour.is_some() || !vertices.colours.is_empty() {
            vertices.colours.resize(vertices.positions.len(), Vec4::ONE);
            vertices.colours.push(colour.unwrap_or(Vec4::ONE));
        }
        vertices.positions.push(Vec3::new(x, y, z));
        Ok(())
    }

    fn face(&mut self, statement: &Statement<'_>) -> Result<(), FormatError> {
        self.corners.clear();
        for word in statement.rest.split_ascii_whitespace().take_while(|word| !word.starts_with('#')) {
            let corner = self.vertices.corner(word).map_err(|problem| self.wrong(statement, problem))?;
            self.corners.push(corner);
        }
        let Some(count) = self.corners.len().checked_sub(2).filter(|&count| count > 0) else {
            self.left_out += 1;
            return Ok(());
        };
        self.triangles += count as u64;
        if self.triangles > MAX_MODEL_TRIANGLES {
            return Err(FormatError::TooManyTriangles {
                file: self.file.to_owned(),
                asked: self.triangles,
                allowed: MAX_MODEL_TRIANGLES,
            });
        }
        let group = self.group();
        triangulate(&self.corners, &self.vertices.positions, &mut self.groups[group].triangles);
        Ok(())
    }

    /// The group of the name and the material at hand.
    fn group(&mut self) -> usize {
        if let Some(current) = self.current {
            return current;
        }
        let (name, material) = (self.name, self.material);
        let groups = &mut self.groups;
        let group = *self.known.entry((name, material)).or_insert_with(|| {
            groups.push(Group { name, material, triangles: Vec::new() });
            groups.len() - 1
        });
        self.current = Some(group);
        group
    }

    fn too_few(&self, statement: &Statement<'_>, least: usize) -> FormatError {
        let keyword = excerpt(statement.keyword.as_bytes());
        let rest = excerpt(statement.rest.as_bytes());
        self.wrong(statement, format!("`{keyword}` needs {least} numbers but has `{rest}`; export it again"))
    }

    fn wrong(&self, statement: &Statement<'_>, problem: String) -> FormatError {
        let position = Some(Position::Line(statement.line));
        FormatError::Malformed { file: self.file.to_owned(), position, problem }
    }

    /// Tells what was passed over.
    fn say(&self, notes: &mut Notes) {
        if self.left_out > 0 {
            notes.say_of_all(format!(
                "left out {} points, lines and faces of less than three corners",
                self.left_out
            ));
        }
        if !self.ignored.is_empty() {
            let names = list(self.ignored.iter().map(String::as_str));
            notes.say_of_all(format!("ignored the statements {names}"));
        }
    }
}

/// Names by number, each once: groups are looked up often, and names may be long.
#[derive(Default)]
struct Names {
    all: Vec<String>,
    known: FxHashMap<String, usize>,
}

impl Names {
    /// The number of `name`.
    fn place(&mut self, name: &str) -> usize {
        if let Some(&known) = self.known.get(name) {
            return known;
        }
        self.all.push(name.to_owned());
        self.known.insert(name.to_owned(), self.all.len() - 1);
        self.all.len() - 1
    }
}

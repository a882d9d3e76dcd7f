/// A model from a file, and where its copies stand.
#[derive(Clone, Debug, PartialEq)]
pub struct Mesh {
    /// Path of a .glb, .gltf or .obj file.
    pub model: String,
    /// Whether the file's z axis points up, not its y axis.
    pub z_up: bool,
    /// Faces that meet at a smaller angle than this, in degrees, blend; `None` keeps the file's normals.
    pub smooth_deg: Option<f32>,
    /// At least one.
    pub copies: Vec<Transform>,
    /// Whether smoke in a grid goes round it.
    pub obstacle: bool,
}

/// Scaled first, then turned, then moved.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Transform {
    /// Where the origin comes to lie, in metres.
    pub position: [f32; 3],
    /// Turns about the x, then the y, then the z axis, in degrees.
    pub rotation_deg: [f32; 3],
    /// Factors along the axes; none is 0.
    pub scale: [f32; 3],
}

impl Default for Transform {
    fn default() -> Self {
        Self { position: [0.0; 3], rotation_deg: [0.0; 3], scale: [1.0; 3] }
    }
}

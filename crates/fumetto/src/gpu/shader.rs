/// The linked and checked WGSL of one of the programs that `build/programs/` lists.
macro_rules! shader {
    ($name:literal) => {
        wgpu::ShaderModuleDescriptor {
            label: Some($name),
            source: wgpu::ShaderSource::Wgsl(
                include_str!(concat!(env!("OUT_DIR"), "/", $name, ".wgsl")).into(),
            ),
        }
    };
}

pub(crate) use shader;

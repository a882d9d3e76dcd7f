//! Holds Rust structs against their WGSL twins: bytes that the two sides read differently draw nonsense
//! without any error.

use std::borrow::Cow;

use naga::TypeInner;

/// Makes a test that a Rust struct lies in memory as its WGSL twin does.
///
/// All fields but padding are named in order; `rust as wgsl` where the names differ.
macro_rules! layout_test {
    ($test:ident: $rust:ty, $wgsl:literal of $program:literal { $($field:ident $(as $twin:ident)?),* $(,)? }) => {
        #[test]
        fn $test() {
            let fields = [$((
                [stringify!($field) $(, stringify!($twin))?].last().copied().unwrap_or_default(),
                std::mem::offset_of!($rust, $field),
            )),*];
            let program = $crate::gpu::shader!($program);
            $crate::gpu::assert_twins(&program, $wgsl, size_of::<$rust>(), &fields);
        }
    };
}

pub(crate) use layout_test;

/// Panics unless the WGSL struct has just these `fields` (name and offset), padding aside, and `size`.
pub(crate) fn assert_twins(
    program: &wgpu::ShaderModuleDescriptor<'static>,
    wgsl: &str,
    size: usize,
    fields: &[(&str, usize)],
) {
    let (members, span) = members_of(program, wgsl);
    let members: Vec<_> = members.iter().filter(|(name, _)| name != "pad").collect();
    let names: Vec<_> = members.iter().map(|(name, _)| name.as_str()).collect();
    assert_eq!(names, fields.iter().map(|(name, _)| *name).collect::<Vec<_>>(), "members of `{wgsl}`");
    for ((name, offset), (_, expected)) in members.iter().zip(fields) {
        assert_eq!(offset, expected, "offset of `{wgsl}.{name}`");
    }
    // A uniform may end in room that WGSL does not see.
    assert_eq!(span.next_multiple_of(16), size, "size of `{wgsl}`");
}

/// Names and offsets of a struct's members, and its size.
fn members_of(program: &wgpu::ShaderModuleDescriptor<'static>, wgsl: &str) -> (Vec<(String, usize)>, usize) {
    let wgpu::ShaderSource::Wgsl(text) = &program.source else { panic!("programs are WGSL") };
    let module = naga::front::wgsl::parse_str(&Cow::clone(text)).expect("the build has parsed it");
    let inner = module.types.iter().find(|(_, ty)| ty.name.as_deref() == Some(wgsl)).map(|(_, ty)| &ty.inner);
    let Some(TypeInner::Struct { members, span }) = inner else { panic!("no struct `{wgsl}`") };
    let named = |member: &naga::StructMember| {
        (member.name.clone().expect("members have names"), member.offset as usize)
    };
    (members.iter().map(named).collect(), *span as usize)
}

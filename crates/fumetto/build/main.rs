//! Links each shader program from its listed modules, and checks it.
//!
//! WGSL has no imports, so a program is the plain concatenation of its modules. A program that
//! does not parse or validate fails the build, with the module's own file name and line.

mod programs;

use std::{env, fs, path::Path, process::ExitCode};

use naga::valid::{Capabilities, ValidationFlags, Validator};

/// What every `WebGPU` adapter can do: `pack2x16float` counts as a capability of its own here.
const CAPABILITIES: Capabilities = Capabilities::SHADER_FLOAT16_IN_FLOAT32;

fn main() -> ExitCode {
    println!("cargo::rerun-if-changed=build");
    let out = env::var("OUT_DIR").expect("cargo sets OUT_DIR");
    // A program that was renamed must not live on here, to be missed only by whoever builds anew.
    fs::remove_dir_all(&out).expect("OUT_DIR is writable");
    let mut broken = 0;
    for (name, modules) in programs::ROOMS.iter().copied().flatten() {
        let program = Program::link(modules);
        if let Err(message) = program.check() {
            println!("cargo::error={name}: {message}");
            broken += 1;
        }
        let path = Path::new(&out).join(format!("{name}.wgsl"));
        fs::create_dir_all(path.parent().expect("the path has a folder")).expect("OUT_DIR is writable");
        fs::write(&path, &program.text).expect("OUT_DIR is writable");
    }
    if broken == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

/// A linked program and where its lines come from.
struct Program {
    text: String,
    /// Each module with the number of its first line in `text`, from 0.
    starts: Vec<(&'static str, u32)>,
}

impl Program {
    fn link(modules: &[&'static str]) -> Self {
        let mut program = Self { text: String::new(), starts: Vec::new() };
        let mut lines = 0;
        for module in modules {
            let path = format!("src/{module}.wgsl");
            println!("cargo::rerun-if-changed={path}");
            let text = fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"));
            program.starts.push((module, lines));
            lines += u32::try_from(text.lines().count()).expect("a shader has fewer lines than u32");
            program.text.push_str(&text);
        }
        program
    }

    fn check(&self) -> Result<(), String> {
        let module = naga::front::wgsl::parse_str(&self.text)
            .map_err(|error| self.place(error.location(&self.text), error.message()))?;
        Validator::new(ValidationFlags::all(), CAPABILITIES).validate(&module).map(|_| ()).map_err(|error| {
            let causes =
                std::iter::successors(std::error::Error::source(error.as_inner()), |cause| cause.source());
            let message = causes.fold(error.to_string(), |text, cause| format!("{text}: {cause}"));
            self.place(error.location(&self.text), &message)
        })
    }

    /// `message` with the module and line that it is about.
    fn place(&self, location: Option<naga::SourceLocation>, message: &str) -> String {
        let Some(location) = location else { return message.to_owned() };
        let line = location.line_number - 1;
        let (module, start) =
            self.starts.iter().rfind(|(_, start)| *start <= line).expect("the first module starts at 0");
        format!("src/{module}.wgsl:{}:{}: {message}", line - start + 1, location.line_position)
    }
}

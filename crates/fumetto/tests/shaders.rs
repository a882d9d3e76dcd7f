//! Every program, as a browser's compiler sees it: naga lets some things pass that others refuse.
#![expect(clippy::unwrap_used, reason = "a test that cannot set up should stop")]

use std::{
    fs,
    path::{Path, PathBuf},
};

use fumetto_browser::{Browser, Server};

/// What a page has to do before programs can be compiled.
const PREPARE: &str = "navigator.gpu.requestAdapter()
    .then(adapter => adapter.requestDevice())
    .then(device => { self.device = device; return true; })";

/// All programs that the build has linked.
fn programs() -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![PathBuf::from(env!("OUT_DIR"))];
    while let Some(folder) = folders.pop() {
        for path in fs::read_dir(folder).unwrap().map(|entry| entry.unwrap().path()) {
            if path.is_dir() { folders.push(path) } else { found.push(path) }
        }
    }
    found.sort();
    found
}

/// What the browser says to a program.
fn messages(browser: &mut Browser, program: &str) -> Vec<String> {
    let script = format!(
        "device.createShaderModule({{ code: {} }}).getCompilationInfo()
            .then(info => info.messages.map(m => `${{m.type}} in line ${{m.lineNum}}: ${{m.message}}`))",
        serde_json::to_string(program).unwrap(),
    );
    let said = browser.evaluate(&script).unwrap();
    said.as_array().unwrap().iter().map(ToString::to_string).collect()
}

#[test]
fn a_browser_takes_every_program() {
    let server = Server::new("<title>programs</title>").unwrap();
    let Some(mut browser) = Browser::open_for("the test of shaders", &server.url()).unwrap() else {
        return;
    };
    browser.wait_for(PREPARE, |made| made == true, std::time::Duration::from_secs(60)).unwrap();

    let wrong = messages(&mut browser, "fn wrong(a: u32) -> u32 { return a & 1u << 2u; }");
    assert!(!wrong.is_empty(), "the browser says what is wrong");
    let programs = programs();
    assert!(programs.len() > 100, "the build's programs were found");
    for program in programs {
        let said = messages(&mut browser, &fs::read_to_string(&program).unwrap());
        let name = program.strip_prefix(env!("OUT_DIR")).unwrap_or(Path::new(""));
        assert!(said.is_empty(), "{}: {}", name.display(), said.join("; "));
    }
}

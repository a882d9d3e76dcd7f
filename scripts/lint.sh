#!/usr/bin/env bash
# All checks that run none of our code, cheap ones first.
cd "$(dirname "$0")/.." && . scripts/common.sh
scripts/setup.sh --lint

tools="${CARGO_TARGET_DIR:-target}/tools"

# Fetches the programs of tools.txt into the target folder, unless just these are there.
fetch_tools() {
    cmp -s scripts/tools.txt "$tools/tools.txt" && return
    rm -rf "$tools" &&
        python3 -m venv "$tools" &&
        "$tools/bin/python" -m pip install --quiet --disable-pip-version-check --only-binary :all: \
            -r scripts/tools.txt &&
        cp scripts/tools.txt "$tools/tools.txt"
}

# Known holes in what we stand on. Without a way to the list of them there is nothing to compare with.
advisories() {
    local log
    if log=$("$tools/bin/cargo-deny" check advisories 2>&1); then
        say "$log"
    elif printf '%s' "$log" | grep -q 'failed to fetch advisory database'; then
        say "SKIPPED: the RustSec advisory database cannot be fetched from here, so nothing was checked."
    else
        say "$log"
        return 1
    fi
}

# must_not_need CRATE OTHER WHY
must_not_need() {
    local tree
    tree=$(cargo tree --locked --package "$1" --edges normal,build --target all --prefix none) || return 1
    if printf '%s\n' "$tree" | grep -q "^$2 v"; then
        say "$1 has come to depend on $2: $3. This is how:"
        cargo tree --locked --package "$1" --edges normal,build --target all --invert "$2"
        return 1
    fi
}

layers() {
    must_not_need fumetto-scene wgpu "the document knows no GPU" &&
        must_not_need fumetto-formats wgpu "reading and writing files needs no GPU" &&
        must_not_need fumetto winit "the engine draws into a texture, and never sees a window" &&
        must_not_need fumetto-cli egui "the command's first build stays short" &&
        must_not_need fumetto-cli glow "it draws with OpenGL and WebGL, and Fumetto never does" &&
        must_not_need fumetto-editor glow "it draws with OpenGL and WebGL, and Fumetto never does"
}

check "checkers" fetch_tools
check "Cargo.lock is up to date" cargo fetch --quiet --locked
check "format" cargo fmt --all --check
check "spelling" "$tools/bin/typos"
check "licences, bans and sources" "$tools/bin/cargo-deny" --locked check licenses bans sources
check "advisories" advisories
check "layers" layers
check "clippy" cargo clippy --locked --workspace --all-targets -- -D warnings
export RUSTDOCFLAGS="-D warnings"
check "documentation" cargo doc --locked --workspace --no-deps

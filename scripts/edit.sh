#!/usr/bin/env bash
# Builds the editor, with the command that it renders by, and opens it: scripts/edit.sh [SCENE]
scene="${1:-}"
# It is named from where this is called.
case "$scene" in
    "" | /* | ?:*) ;;
    *) scene="$PWD/$scene" ;;
esac
cd "$(dirname "$0")/.." && . scripts/common.sh
scripts/setup.sh --window
cargo build --locked --release -p fumetto-cli -p fumetto-editor
exec "${CARGO_TARGET_DIR:-target}/release/fumetto" edit ${scene:+"$scene"}

#!/usr/bin/env bash
# Builds the editor, with the command that it renders by, and opens it: scripts/edit.sh [SCENE]
cd "$(dirname "$0")/.." && . scripts/common.sh
scripts/setup.sh
cargo build --locked --release -p fumetto-cli -p fumetto-editor
exec target/release/fumetto edit "$@"

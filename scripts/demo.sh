#!/usr/bin/env bash
# Draws a chimney's smoke: a picture, and the last two seconds of it as an animation.
cd "$(dirname "$0")/.." && . scripts/common.sh
scripts/setup.sh

scene=scenes/chimney.toml
picture=out/chimney.png
animation=out/chimney.gif

fumetto() {
    cargo run --quiet --release --package fumetto-cli -- "$@"
}

mkdir -p out
say "Building fumetto; the first time takes some minutes."
cargo build --release --package fumetto-cli
fumetto render "$scene" -o "$picture"
fumetto render "$scene" -o "$animation" --frames 144..191 --size 640x360

say ""
say "Here they are:"
for file in "$picture" "$animation"; do
    say "  $file  ($(($(wc -c <"$file") / 1024)) KiB)"
done

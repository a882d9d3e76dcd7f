#!/usr/bin/env bash
# Measures every part of Fumetto at growing sizes: a table here, CSV files and plots in out/bench.
cd "$(dirname "$0")/.." && . scripts/common.sh
scripts/setup.sh
mkdir -p out/bench
cargo run --release --package fumetto-bench -- --out out/bench

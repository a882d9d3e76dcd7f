#!/usr/bin/env bash
# Measures every part of Fumetto at growing sizes: a table here, CSV file and plots in out/bench.
# Takes the program's own flags: scripts/bench.sh --quick, or --help.
cd "$(dirname "$0")/.." && . scripts/common.sh
scripts/setup.sh
cargo run --release --package fumetto-bench -- --out out/bench "$@"

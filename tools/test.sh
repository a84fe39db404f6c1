#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors, and runs all tests:
#   1. g++, release, this machine's instruction set: every test
#   2. clang, debug, the baseline instruction set, address and undefined-behaviour sanitizers: each fuzz target, shortly
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$project"
jobs=${TUMBLE_JOBS:-2}

say() { printf 'test: %s (%d s)\n' "$*" "$SECONDS" >&2; }

# build PRESET TARGET...
build() {
    local preset=$1
    shift
    cmake --preset "$preset" -DTUMBLE_WERROR=ON > "build/$preset.log" 2>&1 || { cat "build/$preset.log" >&2; return 1; }
    cmake --build --preset "$preset" --parallel "$jobs" --target "$@"
}

mkdir -p build
tools/setup.sh all
say "building with g++, release"
build ci all
say "running all tests"
ctest --preset ci --parallel "$jobs"
say "building with clang, debug, sanitizers, baseline instruction set"
build sanitize fuzz_targets
say "running the fuzz targets with sanitizers"
ctest --preset sanitize -L fuzz --parallel "$jobs"
say "all tests passed"

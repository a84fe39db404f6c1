#!/usr/bin/env bash
# Builds the simulation for aarch64 and runs it under qemu: the golden hashes, and the answers to 10 000 pairs of each
# family of distances, casts and times of impact, must be those of this processor, bit for bit. The build `ci` of
# tests/answers answers here, with each instruction set that the processor has. Takes about 90 s on two cores.
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$project"
jobs=${TUMBLE_JOBS:-2}
pairs=10000
here=build/ci/tests/answers
there=build/aarch64/tests/portable
results=build/portable

say() { echo "aarch64: $*" >&2; }

# compare NAME OTHER: the lines of two results; names the families that differ.
compare() {
    diff "$results/$1" "$results/$2" > "$results/differences" && return
    say "the answers of $1 and of $2 differ; for the bits of each answer of one family:"
    say "  $here read $results/pairs $pairs FAMILY"
    say "  qemu-aarch64 $there/answers read $results/pairs $pairs FAMILY"
    cat "$results/differences" >&2
    return 1
}

mkdir -p "$results"
say "building"
cmake --preset aarch64 -DTUMBLE_WERROR=ON > build/aarch64.log || { cat build/aarch64.log >&2; exit 1; }
cmake --build --preset aarch64 --parallel "$jobs"
cmake --build --preset ci --parallel "$jobs" --target answers
"$here" write "$results/pairs" "$pairs" > "$results/x86-64"
say "running under qemu"
qemu-aarch64 "$there/golden" > "$results/golden.log" &
golden=$!
qemu-aarch64 "$there/answers" read "$results/pairs" "$pairs" > "$results/aarch64"
wait "$golden" || { cat "$results/golden.log" >&2; exit 1; }
compare x86-64 aarch64
for set in baseline avx2 avx512; do
    TUMBLE_SIMD=$set build/ci/tools/tumble --version > /dev/null 2>&1 || continue
    TUMBLE_SIMD=$set "$here" read "$results/pairs" "$pairs" > "$results/$set"
    compare x86-64 "$set"
done
say "equal golden hashes and equal answers: $(wc -l < "$results/aarch64") families of $pairs pairs"

#!/usr/bin/env bash
# Installs what is missing, builds everything with warnings as errors, and runs all tests, in stages:
#   sources   the format of all sources, and clang-tidy for those that changed
#   release   g++, release: every test
#   python    the Python package, installed from its wheel into a virtual environment: its tests, types
#   sanitize  clang, debug, address and undefined-behaviour sanitizers, TUMBLE_CHECK: the same state hashes after each
#             step and the same parity results; the tests of the rooms that keep stores, of the command line (each
#             twelfth shipped scene and row of physics; without sweeps, searches and the examples of its page) and of the
#             golden hashes; each fuzz target for a short time; random sequences of calls in Python
#   threads   clang, thread sanitizer: the tests of threads
#   sets      the release build with each instruction set that the processor has, and on 1, 2, 3 and 8 threads: the golden
#             hashes
#   slurm     a sweep on a Slurm cluster of one machine, with a killed task (tools/slurm.sh)
#   aarch64   g++ for aarch64, run by qemu: the golden hashes, and the answers to all families of pairs (tools/aarch64.sh)
#   package   the Debian package: its contents, its program and a project that uses its library (tools/package.sh)
# tools/test.sh STAGE... runs these stages alone, with what they build on.
# tools/test.sh --full [STAGE...] does the same with a million pairs of each parity family, ten minutes for each fuzz
# target, the tests of sweeps, of searches and of the world and ten thousand random worlds with sanitizers, a thousand on
# several threads, long searches and a hundred thousand random sequences of calls in Python, and its API reference. It
# also tests the calls between sources, each compiled alone, and installs the Debian package in a bare Debian 12, with
# packages from the sources of apt.
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$project"
jobs=${TUMBLE_JOBS:-2}
# Some tests mount small disks and fill them.
as_root=(env)
((EUID == 0)) || as_root=(unshare --map-root-user --mount)
sanitized_rooms=(broad dynamics golden tools)
all_stages=(sources release python sanitize threads sets slurm aarch64 package)
if [[ ${1-} == --full ]]; then
    shift
    export TUMBLE_PAIRS=1000000 TUMBLE_FUZZ_SECONDS=600 TUMBLE_FUZZ_SEED=0 TUMBLE_THREADED_WORLDS=1000 TUMBLE_LONG=1
fi
stages=("$@")
(($#)) || stages=("${all_stages[@]}")
for stage in "${stages[@]}"; do
    [[ " ${all_stages[*]} " == *" $stage "* ]] || { echo "usage: ${0##*/} [--full] [STAGE...], of ${all_stages[*]}" >&2; exit 2; }
done

say() { printf 'test: %s (%d s)\n' "$*" "$SECONDS" >&2; }

# build PRESET TARGET...
build() {
    local preset=$1
    shift
    cmake --preset "$preset" -DTUMBLE_WERROR=ON > "build/$preset.log" 2>&1 || { cat "build/$preset.log" >&2; return 1; }
    cmake --build --preset "$preset" --parallel "$jobs" --target "$@"
}

# write_hashes PRESET SCENE SECONDS: prints the file with a line a step.
write_hashes() {
    local folder=build/hashes/$2-$1
    "build/$1/tools/tumble" run "scenes/$2.json" --duration "$3" --no-frames --force -o "$folder" \
        --hashes "$folder/hashes.csv" > /dev/null
    echo "$folder/hashes.csv"
}

# compare_hashes SCENE SECONDS
compare_hashes() {
    local ours theirs
    ours=$(write_hashes ci "$@")
    theirs=$(write_hashes sanitize "$@")
    cmp -- "$ours" "$theirs" || { say "$1: the state hashes of the two builds differ: $ours, $theirs"; return 1; }
    say "$1: equal state hashes over $2 s, $(wc -l < "$ours") lines"
}

# compare_parity PAIRS: the pairs of every family, their distances and the verdicts are the same, bit for bit.
# The seconds and the build of a run are its own.
compare_parity() {
    local preset
    for preset in ci sanitize; do
        "build/$preset/tools/tumble" parity --pairs "$1" --json | grep -vE '"(seconds|build)"' > "build/hashes/parity-$preset.json"
    done
    cmp build/hashes/parity-{ci,sanitize}.json || { say "the parity results of the two builds differ: build/hashes"; return 1; }
    say "parity: equal results over $1 pairs"
}

# check_golden_hashes: one program gives the same hashes with each instruction set, and joints in lanes the numbers of
# joints one by one. Every processor has the baseline.
check_golden_hashes() {
    local set
    for set in baseline avx2 avx512; do
        if [[ $set == baseline ]] || TUMBLE_SIMD=$set build/ci/tools/tumble --version > /dev/null 2>&1; then
            TUMBLE_SIMD=$set build/ci/tests/test_golden
            TUMBLE_SIMD=$set build/ci/tests/test_dynamics --test-case="joints in lanes*"
        else
            say "$set: not run, as this processor does not have it"
        fi
    done
}

# check_golden_threads: the same hashes on any number of threads.
check_golden_threads() {
    local threads
    for threads in 1 2 3 8; do
        TUMBLE_GOLDEN_THREADS=$threads build/ci/tests/test_golden
    done
}

build_release() {
    say "building with g++, release"
    build ci all
}

test_sources() {
    say "checking the sources"
    tools/lint.sh
}

test_release() {
    build_release
    say "running all tests"
    "${as_root[@]}" ctest --preset ci --parallel "$jobs"
    [[ -n ${TUMBLE_LONG-} ]] || return 0
    say "testing the calls between sources, each compiled alone"
    build apart tumble_pages test_house
    build/apart/tests/test_house
}

test_python() {
    build_release
    say "building the Python package, and running its tests in an environment of its own"
    rm -rf build/python
    TUMBLE_BUILD=$project/build/ci TUMBLE_COMMAND=$project/build/ci/tools/tumble tools/python.sh --test
    [[ -z ${TUMBLE_LONG-} ]] || TUMBLE_BUILD=$project/build/ci tools/python.sh --docs
}

test_sanitize() {
    build_release
    say "building with clang, debug, sanitizers"
    build sanitize tumble_cli "${sanitized_rooms[@]/#/test_}" fuzz_targets
    compare_hashes pyramid 5
    compare_hashes mixed_rain 2
    compare_parity 20000
    say "running tests and the fuzz targets with sanitizers"
    local without=(--exclude-regex '^tools_long$')
    [[ -z ${TUMBLE_LONG-} ]] || without=()
    TUMBLE_ONE_OF=12 "${as_root[@]}" ctest --preset sanitize "${without[@]}" \
        --label-regex "^($(IFS="|"; echo "${sanitized_rooms[*]}")|fuzz)\$" --parallel "$jobs"
    say "running random sequences of calls in Python with sanitizers"
    TUMBLE_SEQUENCES=$([[ -z ${TUMBLE_LONG-} ]] && echo 500 || echo 100000) TUMBLE_BUILD=$project/build/ci \
        tools/python.sh --sanitized
    [[ -n ${TUMBLE_LONG-} ]] || return 0
    say "running the tests of the world with sanitizers"
    build sanitize test_world
    build/sanitize/tests/test_world --test-case-exclude='random worlds*'
    seq 1 1000 9001 | TUMBLE_WORLDS=1000 xargs -P "$jobs" -I '{}' env TUMBLE_WORLDS_FROM='{}' \
        build/sanitize/tests/test_world --test-case='random worlds*'
}

test_threads() {
    say "building with clang, thread sanitizer"
    build tsan threads
    build/tsan/tests/threads
}

test_sets() {
    build_release
    say "comparing the golden hashes of the instruction sets"
    check_golden_hashes
    check_golden_threads
}

test_slurm() {
    build_release
    say "running a sweep on a Slurm cluster of one machine"
    tools/slurm.sh build/ci/tools/tumble
}

test_aarch64() {
    build_release
    say "comparing with aarch64"
    tools/aarch64.sh
}

test_package() {
    say "building and testing the Debian package"
    tools/package.sh --test
    [[ -z ${TUMBLE_LONG-} ]] || tools/package.sh --bare
}

mkdir -p build
tools/setup.sh all
for stage in "${stages[@]}"; do
    "test_$stage"
done
say "all tests passed: ${stages[*]}"

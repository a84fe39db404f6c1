#!/usr/bin/env bash
# Checks the sources against .clang-format and .clang-tidy. Every finding is an error.
#   tools/lint.sh           the format of all sources; clang-tidy for what changed in the last day of commits
#   tools/lint.sh BASE      the same, for what differs from the commit BASE
#   tools/lint.sh --all     clang-tidy for all sources
# clang-tidy starts no further source after TUMBLE_TIDY_SECONDS (90, no limit with --all). It takes the sources with the
# most changed lines first, and says how many it left out.
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$project"
jobs=${TUMBLE_JOBS:-2}
seconds=${TUMBLE_TIDY_SECONDS:-90}

say() { echo "lint: $*" >&2; }

# The last commit of the day before, or the empty tree.
day_before_head() {
    local date base
    date=$(git log -1 --format=%ct)
    base=$(git rev-list -1 --before=$((date - 86400)) HEAD)
    echo "${base:-$(git hash-object -t tree /dev/null)}"
}

# These sources need the headers of Box2D v3, which a machine seldom has.
without_v3=':!src/reference/box2d_v3/library/v3_*.cpp'

# The C++ files that differ from the commit BASE, those with the most changed lines first.
changed_files() {
    git diff --numstat --no-renames --diff-filter=d "$1" -- '*.cpp' '*.hpp' "$without_v3" | sort -rn | cut -f3
}

# The source that clang-tidy reads to see a file: itself, or for a header the source of the same name or one that
# includes it.
source_of() {
    local file=$1 own=${1%.hpp}.cpp include=${1#src/}
    [[ $file == *.cpp ]] && { echo "$file"; return; }
    [[ -f $own ]] && { echo "$own"; return; }
    git grep -l -F "#include \"${include#include/}\"" -- '*.cpp' | head -n 1 || true
}

# configure FOLDER OPTION...: how each source is compiled.
configure() {
    local folder=$1
    shift
    mkdir -p build
    cmake -S . -B "$folder" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++-14 \
        -DTUMBLE_FUZZ=ON -DTUMBLE_PYTHON=ON -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON "$@" > "$folder.log" || { cat "$folder.log" >&2; return 1; }
}

# tidy FOLDER CHECKS: reads the names of sources, one a line. CHECKS are added to those of .clang-tidy.
tidy() {
    local folder=$1 checks=$2 deadline=$(($(date +%s) + seconds)) sources
    local checked=$folder/checked
    mapfile -t sources
    ((${#sources[@]})) || { say "clang-tidy: no source has changed"; return; }
    : > "$checked"
    export folder checks checked deadline
    # shellcheck disable=SC2016  # expanded by the inner shell
    printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$jobs" bash -c '
        (($(date +%s) < deadline)) || exit 0
        echo "$1" >> "$checked"
        exec clang-tidy-14 -p "$folder" --quiet --checks="$checks" "$1" 2> /dev/null' lint ||
        { say "clang-tidy found errors"; return 1; }
    say "clang-tidy${checks:+ ($checks)}: $(wc -l < "$checked") of ${#sources[@]} sources are clean"
}

tidy_changed() {
    local file
    configure build/tidy -DTUMBLE_JOIN_SOURCES=OFF
    changed_files "$1" | while read -r file; do source_of "$file"; done | awk 'NF && !seen[$0]++' | tidy build/tidy ''
}

# Most checks spend their time in the headers, so they read a library's sources sixteen at a time. The analyser looks into
# a main file only, so it reads each source alone.
tidy_all() {
    seconds=1000000
    configure build/tidy-joined -DCMAKE_UNITY_BUILD=ON -DCMAKE_UNITY_BUILD_BATCH_SIZE=16
    sed -n 's/.*"file": "\(.*\)".*/\1/p' build/tidy-joined/compile_commands.json | sort -u |
        tidy build/tidy-joined '-clang-analyzer-*,-bugprone-suspicious-include'
    configure build/tidy -DTUMBLE_JOIN_SOURCES=OFF
    git ls-files '*.cpp' "$without_v3" | tidy build/tidy '-bugprone-*,-misc-*,-performance-*,-modernize-*,-readability-*'
}

say "clang-format for all sources"
git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format-14 --dry-run --Werror
case ${1-} in
    --all) tidy_all ;;
    '') tidy_changed "$(day_before_head)" ;;
    *) tidy_changed "$(git rev-parse --verify "$1^{commit}")" ;;
esac

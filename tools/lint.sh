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
build=build/tidy

say() { echo "lint: $*" >&2; }

day_before_head() {
    local date
    date=$(git log -1 --format=%ct)
    git rev-list -1 --before=$((date - 86400)) HEAD
}

# Changed C++ files, those with the most changed lines first.
changed_files() {
    local base=$1
    if [[ -z $base ]]; then
        git ls-files '*.cpp' '*.hpp'
    else
        git diff --numstat --no-renames --diff-filter=d "$base" -- '*.cpp' '*.hpp' | sort -rn | cut -f3
    fi
}

# The source that clang-tidy reads to see a file: itself, or for a header the source of the same name or one that
# includes it.
source_of() {
    local file=$1 own=${1%.hpp}.cpp include=${1#src/}
    [[ $file == *.cpp ]] && { echo "$file"; return; }
    [[ -f $own ]] && { echo "$own"; return; }
    git grep -l -F "#include \"${include#include/}\"" -- '*.cpp' | head -n 1 || true
}

tidy() {
    local base=$1 deadline=$(($(date +%s) + seconds)) file
    local -a sources=()
    while read -r file; do sources+=("$(source_of "$file")"); done < <(changed_files "$base")
    mapfile -t sources < <(printf '%s\n' "${sources[@]}" | awk 'NF && !seen[$0]++')
    ((${#sources[@]})) || { say "clang-tidy: no source has changed"; return; }
    cmake -S . -B "$build" -G Ninja -DCMAKE_BUILD_TYPE=Debug -DCMAKE_CXX_COMPILER=clang++-14 -DTUMBLE_SIMD=baseline \
        -DCMAKE_DISABLE_PRECOMPILE_HEADERS=ON > "$build.log" || { cat "$build.log" >&2; return 1; }
    local checked=$build/checked
    : > "$checked"
    export build checked deadline
    # shellcheck disable=SC2016  # expanded by the inner shell
    printf '%s\0' "${sources[@]}" | xargs -0 -n 1 -P "$jobs" bash -c '
        (($(date +%s) < deadline)) || exit 0
        echo "$1" >> "$checked"
        exec clang-tidy-14 -p "$build" --quiet "$1" 2> /dev/null' lint ||
        { say "clang-tidy found errors"; return 1; }
    say "clang-tidy: $(wc -l < "$checked") of ${#sources[@]} sources are clean"
}

say "clang-format for all sources"
git ls-files -z '*.cpp' '*.hpp' | xargs -0 clang-format-14 --dry-run --Werror
mkdir -p build
case ${1-} in
    --all) seconds=1000000 && tidy '' ;;
    '') tidy "$(day_before_head)" ;;
    *) tidy "$(git rev-parse --verify "$1^{commit}")" ;;
esac

#!/usr/bin/env bash
# Makes build/ci/tumble_VERSION_ARCHITECTURE.deb: the program, its manual page, completions and scenes, and the libraries
# with their headers.
#   tools/package.sh           prints the name of the package
#   tools/package.sh --test    also unpacks it elsewhere and tests what it contains; installs nothing
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$project"
jobs=${TUMBLE_JOBS:-2}
case ${1-} in
    --test | '') ;;
    *) echo "usage: ${0##*/} [--test]" >&2; exit 2 ;;
esac

say() { echo "package: $*" >&2; }
die() { say "$@"; exit 1; }

[[ -f build/ci/CMakeCache.txt ]] || cmake --preset ci > /dev/null
cmake --build --preset ci --parallel "$jobs" --target tumble tumble_render tumble_cli tumble_page_files >&2
rm -f build/ci/tumble_*.deb
(cd build/ci && cpack > cpack.log 2>&1) || { cat build/ci/cpack.log >&2; exit 1; }
package=$(echo build/ci/tumble_*.deb)
echo "$package"
[[ ${1-} == --test ]] || exit 0

place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT
dpkg-deb -x "$package" "$place"
prefix=$place/usr
program=$prefix/bin/tumble

check_contents() {
    local file missing=0
    for file in bin/tumble lib/libtumble.a lib/libtumble_render.a lib/cmake/tumble/tumble-config.cmake \
        include/tumble/world.hpp share/man/man1/tumble.1 share/bash-completion/completions/tumble \
        share/zsh/vendor-completions/_tumble share/fish/vendor_completions.d/tumble.fish share/doc/tumble/copyright; do
        [[ -s $prefix/$file ]] || { say "$file is missing"; missing=1; }
    done
    local scene
    for scene in scenes/*.json; do
        cmp -s "$scene" "$prefix/share/tumble/$scene" || { say "$scene is missing or differs"; missing=1; }
    done
    ((missing == 0))
    man --warnings --local-file "$prefix/share/man/man1/tumble.1" 2>&1 > /dev/null | (! grep .)
    bash -n "$prefix/share/bash-completion/completions/tumble"
    zsh -n "$prefix/share/zsh/vendor-completions/_tumble"
    fish --no-execute "$prefix/share/fish/vendor_completions.d/tumble.fish"
    say "$(find "$place" -type f | wc -l) files"
}

# No file names a folder of the machine that built it.
check_paths() {
    ! grep -rlF -e "$project" "$place" >&2 || die "these files name the folder of the sources"
}

# The objects of AVX2 and AVX-512 are named after them; what is compiled for the baseline uses no register wider than
# 128 bits and no instruction of AVX, whose names begin with v. The program contains tumble_tools,
# tumble_reference and tumble_sweep.
check_instructions() {
    local library found
    for library in "$prefix"/lib/libtumble.a "$prefix"/lib/libtumble_render.a build/ci/tools/libtumble_tools.a \
        build/ci/src/libtumble_reference.a build/ci/src/libtumble_sweep.a; do
        found=$(objdump -d --no-show-raw-insn "$library" | awk '
            /file format/ { dispatched = $1 == "avx2.o:" || $1 == "avx512.o:"; object = $1 }
            !dispatched && ($2 ~ /^v/ || /%[yz]mm|%k[0-7]/) && $1 ~ /^[0-9a-f]+:$/ { print object, $0 }')
        [[ -z $found ]] || die "${library##*/}: instructions above the baseline: ${found::500}"
    done
    # A processor of 2008, which has neither.
    qemu-x86_64 -cpu Nehalem "$program" check "$prefix/share/tumble/scenes/see_saw.json" > /dev/null
    [[ $(qemu-x86_64 -cpu Nehalem "$program" --version) == *baseline* ]] || die "not the baseline on an old processor"
}

check_symbols() {
    ! nm -D --defined-only --demangle "$1" | grep -E '(^| )tumble::' >&2 || die "${1##*/} exports symbols of tumble"
}

# In a folder of its own, without the sources.
check_consumer() {
    say "building a project that uses the package"
    cp -r tests/package "$place/consumer"
    cmake -S "$place/consumer" -B "$place/consumer/build" -G Ninja -DCMAKE_BUILD_TYPE=Release \
        -DCMAKE_PREFIX_PATH="$prefix" -Dtumble_DIR="$prefix/lib/cmake/tumble"
    cmake --build "$place/consumer/build"
    check_symbols "$place/consumer/build/libplugin.so"
    (cd "$place/consumer/build" && ./consumer)
}

check_program() {
    mkdir "$place/elsewhere"
    cd "$place/elsewhere"
    "$program" demo pendulum > demo.log || { cat demo.log; return 1; }
    "$program" doctor --need frames,text > doctor.log || { cat doctor.log; return 1; }
    [[ -s out/demo/summary.json || -n $(find out -name summary.json) ]] || die "demo has written no summary"
    [[ -n $(find out -name '*.png' -print -quit) ]] || die "demo has written no frame"
    cd "$project"
}

check_contents
check_paths
check_instructions
check_symbols "$program"
check_consumer
check_program
say "the package is complete and works elsewhere"

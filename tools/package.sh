#!/usr/bin/env bash
# Makes build/ci/tumble_VERSION_ARCHITECTURE.deb: the program, its manual page, completions and scenes, and the libraries
# with their headers.
#   tools/package.sh           prints the name of the package
#   tools/package.sh --test    also unpacks it elsewhere and tests what it contains; installs nothing
#   tools/package.sh --bare    also installs it with apt in a bare Debian 12, which it makes for that, and runs the program
#                              there. Needs Debian 12 among the sources of apt, and root or user namespaces
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
cd -- "$project"
jobs=${TUMBLE_JOBS:-2}
case ${1-} in
    --test | --bare | '') ;;
    *) echo "usage: ${0##*/} [--test | --bare]" >&2; exit 2 ;;
esac

say() { echo "package: $*" >&2; }
die() { say "$@"; exit 1; }

[[ -f build/ci/CMakeCache.txt ]] || cmake --preset ci > /dev/null
cmake --build --preset ci --parallel "$jobs" --target tumble tumble_render tumble_cli tumble_page_files >&2
rm -f build/ci/tumble_*.deb
(cd build/ci && cpack > cpack.log 2>&1) || { cat build/ci/cpack.log >&2; exit 1; }
package=$(echo build/ci/tumble_*.deb)
echo "$package"
[[ -n ${1-} ]] || exit 0

place=$(mktemp -d)
trap 'rm -rf "$place"' EXIT

# This machine's addresses for the suites of Debian 12, one "deb ADDRESS SUITE main" a line.
debian_sources() {
    # shellcheck disable=SC2016  # the names are apt's
    apt-get indextargets --format '$(REPO_URI) $(RELEASE) $(COMPONENT)' 'Created-By: Packages' |
        awk '$2 ~ /^bookworm(-updates|-security)?$/ && $3 == "main" { print "deb", $1, $2, $3 }' | sort -u
}

# mmdebstrap makes the bare Debian in a folder, runs each hook in it, and removes it: no root is left behind. A hook has
# a clean environment, as a user of that Debian would.
test_in_bare_debian() {
    local log=build/ci/bare.log
    debian_sources > "$place/sources.list"
    [[ -s $place/sources.list ]] || die "no bare Debian: apt on this machine has no source for bookworm main"
    apt-config dump | { grep -E '^Acquire::(https?::Proxy|Check-|Retries)' || true; } > "$place/apt.conf"
    cat > "$place/try.sh" <<'END'
set -eu
echo "step: apt-get installs the package"
apt-get install --yes --quiet --no-install-recommends /tmp/tumble.deb < /dev/null
cd "$(mktemp -d)"
echo "step: tumble --version"
tumble --version
echo "step: tumble doctor"
tumble doctor --need frames,text
echo "step: tumble demo"
tumble demo
find out -name summary.json | grep -q . && find out -name '*.png' | grep -q . || { echo "no summary or no frame"; exit 1; }
echo "step: one frame"
tumble shot /usr/share/tumble/scenes/see_saw.json --at 1 -o frame.png
[ "$(head -c 4 frame.png | tail -c 3)" = PNG ] || { echo "frame.png is not a PNG file"; exit 1; }
echo "step: mmdebstrap removes that Debian"
END
    say "installing it in a bare Debian"
    # shellcheck disable=SC2016  # $1 is the folder of that Debian
    mmdebstrap --variant=minbase --format=null --aptopt="$place/apt.conf" \
        --customize-hook="upload $package /tmp/tumble.deb" --customize-hook="upload $place/try.sh /tmp/try.sh" \
        --customize-hook='chroot "$1" env -i HOME=/root PATH=/usr/sbin:/usr/bin:/sbin:/bin LANG=C.UTF-8 DEBIAN_FRONTEND=noninteractive sh /tmp/try.sh' \
        bookworm /dev/null "$place/sources.list" > "$log" 2>&1 || explain_failure "$log"
    say "it installs and runs in a bare Debian: $(grep -A 1 '^step: tumble --version' "$log" | tail -n 1)"
}

explain_failure() {
    local step
    step=$(sed -n 's/^step: //p' "$1" | tail -n 1)
    tail -n 15 "$1" >&2
    [[ -z $step ]] || die "in a bare Debian this step failed: $step. All output is in $1"
    die "could not make a bare Debian, so that nothing was tested: that needs root or user namespaces, and Debian" \
        "12 among the sources of apt. All output is in $1"
}

if [[ $1 == --bare ]]; then
    test_in_bare_debian
    exit 0
fi

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

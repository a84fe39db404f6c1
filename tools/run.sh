#!/usr/bin/env bash
# Runs tumble: installs and builds what is missing first, which is silent and quick if nothing is.
#   tools/run.sh            the built-in demo
#   tools/run.sh ARGS...    tumble ARGS...
# Standard output is tumble's alone; what installing and building have to say goes to standard error.
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=$project/build/release

configure() {
    [[ -f $build/build.ninja ]] && return
    echo "run: configuring $build" >&2
    (cd -- "$project" && cmake --preset release -DTUMBLE_TESTS=OFF) >&2
}

# Ninja's own messages, apart from those of a build that has nothing to do.
compile() {
    ninja -C "$build" tumble_cli |
        sed -u -e '/no work to do/d' -e '/Entering directory/d' -e '/Re-checking globbed/d' >&2
}

"$project/tools/setup.sh" build
configure
compile
(($#)) || set -- demo
exec "$build/tools/tumble" "$@"

#!/usr/bin/env bash
# Runs tumble. Installs missing packages and builds changed sources first, which is silent if there are none.
#   tools/run.sh            the built-in demo
#   tools/run.sh ARGS...    tumble ARGS...
# Standard output is that of tumble; messages of the installation and of the build go to standard error.
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
build=$project/build/release

configure() {
    [[ -f $build/build.ninja ]] && return
    echo "run: configuring $build" >&2
    (cd -- "$project" && cmake --preset release -DTUMBLE_TESTS=OFF) >&2
}

# Drops Ninja's messages of a build that has nothing to do.
compile() {
    ninja -C "$build" tumble_cli |
        sed -u -e '/no work to do/d' -e '/Entering directory/d' -e '/Re-checking globbed/d' >&2
}

"$project/tools/setup.sh" build
configure
compile
(($#)) || set -- demo
exec "$build/tools/tumble" "$@"

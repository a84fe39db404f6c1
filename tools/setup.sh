#!/usr/bin/env bash
# Installs the Debian packages that tumble needs. No other file lists them. Prints each missing package with its purpose
# and installs it; prints nothing if all packages are installed.
#   tools/setup.sh build   to build and run tumble (the default)
#   tools/setup.sh test    to run its tests
#   tools/setup.sh python  to build the Python package and to run its tests
#   tools/setup.sh all     all of them
set -euo pipefail

# One entry per line: PACKAGE:PURPOSE.
build_packages=(
    'g++:the compiler, C++20'
    'cmake:configures the build, 3.25 or newer'
    'ninja-build:runs the build'
    'libeigen3-dev:lanes of 8 numbers in the solver, small linear algebra'
    'nlohmann-json3-dev:reads scene files'
    'rapidjson-dev:reads distance queries by the million; its schema validator tests the scene schema'
    'libcli11-dev:reads the command line'
    'libfccp-dev:reads trajectories'
    'libtbb-dev:threads of a step'
    'libxxhash-dev:state and scene hashes'
    'libosmesa6:draws frames without a display'
    'libegl1:draws frames where there is no OSMesa'
    'libgl1-mesa-dri:the rasteriser of EGL'
    'libgl-dev:types and constants of OpenGL'
    'libegl-dev:types and constants of EGL'
    'libstb-dev:reads PNG and BMP files, text in frames'
    'libisal-dev:compresses PNG files quickly'
    'libdeflate-dev:compresses replay pages'
    'libturbojpeg0-dev:reads JPEG files'
    'fonts-dejavu-core:the font of the text in frames'
    'libpugixml-dev:reads SVG drawings'
    'libbox2d-dev:the engine that bench compares with'
    'libhdf5-dev:the trajectories of sweeps'
    'libgmp-dev:exact arithmetic to check distances with'
)
test_packages=(
    'doctest-dev:the test framework'
    'librapidcheck-dev:random tests that shrink their failures'
    'clang-14:the second compiler: must give the same state hashes'
    'libclang-rt-14-dev:its sanitizers and libFuzzer'
    'clang-format-14:checks the format of the sources'
    'clang-tidy-14:finds mistakes in the sources'
    'shellcheck:checks these scripts'
    'ffmpeg:encodes the videos of runs, and decodes them for the tests'
    'chromium:opens replay pages'
    'chromium-driver:lets scripts control chromium'
    'python3-selenium:controls chromium from Python'
    'g++-aarch64-linux-gnu:the compiler for another processor: must give the same bits'
    'qemu-user:runs what it builds'
    'dpkg-dev:finds the packages that the .deb depends on'
    'file:tells the package builder which files are programs'
    'mmdebstrap:makes a bare Debian, to install the package in'
    'uidmap:lets mmdebstrap work without root'
    'man-db:reads the manual page of the package'
    'zsh:reads the completions for zsh'
    'fish:reads the completions for fish'
    'slurm-wlm:the scheduler of clusters that sweeps are submitted to'
    'munge:lets its daemons trust each other'
    'python3-sphinx:writes the API reference of the Python package'
)
python_packages=(
    'pybind11-dev:binds the library to Python'
    'python3-dev:headers of Python'
    'python3-numpy:arrays'
    'python3-setuptools:builds the wheel'
    'python3-wheel:builds the wheel'
    'python3-pip:installs the wheel'
    'python3-venv:the environment that it is installed into'
    'python3-pytest:runs the tests of the package'
    'mypy:checks its types'
)

say() { echo "setup: $*" >&2; }
die() { say "$@"; exit 1; }

case ${1-build} in
    build) wanted=("${build_packages[@]}") ;;
    test) wanted=("${test_packages[@]}") ;;
    python) wanted=("${build_packages[@]}" "${python_packages[@]}") ;;
    all) wanted=("${build_packages[@]}" "${test_packages[@]}" "${python_packages[@]}") ;;
    *) echo "usage: ${0##*/} [build|test|python|all]" >&2; exit 2 ;;
esac

if ! type -P dpkg-query apt-get > /dev/null; then
    say "apt-get or dpkg-query is missing, so this script cannot install packages. tumble needs"
    printf '  %s\n' "${wanted[@]/:/: }" >&2
    die "(names as in Debian 12). Install them, then: cmake --preset release && cmake --build --preset release"
fi

is_installed() { [[ $(dpkg-query -W -f '${db:Status-Status}' "$1" 2> /dev/null) == installed ]]; }

missing=()
for entry in "${wanted[@]}"; do
    package=${entry%%:*}
    is_installed "$package" && continue
    ((${#missing[@]})) || say "missing from this machine:"
    printf '  %-20s %s\n' "$package" "${entry#*:}" >&2
    missing+=("$package")
done
((${#missing[@]})) || exit 0

as_root=()
if ((EUID != 0)); then
    type -P sudo > /dev/null || die "installing needs root, and there is no sudo here. As root, run:
  apt-get install --no-install-recommends ${missing[*]}"
    as_root=(sudo)
fi
install_packages() {
    "${as_root[@]}" env DEBIAN_FRONTEND=noninteractive \
        apt-get install --yes --quiet --quiet --no-install-recommends "${missing[@]}" >&2
}
say "installing them with apt-get"
"${as_root[@]}" apt-get update --quiet --quiet >&2 || say "could not update the package lists; using older ones"
install_packages || die "apt-get could not install: ${missing[*]}"

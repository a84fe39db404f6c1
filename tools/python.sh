#!/usr/bin/env bash
# Runs Python with the package tumble. Installs missing packages, and builds and installs the wheel into build/python
# first if a source has changed.
#   tools/python.sh SCRIPT.py ARGS...   runs a script
#   tools/python.sh -m pytest ...       any arguments of python3
#   tools/python.sh --test              runs the tests of the package, and checks its types and its stub
#   tools/python.sh --sanitized         runs random sequences of calls with the address sanitizer, in the preset sanitize
#   tools/python.sh --measure           prints the rates of the package beside those of C++
#   tools/python.sh --docs              writes the API reference, by Sphinx, to build/python/docs
# TUMBLE_BUILD names the build folder of the library (default: build/release). TUMBLE_SEQUENCES is the number of random
# sequences of calls, TUMBLE_LONG=1 runs the tests that take minutes too.
set -euo pipefail

project=$(cd -- "$(dirname -- "${BASH_SOURCE[0]}")/.." && pwd)
export TUMBLE_BUILD=${TUMBLE_BUILD-$project/build/release}
environment=$project/build/python

"$project/tools/setup.sh" python
mkdir -p "$environment"
[[ -x $environment/venv/bin/python ]] || /usr/bin/python3 -m venv --system-site-packages "$environment/venv"
python=$environment/venv/bin/python

# The package is as new as this file if no source is newer.
installed=$environment/installed
if [[ ! -f $installed || -n $(find "$project"/{src,include,CMakeLists.txt} -newer "$installed" -print -quit) ]]; then
    started=$(mktemp -p "$environment")
    rm -rf "$environment"/{source,wheel}
    cp -r "$project/src/python" "$environment/source"
    (cd -- "$environment/source" && TUMBLE_PROJECT=$project "$python" -m pip --quiet wheel --no-deps --no-build-isolation \
        --no-index --wheel-dir "$environment/wheel" .) >&2
    "$python" -m pip --quiet install --no-deps --no-index --force-reinstall "$environment"/wheel/*.whl >&2
    mv -- "$started" "$installed"
fi

if [[ ${1-} == --test ]]; then
    shift
    "$python" -m pytest -q -p no:cacheprovider "$project/tests/python" "$@"
    (cd -- "$project/src/python" && /usr/bin/python3 -m mypy --strict --no-incremental --cache-dir=/dev/null -p tumble)
    cd -- "$environment"
    exec "$python" -m mypy.stubtest tumble._tumble --allowlist "$project/src/python/stubtest.txt"
fi
if [[ ${1-} == --measure ]]; then
    cmake --build "$TUMBLE_BUILD" --target rates >&2
    exec "$python" "$project/tests/python/measure.py" "$TUMBLE_BUILD/tests/rates.so"
fi
if [[ ${1-} == --sanitized ]]; then
    shift
    sanitized=$project/build/sanitize
    cmake --preset sanitize -DTUMBLE_PYTHON=ON -DPython_EXECUTABLE=/usr/bin/python3 > /dev/null
    cmake --build --preset sanitize --target tumble_python
    ln -sf -t "$sanitized/python/tumble" "$project"/src/python/tumble/*.py "$project/src/python/tumble/envs"
    export LD_PRELOAD ASAN_OPTIONS=detect_leaks=0 PYTHONPATH=$sanitized/python
    LD_PRELOAD=$(clang++-14 -print-file-name=libclang_rt.asan-x86_64.so)
    exec "$python" -m pytest -q -s -p no:cacheprovider "$project/tests/python/test_fuzz.py" "$@"
fi
if [[ ${1-} == --docs ]]; then
    exec "$python" -m sphinx -q -W --keep-going -d "$environment/doctrees" "$project/src/python/docs" "$environment/docs"
fi
exec "$python" "$@"

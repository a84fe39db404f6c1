"""Builds tumble._tumble by CMake. TUMBLE_BUILD names the build folder, by default build/release of the project.

An existing build folder is used as it is configured, so that a library that is built already is not built again.
"""

import os
import shutil
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

PROJECT = Path(os.environ.get("TUMBLE_PROJECT", Path(__file__).resolve().parents[2]))


class CMakeBuild(build_ext):
    def build_extension(self, ext: Extension) -> None:
        build = Path(os.environ.get("TUMBLE_BUILD", PROJECT / "build" / "release")).resolve()
        configure = ["cmake", "-S", str(PROJECT), "-B", str(build), "-DTUMBLE_PYTHON=ON"]
        if not (build / "CMakeCache.txt").exists():
            configure += ["-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release"]
        # A virtual environment has no headers: CMake looks for those of the interpreter that it was made from.
        base = getattr(sys, "_base_executable", sys.executable)
        subprocess.run([*configure, f"-DPython_EXECUTABLE={base}"], check=True, stdout=subprocess.DEVNULL)
        subprocess.run(["cmake", "--build", str(build), "--target", "tumble_python"], check=True)
        (module,) = (build / "python" / "tumble").glob("_tumble.*.so")
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        shutil.copy(module, target)


setup(ext_modules=[Extension("tumble._tumble", [])], cmdclass={"build_ext": CMakeBuild})

# SPDX-License-Identifier: BSD-3-Clause
"""Builds the extension module with CMake: `pip install --no-build-isolation .` (see docs/python.md)."""

import os
import re
import subprocess
import sys
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()


class CMakeBuild(build_ext):
    """Builds the target `ridgeline_python` in build/python and takes the extension module from there."""

    def build_extension(self, ext: Extension) -> None:
        build = ROOT / "build" / "python"
        subprocess.run(
            ["cmake", "--preset", "release", "-B", build, "-DRIDGELINE_BUILD_PYTHON=ON",
             "-DRIDGELINE_BUILD_TESTS=OFF", "-DRIDGELINE_WERROR=OFF", f"-DPython_EXECUTABLE={sys.executable}"],
            cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", build, "--target", "ridgeline_python"], check=True)
        built = next((build / "apps" / "python" / "ridgeline").glob("_core.*.so"))
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(os.fspath(built), os.fspath(target))


def version() -> str:
    """The one of the CMake project."""
    return re.search(r"project\(ridgeline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text()).group(1)


setup(version=version(), ext_modules=[Extension("ridgeline._core", sources=[])], cmdclass={"build_ext": CMakeBuild})

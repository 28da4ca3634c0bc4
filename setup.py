# SPDX-License-Identifier: BSD-3-Clause
"""Builds the extension module with CMake: `pip install --no-build-isolation .` (see
docs/python.md).
"""

import os
import re
import subprocess
import sys
import sysconfig
from pathlib import Path

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = Path(__file__).parent.resolve()


class CMakeBuild(build_ext):
    """Builds the target `ridgeline_python` in build/python, or in the configured
    RIDGELINE_BUILD_DIR.
    """

    def build_extension(self, ext: Extension) -> None:
        build = Path(os.environ.get("RIDGELINE_BUILD_DIR", ROOT / "build" / "python"))
        if "RIDGELINE_BUILD_DIR" not in os.environ:
            options = {"BUILD_PYTHON": "ON", "BUILD_TESTS": "OFF", "WERROR": "OFF"}
            defined = [f"-DRIDGELINE_{name}={value}" for name, value in options.items()]
            subprocess.run(["cmake", "--preset", "release", "-B", build, f"-DPython_EXECUTABLE={sys.executable}",
                            *defined], cwd=ROOT, check=True)
        subprocess.run(["cmake", "--build", build, "--target", "ridgeline_python"], check=True)
        built = build / "apps" / "python" / "ridgeline" / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
        target = Path(self.get_ext_fullpath(ext.name))
        target.parent.mkdir(parents=True, exist_ok=True)
        self.copy_file(os.fspath(built), os.fspath(target))


def version() -> str:
    """The one of the CMake project."""
    found = re.search(r"project\(ridgeline VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())
    assert found
    return found.group(1)


os.chdir(ROOT)
(ROOT / "build").mkdir(exist_ok=True)
setup(version=version(), ext_modules=[Extension("ridgeline._core", sources=[])], cmdclass={"build_ext": CMakeBuild},
      options={"egg_info": {"egg_base": "build"}})

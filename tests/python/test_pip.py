# SPDX-License-Identifier: BSD-3-Clause
import importlib.util
import os
import subprocess
import sys
import unittest

from support import CLOUD, LINES, ROOT, Case

MISSING = [name for name in ("pip", "setuptools", "pybind11") if importlib.util.find_spec(name) is None]


class Pip(Case):
    @unittest.skipIf(MISSING, f"not installed: {MISSING}")
    def test_pip_installs_what_can_be_imported(self):
        command = [sys.executable, "-m", "pip", "install", "--no-build-isolation", "--no-deps", "--no-index", "--quiet",
                   "--root-user-action=ignore", "--target", self.folder, ROOT]
        subprocess.run(command, check=True, timeout=240)  # in the build folder that RIDGELINE_BUILD_DIR names
        code = "import ridgeline, sys; print(ridgeline.__file__, repr(ridgeline.evaluate(*sys.argv[1:])))"
        run = subprocess.run([sys.executable, "-c", code, LINES, CLOUD], check=True, capture_output=True, text=True,
                             env={**os.environ, "PYTHONPATH": str(self.folder)})
        self.assertIn(f"{self.folder}/ridgeline/__init__.py <ridgeline.Result: 82 of 89 lines judged", run.stdout)


if __name__ == "__main__":
    unittest.main()

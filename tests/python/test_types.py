# SPDX-License-Identifier: BSD-3-Clause
import shutil
import subprocess
import sys
import unittest
from pathlib import Path

import ridgeline


class Types(unittest.TestCase):
    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_mypy_finds_nothing_in_the_package(self):
        package = Path(ridgeline.__file__).parent
        run = subprocess.run(["mypy", "--strict", "--cache-dir", "/dev/null", "--python-executable", sys.executable, package],
                             capture_output=True, text=True)
        self.assertEqual(run.returncode, 0, run.stdout)

    @unittest.skipUnless(shutil.which("mypy"), "mypy is not installed")
    def test_a_user_who_takes_text_for_a_result_is_told(self):
        code = "import ridgeline\ntext: str = ridgeline.evaluate('lines.gpkg', 'cloud.laz')\n"
        run = subprocess.run(["mypy", "--cache-dir", "/dev/null", "--python-executable", sys.executable, "-c", code],
                             capture_output=True, text=True)
        self.assertIn('has type "Result"', run.stdout)

    def test_every_public_name_is_documented(self):
        for name in ridgeline.__all__:
            if not name.startswith("__"):
                self.assertTrue(getattr(ridgeline, name).__doc__, name)


if __name__ == "__main__":
    unittest.main()

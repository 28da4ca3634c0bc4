# SPDX-License-Identifier: BSD-3-Clause
"""What the tests of the Python package share."""

import os
import subprocess
import tempfile
import unittest
import warnings
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
SAMPLE = ROOT / "sample_data" / "1"
LINES = SAMPLE / "lines.fair.geojson"
CLOUD = SAMPLE / "lidar.las"
PATCH = SAMPLE / "patch.yaml"


def program(*arguments: object) -> "subprocess.CompletedProcess[bytes]":
    """Runs the program that was built beside the package."""
    return subprocess.run([os.environ["RIDGELINE_BINARY"], *map(str, arguments)], check=True, capture_output=True)


class Case(unittest.TestCase):
    """A test with a folder of its own, in which every warning is an error."""

    def setUp(self) -> None:
        folder = tempfile.TemporaryDirectory()
        self.addCleanup(folder.cleanup)
        self.folder = Path(folder.name)
        caught = warnings.catch_warnings()
        caught.__enter__()
        self.addCleanup(caught.__exit__, None, None, None)
        warnings.simplefilter("error")

# SPDX-License-Identifier: BSD-3-Clause
"""The examples of docs/python.md and README.md, run as printed."""

import contextlib
import importlib.util
import io
import os
import re
import unittest
import warnings

from support import ROOT, Case

HAS_MATPLOTLIB = importlib.util.find_spec("matplotlib") is not None
NAMES_OF_OTHERS = {"plt": "matplotlib", "yaml": "yaml"}


def can_run(code):
    """Whether everything is installed that a block uses."""
    return all(importlib.util.find_spec(module) or not re.search(rf"\b{name}\.", code)
               for name, module in NAMES_OF_OTHERS.items())


def examples():
    """Pairs of a block of Python and what the page says it prints, if it does."""
    text = (ROOT / "README.md").read_text() + (ROOT / "docs" / "python.md").read_text()
    return re.findall(r"```python\n(.*?)```\n(?:```\n(.*?)```\n)?", text, re.DOTALL)


class Manual(Case):
    def test_examples_run_and_print_what_the_page_says(self):
        self.assertGreater(len(examples()), 5)
        (self.folder / "sample_data").symlink_to(ROOT / "sample_data")
        os.environ["MPLBACKEND"] = "Agg"
        before = os.getcwd()
        os.chdir(self.folder)
        self.addCleanup(os.chdir, before)
        warnings.simplefilter("ignore")  # of the gates, on how well the sample's sigmas fit
        names = {}
        for code, expected in examples():
            if not can_run(code):
                continue
            printed = io.StringIO()
            with contextlib.redirect_stdout(printed):
                exec(compile(code, "docs/python.md", "exec"), names)
            if expected:
                self.assertEqual(printed.getvalue().split(), expected.split(), code)

    @unittest.skipUnless(HAS_MATPLOTLIB, "matplotlib is not installed")
    def test_the_map_takes_ten_lines(self):
        drawing = [code for code, _ in examples() if "savefig" in code][0]
        self.assertLessEqual(len(drawing.strip().splitlines()), 10)


if __name__ == "__main__":
    unittest.main()

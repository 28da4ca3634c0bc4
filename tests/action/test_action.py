# SPDX-License-Identifier: BSD-3-Clause
"""action.yml, run step by step as GitHub would, and the job that the README prints.

test_action.py --program FOLDER --work FOLDER  with the program of a build, which is put on PATH
test_action.py --root FOLDER --package FILE    in a clean system; the action installs the package
(see .ci/packages)
"""
import argparse
import re
import shutil
import sys
import unittest
import xml.etree.ElementTree as ElementTree
from pathlib import Path

import yaml

from github_runner import Action, Machine

SOURCE = Path(__file__).resolve().parents[2]
SAMPLE = SOURCE / "sample_data/1"
PACKAGE = "package of ridgeline.deb"  # in the workspace
arguments = argparse.Namespace()


def readme_block(key):
    """The YAML block of the README's section on gates that has this key on top."""
    section = (SOURCE / "README.md").read_text().split("\n## Accuracy gates in CI\n")[1].split("\n## ")[0]
    blocks = [yaml.safe_load(block) for block in re.findall(r"\n```yaml\n(.*?)\n```\n", section, re.DOTALL)]
    return next(block for block in blocks if key in block)


class ActionTest(unittest.TestCase):
    def setUp(self):
        if arguments.root:
            self.machine = Machine("/tmp/action", root=arguments.root)
            self.given = {"package": PACKAGE}
            shutil.copy(arguments.package, self.machine.workspace / PACKAGE)
        else:
            self.machine = Machine(Path(arguments.work).resolve(), path=Path(arguments.program).resolve())
            self.given = {}
        self.addCleanup(shutil.rmtree, self.machine.outside(self.machine.home))

    def copy(self, source, name):
        """A file of sample patch 1 in the workspace."""
        target = self.machine.workspace / name
        target.parent.mkdir(exist_ok=True)
        shutil.copy(SAMPLE / source, target)
        return name

    def copy_sample(self):
        for file in SAMPLE.iterdir():
            self.copy(file.name, file.name)

    def write_gates(self, limit_m):
        text = f"gates: [{{metric: rms_m, max: {limit_m}}}, {{metric: evaluated_share, min: 0.5}}]\n"
        (self.machine.workspace / "gates.yaml").write_text(text)
        return "gates.yaml"

    def judge(self, **given):
        """Lines and cloud of sample patch 1, unless they are given otherwise."""
        sample = {"lines": self.copy("lines.fair.geojson", "lines.geojson"),
                  "cloud": self.copy("lidar.las", "lidar.las")}
        return Action(SOURCE).run(self.machine, {**self.given, **sample, **given})

    def n_failures(self, result):
        return int(ElementTree.parse(self.machine.workspace / result.outputs["junit"]).getroot().get("failures"))

    def test_gates_that_hold(self):
        result = self.judge(gates=self.write_gates(0.3))
        self.assertEqual(result.exit_code, 0, result.log)
        folder = "ridgeline-results"
        self.assertEqual(result.outputs, {"results": folder, "report": f"{folder}/report.html",
                                          "junit": f"{folder}/gates.xml", "passed": "true"})
        self.assertEqual(self.n_failures(result), 0)
        self.assertIn("Accuracy gate: **passed**", result.summary)
        self.assertIn("| patch | lines not_aligned | lines aligned | lines total |", result.summary)
        self.assertLessEqual({"report.html", "gates.xml", "judged.lines.gpkg"}, set(result.artifacts[folder]))

    def test_gate_that_is_broken_keeps_summary_and_artifact(self):
        result = self.judge(gates=self.write_gates(0.01), artifact="kept")
        self.assertEqual(result.exit_code, 3, result.log)
        self.assertEqual(result.outputs["passed"], "false")
        self.assertEqual(self.n_failures(result), 1)
        self.assertIn("Accuracy gate: **failed** (1 of 2 checks passed)", result.summary)
        self.assertIn("::error title=Gate", result.log)
        self.assertLessEqual({"report.html", "gates.xml"}, set(result.artifacts["kept"]))

    def test_cloud_that_is_missing(self):
        result = self.judge(cloud="missing.las", gates=self.write_gates(0.3))
        self.assertEqual(result.exit_code, 1, result.log)
        self.assertIn("ridgeline: missing.las: does not exist", result.log)
        self.assertEqual((result.summary, result.artifacts), ("", {}))
        self.assertEqual(set(result.outputs.values()), {""})

    def test_nothing_to_judge(self):
        result = self.judge(lines="", cloud="")
        self.assertEqual(result.exit_code, 1, result.log)
        self.assertIn("--lines is required", result.log)

    def test_several_files_with_spaces_and_further_arguments(self):
        lines = [self.copy(f"lines.{name}.geojson", f"my lines/{name} $(touch run) lines.geojson")
                 for name in ("good", "poor")]
        self.copy("lidar.las", "my tiles/a tile.las")
        result = self.judge(lines="\n".join(lines) + "\n", cloud="\n  my tiles/*.las\n\n", out="my results",
                            artifact="", arguments="--title 'Roofs of $(touch run)' --gross-m 0.5\n--no-report")
        self.assertEqual(result.exit_code, 0, result.log)
        self.assertEqual(result.outputs, {"results": "my results", "report": "", "junit": "", "passed": ""})
        self.assertIn("good $(touch run) lines total", result.summary)
        self.assertIn("poor $(touch run) lines total", result.summary)
        self.assertIn('"gross_m": 0.5', (self.machine.workspace / "my results/run.json").read_text())
        self.assertEqual(result.artifacts, {})
        self.assertFalse((self.machine.workspace / "run").exists(), "an input was run")

    def test_lines_and_a_patch(self):
        self.copy_sample()
        result = self.judge(cloud="", patch="patch.yaml", arguments="--no-report")
        self.assertEqual(result.exit_code, 0, result.log)
        self.assertIn("\n| 1 | ", result.summary)  # named by the patch

    def test_baseline(self):
        (self.machine.workspace / "gates.yaml").write_text("gates: [{max_increase_over_baseline: 0.02}]\n")
        earlier = self.judge(out="earlier results", artifact="")
        self.assertEqual(earlier.exit_code, 0, earlier.log)
        self.assertEqual(self.judge(gates="gates.yaml", baseline="earlier results").exit_code, 0)
        without = self.judge(gates="gates.yaml")
        self.assertEqual(without.exit_code, 3, without.log)

    def test_gates_file_that_is_wrong_leaves_no_verdict_of_an_earlier_use(self):
        self.judge(gates=self.write_gates(0.3))
        (self.machine.workspace / "gates.yaml").write_text("gates: [{metric: rms}]\n")
        result = self.judge(gates="gates.yaml")
        self.assertEqual(result.exit_code, 1, result.log)
        self.assertEqual((result.outputs["passed"], result.outputs["junit"]), ("false", ""))
        self.assertNotIn("Accuracy gate", result.summary)

    def run_readme_job(self, gates):
        """The job's steps: the checkout is the sample patch, the copy of ridgeline is this one."""
        self.copy_sample()
        (self.machine.workspace / "gates.yaml").write_text(yaml.safe_dump(gates))
        (job,) = readme_block("jobs")["jobs"].values()
        self.assertEqual(job["container"], "debian:12")
        checkout, action = job["steps"]
        self.assertEqual((checkout["uses"], action["uses"]), ("actions/checkout@v4", "OWNER/ridgeline@main"))
        return Action(SOURCE).run(self.machine, {**action["with"], "package": "", **self.given})

    def test_job_of_the_readme(self):
        gates = readme_block("gates")
        passed = self.run_readme_job(gates)
        self.assertEqual(passed.exit_code, 0, passed.log)
        self.assertIn("Accuracy gate: **passed**", passed.summary)
        self.assertIn("lines total", passed.summary)
        self.assertIn("1/lines.lines.geojson", passed.artifacts["ridgeline-results"])
        gates["gates"][0]["max"] = 0.01
        failed = self.run_readme_job(gates)
        self.assertEqual(failed.exit_code, 3, failed.log)
        self.assertIn("Accuracy gate: **failed**", failed.summary)


if __name__ == "__main__":
    parser = argparse.ArgumentParser(description=__doc__)
    for option in ("--program", "--work", "--root", "--package"):
        parser.add_argument(option)
    parser.parse_args(namespace=arguments)
    unittest.main(argv=sys.argv[:1], verbosity=2)

# SPDX-License-Identifier: BSD-3-Clause
"""Runs the steps of a composite action as GitHub's runner does, on this machine or in a root
folder.

It knows what action.yml uses, and anything else is an error: `run` steps with bash,
actions/upload-artifact, and conditions of always(), inputs and outputs of steps, joined by &&.
"""
import os
import re
import shutil
import subprocess
from dataclasses import dataclass, field
from pathlib import Path

import yaml

# .ci/packages exports this function, which runs a command in the root folder with a clean
# environment
IN_ROOT = ["bash", "-c", 'in_root "$@"', "in_root"]


@dataclass
class Result:
    exit_code: int = 0  # of the step that failed first
    log: str = ""
    summary: str = ""
    outputs: dict = field(default_factory=dict)
    artifacts: dict = field(default_factory=dict)  # name: paths of the files, relative to the folder that is kept


class Machine:
    """Where the steps run: its folder `home` holds the workspace, the action and the runner's
    files.
    """

    def __init__(self, home, root=None, path=None):
        self.home, self.root, self.path = Path(home), root, path
        shutil.rmtree(self.outside(self.home), ignore_errors=True)
        self.workspace.mkdir(parents=True)

    def outside(self, path):
        """The path as this script sees it."""
        return Path(f"{self.root}{path}") if self.root else Path(path)

    @property
    def workspace(self):
        return self.outside(self.home / "workspace")

    def run(self, script, environment):
        """The exit code and what bash printed."""
        self.outside(self.home / "step.sh").write_text(script)
        kept = {} if self.root else {k: v for k, v in os.environ.items() if not k.startswith("GITHUB_")}
        if self.path:
            kept["PATH"] = f"{self.path}:{kept['PATH']}"
        environment = {**kept, "GITHUB_ACTIONS": "true", **environment}
        command = [*(IN_ROOT if self.root else ["env", "-i"]), "env", f"--chdir={self.home}/workspace",
                   *(f"{name}={value}" for name, value in environment.items()),
                   "bash", "--noprofile", "--norc", "-eo", "pipefail", f"{self.home}/step.sh"]
        done = subprocess.run(command, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True, check=False)
        return done.returncode, done.stdout


class Action:
    def __init__(self, folder):
        self.folder = Path(folder)
        self.description = yaml.safe_load((self.folder / "action.yml").read_text())

    def run(self, machine, given):
        return _Run(self, machine, given).result


class _Run:
    """One use of an action, with the inputs that are given."""

    def __init__(self, action, machine, given):
        declared = action.description["inputs"]
        if unknown := set(given) - set(declared):
            raise ValueError(f"action.yml has no inputs {unknown}")
        self.machine = machine
        self.inputs = {name: given.get(name, about["default"]) for name, about in declared.items()}
        self.steps = action.description["runs"]["steps"]
        self.step_outputs = {step["id"]: {} for step in self.steps if "id" in step}
        self.result = Result()

        copy = machine.outside(machine.home / "action")
        shutil.rmtree(copy, ignore_errors=True)
        copy.mkdir()
        shutil.copy(action.folder / "action.yml", copy)
        shutil.copytree(action.folder / "apps/action", copy / "apps/action")
        self._file("summary").write_text("")
        for step in self.steps:
            if self._is_due(step):
                self._run_step(step)
        self.result.summary = self._file("summary").read_text()
        for name, about in action.description["outputs"].items():
            self.result.outputs[name] = self._expand(about["value"])

    def _file(self, name):
        return self.machine.outside(self.machine.home / name)

    def _is_due(self, step):
        terms = [term.strip() for term in step.get("if", "success()").split("&&")]
        if "always()" not in terms and self.result.exit_code != 0:
            return False
        return all(self._holds(term) for term in terms)

    def _holds(self, term):
        if term in ("always()", "success()"):
            return True
        if not (match := re.fullmatch(r"(\S+) (!=|==) '(.*)'", term)):
            raise ValueError(f"a condition that this test does not know: {term}")
        is_equal = self._value(match[1]) == match[3]
        return is_equal == (match[2] == "==")

    def _value(self, expression):
        if match := re.fullmatch(r"inputs\.(\w+)", expression):
            return self.inputs[match[1]]
        if match := re.fullmatch(r"steps\.(\w+)\.outputs\.(\w+)", expression):
            return self.step_outputs[match[1]].get(match[2], "")
        raise ValueError(f"an expression that this test does not know: {expression}")

    def _expand(self, text):
        return re.sub(r"\$\{\{ *(.*?) *\}\}", lambda match: self._value(match[1]), text)

    def _run_step(self, step):
        if "uses" in step:
            exit_code, log = self._use(step)
        else:
            exit_code, log = self._run_script(step)
        self.result.log += f"== {step['name']}: exit code {exit_code}\n{log}"
        self.result.exit_code = self.result.exit_code or exit_code

    def _run_script(self, step):
        if step["shell"] != "bash":
            raise ValueError("a shell that this test does not know: " + step["shell"])
        if "${{" in step["run"]:
            raise ValueError(f"{step['name']}: an expression in a script can be made to run what it holds")
        self._file("output").write_text("")
        environment = {name: self._expand(value) for name, value in step.get("env", {}).items()}
        for name, file in (("ACTION_PATH", "action"), ("OUTPUT", "output"), ("STEP_SUMMARY", "summary")):
            environment["GITHUB_" + name] = f"{self.machine.home}/{file}"
        done = self.machine.run(step["run"], environment)
        if "id" in step:
            pairs = [line.split("=", 1) for line in self._file("output").read_text().splitlines()]
            self.step_outputs[step["id"]] = dict(pairs)
        return done

    def _use(self, step):
        if step["uses"] != "actions/upload-artifact@v4":
            raise ValueError("an action that this test does not know: " + step["uses"])
        if unknown := set(step["with"]) - {"name", "path"}:
            raise ValueError(f"parameters that this test does not know: {unknown}")
        folder = self.machine.workspace / self._expand(step["with"]["path"])
        files = sorted(str(path.relative_to(folder)) for path in folder.rglob("*") if path.is_file())
        self.result.artifacts[self._expand(step["with"]["name"])] = files
        return (0, "") if files else (1, f"{folder} has no files to keep\n")

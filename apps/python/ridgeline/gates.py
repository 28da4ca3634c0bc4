# SPDX-License-Identifier: BSD-3-Clause
"""Gates on accuracy."""

from __future__ import annotations

import json
import os
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any

from ridgeline import _core
from ridgeline._arguments import Path, text_of, warn
from ridgeline.evaluation import Result


def _text_of_gates(gates: Mapping[str, Any]) -> str:
    """The gates as text with the i-th entry on the i-th line, for locating errors."""
    entries = ",\n".join(text_of(gate) for gate in gates.get("gates", ()))
    others = "".join(f", {text_of(key)}: {text_of(value)}" for key, value in gates.items() if key != "gates")
    return f'{{"gates": [{entries}]{others}}}'


@dataclass(frozen=True)
class GateReport:
    """The verdicts. Its truth value is True if all gates passed; a gate without a figure fails.

    gates: one dict per rule and figure: rule, patch, method, class, metric, value, limit,
        verdict, explanation, ...
    junit: JUnit XML. markdown: for the summary page of a CI job. text: as shown by print(), in
        aligned columns.
    """

    passed: bool
    gates: list[dict[str, Any]]
    warnings: list[str]
    junit: str
    markdown: str
    text: str

    def __bool__(self) -> bool:
        return self.passed

    def __str__(self) -> str:
        return self.text


def gate(
    results: Result | Path,
    gates: Path | Sequence[Mapping[str, Any]] | Mapping[str, Any],
    *,
    baseline: Path | None = None,
) -> GateReport:
    """Checks figures against limits, like `ridgeline gate`.

    results: a result of evaluate(), or a results folder of evaluate, run or Result.write().
    gates: a gates file (docs/gates.md), or its entries: [{"class": "total", "metric": "rms_m",
        "max": 0.3}, ...].
    baseline: results folder of an earlier run on the same data, for gates that refer to it; results
        must then also be a folder. Both must have been judged from files, because a run on arrays
        does not record hashes of its data.
    Raises ValueError for an invalid gate, FileNotFoundError and InputFileError.
    """
    file = text = ""
    if isinstance(gates, (str, os.PathLike)):
        file = os.fspath(gates)
    else:
        text = _text_of_gates(gates if isinstance(gates, Mapping) else {"gates": gates})
    before = None if baseline is None else os.fspath(baseline)
    if isinstance(results, Result):
        found = _core.gate(results._judged, file, text, before)
    else:
        found = _core.gate(os.fspath(results), file, text, before)
    report = json.loads(found["json"])
    warn(report["warnings"])
    texts = (found["junit"], found["markdown"], found["text"])
    return GateReport(found["passed"], report["gates"], report["warnings"], *texts)

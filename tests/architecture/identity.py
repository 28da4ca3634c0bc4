#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Runs the same commands with two builds of ridgeline and compares every file that they write.

identity.py BASE NEW [--quick] [--columns MAP.json] [--work DIR] [--jobs N]

BASE and NEW are programs; --quick takes sample 1 only. With --work the results of BASE are kept in
that folder and are not made again. Tables are compared by value, GeoPackages
as CSV by ogr2ogr, reports by their data, everything else by hash. run.json and the records of what
results were made from are left out. MAP.json holds {"old name": "new name"} of renamed columns and
keys. The exit code is 1 if anything differs; the folders are kept then.
"""
import argparse
import concurrent.futures
import csv
import hashlib
import json
import os
import pathlib
import re
import shutil
import subprocess
import sys
import tempfile

SOURCE = pathlib.Path(__file__).resolve().parents[2]
VAIHINGEN = SOURCE.parent / "shared/data/vaihingen/patch.yaml"
RECORDS = {"run.json", "stages.json", "done.json", ".ridgeline.lock"}
ALL_METHODS = "direct,joint,network,planes,lines"
# Of the program, of the time of a file's last change, and of keys.
VOLATILE = {"git_hash", "versions", "version", "modified_ns", "key"}


def sample_commands(sample, path):
    """Commands on one patch; those of one list run one after another."""
    patch = str(path)
    run = ["run", patch, "--jobs", "2"]
    lists = [
        [run + ["--out", f"{sample}/all", "--methods", ALL_METHODS, "--lines-format",
                "gpkg,dxf,csv"],
         ["compare", f"{sample}/all"],
         ["report", f"{sample}/all"],
         ["evaluate", "--lines", f"{sample}/all/{{id}}/lines.lines.geojson", "--patch", patch,
          "--out", f"{sample}/evaluate"]],
        [run + ["--out", f"{sample}/published", "--preset", "published", "--no-report"]],
        [run + ["--out", f"{sample}/chio", "--preset", "published", "--matcher", "chio",
                "--no-report"]],
        [["match", patch, "--out", f"{sample}/match/m.csv", "--matcher", "chio",
          "--provenance", f"{sample}/match/chio.csv", "--overlay", f"{sample}/match/m.png"],
         ["reconstruct", patch, "--matches", f"{sample}/match/m.csv", "--out",
          f"{sample}/match/lines.geojson"],
         ["match", patch, "--out", f"{sample}/match_published/m.csv", "--preset", "published"],
         ["reconstruct", patch, "--preset", "published", "--out", f"{sample}/published.gpkg"]],
    ]
    for image in sorted(path.parent.glob("*.tif")):
        lists.append([["extract", str(image), "--patch", patch, "--out",
                       f"{sample}/extract/{image.stem}.csv", "--overlay",
                       f"{sample}/extract/{image.stem}.png"]])
    for method in ALL_METHODS.split(","):
        lists.append([["reconstruct", patch, "--method", method, "--out",
                       f"{sample}/reconstruct/{method}.geojson", "--write-surface",
                       f"{sample}/reconstruct/{method}.las"]])
    return lists


def scene_commands(scenes):
    """Models and a block, of scenes that the baseline has simulated."""
    return [
        [["evaluate", "--lines", f"{scenes}/models/buildings.city.json", "--cloud",
          f"{scenes}/models/lidar.las", "--out", "models"]],
        [["block", f"{scenes}/block/block.yaml", "--out", "block", "--jobs", "2"],
         ["compare", "block", "block"]],
        [["run", f"{scenes}/views/patch.yaml", "--out", "views"]],
    ]


def simulate(base, scenes):
    for name, options in (("models", ["--no-images", "--models", "cityjson"]),
                          ("views", ["--views", "strip:3", "--extent-m", "45,45",
                                     "--samples-per-side", "1", "--focal-length-px", "7000"]),
                          ("block", ["--block", "2,3", "--frame-px", "800,700",
                                     "--samples-per-side", "1"])):
        subprocess.run([base, "simulate", "--out", scenes / name, "--seed", "3", *options],
                       check=True, stdout=subprocess.DEVNULL)


def execute(program, folder, name, commands):
    """Runs commands in a folder, unless they have been run there; what they print becomes files of
    it, too."""
    for number, words in enumerate(commands):
        output = folder / f"output.{name}.{number}.txt"
        if output.exists():
            continue
        words = [found(folder, word) for word in words]
        done = subprocess.run([program, *words], cwd=folder, capture_output=True, text=True,
                              check=False)
        text = f"{' '.join(words)}\n{done.returncode}\n{done.stdout}\n{done.stderr}"
        output.write_text(text.replace(str(folder), "FOLDER"))


def found(folder, word):
    """{id}: the only patch of a results folder."""
    if "{id}" not in word:
        return word
    return str(next(folder.glob(word.replace("{id}", "*"))).relative_to(folder))


def renamed(value, columns):
    if isinstance(value, dict):
        return {columns.get(k, k): renamed(v, columns) for k, v in value.items()
                if k not in VOLATILE}
    if isinstance(value, list):
        return [renamed(v, columns) for v in value]
    return value


def table_of(text, columns):
    """Columns by name, in any order; a file without a common width is compared as it is."""
    rows = list(csv.reader(text.splitlines()))
    if not rows or any(len(row) != len(rows[0]) for row in rows):
        return text
    return {columns.get(head, head): values for head, *values in zip(*rows)}


def content(file, columns):
    """What is compared of a file."""
    if file.suffix in {".json", ".geojson"}:
        return renamed(json.loads(file.read_text()), columns)
    if file.suffix == ".csv":
        return table_of(file.read_text(), columns)
    if file.suffix == ".html":
        data = re.search(r'id="report-data">(.*?)</script>', file.read_text(), re.S)
        return renamed(json.loads(data.group(1)), columns) if data else file.read_text()
    if file.suffix == ".gpkg":
        return {layer: table_of(text, columns) for layer, text in layers_of(file)}
    if file.name.startswith("output."):  # times are not compared
        return re.sub(r"[0-9.]+ (s|min|h|MiB)\b", "", file.read_text())
    return hashlib.sha256(file.read_bytes()).hexdigest()


def layers_of(file):
    with tempfile.TemporaryDirectory() as folder:
        subprocess.run(["ogr2ogr", "-f", "CSV", f"{folder}/csv", file, "-lco",
                        "GEOMETRY=AS_WKT"], check=True, capture_output=True)
        for table in sorted(pathlib.Path(folder).rglob("*.csv")):
            yield table.name, table.read_text()


def files_in(folder):
    return {str(f.relative_to(folder)) for f in folder.rglob("*")
            if f.is_file() and f.name not in RECORDS}


def difference(base, new, columns):
    """Why two files differ; nothing if they are the same."""
    if base.read_bytes() == new.read_bytes():
        return None
    before, after = content(base, columns), content(new, {})
    if before == after:
        return None
    if isinstance(before, dict) and isinstance(after, dict):
        names = [k for k in {**before, **after} if before.get(k) != after.get(k)]
        return "differs in " + ", ".join(map(str, names[:5]))
    return "differs"


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("base", type=pathlib.Path)
    parser.add_argument("new", type=pathlib.Path)
    parser.add_argument("--quick", action="store_true", help="sample 1 only")
    parser.add_argument("--columns", type=pathlib.Path, help="JSON of renamed columns and keys")
    parser.add_argument("--work", type=pathlib.Path, help="folder; default: a temporary one")
    parser.add_argument("--jobs", type=int, default=os.cpu_count())
    a = parser.parse_args()
    columns = json.loads(a.columns.read_text()) if a.columns else {}
    work = a.work.resolve() if a.work else pathlib.Path(tempfile.mkdtemp())
    programs = {"base": a.base.resolve(), "new": a.new.resolve()}
    scenes = work / "scenes"
    if not scenes.exists():
        simulate(programs["base"], scenes)
    shutil.rmtree(work / "new", ignore_errors=True)
    jobs = scene_commands(scenes)
    for sample in ["1"] if a.quick else ["1", "2", "3", "4", "5"]:
        jobs += sample_commands(f"sample_{sample}", SOURCE / "sample_data" / sample / "patch.yaml")
    if VAIHINGEN.exists() and not a.quick:
        jobs += sample_commands("vaihingen", VAIHINGEN)
    for name in programs:
        (work / name).mkdir(parents=True, exist_ok=True)
    with concurrent.futures.ThreadPoolExecutor(a.jobs) as pool:
        running = [pool.submit(execute, program, work / name, f"{i:02}", commands)
                   for i, commands in enumerate(jobs) for name, program in programs.items()]
        for job in running:
            job.result()
    of_base, of_new = files_in(work / "base"), files_in(work / "new")
    reasons = {name: "is written by one program only" for name in of_base ^ of_new}
    for name in of_base & of_new:
        reason = difference(work / "base" / name, work / "new" / name, columns)
        if reason:
            reasons[name] = reason
    for name, reason in sorted(reasons.items()):
        print(f"{name}: {reason}")
    print(f"{len(of_base & of_new)} files compared, {len(reasons)} differ")
    if reasons:
        print(f"kept: {work}")
        return 1
    if not a.work:
        shutil.rmtree(work)
    return 0


if __name__ == "__main__":
    sys.exit(main())

# SPDX-License-Identifier: BSD-3-Clause
"""Every command line that the help of a command or the README prints does what it says.

test_examples.py --program FILE
"""
import argparse
import json
import os
import re
import shutil
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2]
SAMPLE = SOURCE / "sample_data/1"
CORNERS = [[513002, 5403002], [513046, 5403002], [513046, 5403046], [513002, 5403046], [513002, 5403002]]
BLOCK = """block: town
crs: EPSG:25832
orientation: opk.csv
cameras: cameras.yaml
images: frames/*.tif
lidar: [lidar.las]
height_range: auto
area: [513002, 5403002, 513046, 5403046]
patch_size_m: 20
overlap_m: 8
"""
arguments = argparse.Namespace()


def shell(command, folder):
    """Runs a command line as a user would type it."""
    path = f"{Path(arguments.program).resolve().parent}:{os.environ['PATH']}"
    return subprocess.run(["/bin/sh", "-c", command], cwd=folder, env={**os.environ, "PATH": path},
                          capture_output=True, text=True)


def done(command, folder):
    result = shell(command, folder)
    if result.returncode != 0:
        raise RuntimeError(f"{command}: {result.stderr}")
    return result.stdout


def examples_of_help():
    """The lines below `Examples:` of each command's help."""
    with tempfile.TemporaryDirectory() as folder:
        commands = re.findall(r"^  ([a-z]+)  ", done("ridgeline --help", folder), re.MULTILINE)
        for command in commands:
            text = done(f"ridgeline {command} --help", folder)
            for line in text.split("\nExamples:\n")[1].splitlines():
                if line.startswith("  ridgeline "):
                    yield line.strip()


def examples_of_readme():
    """Lines of code blocks, and whole command lines within the text; the names of commands are no
    command lines.
    """
    text = (SOURCE / "README.md").read_text()
    yield from re.findall(r"^\$ (ridgeline .*)$", text, re.MULTILINE)
    for line in re.findall(r"`(ridgeline [^`]*)`", text):
        if " --out " in line:
            yield line


class Workspace:
    """The files that examples name, made once; each example gets a copy of its own."""

    def __init__(self):
        self.made = tempfile.TemporaryDirectory()
        root = Path(self.made.name)
        self.root = root
        scene = "--seed 2 --extent-m 48,48 --frame-px 4000,3000 --samples-per-side 1"
        for orientation in ("opk", "blocks_exchange"):
            done(f"ridgeline simulate --out {orientation} --orientation {orientation} {scene}", root)
        done("ridgeline simulate --out village --no-images --extent-m 60,60 --models cityjson", root)
        for name in ("left.tif", "right.tif"):
            (root / "frames").mkdir(exist_ok=True)
            os.link(root / "opk" / name, root / "frames" / name)
        shutil.copy(root / "blocks_exchange/blocks_exchange.xml", root / "block.xml")
        shutil.copy(root / "village/buildings.city.json", root / "model.city.json")
        for name in ("opk.csv", "cameras.yaml"):
            shutil.copy(root / "opk" / name, root / name)
        shutil.copytree(SAMPLE, root / "patches")
        shutil.copytree(SOURCE / "sample_data", root / "sample_data")
        # the matches of a patch are what `match` writes
        patch = (SAMPLE / "patch.yaml").read_text().replace("matches.csv", "reference.csv")
        for folder in (root, root / "patches"):
            (folder / "patch.yaml").write_text(patch)
            shutil.copy(SAMPLE / "matches.csv", folder / "reference.csv")
        for name in ("left.tif", "right.tif", "lidar.las", "truth.geojson"):
            shutil.copy(SAMPLE / name, root / name)
        for copy in ("lidar.laz", "scan.laz", "tiles/1.laz"):  # the content says that it is LAS
            (root / copy).parent.mkdir(exist_ok=True)
            shutil.copy(root / ("village/lidar.las" if copy == "scan.laz" else "lidar.las"), root / copy)
        shutil.copy(SAMPLE / "lines.good.geojson", root / "a.geojson")
        (root / "gates.yaml").write_text("gates: [{metric: rms_m, class: total, max: 10}]\n")
        area = {"type": "Polygon", "coordinates": [CORNERS]}
        (root / "area.geojson").write_text(json.dumps({
            "type": "FeatureCollection", "crs": {"type": "name", "properties": {"name": "EPSG:25832"}},
            "features": [{"type": "Feature", "properties": {}, "geometry": area}]}))
        done("ridgeline reconstruct patch.yaml --out b.dxf", root)
        done("ridgeline reconstruct patch.yaml --out roofs.gpkg", root)
        done("ridgeline match patch.yaml --out matches.csv", root)
        for folder in ("results", "before", "after", "ours", "theirs", "others"):
            done(f"ridgeline evaluate --lines a.geojson --cloud lidar.las --out {folder}", root)
        for folder, x_min, x_max in (("runs/1", 513000, 513025), ("runs/2", 513025, 513100)):
            area = f"{x_min},5403000,{x_max},5403100"
            done(f"ridgeline evaluate --lines a.geojson --cloud lidar.las --area {area} --out {folder}", root)

    def copy(self, example, folder):
        """All files but those that the example writes."""
        shutil.copytree(self.root, folder, dirs_exist_ok=True)
        words = example.replace(";", " ").split()
        written = [words[i + 1] for i, word in enumerate(words[:-1]) if word in ("--out", "--init", ">")]
        reads_results = " --out " not in example
        for name in written:
            path = folder / name
            if path.is_dir() and not reads_results:
                shutil.rmtree(path)
            elif path.is_file():
                path.unlink()
        if example.startswith("ridgeline match"):
            for segments in folder.glob("segments.*.csv"):
                segments.unlink()
        if example.startswith("ridgeline simulate"):
            shutil.rmtree(folder / "village", ignore_errors=True)
        if example.startswith("ridgeline block"):
            (folder / "block.yaml").write_text(BLOCK)
            shutil.copy(folder / "opk/lidar.las", folder / "lidar.las")
        if example.startswith("ridgeline patch"):
            shutil.copy(folder / "opk/lidar.las", folder / "tiles/1.laz")
            if "area.geojson" not in example:
                # the area is larger than what these frames show
                shutil.copytree(folder / "blocks_exchange", folder / "frames", dirs_exist_ok=True)


class Examples(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.workspace = Workspace()

    @classmethod
    def tearDownClass(cls):
        cls.workspace.made.cleanup()

    def check(self, examples, fewest):
        examples = list(examples)
        self.assertGreaterEqual(len(examples), fewest)
        for example in examples:
            with self.subTest(example), tempfile.TemporaryDirectory() as folder:
                self.workspace.copy(example, Path(folder))
                result = shell(example, folder)
                self.assertEqual(result.returncode, 0, result.stderr)

    def test_of_help(self):
        self.check(examples_of_help(), 28)

    def test_of_the_readme(self):
        self.check(examples_of_readme(), 4)


if __name__ == "__main__":
    parser = argparse.ArgumentParser()
    parser.add_argument("--program", required=True)
    arguments, rest = parser.parse_known_args()
    unittest.main(argv=[sys.argv[0], *rest])

# SPDX-License-Identifier: BSD-3-Clause
import json
import re
import sqlite3
import unittest

import numpy as np
import ridgeline
from support import CLOUD, LINES, PATCH, Case, program



def sample_views():
    """The cameras of sample patch 1; images are not needed."""
    rows = [[float(number) for number in row.split(",")] for row in re.findall(r"- \[(.*)\]", PATCH.read_text())]
    image = np.zeros((1, 1), np.uint8)
    return [ridgeline.View(image, np.array(rows[:3]), "left"), ridgeline.View(image, np.array(rows[3:]), "right")], (229, 280)


#: Points are reduced to the local frame from map coordinates either way, which rounds them differently.
ROUNDING_M = 1e-9


class EvaluateJudgesAsTheProgramDoes(Case):
    def test_files_give_the_same_figures_bit_by_bit(self):
        program("evaluate", "--lines", LINES, "--cloud", CLOUD, "--out", self.folder / "out", "--no-report")
        written = json.loads((self.folder / "out" / "evaluation.lines.fair.json").read_text())
        self.assertEqual(ridgeline.evaluate(LINES, CLOUD).to_dict(), written)

    def test_options_reach_the_judge(self):
        program("evaluate", "--lines", LINES, "--cloud", CLOUD, "--patch", PATCH, "--lidar-sigma-m", 0.02, "--classes",
                "2,6", "--bounds", "513000,5403000,513030,5403065", "--gross-m", 0.2, "--bootstrap-seed", 7, "--out",
                self.folder / "out", "--no-report")
        written = json.loads((self.folder / "out" / "evaluation.lines.fair.json").read_text())
        result = ridgeline.evaluate(LINES, CLOUD, patch=PATCH, lidar_sigma_m=0.02, classes=[2, 6],
                                    bounds=(513000, 5403000, 513030, 5403065), gross_m=0.2, bootstrap_seed=7)
        self.assertEqual(result.to_dict(), written)

    def test_the_folder_it_writes_is_that_of_the_program(self):
        program("evaluate", "--lines", LINES, "--cloud", CLOUD, "--out", self.folder / "out", "--no-report")
        ridgeline.evaluate(LINES, CLOUD).write(self.folder / "ours")
        for file in (self.folder / "out").iterdir():
            if file.name == "run.json":  # has times
                continue
            self.assertEqual(file.read_bytes(), (self.folder / "ours" / file.name).read_bytes(), file.name)
        run = json.loads((self.folder / "ours" / "run.json").read_text())
        self.assertEqual([entry["role"] for entry in run["inputs"]], ["lines", "cloud"])


    def test_a_report_of_the_folder_shows_lines_and_points(self):
        options = {"classes": [6], "bounds": (513000, 5403000, 513060, 5403065)}
        ridgeline.evaluate(LINES, CLOUD, **options).write(self.folder / "ours")
        self.assertEqual(program("report", self.folder / "ours").stderr, b"")  # or what it cannot show
        program("evaluate", "--lines", LINES, "--cloud", CLOUD, "--out", self.folder / "out", "--no-report",
                "--classes", 6, "--bounds", ",".join(map(str, options["bounds"])))
        ours, theirs = (json.loads((self.folder / name / "run.json").read_text()) for name in ("ours", "out"))
        self.assertEqual(ours["options"], theirs["options"])


    def test_lines_say_how_many_images_support_them(self):
        collection = json.loads(LINES.read_text())
        collection["features"] = collection["features"][:3]
        collection["features"][0]["properties"].update(n_images=5, class_base="aligned")
        collection["features"][1]["properties"].update(n_images=2)
        (self.folder / "lines.geojson").write_text(json.dumps(collection))
        lines = ridgeline.evaluate(self.folder / "lines.geojson", CLOUD).lines
        np.testing.assert_array_equal(lines["n_images"], [5, 2, np.nan])
        np.testing.assert_array_equal(lines["class_base"], ["aligned", "", ""])


class LinesThatWereMovedOnPurpose(Case):
    def test_are_figures_by_kind_and_distance(self):
        result = ridgeline.evaluate(LINES, CLOUD)
        self.assertEqual([(row["kind"], row["distance_m"]) for row in result.decoys],
                         [(kind, distance_m) for kind in ("height", "across") for distance_m in (0.5, 1, 2, 5)])
        for row in result.decoys:
            self.assertGreater(row["n_decoys"], 0)
            self.assertTrue(row["ci95"][0] <= row["share"] <= row["ci95"][1])
        self.assertEqual([row["n_decoys"] for row in result.tables["decoys"]],
                         [row["n_decoys"] for row in result.decoys])

    def test_are_as_many_as_asked_for(self):
        with_none = ridgeline.evaluate(LINES, CLOUD, decoys=0)
        self.assertEqual(with_none.decoys, [])
        self.assertNotIn("decoys", with_none.tables)
        # those of lines that were not judged do not count
        n_decoys = sum(row["n_decoys"] for row in ridgeline.evaluate(LINES, CLOUD, decoys=100).decoys)
        self.assertTrue(90 <= n_decoys <= 100, n_decoys)
        with self.assertRaisesRegex(ValueError, "decoys = -1"):
            ridgeline.evaluate(LINES, CLOUD, decoys=-1)

    def test_of_images_include_false_matches(self):
        found = ridgeline.reconstruct(PATCH)
        decoys = ridgeline.evaluate(found, CLOUD, patch=PATCH).decoys
        self.assertEqual({row["kind"] for row in decoys}, {"height", "across", "match"})
        gate = {"metric": "decoy_share", "kind": "match", "distance_m": 5, "max": 0.5}
        result = ridgeline.evaluate(found, CLOUD, patch=PATCH)
        self.assertTrue(ridgeline.gate(result, [gate]).passed)


class EdgesOfTheScan(Case):
    def test_are_compared_on_request(self):
        result = ridgeline.evaluate(LINES, CLOUD, completeness=True, decoys=0)
        found = result.completeness
        rows = {row["kind"]: row for row in found["rows"] if row["length"] == "all"}
        self.assertEqual(rows["all"]["n"], len(found["edges"]))
        self.assertEqual(rows["all"]["n_found"], sum(edge["covered_share"] >= 0.5 for edge in found["edges"]))
        self.assertEqual(found["area_from"], "lines")
        self.assertEqual([row["n"] for row in result.tables["completeness"]], [row["n"] for row in found["rows"]])
        gate = {"metric": "scan_recall", "min": 0.01}
        self.assertTrue(ridgeline.gate(result, [gate]).passed)

    def test_are_left_out_by_default(self):
        result = ridgeline.evaluate(LINES, CLOUD, decoys=0)
        self.assertIsNone(result.completeness)
        self.assertNotIn("completeness", result.tables)


class EvaluateTakesArrays(Case):
    def setUp(self):
        super().setUp()
        self.by_files = ridgeline.evaluate(LINES, CLOUD)
        self.lines = ridgeline.read_lines(LINES)
        self.cloud = ridgeline.read_cloud(CLOUD)

    def assert_same(self, result):
        np.testing.assert_array_equal(result.lines["status"], self.by_files.lines["status"])
        np.testing.assert_allclose(result.lines["mean_distance_m"], self.by_files.lines["mean_distance_m"],
                                   rtol=0, atol=ROUNDING_M)

    def test_lines_and_clouds_in_memory_are_judged_as_their_files_are(self):
        self.assert_same(ridgeline.evaluate(self.lines, self.cloud))
        self.assert_same(ridgeline.evaluate(LINES, self.cloud))
        self.assert_same(ridgeline.evaluate(self.lines, CLOUD))

    def test_plain_arrays_are_lines_and_points(self):
        ids = [str(i) for i in range(len(self.lines))]  # which seed the sample consensus
        expected = ridgeline.evaluate(ridgeline.Lines(self.lines.segments, ids=ids), CLOUD).lines["mean_distance_m"]
        result = ridgeline.evaluate(self.lines.segments.reshape(-1, 6), np.array(self.cloud.xyz))
        np.testing.assert_allclose(result.lines["mean_distance_m"], expected, rtol=0, atol=ROUNDING_M)
        self.assertEqual(list(result.lines["id"]), ids)
        self.assertEqual(list(result.classes), ["total"])

    def test_a_shift_of_all_lines_is_told_and_taken_away_on_request(self):
        raised = self.lines.segments + [0, 0, 0.5]
        with self.assertWarnsRegex(UserWarning, "all lines are shifted from the LIDAR planes"):
            result = ridgeline.evaluate(raised, CLOUD)
        self.assertTrue(result.shift["significant"])
        self.assertAlmostEqual(result.shift["axes"]["z"]["shift_m"], 0.5, delta=0.1)  # of lines that err by 0.2 m
        with self.assertWarnsRegex(UserWarning, "They were moved against it"):
            moved = ridgeline.evaluate(raised, CLOUD, apply_shift=True)
        np.testing.assert_allclose(moved.segments, raised - moved.shift["told_m"], rtol=0, atol=ROUNDING_M)
        self.assertLess(moved.classes["total"]["rms_m"], result.classes["total"]["rms_m"])
        self.assertFalse(ridgeline.evaluate(self.lines, CLOUD).shift["significant"])

    def test_classes_of_a_cloud_in_memory_are_filtered(self):
        ground = ridgeline.Cloud.of(self.cloud.xyz, classification=2, crs=self.cloud.crs)
        noise = ridgeline.Cloud.of(self.cloud.xyz + [0, 0, 1], classification=7, crs=self.cloud.crs)
        both = ridgeline.Cloud(np.concatenate([ground.points, noise.points]), self.cloud.crs)
        self.assert_same(ridgeline.evaluate(self.lines, both))

    def test_withheld_points_are_left_out_unless_asked_for(self):
        withheld = self.cloud.points.copy()
        withheld["flags"] = 4
        with self.assertRaisesRegex(ValueError, "cloud: none of 21544 points are left: .* 21544 withheld"):
            ridgeline.evaluate(self.lines, ridgeline.Cloud(withheld, self.cloud.crs))
        self.assert_same(ridgeline.evaluate(self.lines, ridgeline.Cloud(withheld, self.cloud.crs), include_withheld=True))

    def test_cameras_in_memory_are_evidence_as_those_of_a_patch_are(self):
        views, heights = sample_views()
        found = ridgeline.reconstruct(PATCH)
        by_patch = ridgeline.evaluate(found, self.cloud, patch=PATCH)
        by_views = ridgeline.evaluate(found, self.cloud, views=views, height_range_m=heights)
        np.testing.assert_array_equal(by_views.lines["status"], by_patch.lines["status"])
        np.testing.assert_allclose(by_views.lines["mean_distance_m"], by_patch.lines["mean_distance_m"],
                                   rtol=0, atol=ROUNDING_M)

    def test_a_part_of_a_cloud_is_a_cloud(self):
        self.assert_same(ridgeline.evaluate(self.lines, self.cloud.points))
        west = ridgeline.Cloud(self.cloud.points[self.cloud.points["x"] < 513030], self.cloud.crs)
        by_bounds = ridgeline.evaluate(self.lines, self.cloud, bounds=(0, 0, 513029.999999, 1e7))
        np.testing.assert_array_equal(ridgeline.evaluate(self.lines, west).lines["status"], by_bounds.lines["status"])

    def test_feet_become_metres(self):
        foot_m = 1200 / 3937
        crs = "+proj=utm +zone=32 +ellps=GRS80 +units=us-ft +vunits=us-ft +type=crs"
        points = ridgeline.Cloud.of(self.cloud.xyz / foot_m, crs=crs)
        lines = ridgeline.Lines(self.lines.segments / foot_m, ids=self.lines.ids, crs=crs)
        metres = ridgeline.Lines(self.lines.segments, ids=self.lines.ids)
        np.testing.assert_allclose(ridgeline.evaluate(lines, points).lines["mean_distance_m"],
                                   ridgeline.evaluate(metres, np.array(self.cloud.xyz)).lines["mean_distance_m"],
                                   rtol=0, atol=1e-6)  # a sample consensus sees other roundings

    def test_reference_lines_add_errors(self):
        shifted = ridgeline.Lines(self.lines.segments + [0, 0, 0.1], ids=self.lines.ids, crs=self.lines.crs)
        tables = ridgeline.evaluate(shifted, CLOUD, reference_lines=self.lines).tables
        self.assertIn("reference_errors", tables)
        self.assertNotIn("reference_errors", self.by_files.tables)


class GateReportIsText(Case):
    def test_printed_it_is_the_table_of_the_program(self):
        program("evaluate", "--lines", LINES, "--cloud", CLOUD, "--out", self.folder / "out", "--no-report")
        gates = self.folder / "gates.yaml"
        gates.write_text("gates: [{metric: rms_m, max: 0.3}]\n")
        printed = program("gate", self.folder / "out", "--gates", gates).stdout.decode()
        report = ridgeline.gate(self.folder / "out", gates)
        self.assertEqual(str(report), printed)
        self.assertIn("total rms_m <= 0.3  lidar", printed)
        self.assertIn("| total rms_m \\<= 0.3 | lidar |", report.markdown)


class ResultTellsWhatWasFound(Case):
    def setUp(self):
        super().setUp()
        self.result = ridgeline.evaluate(LINES, CLOUD)

    def test_rms_of_the_lines_is_that_of_the_table(self):
        e = self.result.lines["mean_distance_m"]
        rms = np.sqrt(np.nanmean(e**2))
        self.assertAlmostEqual(rms, self.result.classes["total"]["rms_m"], places=12)
        total = [row for row in self.result.tables["table2"] if row["class"] == "total"][0]
        self.assertEqual(total["rms_m"], round(rms, 3))

    def test_the_headline_is_of_the_lines_that_plan_and_images_decided_on(self):
        e = self.result.lines["mean_distance_m"]
        e = e[np.isfinite(e) & ~np.isin(self.result.lines["decided_by"], ["points", "place"])]
        rms = np.sqrt(np.mean(e**2))
        headline = self.result.classes["total"]["decided_by"]["plan_images"]
        self.assertAlmostEqual(headline["rms_m"], rms, places=12)
        self.assertIn(f"{rms:.3f}", str(self.result))
        self.assertIn(f"{rms:.3f} m", repr(self.result))
        squares = np.sort(e**2)[::-1].cumsum()
        n = int(np.searchsorted(squares, squares[-1] / 2)) + 1
        self.assertEqual(headline["n_half_of_squares"], n)
        self.assertIn(f"{n} of {len(e)} lines contribute half of the sum of squares", str(self.result))

    def test_each_line_names_its_surface_or_nothing(self):
        lines = self.result.lines
        for name in ("surface", "surface_other", "surface_probability", "decided_by"):
            self.assertEqual(lines[name].shape, (89,))
        self.assertLessEqual(set(lines["surface"]), {"", "upper", "lower", "ground", "ridge", "object"})
        self.assertEqual(set(lines["decided_by"][lines["status"] != "evaluated"]), {""})

    def test_lines_lie_at_their_distance_from_their_planes(self):
        other_fit_m = 0.05  # a plane of several lines is shown as fitted to the most points
        planes = {plane["id"]: plane for plane in self.result.planes}
        n = 0
        for i, ids in enumerate(self.result.lines["plane_ids"]):
            if self.result.lines["kind"][i] != "step":
                continue
            plane = planes[ids[0]]
            ends = self.result.segments[i] @ plane["normal"] + plane["offset_m"]
            if ends[0] * ends[1] > 0:
                self.assertAlmostEqual(ends.mean(), self.result.lines["signed_mean_m"][i], delta=other_fit_m)
                n += 1
            middle = plane["outline"].mean(axis=0)
            self.assertAlmostEqual(middle @ plane["normal"] + plane["offset_m"], 0.0, places=6)
        self.assertGreater(n, 20)

    def test_the_map_has_every_line(self):
        file = self.folder / "map.gpkg"
        self.result.to_geopackage(file)
        with sqlite3.connect(file) as map_file:
            self.assertEqual(map_file.execute("SELECT count(*) FROM lines").fetchone(), (89,))

    def test_texts_of_tables_stay_texts(self):
        named = ridgeline.evaluate(LINES, CLOUD, name="007")
        self.assertEqual(named.tables["table2"][0]["patch"], "007")

    def test_nothing_is_written_over(self):
        folder = self.folder / "mine"
        folder.mkdir()
        (folder / "quality.csv").write_text("mine")
        with self.assertRaisesRegex(FileExistsError, "mine: is not empty; overwrite=True"):
            self.result.write(folder)
        self.assertEqual((folder / "quality.csv").read_text(), "mine")
        file = self.folder / "map.gpkg"
        file.write_text("mine")
        with self.assertRaisesRegex(FileExistsError, "overwrite=True"):
            self.result.to_geopackage(file)
        self.assertEqual(file.read_text(), "mine")
        self.result.to_geopackage(file, overwrite=True)
        lines = self.folder / "lines.geojson"
        ridgeline.write_lines(lines, ridgeline.read_lines(LINES))
        judged = ridgeline.evaluate(lines, CLOUD)
        with self.assertRaisesRegex(OSError, "is an input"):
            judged.to_geopackage(lines, overwrite=True)


if __name__ == "__main__":
    unittest.main()

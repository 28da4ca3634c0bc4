# SPDX-License-Identifier: BSD-3-Clause
import copy
import pickle
import re
import unittest
import warnings

import numpy as np
import ridgeline
from support import CLOUD, LINES, PATCH, ROOT, SAMPLE, Case, program

SHARED = ROOT.parent / "shared" / "data"
EAVES_M, RIDGE_M, HALF_WIDTH_M, HALF_LENGTH_M = 5.0, 8.0, 6.0, 10.0


def house_from_above(x_m):
    """A gabled roof, its ridge along y, from 100 m above (x_m, 0): 600 x 600 pixels of 0.1 m on the
    ground.
    """
    size, samples = 600, 4
    slope = (RIDGE_M - EAVES_M) / HALF_WIDTH_M
    pixel = (np.arange(size * samples) + 0.5) / samples - 0.5
    across = (pixel[None, :] - 300.0) / 1000.0
    down = (pixel[:, None] - 300.0) / 1000.0
    image = np.full((size * samples, size * samples), 60.0)
    for side, grey in ((-1.0, 200.0), (1.0, 130.0)):  # z = RIDGE_M - slope * side * x
        x = (x_m + across * (100.0 - RIDGE_M)) / (1.0 - slope * side * across)
        y = -down * (100.0 - RIDGE_M + slope * side * x)
        image[(side * x >= 0) & (side * x <= HALF_WIDTH_M) & (np.abs(y) <= HALF_LENGTH_M)] = grey
    image = image.reshape(size, samples, size, samples).mean(axis=(1, 3))
    matrix = [[1000, 0, -300, 30000 - 1000 * x_m], [0, -1000, -300, 30000], [0, 0, -1, 100]]
    return ridgeline.View(np.round(image).astype(np.uint8), np.array(matrix), id=f"at {x_m}")


class ReadCloud(Case):
    def test_coordinates_are_those_of_the_file(self):
        cloud = ridgeline.read_cloud(CLOUD)
        steps = cloud.xyz / 0.001  # the file's scale
        np.testing.assert_allclose(steps, np.round(steps), rtol=0, atol=1e-5)
        self.assertEqual(cloud.counts["read"] - cloud.counts["dropped_class"], len(cloud))
        self.assertIn("UTM zone 32N", cloud.crs)

    def test_coordinates_are_a_view_of_the_points(self):
        cloud = ridgeline.read_cloud(CLOUD)
        np.testing.assert_array_equal(cloud.xyz[:, 2], cloud.points["z"])
        self.assertTrue(np.shares_memory(cloud.xyz, cloud.points))

    def test_bounds_and_classes_choose(self):
        whole = ridgeline.read_cloud(CLOUD)
        bounds = (513010.0, 5403010.0, 513020.0, 5403020.0)
        part = ridgeline.read_cloud(CLOUD, bounds=bounds, classes=[2])
        x, y = whole.points["x"], whole.points["y"]
        inside = (x >= bounds[0]) & (x <= bounds[2]) & (y >= bounds[1]) & (y <= bounds[3])
        np.testing.assert_array_equal(part.points, whole.points[inside & (whole.points["classification"] == 2)])
        self.assertGreater(len(part), 100)

    def test_the_points_outlive_the_cloud(self):
        points = ridgeline.read_cloud(CLOUD).xyz
        self.assertTrue(np.isfinite(np.array(points)).all())

    @unittest.skipUnless(SHARED.exists(), "shared/data is not beside the checkout")
    def test_real_laz_and_copc_hold_the_points_of_their_las(self):
        ign = SHARED / "ign" / "test_data_77060_627760_LA93_IGN69.las"
        np.testing.assert_array_equal(ridgeline.read_cloud(ign.with_suffix(".laz")).points, ridgeline.read_cloud(ign).points)
        with warnings.catch_warnings():
            warnings.simplefilter("ignore")  # these state no reference system
            las = ridgeline.read_cloud(SHARED / "las_samples" / "laspy_simple.las").points
            copc = ridgeline.read_cloud(SHARED / "las_samples" / "laspy_simple.copc.laz").points
        self.assertEqual(len(copc), len(las))
        for name in ("x", "y", "z", "intensity"):  # nodes are in another order; offsets differ, which rounds
            np.testing.assert_allclose(np.sort(copc[name]), np.sort(las[name]), rtol=0, atol=1e-6)

    def test_a_cloud_can_be_sent_to_another_process(self):
        cloud = ridgeline.read_cloud(CLOUD)
        np.testing.assert_array_equal(pickle.loads(pickle.dumps(cloud)).points, cloud.points)
        self.assertEqual(copy.deepcopy(cloud).counts, cloud.counts)

    def test_no_class_and_codes_that_are_none_are_refused(self):
        with self.assertRaisesRegex(ValueError, "classes: none, must be at least one"):
            ridgeline.read_cloud(CLOUD, classes=[])
        with self.assertRaisesRegex(ValueError, "bounds: 0 numbers"):
            ridgeline.read_cloud(CLOUD, bounds=[])
        for codes in (300, -1, 2.5):
            with self.assertRaisesRegex(ValueError, "classification: must be whole numbers from 0 to 255"):
                ridgeline.Cloud.of(np.zeros((2, 3)), classification=codes)

    def test_patterns_are_expanded(self):
        self.assertEqual(len(ridgeline.read_cloud([str(SAMPLE / "lid*.las")])), len(ridgeline.read_cloud(CLOUD)))


class LinesInMemory(Case):
    def test_a_mask_makes_lines_of_a_part(self):
        lines = ridgeline.read_lines(LINES)
        aligned = lines[lines.line_class == "aligned"]
        self.assertEqual(len(aligned), 19)
        self.assertEqual(set(aligned.line_class), {"aligned"})
        np.testing.assert_array_equal(aligned.covariance_m2, lines.covariance_m2[lines.line_class == "aligned"])
        self.assertEqual((len(lines[:5]), repr(lines[[3]])), (5, "<ridgeline.Lines: 1 lines>"))

    def test_texts_are_one_for_each_line(self):
        segments = np.zeros((2, 2, 3))
        self.assertEqual(list(ridgeline.Lines(segments, ids=[7, 8]).ids), ["7", "8"])
        for ids in ("ab", [None, "b"], [b"a", "b"]):
            with self.assertRaisesRegex(TypeError, "ids: "):
                ridgeline.Lines(segments, ids=ids)

    def test_masked_ends_are_not_finite(self):
        lines = ridgeline.Lines(np.ma.masked_equal(np.arange(6.0).reshape(1, 6), 2.0))
        self.assertTrue(np.isnan(lines.segments[0, 0, 2]))


class LinesInFiles(Case):
    def test_what_is_written_is_read_again(self):
        lines = ridgeline.read_lines(LINES)
        file = self.folder / "lines.gpkg"
        self.assertEqual(ridgeline.write_lines(file, lines), 0)
        again = ridgeline.read_lines(file)
        np.testing.assert_allclose(again.segments, lines.segments, rtol=0, atol=1e-4)
        np.testing.assert_allclose(again.covariance_m2, lines.covariance_m2, rtol=1e-5)
        np.testing.assert_array_equal(again.ids, lines.ids)
        np.testing.assert_array_equal(again.line_class, lines.line_class)

    def test_an_unknown_ending_is_refused(self):
        with self.assertRaisesRegex(ValueError, "lines.doc: .*must be one of .geojson"):
            ridgeline.write_lines(self.folder / "lines.doc", np.zeros((1, 6)))


def pose_and_camera(matrix, size_px):
    """The row of a table of orientations, and the entry of a file of cameras, of a projection
    matrix without skew.
    """
    m = matrix / np.linalg.norm(matrix[2, :3])
    m *= np.sign(np.linalg.det(m[:, :3]))
    centre = np.linalg.solve(m[:, :3], -m[:, 3])
    point_px = m[:2, :3] @ m[2, :3]
    axes = m[:, :3].copy()
    axes[:2] -= np.outer(point_px, m[2, :3])
    focal_px = np.linalg.norm(axes[0])
    axes[:2] /= focal_px
    r = axes.T @ np.diag([1.0, -1.0, -1.0])
    angles = np.degrees([np.arctan2(-r[1, 2], r[2, 2]), np.arcsin(r[0, 2]), np.arctan2(-r[0, 1], r[0, 0])])
    right, down = point_px - (np.array(size_px) - 1) / 2
    camera = (f"{{focal_length_mm: {focal_px!r}, pixel_size_um: 1000, size_px: {list(size_px)}, "
              f"principal_point_mm: [{right!r}, {-down!r}]}}")
    return ",".join(repr(float(number)) for number in (*centre, *angles)), camera


class Reconstruct(Case):
    def test_a_patch_takes_its_cameras_from_an_orientation(self):
        numbers = re.findall(r"- \[(.*)\]", PATCH.read_text())
        matrices = np.array([row.split(",") for row in numbers], dtype=float).reshape(2, 3, 4)
        sizes = re.findall(r"(\d+) x (\d+) px", program("info", PATCH).stdout.decode())
        table, cameras = "name,x,y,z,omega,phi,kappa,camera\n", ""
        for name, matrix, size in zip(("left", "right"), matrices, sizes):
            pose, camera = pose_and_camera(matrix, tuple(map(int, size)))
            table += f"{name},{pose},{name}\n"
            cameras += f"{name}: {camera}\n"
        (self.folder / "opk.csv").write_text(table)
        (self.folder / "cameras.yaml").write_text(cameras)
        patch = self.folder / "patch.yaml"
        patch.write_text("id: 1\ncrs: EPSG:25832\nheight_range: [229, 280]\norientation: opk.csv\n"
                         f"cameras: cameras.yaml\nimages: [path: {SAMPLE}/left.tif, path: {SAMPLE}/right.tif]\n")
        with self.assertWarnsRegex(UserWarning, "opk.csv: .*Determined: angles in deg "):
            lines = ridgeline.reconstruct(patch, method="direct")
        self.assertEqual(len(lines), len(ridgeline.reconstruct(PATCH, method="direct")))
        (self.folder / "opk.csv").unlink()
        with self.assertRaisesRegex(Exception, "opk.csv: no such file"):
            ridgeline.reconstruct(patch)

    def test_a_patch_gives_the_lines_of_the_program(self):
        file = self.folder / "lines.geojson"
        program("reconstruct", PATCH, "--method", "network", "--out", file)
        expected = ridgeline.read_lines(file)
        lines = ridgeline.reconstruct(PATCH, method="network")
        np.testing.assert_allclose(lines.segments, expected.segments, rtol=0, atol=1e-4)  # m, of the file
        for name in ("ids", "line_class", "status"):
            np.testing.assert_array_equal(getattr(lines, name), getattr(expected, name))

    def test_views_in_memory_show_a_roof_where_it_is(self):
        views = [house_from_above(x_m) for x_m in (-15.0, 15.0)]
        with self.assertWarnsRegex(UserWarning, "views: .* have only 4 tie points"):  # of a house without texture
            lines = ridgeline.reconstruct(views, (-2.0, 12.0), crs="EPSG:25832")
        self.assertEqual(lines.crs, "EPSG:25832")
        for x_m, z_m in ((0.0, RIDGE_M), (-HALF_WIDTH_M, EAVES_M), (HALF_WIDTH_M, EAVES_M)):
            expected = np.array([[x_m, -HALF_LENGTH_M, z_m], [x_m, HALF_LENGTH_M, z_m]])
            misses = np.abs(np.sort(lines.segments, axis=1) - expected).max(axis=(1, 2))
            self.assertLess(np.nanmin(misses), 0.2)  # m, two pixels on the ground

    def test_views_are_checked(self):
        image, matrix = np.zeros((8, 8), np.uint8), np.eye(3, 4)
        for rule, view in ((r"image of a: type float64; must be uint8 or uint16", (image.astype(float), matrix)),
                           (r"image of a: the shape is \(8, 8, 5\)", (np.zeros((8, 8, 5), np.uint8), matrix)),
                           (r"matrix of a: the shape is \(3, 3\); must be \(3, 4\)", (image, np.eye(3)))):
            with self.assertRaisesRegex(ValueError, rule):
                ridgeline.reconstruct([ridgeline.View(*view, id="a")] * 2, (0, 10))
        for rule, heights, matrices in (("height_range_m = 10 to 0", (10, 0), [house_from_above(0).matrix] * 2),
                                        ("height_range_m: 1 numbers", (0,), [matrix] * 2),
                                        ("view a: its projection matrix must be finite", (0, 10), [np.full((3, 4), np.nan)] * 2),
                                        ("views: 1, must be two", (0, 10), [matrix])):
            with self.assertRaisesRegex(ValueError, rule), warnings.catch_warnings():
                warnings.simplefilter("ignore")
                ridgeline.reconstruct([ridgeline.View(image, m, id="a") for m in matrices], heights)
        with self.assertRaisesRegex(ValueError, "height_range_m: is required"):
            ridgeline.reconstruct([])
        with self.assertRaisesRegex(TypeError, "must be View objects"):
            ridgeline.reconstruct([(image, matrix)] * 2, (0, 10))
        with self.assertRaisesRegex(ValueError, "view b: bands = 3, must be as many as those of view a, 1"):
            left, right = (house_from_above(x_m) for x_m in (-15.0, 15.0))
            ridgeline.reconstruct([ridgeline.View(left.image, left.matrix, "a"),
                                   ridgeline.View(np.dstack([right.image] * 3), right.matrix, "b")], (-2, 12))
        with self.assertRaisesRegex(ValueError, "method = x, must be one of lines, network, joint"):
            ridgeline.reconstruct(PATCH, method="x")


if __name__ == "__main__":
    unittest.main()

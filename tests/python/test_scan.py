# SPDX-License-Identifier: BSD-3-Clause
import unittest

import numpy as np
import ridgeline
from support import CLOUD, Case


class Edges(Case):
    def test_have_kinds_planes_covariances_and_support(self):
        edges = ridgeline.edges(CLOUD)
        self.assertGreater(len(edges), 10)
        self.assertLessEqual(set(edges.kind), {"ridge", "hip", "valley", "eave", "verge", "step"})
        self.assertEqual([len(ids) for ids in edges.plane_ids[edges.kind == "ridge"]], [2] * np.sum(edges.kind == "ridge"))
        self.assertTrue((np.diagonal(edges.covariance_m2, axis1=1, axis2=2) >= 0).all())
        self.assertTrue(((edges.support > 0) & (edges.support <= 1)).all())
        self.assertTrue((edges.moved_out_m[edges.kind == "ridge"] == 0).all())
        self.assertIn("UTM zone 32N", edges.crs)

    def test_are_the_same_for_a_file_and_its_points(self):
        of_file = ridgeline.edges(CLOUD)
        cloud = ridgeline.read_cloud(CLOUD)
        np.testing.assert_array_equal(ridgeline.edges(cloud).segments, of_file.segments)
        np.testing.assert_array_equal(ridgeline.edges(np.ascontiguousarray(cloud.xyz)).segments, of_file.segments)

    def test_shorter_than_the_limit_are_left_out(self):
        lengths = np.linalg.norm(np.diff(ridgeline.edges(CLOUD, min_length_m=4).segments, axis=1), axis=2)
        self.assertGreater(len(lengths), 0)
        self.assertGreaterEqual(lengths.min(), 4)

    def test_keep_their_attributes_in_a_file(self):
        edges = ridgeline.edges(CLOUD)
        path = self.folder / "edges.gpkg"
        ridgeline.write_lines(path, edges)
        read = ridgeline.read_lines(path)
        self.assertEqual(list(read.kind), list(edges.kind))
        self.assertEqual(list(read.plane_ids), list(edges.plane_ids))
        np.testing.assert_allclose(read.support, edges.support)
        np.testing.assert_allclose(read.moved_out_m, edges.moved_out_m)

    def test_can_be_judged_and_selected(self):
        edges = ridgeline.edges(CLOUD)
        ridges = edges[edges.kind == "ridge"]
        result = ridgeline.evaluate(ridges, CLOUD, decoys=0)
        self.assertEqual(len(result.lines["id"]), len(ridges))

    def test_need_points_in_the_bounds(self):
        with self.assertRaisesRegex(ridgeline.InputFileError, "no point lies within bounds"):
            ridgeline.edges(CLOUD, bounds=(0, 0, 1, 1))


if __name__ == "__main__":
    unittest.main()

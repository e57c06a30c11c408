# SPDX-License-Identifier: GPL-3.0-or-later
"""The Reeb graph of a user's function."""

import unittest

import numpy as np

from meshes import cube, lying_torus, reebquad, torus


class Reeb_graph(unittest.TestCase):
    def test_height_on_a_standing_torus_has_one_loop(self):
        points, faces = lying_torus()
        graph = reebquad.reeb_graph(points, faces, points[:, 2])
        self.assertEqual(graph.loops, 1)
        self.assertEqual(graph.components, 1)
        self.assertEqual(graph.kinds, ["minimum", "saddle", "saddle", "maximum"])
        self.assertEqual(graph.vertices[0], points[:, 2].argmin())
        self.assertEqual(graph.vertices[-1], points[:, 2].argmax())
        self.assertTrue(np.isinf(graph.persistence[1:3]).any())

    def test_critical_points_sum_to_the_euler_characteristic_and_arcs_go_up(self):
        points, faces = torus()
        values = np.sin(5 * points[:, 0]) + points[:, 1]
        graph = reebquad.reeb_graph(points, faces, values)
        degree = np.bincount(graph.arcs.ravel(), minlength=len(graph.kinds))
        extrema = [kind in ("minimum", "maximum") for kind in graph.kinds]
        self.assertTrue((degree[extrema] == 1).all())
        self.assertTrue((graph.arcs[:, 0] < graph.arcs[:, 1]).all())
        self.assertEqual(len(graph.kinds) - len(graph.arcs), graph.components - graph.loops)

    def test_a_vertex_lies_between_the_ends_of_its_arc(self):
        points, faces = lying_torus()
        values = points[:, 2]
        graph = reebquad.reeb_graph(points, faces, values)
        for vertex, arc in enumerate(graph.arc_of_vertex):
            if arc >= 0:
                low, high = graph.vertices[graph.arcs[arc]]
                self.assertTrue(values[low] <= values[vertex] <= values[high])
        self.assertEqual((graph.arc_of_vertex < 0).sum(), len(graph.kinds))
        self.assertEqual(graph.arc_of_face.shape, (len(faces),))

    def test_what_is_no_function_or_no_surface_is_refused_with_its_element(self):
        points, faces = cube()
        values = points[:, 2].copy()
        values[3] = np.nan
        with self.assertRaises(reebquad.ImpossibleRequest) as refused:
            reebquad.reeb_graph(points, faces, values)
        self.assertEqual((refused.exception.element, refused.exception.index), ("vertex", 3))
        with self.assertRaises(reebquad.ImpossibleRequest):
            reebquad.reeb_graph(points, faces, points[:7, 2])
        with self.assertRaises(reebquad.NotASurface) as refused:
            reebquad.reeb_graph(points, faces[[0, 0, 1]], points[:, 2])
        self.assertEqual(refused.exception.element, "face")


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""Quads from arrays: what the result promises, and that it is the program's."""

import inspect
import json
import os
import tempfile
import unittest

import numpy as np

from meshes import bytes_of, cube, euler_characteristic, program, reebquad, torus, without_times


def two_shapes():
    """A torus beside a smaller one: two components, which share the quads."""
    points, faces = torus()
    return np.concatenate([points, 0.5 * points + [3, 0, 0]]), np.concatenate([faces, faces + len(points)])


class Equal_to_the_program(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def compare(self, mesh, options, arguments):
        reebquad.write_mesh(self.path("in.off"), *mesh)
        program(
            "run",
            self.path("in.off"),
            "-o",
            self.path("program.obj"),
            "--quiet",
            "--force",
            "--report",
            self.path("report.json"),
            *arguments,
        )
        result = reebquad.quadrangulate(*mesh, **options)
        result.write(self.path("python.obj"))
        self.assertEqual(bytes_of(self.path("python.obj")), bytes_of(self.path("program.obj")))
        with open(self.path("report.json"), encoding="utf-8") as file:
            theirs = without_times(json.load(file))
        ours = without_times(result.report)
        self.assertEqual(ours, {key: theirs[key] for key in theirs})
        return result

    def test_the_same_options_give_the_same_bytes_and_numbers(self):
        self.compare(torus(), {"quads": 300, "effort": "fast"}, ["--quads", 300, "--effort", "fast"])

    def test_search_and_sharp_edges_are_the_programs_defaults(self):
        self.compare(cube(), {"quads": 100}, ["--quads", 100])

    def test_edge_length_solver_and_placed_extrema_mean_the_same(self):
        self.compare(
            torus(),
            {"edge_length": 0.2, "solver": "eigen", "minima": [[-1.4, 0, 0]], "maxima": [0]},
            ["--edge-length", 0.2, "--solver", "eigen", "--min=-1.4,0,0", "--max=1.4,0,0"],
        )

    def test_mirrored_quads_are_the_programs_and_so_is_their_recipe(self):
        mesh = torus()
        result = self.compare(
            mesh,
            {"quads": 300, "effort": "fast", "mirror": "x"},
            ["--quads", 300, "--effort", "fast", "--mirror", "x"],
        )
        mirrored = result.vertices[result.report["mirror"]["image"]] * [-1, 1, 1]
        np.testing.assert_array_equal(mirrored, result.vertices)
        again = reebquad.Editor.replay(*mesh, result.recipe)
        self.assertEqual(again.quads().vertices.tobytes(), result.vertices.tobytes())
        self.assertEqual(result.editor.quads().vertices.tobytes(), result.vertices.tobytes())
        self.assertEqual(again.recipe, result.recipe)

    def test_components_share_the_quads_as_the_programs_do(self):
        result = self.compare(
            two_shapes(), {"quads": 500, "effort": "fast"}, ["--quads", 500, "--effort", "fast"]
        )
        self.assertEqual(set(result.component), {0, 1})
        self.assertEqual(len(result.editors), 2)
        with self.assertRaises(reebquad.ImpossibleRequest):
            _ = result.recipe

    def test_a_hole_is_filled_and_a_component_chosen_as_the_program_does(self):
        points, faces = two_shapes()
        result = self.compare(
            (points, faces[1:]),
            {"quads": 200, "effort": "fast", "fill_holes": 10, "component": 1},
            ["--quads", 200, "--effort", "fast", "--fill-holes", "--hole-edges", 10, "--component", 1],
        )
        self.assertEqual(json.loads(result.recipe)["component"], 1)


class Result(unittest.TestCase):
    @classmethod
    def setUpClass(cls):
        cls.mesh = torus()
        cls.result = reebquad.quadrangulate(*cls.mesh, quads=200, effort="fast", threads=1)

    def test_the_quads_are_a_certified_torus(self):
        self.assertTrue(self.result.certificate["passed"])
        self.assertEqual(euler_characteristic(self.result.quads), 0)
        self.assertEqual(self.result.report["components"][0]["genus"], 1)

    def test_threads_change_no_bit(self):
        other = reebquad.quadrangulate(*self.mesh, quads=200, effort="fast", threads=2)
        self.assertEqual(other.vertices.tobytes(), self.result.vertices.tobytes())
        self.assertEqual(other.quads.tobytes(), self.result.quads.tobytes())

    def test_sources_and_weights_give_the_vertices_back(self):
        points, faces = self.mesh
        weights, sources = self.result.barycentrics, self.result.source_vertices
        np.testing.assert_allclose(weights.sum(axis=1), 1)
        self.assertTrue((weights >= 0).all())
        for vertex, face in enumerate(self.result.source_face):
            self.assertEqual(set(sources[vertex]), set(faces[face]))
        there = (weights[..., None] * points[sources]).sum(axis=1)
        offset = self.result.report["components"][0]["relaxation"]["largest_offset"]
        np.testing.assert_allclose(there, self.result.vertices, atol=offset + 1e-9)

    def test_corners_at_a_vertex_inside_a_chart_agree_but_for_turns(self):
        uv, seen = self.result.uv, {}
        self.assertEqual(uv.shape, (len(self.result.quads), 4, 2))
        charts_at = {}
        for quad, chart in zip(self.result.quads, self.result.chart):
            for vertex in quad:
                charts_at.setdefault(vertex, set()).add(chart)
        for quad, corners in zip(self.result.quads, uv):
            for vertex, (u, v) in zip(quad, corners):
                if len(charts_at[vertex]) > 1:  # a contour may pass a saddle twice
                    continue
                first = seen.setdefault(vertex, (u, v))
                self.assertAlmostEqual(u, first[0])
                self.assertAlmostEqual(v - first[1], round(v - first[1]))
        self.assertGreater(len(seen), 20)
        # Each quad has area in its chart, and all turn alike.
        a, b = uv[:, 2] - uv[:, 0], uv[:, 3] - uv[:, 1]
        self.assertEqual(len(set(np.sign(a[:, 0] * b[:, 1] - a[:, 1] * b[:, 0]))), 1)

    def test_its_editor_replays_its_recipe_and_goes_on(self):
        self.assertEqual(self.result.editor.quads().vertices.tobytes(), self.result.vertices.tobytes())
        again = reebquad.Editor.replay(*self.mesh, self.result.recipe)
        self.assertEqual(again.quads().vertices.tobytes(), self.result.vertices.tobytes())

    def test_polygons_and_rows_of_several_lengths_are_taken(self):
        points, faces = cube()
        rows = [[0, 1, 3, 2], *faces[2:].tolist()]
        result = reebquad.quadrangulate(points, rows, quads=60, effort="fast")
        self.assertEqual(euler_characteristic(result.quads), 2)


class Wishes(unittest.TestCase):
    def test_quads_are_finer_where_sizes_are(self):
        points, faces = torus(48, 24)
        sizes = np.where(points[:, 0] > 0, 0.08, 0.24)
        result = reebquad.quadrangulate(points, faces, sizes=sizes, effort="fast")
        ends = result.vertices[result.quads]
        lengths = np.linalg.norm(ends - np.roll(ends, 1, axis=1), axis=2).mean(axis=1)
        right = ends.mean(axis=1)[:, 0] > 0
        self.assertLess(1.5 * lengths[right].mean(), lengths[~right].mean())
        self.assertEqual(result.uv.shape, (len(result.quads), 4, 2))  # no quad is subdivided

    def test_vertices_lie_on_the_given_features(self):
        points, faces = torus()
        outside = np.arange(24) * 12  # the outermost circle
        features = np.stack([outside, np.roll(outside, -1)], axis=1)
        result = reebquad.quadrangulate(
            points, faces, quads=300, effort="fast", features=features, feature_points=[0]
        )
        distance = np.hypot(
            np.hypot(result.vertices[:, 0], result.vertices[:, 1]) - 1.4, result.vertices[:, 2]
        )
        self.assertGreater((distance < 0.02).sum(), 12)
        self.assertLess(np.linalg.norm(result.vertices - points[0], axis=1).min(), 1e-9)

    def test_without_certificate_there_is_none(self):
        self.assertIsNone(
            reebquad.quadrangulate(*torus(), quads=100, effort="fast", certify=False).certificate
        )


class Documentation(unittest.TestCase):
    def test_every_parameter_has_a_type_and_a_word(self):
        for function in (
            reebquad.quadrangulate,
            reebquad.Editor.__init__,
            reebquad.reeb_graph,
            reebquad.check,
            reebquad.certify,
            reebquad.read_mesh,
            reebquad.write_mesh,
            reebquad.Editor.quads,
        ):
            words = reebquad.Editor.__doc__ if function is reebquad.Editor.__init__ else function.__doc__
            for name, parameter in inspect.signature(function).parameters.items():
                if name != "self":
                    self.assertIsNot(parameter.annotation, inspect.Parameter.empty, name)
                if name not in ("self", "path", "progress"):
                    self.assertIn(name, words)

    def test_the_package_says_that_it_is_typed(self):
        self.assertTrue(os.path.exists(os.path.join(os.path.dirname(reebquad.__file__), "py.typed")))


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""The editor: history, recipes, hints, and refusals that change nothing."""

import json
import os
import tempfile
import threading
import unittest

import numpy as np

from meshes import bytes_of, program, reebquad, torus


class History(unittest.TestCase):
    def setUp(self):
        self.mesh = torus()
        self.editor = reebquad.Editor(*self.mesh, quads=200)
        self.editor.apply({"edit": "suggest"})

    def test_undo_and_redo_give_the_same_bytes_again(self):
        before = self.editor.quads()
        report = self.editor.apply("set_target", quads=400)
        after = self.editor.quads()
        self.assertTrue(report.remeshed_charts)
        self.assertGreater(len(after.quads), 1.5 * len(before.quads))
        self.editor.undo()
        self.assertEqual(self.editor.quads().vertices.tobytes(), before.vertices.tobytes())
        self.assertTrue(self.editor.can_redo)
        self.editor.redo()
        self.assertEqual(self.editor.quads().vertices.tobytes(), after.vertices.tobytes())
        self.assertEqual(self.editor.position, 2)

    def test_dictionary_text_and_keywords_are_the_same_edit(self):
        at = self.editor.design()["extrema"][0]["point"]
        edits = [
            lambda e: e.apply({"edit": "split_pole", "at": {"point": np.array(at)}, "kind": "half"}),
            lambda e: e.apply(json.dumps({"edit": "split_pole", "at": {"point": list(at)}, "kind": "half"})),
            lambda e: e.apply("split_pole", at=at, kind="half"),
        ]
        recipes = set()
        for edit in edits:
            edit(self.editor)
            recipes.add(self.editor.recipe)
            self.editor.undo()
        self.assertEqual(len(recipes), 1)

    def test_a_refused_edit_changes_nothing(self):
        recipe, quads = self.editor.recipe, self.editor.quads(finish=False)
        with self.assertRaises(reebquad.RefusedEdit) as refused:
            self.editor.apply("remove_contour", at=self.editor.design()["extrema"][0]["point"])
        self.assertEqual(refused.exception.code, "refused_edit")
        self.assertTrue(str(refused.exception))
        self.assertEqual(self.editor.recipe, recipe)
        self.assertEqual(self.editor.quads(finish=False).vertices.tobytes(), quads.vertices.tobytes())

    def test_the_recipe_replays_to_the_bytes_of_the_program(self):
        self.editor.apply("set_target", quads=250)
        ours = self.editor.quads(feature_angle=0)
        with tempfile.TemporaryDirectory() as folder:
            path = {
                name: os.path.join(folder, name) for name in ("in.off", "recipe", "program.ply", "python.ply")
            }
            reebquad.write_mesh(path["in.off"], *self.mesh)
            with open(path["recipe"], "w", encoding="utf-8") as file:
                file.write(self.editor.recipe)
            program("replay", path["in.off"], path["recipe"], "-o", path["program.ply"], "--quiet")
            ours.write(path["python.ply"])
            self.assertEqual(bytes_of(path["python.ply"]), bytes_of(path["program.ply"]))
        again = reebquad.Editor.replay(*self.mesh, self.editor.recipe, threads=1)
        self.assertEqual(again.quads().vertices.tobytes(), ours.vertices.tobytes())
        self.assertEqual(again.recipe, self.editor.recipe)

    def test_an_edit_that_does_not_replay_is_named(self):
        recipe = json.loads(self.editor.recipe)
        recipe["edits"].append({"edit": "set_target", "quads": 0, "edge_length": 0})
        with self.assertRaises(reebquad.Error) as refused:
            reebquad.Editor.replay(*self.mesh, json.dumps(recipe))
        self.assertIn("edit 2", str(refused.exception))

    def test_whole_poles_are_triangles_behind_the_quads(self):
        self.editor.apply("split_pole", at=self.editor.design()["extrema"][0]["point"], kind="whole")
        made = self.editor.quads()
        self.assertGreater(len(made.triangles), 2)
        self.assertEqual(made.triangles.max(), len(made.vertices) - 1)

    def test_charts_are_found_by_their_points(self):
        charts = self.editor.design()["charts"]
        point = self.editor.quads(finish=False).vertices[0]
        self.assertIn(self.editor.chart_at(point), [chart["id"] for chart in charts])
        points, faces = self.editor.working_surface()
        self.assertEqual(faces.max(), len(points) - 1)

    def test_a_second_thread_is_refused_and_the_first_goes_on(self):
        refused = []

        def other():
            try:
                self.editor.undo()
            except reebquad.ImpossibleRequest as error:
                refused.append(error)

        def progress(stage, fraction):
            if not refused:
                thread = threading.Thread(target=other)
                thread.start()
                thread.join()

        self.editor.apply("set_target", quads=300, progress=progress)
        self.assertEqual(len(refused), 1)
        self.assertEqual(self.editor.position, 2)


class Hints(unittest.TestCase):
    def test_a_hint_applies_and_its_measure_falls(self):
        points, faces = reebquad.make_shape("hand", 2000)
        editor = reebquad.Editor(points, faces, quads=600)
        low, high = points[points[:, 2].argmin()], points[points[:, 2].argmax()]
        editor.apply(
            {
                "edit": "set_extrema",
                "extrema": [
                    {"at": {"point": low}, "maximum": False},
                    {"at": {"point": high}, "maximum": True},
                ],
            }
        )
        hints = editor.hints(thin_charts=False, saddles=False)
        self.assertTrue(hints)
        self.assertEqual(hints[0]["kind"], "uncovered_limb")
        self.assertLess(hints[0]["after"], hints[0]["before"])
        editor.apply(hints[0]["edit"])
        self.assertEqual(editor.position, 2)


if __name__ == "__main__":
    unittest.main()

# SPDX-License-Identifier: GPL-3.0-or-later
"""What is refused, and how a computation is ended."""

import _thread
import os
import tempfile
import threading
import unittest

import numpy as np

from meshes import cube, reebquad, torus

V, F = torus()


def changed(array, row, value):
    array = np.array(array, dtype=float)
    array[row] = value
    return array


class Arguments(unittest.TestCase):
    def test_wrong_shapes_and_values_are_refused_with_a_sentence_and_their_element(self):
        cases = [
            (dict(vertices=changed(V, 7, np.nan)), ("vertex", 7)),
            (dict(vertices=changed(V, 5, np.inf)), ("vertex", 5)),
            (dict(vertices=V[:, :2]), (None, None)),
            (dict(vertices=V.ravel()), (None, None)),
            (dict(faces=F[:, :2]), (None, None)),
            (dict(faces=np.where(F == 3, len(V), F)), ("face", int(np.where(F == 3)[0][0]))),
            (dict(faces=np.where(F == 3, -1, F)), ("face", int(np.where(F == 3)[0][0]))),
            (dict(quads=0), (None, None)),
            (dict(quads=2**40), (None, None)),
            (dict(quads=10, edge_length=0.1), (None, None)),
            (dict(edge_length=-1.0), (None, None)),
            (dict(edge_length=float("nan")), (None, None)),
            (dict(sizes=np.ones(3)), (None, None)),
            (dict(sizes=np.zeros(len(V))), ("vertex", 0)),
            (dict(features=[[0, 100]]), ("edge", 0)),
            (dict(features=[[0, 1, 2]]), (None, None)),
            (dict(feature_points=[10**6]), ("vertex", 0)),
            (dict(effort="lazy"), (None, None)),
            (dict(mirror="w"), (None, None)),
            (dict(mirror="0,0,0.1,0,0,1", mirror_tolerance=0.001), (None, None)),
            (dict(solver="gauss"), (None, None)),
            (dict(axis=[0, 0, 0]), (None, None)),
            (dict(persistence=2.0), (None, None)),
            (dict(feature_angle=200.0), (None, None)),
            (dict(threads=-1), (None, None)),
            (dict(adaptive=3), (None, None)),
            (dict(minima=[0]), (None, None)),
            (dict(certify=False, strict=True), (None, None)),
        ]
        for case, place in cases:
            with self.subTest(**{key: str(value)[:30] for key, value in case.items()}):
                with self.assertRaises(reebquad.ImpossibleRequest) as refused:
                    reebquad.quadrangulate(**{"vertices": V, "faces": F, "effort": "fast", **case})
                self.assertGreater(len(str(refused.exception)), 10)
                self.assertEqual(refused.exception.code, "impossible_request")
                self.assertEqual((refused.exception.element, refused.exception.index), place)
                self.assertIsInstance(refused.exception, ValueError)

    def test_wrong_types_are_type_errors_that_name_the_argument(self):
        cases = [
            (dict(vertices=V.astype(complex)), "vertices"),
            (dict(vertices="torus"), "vertices"),
            (dict(faces=F.astype(float)), "faces"),
            (dict(faces=F > 3), "faces"),
            (dict(quads=2.5), "quads"),
            (dict(quads=True), "quads"),
            (dict(edge_length="long"), "edge_length"),
            (dict(relax=1), "relax"),
            (dict(effort=3), "effort"),
            (dict(progress=3), "progress"),
            (dict(quadss=3), "quadss"),
        ]
        for case, name in cases:
            with self.subTest(**{key: str(value)[:30] for key, value in case.items()}):
                with self.assertRaisesRegex(TypeError, name):
                    reebquad.quadrangulate(**{"vertices": V, "faces": F, "effort": "fast", **case})

    def test_any_memory_layout_and_width_of_numbers_is_taken(self):
        expected = reebquad.quadrangulate(V, F, quads=100, effort="fast", certify=False).vertices
        for vertices, faces in [
            (np.asfortranarray(V), F.astype(np.uint8 if len(V) < 256 else np.uint16)),
            (np.repeat(V, 2, axis=0)[::2], F.astype(np.int64)),
            (V.tolist(), F.tolist()),
        ]:
            result = reebquad.quadrangulate(vertices, faces, quads=100, effort="fast", certify=False)
            self.assertEqual(result.vertices.tobytes(), expected.tobytes())

    def test_what_is_no_surface_is_refused(self):
        for faces in ([], [[0, 0, 1]]):
            with self.assertRaises(reebquad.NotASurface):
                reebquad.quadrangulate(V, faces)

    def test_every_class_has_its_code(self):
        classes = [
            kind
            for kind in vars(reebquad).values()
            if isinstance(kind, type) and issubclass(kind, reebquad.Error) and kind is not reebquad.Error
        ]
        self.assertEqual(len(classes), 12)
        self.assertEqual(len({kind.code for kind in classes}), 12)


class Files(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.addCleanup(self.folder.cleanup)

    def path(self, name):
        return os.path.join(self.folder.name, name)

    def test_meshes_come_back_with_the_same_bits(self):
        for name in ("a.off", "a.obj", "a.ply"):
            reebquad.write_mesh(self.path(name), V, F)
            mesh = reebquad.read_mesh(self.path(name))
            self.assertEqual(mesh.vertices.tobytes(), V.tobytes())
            self.assertTrue((mesh.faces == F).all())

    def test_faces_of_several_sizes_come_back_as_lists(self):
        points, faces = cube()
        reebquad.write_mesh(self.path("a.off"), points, [[0, 1, 3, 2]], faces[2:])
        mesh = reebquad.read_mesh(self.path("a.off"))
        self.assertEqual([len(face) for face in mesh.faces], [4] + [3] * 10)

    def test_errors_of_files_have_the_line(self):
        with self.assertRaises(reebquad.UnreadableFile):
            reebquad.read_mesh(self.path("none.off"))
        with open(self.path("bad.off"), "w", encoding="utf-8") as file:
            file.write("OFF\n3 1 0\n0 0 0\n1 0 0\n0 1 zero\n3 0 1 2\n")
        with self.assertRaises(reebquad.MalformedFile) as refused:
            reebquad.read_mesh(self.path("bad.off"))
        self.assertEqual((refused.exception.element, refused.exception.index), ("line", 5))
        with self.assertRaises(reebquad.UnsupportedFormat):
            reebquad.write_mesh(self.path("a.docx"), V, F)
        with self.assertRaises(reebquad.UnwritableFile):
            reebquad.write_mesh(self.path("no/folder/a.off"), V, F)
        with self.assertRaises(reebquad.MalformedFile):
            reebquad.Editor.replay(V, F, "{}")

    def test_check_lists_defects_and_tells_what_is_accepted(self):
        found = reebquad.check(changed(V, 7, np.nan), F)
        self.assertEqual(found["check"]["counts"]["non_finite_point"], 1)
        reebquad.write_mesh(self.path("a.off"), V, F)
        found = reebquad.check(self.path("a.off"))
        self.assertTrue(found["accepted"])
        self.assertFalse(found["in_part"])
        self.assertFalse(reebquad.check(V[:3], [[0, 0, 1]])["accepted"])

    def test_a_hole_fails_the_certificate_without_an_exception(self):
        result = reebquad.quadrangulate(V, F, quads=100, effort="fast")
        good = reebquad.certify(result.vertices, result.quads, (V, F))
        self.assertTrue(good["passed"])
        self.assertEqual(good["statistics"]["quads"], len(result.quads))
        bad = reebquad.certify(result.vertices, result.quads[1:], (V, F))
        self.assertFalse(bad["passed"])


class Ending(unittest.TestCase):
    def test_progress_tells_stages_and_fractions_on_the_calling_thread(self):
        calls = []
        reebquad.quadrangulate(
            V,
            F,
            quads=100,
            effort="fast",
            threads=2,
            progress=lambda *call: calls.append((*call, threading.get_ident())),
        )
        self.assertGreater(len({stage for stage, _, _ in calls}), 3)
        self.assertTrue(all(0 <= fraction <= 1 for _, fraction, _ in calls))
        self.assertEqual({thread for _, _, thread in calls}, {threading.get_ident()})

    def test_false_cancels_and_an_exception_comes_through(self):
        with self.assertRaises(reebquad.Cancelled):
            reebquad.quadrangulate(V, F, progress=lambda stage, fraction: False)

        def fail(stage, fraction):
            raise KeyError("mine")

        with self.assertRaisesRegex(KeyError, "mine"):
            reebquad.quadrangulate(V, F, progress=fail)

    def test_an_interrupt_ends_a_long_run_soon_and_other_threads_run_meanwhile(self):
        counted = [0]
        ended = threading.Event()

        def count():
            while not ended.wait(0.005):
                counted[0] += 1

        points, faces = reebquad.make_shape("hand", 20000)
        thread = threading.Thread(target=count)
        timer = threading.Timer(0.5, _thread.interrupt_main)
        thread.start()
        timer.start()
        try:
            with self.assertRaises(KeyboardInterrupt):
                reebquad.quadrangulate(points, faces, quads=20000, effort="best")
        finally:
            ended.set()
            thread.join()
            timer.cancel()
        self.assertGreater(counted[0], 20)


if __name__ == "__main__":
    unittest.main()

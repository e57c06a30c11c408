# SPDX-License-Identifier: GPL-3.0-or-later
"""The add-on in a real Blender: blender -b --factory-startup --python test_addon.py -- ZIP PROGRAM"""

import importlib
import os
import sys
import time
import unittest

import bpy
import numpy as np

ZIP, PROGRAM = sys.argv[sys.argv.index("--") + 1 :]


def addon(name):
    return importlib.import_module("reebquad_blender." + name)


def height_of(point):
    """A linear function of the place, which all data of the test are made of: from 0 to 1."""
    return 0.5 + 0.3 * point[2] + 0.2 * point[0]


def torus():
    """A torus with all that can be transferred."""
    bpy.ops.mesh.primitive_torus_add(
        major_segments=36, minor_segments=18, major_radius=1, minor_radius=0.4, generate_uvs=True
    )
    source = bpy.context.object
    mesh = source.data
    for name in ("left", "right"):
        mesh.materials.append(bpy.data.materials.new(name))
    for polygon in mesh.polygons:
        polygon.material_index = int(polygon.center.x > 0)
        polygon.use_smooth = True
    group = source.vertex_groups.new(name="height")
    for vertex in mesh.vertices:
        group.add([vertex.index], height_of(vertex.co), "REPLACE")
    for name, domain in (("colour", "POINT"), ("corner", "CORNER")):
        mesh.color_attributes.new(name=name, type="FLOAT_COLOR", domain=domain)
    # What was there before another layer is made is no longer valid.
    colours, corners = mesh.color_attributes["colour"], mesh.color_attributes["corner"]
    for vertex in mesh.vertices:
        value = height_of(vertex.co)
        colours.data[vertex.index].color = (value, 1 - value, 0, 1)
    for loop in mesh.loops:
        corners.data[loop.index].color = colours.data[loop.vertex_index].color
    source.modifiers.new("smooth", "SUBSURF").levels = 1
    source.rotation_euler = (0.3, 0.2, 0.1)
    source.scale = (1, 1.5, 1)
    source.location = (5, 0, -2)
    bpy.context.view_layer.update()
    return source


def remesh(**settings):
    """The new object. The operator raises where it reports an error."""
    for name, value in {"quads": 400, "effort": "fast", **settings}.items():
        setattr(bpy.context.scene.reebquad, name, value)
    assert bpy.ops.object.reebquad_remesh() == {"FINISHED"}
    return bpy.context.object


def volume(thing):
    """Signed, in the world."""
    matrix = np.array(thing.matrix_world)
    points = np.array([vertex.co for vertex in thing.data.vertices]) @ matrix[:3, :3].T + matrix[:3, 3]
    total = 0
    for polygon in thing.data.polygons:
        corners = points[list(polygon.vertices)]
        for i in range(1, len(corners) - 1):
            total += np.dot(corners[0], np.cross(corners[i], corners[i + 1])) / 6
    return total


class Remeshing(unittest.TestCase):
    def setUp(self):
        bpy.ops.wm.read_factory_settings(use_empty=True)
        bpy.ops.preferences.addon_enable(module="reebquad_blender")
        bpy.context.preferences.addons["reebquad_blender"].preferences.path = PROGRAM
        self.source = torus()

    def test_the_new_object_has_closed_quads_and_all_that_the_old_one_had(self):
        made = remesh()
        mesh = made.data
        self.assertIsNot(made, self.source)
        self.assertEqual({len(polygon.vertices) for polygon in mesh.polygons}, {4})
        self.assertEqual(len(mesh.vertices) - len(mesh.edges) + len(mesh.polygons), 0)
        self.assertLess(abs(len(mesh.polygons) - 400), 80)
        self.assertEqual([modifier.name for modifier in made.modifiers], ["smooth"])
        self.assertEqual(made.matrix_world, self.source.matrix_world)
        self.assertEqual([slot.material.name for slot in made.material_slots], ["left", "right"])
        self.assertTrue(self.source.hide_get())
        self.assertAlmostEqual(volume(made) / volume(self.source), 1, delta=0.05)

    def test_groups_colours_materials_and_smoothness_come_from_the_nearest_place(self):
        mesh = remesh().data
        for vertex in mesh.vertices:
            value = height_of(vertex.co)
            self.assertAlmostEqual(vertex.groups[0].weight, value, delta=0.03)
            self.assertAlmostEqual(
                mesh.color_attributes["colour"].data[vertex.index].color[0], value, delta=0.03
            )
        for loop in mesh.loops:
            value = height_of(mesh.vertices[loop.vertex_index].co)
            self.assertAlmostEqual(
                mesh.color_attributes["corner"].data[loop.index].color[1], 1 - value, delta=0.03
            )
        for polygon in mesh.polygons:
            self.assertTrue(polygon.use_smooth)
            if abs(polygon.center.x) > 0.15:
                self.assertEqual(polygon.material_index, int(polygon.center.x > 0))

    def test_no_face_of_the_quads_is_smeared_over_a_seam(self):
        made = remesh()
        layer = made.data.uv_layers.active
        self.assertEqual(layer.name, self.source.data.uv_layers.active.name)
        # Each corner has, up to the width of a face, what the nearest old vertex has on one of its sides.
        old = self.source.data
        of_vertex = [[] for _ in old.vertices]
        for loop in old.loops:
            of_vertex[loop.vertex_index].append(np.array(old.uv_layers.active.data[loop.index].uv))
        points = np.array([vertex.co for vertex in old.vertices])
        for polygon in made.data.polygons:
            for vertex, loop in zip(polygon.vertices, polygon.loop_indices):
                distance = np.linalg.norm(points - np.array(made.data.vertices[vertex].co), axis=1)
                uv = np.array(layer.data[loop].uv)
                self.assertLess(
                    min(np.abs(uv - other).max() for other in of_vertex[distance.argmin()]), 1 / 18
                )

    def test_a_mirrored_object_keeps_its_outside_and_one_scaled_to_nothing_is_refused(self):
        self.source.scale = (-1, 1, 1)
        bpy.context.view_layer.update()
        self.assertAlmostEqual(volume(remesh()) / volume(self.source), 1, delta=0.05)
        bpy.context.view_layer.objects.active = self.source
        self.source.scale = (0, 1, 1)
        bpy.context.view_layer.update()
        with self.assertRaisesRegex(RuntimeError, "scaled to nothing"):
            remesh()

    def test_as_it_is_shown_takes_the_modifiers_in_and_leaves_them_out(self):
        made = remesh(use_modifiers=True)
        self.assertEqual(len(made.modifiers), 0)
        self.assertGreater(len(made.vertex_groups), 0)

    def test_marks_are_the_edges_that_are_asked_for(self):
        exchange = addon("exchange")
        mesh = self.source.data
        mesh.edges[3].use_seam = True
        mesh.edges[5].use_edge_sharp = True
        self.assertEqual(exchange.marked_edges(mesh, {"SEAM"}), [tuple(mesh.edges[3].vertices)])
        self.assertEqual(len(exchange.marked_edges(mesh, {"SEAM", "SHARP"})), 2)
        self.assertEqual(exchange.marked_edges(mesh, set()), [])
        if "--marks" in addon("program").options_of(PROGRAM):
            remesh(marks={"SHARP"})
        else:
            with self.assertRaisesRegex(RuntimeError, "marks"):
                remesh(marks={"SHARP"})

    def test_what_is_dropped_is_named(self):
        self.source.shape_key_add(name="Basis")
        self.source.modifiers.new("bound", "SURFACE_DEFORM")
        self.assertEqual(len(addon("transfer").dropped(self.source)), 2)

    def test_a_missing_program_and_a_mesh_without_faces_are_refused(self):
        bpy.context.preferences.addons["reebquad_blender"].preferences.path = "/no/such/program"
        with self.assertRaisesRegex(RuntimeError, "not found"):
            remesh()
        bpy.context.preferences.addons["reebquad_blender"].preferences.path = PROGRAM
        bpy.context.object.data.clear_geometry()
        with self.assertRaisesRegex(RuntimeError, "no faces"):
            remesh()

    def test_a_run_that_is_cancelled_ends_soon_and_leaves_no_files(self):
        settings = bpy.context.scene.reebquad
        settings.quads, settings.effort = 100000, "best"
        job = addon("operators").Job(bpy.context, self.source)
        begin = time.monotonic()
        while not job.run.poll() and time.monotonic() - begin < 0.5:
            time.sleep(0.05)
        folder = os.path.dirname(job.run.quads)
        begin = time.monotonic()
        job.close()
        job.run.wait()
        self.assertLess(time.monotonic() - begin, 8)
        self.assertEqual(job.run.failure(), "cancelled")
        self.assertFalse(os.path.exists(folder))

    def test_the_studio_opens_the_surface_and_ends_with_the_add_on(self):
        bpy.ops.object.reebquad_studio()
        operators = addon("operators")
        (studio,) = operators.REEBQUAD_OT_studio.studios
        surface = next(word for word in studio.args if word.endswith(".obj"))
        self.assertTrue(os.path.exists(surface))
        bpy.ops.preferences.addon_disable(module="reebquad_blender")
        self.assertIsNotNone(studio.returncode)
        os.remove(surface)


if __name__ == "__main__":
    bpy.ops.preferences.addon_install(filepath=ZIP, overwrite=True)
    result = unittest.TextTestRunner(verbosity=2).run(
        unittest.defaultTestLoader.loadTestsFromTestCase(Remeshing)
    )
    sys.stdout.flush()
    sys.exit(0 if result.wasSuccessful() and result.testsRun > 0 else 1)

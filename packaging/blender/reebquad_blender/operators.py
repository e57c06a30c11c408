# SPDX-License-Identifier: GPL-3.0-or-later
"""Remeshing in the background, and opening the studio."""

import os
import subprocess
import tempfile

import bpy

from . import exchange, program, transfer


def found_program(context):
    """The path of the program; empty where there is none."""
    addon = context.preferences.addons.get(__package__)
    return program.find(addon.preferences.path if addon else "")


def program_of(context):
    path = found_program(context)
    if not path:
        raise exchange.Refusal("the program reebquad is not found: name it in the add-on's preferences")
    return path


def mesh_to_remesh(context, source, use_modifiers):
    """The mesh as it is, or as its modifiers make it, and a function that frees what was made for this."""
    if source.mode != "OBJECT":
        source.update_from_editmode()
    if not use_modifiers:
        return source.data, lambda: None
    shown = source.evaluated_get(context.evaluated_depsgraph_get())
    return shown.to_mesh(), shown.to_mesh_clear


def arguments_of(settings, options, marks_file):
    """The settings as arguments of the program, as far as it has these options."""
    arguments = ["--effort", settings.effort, "--feature-angle", repr(settings.feature_angle)]
    if settings.use_edge_length:
        arguments += ["--edge-length", repr(settings.edge_length)]
    else:
        arguments += ["--quads", str(settings.quads)]
    if settings.adaptive != "1":
        arguments += [f"--adaptive={settings.adaptive}"]
    if settings.mirror != "none":
        if "--mirror" not in options:
            raise exchange.Refusal("this reebquad has no mirrors; a newer one has")
        arguments += ["--mirror", settings.mirror]
    if marks_file:
        if "--marks" not in options:
            raise exchange.Refusal("this reebquad takes no marks; a newer one does")
        arguments += ["--marks", marks_file]
    return arguments


class Job:
    """One object on its way: its surface in a folder of files, the program, and what comes of it."""

    def __init__(self, context, source):
        settings = context.scene.reebquad
        self.source = source
        self.use_modifiers = settings.use_modifiers
        self.hide_source = settings.hide_source
        self.matrix = exchange.matrix_of(source)
        self._folder = tempfile.TemporaryDirectory(prefix="reebquad_")
        path = program_of(context)
        mesh, free = mesh_to_remesh(context, source, settings.use_modifiers)
        try:
            exchange.write_surface(mesh, self.matrix, os.path.join(self._folder.name, "surface.obj"))
            edges = exchange.marked_edges(mesh, settings.marks)
        finally:
            free()
        marks_file = os.path.join(self._folder.name, "marks.txt") if edges else ""
        if edges:
            exchange.write_marks(edges, marks_file)
        arguments = arguments_of(settings, program.options_of(path), marks_file)
        self.run = program.Run(path, self._folder.name, arguments)

    def finish(self, context):
        """The new object, and sentences for people. Raises `Refusal` where the program made no quads."""
        if not self.run.has_quads():
            raise exchange.Refusal(self.run.failure())
        points, polygons = exchange.read_quads(self.run.quads)
        mesh = bpy.data.meshes.new(self.source.data.name + " quads")
        exchange.fill_mesh(mesh, points, polygons, self.matrix)
        made = transfer.new_object(self.source, mesh, not self.use_modifiers)
        made.name = self.source.name + " quads"
        old, free = mesh_to_remesh(context, self.source, self.use_modifiers)
        try:
            transfer.transfer_all(old, self.source, made)
        finally:
            free()
        self.source.hide_set(self.hide_source)
        for item in context.selected_objects:
            item.select_set(False)
        made.select_set(True)
        context.view_layer.objects.active = made
        return made, self.run.warnings() + transfer.dropped(self.source)

    def close(self):
        self.run.cancel()
        self._folder.cleanup()


class REEBQUAD_OT_remesh(bpy.types.Operator):
    """Makes quads of the active object, as a new object; Esc cancels"""

    bl_idname = "object.reebquad_remesh"
    bl_label = "Remesh to quads"
    bl_options = {"REGISTER", "UNDO"}

    @classmethod
    def poll(cls, context):
        return (
            context.object is not None and context.object.type == "MESH" and context.object.mode == "OBJECT"
        )

    def begin(self, context):
        self.timer = None
        try:
            self.job = Job(context, context.object)
        except (exchange.Refusal, OSError) as refusal:
            self.report({"ERROR"}, str(refusal))
            return False
        return True

    def execute(self, context):
        """Waits for the program: in scripts and without a window."""
        if not self.begin(context):
            return {"CANCELLED"}
        self.job.run.wait()
        return self.end(context)

    def invoke(self, context, _event):
        if bpy.app.background:
            return self.execute(context)
        if not self.begin(context):
            return {"CANCELLED"}
        self.timer = context.window_manager.event_timer_add(0.1, window=context.window)
        context.window_manager.modal_handler_add(self)
        context.window.cursor_modal_set("WAIT")
        return {"RUNNING_MODAL"}

    def modal(self, context, event):
        if event.type == "ESC":
            self.job.run.cancel()
            self.job.run.wait()
            self.report({"INFO"}, "cancelled")
            self.clear(context)
            return {"CANCELLED"}
        if event.type != "TIMER":
            return {"PASS_THROUGH"}
        if not self.job.run.poll():
            stage = self.job.run.stage or "begins"
            context.workspace.status_text_set(f"reebquad: {stage} (Esc cancels)")
            return {"RUNNING_MODAL"}
        return self.end(context)

    def end(self, context):
        try:
            made, sentences = self.job.finish(context)
        except (exchange.Refusal, ReferenceError) as refusal:
            self.report({"ERROR"}, str(refusal))
            return {"CANCELLED"}
        finally:
            self.clear(context)
        for sentence in self.job.run.sentences:
            self.report({"INFO"}, sentence)
        for sentence in sentences:
            self.report({"WARNING"}, sentence)
        self.report({"INFO"}, f"{len(made.data.polygons)} quads, certified")
        return {"FINISHED"}

    def clear(self, context):
        self.job.close()
        if self.timer is not None:
            context.window_manager.event_timer_remove(self.timer)
            context.workspace.status_text_set(None)
            context.window.cursor_modal_restore()


class REEBQUAD_OT_studio(bpy.types.Operator):
    """Opens the active object's surface in the studio; the file's folder keeps what is designed there"""

    bl_idname = "object.reebquad_studio"
    bl_label = "Open in studio"

    poll = REEBQUAD_OT_remesh.poll

    def execute(self, context):
        try:
            path = program_of(context)
            source = context.object
            folder = bpy.path.abspath("//") or bpy.app.tempdir
            surface = os.path.join(folder, bpy.path.clean_name(source.name) + ".obj")
            mesh, free = mesh_to_remesh(context, source, context.scene.reebquad.use_modifiers)
            try:
                exchange.write_surface(mesh, exchange.matrix_of(source), surface)
            finally:
                free()
            extra = ["--no-browser"] if bpy.app.background else []
            self.studios.append(subprocess.Popen([path, "studio", surface, *extra], stdin=subprocess.DEVNULL))
        except (exchange.Refusal, OSError) as refusal:
            self.report({"ERROR"}, str(refusal))
            return {"CANCELLED"}
        self.report({"INFO"}, f"{surface} is open in the studio")
        return {"FINISHED"}

    studios = []  # they live as long as Blender does


def end_studios():
    for studio in REEBQUAD_OT_studio.studios:
        studio.terminate()
        studio.wait()
    REEBQUAD_OT_studio.studios.clear()


CLASSES = (REEBQUAD_OT_remesh, REEBQUAD_OT_studio)

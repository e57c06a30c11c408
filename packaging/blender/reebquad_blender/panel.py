# SPDX-License-Identifier: GPL-3.0-or-later
"""The panel in the sidebar of the 3D view."""

import bpy

from . import operators, program


class REEBQUAD_PT_panel(bpy.types.Panel):
    bl_label = "Reebquad"
    bl_space_type = "VIEW_3D"
    bl_region_type = "UI"
    bl_category = "Reebquad"

    def draw(self, context):
        settings = context.scene.reebquad
        layout = self.layout
        layout.use_property_split = True
        layout.use_property_decorate = False
        layout.prop(settings, "use_edge_length")
        layout.prop(settings, "edge_length" if settings.use_edge_length else "quads")
        for name in ("effort", "mirror", "adaptive", "feature_angle"):
            layout.prop(settings, name)
        path = operators.found_program(context)
        if path and "--marks" in program.options_of(path):
            layout.row().prop(settings, "marks")
        layout.prop(settings, "use_modifiers")
        layout.prop(settings, "hide_source")
        layout.operator("object.reebquad_remesh", icon="MESH_GRID")
        layout.operator("object.reebquad_studio", icon="URL")


CLASSES = (REEBQUAD_PT_panel,)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Where the program is, and what the next run is asked for."""

import bpy
from bpy.props import BoolProperty, EnumProperty, FloatProperty, IntProperty, StringProperty

from . import program


class ReebquadPreferences(bpy.types.AddonPreferences):
    bl_idname = __package__

    path: StringProperty(
        name="Program",
        description="The program reebquad; empty: it is looked for on PATH",
        subtype="FILE_PATH",
    )

    def draw(self, _context):
        self.layout.prop(self, "path")
        found = program.find(self.path)
        self.layout.label(text=found or "reebquad is not found", icon="CHECKMARK" if found else "ERROR")


class ReebquadSettings(bpy.types.PropertyGroup):
    quads: IntProperty(name="Quads", description="About how many quads", default=3000, min=1, max=100000000)
    use_edge_length: BoolProperty(name="By edge length", description="Ask for a length instead of a number")
    edge_length: FloatProperty(
        name="Edge length",
        description="The length of the quads' edges, in units of the scene",
        default=0.1,
        min=1e-6,
        subtype="DISTANCE",
    )
    effort: EnumProperty(
        name="Effort",
        items=(
            ("fast", "Fast", "Takes the suggested extrema"),
            ("default", "Default", "Searches better ones, so that quads keep the shape"),
            ("best", "Best", "Searches longer"),
        ),
        default="default",
    )
    mirror: EnumProperty(
        name="Mirror",
        items=(
            ("none", "None", "No plane of symmetry"),
            ("auto", "Auto", "Finds a plane of symmetry; the quads equal their mirror image"),
            ("x", "X", "Across the x axis of the world"),
            ("y", "Y", "Across the y axis of the world"),
            ("z", "Z", "Across the z axis of the world"),
        ),
    )
    adaptive: EnumProperty(
        name="Finer",
        description="Finer quads where the surface bends",
        items=(("1", "Not", ""), ("2", "2 times", ""), ("4", "4 times", ""), ("8", "8 times", "")),
    )
    feature_angle: FloatProperty(
        name="Sharp from",
        description="Quads keep edges whose faces' normals differ by more, in degrees; 0: none",
        default=45,
        min=0,
        max=180,
    )
    marks: EnumProperty(
        name="Marks",
        description="Edges that quads shall run along, whatever their angles",
        items=(
            ("SHARP", "Sharp", "Edges that are marked sharp"),
            ("CREASE", "Crease", "Edges with a crease"),
            ("SEAM", "Seam", "Edges of seams"),
        ),
        options={"ENUM_FLAG"},
        default=set(),
    )
    use_modifiers: BoolProperty(
        name="As it is shown",
        description="Remesh the result of the modifiers, and leave them out; else they are kept",
    )
    hide_source: BoolProperty(name="Hide the source", default=True)


CLASSES = (ReebquadPreferences, ReebquadSettings)

# SPDX-License-Identifier: GPL-3.0-or-later
"""Remeshes objects into certified quads by the program reebquad."""

import bpy

from . import operators, panel, preferences

bl_info = {
    "name": "Reebquad: certified quads",
    "author": "The authors of Reeb_quadrangulation",
    "version": (0, 1, 0),
    "blender": (3, 4, 0),
    "location": "3D View > Sidebar > Reebquad",
    "description": "Turns surfaces into meshes of quads only, by Reeb graphs",
    "category": "Mesh",
}

CLASSES = (*preferences.CLASSES, *operators.CLASSES, *panel.CLASSES)


def register():
    for kind in CLASSES:
        bpy.utils.register_class(kind)
    bpy.types.Scene.reebquad = bpy.props.PointerProperty(type=preferences.ReebquadSettings)


def unregister():
    operators.end_studios()
    del bpy.types.Scene.reebquad
    for kind in reversed(CLASSES):
        bpy.utils.unregister_class(kind)

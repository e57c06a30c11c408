# SPDX-License-Identifier: GPL-3.0-or-later
"""What a mesh has at its vertices, corners and faces comes over to the mesh that replaces it, from the
nearest place.

Both meshes are in the same coordinates. UVs respect seams: all corners
of a face get theirs from one side.
"""

import numpy as np
from mathutils import Vector
from mathutils.bvhtree import BVHTree
from mathutils.interpolate import poly_3d_calc

# What hangs on the vertices that there were, and is not transferred.
BOUND_MODIFIERS = {
    "MULTIRES",
    "SURFACE_DEFORM",
    "MESH_DEFORM",
    "CORRECTIVE_SMOOTH",
    "LAPLACIANDEFORM",
    "HOOK",
}


class Source:
    """Finds the face of a mesh that is nearest to a point, and the weights of its corners there."""

    def __init__(self, mesh):
        self.mesh = mesh
        self.points = [vertex.co.copy() for vertex in mesh.vertices]
        self.corners = [tuple(polygon.vertices) for polygon in mesh.polygons]
        self._tree = BVHTree.FromPolygons(self.points, self.corners)

    def face(self, point):
        """The nearest face and the point there."""
        nearest, _, index, _ = self._tree.find_nearest(point)
        return index, nearest

    def place(self, point):
        """The nearest face, and the weights of its corners."""
        face, nearest = self.face(point)
        return face, self.weights(face, nearest)

    def weights(self, face, point):
        return poly_3d_calc([self.points[v] for v in self.corners[face]], point)

    def part(self, faces):
        """A search among some faces alone: takes a point, gives the nearest face and the weights."""
        index = {v: i for i, v in enumerate(dict.fromkeys(v for f in faces for v in self.corners[f]))}
        tree = BVHTree.FromPolygons(
            [self.points[v] for v in index], [[index[v] for v in self.corners[f]] for f in faces]
        )

        def place(point):
            nearest, _, number, _ = tree.find_nearest(point)
            return faces[number], self.weights(faces[number], nearest)

        return place


def mean(values, weights):
    return sum(np.asarray(value, dtype=float) * weight for value, weight in zip(values, weights))


def joined_faces(mesh, layer):
    """The neighbours of each face over edges where the coordinates of both agree: all edges but seams."""
    first, neighbours = {}, [[] for _ in mesh.polygons]
    for polygon in mesh.polygons:
        loops = list(polygon.loop_indices)
        for this, following in zip(loops, loops[1:] + loops[:1]):
            ends = sorted(
                (mesh.loops[i].vertex_index, *np.round(layer.data[i].uv, 6).tolist())
                for i in (this, following)
            )
            other = first.setdefault(tuple(ends), polygon.index)
            if other != polygon.index:
                neighbours[polygon.index].append(other)
                neighbours[other].append(polygon.index)
    return neighbours


def around(source, neighbours, start, center, radius):
    """The faces that a way over neighbours reaches from one of them within a ball, which it belongs to."""
    reached, waiting = {start}, [start]
    while waiting:
        for face in neighbours[waiting.pop()]:
            if face in reached:
                continue
            if min((source.points[v] - center).length for v in source.corners[face]) <= radius:
                reached.add(face)
                waiting.append(face)
    return sorted(reached)


def transfer_uvs(source, target):
    """All UV layers, by name. Corners get theirs from around the middle of their face, on one side of seams."""
    old = source.mesh
    for layer in old.uv_layers:
        new = target.uv_layers.get(layer.name) or target.uv_layers.new(name=layer.name, do_init=False)
        neighbours = joined_faces(old, layer)
        for polygon in target.polygons:
            corners = [target.vertices[v].co for v in polygon.vertices]
            radius = 1.5 * max((corner - polygon.center).length for corner in corners)
            faces = around(source, neighbours, source.face(polygon.center)[0], polygon.center, radius)
            place = source.part(faces)
            for loop, corner in zip(polygon.loop_indices, corners):
                face, weights = place(corner)
                loops = old.polygons[face].loop_indices
                new.data[loop].uv = mean([layer.data[i].uv for i in loops], weights)
    if old.uv_layers.active:
        target.uv_layers.active = target.uv_layers[old.uv_layers.active.name]


def transfer_colours(source, target, places):
    """All colour attributes, of vertices and of corners, by name."""
    old = source.mesh
    for layer in old.color_attributes:
        new = target.color_attributes.new(name=layer.name, type=layer.data_type, domain=layer.domain)
        if layer.domain == "POINT":
            for vertex, (face, weights) in enumerate(places):
                corners = old.polygons[face].vertices
                new.data[vertex].color = mean([layer.data[v].color for v in corners], weights)
        else:
            for loop in target.loops:
                face, weights = places[loop.vertex_index]
                corners = old.polygons[face].loop_indices
                new.data[loop.index].color = mean([layer.data[corner].color for corner in corners], weights)
    if old.color_attributes.active_color:
        target.color_attributes.active_color = target.color_attributes[old.color_attributes.active_color.name]


def transfer_groups(source, source_object, target_object, places):
    """The weights of all vertex groups."""
    old = source.mesh
    weights_of = [{item.group: item.weight for item in vertex.groups} for vertex in old.vertices]
    if len(target_object.vertex_groups) == 0:
        for group in source_object.vertex_groups:
            target_object.vertex_groups.new(name=group.name)
    for vertex, (face, weights) in enumerate(places):
        sums = {}
        for corner, weight in zip(old.polygons[face].vertices, weights):
            for group, value in weights_of[corner].items():
                sums[group] = sums.get(group, 0) + weight * value
        for group, value in sums.items():
            if value > 0:
                target_object.vertex_groups[group].add([vertex], min(value, 1), "REPLACE")


def transfer_faces(source, target):
    """Material and smoothness of each face."""
    for polygon in target.polygons:
        old = source.mesh.polygons[source.face(polygon.center)[0]]
        polygon.material_index = old.material_index
        polygon.use_smooth = old.use_smooth


def dropped(source_object):
    """Sentences about what does not come over."""
    sentences = []
    if source_object.data.shape_keys:
        sentences.append("shape keys are left behind")
    for modifier in source_object.modifiers:
        if modifier.type in BOUND_MODIFIERS:
            sentences.append(f"the modifier {modifier.name} was bound to the old vertices: bind it anew")
    return sentences


def transfer_all(old_mesh, source_object, target_object):
    """Everything from `old_mesh`, which `source_object` shows, to the mesh of `target_object`."""
    target = target_object.data
    source = Source(old_mesh)
    places = [source.place(Vector(vertex.co)) for vertex in target.vertices]
    transfer_faces(source, target)
    transfer_uvs(source, target)
    transfer_colours(source, target, places)
    transfer_groups(source, source_object, target_object, places)
    target.update()


def new_object(source_object, mesh, with_modifiers):
    """A copy of the object with another mesh: its transform, parent, materials and, if wanted, modifiers."""
    copy = source_object.copy()
    slots = [slot.material for slot in source_object.material_slots]
    for material in source_object.data.materials:
        mesh.materials.append(material)
    copy.data = mesh
    for slot, material in zip(copy.material_slots, slots):
        if slot.link == "OBJECT":
            slot.material = material
    if not with_modifiers:
        copy.modifiers.clear()
    for collection in source_object.users_collection:
        collection.objects.link(copy)
    return copy


__all__ = ["dropped", "new_object", "transfer_all"]

# SPDX-License-Identifier: GPL-3.0-or-later
"""Meshes of Blender as files of the program, in coordinates of the world, and back."""

import numpy as np


class Refusal(Exception):
    """Why an object cannot be remeshed, in a sentence."""


def matrix_of(source):
    matrix = np.array(source.matrix_world, dtype=float)
    if not np.isfinite(matrix).all() or abs(np.linalg.det(matrix[:3, :3])) < 1e-30:
        raise Refusal(f"{source.name} is scaled to nothing")
    return matrix


def points_of(mesh, matrix):
    """The vertices in the world, (n, 3)."""
    points = np.empty(3 * len(mesh.vertices), dtype=np.float32)
    mesh.vertices.foreach_get("co", points)
    return points.reshape(-1, 3).astype(float) @ matrix[:3, :3].T + matrix[:3, 3]


def write_surface(mesh, matrix, path):
    """An OBJ file with the same numbers of vertices. Faces of a mirrored object are turned outward."""
    if not mesh.polygons:
        raise Refusal("the mesh has no faces")
    turned = -1 if np.linalg.det(matrix[:3, :3]) < 0 else 1
    with open(path, "w", encoding="ascii") as file:
        for x, y, z in points_of(mesh, matrix).tolist():
            file.write(f"v {x!r} {y!r} {z!r}\n")
        for polygon in mesh.polygons:
            file.write("f " + " ".join(str(v + 1) for v in tuple(polygon.vertices)[::turned]) + "\n")


def creases_of(mesh):
    """The creases of the edges; of Blender 3.4 each edge has one, later ones keep an attribute."""
    if hasattr(mesh, "edge_creases"):
        layer = mesh.edge_creases
        return [item.value for item in layer.data] if layer else [0] * len(mesh.edges)
    return [edge.crease for edge in mesh.edges]


def marked_edges(mesh, kinds):
    """The edges, as pairs of vertices, that are of one of the kinds SHARP, CREASE and SEAM."""
    creases = creases_of(mesh) if "CREASE" in kinds else [0] * len(mesh.edges)
    return [
        tuple(edge.vertices)
        for edge, crease in zip(mesh.edges, creases)
        if ("SHARP" in kinds and edge.use_edge_sharp) or ("SEAM" in kinds and edge.use_seam) or crease > 0
    ]


def write_marks(edges, path):
    with open(path, "w", encoding="ascii") as file:
        for first, second in edges:
            file.write(f"mark {first} {second}\n")


def read_quads(path):
    """Vertices (n, 3) and polygons of the program's OBJ file."""
    points, polygons = [], []
    with open(path, encoding="ascii") as file:
        for line in file:
            words = line.split()
            if words and words[0] == "v":
                points.append([float(word) for word in words[1:4]])
            elif words and words[0] == "f":
                polygons.append([int(word) - 1 for word in words[1:]])
    return np.array(points), polygons


def fill_mesh(mesh, points, polygons, matrix):
    """Gives an empty mesh points of the world and polygons, in the coordinates of an object."""
    inverse = np.linalg.inv(matrix)
    local = points @ inverse[:3, :3].T + inverse[:3, 3]
    turned = -1 if np.linalg.det(matrix[:3, :3]) < 0 else 1
    mesh.from_pydata(local.tolist(), [], [polygon[::turned] for polygon in polygons])
    mesh.update()

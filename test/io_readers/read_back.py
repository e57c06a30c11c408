# SPDX-License-Identifier: GPL-3.0-or-later
"""read_back.py PROGRAM: the files that the program writes, read by others: meshio, Gmsh, VTK. Exit code 77 if none is there."""

import importlib
import math
import os
import subprocess
import sys
import tempfile

COLUMNS, ROWS = 24, 12


def textured_torus(path):
    """With texture coordinates, colours, two groups and two materials."""
    with open(path, "w", encoding="ascii") as obj:
        for i in range(COLUMNS):
            for j in range(ROWS):
                a, b = 2 * math.pi * i / COLUMNS, 2 * math.pi * j / ROWS
                r = 1 + 0.4 * math.cos(b)
                obj.write(f"v {r * math.cos(a)} {r * math.sin(a)} {0.4 * math.sin(b)} {i / COLUMNS} {j / ROWS} 0.5\n")
        for i in range(COLUMNS + 1):
            for j in range(ROWS + 1):
                obj.write(f"vt {i / COLUMNS} {j / ROWS}\n")
        obj.write("vn 0 0 1\n")
        for i in range(COLUMNS):
            obj.write("g left\nusemtl red\n" if i == 0 else "g right\nusemtl blue\n" if i == COLUMNS // 2 else "")
            for j in range(ROWS):
                corners = [(i, j), (i + 1, j), (i + 1, j + 1), (i, j + 1)]
                obj.write("f " + " ".join(f"{(k % COLUMNS) * ROWS + l % ROWS + 1}/{k * (ROWS + 1) + l + 1}/1"
                                          for k, l in corners) + "\n")


def reader(module):
    try:
        return importlib.import_module(module)
    except ImportError:
        print(f"SKIPPED: the python module {module} is not installed")
        return None


def check(what, found, expected):
    if found != expected:
        sys.exit(f"FAILED: {what}: {found}, expected {expected}")


def by_meshio(meshio, files, points, quads):
    # It knows no texture coordinates of corners and no quads in OFF: OBJ and PLY are left to VTK.
    for extension in ("vtu", "inp", "msh"):
        mesh = meshio.read(files[extension])
        cells = sum(len(block.data) for block in mesh.cells if block.type == "quad")
        check(f"meshio's points of {extension}", len(mesh.points), points)
        check(f"meshio's quads of {extension}", cells, quads)
        if extension == "vtu":
            check("meshio's groups of vtu", {int(x) for block in mesh.cell_data["group"] for x in block}, {0, 1})
        if extension == "inp":
            check("meshio's sets of inp", {"GROUP_LEFT", "GROUP_RIGHT"} <= {name.upper() for name in mesh.cell_sets}, True)
    print("meshio reads vtu, inp and msh")


def by_gmsh(gmsh, files, points, quads):
    gmsh.initialize()
    gmsh.option.setNumber("General.Terminal", 0)
    gmsh.open(files["msh"])
    tags = gmsh.model.mesh.getNodes()[0]
    kinds, elements, _ = gmsh.model.mesh.getElements(2)
    names = {gmsh.model.getPhysicalName(*group) for group in gmsh.model.getPhysicalGroups()}
    check("Gmsh's points", len(tags), points)
    check("Gmsh's quads", sum(len(e) for kind, e in zip(kinds, elements) if kind == 3), quads)
    check("Gmsh's names", {"group_left", "group_right", "material_red", "material_blue"} <= names, True)
    gmsh.finalize()
    print("Gmsh reads msh")


def by_vtk(vtk, files, points, quads):
    for extension, kind in (("vtu", vtk.vtkXMLUnstructuredGridReader), ("ply", vtk.vtkPLYReader),
                            ("obj", vtk.vtkOBJReader), ("vtk", vtk.vtkPolyDataReader)):
        read = kind()
        read.SetFileName(files[extension])
        read.Update()
        mesh = read.GetOutput()
        check(f"VTK's cells of {extension}", mesh.GetNumberOfCells(), quads)
        if extension not in ("obj", "ply"):  # there VTK doubles points at seams of the texture
            check(f"VTK's points of {extension}", mesh.GetNumberOfPoints(), points)
        if extension == "vtu":
            check("VTK's arrays", mesh.GetCellData().HasArray("material") + mesh.GetPointData().HasArray("colour"), 2)
    read = vtk.vtkGLTFReader()
    read.SetFileName(files["glb"])
    read.Update()
    faces, stack = 0, [read.GetOutput()]
    while stack:
        block = stack.pop()
        if block is not None and block.IsA("vtkMultiBlockDataSet"):
            stack += [block.GetBlock(i) for i in range(block.GetNumberOfBlocks())]
        elif block is not None:
            faces += block.GetNumberOfCells()
            check("VTK's texture coordinates of glb", block.GetPointData().GetTCoords() is not None, True)
    check("VTK's triangles of glb", faces, 2 * quads)
    print("VTK reads vtu, ply, obj, vtk and glb")


def main(program):
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "torus.obj")
        textured_torus(source)
        files = {}
        for extension in ("obj", "ply", "vtu", "inp", "msh", "off", "vtk", "glb"):
            files[extension] = os.path.join(folder, "quads." + extension)
            subprocess.run([program, "run", source, "-o", files[extension], "--quads", "300", "--effort", "fast"], check=True,
                           stdout=subprocess.DEVNULL)
        with open(files["off"], encoding="ascii") as off:
            points, quads = (int(x) for x in off.read().split()[1:3])
        found = 0
        for module, read in (("meshio", by_meshio), ("gmsh", by_gmsh), ("vtk", by_vtk)):
            imported = reader(module)
            if imported:
                read(imported, files, points, quads)
                found += 1
        sys.exit(0 if found else 77)


if __name__ == "__main__":
    main(sys.argv[1])

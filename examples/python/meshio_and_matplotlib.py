# SPDX-License-Identifier: GPL-3.0-or-later
"""A mesh that meshio reads, its quads written by meshio, and shown by matplotlib."""

import sys

import reebquad

try:
    import matplotlib
    import matplotlib.pyplot as plt
    import meshio
    from mpl_toolkits.mplot3d.art3d import Poly3DCollection
except ImportError as missing:
    print(f"SKIP: {missing.name} is not installed (Debian: python3-meshio, python3-matplotlib)")
    sys.exit(0)


def main():
    # Any file that meshio reads: here a VTU of a built-in shape.
    points, faces = reebquad.make_shape("l-shape", 1500)
    meshio.Mesh(points, [("triangle", faces)]).write("l-shape.vtu")

    mesh = meshio.read(sys.argv[1] if len(sys.argv) > 1 else "l-shape.vtu")
    result = reebquad.quadrangulate(mesh.points, mesh.get_cells_type("triangle"), quads=700, effort="fast")
    for warning in result.warnings:
        print("warning:", warning)
    meshio.Mesh(result.vertices, [("quad", result.quads)], cell_data={"chart": [result.chart]}).write(
        "quads.vtu"
    )

    axes = plt.figure(figsize=(6, 6)).add_subplot(projection="3d")
    colours = matplotlib.colormaps["tab20"](result.chart % 20)
    axes.add_collection3d(
        Poly3DCollection(
            result.vertices[result.quads], facecolors=colours, edgecolors="black", linewidths=0.4
        )
    )
    low, high = result.vertices.min(axis=0), result.vertices.max(axis=0)
    axes.set(xlim=(low[0], high[0]), ylim=(low[1], high[1]), zlim=(low[2], high[2]))
    axes.set_box_aspect(high - low)
    axes.set_axis_off()
    plt.savefig("quads.png", dpi=120)
    if matplotlib.get_backend().lower() != "agg":
        plt.show()
    assert len(meshio.read("quads.vtu").get_cells_type("quad")) == len(result.quads)
    print(f"{len(result.quads)} quads in quads.vtu, pictured in quads.png")


if __name__ == "__main__":
    main()

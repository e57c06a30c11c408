# SPDX-License-Identifier: GPL-3.0-or-later
"""Designing by edits: extrema, hints, a split pole, an edit that is refused, undo, and the recipe of it all."""

import reebquad


def main():
    points, faces = reebquad.make_shape("hand", 3000)
    editor = reebquad.Editor(points, faces, quads=800)
    editor.apply({"edit": "suggest"})
    design = editor.design()
    print(f"{len(design['extrema'])} extrema, {len(design['charts'])} charts, {design['quads']} quads")
    for hint in editor.hints()[:3]:
        print("hint:", hint["reason"])

    tip = design["extrema"][0]["point"]
    editor.apply("split_pole", at=tip, kind="half")
    print(
        "the pole is split; mean scaled Jacobian",
        round(editor.quads().statistics["scaled_jacobian"]["mean"], 3),
    )
    try:
        editor.apply("remove_contour", at=tip)
    except reebquad.Error as refused:
        print(f"refused ({refused.code}): {refused}")
    editor.undo()
    editor.apply("set_target", quads=1200)

    quads = editor.quads()
    quads.write("hand.obj")
    with open("hand.recipe", "w", encoding="utf-8") as file:
        file.write(editor.recipe)
    again = reebquad.Editor.replay(points, faces, editor.recipe)
    assert again.quads().vertices.tobytes() == quads.vertices.tobytes()
    print(f"{len(quads.quads)} quads; the recipe has {len(again.edits)} edits and gives the same bytes")


if __name__ == "__main__":
    main()

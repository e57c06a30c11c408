# SPDX-License-Identifier: GPL-3.0-or-later
"""The gallery, a page of the manual: shapes, each with its picture, recipe, numbers and the lines that make it.

    python3 doc/gallery/make.py PROGRAM                      makes all of it anew
    python3 doc/gallery/make.py PROGRAM --only hand torus    these, and the page (without names: that alone)
    python3 doc/gallery/make.py PROGRAM --check              compares: the page, and what some of the recipes give
    python3 doc/gallery/make.py PROGRAM --meshes IN --out DIR [-- OPTIONS OF run]    a gallery of one's own meshes

PROGRAM is build/release/bin/reebquad. Where no picture can be written (`reebquad version`), nothing can be made,
but compared."""
import argparse
import glob
import json
import os
import shlex
import subprocess
import sys
import tempfile

import small_png

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(HERE))
PAGE = os.path.join(ROOT, "doc", "Reeb_quadrangulation", "gallery.md")
NUMBERS = os.path.join(HERE, "numbers.json")
RECIPES = "test/Reeb_quadrangulation/recipes"
EXTENSIONS = (".obj", ".off", ".ply", ".stl", ".glb", ".gltf")
# These are replayed by the test: recipes of every kind that take a moment each.
CHECKED = ["ellipsoid", "sphere_saddle", "torus", "cylinder", "l_shape_texture"]

# name, title, the built-in shape and its triangles, `run` with options or `replay` with a recipe, what there is to see.
ENTRIES = [
    ("ellipsoid", "An ellipsoid that equals its mirror image", "ellipsoid", 4000,
     "run --quads 600 --effort fast --mirror x",
     "One half is meshed and reflected, so that the other half has the same quads to the bit."),
    ("sphere_saddle", "A sphere with a saddle in quarters", "sphere", 4000,
     f"replay {RECIPES}/sphere_quarter_saddles.json",
     "The saddle between two maxima is taken apart into four vertices of valence 5, a patch of regular quads\n"
     "between them."),
    ("sphere_texture", "A pattern on a sphere", "sphere", 4000,
     "replay doc/gallery/sphere_texture.json",
     "Operators on connectivity textures set quads into others and add a loop of quads; everything around them\n"
     "stays as it was."),
    ("torus", "A torus without any extraordinary vertex", "torus", 4000,
     f"replay {RECIPES}/torus_regular.json",
     "Both saddles are taken apart into halves, and their corners meet those of the extrema and vanish."),
    ("bitorus", "Two tori with four extraordinary vertices", "bitorus", 7000,
     f"replay {RECIPES}/bitorus_half.json",
     "The outer saddles vanish as those of the torus do; those between the holes become two halves each, of\n"
     "valence 6."),
    ("genus_3", "Three holes", "genus-3", 8000,
     "run --quads 1200 --effort fast --mirror auto",
     "The plane of symmetry is found; extrema are suggested, a chart runs through every handle."),
    ("l_shape_lines", "Lines of quads on sharp edges", "l-shape", 6000,
     "run --quads 900 --effort fast --feature-lines",
     "Whole lines of edges lie on the sharp edges, and a vertex on each corner."),
    ("l_shape_texture", "Coarse quads, designed for the sharp edges", "l-shape", 6000,
     f"replay {RECIPES}/l_shape_texture.json --feature-lines",
     "Contours are moved by planes, textures inset and subdivided, and vertices dragged onto the corners."),
    ("twisted_bar", "A twisted bar, all by hand", "twisted-bar", 7000,
     f"replay {RECIPES}/twisted_bar.json --feature-lines",
     "Contours snap onto the ends, charts are divided and shifted, so that columns of quads follow the four edges."),
    ("cylinder", "A surface with boundary", "cylinder", 3000,
     "run --quads 400 --effort fast",
     "The rims are kept as rims, and no vertex is extraordinary."),
    ("hand", "A hand, finer where it bends", "hand", 6000,
     "run --quads 900 --effort fast --adaptive=4",
     "Where the surface bends, as in the fingers, quads are subdivided up to four times finer."),
    ("octahedron", "An octahedron", "octahedron", 400,
     "run --quads 600 --effort fast --feature-lines",
     "The quads keep the twelve edges, and its six corners are vertices."),
]


def run(program, line, work):
    """Runs one line of the program in the folder that recipes' paths start at; what it says on success."""
    line = line.replace("@OUT@", shlex.quote(work))
    done = subprocess.run([program] + shlex.split(line), cwd=ROOT, capture_output=True, text=True)
    if done.returncode != 0:
        raise SystemExit(f"gallery: reebquad {line} ended with {done.returncode}: {done.stderr.strip()}")
    return done.stdout


def lines_of(name, shape, triangles, how):
    """The three lines that make a picture, without the program's name."""
    command, _, rest = how.partition(" ")
    recipe = ""
    if command == "replay":
        recipe, _, rest = rest.partition(" ")
        recipe = " " + recipe
    else:
        rest += f" --write-recipe @OUT@/{name}.json"
    made = f"{command} @OUT@/{name}.obj{recipe} -o @OUT@/{name}_quads.obj {rest}".strip()
    return [f"shape {shape} -o @OUT@/{name}.obj --triangles {triangles}", f"{made} --pictures @OUT@/{name}",
            f"stats @OUT@/{name}_quads.obj --against @OUT@/{name}.obj"]


def recipe_of(name, how):
    """Where the recipe of an entry is, from the root of the project."""
    return how.split()[1] if how.startswith("replay") else f"doc/gallery/{name}.json"


def measured(program, name, work):
    """What `reebquad stats` tells about quads, as far as the page shows it."""
    said = json.loads(run(program, f"stats @OUT@/{name}_quads.obj --against @OUT@/{name}.obj --json", work))
    certificate, statistics = said["certificate"], said["statistics"]
    shape = certificate["shape"]
    valences = {v: n for v, n in certificate["interior_valences"].items() if v != "4"}
    return {"passed": certificate["passed"], "quads": statistics["quads"], "valences": valences,
            "holes": sum(c["boundary_loops"] for c in certificate["components"]),
            "worst_jacobian": round(statistics["scaled_jacobian"]["minimum"], 2),
            "distance_percent": round(100 * shape["distance"] / shape["diagonal"], 2)}


def sentence(n):
    """The numbers in words."""
    irregular = ", ".join(f"{number} of valence {valence}" for valence, number in n["valences"].items())
    holes = f", {n['holes']} boundary loops" if n["holes"] else ""
    return (f"{n['quads']} quads{holes}; extraordinary vertices inside: {irregular or 'none'};\n"
            f"worst scaled Jacobian {n['worst_jacobian']:.2f}; at most {n['distance_percent']:.2f} % of the diagonal "
            f"away from the shape; the certificate {'passes' if n['passed'] else 'FAILS'}.")


def wrapped(line):
    """A line of the shell, in the page's width."""
    if len(line) < 100:
        return "    " + line
    at = max(line.rfind(" -", 0, 100), line.find(" -"))
    return f"    {line[:at]} \\\n        {line[at + 1:]}"


def section(title, anchor, picture, words, lines, numbers, recipe):
    """One shape of the page."""
    shown = "\n".join(wrapped("reebquad " + line.replace("@OUT@/", "out/")) for line in lines)
    return (f"\\section {anchor} {title}\n\n\\image html {picture}\n\n{words}\n\n{shown}\n\n{sentence(numbers)}\n\n"
            f"Its recipe: `{recipe}`.\n")


HEAD = """# Gallery {#Reeb_gallery}

<!-- SPDX-License-Identifier: GPL-3.0-or-later -->
<!-- Written by doc/gallery/make.py. -->

Twelve built-in shapes, each with the lines that make it, from the root of the project, with `reebquad` on `PATH`
(it is `build/release/bin/reebquad`) and a folder `out`. The numbers are those of the third line. Every recipe, also
that of an automatic run, gives the same bytes again:
`reebquad replay out/hand.obj doc/gallery/hand.json -o again.obj`.

`python3 doc/gallery/make.py build/release/bin/reebquad --meshes FOLDER --out DIR -- --quads 2000` makes such a page
of meshes of your own, with any options of `run`.
"""


def page(numbers):
    """The page of the manual."""
    parts = [HEAD]
    for name, title, shape, triangles, how, words in ENTRIES:
        parts.append(section(title, "gallery_" + name, f"gallery_{name}.png", words,
                             lines_of(name, shape, triangles, how), numbers[name], recipe_of(name, how)))
    return "\n".join(parts)


def make(program, only):
    """Makes entries anew, and the page of all."""
    numbers = {}
    if os.path.exists(NUMBERS):
        with open(NUMBERS) as file:
            numbers = json.load(file)
    for name, _, shape, triangles, how, _ in ENTRIES:
        if only is not None and name not in only:
            continue
        with tempfile.TemporaryDirectory() as work:
            for line in lines_of(name, shape, triangles, how):
                run(program, line, work)
            numbers[name] = measured(program, name, work)
            small_png.make_small(f"{work}/{name}/quads.png", f"{HERE}/gallery_{name}.png")
            if how.startswith("run"):
                with open(f"{work}/{name}.json") as made, open(f"{HERE}/{name}.json", "w") as kept:
                    kept.write(made.read())
        print(f"{name}: {sentence(numbers[name])}".replace("\n", " "), flush=True)
    with open(NUMBERS, "w") as file:
        json.dump({name: numbers[name] for name, *_ in ENTRIES if name in numbers}, file, indent=1)
        file.write("\n")
    if all(name in numbers for name, *_ in ENTRIES):
        text = page(numbers)
        with open(PAGE, "w") as file:
            file.write(text)


def differences(told, now):
    """What is not as the page tells: counts exactly, shapes within what another machine's rounding may change."""
    faults = [key for key in ("passed", "quads", "valences", "holes") if told[key] != now[key]]
    if abs(told["worst_jacobian"] - now["worst_jacobian"]) > 0.1:
        faults.append("worst_jacobian")
    if not 2 / 3 <= (now["distance_percent"] + 0.02) / (told["distance_percent"] + 0.02) <= 1.5:
        faults.append("distance_percent")
    return [f"{key}: the page tells {told[key]}, now {now[key]}" for key in faults]


def check(program):
    """Compares the page with its numbers, and these with what recipes give; how many differ."""
    with open(NUMBERS) as file:
        numbers = json.load(file)
    with open(PAGE) as file:
        faults = 0 if file.read() == page(numbers) else 1
    if faults:
        print("gallery.md is not what make.py makes of numbers.json")
    pictures = glob.glob(os.path.join(ROOT, "doc", "**", "*.png"), recursive=True)
    size = sum(os.path.getsize(path) for path in pictures)
    if size > 400000:
        print(f"the pictures of the project take {size} bytes; 400000 are their limit")
        faults += 1
    for name, _, shape, triangles, how, _ in ENTRIES:
        for file in (f"doc/gallery/gallery_{name}.png", recipe_of(name, how)):
            if not os.path.exists(os.path.join(ROOT, file)):
                print(f"{name}: {file} is missing")
                faults += 1
        if name not in CHECKED:
            continue
        options = "--feature-lines" if "--feature-lines" in how else ""
        with tempfile.TemporaryDirectory() as work:
            run(program, lines_of(name, shape, triangles, how)[0], work)
            run(program, f"replay @OUT@/{name}.obj {recipe_of(name, how)} -o @OUT@/{name}_quads.obj {options}", work)
            for difference in differences(numbers[name], measured(program, name, work)):
                print(f"{name}: {difference}")
                faults += 1
    print(f"{len(CHECKED)} recipes of the gallery replayed, {faults} faults")
    return faults


def gallery_of_folder(program, folder, out, options):
    """A page of the meshes in a folder, with pictures and recipes beside it; those that fail are named in it."""
    os.makedirs(out, exist_ok=True)
    out = os.path.abspath(out)
    parts = []
    for file in sorted(os.listdir(folder)):
        name, extension = os.path.splitext(file)
        if extension.lower() not in EXTENSIONS:
            continue
        made = f"@OUT@/{shlex.quote(name)}"
        source = shlex.quote(os.path.abspath(os.path.join(folder, file)))
        lines = [f"run {source} -o {made}_quads.obj {shlex.join(options)} --write-recipe {made}.json "
                 f"--pictures {made}",
                 f"stats {made}_quads.obj --against {source}"]
        try:
            run(program, lines[0] + " --force", out)
            said = run(program, lines[1], out)
        except SystemExit as reason:
            parts.append(f"## {name}\n\n{reason}\n")
            continue
        small_png.make_small(f"{out}/{name}/quads.png", f"{out}/{name}.png")
        shown = "\n".join("    reebquad " + line.replace("@OUT@", shlex.quote(out)) for line in lines)
        told = "\n".join("    " + line for line in said.splitlines())
        parts.append(f"## {name}\n\n![{name}](<{name}.png>)\n\n{shown}\n\n{told}\n\n"
                     f"Its recipe: [{name}.json](<{name}.json>)\n")
    with open(os.path.join(out, "gallery.md"), "w") as page_file:
        page_file.write("# Gallery\n\n" + "\n".join(parts))
    print(f"{len(parts)} meshes: {out}/gallery.md")


def main():
    own, options = sys.argv[1:], []
    if "--" in own:
        options = own[own.index("--") + 1:]
        own = own[:own.index("--")]
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("program")
    parser.add_argument("--only", nargs="*")
    parser.add_argument("--check", action="store_true")
    parser.add_argument("--meshes")
    parser.add_argument("--out", default="gallery")
    arguments = parser.parse_args(own)
    program = os.path.abspath(arguments.program)
    if arguments.check:
        raise SystemExit(1 if check(program) else 0)
    if arguments.meshes:
        gallery_of_folder(program, arguments.meshes, arguments.out, options)
    else:
        make(program, arguments.only)


if __name__ == "__main__":
    main()

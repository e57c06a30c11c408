# SPDX-License-Identifier: GPL-3.0-or-later
"""The wheel that pip makes holds all of the package, and works where nothing else of the project is."""

import glob
import importlib.util
import os
import shutil
import subprocess
import sys
import tempfile
import zipfile

ROOT = os.path.dirname(os.path.dirname(os.path.dirname(os.path.abspath(__file__))))
PROGRAM = """
import os, reebquad
assert os.path.dirname(reebquad.__file__) == os.path.abspath("site/reebquad")
result = reebquad.quadrangulate(*reebquad.make_shape("torus", 500), quads=100, effort="fast")
print(reebquad.__version__, result.certificate["passed"])
"""


def pip(*arguments, folder):
    subprocess.run(
        [sys.executable, "-m", "pip", "--disable-pip-version-check", *arguments], cwd=folder, check=True
    )


def main():
    for module in ("pip", "setuptools", "wheel"):
        if importlib.util.find_spec(module) is None:
            print(f"SKIP: {module} is not installed (cmake/packages.sh)")
            return
    with tempfile.TemporaryDirectory() as folder:
        source = os.path.join(folder, "source")
        os.mkdir(source)
        for name in ("pyproject.toml", "setup.py", "README.md", "CMakeLists.txt"):
            shutil.copy(os.path.join(ROOT, name), source)
        shutil.copytree(os.path.join(ROOT, "python"), os.path.join(source, "python"))
        pip("wheel", "--quiet", "--no-build-isolation", "--no-deps", "-w", folder, source, folder=folder)
        (wheel,) = glob.glob(os.path.join(folder, "*.whl"))
        names = {os.path.basename(name) for name in zipfile.ZipFile(wheel).namelist()}
        missing = set(os.listdir(os.path.join(ROOT, "python", "reebquad"))) - names - {"__pycache__"}
        assert not missing, missing
        assert any(name.startswith("_core") and name.endswith((".so", ".pyd")) for name in names), names
        pip("install", "--quiet", "--no-deps", "--target", "site", wheel, folder=folder)
        environment = {**os.environ, "PYTHONPATH": os.path.join(folder, "site")}
        done = subprocess.run(
            [sys.executable, "-c", PROGRAM],
            cwd=folder,
            env=environment,
            check=True,
            capture_output=True,
            text=True,
        )
        version, passed = done.stdout.split()
        assert passed == "True" and version in os.path.basename(wheel), done.stdout
        print("the wheel", os.path.basename(wheel), "works")


if __name__ == "__main__":
    main()

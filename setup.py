# SPDX-License-Identifier: GPL-3.0-or-later
"""Builds the compiled module of the Python package by CMake; what else there is to say stands in
pyproject.toml.

With REEBQUAD_BUILD_DIR the module is taken from that build folder, where it has been built.
"""

import os
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = os.path.dirname(os.path.abspath(__file__))


def version():
    with open(os.path.join(ROOT, "CMakeLists.txt"), encoding="utf-8") as file:
        return re.search(r"project\(Reeb_quadrangulation VERSION ([0-9.]+)", file.read()).group(1)


class CMakeBuild(build_ext):
    """Configures, builds the module alone, and installs the component `python` where setuptools wants it."""

    def build_extension(self, ext):
        folder = os.environ.get("REEBQUAD_BUILD_DIR")
        if not folder:
            folder = os.path.abspath(self.build_temp)
            subprocess.check_call(
                [
                    "cmake",
                    "-S",
                    ROOT,
                    "-B",
                    folder,
                    "-DCMAKE_BUILD_TYPE=Release",
                    "-DREEBQUAD_PYTHON=ON",
                    "-DREEBQUAD_CLI=OFF",
                    "-DREEBQUAD_TESTS=OFF",
                    "-DREEBQUAD_BENCHMARKS=OFF",
                    f"-DPython_EXECUTABLE={sys.executable}",
                    *os.environ.get("CMAKE_ARGS", "").split(),
                ]
            )
            jobs = str(self.parallel or os.cpu_count() or 1)
            subprocess.check_call(
                ["cmake", "--build", folder, "--target", "reebquad_python", "--parallel", jobs]
            )
        target = os.path.dirname(os.path.dirname(os.path.abspath(self.get_ext_fullpath(ext.name))))
        subprocess.check_call(["cmake", "--install", folder, "--component", "python", "--prefix", target])


setup(
    version=version(),
    ext_modules=[Extension("reebquad._core", sources=[])],
    cmdclass={"build_ext": CMakeBuild},
)

"""Builds the extension by CMake, and installs the package's files into the wheel."""

import pathlib
import re
import subprocess
import sys

from setuptools import Extension, setup
from setuptools.command.build_ext import build_ext

ROOT = pathlib.Path(__file__).resolve().parents[2]


class CMakeBuild(build_ext):
    def run(self):
        build = pathlib.Path(self.build_temp).resolve()
        subprocess.run(["cmake", "-S", ROOT, "-B", build, "-G", "Ninja", "-DCMAKE_BUILD_TYPE=Release",
                        "-DSCB_BUILD_PYTHON=ON", "-DSCB_BUILD_TESTS=OFF", f"-DPython3_EXECUTABLE={sys.executable}",
                        "-DSCB_PYTHON_DESTINATION=."], check=True)
        subprocess.run(["cmake", "--build", build, "--target", "scb_python"], check=True)
        subprocess.run(["cmake", "--install", build, "--component", "python", "--prefix",
                        pathlib.Path(self.build_lib).resolve()], check=True)


version = re.search(r"project\(scb VERSION ([0-9.]+)", (ROOT / "CMakeLists.txt").read_text())
setup(version=version[1], ext_modules=[Extension("scb._scb", [])], cmdclass={"build_ext": CMakeBuild})

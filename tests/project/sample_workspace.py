"""Packages for a workspace. `python -m tests.project.sample_workspace DIR` writes one that is built and passes its test."""

from __future__ import annotations

import sys
from pathlib import Path

PASSES = "def test_sum() -> None:\n    assert 1 + 1 == 2\n"
FAILS = "def test_sum() -> None:\n    assert 1 + 1 == 3\n"
SETUP = """from setuptools import setup
setup(name='{name}', version='0.0.0', packages=['{name}'], data_files=[('share/{name}', ['package.xml'])])
"""
MANIFEST = """<package format="3"><name>{name}</name><version>0.0.0</version><description>d</description>
<maintainer email="student@todo.todo">a</maintainer><license>MIT</license>{needs}
<export><build_type>ament_python</build_type></export></package>
"""


def package(workspace: Path, name: str, test: str = "", setup: str = SETUP, needs: str = "") -> None:
    """Write a package of Python; '' is no test."""
    folder = workspace / "src" / name
    files = {
        "package.xml": MANIFEST.format(name=name, needs=needs),
        "setup.py": setup.format(name=name),
        f"{name}/__init__.py": "",
    }
    for path, text in (files | ({"test/test_it.py": test} if test else {})).items():
        (folder / path).parent.mkdir(parents=True, exist_ok=True)
        (folder / path).write_text(text, encoding="utf-8")


if __name__ == "__main__":
    package(Path(sys.argv[1]), "good", PASSES)

"""On a plain checkout, with nothing installed, tools find every module that ours import."""

from __future__ import annotations

import ast
import json
import os
import re
import shutil
import subprocess
import sys
import venv
from pathlib import Path

import pytest

from tests.support.source_files import OF_DISTRIBUTIONS, ON_THE_PATH, PACKAGES, copy_of_checkout, trees

pytestmark = pytest.mark.process

PYRIGHT = os.environ.get("DAY6_PYRIGHT") or shutil.which("basedpyright", path=os.path.dirname(sys.executable))


def ours() -> set[str]:
    """Return the names of the packages that are in this repository."""
    for_programs = [path.name for path in (*ON_THE_PATH.iterdir(), *OF_DISTRIBUTIONS.glob("*/*")) if path.is_dir()]
    return {*PACKAGES, *(name for name in for_programs if name.isidentifier()), "tests"} - {"__pycache__"}


def imported() -> set[str]:
    """Return the modules of ours that a module of ours imports, wherever in it."""
    found = set()
    for _, tree in trees(*PACKAGES, "tests", words=("import",)):
        for node in ast.walk(tree):
            if isinstance(node, ast.Import):
                found |= {each.name for each in node.names}
            elif isinstance(node, ast.ImportFrom) and node.module is not None and node.level == 0:
                found.add(node.module)
    names = ours()
    without_file = re.compile(r"\w+\.(msg|srv|action)\._|ros2\w+\.(verb|command)\.")  # made when they are imported
    return {module for module in found if module.partition(".")[0] in names and not without_file.match(module)}


@pytest.fixture(scope="module")
def checkout(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the repository with a module at its top that imports all that ours import, and beside it a bare Python."""
    folder = tmp_path_factory.mktemp("tools")
    copy = copy_of_checkout(folder / "checkout")
    (copy / "asking.py").write_text("".join(f"import {module}\n" for module in sorted(imported())), encoding="utf-8")
    venv.create(folder / "bare", symlinks=sys.platform != "win32")
    return copy


def bare(checkout: Path) -> str:
    return str(checkout.parent / "bare" / ("Scripts/python.exe" if sys.platform == "win32" else "bin/python"))


@pytest.mark.skipif(PYRIGHT is None, reason="basedpyright is not installed (DAY6_PYRIGHT may name another pyright)")
def test_pyright_and_editors_with_it_find_every_import_of_ours(checkout: Path) -> None:
    command = [str(PYRIGHT), "--outputjson", "--pythonpath", bare(checkout), "asking.py"]
    done = subprocess.run(command, cwd=checkout, capture_output=True, text=True, encoding="utf-8")
    found = [
        each["message"]
        for each in json.loads(done.stdout)["generalDiagnostics"]
        if "import" in each.get("rule", "").lower()
    ]
    assert [message for message in found if "could not be resolved" in message] == []


def test_mypy_finds_every_import_of_ours(checkout: Path) -> None:
    command = [sys.executable, "-m", "mypy", "--follow-imports=skip", "--cache-dir", os.devnull]
    done = subprocess.run(
        [*command, "--python-executable", bare(checkout), "asking.py"],
        cwd=checkout, capture_output=True, text=True, encoding="utf-8",
    )  # fmt: skip
    assert done.stdout.startswith("Success"), done.stdout + done.stderr


def test_the_import_rules_are_kept_by_a_checkout_on_its_own(checkout: Path) -> None:
    done = subprocess.run(
        [sys.executable, ".ci/import_rules.py"], cwd=checkout, capture_output=True, text=True, encoding="utf-8"
    )
    assert done.returncode == 0, done.stdout + done.stderr

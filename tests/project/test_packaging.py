"""The traps of top-level folders as a package: forgotten sub-packages, lost data files, second copies of modules."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

if sys.version_info >= (3, 11):
    import tomllib
else:  # the same parser under its old name comes with mypy's dependency
    tomllib = pytest.importorskip("tomli")

ROOT = Path(__file__).resolve().parents[2]
TOPS = ("core", "tui", "urdf")
ON_THE_PATH = ROOT / "core" / "ros" / "python"
OF_DISTRIBUTIONS = ROOT / "core" / "ros" / "python_of"
SHARE = ROOT / "core" / "ros" / "share"
"""Package data, not sub-packages: programs find the first two on sys.path, launch files and configurations in the third."""


def sources() -> list[Path]:
    found = [path for top in TOPS for path in (ROOT / top).rglob("*")]
    return [path for path in found if path.is_file() and not any(_is_cache(part) for part in path.parts)]


def _is_cache(part: str) -> bool:
    """Say whether a part of a path is some tool's cache."""
    return part == "__pycache__" or (part.startswith(".") and part.endswith("_cache"))


def project() -> dict[str, object]:
    return tomllib.loads((ROOT / "pyproject.toml").read_text(encoding="utf-8"))


def test_the_list_of_packages_names_every_folder_with_an_init() -> None:
    listed = set(project()["tool"]["setuptools"]["packages"])  # type: ignore[index]
    folders = {
        "day6_tui." + ".".join(path.parent.relative_to(ROOT).parts)
        for path in sources()
        if path.name == "__init__.py" and not {ON_THE_PATH, OF_DISTRIBUTIONS} & set(path.parents)
    }
    assert listed == folders | {"day6_tui"}


def test_every_folder_with_python_in_it_is_a_package() -> None:
    bare = {
        str(path.parent.relative_to(ROOT))
        for path in sources()
        if path.suffix == ".py"
        and not {ON_THE_PATH, OF_DISTRIBUTIONS, SHARE} & set(path.parents)
        and not (path.parent / "__init__.py").exists()
    }
    assert bare == set()


@pytest.mark.process
def test_the_root_imports_nothing() -> None:
    code = (
        "import sys; before = set(sys.modules); import day6_tui; "
        "print({name for name in set(sys.modules) - before if name.startswith('day6_tui.')})"
    )
    done = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, cwd=ROOT.anchor)
    assert done.stdout == "set()\n"


def test_nobody_imports_the_top_folders_by_their_plain_names() -> None:
    plain = re.compile(r"^\s*(?:from|import) (?:core|tui|urdf)\b", re.MULTILINE)
    offenders = [path for path in [*sources(), *(ROOT / "tests").rglob("*.py")] if path.suffix == ".py"]
    assert [path for path in offenders if plain.search(path.read_text(encoding="utf-8"))] == []


@pytest.fixture(scope="module")
def wheel(tmp_path_factory: pytest.TempPathFactory) -> zipfile.ZipFile:
    """A wheel built from a copy of the checkout, so that no stale build folder can leak into it."""
    folder = tmp_path_factory.mktemp("wheel")
    copy = folder / "checkout"
    ignore = shutil.ignore_patterns("__pycache__", ".*_cache")
    for top in TOPS:
        shutil.copytree(ROOT / top, copy / top, ignore=ignore)
    for name in ("__init__.py", "pyproject.toml", "README.md", "LICENSE"):
        shutil.copy(ROOT / name, copy / name)
    code = f"import setuptools.build_meta as b; b.build_wheel({str(folder)!r})"
    done = subprocess.run([sys.executable, "-c", code], cwd=copy, capture_output=True, text=True)
    assert done.returncode == 0, done.stderr
    (path,) = folder.glob("*.whl")
    return zipfile.ZipFile(path)


def content(wheel: zipfile.ZipFile) -> set[str]:
    """Return what it installs, without its own metadata."""
    return {name for name in wheel.namelist() if not name.split("/")[0].endswith(".dist-info")}


@pytest.mark.process
def test_the_wheel_holds_every_source_and_data_file(wheel: zipfile.ZipFile) -> None:
    packed = content(wheel)
    expected = {"day6_tui/" + path.relative_to(ROOT).as_posix() for path in sources()}
    assert packed == expected | {"day6_tui/__init__.py"}


@pytest.mark.process
def test_the_wheel_brings_no_other_top_level_name(wheel: zipfile.ZipFile) -> None:
    tops = {name.split("/")[0] for name in content(wheel)}
    assert tops == {"day6_tui"}


@pytest.mark.process
def test_the_wheel_declares_the_command(wheel: zipfile.ZipFile) -> None:
    (entry_points,) = [name for name in {*wheel.namelist()} - content(wheel) if name.endswith("entry_points.txt")]
    assert "day6-tui = day6_tui.tui.main:main" in wheel.read(entry_points).decode()


def test_data_files_are_found_through_real_packages() -> None:
    from importlib.resources import files

    assert files("day6_tui.urdf").joinpath("models/day6_bot.urdf").is_file()
    assert files("day6_tui.core.ros").joinpath("share/std_msgs/msg/String.msg").is_file()

"""What `ros2 pkg`, `ros2 interface` and `ros2 doctor` show in each distribution: paths that exist, and no module of ours."""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from day6_core.ros import distribution
from day6_core.ros.program_index import named_by

pytestmark = pytest.mark.long

PATH = re.compile(r"(?<![\w:/.~-])/(?:[\w.+-]+/)+[\w.+-]+")
OURS = ("day6_tui", "core.ros", "python_of", "share_of", "dist-info", "Traceback", "site-packages/day6")


@pytest.fixture(params=distribution.NAMES)
def shown(request: pytest.FixtureRequest, machine: Any, in_distribution: Callable[[str], None]) -> Any:
    """Run `ros2 WORDS…`, look at what it shows, and return the lines of its standard output."""
    in_distribution(request.param)

    def run(*words: str) -> list[str]:
        done = machine.ros2(*words)
        assert done.status == 0, (words, done.stderr)
        text = done.stdout + done.stderr
        # An executable is started by its path by shells and launch files, though it is no file.
        missing = [path for path in PATH.findall(text) if not Path(path).exists() and named_by(Path(path)) is None]
        modules = [each for each in OURS if each in re.sub(PATH, "", text)]
        assert (missing, modules) == ([], []), words
        return done.stdout.splitlines()

    return run


def test_each_package_is_where_it_is_said_to_be(shown: Any) -> None:
    for package in shown("pkg", "list"):
        (prefix,) = shown("pkg", "prefix", package)
        assert shown("pkg", "prefix", "--share", package) == [f"{prefix}/share/{package}"]
        assert f"  <name>{package}</name>" in shown("pkg", "xml", package)
        names = [line.split() for line in shown("pkg", "executables", package)]
        paths = shown("pkg", "executables", "--full-path", package)
        assert paths == [f"{prefix}/lib/{package}/{name}" for _, name in names]


def test_each_interface_that_is_listed_is_shown(shown: Any) -> None:
    listed = [line.strip() for line in shown("interface", "list") if line.startswith(" ")]
    packages = shown("interface", "packages")
    assert {name.partition("/")[0] for name in listed} == set(packages)
    found = [name for package in packages for name in shown("interface", "package", package)]
    assert sorted(found) == sorted(listed)
    for name in found:
        shown("interface", "show", name)


@pytest.mark.parametrize("words", [("doctor",), ("doctor", "--report"), ("wtf", "--report-failed")])
def test_doctor_names_nothing_of_ours(shown: Any, words: tuple[str, ...]) -> None:
    shown(*words)

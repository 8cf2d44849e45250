"""What others make is pinned: packages by version, the hub's by checksum too, images by digest, actions by commit."""

from __future__ import annotations

import re
import shutil
import subprocess
import sys
from importlib.metadata import requires
from pathlib import Path

import pytest
from hatchling.metadata.core import ProjectMetadata
from hatchling.plugin.manager import PluginManager
from packaging.requirements import Requirement

from day6_core.parts import PROJECTS
from day6_tui.wheelhouse import closure
from tests.support.source_files import ROOT

CONSTRAINTS = (ROOT / ".ci/constraints.txt").read_text(encoding="utf-8")
TOML = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
DESKTOP = (ROOT / "requirements/desktop.txt").read_text(encoding="utf-8")
EVERYTHING = (ROOT / "requirements/everything.txt").read_text(encoding="utf-8").removeprefix(
    "-r desktop.txt\n"
) + DESKTOP
OF_THE_HUB = (ROOT / "hub/requirements.txt").read_text(encoding="utf-8")
CONTAINERFILE = (ROOT / "hub/Containerfile").read_text(encoding="utf-8")
WORKFLOWS = [*(ROOT / ".github/workflows").glob("*.yml"), *(ROOT / ".github/actions").rglob("*.yml")]


def versions(pinned: str) -> dict[str, set[str]]:
    """Return the versions of each package; other systems or Pythons may have another one."""
    found: dict[str, set[str]] = {}
    for name, version in re.findall(r"^([a-z0-9-]+)==(\S+)", pinned, re.MULTILINE):
        found.setdefault(name, set()).add(version)
    return found


def wanted(*extras: str) -> list[Requirement]:
    """Return what pyproject.toml names, with these extras."""
    core = ProjectMetadata(str(ROOT), PluginManager()).core
    named = [*core.dependencies, *(line for extra in extras for line in core.optional_dependencies[extra])]
    return [Requirement(line) for line in named]


def unfit(requirements: list[Requirement], pinned: str) -> list[str]:
    """Return the requirements that have no version there, or one they don't allow."""
    found = versions(pinned)
    names = {each: re.sub(r"[-_.]+", "-", each.name.lower()) for each in requirements}
    return [
        str(each)
        for each, name in names.items()
        if name != "day6-tui" and not (name in found and all(map(each.specifier.contains, found[name])))
    ]


def test_all_that_is_asked_for_has_a_version_that_is_allowed() -> None:
    lines = (ROOT / "hub/requirements.in").read_text(encoding="utf-8").splitlines()
    beside = [Requirement(line.partition(" #")[0]) for line in lines if not line.startswith("#")]
    assert unfit(wanted("serve", "test", "mutation"), CONSTRAINTS) == [], "run .ci/pins"
    assert unfit([*wanted("serve"), *beside], OF_THE_HUB) == [], "run .ci/pins"
    assert unfit(wanted(), EVERYTHING) == [], "run .ci/pins"


def test_a_version_that_is_missing_or_not_allowed_is_seen() -> None:
    asked = [Requirement(line) for line in ("rich>=14", "PyYAML>=6", "day6-tui[serve]", "numpy>=1")]
    assert unfit(asked, "rich==13.0.0\npyyaml==6.0.2\n") == ["rich>=14", "numpy>=1"]


def test_the_desktop_has_all_but_the_parts_that_can_be_missing() -> None:
    assert versions(EVERYTHING).keys() - versions(DESKTOP).keys() == set(PROJECTS.values()), "run .ci/pins"


def test_what_yourdfpy_brings_is_either_used_or_excluded() -> None:
    excluded = set(re.findall(r'"([\w-]+)"', TOML[TOML.index("exclude-dependencies = [") :].partition("]")[0]))
    brought = {
        re.sub(r"[-_.]+", "-", each.name.lower())
        for each in map(Requirement, requires("trimesh") or ())
        if each.marker is not None and each.marker.evaluate({"extra": "easy", "platform_machine": "x86_64"})
    }
    assert brought - excluded == brought & versions(EVERYTHING).keys()
    assert closure.USED["trimesh", "easy"] < brought and not excluded & versions(EVERYTHING).keys()


def test_every_package_of_the_image_has_checksums() -> None:
    without = [
        line for line in re.findall(r"^[a-z0-9-]+==.*(?:\n    .*)*", OF_THE_HUB, re.MULTILINE) if "--hash" not in line
    ]
    assert (without, len(versions(OF_THE_HUB)) > 100) == ([], True)


def test_the_pinned_packages_come_from_any_index() -> None:
    assert re.findall(r"://|^-", CONSTRAINTS + EVERYTHING + OF_THE_HUB.replace("    --hash", ""), re.MULTILINE) == []


def test_every_image_is_named_by_version_and_digest() -> None:
    texts = [CONTAINERFILE, *(path.read_text(encoding="utf-8") for path in WORKFLOWS)]
    named = [image for text in texts for image in re.findall(r"^(?:FROM| +image:) (\S+)", text, re.MULTILINE)]
    assert (
        named
        and [each for each in named if not re.fullmatch(r"python:3\.\d+\.\d+-\w+(-\w+)?@sha256:[0-9a-f]{64}", each)]
        == []
    )


def test_every_action_of_others_is_named_by_commit_and_version() -> None:
    used = [
        line
        for path in WORKFLOWS
        for line in re.findall(r"^ +(?:- )?uses: (.*)", path.read_text(encoding="utf-8"), re.MULTILINE)
    ]
    others = [line for line in used if not line.startswith("./")]
    assert (
        others and [line for line in others if not re.fullmatch(r"[\w./-]+@[0-9a-f]{40} # v\d+\.\d+\.\d+", line)] == []
    )
    assert len(set(others)) == len({line.partition("@")[0] for line in others}), "one action in two versions"


@pytest.mark.process
def test_what_the_image_copies_is_enough_to_build_day6_tui(tmp_path: Path) -> None:
    for words in (line.split()[1:] for line in CONTAINERFILE.splitlines() if line.startswith("COPY ")):
        if (target := words[-1]).startswith("/opt/day6-tui"):
            place = tmp_path / target.removeprefix("/opt/day6-tui").lstrip("/")
            for each in words[:-1]:
                if (ROOT / each).is_dir():
                    shutil.copytree(ROOT / each, place, ignore=shutil.ignore_patterns("__pycache__"))
                else:
                    place.mkdir(exist_ok=True)
                    shutil.copy(ROOT / each, place)
    command = [sys.executable, "-m", "hatchling", "build", "--target", "wheel"]
    done = subprocess.run(command, cwd=tmp_path, stdout=subprocess.PIPE, stderr=subprocess.STDOUT, text=True)
    assert done.returncode == 0, done.stdout

"""What `.ci/release` asks of a tree before it is released, and what it builds of it."""

from __future__ import annotations

import shutil
import subprocess
import sys
import zipfile
from pathlib import Path

import pytest

from tests.support.folded import folded
from tests.support.loaded import loaded
from tests.support.source_files import ROOT, copy_of_checkout

RELEASE = loaded(".ci/release")
VERSION = RELEASE.version(ROOT)
TITLE = next(
    title for title in RELEASE.sections((ROOT / "CHANGELOG.md").read_text(encoding="utf-8")) if VERSION in title
)


def tree(folder: Path) -> Path:
    """Copy what a release looks at."""
    for name in ("pyproject.toml", "CHANGELOG.md", *RELEASE.SPOKEN_OF):
        (folder / name).parent.mkdir(parents=True, exist_ok=True)
        shutil.copyfile(ROOT / name, folder / name)
    return folder


def change(file: Path, old: str, new: str) -> None:
    text = file.read_text(encoding="utf-8")
    assert old in text
    file.write_text(text.replace(old, new), encoding="utf-8")


def test_the_changelog_speaks_of_the_version_of_the_tree() -> None:
    """Whatever is changed between two releases stands below [Unreleased]; the last one is always there."""
    sections = RELEASE.sections((ROOT / "CHANGELOG.md").read_text(encoding="utf-8"))
    first, second = list(sections)[:2]
    assert (first, second) == ("[Unreleased]", TITLE) and "### Added" in sections[TITLE]


def test_a_tree_that_is_ready_lacks_nothing_for_the_tag_of_its_version(tmp_path: Path) -> None:
    ready = tree(tmp_path)
    text = (ready / "CHANGELOG.md").read_text(encoding="utf-8")
    unreleased = text[text.index("## [Unreleased]") : text.index(f"## {TITLE}")]
    change(ready / "CHANGELOG.md", unreleased, "## [Unreleased]\n\n")
    assert RELEASE.missing(ready, None) == RELEASE.missing(ready, f"v{VERSION}") == []


@folded(
    "name, old, new, said",
    [
        ("pyproject.toml", f'\nversion = "{VERSION}"', '\nversion = "9.9.9"', "no heading '## [9.9.9] - YYYY-MM-DD'"),
        ("pyproject.toml", f'\nversion = "{VERSION}"', '\nversion = "9.9"', "9.9 is no version"),
        ("CHANGELOG.md", f"## {TITLE}", f"## [{VERSION}]", "no heading"),
        ("CHANGELOG.md", f"## {TITLE}", f"## [{VERSION}] - 2026-13-01", "no heading"),
        ("CHANGELOG.md", f"## {TITLE}", f"## {TITLE}\n\n## [0.0.9] - 2026-01-01", f"says nothing of {VERSION}"),
        ("CHANGELOG.md", "## [Unreleased]", "", "no heading"),
        ("CHANGELOG.md", "## [Unreleased]", "## [Unreleased]\n\n- new", "belongs below"),
        ("CHANGELOG.md", f"\n[{VERSION}]: ", "\n[other]: ", f"no link '[{VERSION}]: …'"),
        ("CHANGELOG.md", f"/v{VERSION}...HEAD", "/v0.0.1...HEAD", "the link of [Unreleased]"),
        ("hub/values.yaml", f'"{VERSION}"', '"0.0.1"', "hub/values.yaml names another version"),
        ("hub/Containerfile", f":{VERSION} .", ":0.0.1 .", "hub/Containerfile names another version"),
        (".github/actions/workspace/action.yml", f"@v{VERSION}", "@v0.0.1", "action.yml names another version"),
    ],
)
def test_what_is_forgotten_is_named(
    tmp_path_factory: pytest.TempPathFactory, name: str, old: str, new: str, said: str
) -> None:
    spoilt = tree(tmp_path_factory.mktemp("tree"))
    change(spoilt / name, old, new)
    assert [line for line in RELEASE.missing(spoilt, None) if said in line]


@folded("tag", ["v9.9.9", VERSION, f"V{VERSION}", f"v{VERSION}rc1"])
def test_a_tag_of_anything_but_the_version_is_refused(tag: str) -> None:
    assert [line for line in RELEASE.missing(ROOT, tag) if line.startswith(f"the tag is {tag},")]


@pytest.mark.process
def test_the_wheel_of_a_release_is_built_of_its_source_distribution(tmp_path: Path) -> None:
    copy = copy_of_checkout(tmp_path / "checkout")
    done = subprocess.run([sys.executable, ".ci/release", "build"], cwd=copy, stdout=subprocess.PIPE, text=True)
    assert done.returncode == 0, done.stdout
    assert {path.name for path in (copy / "dist").iterdir()} == {
        f"day6_tui-{VERSION}.tar.gz",
        f"day6_tui-{VERSION}-py3-none-any.whl",
    }
    with zipfile.ZipFile(copy / "dist" / f"day6_tui-{VERSION}-py3-none-any.whl") as wheel:
        packed = [name for name in wheel.namelist() if name.endswith("day6_tui/main.py")]
    assert packed == ["day6_tui/main.py"]

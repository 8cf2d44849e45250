"""What the package's page shows is made of one address and the README: links to files lead to the repository, all others stay."""

from __future__ import annotations

import re
from collections.abc import Iterator

import pytest
from catkin_pkg.package import parse_package

from tests.support.folded import folded
from tests.support.loaded import loaded
from tests.support.source_files import PACKAGES, ROOT

PROJECT = (ROOT / "pyproject.toml").read_text(encoding="utf-8")
REPOSITORY = re.findall(r'^repository = "(.+)"$', PROJECT, re.MULTILINE)
VERSION = re.findall(r'^version = "(.+)"$', PROJECT, re.MULTILINE)
FILES = "https://host/a/b/blob/v1"
PICTURES = "https://host/a/b/raw/v1"


PAGE = loaded(".ci/package_page.py")


@folded(
    "written, shown",
    [
        ("[the hub](hub/README.md)", f"[the hub]({FILES}/hub/README.md)"),
        ("[keys](docs/en/keys.md#panes)", f"[keys]({FILES}/docs/en/keys.md#panes)"),
        ("![a car](docs/car.svg)", f"![a car]({PICTURES}/docs/car.svg)"),
        ("[![a car](docs/car.svg)](docs/car.md)", f"[![a car]({PICTURES}/docs/car.svg)]({FILES}/docs/car.md)"),
        ('<img src="docs/car.png" alt="x">', f'<img src="{PICTURES}/docs/car.png" alt="x">'),
        ('<source srcset="docs/car.svg">', f'<source srcset="{PICTURES}/docs/car.svg">'),
        ('<a href="README.zh.md">中文</a>', f'<a href="{FILES}/README.zh.md">中文</a>'),
        ("see [it]\n\n[it]: docs/x.md\n", f"see [it]\n\n[it]: {FILES}/docs/x.md\n"),
        (
            "[below](#install) [ROS](https://ros.org/x) <mailto:a@b.c>",
            "[below](#install) [ROS](https://ros.org/x) <mailto:a@b.c>",
        ),
        ("```python\nf[0](x)\n```\n[a](b)", f"```python\nf[0](x)\n```\n[a]({FILES}/b)"),
        ("````\n```\n[a](b)\n```\n````\n", "````\n```\n[a](b)\n```\n````\n"),
    ],
)
def test_links_to_files_lead_to_the_repository_and_all_others_stay(written: str, shown: str) -> None:
    assert PAGE.with_absolute_links(written, "https://host/a/b", "v1") == shown


def texts() -> Iterator[str]:
    """Yield every text that people read who have not installed anything."""
    for place in (*ROOT.glob("*.md"), *(ROOT / name for name in ("NOTICE", ".devcontainer", ".github", "docs", "hub"))):
        for path in place.rglob("*") if place.is_dir() else [place]:
            if path.is_file() and path.suffix in ("", ".html", ".json", ".md", ".yaml", ".yml"):
                yield path.read_text(encoding="utf-8")


def test_the_address_of_the_repository_is_the_same_everywhere() -> None:
    (repository,) = REPOSITORY
    mentions = re.compile(r"(?:\bgithub\.com/|\buses: )([\w.-]+/day6-tui)\b")
    assert {f"https://github.com/{found}" for text in texts() for found in mentions.findall(text)} == {repository}


def test_every_image_and_action_that_a_text_names_is_that_of_this_version() -> None:
    mentions = re.compile(r'day6-tui(?:/[\w./-]+@v|:|\n\s+tag: ")(\d+\.\d+\.\d+)')
    assert {found for text in texts() for found in mentions.findall(text)} == set(VERSION)


@pytest.mark.parametrize("places", [REPOSITORY, VERSION])
def test_address_and_version_are_declared_once(places: list[str]) -> None:
    assert len(places) == 1


def test_our_manifests_claim_no_mailbox() -> None:
    """An address has to stand in them (REP 149); nobody can ever own one of `.invalid` (RFC 2606)."""
    said = {
        (maintainer.name, maintainer.email)
        for path in PACKAGES["day6_core"].rglob("package.xml")
        for maintainer in parse_package(path).maintainers
    }
    assert said == {("day6-tui", "noreply@day6-tui.invalid")}

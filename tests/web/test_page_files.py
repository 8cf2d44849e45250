"""What the pages consist of: files of others as they were published, nothing that a strict policy forbids."""

from __future__ import annotations

import hashlib
import re
from pathlib import Path

import pytest

from day6_tui import web

pytestmark = pytest.mark.browser

STATIC = Path(web.__file__).parent / "static"
PAGES = ("links", "mine", "manifest.webmanifest", "class/log.csv", "class/report.csv")
"""What the server writes itself."""
VENDORED = STATIC / "vendor" / "xterm"


def test_files_of_others_are_as_they_were_published() -> None:
    note = (VENDORED / "VENDORED.txt").read_text(encoding="utf-8")
    sums = dict(reversed(line.split("  ")) for line in note.splitlines() if re.match(r"[0-9a-f]{64}  ", line))
    files = (path for path in VENDORED.rglob("*") if path.is_file())
    found = {path.relative_to(VENDORED).as_posix(): hashlib.sha256(path.read_bytes()).hexdigest() for path in files}
    del found["VENDORED.txt"]
    assert found == sums


def test_everything_of_others_has_its_version_and_license() -> None:
    note = (VENDORED / "VENDORED.txt").read_text(encoding="utf-8")
    versions = set(re.findall(r"^@xterm/(\S+) [0-9.]+$", note, re.MULTILINE))
    scripts = {path.stem for path in VENDORED.glob("*.mjs")}
    assert versions == scripts == {path.name.removeprefix("LICENSE.") for path in VENDORED.glob("LICENSE.*")}


def test_no_page_has_script_or_style_within_it() -> None:
    for page in STATIC.glob("*.html"):
        text = page.read_text(encoding="utf-8")
        assert not re.search(r"<style|\sstyle=|\son\w+=|javascript:", text), page.name
        assert all('src="' in tag for tag in re.findall(r"<script[^>]*>", text)), page.name


def test_pages_name_only_their_own_files_and_these_exist() -> None:
    for page in STATIC.glob("*.html"):
        for name in re.findall(r'(?:src|href)="([^"]+)"', page.read_text(encoding="utf-8")):
            assert name.partition("?")[0] in PAGES or (STATIC / name.removeprefix("static/")).is_file(), (
                page.name,
                name,
            )


def test_our_scripts_import_only_files_that_exist_and_never_make_html_of_text() -> None:
    for script in STATIC.glob("*.js"):
        text = script.read_text(encoding="utf-8")
        for name in re.findall(r'from "([^"]+)"', text):
            assert (STATIC / name).is_file(), (script.name, name)
        assert not re.search(r"innerHTML|outerHTML|insertAdjacentHTML|document\.write|\beval\(|new Function", text), (
            script.name
        )

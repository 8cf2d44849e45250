"""The table of what day6-tui writes outside of its package: nothing is written beside it, and it finds what is there."""

from __future__ import annotations

import ast
import os
import re
from fnmatch import fnmatch
from pathlib import Path

import pytest

from day6_core.places import BASES, LEFT_BEHIND, PLACES, data_folder
from day6_core.ros.environment import program_environment
from tests.support.source_files import nodes, trees

TABLE = {each.name: each for each in PLACES}


def written_below_the_data_folder() -> set[str]:
    """Every name that a module puts behind `data_folder() /`; what an f-string or a function fills in is *."""
    found = set()
    for path, tree in trees(words=("data_folder", "default_home")):
        for node in nodes(tree):
            if path.name == "places.py" and path.parent.name == "day6_core":
                continue
            if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Div) and _calls(node.left, "data_folder"):
                found |= set(_patterns(node.right))
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr == "with_name":
                found |= set(_patterns(node.args[0])) if "default_home" in ast.unparse(node.func.value) else set()
    return found


def _calls(node: ast.expr, name: str) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == name


def _patterns(node: ast.expr) -> list[str]:
    if isinstance(node, ast.IfExp):
        return [*_patterns(node.body), *_patterns(node.orelse)]
    if isinstance(node, ast.JoinedStr):
        return ["".join(str(each.value) if isinstance(each, ast.Constant) else "*" for each in node.values)]
    return [node.value] if isinstance(node, ast.Constant) and isinstance(node.value, str) else [ast.unparse(node)]


def test_all_that_is_written_into_the_data_folder_is_in_the_table() -> None:
    below = [each.below for each in PLACES if each.base == "data"]
    written = written_below_the_data_folder()
    assert {"settings.json", "unsaved", "stubs", "class", "_digest()"} <= written
    program_environment()
    written = written - {"_digest()"} | {each.name for each in data_folder().glob("bin-*")}
    assert [name for name in written if not any(fnmatch(name, pattern) for pattern in below)] == []


def test_every_place_is_written_for_readers_of_every_system() -> None:
    assert len(TABLE) == len(PLACES)
    for each in PLACES:
        assert each.base in BASES and each.whose in ("ours", "user", "ros") and all(each.text), each.name
        assert each.shown("linux") and (each.base == "system" or (each.shown("darwin") and each.shown("win32"))), (
            each.name
        )
        re.compile(each.files)
    assert TABLE["settings"].shown("linux") == "~/.local/share/day6-tui/settings.json"
    assert TABLE["settings"].shown("win32") == r"%LOCALAPPDATA%\day6-tui\settings.json"
    assert TABLE["users"].shown("darwin") == ""


@pytest.mark.parametrize(
    "name",
    [
        *(
            "0",
            "232",
            "0/meet",
            "0/meet.lock",
            "0/meeting.lock",
            "0/gate.lock",
            "0/secret",
            "0/doors-12",
            "0/guests-12",
        ),
        *("0/p-cb62bf690038d21b-16855", "0/p-cb62bf690038d21b-16855.lock", "desktop-0a1b2c3d", "desktop-0a1b2c3d.lock"),
        *(
            "c0a1b2c3d/p/0a1b2c3d/0/meet",
            "c0a1b2c3d/k/desktop-0a1b2c3d.lock",
            "0a1b2c3d/0/meet",
            "0/.day6-0123456789ab",
        ),
    ],
)
def test_sockets_of_ours_are_known_by_name(name: str) -> None:
    assert re.fullmatch(TABLE["sockets"].files, name)


@pytest.mark.parametrize(
    "name", ["notes.txt", "0/notes.txt", "desktop", "desktop-anna", "0/meet/x", "1234", "ssh/agent"]
)
def test_other_names_are_not_ours(name: str) -> None:
    assert not re.fullmatch(TABLE["sockets"].files, name)


@pytest.mark.skipif(os.name == "nt", reason="looks at owners and times")
def test_only_old_folders_with_our_names_count_as_left_behind(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr("tempfile.gettempdir", lambda: str(tmp_path))
    ours = ["day6-shell-ab_c1234", "day6-0123abcd", "d6l-abcdefgh"]
    others = ["day6-12345678", "day6-1000", "d6x-abcdefgh", "day6-notes", "notes"]
    for name in [*ours, *others, "day6-trial-abcdefgh"]:
        (tmp_path / name).mkdir()
    old = (tmp_path / "notes").stat().st_mtime - LEFT_BEHIND - 60
    (tmp_path / "day6-shell-linked01").symlink_to(tmp_path / "notes")
    for name in [*ours, *others]:
        os.utime(tmp_path / name, (old, old))
    found = [each.name for each in TABLE["temporary"].found() if each.parent == tmp_path]
    assert found == sorted(ours)

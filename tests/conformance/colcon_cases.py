"""The recorded cases of the real colcon and `ros2 pkg create`: what was there before each, and what is compared."""

from __future__ import annotations

import json
import re
import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from pathlib import Path

from tests.conformance.golden_cases import GOLDEN
from tests.workspace.workshop import Workshop, edit

CASES_FILE = GOLDEN / "colcon.jsonl"
SETUP = "src/day6_publisher/setup.py"
MANIFEST = "src/day6_publisher/package.xml"


@dataclass(frozen=True)
class Case:
    """One recorded command; `folder` is where it ran, below the workspace."""

    name: str
    command: str
    folder: str
    stdout: str
    stderr: str
    exit_code: int
    tree: list[str] = field(default_factory=list)
    contents: dict[str, str] = field(default_factory=dict)


def load_cases() -> list[Case]:
    """Read all cases."""
    rows = [json.loads(line) for line in CASES_FILE.read_text(encoding="utf-8").splitlines()]
    return [
        Case(
            row["name"],
            row["command"],
            row["cwd"].replace("<WS>", ".").removeprefix("./"),
            row["stdout"],
            row["stderr"],
            row["exit_code"],
            row.get("tree") or [],
            row.get("contents") or {},
        )
        for row in rows
    ]


# -- what was there before ---------------------------------------------------------------------------------------------

Prepare = Callable[[Workshop], object]


def _package(workshop: Workshop) -> Path:
    return workshop.publisher()


def _built(workshop: Workshop) -> None:
    workshop.publisher()
    assert workshop.run("colcon build").status == 0


def _edited(file: str, before: str, after: str) -> Prepare:
    def prepare(workshop: Workshop) -> None:
        workshop.publisher()
        edit(workshop.workspace / file, before, after)

    return prepare


def _emptied(file: str) -> Prepare:
    def prepare(workshop: Workshop) -> None:
        workshop.publisher()
        (workshop.workspace / file).write_text("", encoding="utf-8")

    return prepare


def _removed(file: str) -> Prepare:
    def prepare(workshop: Workshop) -> None:
        workshop.publisher()
        (workshop.workspace / file).unlink()

    return prepare


def _built_without_entry_point(workshop: Workshop) -> None:
    workshop.publisher(entry_point=False)
    assert workshop.run("colcon build").status == 0


def _two_of_one_name(workshop: Workshop) -> None:
    workshop.publisher()
    assert workshop.run("cp -r src/day6_publisher src/copy").status == 0


def _listener_needs_publisher(workshop: Workshop) -> None:
    workshop.publisher()
    workshop.create("day6_listener", "--dependencies day6_publisher")


def _wrong_module(workshop: Workshop) -> None:
    workshop.publisher()
    edit(workshop.workspace / SETUP, "publisher.talker:main", "publisher.talkr:main")  # what the recording does by sed


PREPARATIONS: dict[str, Prepare] = {
    "pkg_create_exists": lambda workshop: workshop.create("day6_publisher"),
    "build_before_entry_point": lambda workshop: workshop.publisher(entry_point=False),
    "run_without_entry_point": _built_without_entry_point,
    "run_without_entry_point_no_lib": _built_without_entry_point,
    "build_first": _package,
    "run_wrong_executable": _built,
    "build_again": _built,
    "build_select_two_one_unknown": _built,
    "build_symlink_over_normal": _built,
    "build_symlink_fresh": _package,
    "build_tty": _package,
    "setup_py_missing_comma": _edited(SETUP, "version='0.0.0',", "version='0.0.0'"),
    "setup_py_unclosed_bracket": _edited(SETUP, "        ],\n    },\n)", "        ,\n    },\n)"),
    "setup_py_name_error": _edited(SETUP, "name=package_name", "name=pakage_name"),
    "setup_py_bad_entry_no_equals": _edited(SETUP, "talker = day6", "talker day6"),
    "setup_py_empty": _emptied(SETUP),
    "setup_py_missing_data_file": _edited(SETUP, "['package.xml']", "['pakage.xml']"),
    "build_wrong_module_then_run": _wrong_module,
    "source_syntax_error_build_and_run": _edited(
        "src/day6_publisher/day6_publisher/talker.py", "def tick(self):", "def tick(self)"
    ),
    "package_xml_no_name": _edited(MANIFEST, "  <name>day6_publisher</name>\n", ""),
    "package_xml_name_differs": _edited(MANIFEST, "<name>day6_publisher<", "<name>day6_publish<"),
    "package_xml_bad_build_type": _edited(MANIFEST, ">ament_python<", ">ament_pyton<"),
    "package_xml_empty": _emptied(MANIFEST),
    "resource_marker_missing": _removed("src/day6_publisher/resource/day6_publisher"),
    "setup_cfg_missing": _removed("src/day6_publisher/setup.cfg"),
    "duplicate_package": _two_of_one_name,
    "graph": _listener_needs_publisher,
}
"""What the cases before a case had made of the workspace, as far as it matters. A case that is not here began with nothing."""

ROOTS: dict[str, tuple[str, ...]] = {
    "build_first": ("build", "install", "log"),
    "build_symlink_fresh": ("build/day6_publisher", "install/day6_publisher"),
    "pkg_create": ("src/day6_publisher",),
    "pkg_create_node_name": ("src/day6_node",),
    "pkg_create_default_cmake": ("src/day6_cmake",),
}
"""Folders of which the recording lists everything; elsewhere it lists what is to be there."""


# -- what is masked ----------------------------------------------------------------------------------------------------

_MASKS: list[tuple[str, str]] = [
    (r"\[\d+(?:\.\d+)?s\]", "[<SECS>]"),
    (r"\[(?:<SECS>|[\d.]+s), exited", "[<SECS>, exited"),
    (r"build_\d{4}-\d\d-\d\d_\d\d-\d\d-\d\d", "build_<STAMP>"),
    (r"python3\.\d+", "python3.N"),
    (r"py3\.\d+", "py3.N"),
    # The command that asks setup.py what it says: a program of its own in both.
    (r"Command '\[.*\]' returned", "Command '[...]' returned"),
    # setuptools since 69 keeps the underscore of a name in the scripts it makes.
    (r"day6-publisher==", "day6_publisher=="),
    # Quoted where the path has blanks.
    (r"#!.+/bin/python\S*", "#!<PYTHON>"),
    # How far Python marks what is wrong in a line differs from version to version.
    (r"(?m)^ +[~^]*\^[~^]*\n", ""),
]  # fmt: skip

_FRAME = re.compile(r"^  File \"(?P<file>[^\"]+)\", line \d+(?:, in .*)?\n(?:    .*\n)*", re.MULTILINE)


def masked(text: str, workspace: str, home: str) -> str:
    """Replace what depends on the machine. Of a traceback only frames of the student's files stay, without the line of dashes."""
    for real, token in ((workspace, "<WS>"), (home, "<HOME>")):
        text = text.replace(real, token)
    text = _FRAME.sub(_own_frame, text)
    for pattern, token in _MASKS:
        text = re.sub(pattern, token, text)
    return text.replace("\r", "\n")


def _own_frame(match: re.Match[str]) -> str:
    whole = match.group()
    if match["file"] == "<string>" and ", line 1, in <module>\n" in whole:
        return ""  # how setup.py is started
    if match["file"] == "<string>" or match["file"].startswith("<WS>/src"):
        return whole
    return whole if match["file"].startswith("<WS>") else ""


_STATUS = re.compile(r"\[<SECS>\] \[0/\d complete\](?: \[[^\]\n]* - [\d.]+s\])?\n *\n")


def without_status(text: str) -> str:
    """Drop the status line of a terminal: how often it comes depends on how fast a build is."""
    return _STATUS.sub("", text)


def differences(case: Case, workshop: Workshop, stdout: str, stderr: str, status: int) -> str:
    """Return what differs from the recording, '' if nothing does."""
    places = (str(workshop.workspace), str(workshop.home))
    found = [] if status == case.exit_code else [f"exit code {status}, recorded {case.exit_code}"]
    for stream, want, have in (("stdout", case.stdout, stdout), ("stderr", case.stderr, stderr)):
        want, have = masked(want, *places), masked(have, *places)
        if case.name == "build_tty":
            want, have = without_status(want), without_status(have)
        if want != have:
            found.append(_diff(stream, want, have))
    want_tree = [masked(line, *places) for line in case.tree]
    roots = ROOTS.get(case.name, ())
    have_tree = [masked(line, *places) for line in workshop.tree(*roots or ("src", "build", "install", "log"))]
    if roots:
        want_tree = [line for line in want_tree if line.rstrip("/") not in roots]
        if sorted(want_tree) != sorted(line for line in have_tree):
            found.append(_diff("tree", "\n".join(sorted(want_tree)), "\n".join(sorted(have_tree))))
    elif missing := sorted(set(want_tree) - set(have_tree)):
        found.append(f"not there: {missing}")
    for name, text in case.contents.items():
        found += _different_file(name, text, workshop, places)
    return "\n".join(found)


def _different_file(name: str, text: str, workshop: Workshop, places: tuple[str, str]) -> list[str]:
    path = workshop.workspace / re.sub(r"python3\.\d+", f"python3.{sys.version_info.minor}", name)
    if not path.is_file():
        return [f"there is no {name}"]
    if text.startswith("<generated shell script"):
        return []  # written in our own words
    want, have = (masked(each, *places) for each in (text, path.read_text(encoding="utf-8")))
    return [_diff(name, want, have)] if want != have else []


def _diff(what: str, want: str, have: str) -> str:
    import difflib

    lines = difflib.unified_diff(
        want.splitlines(), have.splitlines(), f"recorded {what}", f"our {what}", lineterm="", n=1
    )
    return "\n".join(lines) or f"{what} differs in newlines: {want[-40:]!r} / {have[-40:]!r}"

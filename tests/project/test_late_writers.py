"""What is kept in memory before it is written: `tests/docs/writers.py` names every module that writes, and what may be lost."""

from __future__ import annotations

import ast
from pathlib import Path

import pytest

from day6_core.workspace.events import BuildEvent
from day6_core.workspace.logs import EventLog, LogFolder
from tests.docs.writers import AT_ONCE, LATE, Late
from tests.support.source_files import nodes, trees

WRITERS = {
    *("append_private", "overwrite_file", "replace_file", "replacing", "write_private", "write_table"),
    *("write_bytes", "write_text", "copyfile", "copyfileobj", "copytree", "copy2", "ZipFile"),
    *("FileHandler", "WatchedFileHandler", "O_WRONLY", "O_RDWR", "O_APPEND"),
}
"""Names of what writes into files."""

OPENERS = {"open", "fdopen"}


def writes(tree: ast.Module) -> bool:
    """Whether a module writes into files: it names a writer, or opens with a mode for writing."""
    return any(
        _called(node) == "sqlite3.connect" or (_called(node).rpartition(".")[2] in OPENERS and _writing(node))
        if isinstance(node, ast.Call)
        else isinstance(node, (ast.Name, ast.Attribute))
        and (getattr(node, "id", "") or getattr(node, "attr", "")) in WRITERS
        for node in nodes(tree)
    )


def _called(call: ast.Call) -> str:
    return ast.unparse(call.func)


def _writing(call: ast.Call) -> bool:
    """Whether one of the first two arguments, or `mode`, is a mode for writing."""
    values = [*call.args[:2], *(each.value for each in call.keywords if each.arg == "mode")]
    modes = [str(each.value) for each in values if isinstance(each, ast.Constant)]
    return any(set(mode) <= set("rwaxbt+") and set(mode) & set("wax+") for mode in modes if 0 < len(mode) <= 3)


def test_every_module_that_writes_is_declared_with_how_long_it_waits() -> None:
    found = {path.as_posix() for path, tree in trees(words=(*WRITERS, "open", "sqlite3")) if writes(tree)}
    declared = [
        *(module for late in LATE for module in late.modules),
        *(m for modules in AT_ONCE.values() for m in modules),
    ]
    assert len(declared) == len(set(declared))
    assert sorted(found - set(declared)) == [], "declare them in tests/docs/writers.py: do they wait before they write?"
    assert sorted(set(declared) - found) == [], "these write nothing (any more)"


@pytest.mark.parametrize("late", LATE, ids=lambda late: late.modules[0])
def test_what_is_late_is_so_by_its_own_constant(late: Late) -> None:
    assert all(late.what) and (0 < late.seconds <= 20 if late.constant else all(late.until))


def test_a_build_that_is_killed_leaves_its_events(tmp_path: Path) -> None:
    events = EventLog(LogFolder(tmp_path / "log", "build", pytest.fail))
    events.handle(BuildEvent("queued", "my_package"))
    (file,) = (tmp_path / "log").glob("build_*/events.log")
    assert "(my_package) queued" in file.read_text()


@pytest.mark.parametrize(
    ("code", "expected"),
    [
        *(("open(path, 'w')", True), ("path.open(mode='ab')", True), ("os.open(path, os.O_RDWR)", True)),
        *(("replace_file(path, data)", True), ("logging.FileHandler(path)", True), ("sqlite3.connect(path)", True)),
        *(("open(path)", False), ("open(path, 'rb')", False), ("path.read_text()", False)),
    ],
)
def test_what_counts_as_writing(code: str, expected: bool) -> None:
    assert writes(ast.parse(code)) == expected

"""Why something failed is told in the system's words ("No space left on device"), never as Python's `[Errno 28]`."""

from __future__ import annotations

import ast
import builtins
import errno
import os
import re
from collections.abc import Iterator, Sequence
from pathlib import Path
from typing import Any

import pytest

from day6_core.reason import fault, named_reason, reason
from tests.support.source_files import nodes, sources, trees

OS_ERRORS = {name for name, each in vars(builtins).items() if isinstance(each, type) and issubclass(each, OSError)}
OS_ERRORS.remove("TimeoutError")
"""What the system's errors are caught by; a TimeoutError is one of ours, with a text of its own."""

PRINTS = {"print", "print_error", "complain", "complain_as_shell", "str", "format", "repr"}

AS_IN_PYTHON = (
    "day6_core/ros/python/ament_index_python/",
    "day6_core/ros/python/launch/",
    "day6_core/ros/ros2/launch/",
)
"""What is Python in ROS, too, and says there what Python's error says."""

WHOLE = re.compile(r"\{type\((\w+)\)\.__name__\}: \{\1\}")
"""How a fault is told with its kind, other than by `fault`."""

BY_HAND = re.compile(r"\.strerror\)? (?:or\b|if isinstance\(\w+, OSError\) else None)")
"""How the words of an error are picked, other than by `reason`."""

OF_PARSERS = {
    "day6_core/ros/programs/rqt_topic/model.py",
    "day6_core/ros/programs/tf2_tools/frame_tree.py",
    "day6_core/shell/editing/checks.py",
    "day6_core/workspace/build_interfaces.py",
    "day6_tui/upkeep/trials.py",
}
"""Modules that tell the kind of what a parser or an import says: none of them touches a file there."""


def test_a_missing_file_is_told_on_windows_as_everywhere() -> None:
    error: Any = FileNotFoundError(errno.ENOENT, "Das System kann die angegebene Datei nicht finden", "f")
    error.winerror = 2
    assert reason(error) == "No such file or directory"
    error = PermissionError(errno.EACCES, "used by another process", "f")
    error.winerror = 32
    assert reason(error) == "used by another process"


def told(path: Path, tree: ast.Module) -> Iterator[str]:
    """Yield the lines of a module where an error that may be the system's becomes a text as it is."""
    for node in nodes(tree):
        if isinstance(node, ast.ExceptHandler) and node.name:
            names = {node.name} if node.type is not None and _is_of_the_system(node.type) else set()
        elif isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            names = {each.arg for each in node.args.args if each.annotation and _is_of_the_system(each.annotation)}
        else:
            continue
        for name in names:
            yield from (f"{path.as_posix()}:{line}" for line in _uses(node.body, name))


def _is_of_the_system(kind: ast.expr) -> bool:
    return any(isinstance(each, ast.Name) and each.id in OS_ERRORS for each in ast.walk(kind))


def _uses(body: Sequence[ast.AST], name: str) -> Iterator[int]:
    """Yield the lines where `name` is made a text: by str, print and the like, in an f-string, or as a named part of a text."""
    todo = list(body)
    while todo:
        node = todo.pop()
        if _is_told_apart(node, name):
            continue
        if isinstance(node, ast.IfExp) and f"isinstance({name}, " in ast.unparse(node.test):
            node = node.orelse  # the other branch is about errors of another kind
        if isinstance(node, ast.Call):
            function = ast.unparse(node.func).rpartition(".")[2]
            values = [each.value for each in node.keywords if each.arg != "exc_info"]
            values += node.args if function in PRINTS else []
        else:
            values = [node.value] if isinstance(node, ast.FormattedValue) else []
        if any(isinstance(each, ast.Name) and each.id == name for each in values):
            yield node.lineno
        todo += ast.iter_child_nodes(node)


def _is_told_apart(node: ast.AST, name: str) -> bool:
    """Whether it is `error.strerror or …`, or a branch on whether the error is the system's."""
    if isinstance(node, ast.BoolOp):
        return f"{name}.strerror" in ast.unparse(node.values[0])
    signs = (f"isinstance({name}, OSError", f"{name}.strerror")
    return isinstance(node, (ast.If, ast.IfExp)) and any(sign in ast.unparse(node.test) for sign in signs)


def test_no_error_of_the_system_is_told_as_python_writes_it() -> None:
    found = {place for path, tree in trees(words=("except", "Error")) for place in told(path, tree)}
    assert {place for place in found if not place.startswith(AS_IN_PYTHON)} == set()
    assert all(any(place.startswith(folder) for place in found) for folder in AS_IN_PYTHON)


def test_a_fault_is_told_in_one_way() -> None:
    found = {path.as_posix() for path, text in sources() if WHOLE.search(text)}
    assert {
        path for path in found if not path.startswith(("day6_core/ros/python/", "day6_core/ros/ros2/"))
    } == OF_PARSERS


def test_the_reason_is_worked_out_in_one_place() -> None:
    assert [path.as_posix() for path, text in sources() if BY_HAND.search(text)] == ["day6_core/reason.py"]


@pytest.mark.parametrize(
    "line",
    [
        *("print(error)", "tell(str(error))", 'tell(f"failed: {error}")', "tell(reason=error)"),
        *("complain(session, error)", "raise ValueError(str(error))"),
    ],
)
def test_such_a_line_is_found(line: str) -> None:
    for source in (
        f"try:\n    x\nexcept (ValueError, OSError) as error:\n    {line}",
        f"def f(error: OSError):\n    {line}",
    ):
        assert list(told(Path("x.py"), ast.parse(source)))


@pytest.mark.parametrize(
    "line", ["tell(reason(error))", "tell(error.strerror or error)", '_log.warning("%s", error)', "self.failed(error)"]
)
def test_one_that_tells_the_reason_is_not(line: str) -> None:
    source = f"try:\n    x\nexcept OSError as error:\n    {line}"
    assert not list(told(Path("x.py"), ast.parse(source)))


def test_the_reason_is_the_one_of_real_tools() -> None:
    full = OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), "/a/b.py")
    assert (reason(full), named_reason(full)) == (os.strerror(errno.ENOSPC), f"/a/b.py: {os.strerror(errno.ENOSPC)}")
    assert fault(full) == f"OSError: {named_reason(full)}"
    assert (reason(ValueError("no number")), reason(ValueError())) == ("no number", "ValueError")

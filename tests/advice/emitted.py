"""Reads from the sources every error and warning that our own commands, programs and windows can print.

A text is found where it is given to something that prints, or raised, or returned by a verb of `ros2` as its error; what is
filled in becomes a sample: a reason of the system, a number, a word.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from functools import cache
from typing import NamedTuple

from day6_core.command_line.texts import texts_in
from tests.support.source_files import nodes, trees

PARTS = ("day6_core/ros/ros2", "day6_core/ros/programs", "day6_core/shell", "day6_core/workspace", "day6_urdf")
SINKS = {"print_error", "complain", "complain_as_shell", "err", "error", "warning", "warn", "fatal", "put_status", "refuse",
         "_set_status", "exit"}  # fmt: skip
REASONS = ("strerror", "reason(", "os.strerror")
TROUBLE = re.compile(
    r"\bWARN|\bERROR|[Ww]arning\b|\b[Ee]rror\b|[Ff]ailed|[Cc]annot|[Cc]ould not|[Uu]nknown|not found|[Ww]aiting|rejected|n't "
)
"""What is printed like any output, and tells of trouble all the same."""

BEGINS = re.compile(r"\s*\[?(?:WARN|ERROR|FATAL|Error: |Warning: ).*\w \w")
"""How texts begin that are made in one place and printed in another."""

NUMBERS = ("number", "count", "len(", "line", "status", "seconds", "code", "size", "pid")


KEYED = {"ExportError": "cli.export."}
"""Errors that name a text of the command line by the end of its key."""


class Emitted(NamedTuple):
    """One text: where it is in the sources, how it is printed, and a sample of it."""

    place: str
    how: str
    text: str


@cache
def constants() -> dict[str, str]:
    """Texts that modules keep under a name."""
    found: dict[str, str] = {}
    for part in (*PARTS, "day6_core/session"):
        for _, tree in trees(part):
            for node in tree.body:
                if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name):
                    value = node.value
                    if isinstance(value, ast.Constant) and isinstance(value.value, str) and " " in value.value:
                        found[node.targets[0].id] = value.value
    return found


@cache
def emitted() -> tuple[Emitted, ...]:
    """Return all of them."""
    return tuple(
        Emitted(f"{path.as_posix()}:{line}", how, _as_printed(how, text))
        for part in PARTS
        for path, tree in trees(part)
        for how, text, line in _in_module(tree, part)
    )


def _in_module(tree: ast.Module, part: str) -> Iterator[tuple[str, str, int]]:
    parts = {id(part) for node in nodes(tree) if isinstance(node, ast.JoinedStr) for part in node.values}
    for node in nodes(tree):
        if isinstance(node, ast.Call):
            how = _sink(node)
            # A status of RViz that is no trouble, a line in the log file of the desktop itself.
            if how and not _is_quiet(node):
                third = how in ("put_status", "_set_status", "refuse") or part == "day6_urdf"
                arguments = node.args[2:3] if third else node.args
                texts = [text for argument in arguments if (text := sample(argument)) and any(map(str.isalpha, text))]
                if texts and (how != "print" or TROUBLE.search(max(texts, key=len))):
                    yield how, max(texts, key=len), node.lineno
        elif (
            isinstance(node, ast.Constant | ast.JoinedStr)
            and id(node) not in parts
            and BEGINS.match(text := sample(node))
        ):
            yield "text", text, node.lineno
        elif isinstance(node, ast.Raise) and isinstance(node.exc, ast.Call) and node.exc.args:
            if not _sink(node.exc) and (text := sample(node.exc.args[0])):
                name = ast.unparse(node.exc.func)
                yield f"raise {name}", _of_key(KEYED[name], text) if name in KEYED else text, node.lineno
        elif part == "day6_core/ros/ros2" and isinstance(node, ast.FunctionDef | ast.AsyncFunctionDef):
            kind = ast.unparse(node.returns) if node.returns is not None else ""
            if "int | str" in kind or (node.name in ("main", "_run") and "str" in kind):
                for each in nodes(node):
                    if isinstance(each, ast.Return) and each.value is not None and (text := sample(each.value)):
                        yield "return", text, each.lineno


def _of_key(begin: str, key: str) -> str:
    """The English text with this key, filled in; a text of another `ExportError` as it is."""
    text = texts_in("en").get(begin + key, key)
    return re.sub(r"\{(\w+)\}", lambda field: "7" if field[1] in NUMBERS else "word", text)


def _sink(call: ast.Call) -> str:
    function = call.func
    name = (
        function.attr if isinstance(function, ast.Attribute) else function.id if isinstance(function, ast.Name) else ""
    )
    if name == "write" and "stderr" in ast.unparse(function):
        return "write"
    return name if name in SINKS or name == "print" else ""


def _is_quiet(call: ast.Call) -> bool:
    whole = ast.unparse(call)
    return whole.startswith(("_log.", "logging.")) or "status(OK," in whole or "sys.exit" in whole


def sample(node: ast.expr) -> str:
    """Return a text with what is filled in replaced, '' for what is no text."""
    if isinstance(node, ast.Constant):
        return node.value if isinstance(node.value, str) else ""
    if isinstance(node, ast.Name):
        return constants().get(node.id, "")
    if isinstance(node, ast.JoinedStr):
        return "".join(part.value if isinstance(part, ast.Constant) else _filled(part) for part in node.values)  # type: ignore[misc]
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Add):
        left, right = sample(node.left), sample(node.right)
        return (left or "word") + (right or "word") if left or right else ""
    if isinstance(node, ast.BinOp) and isinstance(node.op, ast.Mod):
        return sample(node.left)
    if isinstance(node, ast.IfExp):
        return sample(node.body)
    if isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in ("format", "join"):
        return sample(node.func.value).replace("{}", "word")
    return ""


def _filled(part: ast.expr) -> str:
    if isinstance(part, ast.FormattedValue) and isinstance(part.value, ast.Name) and part.value.id in constants():
        return constants()[part.value.id]
    source = ast.unparse(part)
    if any(word in source for word in REASONS):
        return "No such file or directory"
    if any(word in source.casefold() for word in NUMBERS):
        return "7"
    return "word"


def _as_printed(how: str, text: str) -> str:
    """What stands before it on the screen."""
    if how == "complain":
        return f"word: {text}"
    if how == "complain_as_shell":
        return f"bash: word: {text}"
    return text

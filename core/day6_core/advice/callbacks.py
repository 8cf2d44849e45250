"""What is wrong with a method of the pupil's: without `self`, called where it should be handed over, with too many arguments.

Python tells of these where the method is called, which is in rclpy, and in words that fit several causes. So the pupil's file is
read, and only what stands in it is told.
"""

from __future__ import annotations

import ast
import copy
import re
from collections.abc import Iterator, Mapping
from pathlib import Path

from day6_core.advice.fault import Fault

LONGEST_FILE = 1024 * 1024

_CALLBACK_AT = {"create_timer": 1, "create_subscription": 2, "create_service": 2}
"""What takes a callback: the place of it among the arguments."""
_COUNTS = re.compile(
    r"(?:(\w+)\.)?(\w+)\(\) (?:takes (\d+) positional arguments? but (\d+) (?:was|were) given|missing \d+ required)"
)

Cause = tuple[str, Mapping[str, object]]
"""The key of a text, and what it fills in."""

_Function = ast.FunctionDef | ast.AsyncFunctionDef


def cause_in_source(fault: Fault, cwd: Path) -> Cause | None:
    """Return what the pupil's file shows to be the cause of an exception, None if that is not certain."""
    tree = parsed(cwd / fault.file) if fault.file else None
    if tree is None:
        return None
    source = _Source(tree)
    if (counts := _COUNTS.match(fault.message)) is not None and fault.kind == "TypeError":
        return source.wrong_count(counts, fault)
    if "rclpy" not in fault.through:
        return None
    if fault.message == "invalid method signature":
        return next(source.handed_without_self(), None)
    if "is not a callable object" in fault.message:
        return next(source.quoted_callbacks(), None)
    if "callback should be either be callable" in fault.message:
        return source.refused_callback(fault.line)
    if "'arg_name'" in fault.message or fault.message == "'NoneType' object is not callable":
        return next(source.called_callbacks(), None)
    return None


def parsed(path: Path) -> ast.Module | None:
    """Read a file of the pupil's; None for one that is not there, is too large, or is no Python."""
    try:
        return ast.parse(path.read_bytes()) if path.stat().st_size <= LONGEST_FILE else None
    except (OSError, ValueError, SyntaxError, RecursionError, MemoryError):
        return None


class _Source:
    """One file of the pupil's, as Python reads it."""

    def __init__(self, tree: ast.Module) -> None:
        self._methods: dict[str, list[_Function]] = {}
        """The methods of the file's classes by name, and its functions by name with a `.` before it."""
        self._handed: list[tuple[ast.Call, str, ast.expr]] = []
        """Calls that take a callback, with the name of what is called and the callback."""
        for node in ast.walk(tree):
            if isinstance(node, ast.ClassDef):
                for each in node.body:
                    if isinstance(each, _Function) and not _is_static(each):
                        self._methods.setdefault(each.name, []).append(each)
            elif isinstance(node, ast.Call) and isinstance(node.func, ast.Attribute) and node.func.attr in _CALLBACK_AT:
                place = _CALLBACK_AT[node.func.attr]
                named = [word.value for word in node.keywords if word.arg == "callback"]
                if found := named or node.args[place : place + 1]:
                    self._handed.append((node, node.func.attr, found[0]))
        self._handed.sort(key=lambda handed: handed[0].lineno)

    def wrong_count(self, counts: re.Match[str], fault: Fault) -> Cause | None:
        """A method that was called with another number of arguments than it takes."""
        name, takes, given = counts[2], counts[3], counts[4]
        method = self._method(name) if counts[1] else None
        if method is None:
            return None
        if takes is not None and int(given) == int(takes) + 1 and not _has_self(method):
            return _lacks_self(method)
        makers = {maker for _, maker, callback in self._handed if _name_of(callback) == name}
        if makers == {"create_timer"} and "rclpy" in fault.through and fault.through[-1] == "rclpy" and takes is None:
            right = _headed(method, keep=1)
            return "timer.arguments", {"line": method.lineno, "name": name, "right": right}
        return None

    def handed_without_self(self) -> Iterator[Cause]:
        """Callbacks whose method takes nothing at all."""
        for _, _, callback in self._handed:
            method = self._method(_name_of(callback))
            if method is not None and not _names(method):
                yield _lacks_self(method)

    def refused_callback(self, line: int) -> Cause | None:
        """What `create_subscription` in a line was given, if it cannot be called with a message."""
        for call, maker, callback in self._handed:
            if maker != "create_subscription" or not call.lineno <= line <= (call.end_lineno or call.lineno):
                continue
            if isinstance(callback, ast.Call):
                return _called(callback)
            method = self._method(_name_of(callback))
            if method is None:
                return None
            if not _has_self(method):
                return _lacks_self(method)
            if len(_names(method)) == 1:
                right = _headed(method, more="msg")
                return "callback.no_message", {"line": method.lineno, "name": method.name, "right": right}
        return None

    def called_callbacks(self) -> Iterator[Cause]:
        """Callbacks that are called at once, in the order in which they stand."""
        yield from (_called(callback) for _, _, callback in self._handed if isinstance(callback, ast.Call))

    def quoted_callbacks(self) -> Iterator[Cause]:
        """Callbacks of which only the name was handed over, as a text."""
        for _, _, callback in self._handed:
            if isinstance(callback, ast.Constant) and isinstance(callback.value, str):
                yield "callback.quoted", {"line": callback.lineno, "right": f"self.{callback.value}"}

    def _method(self, name: str) -> _Function | None:
        """The one method of that name, None if there are several."""
        found = self._methods.get(name, [])
        return found[0] if len(found) == 1 else None


def _called(callback: ast.Call) -> Cause:
    return "callback.called", {"line": callback.lineno, "right": ast.unparse(callback.func)}


def _lacks_self(method: _Function) -> Cause:
    return "self.lacks", {"line": method.lineno, "right": _headed(method, first="self")}


def _name_of(callback: ast.expr) -> str:
    """`tick` of `self.tick`; '' for anything else."""
    plain = isinstance(callback, ast.Attribute) and isinstance(callback.value, ast.Name)
    return callback.attr if plain and isinstance(callback, ast.Attribute) else ""


def _is_static(method: _Function) -> bool:
    return any(
        isinstance(each, ast.Name) and each.id in ("staticmethod", "classmethod") for each in method.decorator_list
    )


def _names(method: _Function) -> list[str]:
    """The arguments of a method that are given by their place."""
    given = [*method.args.posonlyargs, *method.args.args]
    return [each.arg for each in given] + (["*"] if method.args.vararg is not None else [])


def _has_self(method: _Function) -> bool:
    return _names(method)[:1] in (["self"], ["*"])


def _headed(method: _Function, *, first: str = "", more: str = "", keep: int | None = None) -> str:
    """The line `def …:` of a method, with an argument before or behind the others, or with only the first ones kept."""
    changed = copy.deepcopy(method)
    arguments = changed.args
    if keep is not None:
        changed.args = ast.arguments([], arguments.args[:keep], None, [], [], None, [])
    if first:
        (arguments.posonlyargs or arguments.args).insert(0, ast.arg(first))
    if more:
        arguments.args.append(ast.arg(more))
    changed.body, changed.decorator_list = [ast.Pass()], []
    return ast.unparse(ast.fix_missing_locations(changed)).partition("\n")[0]

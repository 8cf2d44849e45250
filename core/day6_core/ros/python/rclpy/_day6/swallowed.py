"""Exceptions that a callback swallows: `except: pass` around its work, at every message.

Python tells of them only who traces it, which is dear. So nothing happens before the inspector asks, and nothing then in a
program whose files have no handler that catches everything and does nothing. In others a few callbacks after each question are
traced, and in these only the functions that have such a handler. Where a debugger traces, nothing is looked at.
"""

from __future__ import annotations

import ast
import os
import sys
import threading
import time
from collections import Counter
from collections.abc import Iterator
from dataclasses import dataclass
from types import FrameType, TracebackType
from typing import TYPE_CHECKING, Any

from rclpy._day6.entity import Entity
from rclpy._day6.executor import Executor
from rclpy._day6.own_lines import is_own, line_of, raised_at, said

if TYPE_CHECKING:
    from rclpy.node import Node

CALLBACKS = 3
"""Callbacks of one entity that are traced after a question."""

FOR_S = 3.0
"""So long after the last question everything is as before it."""

MOST_FILES, LONGEST_FILE = 200, 500_000
"""Files that are read, and characters of one."""

_ANYTHING = frozenset({"Exception", "BaseException"})
_SLIPS = frozenset({"AttributeError", "NameError", "TypeError"})
"""Exceptions that are always slips of the program."""

_NO_ERRORS = (StopIteration, StopAsyncIteration, GeneratorExit, KeyboardInterrupt, SystemExit)


@dataclass
class _Handler:
    """A handler: the lines it guards, what it catches, and whether it does nothing then."""

    first: int
    last: int
    line: int
    catches: frozenset[str]
    """Empty: everything."""
    silent: bool
    count: int = 0
    error: str = ""
    raised: str = ""


@dataclass
class _Function:
    """A function that has a handler which does nothing, with all its handlers."""

    file: str
    name: str
    handlers: list[_Handler]
    calls: int = 0
    entity: Entity | None = None


_read: set[str] = set()
"""The files that were read."""

_functions: dict[tuple[str, int], _Function] = {}
"""By file and first line."""

_traced: Counter[int] = Counter()
_running = threading.local()
_asked = 0.0
_plain = Executor._execute


def swallowed(nodes: list[Node]) -> Iterator[tuple[str, dict[str, Any], dict[str, object]]]:
    """Yield node, place and facts of every handler that swallowed something; begin, or go on, to look."""
    global _asked
    _asked = time.monotonic()
    _traced.clear()
    _read_files()
    if _functions and Executor._execute is _plain:
        Executor._execute = _watched  # type: ignore[method-assign]
    for function in _functions.values():
        for handler in function.handlers:
            if handler.count:
                scope = function.entity._scope if function.entity is not None else None
                node = next((str(each.handle.node.full_name) for each in nodes if each.handle.scope is scope), "")
                values: dict[str, object] = {
                    "what": function.name,
                    "error": handler.error,
                    "raised": handler.raised,
                    "count": handler.count,
                    "calls": function.calls,
                }
                yield node, line_of(function.file, handler.line), values


# -- which functions -------------------------------------------------------------------------------------------------------


def _read_files() -> None:
    for module in list(sys.modules.values()):
        file = getattr(module, "__file__", None)
        if len(_read) >= MOST_FILES:
            return
        if isinstance(file, str) and file.endswith(".py") and file not in _read and is_own(file):
            _read.add(file)
            _functions.update({(file, line): function for line, function in _silent_in(file).items()})


def _silent_in(file: str) -> dict[int, _Function]:
    try:
        with open(file, encoding="utf-8") as opened:
            text = opened.read(LONGEST_FILE + 1)
        tree = ast.parse(text) if "except" in text and len(text) <= LONGEST_FILE else None
    except (OSError, ValueError, SyntaxError, RecursionError):
        return {}
    found = {}
    for node in ast.walk(tree) if tree is not None else ():
        if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef)):
            handlers = [handler for each in _own_nodes(node) for handler in _handlers(each)]
            if any(handler.silent for handler in handlers):
                first = min([node.lineno, *(each.lineno for each in node.decorator_list)])
                found[first] = _Function(file, node.name, handlers)
    return found


def _own_nodes(function: ast.AST) -> Iterator[ast.AST]:
    """What belongs to a function, without functions and classes inside it."""
    for each in ast.iter_child_nodes(function):
        if not isinstance(each, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            yield each
            yield from _own_nodes(each)


def _handlers(node: ast.AST) -> Iterator[_Handler]:
    if not isinstance(node, ast.Try):
        return
    last = max(each.end_lineno or each.lineno for each in node.body)
    for handler in node.handlers:
        kinds = handler.type.elts if isinstance(handler.type, ast.Tuple) else [handler.type] if handler.type else []
        catches = frozenset(ast.unparse(each).rpartition(".")[2] for each in kinds)
        if catches & _ANYTHING:
            catches = frozenset()
        silent = (not catches or bool(catches & _SLIPS)) and all(map(_does_nothing, handler.body))
        yield _Handler(node.body[0].lineno, last, handler.lineno, catches, silent)


def _does_nothing(statement: ast.stmt) -> bool:
    if isinstance(statement, ast.Return):
        return statement.value is None or isinstance(statement.value, ast.Constant)
    if isinstance(statement, ast.Expr):
        return isinstance(statement.value, ast.Constant)
    return isinstance(statement, (ast.Pass, ast.Continue))


# -- tracing ---------------------------------------------------------------------------------------------------------------


def _watched(self: Executor, entity: Entity) -> bool:
    """Take the place of `Executor._execute` while somebody asks."""
    if _traced[id(entity)] >= CALLBACKS or sys.gettrace() is not None:
        if time.monotonic() - _asked > FOR_S:
            Executor._execute = _plain  # type: ignore[method-assign]
        return _plain(self, entity)
    _traced[id(entity)] += 1
    _running.entity = entity
    sys.settrace(_on_call)
    try:
        return _plain(self, entity)
    finally:
        sys.settrace(None)


def _on_call(frame: FrameType, event: str, argument: object) -> Any:
    function = _functions.get((frame.f_code.co_filename, frame.f_code.co_firstlineno))
    if function is None:
        return None
    function.calls += 1
    function.entity = _running.entity
    frame.f_trace_lines = False

    def inside(frame: FrameType, event: str, argument: Any) -> Any:
        if event == "exception" and not isinstance(argument[1], _NO_ERRORS):
            _note(function, frame.f_lineno, *argument[1:])
        return inside

    return inside


def _note(function: _Function, line: int, error: BaseException, trace: TracebackType | None) -> None:
    names = {each.__name__ for each in type(error).__mro__}
    guarding = [each for each in function.handlers if each.first <= line <= each.last]
    # The innermost one guards the fewest lines; of one `try` the first that catches it.
    for handler in sorted(guarding, key=lambda each: each.last - each.first):
        if not handler.catches or handler.catches & names:
            if handler.silent:
                handler.count += 1
                handler.error = said(error)
                place = raised_at(trace)
                handler.raised = f"{os.path.basename(place['file'])}:{place['line']}"
            return

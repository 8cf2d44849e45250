"""The expressions of `--filter`: Python's syntax and meaning, restricted to reading a message, without side effects.

The real tool gives the text to `eval`. Here the syntax tree is walked, and only the node types below exist: values,
comparisons, arithmetic, indexing, public attributes, comprehensions, and calls of harmless functions and methods.
"""

from __future__ import annotations

import ast
import math
import operator
from array import array
from collections.abc import Callable, Iterator
from functools import lru_cache
from itertools import count
from typing import Any

_HARMLESS = (
    *(abs, all, any, bool, bytes, chr, divmod, enumerate, float, hex, int, isinstance, len, list, max, min, ord, range),
    *(repr, reversed, round, set, sorted, str, sum, tuple, zip),
)
FUNCTIONS: dict[str, Callable[..., Any]] = {function.__name__: function for function in _HARMLESS}
_NAMES: dict[str, Any] = {**FUNCTIONS, "True": True, "False": False, "None": None, "math": math}

_GROWING = frozenset(
    [
        "center",
        "encode",
        "expandtabs",
        "format",
        "format_map",
        "join",
        "ljust",
        "maketrans",
        "rjust",
        "translate",
        "zfill",
    ]
)
"""Methods of str that make large values from small ones, or read attributes."""

_METHODS: dict[type, frozenset[str]] = {
    str: frozenset(name for name in dir(str) if not name.startswith("_")) - _GROWING,
    bytes: frozenset(("count", "decode", "endswith", "find", "hex", "index", "startswith")),
    list: frozenset(("count", "index")),
    tuple: frozenset(("count", "index")),
    array: frozenset(("count", "index", "tolist")),
}
_NUMPY_METHODS = frozenset(["all", "any", "max", "mean", "min", "std", "sum", "tolist"])
_BINARY: dict[type, Callable[[Any, Any], Any]] = {
    ast.Add: operator.add,
    ast.Sub: operator.sub,
    ast.Mult: operator.mul,
    ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv,
    ast.Mod: operator.mod,
    ast.Pow: operator.pow,
    ast.BitAnd: operator.and_,
    ast.BitOr: operator.or_,
    ast.BitXor: operator.xor,
    ast.LShift: operator.lshift,
    ast.RShift: operator.rshift,
}
_UNARY: dict[type, Callable[[Any], Any]] = {
    ast.UAdd: operator.pos,
    ast.USub: operator.neg,
    ast.Not: operator.not_,
    ast.Invert: operator.invert,
}
_COMPARE: dict[type, Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq,
    ast.NotEq: operator.ne,
    ast.Lt: operator.lt,
    ast.LtE: operator.le,
    ast.Gt: operator.gt,
    ast.GtE: operator.ge,
    ast.Is: operator.is_,
    ast.IsNot: operator.is_not,
    ast.In: lambda item, container: item in container,
    ast.NotIn: lambda item, container: item not in container,
}

LONGEST = 1_000_000
"""The most bits of a number or items of a sequence: a filter runs in the desktop and must not use up its memory."""

STEPS = 200_000
"""The most parts of an expression that are evaluated for one message (half a second): nor use up its time."""


class FilterError(RuntimeError):
    """The expression uses something that filters don't allow."""


def evaluate(expression: str, message: Any) -> Any:
    """Return the value of the expression with `m` as the message. Raises FilterError, SyntaxError, any error of Python."""
    return _Evaluation({**_NAMES, "m": message}).of(_parsed(expression))


@lru_cache(maxsize=8)
def _parsed(expression: str) -> ast.expr:
    return ast.parse(expression.strip(), "<string>", "eval").body


class _Evaluation:
    def __init__(self, names: dict[str, Any], steps: Iterator[int] | None = None) -> None:
        self.names = names
        self.steps: Iterator[int] = count() if steps is None else steps

    def of(self, node: ast.AST) -> Any:
        if next(self.steps) > STEPS:
            raise FilterError("a filter cannot take so long")
        handler = getattr(self, f"_{type(node).__name__.lower()}", None)
        if handler is None:
            raise FilterError(f"a filter cannot use {type(node).__name__}")
        return handler(node)

    def _constant(self, node: ast.Constant) -> Any:
        return node.value

    def _name(self, node: ast.Name) -> Any:
        if node.id not in self.names:
            raise NameError(f"name {node.id!r} is not defined")
        return self.names[node.id]

    def _attribute(self, node: ast.Attribute) -> Any:
        value = self.of(node.value)
        if node.attr.startswith("_"):
            raise FilterError(f"a filter cannot use .{node.attr}")
        found = getattr(value, node.attr)
        if callable(found) and not self._may_call(value, node.attr):
            raise FilterError(f"a filter cannot use .{node.attr}")
        return found

    @staticmethod
    def _may_call(owner: Any, name: str) -> bool:
        if type(owner).__module__ == "numpy":
            return name in _NUMPY_METHODS
        return owner is math or name in _METHODS.get(type(owner), ())

    def _call(self, node: ast.Call) -> Any:
        function = self.of(node.func)
        args: list[Any] = []
        for arg in node.args:
            args.extend(self.of(arg.value)) if isinstance(arg, ast.Starred) else args.append(self.of(arg))
        keywords = {each.arg: self.of(each.value) for each in node.keywords if each.arg is not None}
        if not any(function is each for each in FUNCTIONS.values()) and not isinstance(node.func, ast.Attribute):
            raise FilterError("a filter cannot call this")
        if function is range and len(range(*args)) > LONGEST:
            raise FilterError("a filter cannot count so far")
        if function is bytes and args and isinstance(args[0], int):
            _check_size(args[0])
        return function(*args, **keywords)

    def _subscript(self, node: ast.Subscript) -> Any:
        return self.of(node.value)[self.of(node.slice)]

    def _slice(self, node: ast.Slice) -> slice:
        return slice(*(None if part is None else self.of(part) for part in (node.lower, node.upper, node.step)))

    def _binop(self, node: ast.BinOp) -> Any:
        left, right = self.of(node.left), self.of(node.right)
        _check_growth(node.op, left, right)
        return _BINARY[type(node.op)](left, right)

    def _unaryop(self, node: ast.UnaryOp) -> Any:
        return _UNARY[type(node.op)](self.of(node.operand))

    def _boolop(self, node: ast.BoolOp) -> Any:
        stop = isinstance(node.op, ast.Or)
        value: Any = None
        for part in node.values:
            value = self.of(part)
            if bool(value) is stop:
                break
        return value

    def _compare(self, node: ast.Compare) -> Any:
        left, value = self.of(node.left), True
        for op, part in zip(node.ops, node.comparators, strict=True):
            right = self.of(part)
            value = _COMPARE[type(op)](left, right)
            if not value:
                break
            left = right
        return value

    def _ifexp(self, node: ast.IfExp) -> Any:
        return self.of(node.body if self.of(node.test) else node.orelse)

    def _tuple(self, node: ast.Tuple) -> Any:
        return tuple(map(self.of, node.elts))

    def _list(self, node: ast.List) -> Any:
        return list(map(self.of, node.elts))

    def _set(self, node: ast.Set) -> Any:
        return set(map(self.of, node.elts))

    def _generatorexp(self, node: ast.GeneratorExp) -> Iterator[Any]:
        return self._produced(node.elt, node.generators)

    def _listcomp(self, node: ast.ListComp) -> list[Any]:
        return list(self._produced(node.elt, node.generators))

    def _setcomp(self, node: ast.SetComp) -> set[Any]:
        return set(self._produced(node.elt, node.generators))

    def _produced(self, element: ast.expr, generators: list[ast.comprehension]) -> Iterator[Any]:
        if not generators:
            yield self.of(element)
            return
        first, *rest = generators
        for item in self.of(first.iter):
            inner = _Evaluation({**self.names, **_bound(first.target, item)}, self.steps)
            if all(inner.of(test) for test in first.ifs):
                yield from inner._produced(element, rest)


def _bound(target: ast.expr, value: Any) -> dict[str, Any]:
    if isinstance(target, ast.Name):
        return {target.id: value}
    if isinstance(target, (ast.Tuple, ast.List)):
        return {
            name: part
            for each, item in zip(target.elts, value, strict=True)
            for name, part in _bound(each, item).items()
        }
    raise FilterError("a filter cannot assign to this")


def _check_growth(op: ast.operator, left: Any, right: Any) -> None:
    """Refuse an operation that makes a huge value from a short expression. Raises FilterError."""
    if isinstance(op, ast.Pow) and isinstance(left, int) and isinstance(right, int):
        _check_size(left.bit_length() * abs(right))
    elif isinstance(op, ast.LShift) and isinstance(left, int) and isinstance(right, int):
        _check_size(left.bit_length() + right)
    elif isinstance(op, ast.Mult):
        for sequence, times in ((left, right), (right, left)):
            if isinstance(sequence, (str, bytes, list, tuple)) and isinstance(times, int):
                _check_size(len(sequence) * times)
    elif isinstance(op, ast.Mod) and isinstance(left, (str, bytes)):
        raise FilterError("a filter cannot format text")


def _check_size(size: int) -> None:
    if size > LONGEST:
        raise FilterError("a filter cannot make a value so large")

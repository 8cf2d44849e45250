"""The expressions that rqt's plugins accept for a field: a part of Python, computed without ever running it.

The real plugins hand the text to Python's `eval`, with all names of the modules math, random and time. Here only what computes
a value is understood, and none of it can use up memory or time.
"""

from __future__ import annotations

import ast
import math
import operator
import random
import re
import time
from collections.abc import Callable, Mapping
from functools import lru_cache
from typing import Any

from day6_core.interfaces import get_message

LONGEST = 20_000
"""Characters of an expression."""

MOST_NODES = 10_000
"""Parts of an expression."""

MOST_VALUES = 2_000_000
"""Values and characters that are made on the way to a result, all together: an image of 640 x 480 in colour is a million."""

MOST_BITS = 4096
"""Of a whole number."""


class ExpressionError(ValueError):
    """Not an expression, or one that cannot be computed; the text says why, in Python's words where it has any."""


_BINARY: dict[type[ast.operator], Callable[[Any, Any], Any]] = {
    ast.Add: operator.add, ast.Sub: operator.sub, ast.Mult: operator.mul, ast.Div: operator.truediv,
    ast.FloorDiv: operator.floordiv, ast.Mod: operator.mod, ast.Pow: operator.pow, ast.LShift: operator.lshift,
    ast.RShift: operator.rshift, ast.BitAnd: operator.and_, ast.BitOr: operator.or_, ast.BitXor: operator.xor,
}  # fmt: skip

_UNARY: dict[type[ast.unaryop], Callable[[Any], Any]] = {
    ast.UAdd: operator.pos, ast.USub: operator.neg, ast.Not: operator.not_, ast.Invert: operator.invert,
}  # fmt: skip

_COMPARISONS: dict[type[ast.cmpop], Callable[[Any, Any], Any]] = {
    ast.Eq: operator.eq, ast.NotEq: operator.ne, ast.Lt: operator.lt, ast.LtE: operator.le, ast.Gt: operator.gt,
    ast.GtE: operator.ge, ast.In: lambda a, b: a in b, ast.NotIn: lambda a, b: a not in b,
}  # fmt: skip


def _round(value: float, digits: int = 0) -> float:
    """`round`, which takes for ever to a thousand million digits."""
    return round(value, max(-MOST_BITS, min(digits, MOST_BITS))) if digits else round(value)


def _names() -> dict[str, Any]:
    left_out = {"factorial", "comb", "perm", "prod"}  # a short call makes a number of millions of digits
    names = {name: value for name, value in vars(math).items() if not name.startswith("_") and name not in left_out}
    chance = (
        "random uniform triangular randint randrange choice gauss normalvariate expovariate betavariate vonmisesvariate"
    )
    names |= {name: getattr(random, name) for name in chance.split()}
    names |= {name: getattr(time, name) for name in ("time", "time_ns", "monotonic", "monotonic_ns")}
    names |= {each.__name__: each for each in (abs, bool, float, int, len, max, min, str, list, tuple, chr, ord)}
    # Of lists, `sum` would make as many ever longer ones.
    return names | {"round": _round, "sum": lambda values: sum(values)}


NAMES: Mapping[str, Any] = _names()
"""The functions and numbers that an expression may use: Python's own, and those of math, random and time."""


def evaluate(text: str, names: Mapping[str, Any] = NAMES) -> Any:
    """Return the value of an expression. Raises ExpressionError."""
    if len(text) > LONGEST:
        raise ExpressionError(f"{len(text)} characters: at most {LONGEST} are read")
    try:
        value = _Reader(names).value(_parsed(text.strip()))
        if callable(value):
            raise ExpressionError(f"'{text.strip()}' is a function")
        return value
    except ExpressionError:
        raise
    except SyntaxError as error:
        raise ExpressionError(f"invalid syntax: {error.msg}") from None
    except (ArithmeticError, AssertionError, AttributeError, LookupError, TypeError, ValueError) as error:
        raise ExpressionError(str(error) or type(error).__name__) from None
    except (RecursionError, MemoryError):
        raise ExpressionError("expression is nested too deeply") from None


@lru_cache(64)
def _parsed(text: str) -> ast.expr:
    """The parts of an expression, which may be that of a message a hundred times a second."""
    tree = ast.parse(text, mode="eval")
    if sum(1 for _ in ast.walk(tree)) > MOST_NODES:
        raise ExpressionError("expression is too large")
    return tree.body


class _Reader:
    """Computes one expression, and counts what it makes."""

    def __init__(self, names: Mapping[str, Any]) -> None:
        self._names = names
        self._left = MOST_VALUES

    def value(self, node: ast.expr) -> Any:
        method = getattr(self, f"_{type(node).__name__.lower()}", None)
        if method is None:
            raise ExpressionError(f"{type(node).__name__} is not understood here")
        return method(node)

    def _spend(self, count: int) -> None:
        self._left -= count
        if self._left < 0:
            raise ExpressionError(f"more than {MOST_VALUES} values")

    def _kept(self, made: Any) -> Any:
        """What an operation made, if it is not too large."""
        if isinstance(made, int) and made.bit_length() > MOST_BITS:
            raise ExpressionError("number is too large")
        self._spend(_weight(made, self._left))
        return made

    def _constant(self, node: ast.Constant) -> Any:
        return self._kept(node.value)

    def _name(self, node: ast.Name) -> Any:
        try:
            return self._names[node.id]
        except KeyError:
            raise ExpressionError(f"name '{node.id}' is not defined") from None

    def _list(self, node: ast.List) -> list[Any]:
        return self._kept([self.value(each) for each in node.elts])  # type: ignore[no-any-return]

    def _tuple(self, node: ast.Tuple) -> tuple[Any, ...]:
        return self._kept(tuple(self.value(each) for each in node.elts))  # type: ignore[no-any-return]

    def _unaryop(self, node: ast.UnaryOp) -> Any:
        return self._kept(_UNARY[type(node.op)](self.value(node.operand)))

    def _binop(self, node: ast.BinOp) -> Any:
        kind, left, right = type(node.op), self.value(node.left), self.value(node.right)
        if kind not in _BINARY:
            raise ExpressionError("operator is not understood here")
        if kind is ast.Mod and isinstance(left, (str, bytes)):
            _check_format(left)
        elif kind is ast.Mult:
            for many, times in ((left, right), (right, left)):
                if isinstance(many, (str, bytes, list, tuple)) and isinstance(times, int):
                    self._spend(_weight(many, self._left) * max(0, times))
                    return many * times
        elif kind in (ast.Pow, ast.LShift) and isinstance(left, int) and isinstance(right, int):
            bits = left.bit_length() * right if kind is ast.Pow else left.bit_length() + right
            if bits > MOST_BITS:
                raise ExpressionError("number is too large")
        return self._kept(_BINARY[kind](left, right))

    def _boolop(self, node: ast.BoolOp) -> Any:
        stops = isinstance(node.op, ast.Or)
        for each in node.values:
            found = self.value(each)
            if bool(found) is stops:
                break
        return found

    def _compare(self, node: ast.Compare) -> bool:
        left = self.value(node.left)
        for kind, each in zip(node.ops, node.comparators, strict=True):
            if type(kind) not in _COMPARISONS:
                raise ExpressionError("comparison is not understood here")
            right = self.value(each)
            if not _COMPARISONS[type(kind)](left, right):
                return False
            left = right
        return True

    def _ifexp(self, node: ast.IfExp) -> Any:
        return self.value(node.body if self.value(node.test) else node.orelse)

    def _subscript(self, node: ast.Subscript) -> Any:
        of = self.value(node.value)
        if not isinstance(of, (str, bytes, list, tuple)):
            raise ExpressionError(f"'{type(of).__name__}' object is not subscriptable")
        if isinstance(node.slice, ast.Slice):
            parts = (node.slice.lower, node.slice.upper, node.slice.step)
            return self._kept(of[slice(*(None if each is None else self.value(each) for each in parts))])
        return of[self.value(node.slice)]

    def _joinedstr(self, node: ast.JoinedStr) -> str:
        return self._kept("".join(map(self.value, node.values)))  # type: ignore[no-any-return]

    def _formattedvalue(self, node: ast.FormattedValue) -> str:
        form = self.value(node.format_spec) if node.format_spec is not None else ""
        _check_format(form)
        value = self.value(node.value)
        if node.conversion >= 0:
            value = (
                f"{value!r}"
                if node.conversion == ord("r")
                else f"{value!a}"
                if node.conversion == ord("a")
                else str(value)
            )
        return self._kept(format(value, form))  # type: ignore[no-any-return]

    def _call(self, node: ast.Call) -> Any:
        function = self._message_class(node.func) if isinstance(node.func, ast.Attribute) else self.value(node.func)
        arguments = [self.value(each) for each in node.args]
        named = {each.arg: self.value(each.value) for each in node.keywords if each.arg is not None}
        if len(named) < len(node.keywords) or not callable(function):
            raise ExpressionError("call is not understood here")
        return self._kept(function(*arguments, **named))

    def _message_class(self, node: ast.Attribute) -> Any:
        """`geometry_msgs.msg.Point`, as in the real plugin, which imports its package."""
        names = ast.unparse(node).split(".")
        if len(names) != 3 or names[1] != "msg":
            raise ExpressionError(f"'{ast.unparse(node)}' is not the type of a message, like geometry_msgs.msg.Point")
        return get_message("/".join(names))


def _weight(value: Any, most: int) -> int:
    """How many values and characters something consists of; any number above `most` where there are more."""
    if not isinstance(value, (str, bytes, list, tuple)):
        return 1
    total = len(value) + 1
    if isinstance(value, (list, tuple)) and total <= most:
        for each in value:
            if isinstance(each, (str, bytes, list, tuple)):
                total += _weight(each, most - total)
                if total > most:
                    break
    return total


def _check_format(text: str | bytes) -> None:
    """Raise if a format could ask for a text of any length."""
    if re.search(r"\d{4}|\*", text if isinstance(text, str) else text.decode("latin-1")):
        raise ExpressionError("format is too wide")

"""A message as a tree of its fields, each with the expression that gives its value: rqt's request and message trees.

A field is named by its path below the message, as rqt_py_common's trees name it: `/pose/position/x`, `/points[2]/x`.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping
from itertools import islice
from typing import Any, NamedTuple

from day6_tui.core.interfaces import get_message
from day6_tui.core.interfaces.definition import InvalidSpecification
from day6_tui.core.interfaces.fields import PRIMITIVES
from day6_tui.core.ros.programs.rqt_topic.fields import element_type

MOST_ROWS = 1000
"""Fields of a message that are listed; the last line then stands for the rest."""

MOST_ELEMENTS = 500
"""Elements of an array that are written out."""

MOST_CHARACTERS = 4000
"""Of a string that are written out."""

REST = "..."
"""In place of what is not listed or written out."""

INTERFACE_ERRORS = (InvalidSpecification, LookupError, NameError, OSError, TypeError, ValueError)
"""What asking for the class of an interface may raise, which may be anybody's."""

REFUSAL = "Failed to set {name} to {value}\n\t{error}"
"""The words of rqt_service_caller's warning."""

_PYTHON = {each.idl: each.python for each in PRIMITIVES.values()}
_STEPS = re.compile(r"([^/\[\]]+)|\[(\d+)\]")


class FieldRow(NamedTuple):
    """One line of the tree. `text` is the expression of the field, by default its value as Python writes it."""

    path: str
    name: str
    type: str
    depth: int
    text: str
    is_branch: bool = False
    """Whether it has fields below it; its expression is then empty by default."""
    problem: str = ""
    """Why the expression is not taken."""


class FieldKind(NamedTuple):
    """What a field can hold: `python` is the type of its value, of its elements if it is an array."""

    name: str
    python: type[Any]
    is_array: bool


class Rejected(ValueError):
    """An expression that gives no value for its field; the text is the real plugin's."""


Convert = Callable[[str, FieldKind, Mapping[str, Any]], Any]
"""Makes a field's value of an expression and the names that it may use. Raises Rejected."""


def field_rows(message: Any, depth: int = 0) -> list[FieldRow]:
    """The fields of a message and of the messages in it, each after the one that it belongs to."""
    rows = list(islice(_rows(message, "", depth), MOST_ROWS + 1))
    if len(rows) > MOST_ROWS:
        rows[MOST_ROWS:] = [FieldRow("", REST, "", depth, "")]
    return rows


def _rows(value: Any, path: str, depth: int) -> Iterator[FieldRow]:
    for name, kind in value.get_fields_and_field_types().items():
        yield from _field(getattr(value, name), f"{path}/{name}", name, kind, depth)


def _field(value: Any, path: str, name: str, kind: str, depth: int) -> Iterator[FieldRow]:
    if _is_message(value):
        yield FieldRow(path, name, kind, depth, "", is_branch=True)
        yield from _rows(value, path, depth + 1)
    elif isinstance(value, list) and value and _is_message(value[0]):
        yield FieldRow(path, name, kind, depth, "", is_branch=True)
        for index, each in enumerate(value):
            yield from _field(each, f"{path}[{index}]", f"[{index}]", element_type(kind), depth + 1)
    else:
        yield FieldRow(path, name, kind, depth, value_text(value))


def _is_message(value: Any) -> bool:
    return hasattr(value, "get_fields_and_field_types")


def value_text(value: Any) -> str:
    """A value as Python writes it, arrays of every kind as lists; what is very long ends with `...`."""
    if isinstance(value, (str, bytes)):
        return repr(value) if len(value) <= MOST_CHARACTERS else repr(value[:MOST_CHARACTERS]) + REST
    if not hasattr(value, "__len__"):
        return repr(value)
    values = value[:MOST_ELEMENTS]
    texts = [value_text(each) for each in (values.tolist() if hasattr(values, "tolist") else values)]
    return f"[{', '.join(texts + [REST] * (len(value) > MOST_ELEMENTS))}]"


class MessageForm:
    """A message being filled in: `expressions` by path, and what is wrong with them."""

    def __init__(self, message_class: Callable[[], Any], convert: Convert, refusal: str = REFUSAL) -> None:
        """`refusal`: what is said of a value that its field does not take."""
        self._message_class = message_class
        self._convert, self._refusal = convert, refusal
        self._default = message_class()
        self.expressions: dict[str, str] = {}
        self.problems: dict[str, str] = {}
        """By path, as of the last `message`."""

    def rows(self, depth: int = 0) -> list[FieldRow]:
        """The lines of the tree, with what was typed in place of the defaults."""
        return [
            row._replace(text=self.expressions.get(row.path, row.text), problem=self.problems.get(row.path, ""))
            for row in field_rows(self._default, depth)
        ]

    def set(self, path: str, text: str) -> None:
        """Give a field an expression; an empty one gives it back its default. Raises LookupError for no such field."""
        self._slot(self._default, path)
        if text.strip():
            self.expressions[path] = text
        else:
            self.expressions.pop(path, None)

    def message(self, names: Mapping[str, Any]) -> Any:
        """Return a new message; a field whose expression is wrong keeps its default, and has a problem afterwards."""
        message, self.problems = self._message_class(), {}
        for path, text in self.expressions.items():
            if any(path.startswith((f"{other}/", f"{other}[")) for other in self.expressions):
                continue  # what it belongs to has an expression of its own
            owner, name, kind = self._slot(message, path)
            try:
                value = self._convert(text, kind, names)
                if isinstance(name, int):
                    owner[name] = value
                else:
                    self._put(owner, name, value)
            except Rejected as error:
                self.problems[path] = str(error)
        return message

    def _put(self, message: Any, name: str, value: Any) -> None:
        try:
            setattr(message, name, value)
        except (AssertionError, OverflowError, TypeError, ValueError) as error:
            raise Rejected(self._refusal.format(name=name, value=value_text(value), error=error)) from None

    def _slot(self, message: Any, path: str) -> tuple[Any, str | int, FieldKind]:
        """The message or list that a field is in, the field's name or index there, and its kind."""
        steps: list[str | int] = [name or int(index) for name, index in _STEPS.findall(path)]
        kind = ""
        for at, step in enumerate(steps):
            kind = element_type(kind) if isinstance(step, int) else message.get_fields_and_field_types()[step]
            if at == len(steps) - 1:
                return message, step, kind_of(kind)
            message = message[step] if isinstance(step, int) else getattr(message, step)
        raise LookupError(path)


def kind_of(type_name: str) -> FieldKind:
    """What a field of this type can hold; the type is written as rosidl's classes write it, `sequence<double, 3>`."""
    base = element_type(type_name) or type_name
    if "/" in base:
        package, _, name = base.rpartition("/")
        python: type[Any] = get_message(f"{package.partition('/')[0]}/msg/{name}")
    else:
        python = _PYTHON.get(base, str)
    return FieldKind(type_name, python, base != type_name)


def octet(value: Any) -> bytes:
    """A value as one byte. Raises TypeError or ValueError."""
    return value if isinstance(value, bytes) else bytes([value])


def elements(values: Iterable[Any], python: type[Any], make: Callable[[Any], Any]) -> list[Any]:
    """The elements of an array, each made into what the array holds; quick where they, a million perhaps, are that already."""
    found = list(values)
    return found if set(map(type, found)) <= {python} else [make(each) for each in found]

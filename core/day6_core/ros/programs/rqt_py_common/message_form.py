"""A message as a tree of its fields, each with the expression that gives its value: rqt's request and message trees.

A field is named by its path below the message, as rqt_py_common's trees name it: `/pose/position/x`, `/points[2]/x`. Arrays are
branches whose elements have lines and expressions of their own, as in rqt_publisher; here the array's own line, too.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator, Mapping, Sequence
from copy import deepcopy
from itertools import islice
from typing import Any, NamedTuple

from day6_core.interfaces import get_message, type_name
from day6_core.interfaces.definition import InvalidSpecification
from day6_core.interfaces.fields import PRIMITIVES
from day6_core.ros.programs.rqt_topic.fields import element_type

MOST_ROWS = 1000
"""Fields of a message that are listed; the last line then stands for the rest."""

MOST_ELEMENTS = 500
"""Elements of an array that are written out."""

MOST_LINES = 100
"""Elements that an array may have to be a branch; of messages more are listed."""

MOST_CHARACTERS = 4000
"""Of a string that are written out."""

SEQUENCE = "sequence<"
"""With this begins the type of an array that can grow."""

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
    """Whether it has lines below it; a message's expression is then empty by default."""
    problem: str = ""
    """Why the expression is not taken."""
    in_force: str = ""
    """The expression that counts in place of the refused one in `text`."""
    elements: int = 0
    """How many lines below it are elements of an array that are no messages."""


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
    elif element_type(kind) and 0 < len(value) <= MOST_LINES:
        yield FieldRow(path, name, kind, depth, value_text(value), is_branch=True, elements=len(value))
        for index, each in enumerate(value.tolist() if hasattr(value, "tolist") else value):
            yield FieldRow(f"{path}[{index}]", f"[{index}]", element_type(kind), depth + 1, value_text(each))
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
        self._shown = message_class()
        """The newest message: it says which elements there are."""
        self.expressions: dict[str, str] = {}
        self.problems: dict[str, str] = {}
        """By path, as of the last `message`."""
        self._refused: dict[str, tuple[str, str]] = {}
        """What `set_if_good` did not take, and why."""

    def rows(self, depth: int = 0) -> list[FieldRow]:
        """The lines of the tree, with what was typed in place of the defaults."""
        return [self._filled(row) for row in field_rows(self._shown, depth)]

    def _filled(self, row: FieldRow) -> FieldRow:
        text, problem = self._refused.get(row.path, ("", ""))
        known = self.expressions.get(row.path)
        if row.elements and known is None and any(path.startswith(f"{row.path}[") for path in tuple(self.expressions)):
            known = ""
        shown = row.text if known is None else known
        if text:
            return row._replace(text=text, problem=problem, in_force=shown)
        return row._replace(text=shown, problem=self.problems.get(row.path, ""))

    def set(self, path: str, text: str) -> None:
        """Give a field an expression; an empty one gives it back its default. Raises LookupError for no such field.

        An expression for a whole array takes the place of those of its elements.
        """
        self._slot(self._shown, path)
        self._refused.pop(path, None)
        for below in [each for each in self.expressions if each.startswith(f"{path}[")]:
            del self.expressions[below]
        if text.strip():
            self.expressions[path] = text
        else:
            self.expressions.pop(path, None)

    def set_if_good(self, path: str, text: str, names: Mapping[str, Any]) -> None:
        """`set`, unless the expression is wrong now: then the one before counts, as in rqt_publisher."""
        before = dict(self.expressions)
        self.set(path, text)
        self.message(names)
        if path in self.problems:
            self._refused[path] = text, self.problems[path]
            self.expressions = before
            self.message(names)

    def message(self, names: Mapping[str, Any]) -> Any:
        """Return a new message; a field whose expression is wrong keeps its default, and has a problem afterwards."""
        message, self.problems = self._message_class(), {}
        for path, text in sorted(self.expressions.items(), key=lambda item: item[0].count("[")):
            if any(path.startswith(f"{other}/") for other in self.expressions):
                continue  # what it belongs to has an expression of its own
            try:
                owner, name, kind = self._slot(message, path)
            except LookupError:
                continue  # the array is shorter now
            try:
                self._put(owner, name, self._convert(text, kind, names))
            except Rejected as error:
                self.problems[path] = str(error)
        self._shown = message
        return message

    def resize(self, path: str, step: int, names: Mapping[str, Any]) -> None:
        """Give a sequence one element more (1) or less (-1), if its type allows that. Raises LookupError for no such field."""
        owner, name, kind = self._slot(self._shown, path)
        if not kind.name.startswith(SEQUENCE):
            return
        kept = {each: text for each, text in self.expressions.items() if each.startswith(f"{path}[")}
        values = _values(owner, name)
        values = values[:-1] if step < 0 else [*values, octet(0) if kind.python is bytes else kind.python()]
        self.set_if_good(path, _array_text(values), names)
        self.expressions.update(kept)
        self.message(names)

    def _put(self, owner: Any, name: tuple[str, int | None], value: Any) -> None:
        field, index = name
        if index is not None:
            value = [value if at == index else each for at, each in enumerate(_values(owner, name))]
        elif isinstance(value, list) and value and _is_message(value[0]):
            value = [deepcopy(each) for each in value]  # `[Point()] * 2` is one point
        try:
            setattr(owner, field, value)
        except (AssertionError, OverflowError, TypeError, ValueError) as error:
            raise Rejected(self._refusal.format(name=field, value=value_text(value), error=error)) from None

    def _slot(self, message: Any, path: str) -> tuple[Any, tuple[str, int | None], FieldKind]:
        """The message that a field is in, the field's name there, with the index of an element, and its kind."""
        steps: list[str | int] = [name or int(index) for name, index in _STEPS.findall(path)]
        owner, field, kind = None, "", ""
        for at, step in enumerate(steps):
            if isinstance(step, int):
                kind = element_type(kind)
                message[step]  # raises IndexError
                if at == len(steps) - 1:
                    return owner, (field, step), kind_of(kind)
                message = message[step]
            else:
                kind = message.get_fields_and_field_types()[step]
                if at == len(steps) - 1:
                    return message, (step, None), kind_of(kind)
                owner, field, message = message, step, getattr(message, step)
        raise LookupError(path)


def _values(owner: Any, name: tuple[str, int | None]) -> list[Any]:
    values: Any = getattr(owner, name[0])
    return values.tolist() if hasattr(values, "tolist") else list(values)


def _array_text(values: Sequence[Any]) -> str:
    """An expression for an array; of messages, for as many empty ones."""
    if not values or not _is_message(values[0]):
        return value_text(values)
    empty = f"{type_name(type(values[0])).replace('/', '.')}()"
    return f"[{', '.join([empty] * len(values))}]"


def kind_of(name: str) -> FieldKind:
    """What a field of this type can hold; the type is written as rosidl's classes write it, `sequence<double, 3>`."""
    base = element_type(name) or name
    if "/" in base:
        package, _, last = base.rpartition("/")
        python: type[Any] = get_message(f"{package.partition('/')[0]}/msg/{last}")
    else:
        python = _PYTHON.get(base, str)
    return FieldKind(name, python, base != name)


def octet(value: Any) -> bytes:
    """A value as one byte. Raises TypeError or ValueError."""
    return value if isinstance(value, bytes) else bytes([value])


def elements(values: Iterable[Any], python: type[Any], make: Callable[[Any], Any]) -> list[Any]:
    """The elements of an array, each made into what the array holds; quick where they, a million perhaps, are that already."""
    found = list(values)
    return found if set(map(type, found)) <= {python} else [make(each) for each in found]

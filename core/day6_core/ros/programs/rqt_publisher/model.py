"""What the Message Publisher shows: publishers, each with its rate and the expressions of its message's fields."""

from __future__ import annotations

import ast
import math
import time
from collections.abc import Callable, Mapping
from functools import partial
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.interfaces import SerializationError, get_message
from day6_core.ros.programs.rqt_py_common.expressions import NAMES, ExpressionError, evaluate
from day6_core.ros.programs.rqt_py_common.message_form import (
    INTERFACE_ERRORS,
    FieldKind,
    FieldRow,
    MessageForm,
    Rejected,
    elements,
    octet,
)
from day6_core.ros.programs.rqt_py_common.requests import Requests
from rclpy.clock import Clock
from rclpy.clock_type import ClockType
from rclpy.exceptions import InvalidTopicNameException

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher
    from rclpy.timer import Timer

FASTEST = 1_000_000.0
"""Hz, as in the real one's box for a rate; but no message comes earlier than a millisecond after another (its QTimer)."""

DEPTH = 10
"""Of every publisher's history."""

HEAVY_SECONDS = 0.01
"""From this time of computing on, a message is followed by a pause: others live on the same thread."""

RESTS = 3
"""How many times as long that pause is."""

MOST_KEPT = 200
"""Publishers that are taken from a perspective."""


def convert(text: str, kind: FieldKind, names: Mapping[str, Any]) -> Any:
    """Return the value of a message's field; only a text may be something that cannot be computed.

    Raises:
        Rejected: in the words of publisher.py.
    """
    is_text = kind.python is str and not kind.is_array
    try:
        value = evaluate(text, names)
    except ExpressionError as error:
        if is_text:
            return text.strip()
        raise Rejected(f'error evaluating as "{_python_name(kind)}": {error}') from None
    if is_text:
        return str(value)
    try:
        if not kind.is_array:
            return _element(value, kind.python)
        if isinstance(value, (list, tuple)):
            return elements(value, kind.python, lambda each: _element(each, kind.python))
    except (ArithmeticError, TypeError, ValueError):
        pass
    raise Rejected(f'error evaluating as "{_python_name(kind)}"')


def _python_name(kind: FieldKind) -> str:
    return "list" if kind.is_array else kind.python.__name__


def _element(value: Any, python: type[Any]) -> Any:
    """A number of one kind becomes one of the other; everything else has to be what the field holds."""
    if python is bytes:
        return octet(value)
    if isinstance(value, python):
        return value
    if python in (int, float) and type(value) in (int, float):
        return python(value)
    raise TypeError


class ShownPublisher(NamedTuple):
    """One publisher as the window shows it; `counter` is the `i` of its newest message."""

    number: int
    topic: str
    type: str
    rate: float
    enabled: bool
    rows: list[FieldRow]
    counter: int
    problem: str


class MessagePublisher(Requests):
    """The model of one Message Publisher. The window reads `shown` and calls what is below "the window's side"."""

    def __init__(self, node: Node) -> None:
        super().__init__()
        self._node = node
        self._clock = Clock(clock_type=ClockType.STEADY_TIME)
        self._names = {**NAMES, "i": 0, "now": lambda: node.get_clock().now().to_msg()}
        self._entries: dict[int, _Entry] = {}
        self._number = 0
        self.message = ""
        """Why the last request was not carried out, in rqt's words."""
        self.on_warning: Callable[[str], None] = lambda text: None
        """Gets every such message, for the terminal."""
        self.version = 0

    def shown(self) -> list[ShownPublisher]:
        """The publishers, in the order in which they were added."""
        return [entry.shown() for entry in list(self._entries.values())]

    def count_of(self, number: int) -> int:
        """The `i` of a publisher's newest message."""
        entry = self._entries.get(number)
        return entry.count if entry is not None else 0

    def topics(self) -> list[tuple[str, str]]:
        """Names and types of the topics there are, to choose from."""
        return [(name, types[0]) for name, types in sorted(self._node.get_topic_names_and_types()) if types]

    # -- the window's side ---------------------------------------------------------------------------------------------

    def add(self, topic: str, type_name: str, rate: float = 1.0) -> None:
        """Add a publisher, which publishes nothing yet."""
        self.post(partial(self._add, topic, type_name, rate))

    def set_enabled(self, number: int, enabled: bool) -> None:
        """Publish periodically, or no longer."""
        self.post(partial(self._change, number, lambda entry: entry.set_enabled(enabled)))

    def set_rate(self, number: int, text: str) -> None:
        """Publish so many times a second; 0 for publishing by hand."""
        self.post(partial(self._change, number, lambda entry: self._set_rate(entry, text)))

    def set_expression(self, number: int, path: str, text: str) -> None:
        """Give a field an expression; an empty one gives it back its default."""
        self.post(partial(self._change, number, lambda entry: entry.set_expression(path, text)))

    def resize(self, number: int, path: str, step: int) -> None:
        """Give a sequence one element more (1) or less (-1)."""
        self.post(partial(self._change, number, lambda entry: entry.resize(path, step)))

    def publish_once(self, number: int) -> None:
        """Publish one message now."""
        self.post(partial(self._change, number, lambda entry: entry.publish()))

    def remove(self, number: int) -> None:
        """Remove a publisher."""
        self.post(partial(self._change, number, self._remove))

    def clear(self) -> None:
        """Remove all."""
        self.post(self.close)

    # -- the program's side --------------------------------------------------------------------------------------------

    def close(self) -> None:
        """Remove all publishers."""
        for entry in list(self._entries.values()):
            self._remove(entry)

    def _change(self, number: int, change: Callable[[_Entry], object]) -> None:
        entry = self._entries.get(number)
        if entry is not None:
            self.message = ""
            change(entry)
            self.version += 1

    def _fail(self, text: str) -> None:
        self.message = text
        self.version += 1
        self.on_warning(text)

    def _add(self, topic: str, type_name: str, rate: float, expressions: Mapping[str, str] | None = None) -> None:
        self.message = ""
        if not topic.startswith("/"):
            topic = self._node.get_namespace().rstrip("/") + "/" + topic
        try:
            message_class = get_message(type_name)
            form = MessageForm(message_class, convert, "error: {error}")
        except INTERFACE_ERRORS as error:
            self._fail(
                f"Creating message type {type_name} failed. Please check your spelling and that the message package has "
                f"been built\n{error}"
            )
            return
        try:
            publisher = self._node.create_publisher(message_class, topic, DEPTH)
        except InvalidTopicNameException as error:
            self._fail(str(error))
            return
        entry = _Entry(self, self._number, topic, type_name, rate, form, publisher)
        for path, text in sorted((expressions or {}).items(), key=lambda pair: pair[0].count("[")):
            entry.set_expression(path, text)
        self._entries[self._number] = entry
        self._number += 1
        self.version += 1

    def _remove(self, entry: _Entry) -> None:
        entry.set_enabled(False)
        self._node.destroy_publisher(entry.publisher)
        del self._entries[entry.number]
        self.version += 1

    def _set_rate(self, entry: _Entry, text: str) -> None:
        try:
            rate = float(text)
        except ValueError:
            rate = math.nan
        if 0.0 <= rate <= FASTEST:
            entry.set_rate(rate)
        else:
            self._fail(f"Publisher._change_publisher_rate(): could not parse rate value: {text}")

    # -- for a publisher of the model ----------------------------------------------------------------------------------

    def names(self, count: int) -> dict[str, Any]:
        """What an expression may use in the message with this number."""
        self._names["i"] = count
        return self._names

    def create_timer(self, seconds: float, work: Callable[[], None]) -> Timer:
        return self._node.create_timer(seconds, work, clock=self._clock)

    def destroy_timer(self, timer: Timer) -> None:
        self._node.destroy_timer(timer)

    # -- perspectives --------------------------------------------------------------------------------------------------

    def kept(self) -> str:
        """All publishers as rqt_publisher keeps them in a perspective: a list of dictionaries, as Python writes it."""
        return repr(
            [
                {
                    "topic_name": entry.topic,
                    "type_name": entry.type_name,
                    "rate": entry.rate,
                    "enabled": False,
                    "publisher_id": entry.number,
                    "counter": entry.count,
                    "expressions": {entry.topic + path: text for path, text in entry.form.expressions.items()},
                }
                for entry in self._entries.values()
            ]
        )

    def take_kept(self, text: str) -> None:
        """Add the publishers of a perspective; what is wrong in it is left out."""
        try:
            entries = ast.literal_eval(text)
        except (ValueError, SyntaxError, TypeError, RecursionError, MemoryError):
            self._fail("publishers of the perspective cannot be read")
            return
        for each in entries[:MOST_KEPT] if isinstance(entries, list) else ():
            match each:
                case {"topic_name": str(topic), "type_name": str(type_name), "rate": float() | int() as rate, **more}:
                    kept = more.get("expressions")
                    pairs = kept.items() if isinstance(kept, dict) else ()
                    fields = {
                        path.removeprefix(topic): text
                        for path, text in pairs
                        if isinstance(path, str) and isinstance(text, str) and text.isprintable()
                    }
                    self._add(topic, type_name, float(rate) if 0 <= rate <= FASTEST else 1.0, fields)


class _Entry:
    """One publisher: its rate, the form of its message, and the timer while it publishes."""

    def __init__(
        self,
        model: MessagePublisher,
        number: int,
        topic: str,
        type_name: str,
        rate: float,
        form: MessageForm,
        publisher: Publisher[Any],
    ) -> None:
        self._model = model
        self.number, self.topic, self.type_name, self.rate = number, topic, type_name, rate
        self.form, self.publisher = form, publisher
        self.enabled = False
        self.count = 0
        self._timer: Timer | None = None
        self._rests = 0
        """How many of the timer's next calls are let pass."""
        self._problem = ""
        """Why the last message could not be sent."""

    def shown(self) -> ShownPublisher:
        return ShownPublisher(
            self.number,
            self.topic,
            self.type_name,
            self.rate,
            self.enabled,
            self.form.rows(1),
            self.count,
            self._problem,
        )

    def set_enabled(self, enabled: bool) -> None:
        self.enabled = enabled
        if self._timer is not None:
            self._model.destroy_timer(self._timer)
            self._timer = None
        if enabled and self.rate > 0:
            period = max(1, int(1000 / self.rate)) / 1000
            self._timer = self._model.create_timer(period, partial(self._publish_in_turn, period))

    def set_rate(self, rate: float) -> None:
        self.rate = rate
        self.set_enabled(self.enabled)

    def set_expression(self, path: str, text: str) -> None:
        try:
            self.form.set_if_good(path, text, self._model.names(self.count))
        except (LookupError, AttributeError, TypeError):
            return  # a perspective's, of a type that was different then

    def resize(self, path: str, step: int) -> None:
        self.form.resize(path, step, self._model.names(self.count))

    def _publish_in_turn(self, period: float) -> None:
        if self._rests:
            self._rests -= 1
            return
        began = time.thread_time()
        self.publish()
        spent = time.thread_time() - began
        self._rests = int(RESTS * spent / period) if spent > HEAVY_SECONDS else 0

    def publish(self) -> None:
        """Publish one message; a field whose expression is wrong now, which it was not when it was typed, has its default."""
        before = self.form.problems, self._problem
        self.count += 1
        message = self.form.message(self._model.names(self.count))
        self._problem = ""
        try:
            self.publisher.publish(message)
        except (SerializationError, AssertionError, OverflowError, TypeError, ValueError) as error:
            self._problem = str(error)
        if before != (self.form.problems, self._problem):
            self._model.version += 1

"""What may be a callback: functions, methods and objects of all kinds, told apart by the arguments they take."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable
from typing import Any

import pytest
from std_msgs.msg import String

from rclpy._day6.callables import accepts, is_coroutine_function, lacks_self


class Listener:
    heard: list[Any]

    def __init__(self) -> None:
        self.heard = []

    def method(self, message: Any) -> None:
        self.heard.append(message)

    def with_info(self, message: Any, info: Any) -> None:
        self.heard.append((message, info))

    async def later(self, message: Any) -> None:
        self.heard.append(message)

    @classmethod
    def of_class(cls, message: Any) -> None: ...

    @staticmethod
    def plain(message: Any) -> None: ...

    def forgotten() -> None:  # type: ignore[misc]
        ...

    def anything(*arguments: Any) -> None: ...

    def __call__(self, message: Any) -> None:
        self.heard.append(message)


def optional(message: Any, more: Any = None) -> None: ...


def only_by_name(message: Any, *, needed: Any) -> None: ...


def maybe_by_name(message: Any, *, spare: Any = None) -> None: ...


def several(*messages: Any) -> None: ...


def by_names(**messages: Any) -> None: ...


@functools.wraps(optional)
def wrapped(*_arguments: Any) -> None: ...


async def coroutine(message: Any) -> None: ...


LISTENER = Listener()
CALLABLES: tuple[Callable[..., Any], ...] = (
    LISTENER,
    LISTENER.method,
    LISTENER.with_info,
    LISTENER.later,
    LISTENER.of_class,
    LISTENER.plain,
    LISTENER.anything,
    Listener.method,
    Listener,
    optional,
    only_by_name,
    maybe_by_name,
    several,
    by_names,
    wrapped,
    coroutine,
    functools.partial(optional, 1),
    functools.partial(only_by_name, needed=1),
    functools.partial(coroutine),
    [].append,
    len,
    lambda: None,
    lambda message, info: None,
)


def called_with(function: Any, arguments: int) -> bool:
    try:
        inspect.signature(function).bind(*[None] * arguments)
    except TypeError:
        return False
    return True


@pytest.mark.parametrize("function", CALLABLES)
def test_what_a_callable_accepts_is_what_inspect_says(function: Any) -> None:
    assert [accepts(function, number) for number in range(4)] == [called_with(function, number) for number in range(4)]
    assert is_coroutine_function(function) == inspect.iscoroutinefunction(function)
    assert not lacks_self(function)


def test_a_method_without_self_is_noticed() -> None:
    assert lacks_self(LISTENER.forgotten)
    assert not lacks_self(Listener.forgotten)
    with pytest.raises(ValueError):
        accepts(LISTENER.forgotten, 0)


def test_print_may_always_be_a_callback_and_what_does_not_tell_may_not() -> None:
    assert accepts(print, 1)
    unknown = next((each for each in (getattr, max, min, iter) if not _tells(each)), None)
    if unknown is not None:
        with pytest.raises(ValueError):
            accepts(unknown, 1)


def _tells(function: Any) -> bool:
    try:
        inspect.signature(function)
    except ValueError:
        return False
    return True


def test_callbacks_of_all_kinds_hear_a_message(world: Any) -> None:
    node = world.node("n")
    listener = Listener()
    several_heard: list[Any] = []
    callbacks = (
        listener,
        listener.method,
        listener.with_info,
        listener.later,
        listener.heard.append,
        functools.partial(lambda kept, message: kept.append(message), listener.heard),
        lambda *messages: several_heard.append(messages),
    )
    for callback in callbacks:
        node.create_subscription(String, "t", callback, 10)
    node.create_publisher(String, "t", 10).publish(String(data="x"))
    world.settle()
    assert len(listener.heard) == 6
    (pair,) = [each for each in listener.heard if isinstance(each, tuple)]
    assert pair[1]["publication_sequence_number"] == 1
    assert several_heard == [(String(data="x"),)], "one argument is tried first"
    for wrong in (lambda: None, lambda a, b, c: None, "text", None):
        with pytest.raises(RuntimeError, match="callback should be either be callable with one argument"):
            node.create_subscription(String, "t", wrong, 10)

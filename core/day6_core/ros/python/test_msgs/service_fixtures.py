"""The requests and responses of test_msgs that real ROS tests its services with."""

from __future__ import annotations

from collections.abc import Callable
from itertools import count
from typing import Any

from test_msgs.message_fixtures import _EXTREMES, _LONG, _collections
from test_msgs.message_fixtures import get_msg_basic_types as get_messages_basic_types
from test_msgs.srv import Arrays, BasicTypes, Empty

Pairs = list[list[Any]]
"""Requests, each with its response."""


def get_msg_empty() -> Pairs:
    """Return an Empty."""
    return [[Empty.Request(), Empty.Response()]]


def _basic(part: type[Any], number: int, single: float, double: float, text: str) -> Any:
    """Return a part of BasicTypes, whose integers are the multiples of `number`."""
    multiples = count(number, number)
    integers = {f"{kind}_value": next(multiples) for kind in _EXTREMES if "int" in kind}
    return part(
        bool_value=number > 0,
        byte_value=bytes([number]),
        char_value=number,
        float32_value=single,
        float64_value=double,
        string_value=text,
        **integers,
    )


def get_msg_basic_types() -> Pairs:
    """Return a BasicTypes of zeros, and one of small numbers and long texts."""
    request, response = BasicTypes.Request, BasicTypes.Response
    return [
        [_basic(request, 0, 0.0, 0.0, "request"), _basic(response, 0, 0.0, 0.0, "reply")],
        [_basic(request, 1, 1.125, 1.11, _LONG), _basic(response, 11, 11.125, 11.11, _LONG)],
    ]


def _arrays(part: type[Any], order: tuple[int, ...]) -> Any:
    texts, basic = ("", "max value", "min value"), get_messages_basic_types()
    return _collections(
        part(),
        lambda kind: [_EXTREMES[kind][at] for at in order],
        [texts[at] for at in order],
        [basic[at] for at in order],
    )


def get_msg_arrays() -> Pairs:
    """Return an Arrays with full arrays, those of its response in another order."""
    return [[_arrays(Arrays.Request, (0, 1, 2)), _arrays(Arrays.Response, (1, 0, 2))]]


_FIXTURES: dict[str, Callable[[], Pairs]] = {
    "Arrays": get_msg_arrays,
    "BasicTypes": get_msg_basic_types,
    "Empty": get_msg_empty,
}


def get_test_srv(service_name: str) -> Pairs:
    """Return the parts of `test_msgs/srv/<service_name>`; NotImplementedError for a name that isn't in test_msgs."""
    if service_name not in _FIXTURES:
        raise NotImplementedError("%s service is not part of the test suite", service_name)
    return _FIXTURES[service_name]()

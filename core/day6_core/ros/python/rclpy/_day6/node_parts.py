"""Descriptors for the parts of a node, which also detect that `Node.__init__` was not called.

Programs read and set a few private attributes that real rclpy's `Node` has (`self._parameters`, or `self._publishers = {}` by
accident); here they belong to the parts, and a program gets the same objects and the same errors.
"""

from __future__ import annotations

import sys
from typing import TYPE_CHECKING, Any, Generic, NoReturn, TypeVar

_T = TypeVar("_T")

_FIRST_USED = {
    "add_on_set_parameters_callback": "_on_set_parameters_callbacks",
    "add_post_set_parameters_callback": "_post_set_parameters_callbacks",
    "add_pre_set_parameters_callback": "_pre_set_parameters_callbacks",
    "add_waitable": "_Node__waitables",
    "clients": "_clients",
    "create_rate": "_rate_group",
    "declare_parameters": "_parameter_overrides",
    "describe_parameter": "_descriptors",
    "describe_parameters": "_descriptors",
    "destroy_client": "_clients",
    "destroy_guard_condition": "_guards",
    "destroy_publisher": "_publishers",
    "destroy_service": "_services",
    "destroy_subscription": "_subscriptions",
    "destroy_timer": "_timers",
    "guards": "_guards",
    "publishers": "_publishers",
    "remove_on_set_parameters_callback": "_on_set_parameters_callbacks",
    "remove_post_set_parameters_callback": "_post_set_parameters_callbacks",
    "remove_pre_set_parameters_callback": "_pre_set_parameters_callbacks",
    "remove_waitable": "_Node__waitables",
    "services": "_services",
    "set_parameters": "_pre_set_parameters_callbacks",
    "set_parameters_atomically": "_pre_set_parameters_callbacks",
    "subscriptions": "_subscriptions",
    "timers": "_timers",
    "waitables": "_Node__waitables",
}
"""The attribute that a method of real rclpy's `Node` reads first, where it is not the part's `known_by`."""


def _missing(node: object, name: str) -> NoReturn:
    error = AttributeError(f"{type(node).__name__!r} object has no attribute {name!r}")
    error.name, error.obj = name, node
    raise error


class NodePart(Generic[_T]):
    """A part that `Node.__init__` sets; reading it before that fails as in real rclpy."""

    def __init__(self, known_by: str) -> None:
        self._known_by = known_by

    def __get__(self, node: object, _class: type[Any]) -> _T:
        if node is None:
            raise AttributeError(self._known_by)
        _missing(node, _FIRST_USED.get(sys._getframe(1).f_code.co_name, self._known_by))

    if TYPE_CHECKING:

        def __set__(self, node: object, part: _T) -> None: ...


class Owned:
    """An attribute of real rclpy's `Node` that one of the parts owns."""

    def __init__(self, part: str, attribute: str) -> None:
        self._part = part
        self._attribute = attribute

    def __set_name__(self, _class: type[Any], name: str) -> None:
        self._name = name

    def __get__(self, node: object, _class: type[Any]) -> Any:
        if node is None:
            raise AttributeError(self._name)
        part = vars(node).get(self._part)
        if part is None:
            _missing(node, self._name)
        return getattr(part, self._attribute)

    def __set__(self, node: object, value: object) -> None:
        part = vars(node).get(self._part)
        # `Node.__init__` replaces a value that was set before it, in real rclpy too.
        if part is not None:
            setattr(part, self._attribute, value)

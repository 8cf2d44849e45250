"""Names of Python's own library that modules of real rclpy have because they import them (rclpy 9.1.2, Kilted).

Editors complete annotations with them: `rclpy.List[str]`, `from rclpy.executors import Lock`. In real ROS such programs run.
"""

from __future__ import annotations

from importlib import import_module
from typing import Any

_OF_TYPING = {
    "rclpy": "List Optional Type Union",
    "rclpy.action.client": "Dict Optional Tuple Type TypedDict",
    "rclpy.action.graph": "List Tuple",
    "rclpy.action.server": "Dict Literal Optional Tuple Type TypeAlias TypeVar TypedDict",
    "rclpy.callback_groups": "Literal Optional Union",
    "rclpy.client": "Dict Optional Type",
    "rclpy.clock": "Literal Optional Type TypeAlias TypedDict overload",
    "rclpy.context": "ContextManager List Optional Type Union",
    "rclpy.duration": "Union",
    "rclpy.event_handler": "List Optional Type TypeAlias Union overload",
    "rclpy.exceptions": "List Optional Union",
    "rclpy.executors": "ContextManager Coroutine Dict Generator List Optional Set TYPE_CHECKING Tuple Type TypeVar Union "
    "overload",
    "rclpy.guard_condition": "Optional",
    "rclpy.impl.rcutils_logger": "ClassVar Dict List Literal Optional OrderedDict Tuple Type TypedDict Union cast",
    "rclpy.lifecycle.node": "Dict List Literal Optional Set Type TypeAlias TypedDict Union",
    "rclpy.lifecycle.publisher": "TYPE_CHECKING Tuple Type TypeAlias TypedDict Union",
    "rclpy.logging": "Union",
    "rclpy.node": "Dict Iterator List Optional Sequence Tuple Type TypeAlias overload",
    "rclpy.parameter": "Dict List Literal Optional Tuple Union overload",
    "rclpy.parameter_client": "List Optional Sequence Union",
    "rclpy.parameter_event_handler": "Dict Iterable List Optional Tuple",
    "rclpy.publisher": "List Optional Type Union",
    "rclpy.qos": "Callable Iterable List Optional Tuple Type TypeAlias Union",
    "rclpy.qos_overriding_options": "List Optional Text Type TypeAlias Union",
    "rclpy.serialization": "Type",
    "rclpy.service": "Optional Type Union",
    "rclpy.signals": "Optional",
    "rclpy.subscription": "Optional Type Union",
    "rclpy.task": "Dict List Optional Tuple Union cast overload",
    "rclpy.time": "Tuple Union",
    "rclpy.time_source": "List Optional Set",
    "rclpy.timer": "Optional Type Union",
    "rclpy.topic_endpoint_info": "List Union",
    "rclpy.type_support": "ClassVar Optional Protocol Type TypeAlias Union",
    "rclpy.utilities": "List Optional Set",
    "rclpy.wait_for_message": "Literal Tuple Type Union",
    "rclpy.waitable": "List Optional Type",
}
_OTHERS = {
    "rclpy.action.client": "types.TracebackType time uuid",
    "rclpy.action.server": "functools enum.Enum types.TracebackType",
    "rclpy.client": "types.TracebackType time",
    "rclpy.event_handler": "types.TracebackType",
    "rclpy.executors": "threading.Condition threading.Lock threading.RLock contextlib.ExitStack "
    "concurrent.futures.ThreadPoolExecutor types.TracebackType inspect time functools.partial",
    "rclpy.impl.rcutils_logger": "inspect",
    "rclpy.node": "warnings math time",
    "rclpy.parameter": "sys",
    "rclpy.parameter_event_handler": "collections.defaultdict",
    "rclpy.publisher": "types.TracebackType",
    "rclpy.service": "types.TracebackType",
    "rclpy.subscription": "types.TracebackType inspect",
    "rclpy.task": "inspect",
    "rclpy.waitable": "types.TracebackType",
}


def standard_name(module: str, name: str) -> Any:
    """Return the object from Python's library that `module` of real rclpy has under that name; AttributeError if none."""
    if name in _OF_TYPING.get(module, "").split():
        return getattr(import_module("typing"), name)
    for path in _OTHERS.get(module, "").split():
        source, _, last = path.rpartition(".")
        if last == name:
            return getattr(import_module(source), name) if source else import_module(name)
    raise AttributeError(f"module {module!r} has no attribute {name!r}")

"""Names on a node: expansion, remapping and validation."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.graph import names
from rclpy._day6.handles import rules_for
from rclpy._day6.resolve import expand, raise_for_namespace, raise_for_node, raise_for_topic, require_text
from rclpy._rclpy_pybind11 import RCLError
from rclpy.exceptions import InvalidTopicNameException

if TYPE_CHECKING:
    from rclpy._day6.handles import NodeHandle

_WRONG_NAME_TYPE = (
    "rclpy_resolve_name(): incompatible function arguments. The following argument types are supported:\n"
    "    1. (arg0: rclpy::Node, arg1: str, arg2: bool, arg3: bool) -> str\n\nInvoked with: {!r}, {!r}, {}, {}"
)


def resolved_name(handle: NodeHandle, name: str, *, only_expand: bool, is_service: bool) -> str:
    """Return the full name of a topic or service, remapped unless `only_expand`. RCLError for a bad name."""
    handle.check()
    if not isinstance(name, str):
        require_text(name)
        raise TypeError(_WRONG_NAME_TYPE.format(handle, name, only_expand, is_service))
    return handle.resolve(name, is_service=is_service, only_expand=only_expand)


def full_topic_name(handle: NodeHandle, topic: str) -> str:
    """Return the full, remapped name of a topic; InvalidTopicNameException for a bad name."""
    try:
        return resolved_name(handle, topic, only_expand=False, is_service=False)
    except RuntimeError:
        try:
            _require_topic_name(handle, topic)
        except InvalidTopicNameException as error:
            raise error from None
        raise


def full_service_name(handle: NodeHandle, service: str) -> str:
    """Return the full, remapped name of a service; InvalidServiceNameException for a bad one."""
    handle.check()
    raise_for_topic(names.flaw_of_topic_name(service), service, is_service=True)
    full = expand(service, handle.name, handle.namespace)
    if handle.rules:
        full = names.remap_topic(full, handle.name, handle.namespace, rules_for(handle.rules, True))
    raise_for_topic(names.flaw_of_full_topic_name(full), full, is_service=True)
    return full


def _require_topic_name(handle: NodeHandle, topic: str) -> None:
    handle.check()
    require_text(topic)
    raise_for_topic(names.flaw_of_topic_name(topic), topic)
    full = expand(topic, handle.name, handle.namespace)
    raise_for_topic(names.flaw_of_full_topic_name(full), full)


def checked_namespace(node_name: Any, namespace: Any, context: object, node: object) -> str:
    """Check a node's names as rclpy's binding, rcl and rmw do; returns the full namespace."""
    if node_name is None:
        raise RCLError("error creating node: name argument is null, at /project/src/rcl/node.c:126")
    if not isinstance(node_name, str) or not isinstance(namespace, str):
        raise TypeError(
            "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
            "    1. rclpy._rclpy_pybind11.Node(arg0: str, arg1: str, arg2: rclpy._rclpy_pybind11.Context, arg3: object, "
            f"arg4: bool, arg5: bool, arg6: object)\n\nInvoked with: {node_name!r}, {namespace!r}, "
            f"<rclpy._rclpy_pybind11.Context object at {id(context):#x}>, None, True, True, "
            f"<rclpy._rclpy_pybind11.rmw_qos_profile_t object at {id(node):#x}>"
        )
    full: str = namespace if namespace.startswith("/") else f"/{namespace}"
    try:
        _require_names(node_name, full)
    except ValueError:
        # As in rclpy the exception with the caret is raised while rcl's is handled: a traceback shows both.
        raise_for_node(node_name)
        raise_for_namespace(full)
    return full


def _require_names(node_name: str, namespace: str) -> None:
    """Raise ValueError as rcl_node_init() does."""
    flaw = names.flaw_of_node_name(node_name)
    if flaw is not None:
        raise ValueError(f"invalid node name: {flaw.message}, at /project/src/rcl/node.c:153")
    flaw = names.flaw_of_namespace(namespace)
    if flaw is not None:
        raise ValueError(
            f"invalid node namespace: {flaw.message}, result: {flaw.number}, at /project/src/rcl/node.c:181"
        )


def require_remapped(namespace: str) -> None:
    """Raise RCLError for a remapped namespace that rmw rejects: one with a slash at its end."""
    flaw = names.flaw_of_namespace(namespace)
    if flaw is not None:
        raise RCLError(
            f"error creating node: invalid node namespace: {flaw.message}, "
            "at /project/src/rmw_node.cpp:68, at /project/src/rcl/node.c:249"
        )

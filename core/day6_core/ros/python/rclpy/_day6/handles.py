"""Handles, as `node.handle`, `publisher.handle` … return them: the object in the graph, and whether it is still usable."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, TypeVar

from day6_core.graph import Endpoint, names
from day6_core.graph import Node as GraphNode
from rclpy._rclpy_pybind11 import DESTROYED, Destroyable, InvalidHandle, RCLError

if TYPE_CHECKING:
    from collections.abc import Callable

    from day6_core.graph.names import RemapRule
    from rclpy._day6.entity import Scope
    from rclpy.context import Context
    from rclpy.impl.rcutils_logger import RcutilsLogger

_Handle = TypeVar("_Handle", bound="EndpointHandle")

INVALID_NODE = "rcl node's context is invalid, at /project/src/rcl/node.c:401"
INVALID_PUBLISHER = "publisher's context is invalid, at /project/src/rcl/publisher.c:427"


def rules_for(rules: list[RemapRule], is_service: bool) -> list[RemapRule]:
    """Return the rules that apply to topics or to services; `rostopic://` and `rosservice://` limit a rule."""
    if not any("://" in rule.match for rule in rules):
        return rules
    wanted, other = ("rosservice://", "rostopic://") if is_service else ("rostopic://", "rosservice://")
    return [
        type(rule)(rule.kind, rule.match.removeprefix(wanted), rule.replacement, rule.node)
        for rule in rules
        if not rule.match.startswith(other)
    ]


class NodeHandle(Destroyable):
    """A node in the graph, with everything its endpoints need."""

    def __init__(
        self, context: Context, node: GraphNode, rules: list[RemapRule], logger: RcutilsLogger, scope: Scope
    ) -> None:
        super().__init__()
        self.context = context
        self.node = node
        self.name = node.name
        self.namespace = node.namespace
        self.rules = rules
        self.logger = logger
        self.scope = scope
        self._users: list[Any] = []
        """Action servers and clients: while one of them exists, a destroyed node stays in the graph, as in real ROS."""

    def __repr__(self) -> str:
        # Part of the error texts for arguments of the wrong type.
        return f"<rclpy._rclpy_pybind11.Node object at {id(self):#x}>"

    def check(self) -> None:
        """Raise InvalidHandle for a destroyed node."""
        if self._destroyed:
            raise InvalidHandle(DESTROYED)

    def check_valid(self, what: str) -> None:
        """Raise InvalidHandle for a destroyed node, RCLError (`what` first) if its context was shut down."""
        if self._destroyed:
            raise InvalidHandle(DESTROYED)
        if not self.context._valid:
            raise RCLError(f"{what}: {INVALID_NODE}")

    def get_node_name(self) -> str:
        """Return the node's name."""
        return self.name

    def get_namespace(self) -> str:
        """Return the node's namespace."""
        return self.namespace

    def get_fully_qualified_name(self) -> str:
        """Return namespace and name."""
        return names.full_name(self.namespace, self.name)

    def logger_name(self) -> str:
        """Return the name of the node's logger."""
        return self.logger.name

    def resolve(self, name: str, *, is_service: bool, only_expand: bool = False) -> str:
        """Return the full name of a topic or service, remapped unless `only_expand`. RCLError for a bad name."""
        flaw = names.flaw_of_topic_name(name)
        if flaw is not None:
            raise RCLError(f"failed to resolve name: {flaw.message}, at /project/src/rcl/expand_topic_name.c:73")
        try:
            full = names.expand(name, self.name, self.namespace)
        except names.UnknownSubstitution as error:
            raise RCLError(f"failed to resolve name: {error}, at /project/src/rcl/expand_topic_name.c:164") from None
        if self.rules and not only_expand:
            full = names.remap_topic(full, self.name, self.namespace, rules_for(self.rules, is_service))
        flaw = names.flaw_of_full_topic_name(full)
        if flaw is not None:
            raise RCLError(f"failed to resolve name: {flaw.message}, at /project/src/rcl/node_resolve_name.c:102")
        return full

    def claim_topic(self, topic: str, type_name: str, what: str, place: str) -> None:
        """Record that the context uses a topic with this type; RCLError if it already uses it with another type.

        Fast DDS has one type per topic and participant, and the participant is the context's.
        """
        known = self.context._topic_types.get(topic)
        if known is None:
            self.context._topic_types[topic] = [type_name, 1]
            return
        if known[0] != type_name:
            package, kind, name = type_name.split("/")
            raise RCLError(
                f"Failed to create {what}: create_{what}() called for existing topic name rt{topic} with incompatible "
                f"type {package}::{kind}::dds_::{name}_, at {place}"
            )
        known[1] += 1

    def release_topic(self, topic: str) -> None:
        """Undo one `claim_topic`."""
        known = self.context._topic_types.get(topic)
        if known is not None:
            known[1] -= 1
            if known[1] <= 0:
                del self.context._topic_types[topic]

    def add_user(self, user: Any) -> None:
        """Keep the node in the graph, once destroyed, until every user is removed or the context is shut down.

        A user has `endpoints`: the ones of the node that stay with it.
        """
        self._users.append(user)

    def remove_user(self, user: Any) -> None:
        """Stop keeping the node for this user; a destroyed node leaves the graph with its last user."""
        if user in self._users:
            self._users.remove(user)
            if self._destroyed and not self._users:
                self.node.destroy()

    def destroy_when_not_in_use(self) -> None:
        """Take the node out of the graph, or only the endpoints that no user needs."""
        if self._destroyed:
            return
        self._destroyed = True
        if not self._users or not self.context._valid:
            self.node.destroy()
            return
        kept = {id(endpoint) for user in self._users for endpoint in user.endpoints}
        for endpoint in self.node.endpoints:
            if id(endpoint) not in kept:
                endpoint.destroy()
        self.context._watch_end(self.node.destroy)


class EndpointHandle(Destroyable):
    """A publisher, subscription, service or client in the graph."""

    def __init__(self, node: NodeHandle, endpoint: Any, *, is_topic: bool) -> None:
        super().__init__()
        self._node = node
        self._endpoint: Any = endpoint
        self._is_topic = is_topic

    @classmethod
    def _of(cls: type[_Handle], node: NodeHandle, endpoint: Any, *, is_topic: bool) -> _Handle:
        """Return the handle of an existing endpoint."""
        made = cls.__new__(cls)
        EndpointHandle.__init__(made, node, endpoint, is_topic=is_topic)
        return made

    def get_logger(self) -> RcutilsLogger:
        """Return the logger of the endpoint's node."""
        return self._node.logger

    def get_logger_name(self) -> str:
        """Return the name of the logger of the endpoint's node."""
        return self._node.logger.name

    def check(self) -> None:
        """Raise InvalidHandle for a destroyed endpoint."""
        if self._destroyed:
            raise InvalidHandle(DESTROYED)

    def check_publisher(self, what: str) -> None:
        """Raise InvalidHandle for a destroyed publisher, RCLError (`what` first) if its context was shut down."""
        if self._destroyed:
            raise InvalidHandle(DESTROYED)
        if not self._node.context._valid:
            raise RCLError(f"{what}: {INVALID_PUBLISHER}")

    def get_topic_name(self) -> str:
        """Return the full name of the topic."""
        endpoint: Endpoint = self._endpoint
        return endpoint.topic

    service_name = name = property(get_topic_name)

    _before_callback: tuple[Any] | None = None
    """What the endpoint called when it was ready before a program's own callback was set."""

    def _call_on_ready(self, callback: Callable[[int], object] | None) -> None:
        """Call `callback(number)` for what arrives as well, at once for what waits already; None ends that."""
        endpoint = self._endpoint
        if self._before_callback is not None:
            endpoint.on_ready = self._before_callback[0]
            self._before_callback = None
        if callback is None:
            return
        self.check()
        if not callable(callback):
            raise TypeError(f"callback should be a callable, got {type(callback)}")
        before = endpoint.on_ready
        self._before_callback = (before,)

        def on_ready(ready: object) -> None:
            if before is not None:
                before(ready)
            callback(1)

        endpoint.on_ready = on_ready
        if endpoint.queue:
            callback(len(endpoint.queue))

    def destroy_when_not_in_use(self) -> None:
        """Take the endpoint out of the graph."""
        if not self._destroyed:
            self._destroyed = True
            self._endpoint.destroy()
            if self._is_topic:
                self._node.release_topic(self._endpoint.topic)

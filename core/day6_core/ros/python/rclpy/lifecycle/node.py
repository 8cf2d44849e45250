"""Lifecycle nodes."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.ros.differences import value
from rclpy._day6.incidental import also
from rclpy._day6.lost_errors import remember
from rclpy._rclpy_pybind11 import RCLError
from rclpy.lifecycle._state_machine import STATES, StateMachine, Transition
from rclpy.lifecycle.managed_entity import ManagedEntity, TransitionCallbackReturn
from rclpy.lifecycle.publisher import LifecyclePublisher
from rclpy.node import Node
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from typing_extensions import Unpack

    from rclpy._day6.typing_names import CreateLifecyclePublisherArgs, LifecycleNodeArgs
    from rclpy.callback_groups import CallbackGroup
    from rclpy.type_support import MsgT

__getattr__ = also(
    __name__,
    "CreateLifecyclePublisherArgs LifecycleNodeArgs CallbackGroup RcutilsLogger Service check_is_valid_srv_type",
)


_NO_NODE = "LifecycleNodeMixin uses Node fields so Node needs to bein the inheritance tree."
_WRONG_ARGUMENTS = (
    "__init__(): incompatible constructor arguments. The following argument types are supported:\n"
    "    1. rclpy._rclpy_pybind11.LifecycleStateMachine(arg0: rclpy._rclpy_pybind11.Node, arg1: bool)\n\n"
    "Invoked with: {!r}, {!r}"
)
_CALLBACK_OF_STATE = {
    10: "on_configure",
    11: "on_cleanup",
    12: "on_shutdown",
    13: "on_activate",
    14: "on_deactivate",
    15: "on_error",
}
_CONFIGURE, _CLEANUP, _ACTIVATE, _DEACTIVATE = 1, 2, 3, 4
_SHUTDOWN_FROM = {"unconfigured": 5, "inactive": 6, "active": 7}


class LifecycleState(NamedTuple):
    """A state's label and number."""

    label: str
    state_id: int


class LifecycleNodeMixin(ManagedEntity):
    """Adds a lifecycle to a node: states, transitions, the services `~/change_state`, `~/get_state` … ."""

    def __init__(
        self, *, enable_communication_interface: bool = True, callback_group: CallbackGroup | None = None
    ) -> None:
        if not isinstance(self, Node):
            raise RuntimeError(_NO_NODE)
        node: Node = self
        if not isinstance(enable_communication_interface, bool):
            raise TypeError(_WRONG_ARGUMENTS.format(node.handle, enable_communication_interface))
        self._managed_entities: set[ManagedEntity] = set()
        self._callbacks: dict[int, Callable[[LifecycleState], TransitionCallbackReturn]] = {
            state: getattr(self, name) for state, name in _CALLBACK_OF_STATE.items()
        }
        self._event_publisher: Any = None
        self._state_machine = StateMachine(node.context._logging, self._announce)
        self._create_event_publisher(node)
        if enable_communication_interface:
            self._create_services(node, callback_group)

    def _create_services(self, node: Node, group: CallbackGroup | None) -> None:
        from lifecycle_msgs import srv

        for srv_type, name, answer in (
            (srv.ChangeState, "change_state", self._on_change_state),
            (srv.GetState, "get_state", self._on_get_state),
            (srv.GetAvailableStates, "get_available_states", self._on_get_available_states),
            (srv.GetAvailableTransitions, "get_available_transitions", self._on_get_available_transitions),
            (srv.GetAvailableTransitions, "get_transition_graph", self._on_get_transition_graph),
        ):
            service = node.create_service(srv_type, f"~/{name}", answer, callback_group=group)
            setattr(self._state_machine, f"service_{name}", service.handle)
            setattr(self, f"_service_{name}", service)

    def _create_event_publisher(self, node: Node) -> None:
        """Make the publisher of transitions, which in real ROS also a node without the services has."""
        from lifecycle_msgs.msg import TransitionEvent

        publisher = node.create_publisher(TransitionEvent, "~/transition_event", 10)
        # In real ROS it belongs to the state machine and isn't one of the node's publishers.
        node._rclpy_entities.hide(publisher)
        self._event_publisher = publisher

    def _announce(self, transition: Transition) -> None:
        publisher = self._event_publisher
        if publisher is not None and publisher._has_subscribers():
            from lifecycle_msgs import msg

            event = msg.TransitionEvent(
                start_state=msg.State(id=transition.start, label=STATES[transition.start]),
                goal_state=msg.State(id=transition.goal, label=STATES[transition.goal]),
            )
            if value("lifecycle.events_are_filled"):
                node: Any = self
                event.stamp = node.get_clock().now().to_msg()
                event.transition = msg.Transition(id=transition.id, label=transition.label)
            publisher.publish(event)

    # -- transitions ---------------------------------------------------------------------------------------------------

    def trigger_configure(self) -> TransitionCallbackReturn:
        """Go from unconfigured to inactive."""
        return self._change_state(_CONFIGURE)

    def trigger_cleanup(self) -> TransitionCallbackReturn:
        """Go from inactive to unconfigured."""
        return self._change_state(_CLEANUP)

    def trigger_shutdown(self) -> TransitionCallbackReturn:
        """Go to finalized.

        Raises:
            RCLError: if that is impossible now.
        """
        transition = _SHUTDOWN_FROM.get(self._state_machine.current_state[1])
        if transition is None:
            raise RCLError("Shutdown transtion not possible")
        return self._change_state(transition)

    def trigger_activate(self) -> TransitionCallbackReturn:
        """Go from inactive to active."""
        return self._change_state(_ACTIVATE)

    def trigger_deactivate(self) -> TransitionCallbackReturn:
        """Go from active to inactive."""
        return self._change_state(_DEACTIVATE)

    def _change_state(self, transition_id: int) -> TransitionCallbackReturn:
        machine = self._state_machine
        logger = self.get_logger()  # type: ignore[attr-defined]
        number, label = machine.current_state
        before = LifecycleState(label=label, state_id=number)
        try:
            machine.trigger_transition_by_id(transition_id, True)
        except RCLError:
            logger.error(f"Unable to start transition {transition_id} from current state {self._reason(number, label)}")
            return TransitionCallbackReturn.ERROR
        outcome = self._execute_callback(before)
        machine.trigger_transition_by_label(outcome.to_label(), True)
        if outcome == TransitionCallbackReturn.ERROR:
            machine.trigger_transition_by_label(self._execute_callback(before).to_label(), True)
        return outcome

    def _reason(self, state: int, label: str) -> str:
        """Return what is logged of the state that a transition isn't possible from."""
        return str((state, label))

    def _execute_callback(self, before: LifecycleState) -> TransitionCallbackReturn:
        callback = self._callbacks.get(self._state_machine.current_state[0])
        if callback is None:
            return TransitionCallbackReturn.SUCCESS
        try:
            return callback(before)
        except Exception as error:
            # As in real rclpy the exception is not shown; the transition ends in error processing.
            remember(error, self.handle.node.full_name)  # type: ignore[attr-defined]
            return TransitionCallbackReturn.ERROR

    # -- managed entities ----------------------------------------------------------------------------------------------

    def add_managed_entity(self, entity: ManagedEntity) -> None:
        """Let an entity follow the transitions.

        Raises:
            TypeError: for anything that isn't a ManagedEntity.
        """
        if not isinstance(entity, ManagedEntity):
            raise TypeError("Expected a rclpy.lifecycle.ManagedEntity instance.")
        self._managed_entities.add(entity)

    def _follow(self, name: str, state: LifecycleState) -> TransitionCallbackReturn:
        for entity in self._managed_entities:
            outcome: TransitionCallbackReturn = getattr(entity, name)(state)
            if not isinstance(outcome, TransitionCallbackReturn):
                raise TypeError(
                    f"{name}() return value of class {type(entity)} should be `TransitionCallbackReturn`.\n"
                    f"Instance of the class that caused the failure: {entity}"
                )
            if outcome != TransitionCallbackReturn.SUCCESS:
                return outcome
        return TransitionCallbackReturn.SUCCESS

    def on_configure(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Let the managed entities follow; overriding methods call this as well."""
        return self._follow("on_configure", state)

    def on_cleanup(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Let the managed entities follow; overriding methods call this as well."""
        return self._follow("on_cleanup", state)

    def on_shutdown(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Let the managed entities follow; overriding methods call this as well."""
        return self._follow("on_shutdown", state)

    def on_activate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Let the managed entities follow; overriding methods call this as well."""
        return self._follow("on_activate", state)

    def on_deactivate(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Let the managed entities follow; overriding methods call this as well."""
        return self._follow("on_deactivate", state)

    def on_error(self, state: LifecycleState) -> TransitionCallbackReturn:
        """Let the managed entities follow; overriding methods call this as well."""
        return self._follow("on_error", state)

    def create_lifecycle_publisher(
        self,
        msg_type: type[MsgT],
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        publisher_class: None = None,
        **kwargs: Unpack[CreateLifecyclePublisherArgs],
    ) -> LifecyclePublisher[MsgT]:
        """Make a publisher that publishes only while the node is active; arguments as of `Node.create_publisher`."""
        if not isinstance(self, Node):
            raise RuntimeError(_NO_NODE)
        if publisher_class:
            raise TypeError("create_publisher() got an unexpected keyword argument 'publisher_class'")
        publisher = Node.create_publisher(
            self, msg_type, topic, qos_profile, publisher_class=LifecyclePublisher, **kwargs
        )
        assert isinstance(publisher, LifecyclePublisher)
        self._managed_entities.add(publisher)
        return publisher

    def destroy_lifecycle_publisher(self, publisher: LifecyclePublisher[Any]) -> bool:
        """Destroy a lifecycle publisher; False if it isn't one of this node."""
        if not isinstance(self, Node):
            raise RuntimeError(_NO_NODE)
        self._managed_entities.discard(publisher)
        return self.destroy_publisher(publisher)

    # -- services ------------------------------------------------------------------------------------------------------

    def _on_change_state(self, request: Any, response: Any) -> Any:
        transition_id = request.transition.id
        if request.transition.label:
            try:
                transition_id = self._state_machine.get_transition_by_label(request.transition.label)
            except RCLError:
                response.success = False
                return response
        response.success = self._change_state(transition_id) == TransitionCallbackReturn.SUCCESS
        return response

    def _on_get_state(self, _request: Any, response: Any) -> Any:
        response.current_state.id, response.current_state.label = self._state_machine.current_state
        return response

    def _on_get_available_states(self, _request: Any, response: Any) -> Any:
        from lifecycle_msgs.msg import State

        response.available_states = [State(id=n, label=label) for n, label in self._state_machine.available_states]
        return response

    def _on_get_available_transitions(self, _request: Any, response: Any) -> Any:
        response.available_transitions = [_message(each) for each in self._state_machine.available_transitions]
        return response

    def _on_get_transition_graph(self, _request: Any, response: Any) -> Any:
        response.available_transitions = [_message(each) for each in self._state_machine.transition_graph]
        return response


def _message(described: tuple[int, str, int, str, int, str]) -> Any:
    from lifecycle_msgs.msg import State, Transition, TransitionDescription

    number, label, start, start_label, goal, goal_label = described
    return TransitionDescription(
        transition=Transition(id=number, label=label),
        start_state=State(id=start, label=start_label),
        goal_state=State(id=goal, label=goal_label),
    )


class LifecycleNode(LifecycleNodeMixin, Node):
    """A node with a lifecycle; the keyword arguments are those of `rclpy.node.Node`."""

    def __init__(
        self, node_name: str, *, enable_communication_interface: bool = True, **kwargs: Unpack[LifecycleNodeArgs]
    ) -> None:
        Node.__init__(self, node_name, **kwargs)
        LifecycleNodeMixin.__init__(self, enable_communication_interface=enable_communication_interface)

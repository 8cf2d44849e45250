"""Runs a lifecycle node."""

from __future__ import annotations

import threading
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from launch.actions.emit_event import EmitEvent
from launch.actions.opaque_function import OpaqueFunction
from launch.event_handler import EventHandler
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType

from launch_ros.actions.node import Node
from launch_ros.events.lifecycle.change_state import ChangeState
from launch_ros.events.lifecycle.state_transition import StateTransition
from launch_ros.ros_adapters import get_ros_node

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_action("lifecycle_node")
class LifecycleNode(Node):
    """A `Node` whose states the launch monitors (`StateTransition` events) and changes (`ChangeState` events).

    `autostart`: configure and activate it as soon as its services are available.
    """

    def __init__(
        self, *, name: SomeSubstitutionsType, namespace: SomeSubstitutionsType, autostart: bool = False, **kwargs: Any
    ) -> None:
        super().__init__(name=name, namespace=namespace, **kwargs)
        self.__autostart = autostart
        self.__subscription: Any = None
        self.__client: Any = None

    @classmethod
    def parse(cls, entity: Any, parser: Any, ignore: Any = ()) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser, ignore)
        autostart = entity.get_attr("autostart", data_type=bool, optional=True)
        if autostart is not None:
            keywords["autostart"] = autostart
        return cls, keywords

    @property
    def node_autostart(self) -> bool:
        return self.__autostart

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        from lifecycle_msgs.msg import TransitionEvent
        from lifecycle_msgs.srv import ChangeState as ChangeStateService

        self._perform_substitutions(context)
        if self.UNSPECIFIED_NODE_NAME in self.node_name:
            raise RuntimeError("node_name unexpectedly incomplete for lifecycle node")
        node = get_ros_node(context)

        def on_transition(message: Any) -> None:
            event = StateTransition(action=self, msg=message)
            context.asyncio_loop.call_soon_threadsafe(context.emit_event_sync, event)

        self.__subscription = node.create_subscription(
            TransitionEvent, f"{self.node_name}/transition_event", on_transition, 10
        )
        self.__client = node.create_client(ChangeStateService, f"{self.node_name}/change_state")
        context.register_event_handler(
            EventHandler(
                matcher=lambda event: isinstance(event, ChangeState),
                entities=[OpaqueFunction(function=self.__on_change_state)],
            )
        )
        following = list(super().execute(context) or ())
        return [*following, *self.__start_actions()] if self.__autostart else following

    def __start_actions(self) -> list[LaunchDescriptionEntity]:
        from launch.actions.register_event_handler import RegisterEventHandler
        from lifecycle_msgs.msg import Transition

        from launch_ros.event_handlers.on_state_transition import OnStateTransition

        def change_state(transition: int) -> EmitEvent:
            return EmitEvent(
                event=ChangeState(lifecycle_node_matcher=lambda action: action is self, transition_id=transition)
            )

        activate = OnStateTransition(
            target_lifecycle_node=self,
            start_state="configuring",
            goal_state="inactive",
            entities=[change_state(Transition.TRANSITION_ACTIVATE)],
            handle_once=True,
        )
        return [RegisterEventHandler(activate), change_state(Transition.TRANSITION_CONFIGURE)]

    def __on_change_state(self, context: LaunchContext) -> None:
        event: ChangeState = context.locals.event
        if event.lifecycle_node_matcher(self):
            future = context.asyncio_loop.run_in_executor(None, self.__change_state, event.transition_id, context)
            context.add_completion_future(future)

    def __change_state(self, transition: int, context: LaunchContext) -> None:
        """Call the service, in a thread; gives up when the launch ends."""
        from rclpy._rclpy_pybind11 import InvalidHandle

        try:
            self.__call_service(transition, context)
        except InvalidHandle:
            if not context.is_shutdown:  # the end of the launch destroys its node
                raise

    def __call_service(self, transition: int, context: LaunchContext) -> None:
        from lifecycle_msgs.srv import ChangeState as ChangeStateService

        logger = launch.logging.get_logger("launch_ros.actions.lifecycle_node")
        service = self.__client.srv_name
        while not self.__client.wait_for_service(timeout_sec=0.2):
            if context.is_shutdown:
                logger.warning(f"Abandoning wait for the '{service}' service, due to shutdown.")
                return
        request = ChangeStateService.Request()
        request.transition.id = transition
        done = threading.Event()
        future = self.__client.call_async(request)
        future.add_done_callback(lambda _: done.set())
        while not done.wait(0.2):
            if context.is_shutdown:
                logger.warning(f"Abandoning wait for the '{service}' service response, due to shutdown.")
                future.cancel()
                return
        if future.exception() is not None:
            raise future.exception()
        if not future.result().success:
            name = ChangeState.valid_transitions[transition]
            logger.error(f"Failed to make transition '{name}' for LifecycleNode '{self.node_name}'")

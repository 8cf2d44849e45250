"""Takes lifecycle nodes through several transitions."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from launch.action import Action
from launch.actions.emit_event import EmitEvent
from launch.actions.opaque_function import OpaqueFunction
from launch.actions.register_event_handler import RegisterEventHandler
from launch.event_handler import BaseEventHandler, EventHandler
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

from launch_ros.events.lifecycle.change_state import ChangeState
from launch_ros.events.lifecycle.state_transition import StateTransition
from launch_ros.events.matchers import matches_node_name

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext

_PATHS = {
    1: ("configuring", "inactive"),
    2: ("cleaningup", "unconfigured"),
    3: ("activating", "active"),
    4: ("deactivating", "inactive"),
    5: ("shuttingdown", "finalized"),
    6: ("shuttingdown", "finalized"),
    7: ("shuttingdown", "finalized"),
}
"""By lifecycle_msgs/Transition, the transition state and the goal state."""


class LifecycleTransition(Action):
    """Makes each node execute the transitions in sequence; an error ends the sequence of that node."""

    def __init__(
        self,
        *,
        lifecycle_node_names: Sequence[SomeSubstitutionsType],
        transition_ids: Sequence[int | SomeSubstitutionsType],
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        if not transition_ids:
            raise ValueError("No transition_ids provided.")
        if not lifecycle_node_names:
            raise ValueError("No lifecycle_node_names provided.")
        self.__names = [normalize_to_list_of_substitutions(name) for name in lifecycle_node_names]
        self.__ids = [
            normalize_to_list_of_substitutions(str(each) if isinstance(each, int) else each) for each in transition_ids
        ]

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        transitions = [_number(perform_substitutions(context, each)) for each in self.__ids]
        names = [perform_substitutions(context, name) for name in self.__names]
        return [action for name in names for action in self.__begin(name, transitions)]

    def __begin(self, name: str, transitions: list[int]) -> list[Action]:
        full_name = name if name.startswith("/") else f"/{name}"
        changes = [
            EmitEvent(event=ChangeState(lifecycle_node_matcher=matches_node_name(name), transition_id=each))
            for each in transitions
        ]
        handlers: list[BaseEventHandler] = []

        def remove(context: LaunchContext, why: str = "") -> None:
            if why:
                launch.logging.get_logger(__name__).info(f"Stopping transitions for {name} because '{why}'")
            for handler in handlers:
                if handler in context._event_handlers:
                    context.unregister_event_handler(handler)

        for transition, following in zip(transitions, [*changes[1:], OpaqueFunction(function=remove)], strict=True):
            matcher = _reaches(full_name, *_PATHS[transition])
            handlers.append(EventHandler(matcher=matcher, entities=[following], handle_once=True))
        failed = OpaqueFunction(function=remove, args=["error occured during transitions"])
        handlers.append(
            EventHandler(matcher=_reaches(full_name, None, "errorprocessing"), entities=[failed], handle_once=True)
        )
        first, *others = map(RegisterEventHandler, handlers)
        return [first, changes[0], *others]


def _number(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise ValueError(f"expected integer for lifecycle transition, got {text}") from None


def _reaches(node_name: str, start: str | None, goal: str) -> Any:
    def matches(event: Any) -> bool:
        return (
            isinstance(event, StateTransition)
            and event.action.node_name == node_name
            and event.goal_state == goal
            and start in (None, event.start_state)
        )

    return matches

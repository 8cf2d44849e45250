"""Actions: the steps of a launch."""

from __future__ import annotations

from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from launch.condition import Condition
from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


class Action(LaunchDescriptionEntity):
    """Base of all actions. With a `condition` it is executed only if that holds when it is visited."""

    def __init__(self, *, condition: Condition | None = None) -> None:
        self.__condition = condition

    @staticmethod
    def parse(entity: Entity, parser: Parser) -> tuple[type[Action], dict[str, Any]]:
        """Return the class and the keyword arguments of the attributes that every tag may have: `if` and `unless`."""
        from launch.conditions import IfCondition, UnlessCondition

        wanted = entity.get_attr("if", optional=True)
        unwanted = entity.get_attr("unless", optional=True)
        if wanted is not None and unwanted is not None:
            raise RuntimeError("if and unless conditions can't be used simultaneously")
        if wanted is not None:
            return Action, {"condition": IfCondition(parser.parse_substitution(wanted))}
        if unwanted is not None:
            return Action, {"condition": UnlessCondition(parser.parse_substitution(unwanted))}
        return Action, {}

    @property
    def condition(self) -> Condition | None:
        return self.__condition

    def describe(self) -> str:
        return self.__repr__()

    def get_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        """Return the entities that executing it will return, as far as they are known beforehand."""
        return []

    def describe_sub_entities(self) -> Sequence[LaunchDescriptionEntity]:
        return self.get_sub_entities() if self.condition is None else []

    def describe_conditional_sub_entities(self) -> Sequence[tuple[str, Iterable[LaunchDescriptionEntity]]]:
        if self.condition is None:
            return []
        return [(f"Conditionally included by {self.describe()}", self.get_sub_entities())]

    def visit(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        if self.__condition is not None and not self.__condition.evaluate(context):
            return None
        try:
            return self.execute(context)
        finally:
            self.__announce_completion(context)

    def __announce_completion(self, context: LaunchContext) -> None:
        from launch.events.execution_complete import ExecutionComplete

        event = ExecutionComplete(action=self)
        if not context.would_handle_event(event):
            return
        future = self.get_asyncio_future()
        if future is None:
            context.emit_event_sync(event)
        else:
            future.add_done_callback(lambda _: context.emit_event_sync(event))

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        """Execute the action; returns the entities to visit next."""
        return None

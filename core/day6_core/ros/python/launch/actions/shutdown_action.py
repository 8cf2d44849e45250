"""Ends the launch."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

import launch.logging
from launch.actions.emit_event import EmitEvent
from launch.events.process.process_exited import ProcessExited
from launch.events.shutdown import Shutdown as ShutdownEvent
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("shutdown")
class Shutdown(EmitEvent):
    """Queues the event that ends the launch; as a process's `on_exit` it logs that this process was required."""

    def __init__(self, *, reason: str = "reason not given", **kwargs: Any) -> None:
        super().__init__(event=ShutdownEvent(reason=reason), **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        reason = entity.get_attr("reason", optional=True)
        if reason:
            keywords["reason"] = parser.parse_substitution(reason)
        return cls, keywords

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        event = context.get_locals_as_dict().get("event")
        if isinstance(event, ProcessExited):
            logger = launch.logging.get_logger("launch")
            logger.info(f"process[{event.process_name}] was required: shutting down launched system")
        return super().execute(context)

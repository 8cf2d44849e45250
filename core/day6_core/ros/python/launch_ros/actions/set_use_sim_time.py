"""Switches the launch itself to simulated time."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity

from launch_ros.ros_adapters import get_ros_node

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("set_use_sim_time")
class SetUseSimTime(Action):
    """Sets `use_sim_time` of the launch's own node, whose clock `ROSTimer` uses."""

    def __init__(self, value: bool, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__value = value

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["value"] = entity.get_attr("value", data_type=bool, can_be_str=False)
        return cls, keywords

    @property
    def value(self) -> bool:
        return self.__value

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        from rclpy.parameter import Parameter

        node = get_ros_node(context)
        node.set_parameters([Parameter("use_sim_time", Parameter.Type.BOOL, self.value)])
        return None

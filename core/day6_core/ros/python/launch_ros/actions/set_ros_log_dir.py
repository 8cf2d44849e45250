"""Sets the folder of the nodes' log files."""

from __future__ import annotations

import os
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.frontend.expose import expose_action
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.launch_context import LaunchContext


@expose_action("set_ros_log_dir")
class SetROSLogDir(Action):
    """Sets ROS_LOG_DIR to `new_log_dir`; a relative one is below the old value (by default ~/.ros/log)."""

    def __init__(self, new_log_dir: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__log_dir = normalize_to_list_of_substitutions(new_log_dir)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        keywords["new_log_dir"] = parser.parse_substitution(entity.get_attr("new_log_dir"))
        return cls, keywords

    @property
    def log_dir(self) -> list[Substitution]:
        return self.__log_dir

    def execute(self, context: LaunchContext) -> Sequence[LaunchDescriptionEntity] | None:
        home = context.environment.get("ROS_HOME") or os.path.join("~", ".ros")
        before = context.environment.get("ROS_LOG_DIR") or os.path.expanduser(os.path.join(home, "log"))
        context.environment["ROS_LOG_DIR"] = os.path.join(before, perform_substitutions(context, self.log_dir))
        return None

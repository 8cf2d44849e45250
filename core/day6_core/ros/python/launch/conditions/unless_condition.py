"""The condition that a text is false."""

from __future__ import annotations

from typing import TYPE_CHECKING

from launch.conditions.if_condition import IfCondition
from launch.substitution import Substitution

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class UnlessCondition(IfCondition):
    """Holds where `IfCondition` does not."""

    @property
    def _told(self) -> tuple[str, list[Substitution]]:
        return "unless", super()._told[1]

    def _predicate_func(self, context: LaunchContext) -> bool:
        return not super()._predicate_func(context)

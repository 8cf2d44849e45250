"""Declares an argument of a launch file that is true or false."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.actions.declare_launch_argument import DeclareLaunchArgument
from launch.frontend.expose import expose_action
from launch.some_substitutions_type import SomeSubstitutionsType

if TYPE_CHECKING:
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser

_CHOICES = ["true", "false", "True", "False", "TRUE", "FALSE"]


@expose_action("bool_arg")
class DeclareBooleanLaunchArgument(DeclareLaunchArgument):
    """As `DeclareLaunchArgument`, with the choices of a boolean; the default may be a Python one."""

    def __init__(self, name: str, *, default_value: SomeSubstitutionsType | bool | None = None, **kwargs: Any) -> None:
        default = str(default_value) if isinstance(default_value, bool) else default_value
        super().__init__(name=name, default_value=default, choices=_CHOICES, **kwargs)

    @classmethod
    def parse(cls, entity: Entity, parser: Parser) -> tuple[Any, dict[str, Any]]:
        _, keywords = super().parse(entity, parser)
        if "choices" in keywords:
            raise ValueError("Cannot specify choices for bool_arg")
        return cls, keywords

"""A value from `context.locals`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from launch.substitution import Substitution
from launch.utilities.ensure_argument_type_impl import ensure_argument_type

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class LocalSubstitution(Substitution):
    """`context.locals.<expression>`, a Python expression: `event.reason`, `ros_specific_arguments['name']`."""

    def __init__(self, expression: str, description: str | None = None) -> None:
        super().__init__()
        ensure_argument_type(expression, str, "expression", "LocalSubstitution")
        self.__expression = expression
        self.__description = description

    @property
    def expression(self) -> str:
        return self.__expression

    @property
    def description(self) -> str | None:
        return self.__description

    def describe(self) -> str:
        return f"LocalVar('{self.description or self.expression}')"

    def perform(self, context: LaunchContext) -> str:
        # As in real launch. Its author is the launch file's author, and that is a program anyway.
        return eval("context.locals." + self.expression, {}, {"context": context})  # type: ignore[no-any-return]

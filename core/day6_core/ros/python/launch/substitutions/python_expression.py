"""The value of a Python expression."""

from __future__ import annotations

import importlib
from collections.abc import Iterable, Sequence
from typing import TYPE_CHECKING, Any

from launch.frontend.expose import expose_substitution
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities.ensure_argument_type_impl import ensure_argument_type
from launch.utilities.normalize_to_list_of_substitutions_impl import normalize_to_list_of_substitutions
from launch.utilities.perform_substitutions_impl import perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


@expose_substitution("eval")
class PythonExpression(Substitution):
    """`str(eval(expression))`, with the names of `python_modules` and all names in `math`.

    Python evaluates it, as in real launch: launch files run whatever their author wants, so restricting it would gain nothing.
    Never launch a file, not even XML or YAML, that you would not run as a program.
    """

    def __init__(self, expression: SomeSubstitutionsType, python_modules: SomeSubstitutionsType = ("math",)) -> None:
        super().__init__()
        for name, value in (("expression", expression), ("python_modules", python_modules)):
            ensure_argument_type(value, (str, Substitution, Iterable), name, "PythonExpression")
        self.__expression = normalize_to_list_of_substitutions(expression)
        self.__python_modules = normalize_to_list_of_substitutions(python_modules)

    @classmethod
    def parse(cls, data: Sequence[Any]) -> tuple[type, dict[str, Any]]:
        if not 1 <= len(data) <= 2:
            raise TypeError("eval substitution expects 1 or 2 arguments")
        keywords: dict[str, Any] = {"expression": data[0]}
        if len(data) == 2:
            names = "".join(part.perform(None) for part in data[1])
            keywords["python_modules"] = [name.strip() for name in names.split(",") if name.strip()]
        return cls, keywords

    @property
    def expression(self) -> list[Substitution]:
        return self.__expression

    @property
    def python_modules(self) -> list[Substitution]:
        return self.__python_modules

    def describe(self) -> str:
        expression = " + ".join(each.describe() for each in self.expression)
        return f"PythonExpr({expression}, [{', '.join(each.describe() for each in self.python_modules)}])"

    def perform(self, context: LaunchContext) -> str:
        names: dict[str, Any] = {}
        for substitution in self.python_modules:
            module = importlib.import_module(context.perform_substitution(substitution))
            if module.__name__ == "math":
                names.update(vars(module))
            names[module.__name__] = module
        return str(eval(perform_substitutions(context, self.expression), {}, names))

"""The description of a component."""

from __future__ import annotations

from collections.abc import Sequence
from typing import TYPE_CHECKING, Any, List  # noqa: UP035

from launch.condition import Condition
from launch.frontend.entity import Entity
from launch.some_substitutions_type import SomeSubstitutionsType
from launch.substitution import Substitution
from launch.utilities import normalize_to_list_of_substitutions

from launch_ros.remap_rule_type import SomeRemapRules
from launch_ros.utilities import normalize_parameters, normalize_remap_rules

if TYPE_CHECKING:
    from launch.frontend.parser import Parser


class ComposableNode:
    """A node that a container loads from a package; see `ComposableNodeContainer`."""

    def __init__(
        self,
        *,
        package: SomeSubstitutionsType,
        plugin: SomeSubstitutionsType,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        parameters: Sequence[Any] | None = None,
        remappings: SomeRemapRules | None = None,
        extra_arguments: Sequence[Any] | None = None,
        condition: Condition | None = None,
    ) -> None:
        self.__package = normalize_to_list_of_substitutions(package)
        self.__plugin = normalize_to_list_of_substitutions(plugin)
        self.__name = None if name is None else normalize_to_list_of_substitutions(name)
        self.__namespace = None if namespace is None else normalize_to_list_of_substitutions(namespace)
        self.__parameters = None if parameters is None else normalize_parameters(parameters)
        self.__remappings = list(normalize_remap_rules(remappings)) if remappings else None
        self.__extra_arguments = normalize_parameters(extra_arguments) if extra_arguments else None
        self.__condition = condition

    @classmethod
    def parse(cls, parser: Parser, entity: Entity) -> tuple[Any, dict[str, Any]]:
        from launch.action import Action

        from launch_ros.actions.node import Node

        _, keywords = Action.parse(entity, parser)
        for attribute, keyword in (("pkg", "package"), ("plugin", "plugin"), ("name", "name")):
            keywords[keyword] = parser.parse_substitution(entity.get_attr(attribute))
        namespace = entity.get_attr("namespace", optional=True)
        if namespace is not None:
            keywords["namespace"] = parser.parse_substitution(namespace)
        parameters = entity.get_attr("param", data_type=List[Entity], optional=True)  # noqa: UP006
        if parameters is not None:
            keywords["parameters"] = Node.parse_nested_parameters(parameters, parser)
        remaps = entity.get_attr("remap", data_type=List[Entity], optional=True) or []  # noqa: UP006
        keywords["remappings"] = [
            tuple(parser.parse_substitution(each.get_attr(side)) for side in ("from", "to")) for each in remaps
        ]
        extra = entity.get_attr("extra_arg", data_type=List[Entity], optional=True) or []  # noqa: UP006
        keywords["extra_arguments"] = [
            {_parts(each, "name", parser): _parts(each, "value", parser)[0]} for each in extra
        ]
        for each in (*remaps, *extra, entity):
            each.assert_entity_completely_parsed()
        return cls, keywords

    @property
    def package(self) -> list[Substitution]:
        return self.__package

    @property
    def node_plugin(self) -> list[Substitution]:
        return self.__plugin

    @property
    def node_name(self) -> list[Substitution] | None:
        return self.__name

    @property
    def node_namespace(self) -> list[Substitution] | None:
        return self.__namespace

    @property
    def parameters(self) -> Any:
        return self.__parameters

    @property
    def remappings(self) -> Any:
        return self.__remappings

    @property
    def extra_arguments(self) -> Any:
        return self.__extra_arguments

    def condition(self) -> Condition | None:
        return self.__condition


def _parts(entity: Entity, attribute: str, parser: Parser) -> tuple[Substitution, ...]:
    return tuple(parser.parse_substitution(entity.get_attr(attribute)))

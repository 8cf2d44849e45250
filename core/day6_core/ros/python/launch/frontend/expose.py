"""The tags of launch files and the substitutions `$(name …)`: tables in which actions and substitutions register."""

from __future__ import annotations

import functools
import inspect
from collections.abc import Callable, Sequence
from typing import TYPE_CHECKING, Any, TypeVar

from day6_core.ros import differences

if TYPE_CHECKING:
    from launch.action import Action
    from launch.frontend.entity import Entity
    from launch.frontend.parser import Parser
    from launch.substitution import Substitution

Exposed = TypeVar("Exposed", bound=Callable[..., Any])

action_parse_methods: dict[str, Callable[..., Any]] = {}
substitution_parse_methods: dict[str, Callable[..., Any]] = {}


def instantiate_action(entity: Entity, parser: Parser) -> Action:
    """Create the action of a tag. Raises RuntimeError for an unknown tag."""
    if entity.type_name not in action_parse_methods or not differences.in_launch(f"action {entity.type_name}"):
        raise RuntimeError(f"Unrecognized entity of the type: {entity.type_name}")
    kind, keywords = action_parse_methods[entity.type_name](entity, parser)
    action: Action = kind(**keywords)
    return action


def instantiate_substitution(type_name: str, args: Sequence[Any] | None = None) -> Substitution:
    """Create the substitution `$(type_name args…)`. Raises RuntimeError for an unknown one."""
    if type_name not in substitution_parse_methods or not differences.in_launch(f"substitution {type_name}"):
        raise RuntimeError(f"Unknown substitution: {type_name}")
    kind, keywords = substitution_parse_methods[type_name](args or [])
    # `any` and `all` take their operands one by one.
    operands = keywords.pop("args", ())
    substitution: Substitution = kind(*operands, **keywords)
    return substitution


def expose_action(name: str) -> Callable[[Exposed], Exposed]:
    """Register the decorated action class (with a class method `parse`) or parse function as the tag `name`."""

    def expose(exposed: Exposed) -> Exposed:
        parse = _parse_method(exposed, name, "action")

        @functools.wraps(parse)
        def parse_all(entity: Entity, parser: Parser) -> Any:
            result = parse(entity, parser)
            entity.assert_entity_completely_parsed()
            return result

        _register(action_parse_methods, name, parse_all, "action")
        return exposed

    return expose


def expose_substitution(name: str) -> Callable[[Exposed], Exposed]:
    """Register the decorated substitution class (with a class method `parse`) or parse function as `$(name …)`."""

    def expose(exposed: Exposed) -> Exposed:
        _register(substitution_parse_methods, name, _parse_method(exposed, name, "substitution"), "substitution")
        return exposed

    return expose


def _parse_method(exposed: Any, name: str, what: str) -> Callable[..., Any]:
    if not inspect.isclass(exposed):
        method: Callable[..., Any] = exposed
        return method
    if not inspect.ismethod(getattr(exposed, "parse", None)):
        raise RuntimeError(f"the {what} {name} needs a class method called 'parse'")
    return exposed.parse  # type: ignore[no-any-return, attr-defined]


def _register(table: dict[str, Callable[..., Any]], name: str, method: Callable[..., Any], what: str) -> None:
    known = table.get(name)
    if known is not None and getattr(known, "__qualname__", "") != getattr(method, "__qualname__", ""):
        raise RuntimeError(f"Two {what} parsing methods exposed with the same name: [{name}].")
    table[name] = method

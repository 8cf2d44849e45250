"""Tab completion: the words that are possible at the cursor."""

from __future__ import annotations

import argparse
from collections.abc import Awaitable, Callable, Iterable
from typing import TYPE_CHECKING, NamedTuple

if TYPE_CHECKING:
    from day6_core.graph import Graph
    from day6_core.session.session import Session


class CompletionContext(NamedTuple):
    """A completer's input: the session, the arguments before the cursor by name, the beginning of the current word."""

    session: Session
    values: dict[str, str]
    prefix: str
    words: list[str]
    """All arguments before the cursor, in order."""


Words = Iterable[str]
Completer = Callable[[CompletionContext], "Words | Awaitable[Words]"]


async def complete_words(words: list[str], session: Session) -> list[str]:
    """Return the possible last words of `words` (which begins with 'ros2'), sorted; see `ros2.complete`."""
    from day6_core.ros import environment
    from day6_core.ros.ros2.cli.tree import build_parser

    environment.activate()
    prefix = words[-1]
    before = words[1:-1]
    walk = _Walk(build_parser(session, before))
    for word in before:
        walk.take(word)
    found = walk.candidates(session, prefix)
    candidates = await found if isinstance(found, Awaitable) else found
    return sorted({candidate for candidate in candidates if candidate.startswith(prefix)})


class _Walk:
    """Follows a command line word by word through the parsers and knows which words may come next."""

    def __init__(self, parser: argparse.ArgumentParser) -> None:
        self.values: dict[str, str] = {}
        self.words: list[str] = []
        self._enter(parser)

    def _enter(self, parser: argparse.ArgumentParser) -> None:
        self._parser = parser
        self._positionals = [action for action in parser._actions if not action.option_strings]
        self._pending: argparse.Action | None = None

    def take(self, word: str) -> None:
        self.words.append(word)
        if self._pending is not None:
            self.values[self._pending.dest] = word
            self._pending = None
            return
        if word.startswith("-") and not self._in_remainder():
            option = self._parser._option_string_actions.get(word)
            if option is not None and option.nargs != 0:
                self._pending = option
            return
        if not self._positionals:
            return
        action = self._positionals[0]
        if isinstance(action, argparse._SubParsersAction):
            parser = action.choices.get(word)
            if isinstance(parser, argparse.ArgumentParser):
                self._enter(parser)
            else:
                self._positionals = []
            return
        self.values[action.dest] = word
        if action.nargs not in (argparse.REMAINDER, "+", "*"):
            self._positionals.pop(0)

    def candidates(self, session: Session, prefix: str) -> Words | Awaitable[Words]:
        if self._pending is not None:
            return self._values_of(self._pending, session, prefix)
        if prefix.startswith("-") and not self._in_remainder():
            return [
                option for option in self._parser._option_string_actions if option.startswith("--") or len(prefix) < 2
            ]
        return self._values_of(self._positionals[0], session, prefix) if self._positionals else []

    def _in_remainder(self) -> bool:
        return bool(self._positionals) and self._positionals[0].nargs == argparse.REMAINDER

    def _values_of(self, action: argparse.Action, session: Session, prefix: str) -> Words | Awaitable[Words]:
        if action.choices is not None:
            from day6_core.ros.ros2.cli.tree import HIDDEN

            return [str(choice) for choice in action.choices if str(choice) not in HIDDEN]
        completer: Completer | None = getattr(action, "completer", None)
        return completer(CompletionContext(session, self.values, prefix, self.words)) if completer is not None else []


async def topic_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a topic; hidden ones once an underscore was typed."""
    return await _names(context, "MP", "MS")


async def service_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a service; hidden ones once an underscore was typed."""
    return await _names(context, "SS")


async def action_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of an action."""
    infix = "/_action/"
    return sorted({name.partition(infix)[0] for name, _ in await _all_names(context, "SS", "MP") if infix in name})


async def node_names(context: CompletionContext) -> Iterable[str]:
    """Complete the full name of a node; hidden ones once an underscore was typed."""
    graph = await _graph(context)
    found = [f"{node.namespace.rstrip('/')}/{node.name}" for node in graph.nodes] if graph is not None else []
    return [name for name in found if _shown(name, context.prefix)]


async def topic_types(context: CompletionContext) -> Iterable[str]:
    """Complete a message type: the topic's own if the topic named before exists, else any."""
    own = dict(await _all_names(context, "MP", "MS")).get(context.values.get("topic_name", ""))
    return own or message_types(context)


async def service_types_of_service(context: CompletionContext) -> Iterable[str]:
    """Complete a service type: the service's own if the one named before exists, else any."""
    own = dict(await _all_names(context, "SS")).get(context.values.get("service_name", ""))
    return own or service_types(context)


async def action_types_of_action(context: CompletionContext) -> Iterable[str]:
    """Complete an action type: the action's own if the one named before exists, else any."""
    own = dict(await _all_names(context, "SS")).get(f"{context.values.get('action_name', '')}/_action/send_goal")
    return [each.removesuffix("_SendGoal") for each in own] if own else action_types(context)


def message_types(context: CompletionContext) -> Iterable[str]:
    """Complete a message type."""
    return _types(context, "msg")


def service_types(context: CompletionContext) -> Iterable[str]:
    """Complete a service type."""
    return _types(context, "srv")


def action_types(context: CompletionContext) -> Iterable[str]:
    """Complete an action type."""
    return _types(context, "action")


def interface_types(context: CompletionContext) -> Iterable[str]:
    """Complete any interface type."""
    return _types(context, "msg", "srv", "action")


def interface_packages(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a package that defines interfaces."""
    from rosidl_runtime_py.get_interfaces import get_interface_packages

    return get_interface_packages(context.session.env)


def package_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a package."""
    from day6_core.ros.ros2.cli.packages import packages

    return packages(context.session)


def executable_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of an executable of the package named before."""
    from day6_core.ros.ros2.cli.packages import executables

    return [each.name for each in executables(context.session, context.values.get("package_name", "")) or ()]


async def parameter_names(context: CompletionContext) -> Iterable[str]:
    """Complete the name of a parameter; the node named before is asked for its list."""
    from day6_core.ros.ros2.param._services import listed_parameters

    return await listed_parameters(context.session, context.values.get("node_name", ""))


async def topic_fields(context: CompletionContext) -> Iterable[str]:
    """Complete a field of the topic's messages, part by part: `pose`, then `pose.position` …"""
    from rosidl_runtime_py.utilities import get_message

    own = [context.values["message_type"]] if "message_type" in context.values else None
    types = own or dict(await _all_names(context, "MP", "MS")).get(context.values.get("topic_name", ""), [])
    path = context.prefix.split(".")[:-1]
    try:
        kind = get_message(types[0])
        for part in path:
            kind = get_message(kind.get_fields_and_field_types()[part])
        fields = kind.get_fields_and_field_types()
    except (AttributeError, ImportError, IndexError, KeyError, ValueError):
        return []
    return [".".join([*path, name]) for name in fields]


def message_prototype(context: CompletionContext) -> Iterable[str]:
    """Complete the values of a message with the default ones."""
    return _prototype(context.values.get("message_type", ""), None)


def request_prototype(context: CompletionContext) -> Iterable[str]:
    """Complete the values of a service request with the default ones."""
    return _prototype(context.values.get("service_type", ""), "Request")


def goal_prototype(context: CompletionContext) -> Iterable[str]:
    """Complete the values of an action goal with the default ones."""
    return _prototype(context.values.get("action_type", ""), "Goal")


def _prototype(type_name: str, part: str | None) -> Iterable[str]:
    from rosidl_runtime_py.convert import message_to_ordereddict
    from rosidl_runtime_py.utilities import get_interface
    from rosidl_runtime_py.yaml_text import one_line

    try:
        found = get_interface(type_name)
        message = (getattr(found, part) if part else found)()
    except (AttributeError, ImportError, ValueError):
        return []
    # On one line, unlike the real tool's: a line break would end the command that is being context.
    return [one_line(message_to_ordereddict(message))]


def _types(context: CompletionContext, *kinds: str) -> list[str]:
    from rosidl_runtime_py.get_interfaces import get_interfaces

    return [
        f"{package}/{name}"
        for package, names in get_interfaces(environment=context.session.env).items()
        for name in names
        if name.partition("/")[0] in kinds
    ]


async def _names(context: CompletionContext, *kinds: str) -> list[str]:
    return [name for name, _ in await _all_names(context, *kinds) if _shown(name, context.prefix)]


async def _all_names(context: CompletionContext, *kinds: str) -> list[tuple[str, list[str]]]:
    from day6_core.graph.endpoints import EndpointKind

    graph = await _graph(context)
    return graph.names_and_types(*map(EndpointKind, kinds)) if graph is not None else []


async def _graph(context: CompletionContext) -> Graph | None:
    """Return the graph once the entities of other processes are in it."""
    from day6_core.ros.ros2.cli.node import settle

    await settle(context.session)
    return context.session.graph


def _shown(name: str, prefix: str) -> bool:
    return "/_" not in name or "_" in prefix

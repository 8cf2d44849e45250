"""What a launch would start, found by visiting its description without starting anything: `day6-tui launch-plan`.

The launch file is read, its functions, conditions and substitutions are performed as in a launch. What waits for a timer or an
event is visited afterwards, with the configurations that the launch has by then; what only an event can tell is told as unknown.
"""

from __future__ import annotations

import json
import os
import sys
from collections import deque
from collections.abc import Callable, Iterable
from typing import Any

from launch import Action, LaunchContext, LaunchDescription
from launch.actions import (
    DeclareLaunchArgument,
    EmitEvent,
    ExecuteLocal,
    GroupAction,
    IncludeLaunchDescription,
    LogInfo,
    OpaqueCoroutine,
    OpaqueFunction,
    RegisterEventHandler,
    TimerAction,
)
from launch.conditions import IfCondition
from launch.launch_description_sources import AnyLaunchDescriptionSource
from launch.utilities import normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import perform_typed_substitution
from launch_ros.actions import (
    ComposableNodeContainer,
    LifecycleNode,
    LifecycleTransition,
    LoadComposableNodes,
    Node,
    ROSTimer,
    SetUseSimTime,
)
from launch_ros.actions.load_composable_nodes import _sourced_parameters, get_composable_node_load_request
from launch_ros.descriptions import ComposableNode
from launch_ros.events.lifecycle import ChangeState
from launch_ros.substitutions.executable_in_package import LeftOut

from day6_core.ros.ros2.launch._plan_node import node_facts

Facts = dict[str, Any]

MOST_WAITING = 200
"""How much of what waits is followed: what starts itself again would never end."""

_EVENTS = {
    "OnProcessExit": "exit",
    "OnProcessStart": "start",
    "OnProcessIO": "output",
    "OnExecutionComplete": "complete",
    "OnShutdown": "shutdown",
    "OnStateTransition": "transition",
}
"""Class of a handler -> what it waits for; any other one is told by its own description."""


class Planner:
    """Visits a launch file; `items` are what it found, in order, each with what it waits for in `when`."""

    def __init__(self, path: str, arguments: Iterable[tuple[str, str]]) -> None:
        self.context = LaunchContext(noninteractive=True)
        self._environment = dict(os.environ)
        self._given = dict(arguments)
        self._path = path
        self._when: list[Facts] = []
        self._waiting: deque[tuple[list[Facts], Any, dict[str, Any], RegisterEventHandler | None]] = deque()
        self.items: list[Facts] = []
        self.arguments: list[Facts] = []
        self.files: list[str] = []
        self.error = ""

    def run(self) -> None:
        """Visit everything; `error` is what would end the launch before anything starts."""
        source = AnyLaunchDescriptionSource(self._path)
        include = IncludeLaunchDescription(source, launch_arguments=list(self._given.items()))
        try:
            self._visit(LaunchDescription([include]))
        except Exception as error:  # of the launch file: told as the launch would tell it
            self.error = f"{type(error).__name__}: {error}"
            return
        for _ in range(MOST_WAITING):
            if not self._waiting:
                return
            self._follow(*self._waiting.popleft())
        self._add("unknown", why="endless")

    def _follow(
        self, when: list[Facts], entities: Any, known: dict[str, Any], registered: RegisterEventHandler | None
    ) -> None:
        if registered is not None and registered.event_handler not in self.context._event_handlers:
            return  # taken away again
        self._when = when
        if callable(entities):
            self._add("unknown", why="function")
            return
        self.context._push_locals()
        self.context.extend_locals(known)
        try:
            for entity in entities if isinstance(entities, Iterable) else [entities]:
                self._visit(entity)
        except Exception as error:  # may be because the event isn't known: what comes after it isn't, either
            self._add("unknown", why="error", error=f"{type(error).__name__}: {error}")
        finally:
            self.context._pop_locals()

    # -- visiting ------------------------------------------------------------------------------------------------------

    def _visit(self, entity: Any) -> None:
        condition = entity.condition if isinstance(entity, Action) else None
        if condition is not None and not condition.evaluate(self.context):
            entities = _named(entity) or [type(entity).__name__]
            self._add("left_out", entities=entities, condition=self._condition(condition))
            return
        plan = next(function for kind, function in _PLANS if isinstance(entity, kind))
        for each in plan(self, entity) or ():
            self._visit(each)

    def _add(self, kind: str, **facts: Any) -> Facts:
        item = {"kind": kind, **({"when": self._when} if self._when else {}), **facts}
        self.items.append(item)
        return item

    def _wait(self, trigger: Facts, entities: Any, registered: RegisterEventHandler | None = None) -> None:
        known = {} if registered else dict(self.context.get_locals_as_dict())
        self._waiting.append(([*self._when, trigger], entities, known, registered))

    def _condition(self, condition: Any) -> Facts:
        if not isinstance(condition, IfCondition):
            return {"text": condition.describe()}
        word, expression = condition._told
        text = " + ".join(each.describe() for each in expression)
        return {"word": word, "text": text, "value": perform_substitutions(self.context, expression)}

    def _anything(self, entity: Any) -> Any:
        return entity.visit(self.context)

    def _nothing(self, entity: Any) -> None:
        """Of the launch itself: it starts nothing and sets nothing that the plan tells."""

    def _include(self, entity: IncludeLaunchDescription) -> Any:
        following = entity.visit(self.context)
        self.files.append(os.path.abspath(entity.launch_description_source.location))
        return following

    def _argument(self, entity: DeclareLaunchArgument) -> None:
        configurations = self.context.launch_configurations
        origin = "default" if entity.name not in configurations else "launch_file"
        entity.visit(self.context)
        value = configurations[entity.name]
        if origin == "launch_file" and self._given.get(entity.name) == value:
            origin = "given"
        argument = {"name": entity.name, "value": value, "origin": origin}
        if argument not in self.arguments:  # a file may be included twice
            self.arguments.append(argument)

    def _function(self, entity: OpaqueFunction) -> Any:
        if any(trigger["wait"] != "timer" for trigger in self._when):
            self._add("unknown", why="function")
            return None
        return entity.visit(self.context)

    def _coroutine(self, entity: OpaqueCoroutine) -> None:
        self._add("unknown", why="coroutine")

    def _timer(self, entity: TimerAction) -> None:
        seconds = perform_typed_substitution(self.context, entity.period, float)
        clock = "ros" if isinstance(entity, ROSTimer) else "wall"
        self._wait({"wait": "timer", "seconds": seconds, "clock": clock}, entity.actions)

    def _handler(self, entity: RegisterEventHandler) -> None:
        entity.visit(self.context)
        handler: Any = entity.event_handler
        _, entities = handler.describe()
        wait = next((_EVENTS[kind.__name__] for kind in type(handler).__mro__ if kind.__name__ in _EVENTS), "event")
        trigger: Facts = {"wait": wait}
        target = getattr(handler, "_OnActionEventBase__action_matcher", None)
        target = getattr(handler, "_OnStateTransition__target", target)
        if isinstance(target, ExecuteLocal) and target.process_details is not None:
            trigger["of"] = target.process_details["name"]
        elif target is not None:
            trigger["of"] = ""  # a function chooses, or it hasn't been visited
        if wait == "event":
            trigger["text"] = handler.matcher_description or ""
        at_end = getattr(handler, "_OnShutdown__on_shutdown", None)
        self._wait(trigger, at_end or entities or handler.handle, entity)

    def _transitions(self, entity: Any) -> None:
        def texts(many: Any) -> list[str]:
            return [perform_substitutions(self.context, each) for each in many]

        numbers = texts(entity._LifecycleTransition__ids)
        steps = [
            ChangeState.valid_transitions.get(int(each), each).removeprefix("TRANSITION_").lower() for each in numbers
        ]
        self._add("transitions", nodes=texts(entity._LifecycleTransition__names), steps=steps)

    def _event(self, entity: EmitEvent) -> None:
        reason = getattr(entity.event, "reason", None)
        self._add("event", event=entity.event.name, **({"reason": str(reason)} if reason else {}))

    # -- what would start ----------------------------------------------------------------------------------------------

    def _process(self, entity: Any, kind: str = "process") -> Facts | None:
        try:
            entity.prepare(self.context)
        except LeftOut as error:
            self._add("cannot_start", entities=_named(entity), error=str(error))
            return None
        details = entity.process_details
        facts = {"process": details["name"], "command": details["cmd"], "environment": self._changed(entity)}
        if details["cwd"] is not None:
            facts["folder"] = details["cwd"]
        if entity._ExecuteLocal__respawn:
            facts["respawn"] = True
        item = self._add(kind, **facts)
        on_exit = entity._ExecuteLocal__on_exit
        if on_exit is not None:
            self._wait({"wait": "exit", "of": details["name"]}, on_exit)
        return item

    def _changed(self, entity: ExecuteLocal) -> dict[str, str]:
        """Return the variables that differ from those that the launch itself was started with."""
        final = entity.process_details["env"] or {}
        return {name: value for name, value in sorted(final.items()) if self._environment.get(name) != value}

    def _node(self, entity: Node) -> Facts | None:
        item = self._process(entity, "node")
        if item is None:
            return None
        for key, given in (("package", entity.node_package), ("executable", entity.node_executable)):
            if given is not None:
                item[key] = perform_substitutions(self.context, normalize_to_list_of_substitutions(given))
        before = len(item["command"]) - len(entity.process_description.cmd)
        if before:
            item["prefix"] = item["command"][:before]
        item |= node_facts(entity, item["command"][before:])
        if isinstance(entity, LifecycleNode):
            item["lifecycle"] = "active" if entity.node_autostart else "unconfigured"
        return item

    def _only_process(self, entity: ExecuteLocal) -> None:
        self._process(entity)

    def _only_node(self, entity: Node) -> None:
        self._node(entity)

    def _container(self, entity: Any) -> None:
        item = self._node(entity)
        if item is not None:
            item["components"] = self._components(entity._ComposableNodeContainer__composable_node_descriptions)

    def _load(self, entity: Any) -> None:
        target: Any = entity._LoadComposableNodes__target_container
        name = target.node_name if isinstance(target, Node) else perform_substitutions(self.context, target)
        components = self._components(entity._LoadComposableNodes__composable_node_descriptions)
        self._add("components", container=name, components=components)

    def _components(self, descriptions: Iterable[ComposableNode]) -> list[Facts]:
        found = []
        for each in descriptions:
            request = get_composable_node_load_request(each, self.context)
            if request is None:
                condition = self._condition(each.condition())
                self._add("left_out", entities=[_described(each.node_plugin)], condition=condition)
                continue
            values = _sourced_parameters(self.context, each, request).items()
            name = f"{request.node_namespace.rstrip('/')}/{request.node_name}" if request.node_name else ""
            found.append(
                {
                    "name": name,
                    "package": request.package_name,
                    "plugin": request.plugin_name,
                    "parameters": [{"name": key, "value": value, "source": source} for key, (value, source) in values],
                    "remaps": list(request.remap_rules),
                }
            )
        return found


_PLANS: tuple[tuple[type, Callable[[Planner, Any], Any]], ...] = (
    (LoadComposableNodes, Planner._load),
    (ComposableNodeContainer, Planner._container),
    (Node, Planner._only_node),
    (ExecuteLocal, Planner._only_process),
    (IncludeLaunchDescription, Planner._include),
    (DeclareLaunchArgument, Planner._argument),
    (OpaqueFunction, Planner._function),
    (OpaqueCoroutine, Planner._coroutine),
    (TimerAction, Planner._timer),
    (RegisterEventHandler, Planner._handler),
    (LifecycleTransition, Planner._transitions),
    (EmitEvent, Planner._event),
    (LogInfo, Planner._nothing),
    (SetUseSimTime, Planner._nothing),
    (object, Planner._anything),
)
"""Class of an entity -> what is done with it in place of executing it; it returns what to visit next. The first one counts."""


def _named(entity: Any) -> list[str]:
    """Return what an entity would start, as far as it is known without executing it."""
    if isinstance(entity, Node):
        package = "" if entity.node_package is None else f"{_described(entity.node_package)} "
        return [f"{package}{_described(entity.node_executable)}"]
    if isinstance(entity, ExecuteLocal):
        return [" ".join(_described(word) for word in entity.process_description.cmd)]
    if isinstance(entity, IncludeLaunchDescription):
        return [os.path.basename(entity.launch_description_source.described_location.strip("'"))]
    if isinstance(entity, GroupAction):
        return [name for each in entity.get_sub_entities() for name in _named(each)]
    return []


def _described(given: Any) -> str:
    return " + ".join(each.describe() for each in normalize_to_list_of_substitutions(given)).replace("'", "")


def plan_of(path: str, arguments: Iterable[tuple[str, str]]) -> Facts:
    """Return what a launch of the file would do."""
    planner = Planner(path, arguments)
    planner.run()
    return {
        "file": os.path.abspath(path),
        "includes": planner.files[1:],
        "arguments": planner.arguments,
        "items": planner.items,
        "error": planner.error,
    }


def show_plan(options: Facts) -> int:
    """Print the plan; the status is that of a launch that could not start where this one couldn't."""
    import logging
    import tempfile
    from contextlib import redirect_stdout

    import launch.logging

    with tempfile.TemporaryDirectory() as folder:  # no launch: nothing in ~/.ros/log
        launch.logging.launch_config.log_dir = folder
        launch.logging.launch_config.screen_handler = launch.logging.handlers.StreamHandler(sys.stderr)
        launch.logging.launch_config.level = logging.WARNING
        with redirect_stdout(sys.stderr):  # what the launch file prints is no part of the plan
            plan = plan_of(options["path"], options["arguments"])
        launch.logging.reset()
        logging.shutdown()
    if options["json"]:
        print(json.dumps(plan, ensure_ascii=False, indent=2, default=str))
    else:
        from day6_core.ros.ros2.launch._plan_text import lines_of

        print("\n".join(lines_of(plan, options["language"])))
    return 1 if plan["error"] else 0

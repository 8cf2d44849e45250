"""Shows a launch description without launching it."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from launch.actions import EmitEvent, ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handler import BaseEventHandler
from launch.launch_description import LaunchDescription
from launch.launch_description_entity import LaunchDescriptionEntity
from launch.utilities import normalize_to_list_of_substitutions

_STEP = 4


class LaunchIntrospector:
    """Formats launch descriptions for `ros2 launch --print`."""

    def format_launch_description(self, launch_description: LaunchDescription) -> str:
        """Return the tree of a launch description's entities."""
        lines: list[tuple[int, str]] = []
        for entity in launch_description.entities:
            lines += _entity_lines(entity, 1)
        return f"{launch_description}\n" + "\n".join(_tree(lines))


def _entity_lines(entity: LaunchDescriptionEntity, depth: int) -> list[tuple[int, str]]:
    """Return `(depth, text)` for an entity and those below it."""
    if isinstance(entity, LogInfo):
        return [(depth, f"LogInfo({_text(entity.msg)})")]
    if isinstance(entity, EmitEvent):
        return [(depth, f"EmitEvent(event='{entity.event.name}')")]
    if isinstance(entity, ExecuteProcess):
        return [(depth, _process_text(entity))]
    if isinstance(entity, RegisterEventHandler):
        first = (depth, f"RegisterEventHandler('{entity.event_handler}'):")
        return [first, *_handler_lines(entity.event_handler, depth + 1)]
    return [(depth, f"Action('{entity}')")]


def _handler_lines(handler: BaseEventHandler, depth: int) -> list[tuple[int, str]]:
    description, entities = handler.describe()
    lines = [(depth, description)]
    for entity in [entities] if isinstance(entities, LaunchDescriptionEntity) else entities:
        lines += _entity_lines(entity, depth + 1)
    return lines


def _process_text(action: ExecuteProcess) -> str:
    command = ", ".join(_text(part) for part in action.cmd)
    folder = None if action.cwd is None else f"'{_text(action.cwd)}'"
    env: Any = action.env
    if env is not None:
        env = "{" + ", ".join(f"{_text(key)}: {_text(value)}" for key, value in env) + "}"
    return f"ExecuteProcess(cmd=[{command}], cwd={folder}, env={env}, shell={action.shell})"


def _text(substitutions: Any) -> str:
    return " + ".join(each.describe() for each in normalize_to_list_of_substitutions(substitutions))


def _tree(lines: Iterable[tuple[int, str]]) -> list[str]:
    """Draw the branches; a line is the last of its branch unless the next one is at its depth or deeper."""
    wanted = list(lines)
    drawn = []
    for number, (depth, text) in enumerate(wanted):
        following = wanted[number + 1][0] if number + 1 < len(wanted) else 0
        branch = "├── " if following >= depth else "└── "
        start = "│" if depth > 1 else ""
        drawn.append(start + " " * (_STEP * (depth - 1) - len(start)) + branch + text)
    if drawn and drawn[-1].startswith("│"):
        drawn[-1] = " " + drawn[-1][1:]
    return drawn

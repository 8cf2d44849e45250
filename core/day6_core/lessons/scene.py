"""Scenes: what is typed for whoever chose it, by the files of the folder `scenes` (writing/en.md, "Scenes").

Their texts are shown in the first frame of the desktop, so these files are read without YAML, which takes 16 ms and 1.5 MB.
"""

from __future__ import annotations

import json
from collections.abc import Iterable, Iterator, Mapping
from functools import cache
from pathlib import Path
from typing import Any, NamedTuple

from day6_core.lessons.blocks import blocks


class SceneTexts(NamedTuple):
    """What a scene is called in one language."""

    title: str
    more: str = ""
    """What stands below the title."""
    help: str = ""
    """What it types; '' for a scene that is offered at the start alone."""
    short: str = ""
    """Its name in the list of a class."""


class Scene(NamedTuple):
    """A scene's name, its texts by language and what it does."""

    name: str
    texts: Mapping[str, SceneTexts]
    actions: tuple[Mapping[str, Any], ...] = ()

    @property
    def is_action(self) -> bool:
        """Whether it can be chosen at any time."""
        return any(each.help for each in self.texts.values())


_PARTS = {"": "more", "do": "help", "teacher": "short"}


@cache
def scenes() -> Mapping[str, Scene]:
    """All scenes by name, in the order of their files. Raises ValueError for actions that aren't JSON."""
    found = map(_scene, sorted((Path(__file__).parent / "scenes").glob("*.md")))
    return {scene.name: scene for scene in found}


def _scene(path: Path) -> Scene:
    name = language = part = ""
    texts: dict[str, SceneTexts] = {}
    actions: list[Mapping[str, Any]] = []
    for block in blocks(path.read_text(encoding="utf-8").split("\n"), 1):
        if block.kind == "#":
            name = block.text
        elif block.kind == "##":
            language, _, title = block.text.partition(" ")
            texts[language], part = SceneTexts(title), ""
        elif block.kind == "###":
            part = block.text
        elif block.kind == "json":
            actions = json.loads(block.text)
        elif not block.kind:
            texts[language] = texts[language]._replace(**{_PARTS[part]: block.text})
    return Scene(name, texts, tuple(actions))


def below(actions: Iterable[Mapping[str, Any]], namespace: str) -> Iterator[Mapping[str, Any]]:
    """The actions in a namespace, for who shares a graph with others. What is launched keeps its names."""
    for action in actions:
        ((name, value),) = action.items()
        if name == "type" and value.startswith("ros2 run "):
            value += f" --ros-args -r __ns:=/{namespace}"
        elif name == "type":
            value = value.replace("ros2 topic echo /", f"ros2 topic echo /{namespace}/")
        elif name == "heard":
            value = f"/{namespace}{value}"
        elif name == "wait" and "topic" in value:
            value = {"topic": f"/{namespace}{value['topic']}"}
        yield {name: value}

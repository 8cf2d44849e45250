"""The files of scenes: what the lessons' reader takes, and what it refuses."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.lessons.actions import MOST_PAUSE
from day6_core.lessons.reading import read_scene
from day6_core.lessons.scene import Scene, below, scenes
from day6_core.lessons.source import LANGUAGES, LessonMistakes

TEXTS = "\n## zh 标题\n\n下一行\n\n## en Title\n\nthe line below\n"


def read(folder: Path, block: str) -> list[str]:
    """Return the mistakes of a scene with this block."""
    path = folder / "1_scene.md"
    path.write_text(f"# scene\n\n~~~yaml\n{block}\n~~~\n{TEXTS}", encoding="utf-8")
    with pytest.raises(LessonMistakes) as refused:
        read_scene(path)
    return [f"{each.line}: {each.text}" for each in refused.value.mistakes]


@pytest.mark.parametrize("scene", scenes().values(), ids=lambda scene: scene.name)
def test_a_scene_is_as_it_should_be_and_all_its_texts_are_there(scene: Scene) -> None:
    actions = read_scene(scene.path)
    assert bool(actions) == scene.is_action and tuple(scene.texts) == LANGUAGES
    for texts in scene.texts.values():
        assert texts.title and texts.more and texts.short and bool(texts.help) == scene.is_action


def test_a_mistake_in_a_scene_is_named_with_its_line(tmp_path: Path) -> None:
    told = read(tmp_path, "play:\n  - type: ls\n  - write: {file: ~/a, text: b}\n  - look: -1")
    assert [each.partition(";")[0] for each in told] == [
        "6: play: there is no action 'write'",
        f"7: play: look: a number of seconds from 0 to {MOST_PAUSE:g}",
    ]
    assert read(tmp_path, "solve: []") == ["4: unknown key 'solve'; there are play"]


def test_in_a_room_a_scene_is_below_the_pupils_name() -> None:
    found = list(below(read_scene(scenes()["turtle"].path), "anna"))
    lines = [each["type"] for each in found if "type" in each]
    assert lines == [
        "ros2 run turtlesim turtlesim_node --ros-args -r __ns:=/anna",
        "ros2 topic echo /anna/turtle1/cmd_vel",
        "ros2 run turtlesim turtle_teleop_key --ros-args -r __ns:=/anna",
    ]
    assert {"heard": "/anna/turtle1/cmd_vel"} in found
    assert {"wait": {"topic": "/anna/robot_description"}} in list(below(read_scene(scenes()["car"].path), "anna"))

"""The files of scenes, and what becomes of them in a room."""

from __future__ import annotations

import pytest

from day6_core.language import LANGUAGES
from day6_core.lessons.actions import action_mistake
from day6_core.lessons.scene import Scene, below, scenes
from day6_core.lessons.scene_player import ScenePlayer

NAMES = [name.removeprefix("_do_") for name in dir(ScenePlayer) if name.startswith("_do_") and name != "_do_line"]


@pytest.mark.parametrize("scene", scenes().values(), ids=lambda scene: scene.name)
def test_a_scene_is_as_it_should_be_and_all_its_texts_are_there(scene: Scene) -> None:
    assert [mistake for mistake in (action_mistake(each, NAMES) for each in scene.actions) if mistake] == []
    assert bool(scene.actions) == scene.is_action and tuple(scene.texts) == LANGUAGES
    for texts in scene.texts.values():
        assert texts.title and texts.more and texts.short and bool(texts.help) == scene.is_action


def test_what_no_scene_can_do_is_a_mistake() -> None:
    assert action_mistake({"write": {"file": "~/a", "text": "b"}}, NAMES).startswith("there is no action 'write'")
    assert action_mistake({"look": -1}, NAMES).startswith("look: a number of seconds")


def test_in_a_room_a_scene_is_below_the_pupils_name() -> None:
    found = list(below(scenes()["turtle"].actions, "anna"))
    lines = [each["type"] for each in found if "type" in each]
    assert lines == [
        "ros2 run turtlesim turtlesim_node --ros-args -r __ns:=/anna",
        "ros2 topic echo /anna/turtle1/cmd_vel",
        "ros2 run turtlesim turtle_teleop_key --ros-args -r __ns:=/anna",
    ]
    assert {"heard": "/anna/turtle1/cmd_vel"} in found
    assert {"wait": {"topic": "/anna/robot_description"}} in list(below(scenes()["car"].actions, "anna"))

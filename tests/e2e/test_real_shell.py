"""`day6-tui shell` as a person uses it: Tab, the commands of ROS, and windows that take the terminal."""

from __future__ import annotations

import shutil
from typing import TYPE_CHECKING

import pytest

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person


def shell(place: Place, name: str) -> Terminal:
    """A `day6-tui shell` of a user without settings, ready for a line."""
    path = shutil.which(name)
    if path is None:
        pytest.skip(f"there is no {name} here")
    place.home.mkdir(exist_ok=True)
    (place.home / f".{name}rc").write_text("PS1='ready> '\n", encoding="utf-8")
    (place.work / "robot.urdf").write_text("<robot/>", encoding="utf-8")
    screen = place.terminal("shell", SHELL=path, HOME=str(place.home), columns=100, ZDOTDIR=None, LC_ALL="C.UTF-8")
    screen.wait("(day6) ready>")
    return screen


LINES = (
    (("ros2 topi\t", "ros2 topic"), ("ec\t", "ros2 topic echo"), ("--o\t", "ros2 topic echo --once")),
    (
        ("ros2 launch day6_b\t", "launch day6_bot"),
        ("dis\t", "day6_bot display.launch.py"),
        ("spi\t", "display.launch.py spin:="),
        ("f\t", "display.launch.py spin:=false"),
    ),
    (("ros2 topic pub /a std_msgs/msg/Stri\t", "msg/String"), ("\t", "msg/String \"{data: ''}\"")),
    (("colcon bu\t", "colcon build"), ("--packages-up-to-\t", "colcon build --packages-up-to-regex")),
    (("day6-tui check\t", "day6-tui check_urdf"), ("rob\t", "day6-tui check_urdf robot.urdf")),
    (("check_urdf rob\t", "> check_urdf robot.urdf"),),
    (("true && ros2 run turtlesim dr\t", "> true && ros2 run turtlesim draw_square"),),
)
"""What is typed, and what the line then shows."""


@pytest.mark.parametrize("name", ["bash", "zsh"])
def test_tab_completes_words_of_ros2_colcon_and_day6_tui(place: Place, name: str) -> None:
    with shell(place, name) as screen:
        for steps in LINES:
            for typed, shown in steps:
                screen.send(typed)
                screen.wait(shown)
            # Not by Ctrl-C: bash and zsh may miss one that comes while they finish a completion.
            screen.press("Ctrl-U")
            screen.wait(lambda seen: seen.rstrip().endswith("ready>"))


def test_every_command_of_ros_is_one_in_the_real_shell_too(place: Place) -> None:
    from day6_core.ros.executables import ros_commands

    with shell(place, "bash") as screen:
        screen.line(
            f"for each in {' '.join(ros_commands())} day6-tui; do type -P $each | grep -c /day6-tui/bin-; done | uniq -c"
        )
        screen.wait(f"{len(ros_commands()) + 1} 1")


@pytest.mark.parametrize("name", ["rqt", "rqt_bag", "rqt_graph", "rqt_console", "rqt_plot", "rqt_topic", "rviz2"])
def test_a_program_with_a_window_takes_the_terminal_by_its_name_and_gives_it_back(place: Place, name: str) -> None:
    with place.terminal(name, DAY6_LANG="en") as screen:
        screen.wait(lambda seen: " ".join(seen.split()).count("F1 Help"), "End")
        screen.press("Ctrl-C")
        assert screen.wait_end() in (0, 130)
        assert "Traceback" not in screen.look()

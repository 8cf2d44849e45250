"""Everything by mouse in a real terminal: choosing, giving the keyboard, looking back, copying, sliders, RViz, closing."""

from __future__ import annotations

from typing import TYPE_CHECKING

import pytest

from day6_urdf.shipped import shipped_model
from tests.e2e.mouse import MIDDLE, Mouse

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person


def test_the_mouse_chooses_gives_the_keyboard_and_closes(place: Place) -> None:
    with place.desktop(columns=120, rows=40) as screen:
        mouse = Mouse(screen)
        screen.wait("student@day6:~$")
        mouse.click_on("Drive the turtle")
        screen.wait("x 5.54  y 5.54", "'q' to quit")
        mouse.click_on("TurtleSim")
        screen.wait("┏ 2 TurtleSim", "Arrow keys work only in here: click or")
        screen.press("Up")
        mouse.click_on("Use arrow keys to move")
        screen.wait_gone("Arrow keys work only in here")
        assert "x 5.54  y 5.54" in screen.look()
        screen.press("Up")
        screen.wait("x 7.56  y 5.54")
        mouse.click_on("1 turtlesim_node")
        screen.wait("┏ 1 turtlesim_node", "ros2 run turtlesim turtlesim_node")
        column, row = mouse.find("2 TurtleSim")
        mouse.click(screen._picture.display[row].index(" × ", column) + 1, row)
        screen.wait_gone("2 TurtleSim")
        screen.wait("1 ~")


def test_the_wheel_looks_back_and_dragging_copies_what_the_middle_button_pastes(place: Place) -> None:
    with place.desktop("--scene", "empty", columns=120, rows=40) as screen:
        mouse = Mouse(screen)
        screen.wait("student@day6:~$")
        screen.line("seq 1 100; echo echo 小海龟 pasted")
        screen.wait_lines("100", "echo 小海龟 pasted")
        mouse.wheel(10, 10, 10)
        screen.wait("30 more lines below")
        screen.wait_lines("60")
        mouse.wheel(10, 10, -10)
        screen.wait_lines("echo 小海龟 pasted")
        column, row = mouse.find("echo 小海龟 pasted")
        mouse.drag((column, row), (column + 6, row), (column + len("echo ...... pasted"), row))
        mouse.click(10, 5, MIDDLE)
        screen.wait("~$ echo 小海龟 pasted")
        screen.press("Enter")
        screen.wait_lines("小海龟 pasted")


def test_sliders_are_dragged_and_the_view_of_rviz_is_turned(place: Place) -> None:
    place.home_file("car.urdf", shipped_model().read_text(encoding="utf-8"))
    with place.desktop("--scene", "empty", columns=140, rows=44) as screen:
        mouse = Mouse(screen)
        screen.wait("student@day6:~$")
        screen.line(
            "clear; ros2 run robot_state_publisher robot_state_publisher car.urdf 2> /dev/null & rviz2 -f base_link &"
        )
        screen.wait("╭ 2 RViz")
        screen.line("ros2 run joint_state_publisher_gui joint_state_publisher_gui &")
        screen.wait("left_wheel_joint", "0.000 rad")
        _, row = mouse.find("-3.14")
        knob = screen._picture.display[row].index("●")
        mouse.drag((knob, row), (knob + 5, row), (knob + 10, row))
        screen.wait("┏ 3 Joint State Publisher", lambda seen: seen.count("0.000 rad") == 1)
        before = [line[110:138] for line in screen.wait("╭ 2 RViz").split("\n")[3:15]]
        mouse.drag((120, 10), (124, 11), (130, 12))
        screen.wait("┏ 2 RViz", lambda seen: [line[110:138] for line in seen.split("\n")[3:15]] != before)


def test_a_click_on_a_tab_shows_it_though_the_places_change_under_the_mouse(place: Place) -> None:
    with place.desktop("--scene", "empty") as screen:
        mouse = Mouse(screen)
        screen.wait("student@day6:~$")
        screen.line("rviz2")
        screen.wait("2 RViz", "RViz is ready")
        screen.press("F2")
        screen.wait("┏ 3 ~")
        screen.line("echo th''ree; sleep 1000")
        screen.wait_lines("three")
        screen.press("F2")
        screen.wait("4 ~ ━")
        screen.press("F6")
        screen.wait("no fault found")
        for text, tab in [("three", "3 sleep"), ("no fault found", "5 Inspector")] * 2:
            screen.press("Alt-4")
            screen.wait("4 ~ ━")
            mouse.click_on(tab)
            screen.wait(text, lambda seen, tab=tab: "┏ 3 sleep" in seen)

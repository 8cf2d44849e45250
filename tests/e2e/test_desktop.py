"""The desktop in a real terminal: what one sees, types and gets, from the welcome to the end."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.support.waiting import until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

termios = pytest.importorskip("termios", reason="this system has no pseudo-terminals to try the screen in")

SIZES_AND_LANGUAGES = [(80, 24, "zh"), (80, 24, "en"), (120, 40, "zh"), (120, 40, "en")]
WELCOME = {
    "zh": ("驾驶小海龟", "让小车的轮子转起来", "开着小车去闯一闯", "上课", "空桌面"),
    "en": ("Drive the turtle", "Make the car's wheels turn", "Drive the car in a world", "Lessons", "An empty desk"),
}
QUIT_SECONDS = 10.0
"""Far more than quitting takes; programs that have to be ended by force would take longer."""


def leave(screen: Terminal, place: Place) -> None:
    """Quit as the key bar says, and see that nothing stays behind: no process, no mode of the terminal."""
    screen.quit()
    assert screen.wait_end(QUIT_SECONDS) == 0
    until(lambda: place.processes() == {})  # the guard looks once more when the desktop is gone
    modes = screen.attributes()[3]
    assert modes & termios.ECHO and modes & termios.ICANON and modes & termios.ISIG
    end = bytes(screen.output)
    end = end[end.rindex(b"\x1b[?1049h") :]
    for restored in (b"\x1b[?1049l", b"\x1b[?25h", b"\x1b[?1000l", b"\x1b[?2004l"):
        assert restored in end, restored
    assert b"Traceback" not in end


@pytest.mark.parametrize(("columns", "rows", "lang"), SIZES_AND_LANGUAGES)
def test_the_welcome_is_there_and_quitting_leaves_nothing_behind(
    place: Place, columns: int, rows: int, lang: str
) -> None:
    with place.desktop(columns=columns, rows=rows, lang=lang) as screen:
        seen = screen.wait(*WELCOME[lang], "student@day6:~$", "^Q")
        assert all(f" {number}  {text}" in seen for number, text in enumerate(WELCOME[lang], start=1))
        leave(screen, place)


def test_a_line_that_sources_another_distribution_starts_the_desktop_again_as_it(place: Place) -> None:
    with place.desktop(columns=120, rows=40) as screen:
        screen.wait("student@day6:~$")
        screen.send("source /opt/ros/lyrical/setup.bash && echo $ROS_DISTRO is here\r")
        assert "this desktop is ROS 2 jazzy" in screen.wait("lyrical is here", "[from 20")
        leave(screen, place)


@pytest.mark.parametrize(("columns", "rows", "lang"), [(80, 24, "zh"), (120, 40, "en")])
def test_key_1_drives_the_turtle_and_every_tool_tells_the_truth(
    place: Place, columns: int, rows: int, lang: str
) -> None:
    with place.desktop(columns=columns, rows=rows, lang=lang) as screen:
        screen.wait(WELCOME[lang][0], "student@day6:~$")
        # The arrow key is typed while the commands are: it waits for the teleop it is meant for.
        screen.press("1")
        screen.wait("student@day6:~$ ros2")
        screen.press("Up")
        screen.wait("x 7.56  y 5.54  θ 0.00", "3 echo /turtle1/cmd_vel", "4 turtle_tele")
        screen.wait_lines("x: 2.0", "angular:", "---")  # seen at the same moment

        screen.press("F2", "F8")
        screen.wait("5 ~")
        screen.line("ros2 node list")
        screen.wait_lines("/teleop_turtle", "/turtlesim")
        screen.line("clear; ros2 topic list")
        screen.wait_lines("/parameter_events", "/rosout", "/turtle1/cmd_vel", "/turtle1/color_sensor", "/turtle1/pose")

        screen.press("F8")
        until(lambda: "Subscription count: 2" in place.run("ros2", "topic", "info", "/turtle1/cmd_vel").stdout)
        screen.press("Alt-4")
        screen.wait("'q' to quit.")
        screen.press("Up")
        screen.wait("x 9.58")

        screen.press("Alt-5")
        screen.line("clear; rqt_graph")
        screen.wait("rqt_graph  ", "/teleop_turtle", "/turtlesim", "/turtle1/cmd_vel")

        screen.press("Alt-1")
        screen.wait("┏ 1 turtlesim", "[INFO]")
        screen.press("Ctrl-C")
        screen.wait_gone("TurtleSim")
        screen.line("clear; ros2 node list")
        screen.wait_lines("/teleop_turtle", "student@day6:~$")
        screen.wait(lambda _: "/turtlesim" not in screen.pieces())  # rqt_graph, too, is drawn a moment later
        leave(screen, place)


def test_the_scene_of_the_command_line_begins_at_once(place: Place) -> None:
    with place.desktop("--scene", "turtle", "--reduced-motion") as screen:
        screen.wait("x 5.54", "'q' to quit.")
        screen.press("q")
        screen.wait_lines("student@day6:~$")
        screen.press("Ctrl-D")
        screen.wait_gone("2 turtle")


def test_another_terminal_opened_during_a_scene_gets_nothing_of_it(place: Place) -> None:
    with place.desktop() as screen:
        screen.wait("Drive the turtle", "student@day6:~$")
        screen.press("1")
        screen.wait("TurtleSim", "3 ~", "student@day6:~$ ros2")
        screen.press("F2")
        screen.line("echo mine")
        screen.wait_lines("student@day6:~$ echo mine", "mine")
        screen.wait("turtle_tele", "^Q")
        assert "not found" not in screen.look()
        screen.press("Alt-5")
        screen.wait("'q' to quit.")


def test_keys_mean_what_the_bar_says(place: Place) -> None:
    with place.desktop(columns=120) as screen:
        screen.wait("Drive the turtle", "student@day6:~$")
        screen.press("F1")
        screen.wait("Keys that work everywhere")
        screen.press("Esc")
        screen.wait_gone("Keys that work everywhere")
        screen.press("F7")
        screen.wait("type to search")
        screen.send("language")
        screen.wait("中文 / English")
        screen.press("Enter")
        screen.wait("驾驶小海龟", "F2  终端")
        screen.press("F9")
        screen.wait("F9  继续")
        screen.press("F9")
        screen.wait("F9  暂停")


def test_keys_pressed_one_upon_the_other_reach_the_pane_they_are_meant_for(place: Place) -> None:
    with place.desktop("--scene", "empty", columns=120, rows=40) as screen:
        screen.wait("student@day6:~$")
        screen.line("rqt_graph & ros2 run turtlesim turtlesim_node > out 2>&1 &")
        screen.wait("2 rqt_graph", "3 TurtleSim")
        screen.press("F3", "F3", "F3", "F3", "F3", "F3", "echo he''re", "Enter")
        screen.wait_lines("here")
        screen.wait(lambda seen: seen.split("\n")[-1].strip().startswith("F2"))


def test_up_brings_back_commands_and_tab_completes(place: Place) -> None:
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.send("ros2 run turtlesim turtlesim_n\t")
        screen.wait("ros2 run turtlesim turtlesim_node")
        screen.press("Ctrl-C")
        screen.line("echo o''ne")
        screen.wait_lines("one")
        screen.press("Up")
        screen.wait(lambda seen: seen.count("echo o''ne") == 2)
        screen.line(" two")
        screen.wait_lines("one two")


def test_jobs_pipes_and_signals_in_a_terminal(place: Place) -> None:
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("sleep 100 &")
        screen.wait(lambda seen: re.search(r"\[1] \d+", seen))
        screen.line("clear; jobs; kill %1")
        screen.wait_lines("[1]+  Running                 sleep 100 &")
        screen.line("")
        screen.wait_lines("[1]+  Terminated              sleep 100")
        screen.line("clear; timeout 0.1 sleep 5; echo status $?; ros2 pkg list | grep -c turtlesim")
        screen.wait_lines("status 124", "1")
        screen.line("clear; cat")
        screen.wait("1 cat")
        screen.line("typed")
        screen.wait(lambda seen: screen.pieces().count("typed") == 2)
        screen.press("Ctrl-C")
        screen.wait_lines("^C", "student@day6:~$")
        screen.line("echo status $?")
        screen.wait_lines("status 130")


def test_the_shell_ends_with_ctrl_d_and_another_one_is_there(place: Place) -> None:
    with place.desktop("--scene", "empty") as screen:
        screen.wait("student@day6:~$")
        screen.line("echo first")
        screen.wait_lines("first")
        screen.press("Ctrl-D")
        screen.wait_gone("first")
        screen.line("echo second")
        screen.wait_lines("second")


def test_closing_the_terminal_window_ends_the_desktop_and_its_programs(place: Place) -> None:
    place.home_file("idle.py", "import time\nprint('idle now', flush=True)\ntime.sleep(1000)\n")
    screen = place.desktop("--scene", "empty")
    with screen:
        screen.wait("student@day6:~$")
        screen.line("python3 idle.py")
        screen.wait_lines("idle now")
    # Leaving the block closes the pty, as a window manager does.
    until(lambda: place.processes() == {})


XTERM_LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    teleop = Node(package='turtlesim', executable='turtle_teleop_key', prefix='xterm -e', output='screen')
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node'), teleop])
"""


def test_a_launched_teleop_with_xterm_gets_a_terminal_of_its_own(place: Place) -> None:
    file = place.file("drive.launch.py", XTERM_LAUNCH)
    with place.desktop("--scene", "empty", columns=120, rows=40, lang="en") as screen:
        screen.wait("student@day6:~$")
        screen.line(f"ros2 launch '{file}'")
        screen.wait("turtle_teleop_key", "Use arrow keys to move the turtle.", "TurtleSim")
        screen.press("Up")
        screen.wait("x 7.56")
        screen.send("q")
        screen.wait("[xterm-2]: process has finished cleanly", "1 drive.launch.py")
        screen.press("Ctrl-C")
        screen.wait("student@day6:~$")
        screen.line("clear; xterm -e bash -c 'echo in th''ere; sleep 30' & sleep 1; kill -INT %1; wait; echo en''ded")
        screen.wait("in there")
        screen.wait_lines("ended")
        screen.wait_gone("2 bash")

"""A program with a window, started in a real terminal: it takes that terminal, and gives it back as it was."""

from __future__ import annotations

import os
import shlex
import signal
from pathlib import Path
from typing import TYPE_CHECKING

import pytest

from tests.e2e.place import DAY6
from tests.e2e.students import TALKER
from tests.support.waiting import communicate, until

if TYPE_CHECKING:
    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = pytest.mark.person

TURTLESIM = ("ros2", "run", "turtlesim", "turtlesim_node")
ENTER_SECOND_SCREEN, LEAVE_SECOND_SCREEN = "\x1b[?1049h", "\x1b[?1049l"
DRIVE = "{linear: {x: 1.5}, angular: {z: 0.0}}"


def turtlesim(place: Place) -> Terminal:
    """A terminal that shows the turtle's window."""
    screen = place.terminal(*TURTLESIM, DAY6_LANG="en")
    screen.wait("TurtleSim ", "x 5.54", "/turtlesim")
    return screen


def test_turtlesim_takes_the_terminal_and_moves_when_another_terminal_says_so(place: Place) -> None:
    with turtlesim(place) as screen:
        screen.wait("Spawning turtle [turtle1]", "End")
        done = place.run(
            *("ros2", "topic", "pub", "--once", "-w", "1", "/turtle1/cmd_vel", "geometry_msgs/msg/Twist", DRIVE)
        )
        assert done.returncode == 0, done.stderr
        screen.wait("x 7.06")


def test_q_ends_it_and_the_terminal_is_as_before_with_what_the_program_wrote(place: Place) -> None:
    with place.terminal("ros2", "run", "--help") as before:
        untouched = before.attributes()
        before.wait_end()
    with turtlesim(place) as screen:
        place.run("ros2", "service", "call", "/clear", "std_srvs/srv/Empty")
        screen.wait("[INFO] [turtlesim]: Clearing turtlesim.")
        screen.press("q")
        assert screen.wait_end() == 0
        while_shown, _, afterwards = screen.output.decode().rpartition(LEAVE_SECOND_SCREEN)
        assert "Starting turtlesim with node name /turtlesim" in while_shown.partition(ENTER_SECOND_SCREEN)[0]
        assert "Clearing turtlesim." in afterwards
        assert screen.attributes() == untouched
    assert place.nodes() == []


def test_where_letters_are_text_q_is_not_named_as_the_end(place: Place) -> None:
    with place.terminal("ros2", "run", "rqt_shell", "rqt_shell", DAY6_LANG="en") as screen:
        screen.wait("SimpleShell", "^C  End")
        assert "q ^C" not in "\n".join(screen.pieces())
        screen.press("q")
        screen.wait(">>> q")
        screen.press("Ctrl-C")
        assert screen.wait_end() == 0


def test_ctrl_c_is_answered_by_the_node(place: Place) -> None:
    with turtlesim(place) as screen:
        screen.press("Ctrl-C")
        assert screen.wait_end() == 0
        assert "[rclcpp]: signal_handler(SIGINT/SIGTERM)" in screen.look()


def test_help_and_the_log_lie_over_the_window(place: Place) -> None:
    with turtlesim(place) as screen:
        screen.press("F1")
        screen.wait("The world of turtlesim", "ends the program")
        screen.press("Esc")
        screen.wait_gone("ends the program")
        screen.send("\x1b[15~")
        screen.wait("Starting turtlesim with node")
        screen.press("q")
        screen.wait("x 5.54")
        screen.press("q")
        assert screen.wait_end() == 0


def test_kill_ends_it_with_the_terminal_in_order(place: Place) -> None:
    with turtlesim(place) as screen:
        screen.kill(signal.SIGTERM)
        assert screen.wait_end() == 128 + signal.SIGTERM
        assert "TurtleSim" not in screen.output.decode().rpartition(LEAVE_SECOND_SCREEN)[2]
        assert screen.output.count(b"1049h") == screen.output.count(b"1049l") == 1


def test_without_a_terminal_it_runs_and_logs(place: Place) -> None:
    process = place.start(*TURTLESIM)
    place.wait_nodes("/turtlesim")
    process.send_signal(signal.SIGINT)
    _, log = communicate(process)
    assert process.returncode == 0
    assert "Spawning turtle [turtle1]" in log and "\x1b" not in log


def test_in_the_background_of_a_real_shell_it_runs_and_logs(place: Place) -> None:
    if os.name != "posix":
        return
    from tests.e2e.terminal import Terminal

    env = {**place.environment(), "PS1": "$ "}
    with Terminal(["/bin/bash", "--norc", "-i"], 120, 24, cwd=place.work, env=env) as screen:
        screen.line(f"{shlex.join([*DAY6, *TURTLESIM])} &")
        screen.wait("Spawning turtle [turtle1]")
        place.wait_nodes("/turtlesim")
        assert "╭" not in screen.look() and "┏" not in screen.look()
        screen.line("kill %1; wait; echo over")
        screen.wait_lines("over")


def test_ctrl_z_gives_the_shell_its_terminal_and_fg_the_window(place: Place) -> None:
    if os.name != "posix":
        return
    from tests.e2e.terminal import Terminal

    env = {**place.environment(DAY6_LANG="en"), "PS1": "$ "}
    with Terminal(["/bin/bash", "--norc", "-i"], 120, 24, cwd=place.work, env=env) as screen:
        screen.line(shlex.join([*DAY6, *TURTLESIM]))
        screen.wait("x 5.54")
        screen.send("\x1a")
        screen.wait("Stopped")
        screen.line("fg")
        screen.wait("x 5.54", "TurtleSim")
        screen.press("q")
        screen.wait(lambda _: screen.output.count(LEAVE_SECOND_SCREEN.encode()) == 2)
        screen.line("echo status $?")
        screen.wait("status 0")


def test_rqt_graph_shows_a_students_node_in_its_window(place: Place) -> None:
    place.file("talker.py", TALKER)
    talker = place.start("python", "talker.py")
    place.wait_nodes("/day6_talker")
    with place.terminal("rqt_graph", columns=120, rows=40, DAY6_LANG="en") as screen:
        screen.wait("day6_talker", "rqt_graph")
        talker.kill()
        talker.communicate()
        screen.wait_gone("day6_talker")
        screen.press("q")
        screen.wait_end()
    until(lambda: not place.nodes())


def test_a_value_is_typed_in_rviz_as_fast_as_a_terminal_can_send_it(place: Place) -> None:
    with place.terminal("rviz2", "-f", "base_link", columns=120, rows=40, DAY6_LANG="en") as screen:
        screen.wait("Fixed Frame base_link", "Background Color")
        screen.send("\x1b[B\x1b[B\r\x15q; 2; 3\r")
        screen.wait("enter three numbers from 0 to 255")
        screen.send("\x1b[H\x1b[3~1\r\x1b[A\r\x15map\r")
        screen.wait("1; 2; 3", "Fixed Frame map")
        screen.send("/quality\r\r")
        screen.wait("━ Choose", "Medium")
        screen.send("med\r")
        screen.wait("Orbit Medium", lambda seen: "━ Choose" not in seen and "┏" in seen)
        screen.send("\x1b[Z\r")  # Shift+Tab: the buttons
        screen.wait("━ Add")
        screen.press("Esc")
        screen.wait_gone("━ Add")
        screen.press("q")
        screen.wait("There are unsaved changes")
        screen.send("discard\r")
        assert screen.wait_end() == 0


def test_rviz_asks_before_q_loses_what_was_changed(place: Place) -> None:
    with place.terminal("rviz2", "-f", "base_link", DAY6_LANG="en") as screen:
        screen.wait("RViz ", "Add", "Fixed Frame base_link")
        screen.send("a")
        screen.wait("AccelStamped")
        screen.send("axes\r")
        screen.wait("[x] Axes", "RViz *")
        screen.press("q")
        screen.wait("There are unsaved changes")
        screen.send("cancel\r")
        screen.wait_gone("There are unsaved changes")
        screen.press("q")
        screen.wait("There are unsaved changes")
        screen.send("save\r")
        assert screen.wait_end() == 0
    saved = Path(os.environ["HOME"]) / ".rviz2" / "default.rviz"  # a terminal of the test's own user
    assert "rviz_default_plugins/Axes" in saved.read_text(encoding="utf-8")


def test_plugins_of_rqt_are_tabs_of_its_terminal(place: Place) -> None:
    with place.terminal("rqt", DAY6_LANG="en", HOME=str(place.home)) as screen:
        screen.wait("Node Graph", "perspective Default", "End", "perspectives")
        assert "F3 Next" not in screen.look()
        screen.press("Down", "Down", "Enter")
        screen.wait("No node is publishing", "F3 Next")
        screen.press("F3")
        screen.wait("open: Node Graph")
        screen.press("Down", "x")
        screen.wait(lambda seen: "open: Node Graph" not in seen and "F3 Next" not in seen)
        screen.press("q")
        assert screen.wait_end() == 0
        assert "Traceback" not in screen.look()

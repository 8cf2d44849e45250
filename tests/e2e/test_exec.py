"""`day6-tui exec` and the commands of a real terminal: a lesson as a script, on real standard streams and statuses."""

from __future__ import annotations

import re
import signal
from typing import TYPE_CHECKING

import pytest

from day6_core.ros.programs.turtlesim.model import TICK
from day6_core.session.scheduler import MAX_LAG_NS
from tests.support.waiting import communicate, until

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

LESSON = (
    "ros2 run turtlesim turtlesim_node & sleep 1; ros2 topic pub --once /turtle1/cmd_vel geometry_msgs/msg/Twist "
    '"{linear: {x: 2.0}, angular: {z: 1.8}}"; sleep 2; ros2 topic echo --once /turtle1/pose; ros2 node list'
)
"""The example of the issue."""


def test_the_lesson_in_one_line_prints_the_real_answers(place: Place) -> None:
    done = place.execute(LESSON)
    assert done.returncode == 0
    assert done.stdout == (
        "Waiting for at least 1 matching subscription(s)...\n"
        "publisher: beginning loop\n"
        "publishing #1: geometry_msgs.msg.Twist(linear=geometry_msgs.msg.Vector3(x=2.0, y=0.0, z=0.0), "
        "angular=geometry_msgs.msg.Vector3(x=0.0, y=0.0, z=1.8))\n\n"
        "x: 6.602816581726074\n"
        "y: 6.938989639282227\n"
        "theta: 1.8143999576568604\n"
        "linear_velocity: 0.0\n"
        "angular_velocity: 0.0\n"
        "---\n"
        "/turtlesim\n"
    ) or done.stdout.startswith("publisher: beginning loop\n")
    first, second = done.stderr.splitlines()
    assert re.fullmatch(r"\[INFO] \[\d{10}\.\d{9}] \[turtlesim]: Starting turtlesim with node name /turtlesim", first)
    assert second.endswith("[turtlesim]: Spawning turtle [turtle1] at x=[5.544445], y=[5.544445], theta=[0.000000]")


@pytest.mark.parametrize(
    ("commands", "status", "out"),
    [
        ("true", 0, ""),
        ("false", 1, ""),
        ("exit 7", 7, ""),
        ("false; echo $?", 0, "1\n"),
        ("false | true; echo $?; true | false", 1, "0\n"),
        ("false && echo no || echo yes", 0, "yes\n"),
        ("timeout 0.2 sleep 9; echo $?", 0, "124\n"),
        ("sleep 9 & jobs; kill %1; wait; jobs", 0, "[1]+  Running                 sleep 9 &\n"),
        ("sleep 9 & kill %1; wait $!", 143, ""),
        ("mkdir a; cd a; echo one > f; echo two >> f; cat f; ls; wc -l < f", 0, "one\ntwo\nf\n2\n"),
        ('export ROBOT=\'day 6\'; echo "$ROBOT" | grep -c day; echo "${ROBOT}"', 0, "1\nday 6\n"),
        ("ros2 pkg executables turtlesim | head -2 | wc -l", 0, "2\n"),
        ("ros2 topic list | grep chatter", 1, ""),
        ("ros2 topic list", 0, "/parameter_events\n/rosout\n"),
    ],
)
def test_status_and_output_are_those_of_a_shell(place: Place, commands: str, status: int, out: str) -> None:
    done = place.execute(commands)
    assert (done.returncode, done.stdout) == (status, out), done.stderr


WORDS = {"zh": ("新建文件夹", "没有删除任何东西"), "en": ("make folders", "Nothing was removed")}


@pytest.mark.parametrize(
    ("language", "locale"),
    [
        ("zh", {"LANG": "C.UTF-8", "DAY6_LANG": "zh"}),
        ("en", {"LANG": "zh_CN.UTF-8", "DAY6_LANG": "en"}),
        ("zh", {"LANG": "zh_CN.UTF-8", "DAY6_LANG": "fr"}),
        ("en", {"LANG": "zh_CN.UTF-8", "LC_MESSAGES": "C"}),
    ],
)
def test_everything_is_said_in_one_language(place: Place, language: str, locale: dict[str, str]) -> None:
    done = place.execute("man mkdir; apt remove x", **{"LC_ALL": None, "DAY6_LANG": None, **locale})
    assert [word for words in WORDS.values() for word in words if word in done.stdout] == [*WORDS[language]]


def test_a_job_that_is_killed_says_so_when_asked(place: Place) -> None:
    done = place.execute("sleep 9 & kill %1; sleep 0.1; jobs; kill %1")
    assert done.stdout == "[1]+  Terminated              sleep 9\n"
    assert done.stderr == "bash: kill: %1: no such job\n"
    assert done.returncode == 1


def test_a_script_comes_from_a_file_or_from_standard_input(place: Place) -> None:
    script = place.file("lesson.sh", 'echo "$1 and $2"\nread line; echo "read $line"\n')
    from_file = place.run("exec", "--home", str(place.home), str(script), "one", "two", stdin="typed\n")
    assert (from_file.returncode, from_file.stdout) == (0, "one and two\nread typed\n")
    from_stdin = place.run("exec", "--home", str(place.home), stdin="pwd\nfalse\n")
    assert (from_stdin.returncode, from_stdin.stdout) == (1, f"{place.work}\n")


def test_the_time_limit_ends_everything_with_status_124(place: Place) -> None:
    done = place.execute("ros2 run turtlesim turtlesim_node & sleep 60; echo no", "--timeout", "0.5")
    assert (done.returncode, done.stdout) == (124, "")
    until(lambda: place.processes() == {})


def test_ctrl_c_ends_the_script_with_status_130(place: Place) -> None:
    process = place.start("exec", "--home", str(place.home), "-c", "echo begun; sleep 60; echo no")
    assert process.stdout is not None and process.stdout.readline() == "begun\n"
    process.send_signal(signal.SIGINT)
    out, _ = communicate(process)
    assert (process.returncode, out) == (130, "")


def test_services_parameters_and_actions_answer(place: Place) -> None:
    done = place.execute(
        "ros2 run turtlesim turtlesim_node 2> /dev/null & sleep 0.3\n"
        "ros2 service call /spawn turtlesim/srv/Spawn '{x: 2, y: 3, theta: 0.0, name: shelly}' | tail -2\n"
        "ros2 param set /turtlesim background_r 200\n"
        "ros2 param get /turtlesim background_r\n"
        "ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute '{theta: 0.1}' | tail -1\n"
        "ros2 topic list | grep -c shelly\n"
    )
    assert done.stdout.replace("\n\n", "\n") == (
        "turtlesim.srv.Spawn_Response(name='shelly')\n"
        "Set parameter successful\n"
        "Integer value is: 200\n"
        "Goal finished with status: SUCCEEDED\n"
        "3\n"
    ), done.stderr
    assert done.returncode == 0


def test_the_rate_of_the_pose_is_measured(place: Place) -> None:
    def measured() -> float:
        done = place.execute("ros2 run turtlesim turtlesim_node & timeout -s INT 2.4 ros2 topic hz /turtle1/pose")
        found = re.findall(r"average rate: ([\d.]+)\n.*window: (\d+)", done.stdout)
        if not found:
            return 0.0
        rate, periods = float(found[-1][0]), int(found[-1][1])
        # Messages are counted by real time. A world that was held up before the first of them catches up, by so much at most.
        assert periods * TICK <= periods / rate + MAX_LAG_NS / 1e9 + TICK, done.stdout + done.stderr
        return rate

    until(lambda: measured() > 40)  # a busy machine may hold it up for longer once


def test_commands_of_a_real_terminal_see_what_a_script_runs(place: Place) -> None:
    process = place.start("exec", "--home", str(place.home), "-c", "ros2 run turtlesim turtlesim_node")
    place.wait_nodes("/turtlesim")
    info = "Type: geometry_msgs/msg/Twist\nPublisher count: 0\nSubscription count: 1\n"
    until(lambda: place.run("ros2", "topic", "info", "/turtle1/cmd_vel").stdout == info)
    moved = place.run(
        "ros2", "service", "call", "/turtle1/teleport_relative", "turtlesim/srv/TeleportRelative", "{linear: 1}"
    )
    assert "response:\nturtlesim.srv.TeleportRelative_Response()" in moved.stdout, moved.stderr
    pose = place.run("ros2", "topic", "echo", "--once", "/turtle1/pose")
    assert pose.stdout.startswith("x: 6.544444561004639\ny: 5.544444561004639\n"), pose.stderr
    process.send_signal(signal.SIGINT)
    communicate(process)
    assert process.returncode == 0  # like every rclcpp node, turtlesim takes Ctrl-C as the ordinary end
    place.wait_nodes()

"""Programs with a window where there is no screen: asked for they print once, launched or with & they are nodes that stay."""

from __future__ import annotations

import signal
from typing import TYPE_CHECKING

import pytest

from tests.support.waiting import communicate

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

SAID = "There is no screen for the window: the node runs without it\n"


def test_in_the_foreground_of_exec_they_print_once_and_end(place: Place) -> None:
    done = place.play(
        "ros2 run day6_bot wheel_spinner 2> /dev/null & ros2 topic echo /joint_states > /dev/null &\n"
        "rqt_graph; echo one $?\nrqt_topic; echo two $?\nrviz2 -f base_link; echo three $?\n"
    )
    assert (done.returncode, done.stderr) == (0, "")
    graph, rest = done.stdout.split("one 0\n")
    topics, rest = rest.split("two 0\n")
    panel, rest = rest.split("three 0\n")
    assert "/wheel_spinner" in graph and " hidden: " in graph
    assert "/rosout [rcl_interfaces/msg/Log]\n" in topics and rest == ""
    assert panel.startswith("Fixed Frame: base_link\nGlobal Status: ")


def test_in_the_background_they_are_nodes_until_they_are_interrupted(place: Place) -> None:
    done = place.play(
        "ros2 run rviz2 rviz2 & ros2 run rqt_graph rqt_graph & ( rqt_topic ) & ros2 run day6_bot car_view &\n"
        "ros2 run joint_state_publisher_gui joint_state_publisher_gui & rqt_console > /dev/null & rqt_plot &\n"
        # longer than any of them would take to print
        "sleep 3.5; ros2 node list | grep -v -e transform_listener | sed 's/_[0-9]*$//'\n"
        "jobs | wc -l; kill -INT %1 %2 %3 %4 %5 %6 %7; wait; jobs; ros2 node list\n"
    )
    assert done.stdout.splitlines() == [
        "/car_view",
        "/joint_state_publisher",
        *["/rqt_gui_py_node"] * 4,
        "/rviz",
        "7",
    ], done.stdout + done.stderr
    assert done.stderr.count(SAID) == 4
    assert "[rviz]: Global Status: Fixed Frame: " in done.stderr  # what its panel would warn of is logged


@pytest.mark.parametrize("words", [("rviz2",), ("ros2", "run", "rqt_graph", "rqt_graph")])
def test_a_real_process_without_a_terminal_stays_too(place: Place, words: tuple[str, ...]) -> None:
    process = place.start(*words)
    assert process.stderr is not None
    said = process.stderr.readline()
    assert said.endswith(SAID), said
    process.send_signal(signal.SIGINT)
    communicate(process)
    assert process.returncode in (0, 130)


def test_the_shipped_car_is_launched_in_one_line(place: Place) -> None:
    done = place.play(
        "ros2 launch day6_bot display.launch.py > log 2>&1 &\n"
        "ros2 run tf2_ros tf2_echo base_link left_wheel 2> /dev/null | grep -m 2 'RPY (radian)'\n"
        "until ros2 node list | grep -q rviz2; do sleep 0.05; done\n"
        "ros2 node list | grep -v transform\nkill -INT %1; wait; cat log\n"
    )
    *turned, first, second, third, _ = done.stdout.split("\n", 5)
    assert [first, second, third] == ["/robot_state_publisher", "/rviz2", "/wheel_spinner"], done.stdout + done.stderr
    assert len(turned) == 2 and turned[0] != turned[1]
    # RViz finds its file and the robot in it: nothing to warn of.
    assert "[rviz2-2]" in done.stdout and "WARN]" not in done.stdout and "ERROR]" not in done.stdout, done.stdout


def test_the_shipped_launch_file_takes_sliders_and_another_robot(place: Place) -> None:
    robot = place.file("cart.urdf", '<robot name="cart"><link name="base_link"/></robot>\n')
    done = place.play(
        f"ros2 launch day6_bot display.launch.py sliders:=true robot:='{robot}' > log 2>&1 &\n"
        "ros2 topic echo --once --full-length --qos-durability transient_local "
        "/robot_description std_msgs/msg/String --field data\n"
        "for node in joint_state_publisher robot_state_publisher rviz2; do\n"
        "  until ros2 node list | grep -q $node; do sleep 0.05; done\ndone\n"
        "ros2 node list | grep -v transform\nkill -INT %1; wait\n"
    )
    assert '<robot name="cart">' in done.stdout, done.stdout + done.stderr
    assert done.stdout.endswith("/joint_state_publisher\n/robot_state_publisher\n/rviz2\n"), done.stdout

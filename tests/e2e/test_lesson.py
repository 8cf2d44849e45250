"""The article's sections 3 and 5 typed line by line from an empty home, and the faults of its section 6."""

from __future__ import annotations

import re
from typing import TYPE_CHECKING

import pytest

from tests.e2e.lesson_files import (
    LAUNCH,
    SETUP,
    SPINNER_SCRIPT,
    TALKER,
    TALKER_SCRIPT,
    URDF,
    WHEEL_SPINNER,
    heredoc,
)

if TYPE_CHECKING:
    from tests.e2e.place import Place

pytestmark = pytest.mark.person

CREATE = (
    "cd ~/ros2_ws/src\n"
    "ros2 pkg create --build-type ament_python day6_publisher --dependencies rclpy std_msgs > /dev/null\n"
    "cd ~/ros2_ws/src/day6_publisher/day6_publisher\n" + heredoc("talker.py", TALKER)
)
"""Sections 3.1 and 3.2, up to the node."""

ENTRY_POINT = heredoc("../setup.py", SETUP.replace("@SCRIPTS@", TALKER_SCRIPT))
BUILD = "cd ~/ros2_ws\ncolcon build --packages-select day6_publisher\n"
SOURCE = "source install/setup.bash\n"

BUILT = "Starting >>> day6_publisher\nFinished <<< day6_publisher [<TIME>]\n\nSummary: 1 package finished [<TIME>]\n"


def timeless(text: str) -> str:
    return re.sub(r"\[\d+\.\d+s\]", "[<TIME>]", text)


def test_section_3_the_first_publisher_talks_and_another_terminal_hears_it(place: Place) -> None:
    done = place.play(
        CREATE + ENTRY_POINT + BUILD + SOURCE + "ros2 run day6_publisher talker &\n"
        # another terminal, in which nothing was sourced
        "bash -c 'source ~/ros2_ws/install/setup.bash; ros2 topic echo --once /chatter std_msgs/msg/String'\n"
        "ros2 topic info /chatter\n"
        "ros2 node list\n"
        "kill -INT %1; wait\n"
    )
    assert timeless(done.stdout).startswith(BUILT)
    assert re.search(
        r"^data: 'Hello from Day 6: \d+'\n---\n|^data: Hello from Day 6: \d+\n---\n", done.stdout, re.MULTILINE
    )
    assert "Type: std_msgs/msg/String\nPublisher count: 1\nSubscription count: 0\n" in done.stdout
    assert "/day6_talker\n" in done.stdout
    assert re.search(r"\[INFO\] \[\d+\.\d+\] \[day6_talker\]: Publishing: Hello from Day 6: 0\n", done.stderr)


def test_section_5_the_wheels_turn(place: Place) -> None:
    package = "~/ros2_ws/src/day6_publisher"
    done = place.play(
        CREATE
        + f"cd {package}\nmkdir urdf launch\n"
        + heredoc("urdf/day6_bot.urdf", URDF)
        + heredoc("launch/day6_display.launch.py", LAUNCH.replace("@HOME@", str(place.home)))
        + heredoc("day6_publisher/wheel_spinner.py", WHEEL_SPINNER)
        + heredoc("setup.py", SETUP.replace("@SCRIPTS@", TALKER_SCRIPT + SPINNER_SCRIPT))
        + "check_urdf urdf/day6_bot.urdf | head -1\n"
        + BUILD
        + SOURCE
        + "ros2 launch day6_publisher day6_display.launch.py &\n"
        "until [ $(ros2 node list | grep -c -e robot_state -e rviz2) = 2 ]; do sleep 0.05; done\n"
        "ros2 topic info /robot_description\n"
        # a new terminal
        "bash -c 'source ~/ros2_ws/install/setup.bash; ros2 run day6_publisher wheel_spinner' &\n"
        "until ros2 topic info /joint_states | grep -q 'Publisher count: 1'; do sleep 0.05; done\n"
        "ros2 node list\n"
        "ros2 topic info /joint_states\n"
        "ros2 run tf2_ros tf2_echo base_link left_wheel 2> /dev/null | grep -m 2 'RPY (radian)'\n"
        "kill -INT %1 %2; wait\n"
    )
    assert "robot name is: day6_bot\n" in done.stdout, done.stderr
    assert BUILT in timeless(done.stdout)
    assert "Type: sensor_msgs/msg/JointState\nPublisher count: 1\nSubscription count: 1\n" in done.stdout, (
        done.stdout + done.stderr
    )
    for node in ("/robot_state_publisher", "/rviz2", "/wheel_spinner"):
        assert f"{node}\n" in done.stdout, done.stdout + done.stderr
    turned = re.findall(r"RPY \(radian\) \[(-?[\d.]+), (-?[\d.]+), (-?[\d.]+)\]", done.stdout)
    assert len(turned) == 2 and turned[0] != turned[1], done.stdout + done.stderr


# -- section 6.1: Package 'day6_publisher' not found -------------------------------------------------------------------

# The package lies a level too deep, and was built where the student thinks the workspace is.
NESTED = (
    "mkdir -p ~/ros2_ws/src/src\ncd ~/ros2_ws/src\nmv day6_publisher src/\n"
    "cd ~/ros2_ws/src\ncolcon build > /dev/null\ncd ~/ros2_ws\nsource install/setup.bash\n"
)
NOT_FOUND = "Package 'day6_publisher' not found\n"


@pytest.mark.parametrize(
    ("fault", "lines"),
    [
        (
            "a workspace inside the workspace: nested src",
            NESTED,
        ),
        ("never built", "cd ~/ros2_ws\nsource install/setup.bash\n"),
        ("the terminal was not sourced", BUILD),
    ],
)
def test_section_6_1_the_package_is_not_found(place: Place, fault: str, lines: str) -> None:
    done = place.play(CREATE + ENTRY_POINT + lines + "ros2 pkg list | grep day6\nros2 run day6_publisher talker\n")
    assert done.returncode == 1, fault
    assert done.stderr.endswith(NOT_FOUND), done.stderr
    assert "day6_publisher\n" not in done.stdout.replace(">>> day6_publisher\n", "")
    if "source install" in lines:
        assert "bash: install/setup.bash: No such file or directory\n" in done.stderr


def test_section_6_1_a_wrong_indentation_in_setup_py_fails_the_build(place: Place) -> None:
    broken = SETUP.replace("@SCRIPTS@", TALKER_SCRIPT).replace("package_name = 'day6", "    package_name = 'day6")
    done = place.play(CREATE + heredoc("../setup.py", broken) + BUILD + SOURCE + "ros2 run day6_publisher talker\n")
    assert "IndentationError: unexpected indent\n" in done.stderr
    assert "--- stderr: day6_publisher\n" in done.stderr
    assert re.search(r"Failed   <<< day6_publisher \[\d+\.\d+s, exited with code 1\]\n", done.stderr)
    assert timeless(done.stdout) == (
        "Starting >>> day6_publisher\n\nSummary: 0 packages finished [<TIME>]\n  1 package failed: day6_publisher\n"
        "  1 package had stderr output: day6_publisher\n"
    )
    assert done.stderr.endswith(NOT_FOUND)


def test_section_6_1_without_an_entry_point_there_is_no_executable(place: Place) -> None:
    done = place.play(CREATE + BUILD + SOURCE + "ros2 pkg list | grep day6\nros2 run day6_publisher talker\n")
    assert timeless(done.stdout) == BUILT + "day6_publisher\n"
    assert (done.returncode, done.stderr) == (1, "No executable found\n")


def test_section_6_1_sourcing_makes_the_package_known_to_this_terminal_only(place: Place) -> None:
    done = place.play(
        CREATE + ENTRY_POINT + BUILD + "bash -c 'source ~/ros2_ws/install/setup.bash; ros2 pkg list | grep day6'\n"
        "ros2 pkg prefix day6_publisher\nsource ~/ros2_ws/install/setup.bash\nros2 pkg prefix day6_publisher\n"
        "ros2 pkg executables day6_publisher\n"
    )
    assert timeless(done.stdout) == (
        BUILT + f"day6_publisher\n{place.home}/ros2_ws/install/day6_publisher\nday6_publisher talker\n"
    )
    assert done.stderr == "Package not found\n"


# -- section 6.5: .bashrc ----------------------------------------------------------------------------------------------


def test_section_6_5_the_line_in_bashrc_makes_every_terminal_know_the_package(place: Place) -> None:
    done = place.play(
        CREATE + ENTRY_POINT + BUILD + 'echo "source ~/ros2_ws/install/setup.bash" >> ~/.bashrc\n'
        "ros2 pkg prefix day6_publisher\nsource ~/.bashrc\nros2 pkg prefix day6_publisher\ncat ~/.bashrc\n"
    )
    assert done.stderr == "Package not found\n"
    assert timeless(done.stdout) == (
        BUILT + f"{place.home}/ros2_ws/install/day6_publisher\nsource ~/ros2_ws/install/setup.bash\n"
    )


def test_section_6_5_of_two_workspaces_the_one_sourced_last_shadows_the_other(place: Place) -> None:
    older = TALKER.replace("Hello from Day 6", "OldWorkspace")
    said = 'grep -o -m 1 -E "Hello|OldWorkspace" ~/said'
    run = f"ros2 run day6_publisher talker > ~/said 2>&1 & until {said}; do sleep 0.05; done; kill -INT $!; wait\n"
    done = place.play(
        CREATE + ENTRY_POINT + BUILD + "mkdir -p ~/old_ws\ncp -r ~/ros2_ws/src ~/old_ws/src\n"
        "cd ~/old_ws/src/day6_publisher/day6_publisher\n" + heredoc("talker.py", older) + "cd ~/old_ws\ncolcon build\n"
        f"bash -c 'source ~/ros2_ws/install/setup.bash; source ~/old_ws/install/setup.bash; {run}'\n"
        f"bash -c 'source ~/old_ws/install/setup.bash; source ~/ros2_ws/install/setup.bash; {run}'\n"
    )
    assert done.stdout.splitlines()[-2:] == ["OldWorkspace", "Hello"], done.stdout + done.stderr

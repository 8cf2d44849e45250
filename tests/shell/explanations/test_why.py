"""`why` and `explain` in a terminal: the card of what was printed, with the cause that is found in the files and in the graph."""

from __future__ import annotations

import os
from typing import Any

import pytest

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a terminal there has no pty")


def said(seat: Any, line: str) -> str:
    """What a command prints, without line breaks of the screen."""
    seat.line(f"clear; {line}")
    return " ".join(seat.wait_prompt().split())


def test_why_explains_the_last_message_and_says_what_to_type(machine: Any, tall: Any) -> None:
    said(tall, "ros2 run turtlesm turtlesim_node")
    seen = said(tall, "why")
    assert "Package 'turtlesm' not found" in seen and "What it means" in seen
    assert "No package is called turtlesm, but there is turtlesim" in seen
    assert "Type next ros2 run turtlesim turtlesim_node" in seen and "On a real robot" in seen
    assert said(tall, "why; echo $?").count("Package 'turtlesm' not found") == 1  # what why prints is no message
    said(tall, "ls nothing_here")
    assert "'nothing_here'" in said(tall, "why") and "turtlesm" in said(tall, "why 2")
    assert "There is no card for anything this terminal has printed lately" in said(tall, "why 9")
    assert said(tall, "why 9 > out; echo $?").endswith("1 student@day6:~$")


def test_why_in_the_same_line_explains_what_came_before_it(tall: Any) -> None:
    said(tall, "ls first")
    seen = said(tall, "ls nothing; why")
    assert "There is no file or folder nothing" in seen and "folder first" not in seen
    assert "There is no file or folder first" in said(tall, "why")  # a line with why in it is not explained again


def test_a_program_that_a_package_of_ros_does_not_have(tall: Any) -> None:
    said(tall, "ros2 run turtlesim nope")
    assert "turtlesim has these programs: draw_square, mimic" in said(tall, "why")


def test_a_package_and_its_program_the_wrong_way_round_and_a_type_with_dots(tall: Any) -> None:
    said(tall, "ros2 run turtlesim_node turtlesim")
    seen = said(tall, "why")
    assert "turtlesim_node is a program and turtlesim its package" in seen
    assert "Type next ros2 run turtlesim turtlesim_node" in seen
    said(tall, "ros2 interface show geometry_msgs.msg.Twist")
    assert "Type next ros2 interface show geometry_msgs/msg/Twist" in said(tall, "why")


def test_in_chinese_the_grey_line_tells_the_cause_that_is_found(machine: Any, tall: Any) -> None:
    (machine.desk.home / "talk.py").write_text("print('hi')\n")
    said(tall, "export DAY6_LANG=zh")
    assert (
        "意思：这个包里没有叫 turtlesim_nod 的程序，不过有 turtlesim_node。可以输入：ros2 run turtlesim turtlesim_node"
        in said(tall, "ros2 run turtlesim turtlesim_nod")
    )
    assert "意思：没有 talk.pi，不过有 talk.py。可以输入：cat talk.py" in said(tall, "cat talk.pi")
    assert "意思：没有 zzqy 这个文件或文件夹。（怎么办：输入 why）" in said(tall, "cat zzqy")


def test_a_new_terminal_has_nothing_to_explain_and_says_so(seat: Any) -> None:
    assert "why: There is no card for anything this terminal has printed lately" in said(seat, "why; echo status $?")


@pytest.mark.process
def test_built_and_not_sourced(machine: Any, tall: Any) -> None:
    assert machine.run("cd ros2_ws/src; ros2 pkg create --build-type ament_python --node-name go car").status == 0
    said(tall, "ros2 run car go")
    seen = said(tall, "why")
    assert "hasn't been built yet" in seen
    assert "colcon build --packages-select car; source install/setup.bash" in seen
    assert machine.run("cd ~/ros2_ws; colcon build").status == 0
    said(tall, "ros2 run car go")
    seen = said(tall, "why")
    assert "car is built, in ~/ros2_ws/install, but this terminal has not sourced it" in seen
    assert "Type next source ~/ros2_ws/install/setup.bash" in seen
    said(tall, "source ~/ros2_ws/install/setup.bash; ros2 run car gone")
    assert "Type next ros2 run car go " in said(tall, "why")
    said(tall, "ros2 run car zzz_other")
    assert "setup.py of car names only these programs: go" in said(tall, "why")


@pytest.mark.process
def test_a_program_that_setup_py_does_not_name_and_one_that_was_not_built(machine: Any, tall: Any) -> None:
    assert machine.run("cd ros2_ws/src; ros2 pkg create --build-type ament_python --node-name go car").status == 0
    assert machine.run("cd ~/ros2_ws; colcon build").status == 0
    package = machine.desk.home / "ros2_ws" / "src" / "car"
    (package / "car" / "listener.py").write_text("def main(): pass\n")
    said(tall, "source ~/ros2_ws/install/setup.bash; ros2 run car listener.py")
    seen = said(tall, "why")
    assert "listener.py is there, but" in seen and "'listener = car.listener:main'," in seen
    setup = package / "setup.py"
    setup.write_text(
        setup.read_text().replace("'go = car.go:main'", "'go = car.go:main', 'listener = car.listener:main'")
    )
    said(tall, "ros2 run car listener")
    seen = said(tall, "why")
    assert "names listener, but it isn't installed" in seen and "colcon build --packages-select car" in seen


@pytest.mark.process
def test_a_launch_file_that_is_not_installed(machine: Any, tall: Any) -> None:
    assert machine.run("cd ros2_ws/src; ros2 pkg create --build-type ament_python car").status == 0
    package = machine.desk.home / "ros2_ws" / "src" / "car"
    (package / "launch").mkdir()
    (package / "launch" / "car.launch.py").write_text("")
    assert machine.run("cd ~/ros2_ws; colcon build").status == 0
    said(tall, "source ~/ros2_ws/install/setup.bash; ros2 launch car car.launch.py")
    seen = said(tall, "why")
    assert "data_files in" in seen and "glob('launch/*')" in seen and "Type next nano" in seen
    setup = package / "setup.py"
    setup.write_text(
        setup.read_text().replace("data_files=[", "data_files=[('share/car/launch', ['launch/car.launch.py']),")
    )
    said(tall, "ros2 launch car car.launch.py")
    assert "not installed yet: build again" in said(tall, "why")
    said(tall, "ros2 launch turtlesim multisim.launch")
    assert "ros2 launch turtlesim multisim.launch.py" in said(tall, "why")


def test_names_are_looked_for_in_the_live_graph(machine: Any, tall: Any) -> None:
    said(tall, "ros2 topic info /pose")
    assert "This terminal sees no running nodes (ROS_DOMAIN_ID is 0)" in said(tall, "why")
    tall.line("ros2 run turtlesim turtlesim_node &")
    tall.settle(1.0)
    said(tall, "ros2 topic info /pose")
    seen = said(tall, "why")
    assert "There is no /pose, but there is /turtle1/pose" in seen and "Type next ros2 topic info /turtle1/pose" in seen
    said(tall, "ros2 node info /turtlsim")
    assert "Type next ros2 node info /turtlesim" in said(tall, "why")
    said(tall, "ros2 node info /zzz")
    assert "I could not find the cause here; check in this order: 1. ros2 node list" in said(tall, "why")
    said(tall, "export ROS_DOMAIN_ID=5; ros2 node info /turtlesim")
    seen = said(tall, "why")
    assert "ROS_DOMAIN_ID is 5 in this terminal, where no node is running; but domain 0 has /turtlesim" in seen
    assert "Type next export ROS_DOMAIN_ID=0" in seen


def test_paths_and_commands(machine: Any, tall: Any) -> None:
    (machine.desk.home / "ros2_ws" / "src" / "car.urdf").write_text("<robot/>")
    (machine.desk.home / "talk.py").write_text("print('hi')\n")
    for typed, next_ in {
        "cat talk.pi": "cat talk.py",
        "cat Talk.py": "cat talk.py",
        "cat car.urdf": "cd ~/ros2_ws/src",
        "talk.py": "python3 talk.py",
        "./talk.py": "python3 ./talk.py",
        "colon build": "colcon build",
        "cat ros2_ws": "",
    }.items():
        said(tall, typed)
        seen = said(tall, "why")
        assert "What it means" in seen
        assert (f"Type next {next_}" in seen) if next_ else "Type next" not in seen, (typed, seen)


@pytest.mark.process
def test_a_traceback_is_explained_by_the_rules_of_the_hints(machine: Any, tall: Any) -> None:
    (machine.desk.home / "slip.py").write_text("count = 1\nprint(cuont)\n")
    said(tall, "python3 slip.py")
    seen = said(tall, "why")
    assert "Line 2 uses cuont" in seen and "nothing is called cuont here; did you mean count?" in seen


def test_explain_takes_a_text_a_topic_a_card_or_what_is_piped(machine: Any) -> None:
    assert "The dictionary has no such key" in machine.run("explain \"KeyError: 'x'\"").out
    topics = machine.run("explain").out
    assert "packages" in topics and "Robot descriptions" in topics
    assert "package-not-found" in machine.run("explain packages").out
    assert "语法错误" in machine.run("DAY6_LANG=zh; export DAY6_LANG; explain").out
    card = machine.run("explain ctrl-c").out
    assert "这不是错误" in card and "真机上" not in card  # nothing is different there
    for line in ("explain zzqqzz", "why zzqqzz", "echo all is well | why"):
        done = machine.run(line)
        assert (done.status, done.out) == (1, "") and "没有卡片" in done.err
    assert "没有叫 car 的包" in machine.run("ros2 run car go 2>&1 | why").out
    assert machine.run("ros2 run car go 2>&1 | why").status == 0


@pytest.mark.process
def test_the_first_line_appears_below_a_failure_in_chinese_only(machine: Any, seat: Any) -> None:
    seen = seat.line("ls nothing")
    seen = seat.wait_prompt()
    assert "意思" not in seen and "What it means" not in seen
    seat.line("clear; export DAY6_LANG=zh; ls nothing")
    assert "意思：没有 nothing 这个文件或文件夹。（怎么办：输入 why）" in seat.wait_prompt()
    row = next(seat.terminal.screen.row(y) for y in range(24) if "意思" in str(seat.terminal.screen.row(y)))
    assert not isinstance(row, str) and row[0][1].fg == "brightblack"
    seat.line("clear; ros2 run car")
    assert seat.wait_prompt().count("意思：") == 1
    (machine.desk.home / "value.py").write_text("int('a')\n")
    seat.line("clear; python3 value.py")
    assert seat.wait_prompt().count("意思：") == 1
    for line in (
        "ls nothing 2>&1 | cat",
        "ls nothing 2> f",
        "x=$(ls nothing 2>&1)",
        "DAY6_HINTS=off; ls nothing",
        "true",
    ):
        seat.line(f"clear; {line}")
        assert "意思" not in seat.wait_prompt(), line


@pytest.mark.process
def test_a_certain_hint_comes_in_its_place(machine: Any, seat: Any) -> None:
    (machine.desk.home / "slip.py").write_text("count = 1\nprint(cuont)\n")
    seat.line("export DAY6_LANG=zh; clear; python3 slip.py")
    seen = seat.wait_prompt()
    assert "提示：这里没有叫 cuont 的东西，是不是想写 count？" in seen and "意思" not in seen


@pytest.mark.process
def test_ctrl_c_and_programs_that_go_well_get_no_line(machine: Any, seat: Any) -> None:
    seat.line("export DAY6_LANG=zh; clear; echo 'KeyError: 1'")
    assert "意思" not in seat.wait_prompt()
    (machine.desk.home / "wait.py").write_text("import time\nprint('KeyError: 1', flush=True)\ntime.sleep(100)\n")
    seat.line("python3 wait.py")
    seat.wait(lambda text: text.count("KeyError") > 1)
    seat.type("\x03")
    assert "意思" not in seat.wait_prompt()

"""What beginners type wrong, in their own words: the hint below, and the card with the whole line put right."""

from __future__ import annotations

import os
from typing import Any

import pytest

from day6_core.advice.matching import unfinished
from tests.shell.explanations.asking import said

pytestmark = pytest.mark.skipif(os.name == "nt", reason="a terminal there has no pty")

SPAWN = "ros2 service call /spawn turtlesim/srv/Spawn"
PUB = "ros2 topic pub /turtle1/cmd_vel geometry_msgs/msg/Twist"
ZERO = "{x: 0.0, y: 0.0, z: 0.0}"
TELEOP = "ros2 run turtlesim turtle_teleop_key --ros-args"


def hint(seat: Any, line: str) -> str:
    """The hint below what a line prints, '' if it has none."""
    seat.line("clear")
    seat.line(line)
    lines = [each for each in seat.wait_prompt().splitlines() if each.startswith(("hint: ", "提示："))]
    return lines[-1] if lines else ""


SLIPS = {
    # What was typed -> words of the hint, what comes next.
    "$ ros2 pkg list": ("$ is the prompt", "ros2 pkg list"),
    "$ ros2 pkg list | grep turtle": ("$ is the prompt", "ros2 pkg list"),
    "$ros2 pkg list": ("$ is the prompt", "ros2 pkg list"),
    "student@day6:~$ ls": ("is the prompt", "ls"),
    "student@day6:~/ros2_ws$ ls -l": ("is the prompt", "ls -l"),
    "cd..": ("a space is missing after cd: cd ..", "cd .."),
    "cd../": ("a space is missing after cd: cd ../", "cd ../"),
    "cd~": ("a space is missing after cd: cd ~", "cd ~"),
    "cd/tmp": ("a space is missing after cd: cd /tmp", "cd /tmp"),
    "ls-l": ("a space is missing after ls: ls -l", "ls -l"),
    "ls-la ros2_ws": ("a space is missing after ls: ls -la", "ls -la ros2_ws"),
    "ros2run turtlesim turtlesim_node": ("after ros2: ros2 run", "ros2 run turtlesim turtlesim_node"),
    "ros2-topic list": ("after ros2: ros2 topic", "ros2 topic list"),
    "colconbuild": ("after colcon: colcon build", "colcon build"),
    "mkdirmy_robot": ("after mkdir: mkdir my_robot", "mkdir my_robot"),
    "python3star.py": ("after python3: python3 star.py", "python3 star.py"),
    'echo"hi there"': ("a space is missing after echo", 'echo "hi there"'),
    "mkdri my_robot": ("did you mean mkdir?", "mkdir my_robot"),
    "mkdirs a": ("did you mean mkdir?", "mkdir a"),
    "sl": ("did you mean ls?", "ls"),
    "speed = 5": ("no spaces around =", "speed=5"),
    "cta x": ("did you mean cat?", "cat x"),
    "ros topic list": ("did you mean ros2?", "ros2 topic list"),
    "LS -l": ("commands are lowercase: ls", "ls -l"),
    "ros2 topik list": ("did you mean topic?", "ros2 topic list"),
    "ros2 topic lsit": ("did you mean list?", "ros2 topic list"),
    "colcon biuld": ("did you mean build?", "colcon build"),
    "ros2 run demo_nodes_cpp talker。": ("ends with a Chinese '。'", "ros2 run demo_nodes_cpp talker"),
    "ls　-l": ("a wide, Chinese space", "ls -l"),
    "“source": ("a Chinese '“'", '"source'),
}


@pytest.mark.parametrize(("typed", "expected"), SLIPS.items())
def test_a_slip_of_the_line_gets_its_hint_and_the_line_put_right(
    tall: Any, typed: str, expected: tuple[str, str]
) -> None:
    words, next_ = expected
    assert words in hint(tall, typed)
    seen = said(tall, "why")
    assert f"Type next {next_} student@day6:~$" in seen or f"Type next {next_} On a real robot" in seen, seen
    assert "apt" not in seen and "jazzy" not in seen  # of ROS that is not sourced nobody spoke


@pytest.mark.process
def test_what_is_no_slip_gets_no_hint(machine: Any, tall: Any) -> None:
    typed = (
        "b",
        "foo-bar",
        "catalog",
        "lsof",
        "grep 你好， .bashrc",
        "ls 你好。",
        "apt-cache x",
        "x/y",
        "test-a1",
        "envs/bin",
    )
    assert {line: hint(tall, line) for line in typed} == dict.fromkeys(typed, "")
    (machine.desk.home / "ls").mkdir()
    assert hint(tall, "ls/frob") == ""


def test_ros_2_that_is_not_sourced_keeps_its_own_card(tall: Any) -> None:
    said(tall, "unset AMENT_PREFIX_PATH ROS_DISTRO; PATH=/usr/bin:/bin")
    said(tall, "ros2 topic list")
    seen = said(tall, "why")
    assert "source /opt/ros/jazzy/setup.bash" in seen and "On a real robot" in seen


def test_a_letter_at_the_prompt_is_an_answer_while_a_question_is_open(machine: Any, tall: Any) -> None:
    class Question:
        letters_awaited = "abc"

    assert hint(tall, "b") == ""
    window = machine.desk.display.open("lesson", "Lessons", Question())
    assert "press F5, then b" in hint(tall, "b") and "press F5, then b" in said(tall, "why")
    assert hint(tall, "d") == "" and hint(tall, "b x") == ""
    tall.line("export DAY6_LANG=zh")
    assert hint(tall, "c") == "提示：回答问题要在课程窗口里：先按 F5，再按 c"
    Question.letters_awaited = ""
    assert hint(tall, "c") == ""
    assert window is not None


def test_a_course_awaits_letters_only_where_it_asks(machine: Any) -> None:
    from day6_core.lessons.course import Course
    from day6_core.lessons.state import State
    from day6_core.shell.language.hints import AsksByLetter

    course = Course.__new__(Course)
    course.state = State()
    assert isinstance(course, AsksByLetter) and course.letters_awaited == ""
    from day6_core.lessons.catalogue import days

    lessons = [each for each in days() if not hasattr(each, "reason") and hasattr(each, "steps")]
    asked = []
    for lesson in lessons:
        for index in range(len(lesson.steps)):
            course.state = State(lesson, index)
            asked.append(course.letters_awaited)
            course.state = State(lesson, index, solved=True)
            assert course.letters_awaited == ""
    assert "abc" in "".join(asked) and "" in asked


CONTENTS = {
    # What was typed -> words of the card, what comes next.
    f'{SPAWN} "{{x:2.0, y:2.0, name:lily}}"': (
        "A space is missing after x:",
        f'{SPAWN} "{{x: 2.0, y: 2.0, name: lily}}"',
    ),
    f'{SPAWN} "{{x: 2.0, y:2.0}}"': ("A space is missing after y:", f'{SPAWN} "{{x: 2.0, y: 2.0}}"'),
    f'{SPAWN} "{{x: 2.0, nam: lily}}"': ("did you mean name?", f'{SPAWN} "{{x: 2.0, name: lily}}"'),
    f'{SPAWN} "{{speed: 2.0}}"': (
        "turtlesim/srv/Spawn has these fields: x, y, theta, name",
        "ros2 interface show turtlesim/srv/Spawn",
    ),
    f'{PUB} "{{linear: {{x:2.0}}}}"': ("after x:", f'{PUB} "{{linear: {{x: 2.0}}}}"'),
    f'{PUB} "linear:{{x: 2.0}}"': ("after linear:", f'{PUB} "linear: {{x: 2.0}}"'),
    f'{PUB} "{{x: 2.0, z: 1.8}}"': (
        "x isn't a separate field: it is inside linear, angular.",
        f'{PUB} "{{linear: {{x: 2.0}}, angular: {{z: 1.8}}}}"',
    ),
    f'{PUB} "{{linear: 2.0}}"': (
        "linear: {x: …, y: …, z: …}",
        "ros2 interface show geometry_msgs/msg/Twist",
    ),
    f"{PUB} {{linear: {{x: 2.0}}}}": ("quotation marks around them", f'{PUB} "{{linear: {{x: 2.0}}}}"'),
    'ros2 topic pub /c std_msgs/msg/String "data:hi"': (
        "A space is missing after data:",
        'ros2 topic pub /c std_msgs/msg/String "data: hi"',
    ),
    "ros2 topic pub /c std_msgs/msg/String data:hi": (
        "A space is missing after data:",
        'ros2 topic pub /c std_msgs/msg/String "data: hi"',
    ),
    "ros2 topic pub /c std_msgs/msg/String hi": (
        "The name of the field is missing: {data: hi}",
        'ros2 topic pub /c std_msgs/msg/String "{data: hi}"',
    ),
    'ros2 service call /turtle1/set_pen turtlesim/srv/SetPen "{r: 300}"': (
        "r takes whole numbers from 0 to 255",
        "ros2 interface show turtlesim/srv/SetPen",
    ),
    'ros2 service call /turtle1/set_pen turtlesim/srv/SetPen "{r: red}"': (
        "r takes whole numbers from 0 to 255",
        "ros2 interface show turtlesim/srv/SetPen",
    ),
    'ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta:1}"': (
        "after theta:",
        'ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta: 1}"',
    ),
    "ros2 service call /clear": (
        "/clear has the type std_srvs/srv/Empty",
        "ros2 service call /clear std_srvs/srv/Empty",
    ),
    "ros2 service call /spawn": (
        "/spawn has the type turtlesim/srv/Spawn",
        "ros2 service call /spawn turtlesim/srv/Spawn \"{x: 0.0, y: 0.0, theta: 0.0, name: ''}\"",
    ),
    "ros2 service call /claer": ("but there is /clear", "ros2 service call /clear"),
    "ros2 action send_goal /turtle1/rotate_absolute": (
        "has the type turtlesim/action/RotateAbsolute",
        'ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "{theta: 0.0}"',
    ),
    "ros2 topic pub --once /turtle1/cmd_vel": (
        "has the type geometry_msgs/msg/Twist",
        f'{PUB.replace("pub", "pub --once")} "{{linear: {ZERO}, angular: {ZERO}}}"',
    ),
    "ros2 topic echo": ("ros2 topic list lists them", "ros2 topic list"),
    "ros2 interface show Twist": (
        "The package comes before Twist: geometry_msgs/msg/Twist",
        "ros2 interface show geometry_msgs/msg/Twist",
    ),
    "ros2 interface show twist": ("geometry_msgs/msg/Twist", "ros2 interface show geometry_msgs/msg/Twist"),
    "ros2 interface show geometry_msgs/Twist": ("three parts", "ros2 interface show geometry_msgs/msg/Twist"),
    "ros2 interface show Pose": ("geometry_msgs/msg/Pose, turtlesim/msg/Pose", ""),
    "ros2 param set background_r 200": (
        "The node is missing: it comes before background_r",
        "ros2 param set /turtlesim background_r 200",
    ),
    "ros2 param get background_r": ("The node is missing", "ros2 param get /turtlesim background_r"),
    "ros2 param set /turtlesim background_r=200": ("not =", "ros2 param set /turtlesim background_r 200"),
    "ros2 run turtlesim_node": ("turtlesim_node is a program", "ros2 run turtlesim turtlesim_node"),
    "ros2 run turtlesim": ("turtlesim is a package", "ros2 pkg executables turtlesim"),
    f"{TELEOP} -p scale_linear:=4.0 scale_angular:=2.493": (
        "scale_angular:=2.493 has no -p before it: each one needs its own -p",
        f"{TELEOP} -p scale_linear:=4.0 -p scale_angular:=2.493",
    ),
    f"{TELEOP} scale_linear:=4.0": ("has no -p before it", f"{TELEOP} -p scale_linear:=4.0"),
    f"{TELEOP} /turtle1/cmd_vel:=/a": ("has no -r before it", f"{TELEOP} -r /turtle1/cmd_vel:=/a"),
    f"{TELEOP} -p scale_linear=4.0": ("Put := between", f"{TELEOP} -p scale_linear:=4.0"),
}


@pytest.mark.parametrize(("typed", "expected"), CONTENTS.items())
def test_contents_types_and_parameters_that_are_not_right(
    machine: Any, tall: Any, typed: str, expected: tuple[str, str]
) -> None:
    words, next_ = expected
    tall.line("ros2 run turtlesim turtlesim_node &")
    tall.settle(1.0)
    said(tall, typed)
    seen = said(tall, "why")
    assert words in seen, seen
    assert (f"Type next {next_} student@" in seen) if next_ else "Type next" not in seen, seen
    tall.line("export DAY6_LANG=zh")
    chinese = said(tall, "why")
    assert "has no attribute" not in chinese.partition("是什么意思")[2]


def test_a_card_says_nothing_twice_and_leaves_out_what_it_has_not(tall: Any) -> None:
    tall.line("export DAY6_LANG=zh; clear")
    said(tall, "mkdri a")
    seen = said(tall, "why")
    assert seen.count("没有叫 mkdri 的命令") == 1 and "真机上" not in seen and "一样。" not in seen
    said(tall, "zzzzq")
    tall.line("clear; why")
    seen = tall.wait_prompt()
    assert "python3 文件名" in seen and "`" not in seen


def test_an_open_quote_is_told_once_at_the_continuation_prompt(machine: Any, tall: Any) -> None:
    tall.line("export DAY6_LANG=zh")
    tall.line("clear")
    assert "提示" not in tall.line("echo 'a") + tall.line("ros2 topic list")
    assert tall.terminal.unfinished == "echo 'a\nros2 topic list\n"
    card = unfinished(tall.terminal.unfinished)
    assert card is not None and card.line == "echo 'a" and card.card.id == "prompt-continues"
    for _ in range(3):
        seen = tall.line("why")
    assert seen.count("提示：> 表示引号 ' 还没有关上") == 1 and "Ctrl-C" in seen
    tall.type("\x03")
    assert tall.terminal.unfinished == ""
    tall.line("clear")
    for line in ("for i in 1 2", "do", "echo $i", "done"):
        seen = tall.line(line)
    assert "提示" not in seen and "1" in seen
    tall.line("export DAY6_HINTS=off; clear")
    for _ in range(4):
        seen = tall.line("echo 'a" if "> " not in seen else "b")
    assert "提示" not in seen


@pytest.mark.process
def test_a_comma_between_entry_points_that_is_missing(machine: Any, tall: Any) -> None:
    assert machine.run("cd ros2_ws/src; ros2 pkg create --build-type ament_python --node-name hello car").status == 0
    setup = machine.desk.home / "ros2_ws" / "src" / "car" / "setup.py"
    good = setup.read_text()
    entry = "'hello = car.hello:main'"
    assert entry in good
    line = good[: good.index(entry)].count("\n") + 1
    setup.write_text(
        good.replace(f"{entry},", entry).replace(entry, f"{entry}\n            'talker = car.talker:main',")
    )
    told = f"comma is missing at the end of line {line} of "
    seen = hint(tall, "cd ~/ros2_ws; colcon build")
    assert told in seen  # and the path, as far as there is room
    seen = said(tall, "why")
    assert told in seen and "Type next nano src/car/setup.py" in seen
    said(tall, "ros2 run car talker")
    said(tall, "source install/setup.bash; ros2 run car talker")
    setup.write_text(good)
    assert machine.run("cd ~/ros2_ws; colcon build").status == 0
    setup.write_text(
        good.replace(f"{entry},", entry).replace(entry, f"{entry}\n            'talker = car.talker:main',")
    )
    said(tall, "source install/setup.bash; ros2 run car talker")
    assert told in said(tall, "why")


CHECKED = {
    "SyntaxError: expected ':'": "第 9 行末尾少了冒号",
    "SyntaxError: unterminated string literal (detected at line 9)": "第 9 行的字符串少了结尾的引号",
    "SyntaxError: invalid character '：' (U+FF1A)": "第 9 行用了中文的「：」",
    "mismatched tag": "标签没有配对",
    "not well-formed (invalid token)": "标签写坏了",
    "no element found": "文件没有写完",
    "mapping values are not allowed here": "YAML 写得不对",
}


@pytest.mark.parametrize(("message", "words"), CHECKED.items())
def test_what_the_checker_of_the_editor_says_has_its_sentence(message: str, words: str) -> None:
    from day6_core.advice.rules import in_short

    assert words in in_short(message, 9, "zh") and in_short(message, 9, "en")
    assert in_short("joint left_wheel is no good at all", 9, "zh") == ""

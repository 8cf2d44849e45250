"""Each hint below an error: the program really fails, its traceback stays Python's, and the next line says what to do."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.advice.rules import Surroundings, hint_below
from day6_core.advice.texts import TEXTS
from day6_core.ros.environment import program_environment
from tests.advice.failing import failed

NEEDED = (
    "<version>0.0.0</version><description>.</description><maintainer email='a@b.c'>a</maintainer><license>MIT</license>"
)
"""What a package.xml has besides its name."""

NODE = "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String, Float64\n"

FAULTS = {
    "if True\n    pass": "line 1 needs a colon",
    "def f()\n    pass": "line 1 needs a colon",
    "x = (1,\n": "the ( in line 1 is never closed",
    "print(1))": "line 1 has a ) too many",
    "x = [1)": "in line 1 a [ is closed by )",
    "x = 'a": "no closing quotation mark",
    "print 'a'": "print(…)",
    "if 1 = 2: pass": "write ==",
    "x = [1 2]": "comma",
    "return 1": "return in line 1 isn't inside a function",
    "if True:\nx = 1": "line 2 belongs to line 1",
    "def f():\nx = 1": "line 2 belongs to line 1",
    "x = 1\n  y = 2": "line 2 is indented deeper",
    "def f():\n    x = 1\n   y = 2": "the indentation of line 3 matches no earlier line",
    "if 1:\n\tx = 1\n        y = 2": "line 3 mixes tabs and spaces",
    "if True：\n    pass": "a Chinese '：'. Code needs the English ':'",
    "print（1）": "a Chinese '（'. Code needs the English '('",
    "print(“a”)": 'a Chinese \'“\'. Code needs the English \'"\'',
    "f(1，2)": "the English ','",
    "x\u3000= 1": "an unusual space",
    "x\u00a0= 1": "an unusual space",
    "class A:\n    def f(): pass\nA().f()": "self is missing in line 2: write def f(self):",
    "'a' + 1": "str(…)",
    "import std_msg": "did you mean std_msgs?",
    "import rlcpy": "did you mean rclpy?",
    "import turtlesim_msgs.msg": (
        "in jazzy the interfaces of turtlesim are in turtlesim: write turtlesim instead of turtlesim_msgs"
    ),
    "import geometry_msgs.mgs": "did you mean geometry_msgs.msg?",
    "import rclpy.nod": "did you mean rclpy.node?",
    "from std_msgs.msg import Strng": "std_msgs.msg has no Strng; did you mean String?",
    "from launch_ros.actions import Nod": "did you mean Node?",
    "from rclpy.node import Nde": "did you mean Node?",
    "String()": "from std_msgs.msg import String",
    "Twist()": "from geometry_msgs.msg import Twist",
    "math.pi": "import math",
    "Node('x')": "from rclpy.node import Node",
    "count = 1\nprint(cuont)": "did you mean count?",
    "from geometry_msgs.msg import Twist\nTwist().liner": (
        "a Twist has no field liner; did you mean linear. Its fields are linear, angular"
    ),
    "from std_msgs.msg import String\nString().text": "Its fields are data",
    "from turtlesim.msg import Pose\nPose().speed": "",  # two packages have a Pose
    "{}['a']": "the dictionary has no key 'a'",
    "import rclpy\nrclpy.node.Node('x')": "import rclpy.node",
    NODE + "Node('x')": "rclpy.init() has to come before",
    NODE + "rclpy.init()\nclass A(Node):\n  def __init__(self):\n    self.create_timer(1, print)\nA()": "super().__init__",
    NODE + "rclpy.init()\nNode('x').create_publisher(String, 'y')": "e.g. 10",
    NODE + "rclpy.init()\nNode('x').create_publisher(String, 'y', 10).publish('a')": "msg = String()",
    NODE + "rclpy.init()\nNode('x').create_subscription(String, 'y', None, 10)": "",
    NODE + "rclpy.init()\nNode('x').create_subscription(String, 'y', print('x'), 10)": "pass the function itself",
    NODE + "rclpy.init()\nNode('x').get_parameter('speed')": "self.declare_parameter('speed', VALUE)",
    NODE + "Float64().data = 1": "write 1.0 instead of 1",
    NODE + "String().data = 1": "data must be of type str: str(…)",
    "raise RuntimeError('my own')": "",
    "import sys; sys.exit(3)": "",
    "int('a')": "",
    "import no_such_thing_at_all": "",
    "undefined_thing_of_mine": "",
}  # fmt: skip


@pytest.mark.process
@pytest.mark.parametrize(("program", "hint"), FAULTS.items())
def test_a_fault_gets_its_hint_and_what_is_not_certain_none(tmp_path: Path, program: str, hint: str) -> None:
    around = Surroundings({**program_environment(), "HOME": str(tmp_path)}, tmp_path)
    output = failed(program, tmp_path)
    said = hint_below(output.replace("\n", "\r\n"), around)
    assert (hint in said and said.startswith("hint: ") and "\n" not in said) if hint else said == ""
    chinese = hint_below(output, Surroundings({**around.variables, "DAY6_LANG": "zh"}, tmp_path))
    assert chinese.startswith("提示：") == bool(hint) and "{" not in chinese.replace("{x}", "")
    assert hint_below(output, Surroundings({**around.variables, "DAY6_HINTS": "off"}, tmp_path)) == ""


@pytest.mark.process
def test_a_package_of_the_workspace_that_is_not_built_or_not_sourced(tmp_path: Path) -> None:
    workspace = tmp_path / "ros2_ws"
    package = workspace / "src" / "car"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(f"<package><name>car_pkg</name>{NEEDED}</package>")
    variables = {"HOME": str(tmp_path), "PYTHONPATH": "", "AMENT_PREFIX_PATH": ""}
    output = failed("import car_pkg", tmp_path)
    said = hint_below(output, Surroundings(variables, tmp_path))
    assert "car_pkg is in ~/ros2_ws/src/car" in said and "cd ~/ros2_ws; colcon build" in said
    share = workspace / "install" / "car_pkg" / "share" / "car_pkg"
    share.mkdir(parents=True)
    (share / "package.xml").touch()
    (workspace / "install" / "setup.bash").write_text("")
    said = hint_below(output, Surroundings(variables, package))
    assert said.endswith("source ~/ros2_ws/install/setup.bash")
    sourced = {**variables, "AMENT_PREFIX_PATH": str(workspace / "install" / "car_pkg")}
    assert hint_below(output, Surroundings(sourced, tmp_path)) == ""


@pytest.mark.process
def test_a_path_in_the_home_of_somebody_else(tmp_path: Path) -> None:
    (tmp_path / "ros2_ws").mkdir()
    around = Surroundings({"HOME": str(tmp_path)}, tmp_path)
    output = failed("open('/home/your_name/ros2_ws/src/a.urdf')", tmp_path)
    said = hint_below(output, around)
    assert "there is no /home/your_name here: your home folder is ~." in said and str(tmp_path) not in said
    assert said.endswith("os.path.expanduser('~/ros2_ws/src/a.urdf')")
    in_launch = (
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): Caught multiple exceptions when trying to "
        "load file of format [py]:\n - FileNotFoundError: [Errno 2] No such file or directory: '/home/me/ros2_ws/a.urdf'\n"
        " - InvalidFrontendLaunchFileError: The launch file may have a syntax error, or its format is unknown\n"
    )
    assert "get_package_share_directory" in hint_below(in_launch, Surroundings(around.variables, tmp_path, launch=True))
    assert hint_below(failed("open('/home/me/nothing/a')", tmp_path), around) == ""
    assert hint_below(failed("open('/nothing/a')", tmp_path), around) == ""


@pytest.mark.process
def test_the_output_of_a_launched_node_and_of_a_broken_launch_file(tmp_path: Path) -> None:
    around = Surroundings({"HOME": str(tmp_path)}, tmp_path, launch=True)
    node = "".join(f"[talker-1] {line}\n" for line in failed("x = {}\nx['speed']", tmp_path).splitlines())
    assert "no key 'speed'" in hint_below(node + "[ERROR] [talker-1]: process has died [pid 7, exit code 1]\n", around)
    broken = (
        "[ERROR] [launch]: Caught exception in launch (see debug for traceback): Caught multiple exceptions when trying to "
        "load file of format [py]:\n - SyntaxError: invalid character '：' (U+FF1A) (c.launch.py, line 2)\n"
    )
    assert "line 2 has a Chinese '：'" in hint_below(broken, around)


@pytest.mark.parametrize(
    ("said", "hint"),
    [
        ("error: package directory 'car' does not exist\n", "the folder car beside it"),
        ("error: can't copy 'launch/a.py': doesn't exist or not a regular file\n", "names launch/a.py"),
        ("error in car setup command: ('EntryPoint must be in', 'x')\n", "'name = package.file:main'"),
        ("SetuptoolsDeprecationWarning: setup.py install is deprecated.\n", ""),
    ],
)
def test_what_setuptools_says(tmp_path: Path, said: str, hint: str) -> None:
    assert hint in hint_below(said, Surroundings({"HOME": str(tmp_path)}, tmp_path)) or not hint
    assert hint or not hint_below(said, Surroundings({"HOME": str(tmp_path)}, tmp_path))


def test_both_languages_fill_in_the_same() -> None:
    import re

    for english, chinese in TEXTS.values():
        assert {*re.findall(r"{(\w+)}", english)} == {*re.findall(r"{(\w+)}", chinese)}, english

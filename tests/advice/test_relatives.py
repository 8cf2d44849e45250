"""Messages that have several causes: each gets the words for its own, and what isn't certain gets no hint."""

from __future__ import annotations

from pathlib import Path

import pytest

from day6_core.advice.below import first_line_below
from day6_core.advice.explain import as_text, explain, scene_of
from day6_core.advice.matching import card_for, cards_in
from day6_core.advice.rules import Surroundings, hint_below
from day6_core.ros.environment import program_environment
from tests.advice.failing import failed
from tests.support.folded import folded

RAISED = 'Traceback (most recent call last):\n  File "a.py", line 3, in <module>\n    f()\n{}\n'

OWN_WORDS = {
    # What a program of the pupil's raises in its own words, which are a tool's too -> the card of its kind.
    "ValueError: not a number": "value-error",
    "ValueError: x is invalid: 3": "value-error",
    "ValueError: unknown option x": "value-error",
    "ValueError: missing operand": "value-error",
    "TypeError: speed must be a number": "type-error",
    "TypeError: expected str instance, int found": "type-error",
    "RuntimeError: Failed to open the door": "runtime-error",
    "RuntimeError: my file exists already: File exists": "runtime-error",
    "RuntimeError: bad filter expression": "runtime-error",
    "Exception: Invalid topic name": "runtime-error",
    "Exception: too many arguments": "runtime-error",
    "Exception: no such job": "runtime-error",
    "Exception: Goal rejected by boss": "runtime-error",
    "AttributeError: 'Arm' object has no attribute '_handle'": "attribute-missing",
    "AttributeError: module 'a.b' has no attribute 'main'": "attribute-missing",
    "ConnectionRefusedError: [Errno 111] Connection refused": "os-error",
    "UnboundLocalError: cannot access local variable 'arg_name' where it is not associated with a value": "local-without-value",
    "ValueError: invalid method signature": "value-error",
    # and what the system says keeps its own
    "OSError: [Errno 28] No space left on device": "disk-full",
    "PermissionError: [Errno 13] Permission denied: '/etc/x'": "permission-denied",
    "IsADirectoryError: [Errno 21] Is a directory: 'x'": "is-a-directory",
}  # fmt: skip


@folded("error, card", OWN_WORDS.items())
def test_the_own_words_of_a_program_are_not_taken_for_a_tools(error: str, card: str) -> None:
    match = next(cards_in(RAISED.format(error)))
    assert match.card.id == card


TOOLS = {
    "bash: rviz2: command not found": "ros-command-not-found",
    "bash: wget: command not found": "command-not-found",
    "foo.py: Error: bad thing": None,
    "serial port timed out waiting for data": None,
    "rm: cannot remove 'ros2_ws': Is a directory": "is-a-directory",
    "error: No such file or directory: ./x.xacro [Errno 2] No such file or directory: './x.xacro'": "no-such-file",
    "Error:   Error=XML_ERROR_EMPTY_DOCUMENT ErrorID=13 (0xd) Line number=0": "urdf-empty",
    "Error:   Error=XML_ERROR_PARSING_ATTRIBUTE ErrorID=7 (0x7) Line number=3": "urdf-xml",
    "bash: export: `2x=3': not a valid identifier": "variable-name",
    "ValueError: 'no.launch.py' is not a valid package name": "launch-file-or-package",
    "bash: cd: too many arguments": "too-many-words",
    "bash: [: too many arguments": "shell-test",
    "pwd: extra operand 'x'": "too-many-words",
    "bash: kill: (1) - Operation not permitted": "process-of-others",
    "touch: cannot touch 'x': Operation not permitted": "read-only",
    "rm: refusing to remove '.' or '..' directory: skipping '.'": "rm-refused",
    "rm: it is dangerous to operate recursively on '/'": "rm-refused",
    "cp: 'a' and 'a' are the same file": "same-file",
    "wget: missing URL": "operand-missing",
    "curl: option --zz: is unknown": None,
    "sed: -e expression #1, char 25: unknown command: `1'": "expression-wrong",
    "/home/me/car.py:3: UserWarning: slow": "python-warning",
    "/opt/ros/jazzy/lib/python3.12/site-packages/ros2doctor/api/__init__.py: 162: UserWarning: x": "doctor-warns",
    "[ERROR] [1.5] [car]: Service call failed x": "service-call-failed",
    "rviz2: this is not an RViz configuration": "rviz-config",
    "wget: unable to resolve host address 'x'": "download-failed",
}


@folded("line, card", TOOLS.items())
def test_a_name_alone_does_not_choose_a_card(line: str, card: str | None) -> None:
    match = card_for(line)
    assert (match.card.id if match is not None else None) == card


RCLPY = "import rclpy\nfrom rclpy.node import Node\nfrom std_msgs.msg import String\nrclpy.init()\nn = Node('a')\n"
CLASS = (
    "import rclpy\nfrom rclpy.node import Node\nclass A(Node):\n    def __init__(self):\n        {}\nrclpy.init()\n{}\n"
)

HINTS = {
    # A program -> words of its hint, '' if nothing is certain.
    "cmd.linear.x = 1": "",
    "print(code)": "",
    "print(string)": "",
    "p = Path('a')": "",
    "d = Duration(seconds=1)": "",
    "time.sleep(1)": "import time",
    "import math\nprint(math,pi)": "pi belongs to the module math",
    "print(你好)": "a text needs quotation marks in line 1: '你好'",
    "q = QoSProfile(depth=1)": "from rclpy.qos import QoSProfile",
    "from rclpy import Node": "Node is not in rclpy; write from rclpy.node import Node",
    "from launch.actions import Node": "write from launch_ros.actions import Node",
    "from std_msgs.msg import Twist": "Twist is not in std_msgs.msg; write from geometry_msgs.msg import Twist",
    "from std_msgs import String": "write from std_msgs.msg import String",
    "import geometry_msgs.msg.Twist": "write from geometry_msgs.msg import Twist",
    "class Pose:\n    pass\nPose().speed": "",
    "class Arm:\n    pass\nArm()._handle": "",
    "x = 1\nif x == 1:\n    pass\nelse if x == 2:\n    pass": "line 4: Python has elif instead of else if",
    "x = 1\nx++": "line 2: Python has no ++ and no --; write x += 1",
    "if 1 && 2:\n    pass": "line 1: Python has and instead of &&",
    "if 1 || 2:\n    pass": "line 1: Python has or instead of ||",
    "x = 1\nif !x:\n    pass": "line 2: Python has not instead of !",
    "for (i=0; i<3; i++):\n    pass": "line 1: write a counting loop as for i in range(TIMES):",
    "if 1 then:\n    pass": "line 1: Python has no then",
    "if 1 {\n    x = 1\n}": "line 1: Python has no braces here",
    "int x = 1": "line 1: Python has no int before a name",
    "void f() {\n}": "line 1: a function starts with def in Python, not with void",
    "class = 1": "line 1: class is a word of Python",
    "print('hello”)": "line 1 has a Chinese quotation mark ”",
    "print(你好 世界)": "a text needs quotation marks in line 1: '你好 世界'",
    "print('a && b' 5)": "is a comma missing in line 1",
    "5 = x": "line 1: the name goes left of =",
    "x = 1\nif x = 1:\n    pass": "to compare two values, write ==",
    CLASS.format("super().__init__()", "A()"): "super().__init__('NAME')",
    CLASS.format("super.__init__('a')", "A()"): "brackets are missing after super",
    CLASS.format("self.create_timer(1, print)", "A()"): "the first line of __init__ has to be super().__init__('NAME')",
    CLASS.format("super().__init__('a'); self.x = self._y", "A()"): "",
    RCLPY + "n.create_publisher('String', 'x', 10)": "the type String in line 6 has no quotation marks",
    RCLPY + "n.create_publisher(String, 'x', 10).publish(String)": "publishes the class String itself, not a message",
    "import rclpy\nrclpy.init()\nrclpy.shutdown()\nfrom rclpy.node import Node\nNode('a')": "no node can be made after",
}  # fmt: skip


@pytest.mark.process
@pytest.mark.parametrize(("program", "hint"), HINTS.items(), ids=lambda text: text.split("\n")[-1][:40])
def test_a_hint_is_for_the_cause_that_the_program_shows(tmp_path: Path, program: str, hint: str) -> None:
    around = Surroundings({**program_environment(), "HOME": str(tmp_path)}, tmp_path)
    output = failed(program, tmp_path)
    said = hint_below(output, around)
    assert (hint in said) if hint else said == "", said
    chinese = Surroundings({**around.variables, "DAY6_LANG": "zh"}, tmp_path)
    below = hint_below(output, chinese) or first_line_below(output, chinese)
    assert below.startswith("提示：" if hint else "意思：") and "{" not in below.replace("{x}", "")


MEANS = {
    # A program -> words of its card.
    "'a' - 1": "1 mixes a number and a text",
    "for i in 5: pass": "to count up to it, write range(5)",
    "x = 5\nx[0]": "There is [ ] after a int, but you cannot take items out of that (line 2)",
    "[1]['a']": "The brackets after a list need a whole number",
    "int('abc')": "'abc' cannot be turned into a number (line 1)",
    "a, b = 1, 2, 3": "The number of names left of the = differs from the number of values right of it",
    "import os\nos.environ['NOPE']": "the environment variable NOPE, which is not set (line 2)",
    "x = None\nx.foo": "What is before the dot is None",
    RCLPY + "n.get_logger.info('a')": "() is missing after get_logger in line 6",
    RCLPY + "rclpy.spin(Node)": "gives spin the class Node, but it needs a node",
    RCLPY + "n.declare_parameter('x', 1)\nn.get_parameter('x') + 1": "returns the parameter, not its value: add .value",
    RCLPY + "n.create_timer(print, 0.5)": "One of the values for rclpy has the wrong type",
    "from geometry_msgs.msg import Twist\nt = Twist()\nt.linear = 1.0": "linear is a whole Vector3, not a number",
    "from std_msgs.msg import Float64MultiArray\nFloat64MultiArray().data = ['1', '2']": "data takes a list of decimal numbers",
    "from turtlesim.srv import SetPen\nSetPen.Request().r = 300": "r must be between the two numbers",
    "class A:\n    def _init_(self, x): pass\nA(1)": "A got values in its brackets, but it takes none",
    "class A:\n    def go(self): pass\nA.go()": "go has to be called on an object of A",
    "input()": "The program waits in input()",
}  # fmt: skip


@pytest.mark.process
@pytest.mark.parametrize(("program", "means"), MEANS.items(), ids=lambda text: text.split("\n")[-1][:40])
def test_a_card_says_what_the_message_means_here(tmp_path: Path, program: str, means: str) -> None:
    around = Surroundings({**program_environment(), "HOME": str(tmp_path)}, tmp_path)
    output = failed(program, tmp_path)
    match = next(cards_in(output))
    assert means in as_text(explain(match, scene_of(match, around, output=output), "en"), "en", 300)


def test_the_lines_of_a_program_that_a_report_repeats_are_no_messages() -> None:
    code = "raise Boom(\"ls: cannot access 'x': No such file or directory\")"
    output = (
        f'Traceback (most recent call last):\n  File "a.py", line 3, in <module>\n    {code}\n__main__.Boom: my own\n'
    )
    (match,) = [each for each in cards_in(output) if not each.card.echo]
    assert (match.card.id, match.line) == ("exception-of-its-own", "__main__.Boom: my own")
    launched = "".join(f"[go-1] {line}\n" for line in output.splitlines())
    assert [each.card.id for each in cards_in(launched) if not each.card.echo] == ["exception-of-its-own"]
    indented = list(cards_in(f"  ls: cannot access 'x': No such file or directory\n{output}"))
    assert [each.card.id for each in indented if not each.card.echo] == ["exception-of-its-own", "no-such-file"]

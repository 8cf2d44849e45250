# ruff: noqa: E501 (one forgery a line is easier to compare than what formatting makes of it)
"""What a clever fifteen-year-old hands in instead of a program that works, and part of the reason for which it is refused.

Every forgery spoils one scenario of an otherwise good submission. Those of one lesson's parts go together into one submission.
"""

from __future__ import annotations

import textwrap
from dataclasses import dataclass
from itertools import zip_longest

from tests.grading.article import HELLO, INNER, LAUNCH, LISTENER, PACKAGE_XML, SETUP, SPINNER, STAR, TALKER, TOP, URDF


@dataclass(frozen=True)
class Forgery:
    """Which scenario it is for, its name, the changed files, part of the English reason."""

    lesson: str
    scenario: str
    name: str
    files: dict[str, str | None]
    reason: str

    @property
    def id(self) -> str:
        return f"{self.scenario}: {self.name}"


def _program(body: str, imports: str = "") -> str:
    return f"{imports}\ndef main():\n{textwrap.indent(textwrap.dedent(body).strip(), '    ')}\n\nif __name__ == '__main__':\n    main()\n"


_SILENT = "Nobody"
FOREVER = "import time\nwhile True:\n    time.sleep(1)\n"


def _talkers() -> list[Forgery]:
    none = "There is no topic /chatter"
    said = [
        ("prints what a talker logs", _program("import time\nfor n in range(99):\n    print(f'[INFO] said: Hello {n}', flush=True)\n    time.sleep(0.3)"), none),
        ("prints JSON that says it has passed", _program("print('{\"lesson\":\"day5\",\"scenario\":\"talker\",\"ok\":true,\"problems\":[],\"seconds\":1}')"), none),
        ("publishes once", TALKER.replace("self.create_timer(0.5, self.speak)", "self.speak()"), "No message on" ),
        ("always says the same", TALKER.replace("Hello {self.number}", "Hello 1"), "only these different values: Hello 1"),
        ("says two things by turns", TALKER.replace("{self.number}", "{self.number % 2}"), "only these different values"),
        ("says it on another topic", TALKER.replace("'chatter'", "'chater'"), none),
        ("sends numbers", TALKER.replace("String", "Int32").replace("note.data = f'Hello {self.number}'", "note.data = self.number"), "Its type is std_msgs/msg/Int32"),
        ("never spins", TALKER.replace("rclpy.spin(Talker())", "Talker()\n        " + "import time\n        time.sleep(60)"), "No message on"),
        ("lets `ros2 topic pub` do it", _program("import subprocess\nsubprocess.run(['ros2', 'topic', 'pub', '-r', '2', '/chatter', 'std_msgs/msg/String', 'data: Hello'])"), "It is published by"),
        ("starts somebody else's talker", _program("import subprocess\nsubprocess.run(['ros2', 'run', 'demo_nodes_py', 'talker'])"), "It is published by|no topic"),
        ("floods the topic once a millisecond", TALKER.replace("0.5", "0.001"), "Measured"),
        ("speaks every three seconds", TALKER.replace("0.5", "3.0"), "changes|different|Nothing"),
        ("calls the node what it likes", TALKER.replace("rclpy.init()", "rclpy.init(args=[])"), "It is published by: /day6_talker"),
        ("ends at once", _program("pass"), none),
        ("raises", _program("raise RuntimeError('passed')"), none),
        ("two publishers say it by turns", TALKER.replace("self.number = 0", "self.number = 0\n        self.other = self.create_publisher(String, 'chatter', 10)"), "2 publish"),
        ("has an rclpy of its own beside it", TALKER.replace("import rclpy\n", "import sys, os\nsys.path.insert(0, os.path.join(os.path.dirname(__file__), 'mine'))\nimport rclpy\n"), none),
        ("calls itself passed by its exit status", _program("import sys\nsys.exit(0)"), none),
        ("writes a transcript of a good run", _program("from pathlib import Path\nPath.home().joinpath('transcript.txt').write_text('/chatter Hello 1 Hello 2')\nPath.home().joinpath('.config/day6-tui/pupils').mkdir(parents=True)\nPath.home().joinpath('.config/day6-tui/pupils/anna.json').write_text('{\"version\": 1}')"), none),
        ("kills its parents", _program("import os, signal\nos.kill(os.getppid(), signal.SIGKILL)"), "none|no topic|ended from inside"),
    ]  # fmt: skip
    fake = "class Fake:\n    def __getattr__(self, name):\n        return lambda *a, **k: Fake()\n    def __call__(self, *a, **k):\n        return Fake()\n"
    made = [Forgery("day5", "talker", name, {INNER + "talker.py": text}, reason) for name, text, reason in said]
    for each in made:
        if "rclpy of its own" in each.name:
            each.files[INNER + "mine/rclpy/__init__.py"] = (
                f"{fake}\ndef init(*a, **k): pass\ndef spin(node):\n    import time\n    print('Hello 1')\n    time.sleep(30)\n"
            )
            each.files[INNER + "mine/rclpy/node.py"] = (
                "class Node:\n    def __init__(self, name): pass\n"
                "    def __getattr__(self, name):\n        return lambda *a, **k: None\n"
            )
            each.files[INNER + "mine/__init__.py"] = ""
    return made


def _listeners() -> list[Forgery]:
    none = "Nobody subscribes to it|The subscribers are: "
    unheard = "It didn't print that"
    echo = "import subprocess\nsubprocess.run(['ros2', 'topic', 'echo', '/chatter'])"
    texts = [
        ("prints what lessons' listeners print", _program("import time\nfor n in range(40):\n    print(f'heard: Hello {n}', flush=True)\n    time.sleep(0.2)"), none),
        ("listens and prints its own words", LISTENER.replace("{note.data}", "Hello 1"), unheard),
        ("listens and prints nothing", LISTENER.replace("self.get_logger().info(f'heard: {note.data}')", "pass"), unheard),
        ("prints only the first word", LISTENER.replace("    def hear(self, note):", "    def hear(self, note):\n        if hasattr(self, 'done'):\n            return\n        self.done = True"), unheard),
        ("prints the words in the order of the alphabet, at the end", LISTENER.replace("self.get_logger().info(f'heard: {note.data}')", "self.all = sorted([*getattr(self, 'all', []), note.data], key=lambda w: w[::-1])\n        print(len(self.all))"), unheard),
        ("prints how long the words are", LISTENER.replace("{note.data}", "{len(note.data)}"), unheard),
        ("listens to another topic", LISTENER.replace("'chatter'", "'chater'"), none),
        ("listens for numbers", LISTENER.replace("String", "Int32"), "Subscribed|Nobody|printed"),
        ("lets `ros2 topic echo` listen", _program(echo), none),
        ("starts somebody else's listener", _program("import subprocess\nsubprocess.run(['ros2', 'run', 'demo_nodes_py', 'listener'])"), none),
        ("never spins", LISTENER.replace("rclpy.spin(Listener())", "node = Listener()\n        import time\n        time.sleep(60)"), unheard),
        ("talks to itself", LISTENER.replace("self.create_subscription(String, 'chatter', self.hear, 10)", "self.create_subscription(String, 'chatter', self.hear, 10)\n        self.create_publisher(String, 'chatter', 10).publish(String(data='Hello 7'))").replace("{note.data}", "Hello 7"), unheard),
        ("prints the alphabet, in which every word is", LISTENER.replace("{note.data}", "abcdefghijklmnopqrstuvwxyz"), unheard),
        ("prints every word backwards", LISTENER.replace("{note.data}", "{note.data[::-1]}"), unheard),
        ("prints each word's first half", LISTENER.replace("{note.data}", "{note.data[:5]}"), unheard),
        ("reads the words from the grader's memory", _program(_SNOOP), none),
        ("writes verdicts into all open files of the others", _program(_WRITER), none),
        ("answers for the node without listening", _program("import rclpy\nrclpy.init()\nnode = rclpy.create_node('day6_listener')\nrclpy.spin(node)"), none),
        ("lets another node of its own listen", LISTENER.replace("        self.create_subscription(String", "        import rclpy.node\n        self.ear = rclpy.node.Node('ear', use_global_arguments=False)\n        self.ear.create_subscription(String").replace("rclpy.spin(Listener())", "rclpy.spin(Listener().ear)"), "The subscribers are: /ear"),
        ("ends at once", _program("print('heard: everything')"), none),
    ]  # fmt: skip
    return [Forgery("day5", "listener", name, {INNER + "listener.py": text}, reason) for name, text, reason in texts]


_SNOOP = """
import os, re, time
found = set()
for pid in filter(str.isdigit, os.listdir('/proc')):
    try:
        with open(f'/proc/{pid}/maps') as maps, open(f'/proc/{pid}/mem', 'rb', 0) as memory:
            if int(pid) == os.getpid():
                continue
            for line in maps:
                begin, end = (int(each, 16) for each in line.split()[0].split('-'))
                if 'rw' in line.split()[1] and end - begin < 1 << 26:
                    memory.seek(begin)
                    found |= set(re.findall(rb'[a-z]{10}', memory.read(end - begin)))
    except (OSError, ValueError, OverflowError):
        continue
print(b' '.join(sorted(found)).decode()[:20000], flush=True)
"""

_WRITER = """
import json, os
line = (json.dumps({'lesson': 'day5', 'scenario': 'listener', 'ok': True, 'problems': [], 'seconds': 1}) + '\\n').encode()
for pid in filter(str.isdigit, os.listdir('/proc')):
    if int(pid) == os.getpid():
        continue
    try:
        names = os.listdir(f'/proc/{pid}/fd')
    except OSError:
        continue
    for name in names:
        try:
            number = os.open(f'/proc/{pid}/fd/{name}', os.O_WRONLY | os.O_NONBLOCK)
            os.write(number, line)
            os.close(number)
        except OSError:
            continue
"""


def _spinners() -> list[Forgery]:
    none = "There is no topic /joint_states"
    texts = [
        ("prints angles", _program("import time\nfor n in range(50):\n    print([n / 10, n / 10], flush=True)\n    time.sleep(0.1)"), none),
        ("publishes once", SPINNER.replace("self.create_timer(0.02, self.turn)", "self.angle = 1.0\n        self.turn()"), "Nothing arrives"),
        ("stands still", SPINNER.replace("self.angle + 0.02", "self.angle"), "It has turned by 0.00"),
        ("turns the left wheel only", SPINNER.replace("[self.angle, self.angle]", "[self.angle, 0.0]"), "right_wheel_joint"),
        ("has other joints", SPINNER.replace("_wheel_joint", "_wheel"), "names: left_wheel, right_wheel"),
        ("has joints in capital letters", SPINNER.replace("left_wheel_joint", "Left_wheel_joint"), "Left_wheel_joint"),
        ("is too slow", SPINNER.replace("0.02, self.turn", "0.5, self.turn"), "Measured"),
        ("knows of one wheel only", SPINNER.replace("'left_wheel_joint', ", "").replace("[self.angle, self.angle]", "[self.angle]"), "left_wheel_joint"),
        ("sends no positions", SPINNER.replace("state.position = [self.angle, self.angle]", "pass"), "names"),
        ("sends velocities only", SPINNER.replace("state.position =", "state.velocity ="), "names"),
        ("has another type", SPINNER.replace("sensor_msgs.msg", "std_msgs.msg").replace("JointState", "Float64").replace("state.header.stamp = self.get_clock().now().to_msg()", "pass").replace("state.name = ['left_wheel_joint', 'right_wheel_joint']", "pass").replace("state.position = [self.angle, self.angle]", "state.data = self.angle"), "std_msgs/msg/Float64"),
        ("stamps nothing", SPINNER.replace("state.header.stamp = self.get_clock().now().to_msg()", "pass"), "header.stamp.sec"),
        ("lets joint_state_publisher do it", _program("import subprocess\nsubprocess.run(['ros2', 'run', 'joint_state_publisher', 'joint_state_publisher'])"), "is published by|no topic"),
        ("publishes on another topic", SPINNER.replace("'joint_states'", "'joint_state'"), none),
        ("never spins", SPINNER.replace("rclpy.spin(Spinner())", "Spinner()\n        import time\n        time.sleep(60)"), "Nothing arrives"),
        ("trembles: there and back", SPINNER.replace("self.angle = (self.angle + 0.02) % (2 * math.pi)", "self.angle = 0.0001 - self.angle"), "It has turned by"),
    ]  # fmt: skip
    return [
        Forgery("day6", "spinner", name, {INNER + "wheel_spinner.py": text}, reason) for name, text, reason in texts
    ]


def _robots() -> list[Forgery]:
    texts = [
        ("is empty", "", "urdf|robot|document"),
        ("is a text that says it is right", "robot name is:: day6_bot ---------- Successfully Parsed XML", "robot|syntax|XML|document"),
        ("has another name", URDF.replace('name="day6_bot"', 'name="bot"', 1), "day6_bot"),
        ("has no right wheel", URDF[: URDF.index('  <link name="right_wheel"')] + "</robot>", "right_wheel"),
        ("has fixed wheels", URDF.replace("continuous", "fixed"), "type continuous"),
        ("has wheels that turn about x", URDF.replace('<axis xyz="0 1 0"/>', '<axis xyz="1 0 0"/>'), "axis"),
        ("has both wheels on the left", URDF.replace('xyz="0 -0.15 0.05"', 'xyz="0 0.15 0.05"'), "xyz"),
        ("has its joints in a comment", URDF.replace("<joint", "<!--<joint").replace("</joint>", "</joint>-->"), "robot|link|joint|root"),
        ("has its wheels in the ground", URDF.replace("0.15 0.05", "0.15 0"), "xyz"),
        ("hangs the wheels on one another", URDF.replace('<parent link="base_link"/>\n    <child link="right_wheel"/>', '<parent link="left_wheel"/>\n    <child link="right_wheel"/>'), "parent"),
        ("is not closed", URDF.replace("</robot>", ""), "XML|syntax|robot|closed|document"),
        ("is a picture of a robot", "\x89PNG\r\n" + "x" * 200, "XML|syntax|robot|document"),
    ]  # fmt: skip
    return [Forgery("day6", "urdf", name, {TOP + "urdf/day6_bot.urdf": text}, reason) for name, text, reason in texts]


def _launches() -> list[Forgery]:
    faker = (
        "import rclpy\nfrom rclpy.node import Node\nfrom geometry_msgs.msg import TransformStamped\nfrom tf2_msgs.msg import TFMessage\n"
        "from std_msgs.msg import String\n\n\ndef main():\n    rclpy.init()\n    node = Node('robot_state_publisher')\n"
        "    out = node.create_publisher(TFMessage, '/tf', 10)\n\n    def turn():\n        both = []\n"
        "        for side in ('left', 'right'):\n            each = TransformStamped()\n"
        "            each.header.stamp = node.get_clock().now().to_msg()\n            each.header.frame_id = 'base_link'\n"
        "            each.child_frame_id = side + '_wheel'\n            each.transform.rotation.w = 1.0\n            both.append(each)\n"
        "        out.publish(TFMessage(transforms=both))\n\n    node.create_timer(0.05, turn)\n    rclpy.spin(node)\n"
    )
    fake_launch = LAUNCH.replace(
        "'robot_state_publisher',\n            executable='robot_state_publisher'",
        "'day6_publisher',\n            executable='hello'",
    )
    texts: list[tuple[str, dict[str, str | None], str]] = [
        ("starts nothing", {TOP + "launch/day6_display.launch.py": "from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"}, "no node /robot_state_publisher"),
        ("prints that it has started", {TOP + "launch/day6_display.launch.py": "print('[INFO] [robot_state_publisher-1]: process started with pid [42]')\nfrom launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n"}, "no node /robot_state_publisher"),
        ("is not installed", {TOP + "setup.py": SETUP.replace("        (os.path.join('share', package_name, 'launch'), glob('launch/*.launch.py')),\n", "")}, "no node /robot_state_publisher"),
        ("starts a faker of TF that knows no angles", {TOP + "launch/day6_display.launch.py": fake_launch, INNER + "hello.py": faker}, "Nobody does|published there|It is turned by|Nothing was"),
        ("gives no description", {TOP + "launch/day6_display.launch.py": LAUNCH.replace("{'robot_description': robot}", "{'robot': robot}")}, "no node|Nobody|published"),
        ("describes another robot", {TOP + "launch/day6_display.launch.py": LAUNCH.replace("file.read()", "'<robot name=\"a\"><link name=\"base_link\"/></robot>'")}, "joints|has"),
        ("has the wheels' axes wrong in what it publishes", {TOP + "launch/day6_display.launch.py": LAUNCH.replace("file.read()", "file.read().replace('continuous', 'fixed')")}, "joint|turned|Nobody|has"),
        ("sleeps", {TOP + "launch/day6_display.launch.py": "import time\ntime.sleep(100)\n"}, "no node /robot_state_publisher"),
    ]  # fmt: skip
    return [Forgery("day6", "launch", name, files, reason) for name, files, reason in texts]


def _stars() -> list[Forgery]:
    little = "no straight line"
    teleport = (
        "import math, rclpy\nfrom turtlesim.srv import TeleportAbsolute\nrclpy.init()\nnode = rclpy.create_node('star')\n"
        "client = node.create_client(TeleportAbsolute, '/turtle1/teleport_absolute')\nclient.wait_for_service()\n"
    )
    pose = (
        "import math, time, rclpy\nfrom turtlesim.msg import Pose\nrclpy.init()\nnode = rclpy.create_node('star')\n"
        "out = node.create_publisher(Pose, '/turtle1/pose', 10)\nfor n in range(20):\n    for k in range(10):\n"
        "        p = Pose(); p.x = 5 + 3 * math.cos(n * 2.513); p.y = 5 + 3 * math.sin(n * 2.513); out.publish(p)\n        time.sleep(0.01)\n"
    )
    texts = [
        ("prints a pentagram", "print('*')\n", little),
        ("publishes poses of a pentagram", pose, little),
        ("draws four lines", STAR.replace("range(5)", "range(4)"), "The last straight lines"),
        ("draws a square", STAR.replace("2.5132741", "1.5707963").replace("range(5)", "range(4)"), "The last straight lines"),
        ("draws a pentagon", STAR.replace("2.5132741", "1.2566371"), "The last straight lines"),
        ("draws lines of five lengths", STAR.replace("press(3.0, 0.0)", "press(1.0 + 0.5 * side, 0.0)"), "The last straight lines"),
        ("lifts the pen", STAR.replace("for side in range(5):", "from turtlesim.srv import SetPen\npen = node.create_client(SetPen, '/turtle1/set_pen')\npen.wait_for_service()\nrclpy.spin_until_future_complete(node, pen.call_async(SetPen.Request(off=1)))\nfor side in range(5):"), little),
        ("steers another turtle", STAR.replace("turtle1/", "turtle2/").replace("while keys.get_subscription_count() == 0:", "while False:"), little),
        ("runs in circles", STAR.replace("press(3.0, 0.0)", "press(2.0, 2.0)").replace("press(0.0, 2.5132741)", "pass"), "straight line"),
        ("is not Python", "pentagram\n", little),
        ("is empty", "", little),
        ("wipes what it has drawn", STAR + "from std_srvs.srv import Empty\nclear = node.create_client(Empty, '/clear')\nclear.wait_for_service()\n", "") ,
    ]  # fmt: skip
    made = [
        Forgery("day3", "elsewhere", name, {"home/star.py": text}, reason) for name, text, reason in texts if reason
    ]
    jump = teleport + (
        "for n in range(6):\n    a = n * 2.5132741\n    request = TeleportAbsolute.Request(x=5.5 + 2 * math.cos(a), y=5.5 + 2 * math.sin(a))\n"
        "    rclpy.spin_until_future_complete(node, client.call_async(request))\n"
    )
    turn = STAR.replace("    press(0.0, 2.5132741)", "    turn(2.5132741)").replace(
        "for side in range(5):",
        "from turtlesim.srv import TeleportRelative\nplace = node.create_client(TeleportRelative, 'turtle1/teleport_relative')\n"
        "place.wait_for_service()\n\n\ndef turn(angle):\n"
        "    rclpy.spin_until_future_complete(node, place.call_async(TeleportRelative.Request(angular=angle)))\n\n\nfor side in range(5):",
    )
    spawn = STAR.replace("rclpy.init()", "rclpy.init(args=[])").replace(
        "while keys.get_subscription_count()",
        "from turtlesim.srv import Spawn\nbirth = node.create_client(Spawn, 'spawn')\nbirth.wait_for_service()\n"
        "rclpy.spin_until_future_complete(node, birth.call_async(Spawn.Request(x=5.5, y=5.5, name='turtle1')))\n"
        "while keys.get_subscription_count()",
    )
    teleports = "by a teleport service"
    made.append(Forgery("day3", "elsewhere", "jumps from corner to corner", {"home/star.py": jump}, teleports))
    made.append(
        Forgery("day3", "elsewhere", "drives its lines and turns by teleport", {"home/star.py": turn}, teleports)
    )
    made.append(
        Forgery("day3", "other-turtle", "brings back turtle1 and draws with it", {"home/star.py": spawn}, "not: ")
    )
    fixed = STAR.replace("'turtle1/cmd_vel', 10)", "'turtle1/cmd_vel', 10)").replace(
        "rclpy.init()", "rclpy.init(args=[])"
    )
    made.append(Forgery("day3", "other-turtle", "works with turtle1 only", {"home/star.py": fixed}, little))
    made.append(Forgery("day3", "elsewhere", "is not there", {"home/star.py": None}, "There is none"))
    return made


def _packages() -> list[Forgery]:
    late = "import os, pathlib\n"
    write = (
        "home = pathlib.Path(os.environ['HOME'])\nlib = home / 'ros2_ws/install/day6_publisher/lib/day6_publisher'\n"
        "lib.mkdir(parents=True, exist_ok=True)\n(lib / 'hello').write_text('#!/bin/sh\\necho This is my own package!\\n')\n(lib / 'hello').chmod(0o755)\n"
        "share = home / 'ros2_ws/install/day6_publisher/share/day6_publisher'\nshare.mkdir(parents=True, exist_ok=True)\n"
        "(share / 'package.xml').write_text('<package/>')\n"
        "(home / 'ros2_ws/build/day6_publisher').mkdir(parents=True, exist_ok=True)\n"
        "(home / 'ros2_ws/build/day6_publisher/colcon_build.rc').write_text('0')\n"
    )
    bashrc = "(pathlib.Path(os.environ['HOME']) / '.bashrc').write_text('colcon() { echo Summary: 1 package finished; }\\nros2() { echo Hi; }\\n')\n"
    texts: list[tuple[str, str, dict[str, str | None], str]] = [
        ("builds", "setup.py writes into install and fails", {TOP + "setup.py": late + write + "raise SystemExit(1)\n"}, "colcon says"),
        ("builds", "setup.py writes into install and calls no setup()", {TOP + "setup.py": late + write}, "colcon says"),
        ("builds", "setup.py writes a .bashrc whose colcon always succeeds", {TOP + "setup.py": late + bashrc + "raise SystemExit(1)\n"}, "colcon says"),
        ("builds", "has only what a build leaves", {TOP + "setup.py": None, TOP + "package.xml": None, TOP + "install/day6_publisher/share/day6_publisher/package.xml": PACKAGE_XML}, "no package of this name|colcon says"),
        ("builds", "is called otherwise", {TOP + "package.xml": PACKAGE_XML.replace("day6_publisher", "day6_publishers")}, "no package of this name"),
        ("builds", "names no dependencies", {TOP + "package.xml": PACKAGE_XML.replace("  <depend>std_msgs</depend>\n", "")}, "Missing: std_msgs"),
        ("builds", "is a CMake package", {TOP + "package.xml": PACKAGE_XML.replace("ament_python", "ament_cmake")}, "colcon says|ament_cmake"),
        ("runs", "has no such executable", {TOP + "setup.py": SETUP.replace("            'hello = day6_publisher.hello:main',\n", "")}, "hello"),
        ("runs", "prints nothing", {INNER + "hello.py": HELLO.replace("print('This is my own package!')", "pass")}, "It didn't print that"),
        ("runs", "fails after printing", {INNER + "hello.py": HELLO.replace("package!')", "package!')\n    raise SystemExit(3)")}, "status 3"),
        ("runs", "names a module that is not there", {TOP + "setup.py": SETUP.replace("day6_publisher.hello:main", "day6_publisher.hallo:main")}, "status 1"),
        ("runs", "writes a .bashrc whose ros2 fails", {INNER + "hello.py": "import os\n\n\ndef main():\n    os.kill(os.getpid(), 9)\n"}, "status"),
    ]  # fmt: skip
    return [Forgery("day4", scenario, name, files, reason) for scenario, name, files, reason in texts]


def _groups() -> dict[str, tuple[tuple[str, ...], list[list[Forgery | None]]]]:
    packages, robots, launches = _packages(), _robots(), _launches()
    talkers = _talkers()
    return {
        "stars": (("day3",), [list(_stars())]),
        "builds": (("day4",), [[each for each in packages if each.scenario == "builds"]]),
        "programs": (
            ("day4", "day5", "day6"),
            [
                [each for each in packages if each.scenario == "runs"],
                [*talkers[:-1], None, talkers[-1]],  # the last one kills the judge: nothing after it is played
                list(_listeners()),
                list(_spinners()),
                [*robots, *launches],
            ],
        ),
    }


GROUPS = _groups()
"""Which lessons are played, and the parts that are spoiled independently of one another (None: this part is left good)."""


def together(group: str) -> list[list[Forgery]]:
    """The forgeries of each submission, one of each part: parts of one lesson do not disturb one another."""
    return [[each for each in spoiled if each is not None] for spoiled in zip_longest(*GROUPS[group][1])]


ALL = [forgery for group in GROUPS for spoiled in together(group) for forgery in spoiled]

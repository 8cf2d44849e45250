"""Whatever a file, a log line, a name or a robot holds: the user's terminal gets it as text.

Every test looks at the bytes on the outer pty and accepts nothing but text, colours and what our own renderer makes.
"""

from __future__ import annotations

import os
import sys
from typing import TYPE_CHECKING

import pytest

from tests.e2e.hostile import HOSTILE, MARK, SEQUENCES, SHORT, foreign, whole
from tests.support.waiting import until

if TYPE_CHECKING:
    from pathlib import Path

    from tests.e2e.place import Place
    from tests.e2e.terminal import Terminal

pytestmark = [
    pytest.mark.person,
    pytest.mark.skipif(os.name != "posix", reason="no pseudo-terminals, and no such names of files"),
]

NODE = f"""\
import rclpy
from rclpy.node import Node
from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import ParameterDescriptor
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_msgs.msg import TFMessage

EVIL = {HOSTILE!a}
rclpy.init()
node = Node('evil')
described = ParameterDescriptor(description=EVIL, additional_constraints=EVIL)
node.declare_parameter('word', EVIL, described)
node.declare_parameter('a\\n  faked' + EVIL, 1)
chatter = node.create_publisher(String, 'chatter', 10)
tf = node.create_publisher(TFMessage, 'tf', 10)
joints = node.create_publisher(JointState, 'joint_states', 10)

def tick():
    node.get_logger().info(EVIL)
    chatter.publish(String(data=EVIL))
    moved = TransformStamped(child_frame_id='child' + EVIL)
    moved.header.frame_id = 'base' + EVIL
    moved.header.stamp = node.get_clock().now().to_msg()
    tf.publish(TFMessage(transforms=[moved]))
    joints.publish(JointState(name=['joint' + EVIL], position=[1.0]))

node.create_timer(0.1, tick)
rclpy.spin(node)
"""

RAW = "".join(char for char in SEQUENCES["title"] + SEQUENCES["DCS"] + "\x9b2J\u202e\u2028\u200b" if char != "<")
ROBOT = f"""\
<robot name="robot{RAW}">
  <link name="base{RAW}"/>
  <link name="wheel{RAW}"/>
  <joint name="{RAW}joint" type="revolute">
    <parent link="base{RAW}"/><child link="wheel{RAW}"/><axis xyz="0 0 1"/>
    <limit lower="-1" upper="1" effort="1" velocity="1"/>
  </joint>
</robot>
"""


def ended(screen: Terminal) -> bytes:
    screen.wait_end()
    return bytes(screen.output)


def hostile_files(folder: Path) -> None:
    """Files and folders whose names and contents attack."""
    folder.mkdir(exist_ok=True)
    (folder / SHORT).mkdir()
    (folder / "text.txt").write_text(HOSTILE.replace("\r", "") + "\n", encoding="utf-8", newline="")
    (folder / ("file" + SHORT + ".py")).write_text("print(1)\n")
    with open(os.fsencode(folder) + b"/bytes\xff\x9b\x1b]0;T\x07", "wb"):
        pass
    (folder / "evil.urdf").write_text(ROBOT, encoding="utf-8")
    (folder / "evil.py").write_text(NODE, encoding="utf-8")
    package = folder / "src" / "pkg"
    package.mkdir(parents=True)
    (package / "package.xml").write_text(
        f"<package format='3'><name>pkg{RAW}</name><version>0.0.0</version><description>{RAW}</description>"
        f"<maintainer email='a@example.org'>m</maintainer><license>{RAW}</license>"
        "<export><build_type>ament_python</build_type></export></package>",
        encoding="utf-8",
    )


COMMANDS = r"""
ls
ls -la
ls -R
cat text.txt
head -n 1 text.txt
cat evil*
echo *
find .
tree
grep -r T .
wc *
cd nowhere$'\e]0;T\a'
for f in *; do cat "$f/x"; rm -d "$f/x"; python3 "$f/y"; ros2 run "$f" x; ros2 pkg prefix "$f"; done
check_urdf evil.urdf
check_urdf text.txt
xacro evil.urdf
xacro text.txt
ros2 run robot_state_publisher robot_state_publisher text.txt
colcon list
colcon build
colcon build --event-handlers console_direct+
ros2 pkg list
ros2 interface show $'std_msgs/msg/\e]0;T\a'
ros2 launch text.txt
ros2 launch $'no\e]0;T\a' x
ros2 bag info $'no\e]0;T\a'
ros2 doctor
$'nope\e]0;T\a'
python3 evil.py > /dev/null 2>&1 &
until ros2 node list | grep -q evil; do sleep 0.05; done
ros2 node list
ros2 node info /evil
ros2 topic list -t
ros2 topic info -v /chatter
ros2 topic echo --once /chatter
ros2 topic echo --once --csv /chatter
ros2 topic echo --once --field data /chatter
ros2 topic echo --once /rosout
ros2 topic echo --once /tf
ros2 param list
ros2 param get /evil word
ros2 param describe /evil word
ros2 param dump /evil
ros2 service list -t
timeout 2 ros2 run tf2_ros tf2_echo a b
timeout 2 ros2 run tf2_ros tf2_monitor
timeout 2 ros2 run rqt_console rqt_console
timeout 2 ros2 run rqt_topic rqt_topic
timeout 1 ros2 bag record -o bag /chatter /tf
ros2 bag info bag
ros2 topic pub --once /x std_msgs/msg/String "data: $(cat text.txt)"
kill %1
"""


def test_the_reader_of_these_tests_sees_every_attack() -> None:
    for desktop in (True, False):
        for name, sequence in SEQUENCES.items():
            if name != "markup" and not (desktop and name == "clear"):
                assert foreign(b"text" + sequence.encode() + b"text", desktop=desktop), name
    assert foreign(b"\x1b[2J", desktop=False)
    assert foreign("\udcff".encode("utf-8", "surrogateescape"), desktop=True)
    assert not foreign("\x1b[01;31mred 小\x1b[0m\r\n".encode(), desktop=False)


def test_commands_write_hostile_names_and_texts_as_text(place: Place) -> None:
    hostile_files(place.work)
    script = place.file("script", COMMANDS)
    with place.terminal("exec", "--home", str(place.home), str(script), columns=200, rows=50) as screen:
        data = ended(screen)
    assert foreign(data, desktop=False) == []
    assert data.count(MARK.encode()) > 30, data.decode("utf-8", "replace")
    assert b"  a^J  faked" in data and b"\n  faked" not in data  # a parameter's name is one entry of the list


def test_into_a_pipe_goes_every_byte_as_it_is(place: Place) -> None:
    hostile_files(place.work)
    done = place.run("exec", "--home", str(place.home), "-c", "cat text.txt")
    assert done.stdout.encode() == (place.work / "text.txt").read_bytes()


REAL_COMMANDS = {
    "a file that is not there": ["check_urdf", SHORT],
    "a robot": ["check_urdf", "evil.urdf"],
    "a file for xacro": ["xacro", SHORT],
    "a command that is none": [SHORT],
    "an option that is none": ["--" + SHORT],
    "a script that is not there": ["exec", SHORT],
    "an export": ["export", SHORT],
    "a launch file": ["ros2", "launch", SHORT],
    "a package": ["ros2", "run", SHORT, SHORT],
    "a type": ["ros2", "interface", "show", SHORT],
    "a topic": ["ros2", "topic", "echo", SHORT],
}


MANIFEST = (
    "<package><name>lab</name><version>0.0.0</version><description>d</description>"
    "<maintainer email='a@example.org'>a</maintainer><license>MIT</license></package>"
)


@pytest.mark.parametrize("words", REAL_COMMANDS.values(), ids=REAL_COMMANDS)
def test_messages_of_commands_in_a_real_terminal_are_text(place: Place, words: list[str]) -> None:
    place.file("evil.urdf", ROBOT)
    # A workspace: `export` looks for the package there.
    (place.work / "src" / "lab").mkdir(parents=True)
    (place.work / "src" / "lab" / "package.xml").write_text(MANIFEST)
    with place.terminal(*words, columns=200) as screen:
        data = ended(screen)
    assert foreign(data, desktop=False) == []
    assert MARK.encode() in data or b"\\x1b" in data


DECLARE = """\
import sys, time
from day6_core.graph import graph_for_domain
from day6_core.link import join
graph = graph_for_domain(0)
join(graph)
graph.create_node("honest")
session = graph.transport._session
names = ["bad\\nfaked", "bad\\x1b]0;T\\x07", "bad\\u202e", "bad\\x9b2J", "b" * 256]
kept = []
for number, name in enumerate(names, 90):
    kept.append(session.liveliness().declare_token(f"@ros2_lv/0/abc{number}/{number}/{number}/NN/%/%/{name}"))
    kept.append(session.liveliness().declare_token(
        f"@ros2_lv/0/abc{number}/{number}/{number}1/MP/%/%/fine{number}/%{name}/std_msgs::msg::dds_::String_/RIHS01_00/::,10:,:,:,,"
    ))
kept.append(session.liveliness().declare_token("@ros2_lv/0/abc80/1/1/NN/%/%/stranger"))
print("ready", flush=True)
sys.stdin.read()
"""


def test_nodes_of_others_with_names_that_ros_has_not_are_in_no_list(place: Place) -> None:
    import subprocess

    other = subprocess.Popen(
        [sys.executable, "-c", DECLARE],
        env=place.variables(),
        stdin=subprocess.PIPE,
        stdout=subprocess.PIPE,
        text=True,
    )
    try:
        assert other.stdout is not None and other.stdout.readline() == "ready\n"
        until(lambda: "/stranger" in place.nodes())
        for words, wanted in ((["node", "list"], ["/honest", "/stranger"]), (["topic", "list"], [])):

            def listed(words: list[str] = words) -> list[str]:
                with place.terminal("ros2", *words) as screen:
                    data = ended(screen)
                assert foreign(data, desktop=False) == []
                return [line for line in data.decode().split() if line not in ("/parameter_events", "/rosout")]

            until(lambda wanted=wanted: listed() == wanted)  # a command may not hear of all in its time
    finally:
        other.kill()
        other.wait()


IN_XML = "\x9b2J\x9d0;T\x9c\u202e\u2028\u200b[@click=app.quit]"
"""What XML can carry, which has no other control characters."""
IN_XML_SHOWN = "\\x9b2J\\x9d0;T"

WINDOWS = [
    # what is typed, a word of the window, keys in the window, what is then to be seen
    ("rqt_console", "Console", ["Up"], MARK),
    ("rqt_topic", "Topic Monitor", ["Enter", "Right"], "data: ^[]0;T^G"),
    ("rqt_plot /chatter/data", "MatPlot", [], "cannot be plotted"),
    ("rqt_graph", "rqt_graph", ["t"], "/evil"),
    ("rviz2 -f $'\\e]0;T\\a'", "RViz", ["Down", "Down"], MARK),
    ("ros2 run joint_state_publisher_gui joint_state_publisher_gui soft.urdf", "Joint State", ["Right"], IN_XML_SHOWN),
    ("ros2 run day6_bot car_view", "car_view", ["Down"], IN_XML_SHOWN),
    ("ros2 run turtlesim turtlesim_node", "TurtleSim", [], "turtle1"),
    ("ros2 launch day6_world world.launch.py", "world: empty", [], "evil publishes"),
]

LISTED = {"rqt_topic": "▸ [ ] /chatter"}
"""The line of a list to which the keys are meant: the frame of a window is drawn before its list is known."""


def test_every_window_title_tab_and_list_of_the_desktop_shows_hostile_texts_as_text(place: Place) -> None:
    hostile_files(place.home)
    place.home_file("soft.urdf", ROBOT.replace(RAW, IN_XML))
    with place.desktop("--scene", "empty", columns=130, rows=40) as screen:
        screen.wait("$")
        screen.line("python3 evil.py 2> /dev/null &")
        screen.line("ros2 run robot_state_publisher robot_state_publisher soft.urdf 2> /dev/null &")
        screen.wait("nodes 2")
        screen.line("clear; cat text.txt evil.py; ls -la")
        screen.wait("'bytes'$'\\377")
        for command, title, keys, wanted in WINDOWS:
            screen.line("clear; " + command)
            if not command.startswith("rqt"):  # those have the keyboard by themselves
                screen.wait(f"╭ 2 {title} ")
                screen.press("F3")
            screen.wait(f"┏ 2 {title} ", LISTED.get(command, ""))
            screen.press(*keys)
            screen.wait(wanted)
            screen.press("F3")
            screen.wait(f"╭ 2 {title} ")
            screen.press("Ctrl-C")
            screen.wait_gone(f"╭ 2 {title}")
        screen.press("F6")  # the inspector
        screen.wait("Inspector")
        screen.press("F6")
        screen.line("cd ./*'[@click=app.quit]'; clear")
        screen.wait("1 ~/^[]0;T^G\\x9b2J")  # the tab
        for key, title in (("F4", "━ Windows"), ("F7", "━ Commands"), ("F1", "━ Help")):
            screen.press(key)
            screen.wait(title)
            screen.press("Esc")
            screen.wait_gone(title)
        screen.line("cd; nano text.txt")
        screen.wait("␛]0;T␇␛]52;c")
        data = whole(bytes(screen.output))
    assert foreign(data, desktop=True) == []

"""What is tried on every platform: each feature with the commands a user types and what must be seen then.

A `$` stands before what is typed into a terminal of one's own (`&` at its end: it goes on meanwhile; `!` before it: it has to
fail), a `>` before what is typed into the screen that the last command opened: a line, a key by its name, or `click` and a
text. Below each stand texts that must come; at Esc those before it must go. A word before `$` and `>` names one of several
places: two machines with a home each, a browser, or a terminal that shows real pixels. PORT is a free one.
"""

from __future__ import annotations

from collections.abc import Mapping
from typing import NamedTuple

from tests.grading.article import STAR

ROBOTS = "$(ros2 pkg prefix --share urdf_tutorial)/urdf"
TURTLE = "$ day6-tui ros2 run turtlesim turtlesim_node &"
POSE = "$ day6-tui ros2 topic echo --once /turtle1/pose turtlesim/msg/Pose --field x\n5.54444"
PACKAGE = "cd ~/ros2_ws/src; ros2 pkg create --build-type ament_python --node-name hello first"
PUBLISH = "ros2 topic pub -r 10 -t 3 -w 1 --max-wait-time-secs 60 /chatter std_msgs/msg/String '{data: hello}'"
RECORD = f"{PUBLISH}; kill %1; wait; ros2 bag info talk"
PLAY = (
    '$ day6-tui exec -c "ros2 bag play --loop talk & ros2 topic echo --once /chatter std_msgs/msg/String"\ndata: hello'
)


class Feature(NamedTuple):
    """One row of the table in docs/*/trust/platforms.md."""

    key: str
    """Its name in runs.json."""
    name: tuple[str, str]
    """In English and Chinese."""
    typed: str
    files: Mapping[str, str] = {}
    """What is in the current folder at first."""


FEATURES = (
    Feature("version", ("installed, says its version", "安装后能显示版本"), "$ day6-tui --version\nday6-tui "),
    Feature("doctor", ("`doctor` finds no problem", "`doctor` 没有发现问题"), "$ day6-tui doctor\nNo problems"),
    Feature(
        "processes",
        ("nodes in two processes, `topic pub` and `echo`", "两个进程里的节点，`topic pub` 和 `echo`"),
        f"""
{TURTLE}
{POSE}
$ day6-tui ros2 topic pub /chatter std_msgs/msg/String "data: hello" &
$ day6-tui ros2 topic echo --once /chatter std_msgs/msg/String
data: hello
$ day6-tui ros2 node list --spin-time 5
/turtlesim
""",
    ),
    Feature(
        "local",
        ("the same without Zenoh", "不用 Zenoh 也一样"),
        f"{TURTLE}\n{POSE}".replace("day6-tui", "DAY6_LINK=local day6-tui"),
    ),
    Feature(
        "services",
        ("services, parameters, actions", "服务、参数、动作"),
        f"""
{TURTLE}
$ day6-tui ros2 service call /spawn turtlesim/srv/Spawn "{{x: 2, y: 3, name: anna}}"
name='anna'
$ day6-tui ros2 param set --timeout 60 /turtlesim background_r 7
Set parameter successful
$ day6-tui ros2 param get --timeout 60 /turtlesim background_r
Integer value is: 7
$ day6-tui ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute "theta: 0.5"
SUCCEEDED
""",
    ),
    Feature(
        "packages",
        ("`pkg create`, `colcon build`, `colcon test`, `run`", "`pkg create`、`colcon build`、`colcon test`、`run`"),
        f"""
$ day6-tui exec -c "mkdir -p ~/ros2_ws/src; {PACKAGE}"
$ day6-tui exec -c "cd ~/ros2_ws; colcon build && source install/setup.bash && ros2 run first hello"
Summary: 1 package finished
Hi from first.
$ day6-tui exec -c "cd ~/ros2_ws; colcon test; colcon test-result"
Summary:
""",
    ),
    Feature(
        "export",
        ("`export` to a real ROS 2", "`export`：导出到真正的 ROS 2"),
        f"""
$ day6-tui exec -c "mkdir -p ~/ros2_ws/src; {PACKAGE}; cd ~/ros2_ws; day6-tui export; python3 -m zipfile -l ros2_ws.zip"
ros2_ws/src/first/package.xml
""",
    ),
    Feature(
        "launch",
        ("launch files", "launch 文件"),
        """
$ day6-tui ros2 launch turtlesim multisim.launch.py &
$ day6-tui ros2 topic echo --once /turtlesim2/turtle1/pose turtlesim/msg/Pose --field x
5.54444
""",
    ),
    Feature(
        "bags",
        ("bags: recorded, played", "bag：录制、播放"),
        f"""
$ day6-tui exec -c "ros2 bag record -o talk --topics /chatter & {RECORD}"
Count: 3
{PLAY}
""",
    ),
    Feature(
        "compressed",
        ("the same, compressed", "同上，压缩"),
        f"""
$ day6-tui exec -c "ros2 bag record -o talk --compression-mode file --compression-format zstd --topics /chatter & {RECORD}"
talk_0.mcap.zstd
Count: 3
{PLAY}
""",
    ),
    Feature(
        "robots",
        ("`xacro`, `check_urdf`", "`xacro`、`check_urdf`"),
        f"""
$ day6-tui exec -c "xacro {ROBOTS}/08-macroed.urdf.xacro > car.urdf && check_urdf car.urdf"
Successfully Parsed XML
""",
    ),
    Feature(
        "pdf",
        ("PDF files: `urdf_to_graphviz` without graphviz", "PDF 文件：没有 graphviz 时的 `urdf_to_graphviz`"),
        f"""
$ PATH= day6-tui exec -c "urdf_to_graphviz {ROBOTS}/05-visual.urdf && head -c 5 visual.pdf"
%PDF-
""",
    ),
    Feature(
        "lessons",
        ("`lessons`: a step is played", "`lessons`：试做一个步骤"),
        """
$ day6-tui lessons new turtle.md
$ day6-tui lessons play turtle.md
ok
turtle.md:10: turtle
""",
    ),
    Feature(
        "grading",
        ("`submit` and `grade`", "`submit` 和 `grade`"),
        """
$ day6-tui exec -c "cp star.py ~"
$ day6-tui submit --pupil anna -o anna.zip
anna.zip: star.py
$ ! day6-tui grade anna.zip --lesson day3
2 of 3
""",
        {"star.py": STAR},
    ),
    Feature(
        "desktop",
        ("the desktop at 80x24, keys and mouse", "80x24 的桌面，键盘和鼠标"),
        """
$ day6-tui
Drive the turtle
^Q Quit
> echo $((6 * 7)) ü
42 ü
> F7
type to search
> Esc
> F1
Help: Terminals
> Esc
> click F7 Commands
type to search
> Esc
> click Drive the turtle
TurtleSim
x 5.54
""",
    ),
    Feature(
        "pixels",
        ("pictures in real pixels", "真实像素的图像"),
        """
pixels$ day6-tui --scene turtle --glyphs pixels
a picture
""",
    ),
    Feature(
        "detach",
        ("`--detach` and `attach`", "`--detach` 和 `attach`"),
        """
$ day6-tui --detach
$ day6-tui attach
Drive the turtle
> echo $((6 * 7))
42
""",
    ),
    Feature(
        "serve",
        ("`serve`: the desktop in a browser tab", "`serve`：浏览器标签页里的桌面"),
        """
$ day6-tui serve --port PORT --isolation none &
open http://127.0.0.1:PORT/ in a browser
browser$ me
Drive the turtle
> echo $((6 * 7))
42
""",
    ),
    Feature(
        "class",
        ("`class`: two machines", "`class`：两台电脑"),
        """
teacher$ day6-tui class --teacher --listen 127.0.0.1:PORT
--join
anna$ day6-tui class --join 127.0.0.1:PORT --name anna --scene empty
joined 127.0.0.1
anna> ros2 run turtlesim turtlesim_node &
teacher>
/turtlesim
""",
    ),
)

REASONS = (
    (r"cannot be graded on Windows", ("not on Windows", "Windows 上没有")),
    (r"needs?\s+([\w-]+),\s+which\s+isn't\s+installed", ("needs {}", "需要 {}")),
    (r"needs Zenoh", ("needs Zenoh", "需要 Zenoh")),
    (r"pseudo-terminals", ("needs pseudo-terminals, which Windows hasn't", "需要伪终端，Windows 没有")),
)
"""What day6-tui, or a test, says of a feature that isn't there, and how the table says so."""

"""The 46 faults of beginners, each injected for real into a machine that runs, and what the inspector has to say.

`DRILLS` is a table: number in the list of faults (with a letter where one has several faces), name, injection, the findings of
which one has to come. An injection returns when the symptom is there.
"""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from day6_core.graph import EndpointKind
from day6_urdf import shipped_model

if TYPE_CHECKING:
    from tests.inspector.lab import Lab

HEAD = """\
import time
import rclpy
from rclpy.node import Node
from std_msgs.msg import String
from geometry_msgs.msg import Twist
from std_srvs.srv import Trigger
"""

TALKER = (
    HEAD
    + """
class Talker(Node):
    def __init__(self):
        super().__init__('talker')
        self.publisher = self.create_publisher(String, 'chatter', 10)
        self.create_timer(0.1, self.say)

    def say(self):
        self.publisher.publish(String(data='hello'))

def main():
    rclpy.init()
    rclpy.spin(Talker())

if __name__ == '__main__':
    main()
"""
)
LISTENER = (
    HEAD
    + """
rclpy.init()
node = Node('listener')
node.create_subscription(String, 'chatter', lambda message: print('I heard', message.data, flush=True), 10)
rclpy.spin(node)
"""
)


class Drill(NamedTuple):
    """One fault."""

    number: str
    name: str
    inject: Callable[[Lab], object]
    findings: tuple[str, ...]


def program(text: str, *, node: str = "/mine", shows: str = "", ends: bool = False) -> Callable[[Lab], object]:
    """A program of a student's: wait until it shows something and its node is there, or it has ended."""

    def inject(lab: Lab) -> None:
        lab.file("program.py", HEAD + text)
        if ends:
            lab.run("python3 program.py")
            return
        lab.start("python3 program.py", shows=shows)
        lab.wait_node(node)

    return inject


def bare(text: str) -> Callable[[Lab], object]:
    """The same without the usual imports; it ends."""

    def inject(lab: Lab) -> None:
        lab.file("program.py", text)
        lab.run("python3 program.py")

    return inject


def typed(*lines: str, shows: str = "") -> Callable[[Lab], object]:
    """Lines that end, each in turn; with `shows` the last one goes on."""

    def inject(lab: Lab) -> None:
        for line in lines[: -1 if shows else None]:
            lab.run(line)
        if shows:
            lab.start(lines[-1], shows=shows)

    return inject


def package(lab: Lab, *, node: str = "my_node", build: bool = True) -> Path:
    """A package with a node, built."""
    lab.run(f"cd ~/ros2_ws/src && ros2 pkg create --build-type ament_python my_pkg --node-name {node}; cd ~/ros2_ws")
    if build:
        lab.run("colcon build")
    return lab.home / "ros2_ws/src/my_pkg"


def replace(path: Path, old: str, new: str) -> None:
    text = path.read_text(encoding="utf-8")
    assert old in text
    path.write_text(text.replace(old, new), encoding="utf-8")


# -- packages and the build ------------------------------------------------------------------------------------------------


def not_sourced(lab: Lab) -> None:
    package(lab)
    lab.run("ros2 run my_pkg my_node", 1)


def not_built(lab: Lab) -> None:
    package(lab, build=False)
    lab.run("ros2 run my_pkg my_node", 1)


def nowhere_sourced(lab: Lab) -> None:
    package(lab)


def no_entry_point(lab: Lab) -> None:
    folder = package(lab, build=False)
    (folder / "my_pkg/talker.py").write_text(TALKER, encoding="utf-8")
    lab.run("colcon build && source install/setup.bash")
    lab.run("ros2 run my_pkg talker")


def entry_with_py(lab: Lab) -> None:
    folder = package(lab, build=False)
    replace(folder / "setup.py", "my_pkg.my_node:main", "my_pkg.my_node.py:main")
    lab.run("colcon build && source install/setup.bash && ros2 run my_pkg my_node")


def entry_without_module(lab: Lab) -> None:
    replace(package(lab, build=False) / "setup.py", "my_pkg.my_node:main", "my_pkg.my_nod:main")


def entry_without_function(lab: Lab) -> None:
    replace(package(lab, build=False) / "setup.py", "my_pkg.my_node:main", "my_pkg.my_node:mian")


def no_setup_cfg(lab: Lab) -> None:
    folder = package(lab, build=False)
    (folder / "setup.cfg").unlink()
    lab.run("colcon build && source install/setup.bash && ros2 run my_pkg my_node")


def launch_file_left_out(lab: Lab) -> None:
    folder = package(lab, build=False)
    (folder / "launch").mkdir()
    (folder / "launch/my.launch.py").write_text("from launch import LaunchDescription\n", encoding="utf-8")
    lab.run("colcon build && source install/setup.bash && ros2 launch my_pkg my.launch.py")


def not_rebuilt(lab: Lab) -> None:
    folder = package(lab)
    lab.run("source install/setup.bash")
    replace(folder / "my_pkg/my_node.py", "Hi from", "Hello from")


def duplicates(lab: Lab) -> None:
    package(lab, build=False)
    lab.run("cp -r src/my_pkg src/my_pkg_backup")
    lab.run("colcon build")


def built_in_src(lab: Lab) -> None:
    package(lab, build=False)
    lab.run("cd src && colcon build")


def built_at_home(lab: Lab) -> None:
    package(lab, build=False)
    lab.run("cd ~ && colcon build")


def inner_package(lab: Lab) -> None:
    package(lab, build=False)
    lab.run("cd src/my_pkg && ros2 pkg create inner --build-type ament_python")


def install_removed(lab: Lab) -> None:
    package(lab)
    lab.run("source install/setup.bash && rm -r build install")


def interfaces_not_sourced(lab: Lab) -> None:
    lab.run("cd ~/ros2_ws/src && ros2 pkg create my_msgs; cd ~/ros2_ws")
    folder = lab.home / "ros2_ws/src/my_msgs"
    (folder / "msg").mkdir()
    (folder / "msg/Num.msg").write_text("int64 num\n", encoding="utf-8")
    replace(
        folder / "CMakeLists.txt",
        "ament_package()",
        'find_package(rosidl_default_generators REQUIRED)\nrosidl_generate_interfaces(${PROJECT_NAME} "msg/Num.msg")\n'
        "ament_package()",
    )
    replace(
        folder / "package.xml",
        "<export>",
        "<build_depend>rosidl_default_generators</build_depend>\n"
        "  <member_of_group>rosidl_interface_packages</member_of_group>\n  <export>",
    )
    lab.run("colcon build")
    lab.run("ros2 topic pub /num my_msgs/msg/Num '{num: 1}'", 1)


def without_ros(lab: Lab) -> None:
    lab.file(
        "program.py",
        "import subprocess\nsubprocess.run(['/bin/bash', '-c', 'ros2 node list'], env={'PATH': '/usr/bin:/bin'})\n",
    )
    lab.run("python3 program.py")


# -- the graph -------------------------------------------------------------------------------------------------------------


def topic_slip(lab: Lab) -> None:
    lab.start("ros2 run turtlesim turtlesim_node")
    lab.start(
        "ros2 topic pub -r 5 /cmd_vel geometry_msgs/msg/Twist '{linear: {x: 1.0}}' -w 0", 1, shows="publishing #1"
    )


def wrong_namespace(lab: Lab) -> None:
    lab.file("talker.py", TALKER)
    lab.start("python3 talker.py --ros-args -r __ns:=/team")
    lab.wait_node("/team/talker")
    lab.start("ros2 topic echo /chatter std_msgs/msg/String", 1)


def incompatible_qos(lab: Lab) -> None:
    lab.file("listener.py", LISTENER)
    lab.start("python3 listener.py")
    lab.wait_node("/listener")
    line = "ros2 topic pub -w 0 --qos-reliability best_effort /chatter std_msgs/msg/String '{data: a}'"
    lab.start(line, 1, shows="publishing #1")


def different_types(lab: Lab) -> None:
    lab.start("ros2 topic pub -w 0 /chatter std_msgs/msg/String '{data: a}'", 0, shows="publishing #1")
    lab.start("ros2 topic pub -w 0 /chatter std_msgs/msg/Int32 '{data: 1}'", 1, shows="publishing #1")
    lab.run("ros2 topic echo /chatter", 2)


def published_too_soon(lab: Lab) -> None:
    lab.file(
        "once.py",
        # On a busy computer a program that ends at once is gone before anybody has heard of it, as with the real one.
        HEAD
        + "import os\nrclpy.init()\nnode = Node('once')\npublisher = node.create_publisher(String, 'chatter', 10)\n"
        "publisher.publish(String(data='hello'))\nwhile not os.path.exists('known'):\n    time.sleep(0.02)\n",
    )
    lab.start("python3 once.py", 1)
    lab.wait(lambda: lab.desk.graph.endpoints(EndpointKind.PUBLISHER, topic="/chatter"))
    lab.file("known", "")
    lab.wait(lambda: all(node.name != "once" for node in lab.desk.graph.nodes))
    lab.file("listener.py", LISTENER)
    lab.start("python3 listener.py")
    lab.wait_node("/listener")


def published_in_init(lab: Lab) -> None:
    """The same by a node that stays."""
    lab.file(
        "once.py",
        HEAD + "rclpy.init()\nnode = Node('once')\npublisher = node.create_publisher(String, 'chatter', 10)\n"
        "publisher.publish(String(data='hello'))\nrclpy.spin(node)\n",
    )
    lab.start("python3 once.py", 1)
    lab.wait_node("/once")
    lab.file("listener.py", LISTENER)
    lab.start("python3 listener.py")
    lab.wait_node("/listener")


def twins(lab: Lab) -> None:
    lab.file("talker.py", TALKER)
    for number in range(2):
        lab.start("python3 talker.py", number)
    lab.wait(lambda: sum(node.name == "talker" for node in lab.desk.graph.nodes) == 2)


def fight(lab: Lab) -> None:
    lab.start("ros2 run turtlesim turtlesim_node")
    for number, speed in enumerate(("1.0", "-1.0"), 1):
        line = f"ros2 topic pub -r 5 /turtle1/cmd_vel geometry_msgs/msg/Twist '{{linear: {{x: {speed}}}}}'"
        lab.start(line, number, shows="publishing #1")


def other_domain(lab: Lab) -> None:
    lab.start("ros2 run turtlesim turtlesim_node")
    lab.wait_node("/turtlesim")
    lab.run("export ROS_DOMAIN_ID=7", 1)
    lab.run("ros2 node list", 1)


def parameters_for_nobody(lab: Lab) -> None:
    lab.file("params.yaml", "turtle_sim:\n  ros__parameters:\n    background_b: 0\n")
    lab.start("ros2 run turtlesim turtlesim_node --ros-args --params-file params.yaml")
    lab.wait_node("/turtlesim")


# -- the robot -------------------------------------------------------------------------------------------------------------


def robot(lab: Lab, change: Callable[[str], str] = str) -> Path:
    path = lab.file("my_car.urdf", change(shipped_model().read_text(encoding="utf-8")))
    lab.start("ros2 run robot_state_publisher robot_state_publisher my_car.urdf")
    lab.wait_node("/robot_state_publisher")
    return path


def joints(names: str, more: str = "") -> str:
    return f"ros2 topic pub -w 0 -r 20 /joint_states sensor_msgs/msg/JointState '{{name: {names}, position: [0.0, 0.0]{more}}}'"


def unknown_joint(lab: Lab) -> None:
    robot(lab)
    lab.start(joints("[wheel_left_joint, right_wheel_joint]"), 1, shows="publishing #1")


def too_few_positions(lab: Lab) -> None:
    robot(lab)
    lab.start(joints("[left_wheel_joint, right_wheel_joint, x]"), 1, shows="publishing #1")


def rviz(lab: Lab, frame: str, displays: str, number: int = 2) -> None:
    lab.file(
        "my.rviz",
        f"Visualization Manager:\n  Displays:\n{displays}  Global Options:\n    Fixed Frame: {frame}\n",
    )
    lab.start("rviz2 -d my.rviz", number)
    lab.wait(lambda: lab.windows("rviz2"))


MODEL = (
    "    - Class: rviz_default_plugins/RobotModel\n      Name: RobotModel\n      Enabled: true\n"
    "      Description Topic:\n        Value: {topic}\n"
)


def unknown_fixed_frame(lab: Lab) -> None:
    robot(lab)
    lab.start("ros2 run joint_state_publisher joint_state_publisher", 1)
    rviz(lab, "map", MODEL.format(topic="/robot_description"))


def no_robot_model(lab: Lab) -> None:
    robot(lab)
    lab.start("ros2 run joint_state_publisher joint_state_publisher", 1)
    rviz(lab, "base_link", "    - Class: rviz_default_plugins/Grid\n      Name: Grid\n      Enabled: true\n")


def robot_model_elsewhere(lab: Lab) -> None:
    robot(lab)
    lab.start("ros2 run joint_state_publisher joint_state_publisher", 1)
    rviz(lab, "base_link", MODEL.format(topic="/description"))


def rviz_alone(lab: Lab) -> None:
    rviz(lab, "base_link", MODEL.format(topic="/robot_description"), 0)


def wheels_without_joint_states(lab: Lab) -> None:
    robot(lab)
    rviz(lab, "base_link", MODEL.format(topic="/robot_description"))


def no_state_publisher(lab: Lab) -> None:
    lab.start(joints("[left_wheel_joint, right_wheel_joint]"), shows="publishing #1")


def wheel_axis(lab: Lab) -> None:
    robot(lab, lambda text: text.replace('<axis xyz="0 1 0"/>', '<axis xyz="1 0 0"/>'))


def wheel_height(lab: Lab) -> None:
    text = shipped_model().read_text(encoding="utf-8")
    at = text.index('<joint name="left_wheel_joint"')
    before = text.index('<origin xyz="', at) + len('<origin xyz="')
    x, y, z = text[before : text.index('"', before)].split()
    robot(lab, lambda _: text[:before] + f"{x} {y} {float(z) + 0.05}" + text[text.index('"', before) :])


def ghost(lab: Lab) -> None:
    import re

    text = re.sub(r"<inertial>.*?</inertial>", "", shipped_model().read_text(encoding="utf-8"), flags=re.DOTALL)
    lab.file("my_car.urdf", text)
    lab.start("ros2 run day6_world world --ros-args -p robot_file:=my_car.urdf")
    lab.wait(lambda: lab.windows("world"))


# -- Python ----------------------------------------------------------------------------------------------------------------

NODE = "rclpy.init()\nnode = Node('mine')\n"


def spinning(text: str, name: str = "mine") -> str:
    """A program that makes a node, does this, and spins."""
    return f"rclpy.init()\nnode = Node({name!r})\n{text}rclpy.spin(node)\n"


SERVICE_NODE = """
class Mine(Node):
    def __init__(self):
        super().__init__('mine')
        self.client = self.create_client(Trigger, 'trigger')
        self.create_service(Trigger, 'trigger', lambda request, response: response)
        self.create_timer(0.2, self.tick)

    def tick(self):
        {body}

rclpy.init()
rclpy.spin(Mine())
"""


def interrupted(lab: Lab) -> None:
    lab.file("talker.py", TALKER)
    lab.start("python3 talker.py")
    lab.wait(lambda: lab.desk.graph.endpoints(EndpointKind.PUBLISHER, topic="/chatter"))  # made when all is imported
    lab.interrupt()


LIFECYCLE = """
from rclpy.lifecycle import LifecycleNode

class Camera(LifecycleNode):
    def on_configure(self, state):
        return self.picture()

rclpy.init()
camera = Camera('camera')
camera.trigger_configure()
rclpy.spin(camera)
"""
POOL = """
from rclpy.executors import MultiThreadedExecutor
rclpy.init()
node = Node('mine')

def once():
    timer.cancel()
    raise SystemExit(1)

timer = node.create_timer(0.2, once)
executor = MultiThreadedExecutor(2)
executor.add_node(node)
executor.spin()
"""

DRILLS: tuple[Drill, ...] = (
    Drill("1", "package not sourced", not_sourced, ("not_sourced",)),
    Drill("1b", "package not built", not_built, ("not_built",)),
    Drill("1c", "built, sourced nowhere", nowhere_sourced, ("nowhere_sourced",)),
    Drill("2", "ROS not sourced", without_ros, ("no_ros",)),
    Drill("3", "entry point missing", no_entry_point, ("no_entry_point",)),
    Drill("3b", "entry point with .py", entry_with_py, ("entry_py",)),
    Drill("3c", "entry point without module", entry_without_module, ("entry_module",)),
    Drill("3d", "entry point without function", entry_without_function, ("entry_function",)),
    Drill("3e", "setup.cfg missing", no_setup_cfg, ("no_setup_cfg",)),
    Drill("4", "launch file not in data_files", launch_file_left_out, ("launch_not_installed",)),
    Drill("5", "edited, not rebuilt", not_rebuilt, ("not_rebuilt",)),
    Drill(
        "6",
        "another Python",
        program("raise ModuleNotFoundError(\"No module named 'rclpy._rclpy_pybind11'\")\n", ends=True),
        ("other_python",),
    ),
    Drill("7", "rclpy not found", typed("python3 -I -c 'import rclpy'"), ("no_rclpy",)),
    Drill(
        "8",
        "setup.py install is deprecated",
        program(
            "import warnings\nfrom setuptools.warnings import SetuptoolsDeprecationWarning\n"
            "warnings.warn('setup.py install is deprecated.', SetuptoolsDeprecationWarning)\n",
            ends=True,
        ),
        ("setuptools",),
    ),
    Drill("9", "duplicate packages", duplicates, ("duplicates",)),
    Drill("10", "built in src", built_in_src, ("stray_build",)),
    Drill("10b", "built in the home folder", built_at_home, ("stray_build",)),
    Drill("10c", "package inside a package", inner_package, ("inner_package",)),
    Drill("11", "AMENT_PREFIX_PATH to nowhere", install_removed, ("gone",)),
    Drill("12", "topic slip", topic_slip, ("near",)),
    Drill("13", "namespace", wrong_namespace, ("near",)),
    Drill("14", "QoS", incompatible_qos, ("qos",)),
    Drill("15", "types differ", different_types, ("types", "mixed_types", "two_types_said")),
    Drill("16", "custom message not sourced", interfaces_not_sourced, ("not_sourced",)),
    Drill("17", "YAML: field", typed("ros2 topic pub /x std_msgs/msg/String '{dat: 1}'"), ("bad_yaml",)),
    Drill("17b", "YAML: no dictionary", typed("ros2 topic pub /x std_msgs/msg/String hello"), ("bad_yaml",)),
    Drill("18", "published once and ended", published_too_soon, ("gone_too_soon",)),
    Drill("18b", "published once in __init__", published_in_init, ("said_too_soon",)),
    Drill(
        "19",
        "spin forgotten",
        program(NODE + "node.create_timer(0.1, lambda: print('tick'))\nwhile True:\n    time.sleep(1)\n"),
        ("never_spun",),
    ),
    Drill(
        "19b",
        "spin forgotten, program ends",
        program(NODE + "node.create_timer(0.1, lambda: print('tick'))\n", ends=True),
        ("ended_unspun",),
    ),
    Drill(
        "19c",
        "spin left",
        program(NODE + "node.create_timer(0.1, lambda: None)\nrclpy.spin_once(node)\nwhile True:\n    time.sleep(1)\n"),
        ("spin_ended",),
    ),
    Drill(
        "20",
        "call() in a callback",
        program(SERVICE_NODE.format(body="self.client.call(Trigger.Request())")),
        ("calls_own_service",),
    ),
    Drill(
        "20b",
        "spin in a callback",
        program(
            SERVICE_NODE.format(
                body="rclpy.spin_until_future_complete(self, self.client.call_async(Trigger.Request()))"
            )
        ),
        ("spins_in_callback",),
    ),
    Drill(
        "20c",
        "call() without a second thread",
        program(
            NODE + "client = node.create_client(Trigger, 'trigger')\n"
            "node.create_service(Trigger, 'trigger', lambda request, response: response)\n"
            "client.call(Trigger.Request())\n"
        ),
        ("call_alone",),
    ),
    Drill(
        "21",
        "sleep in a callback",
        program(spinning("node.create_timer(0.1, lambda: time.sleep(30))\n")),
        ("sleeps_in_callback",),
    ),
    Drill(
        "21b",
        "endless loop in a callback",
        program(spinning("def tick():\n    while True:\n        pass\nnode.create_timer(0.1, tick)\n")),
        ("stays_in_callback",),
    ),
    Drill(
        "21c",
        "sleep in an async callback",
        program(spinning("async def tick():\n    time.sleep(30)\nnode.create_timer(0.1, tick)\n")),
        ("sleeps_in_callback",),
    ),
    Drill(
        "21d",
        "sleep in an action's callback holds up a timer",
        program(
            "from example_interfaces.action import Fibonacci\nfrom rclpy.action import ActionClient, ActionServer\n"
            + NODE
            + "def execute(goal):\n    print('begun', flush=True)\n    time.sleep(30)\n    return Fibonacci.Result()\n"
            "server = ActionServer(node, Fibonacci, 'fibonacci', execute)\n"
            "client = ActionClient(node, Fibonacci, 'fibonacci')\n"
            "client.send_goal_async(Fibonacci.Goal())\n"
            "node.create_timer(0.2, lambda: None)\nrclpy.spin(node)\n",
            shows="begun",
        ),
        ("sleeps_in_callback",),
    ),
    Drill(
        "22",
        "Rate without a second thread",
        program(NODE + "rate = node.create_rate(10)\nwhile rclpy.ok():\n    rate.sleep()\n"),
        ("rate_alone",),
    ),
    Drill(
        "22b",
        "Rate in a callback",
        program(spinning("rate = node.create_rate(1)\nnode.create_timer(0.1, lambda: rate.sleep())\n")),
        ("rate_in_callback",),
    ),
    Drill(
        "23",
        "super().__init__ forgotten",
        program(
            "class Mine(Node):\n    def __init__(self):\n        self.create_publisher(String, 'a', 10)\n"
            "rclpy.init()\nMine()\n",
            ends=True,
        ),
        ("no_super",),
    ),
    Drill("24", "rclpy.init forgotten", program("node = Node('mine')\n", ends=True), ("no_init",)),
    Drill(
        "25",
        "module 'rclpy' has no attribute",
        bare("import rclpy\nrclpy.node.Node\n"),
        ("submodule",),
    ),
    Drill(
        "26",
        "publisher without depth",
        program(NODE + "node.create_publisher(String, 'a')\n", ends=True),
        ("no_depth",),
    ),
    Drill(
        "27",
        "publish('text')",
        program(NODE + "node.create_publisher(String, 'a', 10).publish('text')\n", ends=True),
        ("not_a_message",),
    ),
    Drill("28", "int for float", program("Twist().linear.x = 1\n", ends=True), ("field_type",)),
    Drill("29", "field typo", program("Twist().liner.x = 1.0\n", ends=True), ("attribute",)),
    Drill(
        "30",
        "callback called",
        program(
            NODE + "def heard():\n    pass\nnode.create_subscription(String, 'a', heard(), 10)\n",
            ends=True,
        ),
        ("called_callback",),
    ),
    Drill("31", "Ctrl-C traceback", interrupted, ("ctrl_c",)),
    Drill("31b", "shut down twice", program(NODE + "rclpy.shutdown()\nrclpy.shutdown()\n", ends=True), ("shut_twice",)),
    Drill("32", "exception lost in a lifecycle node", program(LIFECYCLE, node="/camera"), ("hidden_error",)),
    Drill("32b", "exception lost in a pool", program(POOL), ("hidden_error",)),
    Drill("33", "two nodes of one name", twins, ("twins",)),
    Drill("34", "two publishers fight", fight, ("fight",)),
    Drill("35", "parameter not declared", program(NODE + "node.get_parameter('speed')\n", ends=True), ("undeclared",)),
    Drill(
        "36",
        "parameter of the wrong type",
        lambda lab: (
            lab.file("program.py", HEAD + NODE + "node.declare_parameter('speed', 1.0)\n"),
            lab.run("python3 program.py --ros-args -p speed:=1"),
        ),
        ("parameter_type",),
    ),
    Drill(
        "36b",
        "ros2 param set with another type",
        lambda lab: (
            lab.start("ros2 run turtlesim turtlesim_node"),
            lab.wait_node("/turtlesim"),
            lab.run("ros2 param set /turtlesim background_r red", 1),
        ),
        ("parameter_type",),
    ),
    Drill("37", "params file for another node", parameters_for_nobody, ("parameter_keys",)),
    Drill(
        "38",
        "service not there",
        typed("ros2 service call /nope std_srvs/srv/Empty", shows="waiting for service"),
        ("waits_service",),
    ),
    Drill(
        "38b",
        "a program waits for a service",
        program(
            NODE + "client = node.create_client(Trigger, 'nope')\n"
            "while not client.wait_for_service(timeout_sec=1.0):\n    pass\n"
        ),
        ("program_waits_service", "no_server"),
    ),
    Drill(
        "39",
        "action not there",
        typed(
            "ros2 action send_goal /nope turtlesim/action/RotateAbsolute '{theta: 1.0}'", shows="Waiting for an action"
        ),
        ("waits_action",),
    ),
    Drill("40", "frame does not exist", typed("ros2 run tf2_ros tf2_echo a b", shows="does not exist"), ("no_frame",)),
    Drill(
        "41",
        "extrapolation",
        program(
            "from tf2_ros import Buffer, StaticTransformBroadcaster\nfrom geometry_msgs.msg import TransformStamped\n"
            "from rclpy.time import Time\nbuffer = Buffer()\n"
            "for second in (1, 2):\n"
            "    moved = TransformStamped(child_frame_id='b')\n    moved.header.frame_id = 'a'\n"
            "    moved.header.stamp.sec = second\n    moved.transform.rotation.w = 1.0\n"
            "    buffer.set_transform(moved, 'me')\n"
            "buffer.lookup_transform('a', 'b', Time(seconds=9))\n",
            ends=True,
        ),
        ("extrapolation",),
    ),
    Drill("42", "Fixed Frame unknown", unknown_fixed_frame, ("fixed_frame",)),
    Drill("42b", "no transform to the wheels", wheels_without_joint_states, ("no_joint_states",)),
    Drill("42c", "RobotModel missing", no_robot_model, ("no_robot_model",)),
    Drill("42d", "RobotModel without description", robot_model_elsewhere, ("robot_model_deaf",)),
    Drill("42e", "RViz waits for a robot", rviz_alone, ("rviz_no_description",)),
    Drill("43", "joint names differ", unknown_joint, ("unknown_joint_near",)),
    Drill("43b", "positions missing", too_few_positions, ("unequal_joints",)),
    Drill(
        "43g",
        "joint states without time",
        lambda lab: (
            robot(lab),
            lab.start(joints("[left_wheel_joint, right_wheel_joint]"), 1, shows="publishing #1"),
        ),
        ("no_stamp",),
    ),
    Drill("43c", "robot_state_publisher missing", no_state_publisher, ("no_state_publisher",)),
    Drill("43d", "wheel axis wrong", wheel_axis, ("wheel_tumbles",)),
    Drill("43e", "wheel height wrong", wheel_height, ("wheel_height",)),
    Drill("43f", "ghost without inertia", ghost, ("world.no_inertial",)),
    Drill(
        "44",
        "simulated time without /clock",
        lambda lab: (
            lab.file("talker.py", TALKER),
            lab.start("python3 talker.py --ros-args -p use_sim_time:=true"),
            lab.wait_node("/talker"),
        ),
        ("no_clock",),
    ),
    Drill(
        "44b",
        "turtlesim on simulated time",
        typed("ros2 run turtlesim turtlesim_node --ros-args -p use_sim_time:=true", shows="Starting"),
        ("no_clock",),
    ),
    Drill("45", "another ROS_DOMAIN_ID", other_domain, ("domains",)),
    Drill(
        "46",
        "no Zenoh router",
        program("print('Unable to connect to a Zenoh router. Have you started a router?')\n", ends=True),
        ("no_router",),
    ),
)

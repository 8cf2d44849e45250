"""The official beginners' tutorials in our own words: what a pupil has running at the end of each, without a mistake.

`TUTORIALS` is a table of functions; each builds packages in `~/ros2_ws` and starts their programs.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from pathlib import Path

    from tests.inspector.lab import Lab

SOURCE = "source install/setup.bash"


def python_package(
    lab: Lab, name: str, programs: dict[str, str], depends: str, more: dict[str, str] | None = None
) -> Path:
    """Make a package of Python programs, one module and one executable each; `more`: files for share, by folder and name."""
    lab.run(
        f"cd ~/ros2_ws/src && ros2 pkg create --build-type ament_python --dependencies {depends} --license Apache-2.0 {name}"
    )
    lab.run("cd ~/ros2_ws")
    folder = lab.home / "ros2_ws/src" / name
    for program, text in programs.items():
        (folder / name / f"{program}.py").write_text(text, encoding="utf-8")
    setup = folder / "setup.py"
    text = setup.read_text(encoding="utf-8")
    lines = "".join(f"            '{program} = {name}.{program}:main',\n" for program in programs)
    text = text.replace("'console_scripts': [\n", f"'console_scripts': [\n{lines}")
    shared = "('share/' + package_name, ['package.xml']),\n"
    for path, content in (more or {}).items():
        (folder / path).parent.mkdir(exist_ok=True)
        (folder / path).write_text(content, encoding="utf-8")
        place = path.rpartition("/")[0]
        text = text.replace(shared, f"{shared}        ('share/' + package_name + '/{place}', ['{path}']),\n")
    setup.write_text(text, encoding="utf-8")
    return folder


def built(lab: Lab, *names: str) -> None:
    """Build these, and source the workspace in three terminals."""
    said = lab.run(f"colcon build --packages-select {' '.join(names)}")
    assert "Failed" not in said and "Finished" in said, said
    for number in range(3):
        lab.run(f"cd ~/ros2_ws && {SOURCE}", number)


TALK = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Parrot(Node):
    def __init__(self):
        super().__init__('minimal_publisher')
        self.out = self.create_publisher(String, 'topic', 10)
        self.clock_tick = self.create_timer(0.5, self.say)
        self.said = 0

    def say(self):
        self.out.publish(String(data=f'word {self.said}'))
        self.get_logger().info(f'said word {self.said}')
        self.said += 1


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Parrot())
    rclpy.shutdown()
"""
HEAR = """
import rclpy
from rclpy.node import Node
from std_msgs.msg import String


class Ear(Node):
    def __init__(self):
        super().__init__('minimal_subscriber')
        self.create_subscription(String, 'topic', self.hear, 10)

    def hear(self, message):
        self.get_logger().info(f'heard {message.data}')


def main(args=None):
    rclpy.init(args=args)
    rclpy.spin(Ear())
    rclpy.shutdown()
"""


def pubsub(lab: Lab) -> None:
    """Publisher and subscriber; the listener is started first, as half of the pupils do."""
    python_package(lab, "py_pubsub", {"talker": TALK, "listener": HEAR}, "rclpy std_msgs")
    built(lab, "py_pubsub")
    lab.start("ros2 run py_pubsub listener", 1)
    lab.wait_node("/minimal_subscriber")
    lab.start("ros2 run py_pubsub talker", 0)
    lab.wait(lambda: "heard word" in lab.screen(1))


def talker_ended(lab: Lab) -> None:
    """The same, and Ctrl-C in both: the tutorial ends so."""
    pubsub(lab)
    lab.interrupt(0)
    lab.interrupt(1)


ADD_SERVER = """
import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.node import Node


class Adder(Node):
    def __init__(self):
        super().__init__('minimal_service')
        self.create_service(AddTwoInts, 'add_two_ints', self.add)

    def add(self, request, response):
        response.sum = request.a + request.b
        self.get_logger().info(f'{request.a} and {request.b}')
        return response


def main():
    rclpy.init()
    rclpy.spin(Adder())
    rclpy.shutdown()
"""
ADD_CLIENT = """
import sys

import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.node import Node


class Asker(Node):
    def __init__(self):
        super().__init__('minimal_client_async')
        self.client = self.create_client(AddTwoInts, 'add_two_ints')
        while not self.client.wait_for_service(timeout_sec=1.0):
            self.get_logger().info('service not available, waiting again...')

    def ask(self, a, b):
        return self.client.call_async(AddTwoInts.Request(a=a, b=b))


def main():
    rclpy.init()
    asker = Asker()
    future = asker.ask(int(sys.argv[1]), int(sys.argv[2]))
    rclpy.spin_until_future_complete(asker, future)
    asker.get_logger().info(f'sum: {future.result().sum}')
    asker.destroy_node()
    rclpy.shutdown()
"""


def service_and_client(lab: Lab) -> None:
    programs = {"service": ADD_SERVER, "client": ADD_CLIENT}
    python_package(lab, "py_srvcli", programs, "rclpy example_interfaces")
    built(lab, "py_srvcli")
    lab.start("ros2 run py_srvcli service", 0)
    lab.wait_node("/minimal_service")
    assert "sum: 5" in lab.run("ros2 run py_srvcli client 2 3", 1)


def client_before_service(lab: Lab) -> None:
    """The client is started first and waits, as the tutorial lets it; then comes the service."""
    programs = {"service": ADD_SERVER, "client": ADD_CLIENT}
    python_package(lab, "py_srvcli", programs, "rclpy example_interfaces")
    built(lab, "py_srvcli")
    lab.start("ros2 run py_srvcli client 2 3", 1, shows="waiting again")
    lab.start("ros2 run py_srvcli service", 0)
    lab.wait(lambda: "sum: 5" in lab.screen(1))


CMAKE = """\
cmake_minimum_required(VERSION 3.8)
project(tutorial_interfaces)
find_package(ament_cmake REQUIRED)
find_package(geometry_msgs REQUIRED)
find_package(rosidl_default_generators REQUIRED)
rosidl_generate_interfaces(${PROJECT_NAME}
  "msg/Num.msg"
  "msg/Sphere.msg"
  "srv/AddThreeInts.srv"
  DEPENDENCIES geometry_msgs
)
ament_package()
"""
INTERFACES_USED = """
import rclpy
from rclpy.node import Node
from tutorial_interfaces.msg import Num
from tutorial_interfaces.srv import AddThreeInts


class Counter(Node):
    def __init__(self):
        super().__init__('counter')
        self.out = self.create_publisher(Num, 'number', 10)
        self.create_subscription(Num, 'number', self.hear, 10)
        self.create_service(AddThreeInts, 'add_three_ints', self.add)
        self.at = 0
        self.create_timer(0.2, self.count)

    def count(self):
        self.at += 1
        self.out.publish(Num(num=self.at))

    def hear(self, message):
        self.get_logger().info(f'number {message.num}')

    def add(self, request, response):
        response.sum = request.a + request.b + request.c
        return response


def main():
    rclpy.init()
    rclpy.spin(Counter())
"""


def custom_interfaces(lab: Lab) -> None:
    lab.run("cd ~/ros2_ws/src && ros2 pkg create --build-type ament_cmake --license Apache-2.0 tutorial_interfaces")
    folder = lab.home / "ros2_ws/src/tutorial_interfaces"
    for name, text in {
        "msg/Num.msg": "int64 num\n",
        "msg/Sphere.msg": "geometry_msgs/Point center\nfloat64 radius\n",
        "srv/AddThreeInts.srv": "int64 a\nint64 b\nint64 c\n---\nint64 sum\n",
        "CMakeLists.txt": CMAKE,
    }.items():
        (folder / name).parent.mkdir(exist_ok=True)
        (folder / name).write_text(text, encoding="utf-8")
    manifest = folder / "package.xml"
    more = (
        "<depend>geometry_msgs</depend>\n  <buildtool_depend>rosidl_default_generators</buildtool_depend>\n"
        "  <exec_depend>rosidl_default_runtime</exec_depend>\n"
        "  <member_of_group>rosidl_interface_packages</member_of_group>\n  <export>"
    )
    manifest.write_text(manifest.read_text(encoding="utf-8").replace("<export>", more), encoding="utf-8")
    python_package(lab, "py_counter", {"counter": INTERFACES_USED}, "rclpy tutorial_interfaces")
    built(lab, "tutorial_interfaces", "py_counter")
    lab.run("ros2 interface show tutorial_interfaces/msg/Num")
    lab.start("ros2 run py_counter counter", 1, shows="number")
    lab.start("ros2 topic echo /number", 2, shows="num:")
    call = "ros2 service call /add_three_ints tutorial_interfaces/srv/AddThreeInts '{a: 1, b: 2, c: 3}'"
    assert "sum=6" in lab.run(call, 0)


PARAMETERS = """
import rclpy
from rclpy.node import Node
from rclpy.parameter import Parameter


class Greeter(Node):
    def __init__(self):
        super().__init__('minimal_param_node')
        self.declare_parameter('my_parameter', 'world')
        self.timer = self.create_timer(0.5, self.greet)

    def greet(self):
        name = self.get_parameter('my_parameter').get_parameter_value().string_value
        self.get_logger().info(f'Hello {name}!')
        self.set_parameters([Parameter('my_parameter', Parameter.Type.STRING, 'world')])


def main():
    rclpy.init()
    rclpy.spin(Greeter())
"""
PARAMETERS_LAUNCHED = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='python_parameters', executable='minimal_param_node', name='custom_minimal_param_node',
             output='screen', emulate_tty=True, parameters=[{'my_parameter': 'earth'}]),
    ])
"""


def parameters(lab: Lab) -> None:
    more = {"launch/python_parameters_launch.py": PARAMETERS_LAUNCHED}
    python_package(lab, "python_parameters", {"minimal_param_node": PARAMETERS}, "rclpy", more)
    built(lab, "python_parameters")
    lab.start("ros2 run python_parameters minimal_param_node", 1, shows="Hello world!")
    lab.run("ros2 param list")
    lab.run("ros2 param set /minimal_param_node my_parameter earth")
    lab.start("ros2 launch python_parameters python_parameters_launch.py", 2, shows="Hello")
    lab.wait_node("/custom_minimal_param_node")


MIMIC = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', namespace='turtlesim1', executable='turtlesim_node', name='sim'),
        Node(package='turtlesim', namespace='turtlesim2', executable='turtlesim_node', name='sim'),
        Node(package='turtlesim', executable='mimic', name='mimic', remappings=[
            ('/input/pose', '/turtlesim1/turtle1/pose'), ('/output/cmd_vel', '/turtlesim2/turtle1/cmd_vel')]),
    ])
"""


def launch_files(lab: Lab) -> None:
    """Two turtles, the second one mimics the first, which is driven from a terminal."""
    lab.run("mkdir -p ~/launch")
    lab.file("launch/turtlesim_mimic_launch.py", MIMIC)
    lab.start("cd ~/launch; ros2 launch turtlesim_mimic_launch.py")
    for name in ("/turtlesim1/sim", "/turtlesim2/sim", "/mimic"):
        lab.wait_node(name)
    twist = "geometry_msgs/msg/Twist '{linear: {x: 2.0}, angular: {z: -1.8}}'"
    lab.start(f"ros2 topic pub -r 1 /turtlesim1/turtle1/cmd_vel {twist}", 1, shows="publishing #1")
    lab.start("ros2 topic echo /turtlesim2/turtle1/cmd_vel", 2, shows="linear")


STATIC = """
import sys

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster


class Shelf(Node):
    def __init__(self, child):
        super().__init__('static_turtle_tf2_broadcaster')
        self.broadcaster = StaticTransformBroadcaster(self)
        said = TransformStamped()
        said.header.stamp = self.get_clock().now().to_msg()
        said.header.frame_id = 'world'
        said.child_frame_id = child
        said.transform.translation.z = 1.0
        said.transform.rotation.w = 1.0
        self.broadcaster.sendTransform(said)


def main():
    rclpy.init()
    rclpy.spin(Shelf(sys.argv[1]))
"""
BROADCASTER = """
import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from tf2_ros import TransformBroadcaster
from turtlesim.msg import Pose


class Frames(Node):
    def __init__(self):
        super().__init__('turtle_tf2_frame_publisher')
        self.name = self.declare_parameter('turtlename', 'turtle').get_parameter_value().string_value
        self.broadcaster = TransformBroadcaster(self)
        self.create_subscription(Pose, f'/{self.name}/pose', self.tell, 1)

    def tell(self, pose):
        said = TransformStamped()
        said.header.stamp = self.get_clock().now().to_msg()
        said.header.frame_id = 'world'
        said.child_frame_id = self.name
        said.transform.translation.x = pose.x
        said.transform.translation.y = pose.y
        said.transform.rotation.z = math.sin(pose.theta / 2)
        said.transform.rotation.w = math.cos(pose.theta / 2)
        self.broadcaster.sendTransform(said)


def main():
    rclpy.init()
    rclpy.spin(Frames())
"""
FOLLOWER = """
import math

import rclpy
from geometry_msgs.msg import Twist
from rclpy.node import Node
from tf2_ros import TransformException
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener
from turtlesim.srv import Spawn


class Follower(Node):
    def __init__(self):
        super().__init__('turtle_tf2_frame_listener')
        self.target = self.declare_parameter('target_frame', 'turtle1').get_parameter_value().string_value
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.spawner = self.create_client(Spawn, 'spawn')
        self.asked = False
        self.out = self.create_publisher(Twist, 'turtle2/cmd_vel', 1)
        self.create_timer(0.2, self.follow)

    def follow(self):
        if not self.asked:
            if self.spawner.service_is_ready():
                self.spawner.call_async(Spawn.Request(name='turtle2', x=4.0, y=2.0))
                self.asked = True
            return
        try:
            there = self.buffer.lookup_transform('turtle2', self.target, rclpy.time.Time()).transform.translation
        except TransformException as error:
            self.get_logger().info(f'Could not transform turtle2 to {self.target}: {error}')
            return
        twist = Twist()
        twist.angular.z = math.atan2(there.y, there.x)
        twist.linear.x = 0.5 * math.hypot(there.x, there.y)
        self.out.publish(twist)


def main():
    rclpy.init()
    rclpy.spin(Follower())
"""
FRAMES_LAUNCHED = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim'),
        Node(package='learning_tf2_py', executable='turtle_tf2_broadcaster', name='broadcaster1',
             parameters=[{'turtlename': 'turtle1'}]),
        DeclareLaunchArgument('target_frame', default_value='turtle1'),
        Node(package='learning_tf2_py', executable='turtle_tf2_broadcaster', name='broadcaster2',
             parameters=[{'turtlename': 'turtle2'}]),
        Node(package='learning_tf2_py', executable='turtle_tf2_listener', name='listener',
             parameters=[{'target_frame': LaunchConfiguration('target_frame')}]),
    ])
"""


def transforms(lab: Lab) -> None:
    """A turtle that follows another by TF, with tf2_echo beside it; and a static frame."""
    python_package(
        lab,
        "learning_tf2_py",
        {
            "static_turtle_tf2_broadcaster": STATIC,
            "turtle_tf2_broadcaster": BROADCASTER,
            "turtle_tf2_listener": FOLLOWER,
        },
        "geometry_msgs rclpy tf2_ros turtlesim",
        {"launch/turtle_tf2_demo_launch.py": FRAMES_LAUNCHED},
    )
    built(lab, "learning_tf2_py")
    lab.start("ros2 launch learning_tf2_py turtle_tf2_demo_launch.py")
    lab.start("ros2 run tf2_ros tf2_echo turtle2 turtle1", 1, shows="Translation")
    lab.start("ros2 run learning_tf2_py static_turtle_tf2_broadcaster shelf", 2)
    lab.wait_node("/static_turtle_tf2_broadcaster")
    lab.start("ros2 run turtlesim turtle_teleop_key", 3)


def figure(name: str, z: float) -> str:
    """A robot like the URDF tutorial's: a body on legs, wheels, a gripper that slides, a head that swivels."""
    wheel = (
        '<link name="{side}_{end}_wheel"><visual><origin rpy="1.57075 0 0"/><geometry>'
        '<cylinder length="0.1" radius="0.035"/></geometry></visual><collision><geometry>'
        '<cylinder length="0.1" radius="0.035"/></geometry></collision><inertial><mass value="1"/>'
        '<inertia ixx="0.001" ixy="0" ixz="0" iyy="0.001" iyz="0" izz="0.001"/></inertial></link>'
        '<joint name="{side}_{end}_wheel_joint" type="continuous"><axis xyz="0 1 0"/><parent link="{side}_leg"/>'
        '<child link="{side}_{end}_wheel"/><origin xyz="{x} 0 -0.35"/></joint>'
    )
    leg = (
        '<link name="{side}_leg"><visual><origin xyz="0 0 -0.15"/><geometry><box size="0.1 0.2 0.4"/></geometry></visual></link>'
        '<joint name="base_to_{side}_leg" type="fixed"><parent link="base_link"/><child link="{side}_leg"/>'
        '<origin xyz="0 {y} {z}"/></joint>'
    )
    legs = "".join(leg.format(side=side, y=y, z=z) for side, y in (("right", -0.22), ("left", 0.22)))
    wheels = "".join(
        wheel.format(side=side, end=end, x=x)
        for side in ("right", "left")
        for end, x in (("front", 0.133), ("back", -0.133))
    )
    return (
        f'<?xml version="1.0"?>\n<robot name="{name}"><link name="base_link"><visual><geometry>'
        '<cylinder length="0.6" radius="0.2"/></geometry></visual></link>'
        f"{legs}{wheels}"
        '<link name="gripper_pole"><visual><geometry><cylinder length="0.2" radius="0.01"/></geometry></visual></link>'
        '<joint name="gripper_extension" type="prismatic"><parent link="base_link"/><child link="gripper_pole"/>'
        '<axis xyz="1 0 0"/><limit effort="1000" lower="-0.38" upper="0" velocity="0.5"/><origin xyz="0.19 0 0.2"/></joint>'
        '<link name="head"><visual><geometry><sphere radius="0.2"/></geometry></visual></link>'
        '<joint name="head_swivel" type="continuous"><parent link="base_link"/><child link="head"/><axis xyz="0 0 1"/>'
        '<origin xyz="0 0 0.3"/></joint></robot>\n'
    )


STATES = """
import math

import rclpy
from geometry_msgs.msg import TransformStamped
from rclpy.node import Node
from sensor_msgs.msg import JointState
from tf2_ros import TransformBroadcaster

WHEELS = [f'{side}_{end}_wheel_joint' for side in ('right', 'left') for end in ('front', 'back')]


class Mover(Node):
    def __init__(self):
        super().__init__('state_publisher')
        self.joints = self.create_publisher(JointState, 'joint_states', 10)
        self.broadcaster = TransformBroadcaster(self)
        self.turn = 0.0
        self.create_timer(1 / 30, self.move)

    def move(self):
        self.turn += 0.02
        now = self.get_clock().now().to_msg()
        state = JointState()
        state.header.stamp = now
        state.name = ['head_swivel', 'gripper_extension', *WHEELS]
        state.position = [self.turn, -0.19 + 0.1 * math.sin(self.turn), *[self.turn] * 4]
        where = TransformStamped()
        where.header.stamp = now
        where.header.frame_id = 'odom'
        where.child_frame_id = 'base_link'
        where.transform.translation.x = 2 * math.cos(self.turn)
        where.transform.translation.y = 2 * math.sin(self.turn)
        where.transform.rotation.z = math.sin(self.turn / 2)
        where.transform.rotation.w = math.cos(self.turn / 2)
        self.joints.publish(state)
        self.broadcaster.sendTransform(where)


def main():
    rclpy.init()
    rclpy.spin(Mover())
"""
ROBOT_LAUNCHED = """
import os

from ament_index_python.packages import get_package_share_directory
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    with open(os.path.join(get_package_share_directory('urdf_tutorial_r2d2'), 'urdf', 'r2d2.urdf')) as file:
        robot = file.read()
    return LaunchDescription([
        Node(package='robot_state_publisher', executable='robot_state_publisher', output='screen',
             parameters=[{'use_sim_time': False, 'robot_description': robot}]),
        Node(package='urdf_tutorial_r2d2', executable='state_publisher', output='screen'),
    ])
"""
SCENE = """\
Visualization Manager:
  Displays:
    - Class: rviz_default_plugins/RobotModel
      Name: RobotModel
      Enabled: true
      Description Topic:
        Value: /robot_description
    - Class: rviz_default_plugins/TF
      Name: TF
      Enabled: true
  Global Options:
    Fixed Frame: odom
"""


def robot_that_moves(lab: Lab) -> None:
    """robot_state_publisher with joint states and an odometry of one's own, looked at in RViz."""
    python_package(
        lab,
        "urdf_tutorial_r2d2",
        {"state_publisher": STATES},
        "rclpy geometry_msgs sensor_msgs tf2_ros",
        {
            "urdf/r2d2.urdf": figure("r2d2", 0.25),
            "urdf/r2d2.rviz": SCENE,
            "launch/demo_launch.py": ROBOT_LAUNCHED,
        },
    )
    built(lab, "urdf_tutorial_r2d2")
    lab.start("ros2 launch urdf_tutorial_r2d2 demo_launch.py")
    lab.wait_node("/state_publisher")
    lab.wait_node("/robot_state_publisher")
    lab.start("rviz2 -d install/urdf_tutorial_r2d2/share/urdf_tutorial_r2d2/urdf/r2d2.rviz", 1)
    lab.wait(lambda: lab.windows("rviz2"))
    lab.start("ros2 topic echo /joint_states", 2, shows="head_swivel")


def robot_with_sliders(lab: Lab) -> None:
    """The first robot of the URDF tutorials with the sliders."""
    lab.file("r2d2.urdf", figure("visual", 0.25))
    lab.start("ros2 run robot_state_publisher robot_state_publisher r2d2.urdf")
    lab.wait_node("/robot_state_publisher")
    lab.start("ros2 run joint_state_publisher_gui joint_state_publisher_gui", 1)
    lab.wait(lambda: lab.windows("joint_state_publisher"))
    lab.file("my.rviz", SCENE.replace("odom", "base_link"))
    lab.start("rviz2 -d my.rviz", 2)
    lab.wait(lambda: lab.windows("rviz2"))


TUTORIALS: tuple[Callable[[Lab], object], ...] = (
    pubsub, talker_ended, service_and_client, client_before_service, custom_interfaces, parameters, launch_files, transforms,
    robot_that_moves, robot_with_sliders,
)  # fmt: skip

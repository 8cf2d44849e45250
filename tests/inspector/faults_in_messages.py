"""Faults in what is sent: numbers, transforms, stamps, sizes, joints. Each is really injected, as in `drills.py`.

`IN_MESSAGES` is a table like `DRILLS`. Nearly all are one program that publishes one message again and again.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from day6_urdf import shipped_model
from tests.inspector.drills import HEAD, Drill, joints, robot

if TYPE_CHECKING:
    from tests.inspector.lab import Lab

SENDER = (
    HEAD
    + """
import math
from builtin_interfaces.msg import Time
from geometry_msgs.msg import *
from nav_msgs.msg import *
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import *
from std_msgs.msg import *
from tf2_msgs.msg import TFMessage
from trajectory_msgs.msg import JointTrajectory, JointTrajectoryPoint

rclpy.init()
node = Node({name!r})
began = time.monotonic()


def now(seconds=0.0):
    stamp = node.get_clock().now().nanoseconds + round(seconds * 1e9)
    return Time(sec=stamp // 10**9, nanosec=stamp % 10**9)


def header(frame='', stamp=None):
    return Header(frame_id=frame, stamp=now() if stamp is None else stamp)


def tf(parent, child, x=0.0, turned=(0.0, 0.0, 0.0, 1.0), stamp=None):
    made = TransformStamped(header=header(parent, stamp), child_frame_id=child)
    made.transform.translation.x = x
    made.transform.rotation = Quaternion(**dict(zip('xyzw', turned)))
    return made


def pose(turned=(0.0, 0.0, 0.0, 1.0), x=0.0):
    return Pose(position=Point(x=x), orientation=Quaternion(**dict(zip('xyzw', turned))))


def odometry(frame='odom', child='base_link', x=0.0, turned=(0.0, 0.0, 0.0, 1.0), stamp=None):
    made = Odometry(header=header(frame, stamp), child_frame_id=child)
    made.pose.pose = pose(turned, x)
    return made


def scan(frame='laser', stamp=None, count=5, **fields):
    usual = dict(angle_min=-1.0, angle_max=1.0, angle_increment=0.5, range_min=0.1, range_max=10.0)
    ranges = fields.pop('ranges', [1.0] * count)
    return LaserScan(header=header(frame, stamp), ranges=ranges, **{{**usual, **fields}})


def cloud(length, step=16, width=10):
    fields = [PointField(name=name, offset=4 * at, datatype=PointField.FLOAT32, count=1) for at, name in enumerate('xyz')]
    return PointCloud2(
        header=header('laser'), height=1, width=width, fields=fields, point_step=step, row_step=step * width,
        data=bytes(length),
    )


def grid(cells, resolution=0.1):
    made = OccupancyGrid(header=header('map'), data=[0] * cells)
    made.info.width, made.info.height, made.info.resolution = 10, 10, resolution
    return made


sent = [(node.create_publisher(kind, topic, 10), make) for topic, kind, make in [{sent}]]


def send():
    for publisher, make in sent:
        publisher.publish(make())


node.create_timer({period}, send)
rclpy.spin(node)
"""
)


def start(lab: Lab, *sent: str, name: str = "sender", number: int = 0, period: float = 0.05, options: str = "") -> None:
    """Start a program that publishes topics again and again: `'topic', Type, how a message is made`."""
    lines = "".join(
        f"({topic}, {kind}, lambda: {make}), " for topic, kind, make in (each.split(", ", 2) for each in sent)
    )
    lab.file(f"{name}.py", SENDER.format(name=name, sent=lines, period=period))
    lab.start(f"python3 {name}.py {options}".rstrip(), number)
    lab.wait_node(f"/{name}")


def sends(*sent: str, period: float = 0.05) -> Callable[[Lab], object]:
    return lambda lab: start(lab, *sent, period=period)


def both(first: str, second: str) -> Callable[[Lab], object]:
    """The same from two programs."""

    def inject(lab: Lab) -> None:
        start(lab, first, name="one")
        start(lab, second, name="other", number=1)

    return inject


def with_robot(*sent: str) -> Callable[[Lab], object]:
    def inject(lab: Lab) -> None:
        robot(lab)
        start(lab, *sent, number=1)

    return inject


def nan_to_the_turtle(lab: Lab) -> None:
    lab.start("ros2 run turtlesim turtlesim_node")
    start(lab, "'/turtle1/cmd_vel', Twist, Twist(linear=Vector3(x=math.nan))", number=1)


def wheels_by_other_names(lab: Lab) -> None:
    robot(lab)
    lab.start(joints("[lwheel, rwheel]", ", header: {stamp: now}"), 1, shows="publishing #1")


def one_wheel(lab: Lab) -> None:
    robot(lab)
    line = "'/joint_states', JointState, JointState(header=header(), name=['left_wheel_joint'], position=[0.1])"
    start(lab, line, number=1)


def no_wheels(lab: Lab) -> None:
    """Names and no position."""
    robot(lab)
    names = "['left_wheel_joint', 'right_wheel_joint']"
    start(lab, f"'/joint_states', JointState, JointState(header=header(), name={names}, velocity=[1.0, 1.0])", number=1)


def two_descriptions(lab: Lab) -> None:
    robot(lab)
    other = shipped_model().read_text(encoding="utf-8").replace("left_wheel_joint", "front_wheel_joint")
    lab.file("other.urdf", other)
    lab.start(
        "ros2 run robot_state_publisher robot_state_publisher other.urdf --ros-args -r __node:=other_publisher", 1
    )
    lab.wait_node("/other_publisher")


def no_inertia(lab: Lab) -> None:
    import re

    text = re.sub(r'i(xx|yy|zz)="[^"]*"', r'i\1="0"', shipped_model("day6_bot_gazebo").read_text(encoding="utf-8"))
    lab.file("my_car.urdf", text)
    lab.start("ros2 run day6_world world --ros-args -p robot_file:=my_car.urdf")
    lab.wait(lambda: lab.windows("world"))


def beyond_limits(lab: Lab) -> None:
    """An arm in degrees."""
    text = (
        '<robot name="arm"><link name="base_link"/><link name="arm"/><joint name="arm_joint" type="revolute">'
        '<parent link="base_link"/><child link="arm"/><axis xyz="0 0 1"/>'
        '<limit lower="-1.57" upper="1.57" effort="1" velocity="1"/></joint></robot>'
    )
    robot(lab, lambda _: text)
    line = "'/joint_states', JointState, JointState(header=header(), name=['arm_joint'], position=[90.0])"
    start(lab, line, number=1)


def played(lab: Lab) -> None:
    """A bag of yesterday: its stamps are old, and that is right."""
    start(
        lab,
        "'/scan', LaserScan, scan(stamp=now(-86400))",
        TREE.replace("')", "', stamp=now(-86400))"),
        name="yesterday",
    )
    lab.start("ros2 bag record -o yesterday /scan /tf", 1, shows="Subscribed to topic '/tf'")
    lab.run("sleep 2", 2)
    lab.interrupt(1)
    lab.interrupt(0)
    lab.start("ros2 bag play -l yesterday", 0, shows="Playback")


def measured(lab: Lab) -> None:
    """What sensors say where there is nothing to measure, and sizes that look odd and are right."""
    start(
        lab,
        TREE,
        "'/scan', LaserScan, scan(ranges=[math.nan, math.inf, 1.0, 0.0, -math.inf])",
        "'/half_scan', LaserScan, scan(angle_min=0.0, angle_max=6.28, angle_increment=0.0175, count=360)",
        "'/battery', BatteryState, BatteryState(percentage=math.nan, voltage=math.nan)",
        "'/fix', NavSatFix, NavSatFix(latitude=math.nan, longitude=math.nan)",
        "'/sonar', Range, Range(range=math.inf)",
        "'/echo', Float32, Float32(data=math.inf)",
        "'/imu', Imu, Imu(header=header('laser'), orientation=Quaternion(w=0.0), orientation_covariance=[-1.0] * 9)",
        "'/padded', Image, Image(header=header('laser'), width=3, height=2, encoding='mono8', step=4, data=bytes(8))",
        "'/jpeg', CompressedImage, CompressedImage(format='jpeg', data=bytes(5))",
        "'/points', PointCloud2, cloud(160)",
        "'/map', OccupancyGrid, grid(100)",
        "'/empty_map', OccupancyGrid, OccupancyGrid(header=header('odom'))",
        "'/turned', PoseStamped, PoseStamped(header=header('odom'), pose=pose((0.0, 0.0, -0.7071, 0.7071)))",
        "'/array', Float64MultiArray, Float64MultiArray(data=[1.0, 2.0])",
    )


def handed_over(lab: Lab) -> None:
    """A cup that is on the table first and in the gripper then: one parent at a time."""
    gripped = "tf('table' if int(time.time() / 3) % 2 else 'gripper', 'cup')"
    start(lab, f"'/tf', TFMessage, TFMessage(transforms=[tf('world', 'table'), tf('world', 'gripper'), {gripped}])")


def simulated(lab: Lab) -> None:
    """A simulator's clock begins at 0, and everybody goes by it."""
    ticks = "'/clock', Clock, Clock(clock=Time(sec=int(time.monotonic() - began)))"
    start(lab, ticks, name="simulator", number=2)
    start(lab, "'/odom', Odometry, odometry()", TREE, name="robot", options="--ros-args -p use_sim_time:=true")


def paused(lab: Lab) -> None:
    """A simulator that has sent its very first time, and waits for somebody to press Play."""
    start(lab, "'/clock', Clock, Clock()", name="simulator", number=2)
    start(lab, "'/odom', Odometry, odometry()", TREE, name="robot", options="--ros-args -p use_sim_time:=true")


HEALTHY: tuple[Callable[[Lab], object], ...] = (played, measured, handed_over, simulated, paused)

TREE = "'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link'), tf('base_link', 'laser')])"
WHEELS = "name=['left_wheel_joint', 'right_wheel_joint']"

IN_MESSAGES: tuple[Drill, ...] = (
    Drill("d1", "NaN in cmd_vel", nan_to_the_turtle, ("not_finite",)),
    Drill("d2", "infinity in cmd_vel", sends("'/cmd_vel', Twist, Twist(angular=Vector3(z=math.inf))"), ("not_finite",)),
    Drill(
        "d3",
        "NaN in a pose",
        sends("'/goal', PoseStamped, PoseStamped(header=header('map'), pose=pose(x=math.nan))"),
        ("not_finite",),
    ),
    Drill(
        "d4",
        "NaN in joint states",
        with_robot(f"'/joint_states', JointState, JointState(header=header(), {WHEELS}, position=[math.nan, 0.0])"),
        ("not_finite",),
    ),
    Drill("d5", "NaN in odometry", sends("'/odom', Odometry, odometry(x=math.nan)", TREE), ("not_finite",)),
    Drill(
        "d6",
        "infinity in an array",
        sends("'/speeds', Float64MultiArray, Float64MultiArray(data=[0.0, -math.inf])"),
        ("not_finite",),
    ),
    Drill(
        "d7",
        "NaN in a transform",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link', x=math.nan)])"),
        ("not_finite",),
    ),
    Drill(
        "d8",
        "NaN once a second",
        sends("'/cmd_vel', Twist, Twist(linear=Vector3(x=math.nan if time.time() % 1 < 0.5 else 0.0))", period=0.5),
        ("not_finite",),
    ),
    Drill(
        "d9",
        "zero quaternion in a transform",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link', turned=(0.0, 0.0, 0.0, 0.0))])"),
        ("quaternion",),
    ),
    Drill(
        "d10",
        "zero quaternion in odometry",
        sends("'/odom', Odometry, odometry(turned=(0.0, 0.0, 0.0, 0.0))", TREE),
        ("quaternion",),
    ),
    Drill(
        "d11",
        "an angle in z of a quaternion",
        sends("'/odom', Odometry, odometry(turned=(0.0, 0.0, 1.57, 1.0))", TREE),
        ("quaternion",),
    ),
    Drill(
        "d12",
        "transforms in a loop",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('a', 'b'), tf('b', 'c'), tf('c', 'a')])"),
        ("tf_loop",),
    ),
    Drill(
        "d13",
        "a frame is its own parent",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('base_link', 'base_link')])"),
        ("tf_loop",),
    ),
    Drill(
        "d14",
        "a frame with two parents",
        both(
            "'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link')])",
            "'/tf', TFMessage, TFMessage(transforms=[tf('map', 'base_link')])",
        ),
        ("two_parents",),
    ),
    Drill(
        "d15",
        "two programs send one transform",
        both(
            "'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link', x=1.0)])",
            "'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link', x=2.0)])",
        ),
        ("tf_fight",),
    ),
    Drill(
        "d16",
        "a transform without a frame",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('', 'base_link')])"),
        ("tf_nameless",),
    ),
    Drill(
        "d17",
        "transforms stamped 1970",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link', stamp=Time(sec=5))])"),
        ("stamp_1970",),
    ),
    Drill(
        "d18",
        "transforms stamped in an hour",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link', stamp=now(3600))])"),
        ("stamp_future",),
    ),
    Drill("d19", "a scan without a stamp", sends("'/scan', LaserScan, scan(stamp=Time())", TREE), ("stampless",)),
    Drill(
        "d20",
        "odometry of another clock",
        sends("'/odom', Odometry, odometry(stamp=Time(sec=12))", TREE),
        ("stamp_1970",),
    ),
    Drill(
        "d21",
        "a scan of NaN, increment 0, in a frame that is nowhere",
        sends("'/scan', LaserScan, scan('lidar', ranges=[math.nan] * 5, angle_increment=0.0)", TREE),
        ("scan_angles",),
    ),
    Drill(
        "d22",
        "a scan of nothing but NaN",
        sends("'/scan', LaserScan, scan(ranges=[math.nan] * 5)", TREE),
        ("scan_empty",),
    ),
    Drill("d23", "more ranges than angles", sends("'/scan', LaserScan, scan(count=360)", TREE), ("scan_angles",)),
    Drill(
        "d24",
        "a scan in degrees",
        sends("'/scan', LaserScan, scan(angle_min=0.0, angle_max=359.0, angle_increment=1.0, count=360)", TREE),
        ("scan_degrees",),
    ),
    Drill("d25", "range_max 0", sends("'/scan', LaserScan, scan(range_max=0.0)", TREE), ("scan_ranges",)),
    Drill(
        "d26",
        "a scan in a frame that is nowhere",
        sends("'/scan', LaserScan, scan('lidar')", TREE),
        ("unknown_frame", "unknown_frame_near"),
    ),
    Drill("d27", "a scan without a frame", sends("'/scan', LaserScan, scan('')", TREE), ("empty_frame",)),
    Drill(
        "d28", "odometry without a child frame", sends("'/odom', Odometry, odometry(child='')", TREE), ("empty_frame",)
    ),
    Drill(
        "d29",
        "odometry of a frame that is nowhere",
        sends("'/odom', Odometry, odometry(child='base_footprint')", TREE),
        ("unknown_frame", "unknown_frame_near"),
    ),
    Drill(
        "d30",
        "an image with too few bytes",
        sends(
            "'/image', Image, Image(header=header('laser'), width=8, height=4, encoding='rgb8', step=24, data=bytes(32))"
        ),
        ("data_size",),
    ),
    Drill(
        "d31",
        "an image whose rows are too short",
        sends(
            "'/image', Image, Image(header=header('laser'), width=8, height=4, encoding='bgr8', step=8, data=bytes(32))"
        ),
        ("data_size",),
    ),
    Drill("d32", "a point cloud with too few bytes", sends("'/points', PointCloud2, cloud(100)"), ("data_size",)),
    Drill("d33", "points longer than their step", sends("'/points', PointCloud2, cloud(80, step=8)"), ("data_size",)),
    Drill("d34", "a map with too few cells", sends("'/map', OccupancyGrid, grid(90)"), ("data_size",)),
    Drill("d35", "a map of resolution 0", sends("'/map', OccupancyGrid, grid(100, 0.0)"), ("map_resolution",)),
    Drill(
        "d36",
        "a trajectory with too few positions",
        sends(
            "'/trajectory', JointTrajectory, JointTrajectory(joint_names=['a', 'b'], "
            "points=[JointTrajectoryPoint(positions=[0.0])])"
        ),
        ("data_size",),
    ),
    Drill(
        "d37",
        "a trajectory for a joint that is not there",
        with_robot(
            "'/trajectory', JointTrajectory, JointTrajectory(joint_names=['left_weel_joint'], "
            "points=[JointTrajectoryPoint(positions=[0.0])])"
        ),
        ("trajectory_joint_near",),
    ),
    Drill(
        "d38",
        "two programs publish odometry",
        both("'/odom', Odometry, odometry()", "'/odom', Odometry, odometry()"),
        ("fight",),
    ),
    Drill("d39", "two clocks", both("'/clock', Clock, Clock(clock=now())", "'/clock', Clock, Clock()"), ("fight",)),
    Drill(
        "d40",
        "a battery in percent",
        sends("'/battery', BatteryState, BatteryState(percentage=87.0)"),
        ("out_of_range",),
    ),
    Drill(
        "d41",
        "latitude and longitude exchanged",
        sends("'/fix', NavSatFix, NavSatFix(header=header('gps'), latitude=116.4, longitude=39.9)"),
        ("out_of_range",),
    ),
    Drill("d42", "my wheels are missing: other names", wheels_by_other_names, ("other_joints", "unknown_joint_near")),
    Drill("d43", "my wheels are missing: one is published", one_wheel, ("silent_joint",)),
    Drill("d44", "my wheels are missing: nobody publishes", robot, ("no_joint_states",)),
    Drill("d45", "my wheels are missing: names without positions", no_wheels, ("unequal_joints",)),
    Drill("d46", "two descriptions of one robot", two_descriptions, ("two_descriptions",)),
    Drill("d47", "inertia 0", no_inertia, ("world.bad_inertia",)),
    Drill("d48", "an arm in degrees", beyond_limits, ("joint_limits",)),
    Drill(
        "d49",
        "this computer's time beside a simulator's",
        both("'/clock', Clock, Clock(clock=Time(sec=100))", "'/odom', Odometry, odometry()"),
        ("stamp_clock",),
    ),
    Drill(
        "d50",
        "stamped once and for all",
        sends("'/tf', TFMessage, TFMessage(transforms=[tf('odom', 'base_link', stamp=now(-600))])"),
        ("stamp_past",),
    ),
    Drill(
        "d51",
        "an encoding in capitals",
        sends(
            "'/image', Image, Image(header=header('laser'), width=8, height=4, encoding='RGB8', step=24, data=bytes(96))"
        ),
        ("image_encoding",),
    ),
    Drill(
        "d52",
        "an array whose layout says another size",
        sends(
            "'/table', Float32MultiArray, Float32MultiArray("
            "layout=MultiArrayLayout(dim=[MultiArrayDimension(label='row', size=3, stride=3)]), data=[1.0, 2.0])"
        ),
        ("data_size",),
    ),
)

"""What the world publishes about the robot: /odom, /tf, /joint_states, /scan, /line_sensor, /ground_truth."""

from __future__ import annotations

import math
import re
from typing import TYPE_CHECKING

from geometry_msgs.msg import TransformStamped
from nav_msgs.msg import Odometry
from sensor_msgs.msg import JointState, LaserScan
from std_msgs.msg import Float32MultiArray, MultiArrayDimension, MultiArrayLayout
from tf2_msgs.msg import TFMessage

from day6_core.ros.programs.day6_world._simulation import STEP, Place, Simulation
from day6_core.ros.programs.day6_world.model import Scan
from day6_urdf.topview.plan import plan_top
from rclpy.qos import QoSProfile

if TYPE_CHECKING:
    from builtin_interfaces.msg import Time

    from day6_urdf.model import Robot
    from rclpy.node import Node
    from rclpy.publisher import Publisher

RAYS = 180
FIRST_RAY, RAY_STEP = -math.pi, 2 * math.pi / RAYS
SHORTEST, LONGEST = 0.05, 8.0
SCAN_STEPS = 5
"""Steps between two scans: ten a second."""

LINE_SENSORS = (0.06, 0.03, 0.0, -0.03, -0.06)
"""Metres to the left of the middle, at the front of the robot: the order of the values of /line_sensor."""

_LIDAR = re.compile("laser|lidar|scan", re.IGNORECASE)


class Sensors:
    """The publishers. `mount` sets the robot, `publish` is called after every step."""

    def __init__(self, node: Node, simulation: Simulation, *, publishes_joints: bool) -> None:
        self._node = node
        self._simulation = simulation
        self._noise = float(node.declare_parameter("lidar_noise", 0.01).value)
        self._wanted_link = str(node.declare_parameter("lidar_link", "").value)
        self._odom = node.create_publisher(Odometry, "odom", 10)
        self._truth = node.create_publisher(Odometry, "ground_truth", 10)
        self._tf = node.create_publisher(TFMessage, "/tf", QoSProfile(depth=100))
        self._publishes_joints = publishes_joints
        self._joints: Publisher[JointState] | None = None
        self._scan = node.create_publisher(LaserScan, "scan", 10)
        self._line = node.create_publisher(Float32MultiArray, "line_sensor", 10)
        self._root = ""
        self._lidar = ""
        self._front = 0.0
        self.line: tuple[float, ...] = ()
        self.newest: Scan | None = None

    def mount(self, robot: Robot) -> None:
        """Put the sensors on a robot: the lidar on the link of its name, or on the root link where there is none."""
        self._root = robot.root
        names = [link.name for link in robot.links]
        named = [name for name in names if _LIDAR.search(name)]
        self._lidar = self._wanted_link if self._wanted_link in names else named[0] if named else robot.root
        self._front = plan_top(robot).bounds[2]
        if self._publishes_joints and self._joints is None:
            self._joints = self._node.create_publisher(JointState, "joint_states", 10)
        self.newest = None

    def unmount(self) -> None:
        """Remove the robot: this node must no longer look like a publisher of joint states."""
        if self._joints is not None:
            self._node.destroy_publisher(self._joints)
            self._joints = None
        self.line, self.newest = (), None

    def publish(self, stamp: Time, wants_rays: bool) -> None:
        """Publish the state after a step; a scan only when it is due and something reads it."""
        simulation = self._simulation
        self._publish_odometry(stamp)
        if self._joints is not None:
            state = JointState(
                name=list(simulation.angles),
                position=list(simulation.angles.values()),
                velocity=list(simulation.speeds.values()),
            )
            state.header.stamp = stamp
            self._joints.publish(state)
        places = [(self._front, y) for y in LINE_SENSORS]
        self.line = tuple(simulation.line_darkness(places)) if simulation.scenery.line else ()
        if self.line and self._line.get_subscription_count():
            size = len(self.line)
            layout = MultiArrayLayout(dim=[MultiArrayDimension(label="left_to_right", size=size, stride=size)])
            self._line.publish(Float32MultiArray(layout=layout, data=list(self.line)))
        heard = self._scan.get_subscription_count() > 0
        if simulation.steps % SCAN_STEPS == 0 and (heard or wants_rays):
            self._measure(stamp, heard)

    def _publish_odometry(self, stamp: Time) -> None:
        simulation = self._simulation
        odom = self._odometry(stamp, "odom", simulation.odometry, simulation.wheel_velocity)
        self._odom.publish(odom)
        if self._truth.get_subscription_count():
            self._truth.publish(self._odometry(stamp, "world", simulation.pose, simulation.velocity))
        transform = TransformStamped(header=odom.header, child_frame_id=self._root)
        place = odom.pose.pose
        transform.transform.translation.x = place.position.x
        transform.transform.translation.y = place.position.y
        transform.transform.rotation = place.orientation
        self._tf.publish(TFMessage(transforms=[transform]))

    def _odometry(self, stamp: Time, frame: str, pose: Place, velocity: tuple[float, float]) -> Odometry:
        message = Odometry(child_frame_id=self._root)
        message.header.stamp, message.header.frame_id = stamp, frame
        x, y, yaw = pose
        place = message.pose.pose
        place.position.x, place.position.y = x, y
        place.orientation.z, place.orientation.w = math.sin(yaw / 2), math.cos(yaw / 2)
        message.twist.twist.linear.x, message.twist.twist.angular.z = velocity
        return message

    def _measure(self, stamp: Time, heard: bool) -> None:
        simulation = self._simulation
        ranges = simulation.scan(self._lidar, FIRST_RAY, RAY_STEP, RAYS, LONGEST, self._noise)
        x, y, yaw = simulation.mounted_at(self._lidar)
        self.newest = Scan(x, y, yaw + FIRST_RAY, RAY_STEP, tuple(ranges))
        if not heard:
            return
        message = LaserScan(
            angle_min=FIRST_RAY,
            angle_max=FIRST_RAY + (RAYS - 1) * RAY_STEP,
            angle_increment=RAY_STEP,
            scan_time=SCAN_STEPS * STEP,
            range_min=SHORTEST,
            range_max=LONGEST,
            ranges=[value if value >= SHORTEST else 0.0 for value in ranges],
        )
        message.header.stamp, message.header.frame_id = stamp, self._lidar
        self._scan.publish(message)

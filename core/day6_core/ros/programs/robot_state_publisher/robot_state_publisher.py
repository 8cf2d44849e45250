"""robot_state_publisher as in Jazzy (3.3.3): /robot_description, /tf and /tf_static from a URDF and /joint_states.

It reads the description with our own parser (`day6_urdf.check`), not with yourdfpy: it must be up at once, must
print urdfdom's messages in any case, and needs neither meshes nor numpy; a test holds the two readers' robots equal. A
long description is read in a thread at the start. A description that is set while it runs is read within the parameter
callback, as in the original, because that callback has to answer; its size is bounded (`check.MAX_BYTES`).
"""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from geometry_msgs.msg import Quaternion, Transform, TransformStamped, Vector3
from rcl_interfaces.msg import ParameterEvent, SetParametersResult
from sensor_msgs.msg import JointState
from std_msgs.msg import Header, String
from tf2_msgs.msg import TFMessage

from day6_core.ros.differences import value
from day6_core.ros.programs.rclcpp import STOPPED, CppException, create_node, log_interrupt
from day6_core.ros.programs.rclcpp.qos import DYNAMIC_TF, STATIC_TF
from day6_core.ros.programs.robot_state_publisher._segments import FrameTransform, Segments, StaticFrames, Throttle
from day6_core.ros.robot_check import check_robot
from day6_core.session.threads import in_thread
from day6_urdf.check import MAX_BYTES, read_description, too_large
from day6_urdf.model import Robot
from rclpy.qos import (
    DurabilityPolicy,
    QoSProfile,
    ReliabilityPolicy,
    qos_profile_parameter_events,
)
from rclpy.qos_overriding_options import QoSOverridingOptions
from rclpy.utilities import remove_ros_args

if TYPE_CHECKING:
    from collections.abc import Callable

    from builtin_interfaces.msg import Time

    from day6_core.session.session import Session
    from day6_urdf.report import Report
    from rclpy.node import Node
    from rclpy.parameter import Parameter

SHORT = 100_000
"""Characters of a description that may be read (in some hundredths of a second) without a thread."""


class DescriptionRefused(Exception):
    """A description that cannot be used, in robot_state_publisher's words."""


class RobotStatePublisher:
    """The node; it does nothing before `start` or `wait`. Raises CppException for parameters that crash the original.

    `listens`: whether the description comes from the topic on which it is published otherwise.
    """

    def __init__(self, node: Node, print_error: Callable[[str], None], *, listens: bool = False) -> None:
        self._node = node
        self._print_error = print_error
        self._segments: Segments | None = None
        self._throttle = Throttle()
        self._static = StaticFrames()
        frequency = node.declare_parameter("publish_frequency", 20.0).value
        if not 0.0 <= frequency <= 1000.0:
            raise CppException("publish_frequency must be between 0 and 1000")
        node.declare_parameter("frame_prefix", "")
        node.declare_parameter("ignore_timestamp", False)
        # These three and the subscription have the QoS, and the `qos_overrides.…` parameters, of tf2_ros and the original.
        self._tf = node.create_publisher(TFMessage, "/tf", QoSProfile(depth=100), qos_overriding_options=DYNAMIC_TF)
        self._tf_static = node.create_publisher(TFMessage, "/tf_static", _latched(), qos_overriding_options=STATIC_TF)
        self._description = None if listens else node.create_publisher(String, "robot_description", _latched())

    def start(self, description: str, report: Report) -> None:
        """Publish the description and the fixed transforms, then listen. Raises CppException."""
        try:
            robot = self._accept(report)
        except DescriptionRefused as error:
            raise CppException(str(error)) from error
        self._setup(description, robot)
        self._listen()
        self._publish_fixed()
        self._node.add_on_set_parameters_callback(self._check_parameters)
        events_qos = qos_profile_parameter_events
        self._node.create_subscription(ParameterEvent, "/parameter_events", self._parameters_changed, events_qos)

    def wait(self) -> None:
        """Wait for descriptions on the topic, instead of `start`."""
        self._node.create_subscription(String, "robot_description", lambda said: self._renew(said.data), _latched())
        self._listen()
        self._node.add_on_set_parameters_callback(self._check_parameters)

    def _listen(self) -> None:
        node = self._node
        node.create_subscription(
            JointState,
            "joint_states",
            self._joint_states,
            QoSProfile(depth=5, reliability=ReliabilityPolicy.BEST_EFFORT),  # rclcpp::SensorDataQoS
            qos_overriding_options=QoSOverridingOptions.with_default_policies(),
        )

    def _accept(self, report: Report) -> Robot:
        """Print what the parsers print and return the robot. Raises Refused."""
        if report.diagnostics:
            self._print_error(report.text.rstrip("\n"))
        if report.robot is None:
            self._print_error("Failed to parse robot description using: urdf_xml_parser/URDFXMLParser")
            raise DescriptionRefused("Unable to initialize urdf::model from robot description")
        loop = report.robot.loop
        if loop:
            # The original recurses until its stack overflows; here the error is reported instead.
            self._print_error(f"The links form a loop: {' -> '.join(loop)}")
            raise DescriptionRefused("Failed to extract kdl tree from robot description")
        self._warn_as_kdl(report.robot)
        return report.robot

    def _warn_as_kdl(self, robot: Robot) -> None:
        texts = []
        if robot.link(robot.root).inertial is not None:
            texts.append(
                f"The root link {robot.root} has an inertia specified in the URDF, but KDL does not support a root link"
                " with an inertia.  As a workaround, you can add an extra dummy link to your URDF."
            )
        for joint in robot.tree():
            if joint.type in ("floating", "planar"):
                texts.append(f"Converting unknown joint type of joint '{joint.name}' into a fixed joint")
        seconds, nanoseconds = divmod(self._now_ns(), 1_000_000_000)
        for text in texts:
            self._print_error(f"[WARN] [{seconds}.{nanoseconds:09d}] [kdl_parser]: {text}")

    def _setup(self, description: str, robot: Robot) -> None:
        self._segments = Segments(robot)
        if self._description is not None:
            self._description.publish(String(data=description))
        log = self._node.get_logger()
        if value("robot_state_publisher.names_segments"):
            for name in sorted(link.name for link in robot.links):
                log.info(f"got segment {name}")
        else:
            log.info("Robot initialized")

    def _publish_fixed(self) -> None:
        assert self._segments is not None
        stamp = self._node.get_clock().now().to_msg()
        messages = [self._stamped(transform, stamp) for transform in self._segments.fixed()]
        merged = self._static.merged({message.child_frame_id: message for message in messages})
        self._tf_static.publish(TFMessage(transforms=merged))

    def _joint_states(self, state: JointState) -> None:
        if self._segments is None:
            return  # no description has come yet
        names, positions = state.name, state.position
        if len(names) != len(positions):
            if len(positions) == 0:
                self._node.get_logger().warning(
                    f'Robot state publisher ignored a JointState message about joint(s) "{names[0]}"(,...)'
                    " whose position member was empty."
                )
            else:
                self._node.get_logger().error("Robot state publisher ignored an invalid JointState message")
            return
        now_ns = self._now_ns()
        if self._throttle.went_back(now_ns):
            self._node.get_logger().warning("Moved backwards in time, re-publishing joint transforms!")
        stamp_ns = state.header.stamp.sec * 1_000_000_000 + state.header.stamp.nanosec
        frequency = self._node.get_parameter("publish_frequency").value
        due = self._throttle.admits(names, stamp_ns, now_ns, frequency)
        if due or self._node.get_parameter("ignore_timestamp").value:
            transforms = self._segments.moving(names, positions)
            # Also when there is none: the original sends an empty message for joints it does not know.
            self._tf.publish(TFMessage(transforms=[self._stamped(item, state.header.stamp) for item in transforms]))
            self._throttle.note(names, stamp_ns)

    def _stamped(self, transform: FrameTransform, stamp: Time) -> TransformStamped:
        prefix = self._node.get_parameter("frame_prefix").value
        x, y, z = transform.translation
        qx, qy, qz, qw = transform.rotation
        return TransformStamped(
            header=Header(stamp=stamp, frame_id=prefix + transform.parent),
            child_frame_id=prefix + transform.child,
            transform=Transform(translation=Vector3(x=x, y=y, z=z), rotation=Quaternion(x=qx, y=qy, z=qz, w=qw)),
        )

    def _check_parameters(self, parameters: list[Parameter[Any]]) -> SetParametersResult:
        for parameter in parameters:
            if parameter.name == "robot_description":
                if not parameter.value:
                    return SetParametersResult(successful=False, reason="Empty URDF is not allowed")
                try:
                    self._accept(check_robot(parameter.value))
                except DescriptionRefused as error:
                    self._node.get_logger().warning(str(error))
                    return SetParametersResult(successful=False, reason=str(error))
            elif parameter.name == "publish_frequency" and not 0.0 <= parameter.value <= 1000.0:
                return SetParametersResult(successful=False, reason="publish_frequency must be between 0.0 and 1000.0")
        return SetParametersResult(successful=True)

    def _parameters_changed(self, event: ParameterEvent) -> None:
        if event.node != self._node.get_fully_qualified_name():
            return
        for parameter in event.changed_parameters:
            if parameter.name == "robot_description":
                self._renew(parameter.value.string_value)

    def _renew(self, description: str) -> None:
        try:
            robot = self._accept(check_robot(description))
        except DescriptionRefused as error:
            self._node.get_logger().warning(f"Failed to parse new URDF: {error}")
        else:
            self._setup(description, robot)
            self._publish_fixed()

    def _now_ns(self) -> int:
        return int(self._node.get_clock().now().nanoseconds)


def _latched() -> QoSProfile:
    return QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)


def _listens(node: Node) -> bool:
    return value("robot_state_publisher.listens") and bool(
        node.declare_parameter("use_robot_description_topic", False).value
    )


def _description(session: Session, node: Node) -> tuple[str, int]:
    """Return the description, from the parameter or the file on the command line, and its size. Raises CppException."""
    text = node.declare_parameter("robot_description", "").value
    if text:
        return text, len(text)
    try:
        text, size = _description_in_file(session, node)
    except CppException as error:
        node.get_logger().fatal(str(error))
        raise
    if size <= MAX_BYTES:
        from rclpy.parameter import Parameter

        node.set_parameters([Parameter("robot_description", Parameter.Type.STRING, text)])
    return text, size


def _description_in_file(session: Session, node: Node) -> tuple[str, int]:
    arguments = remove_ros_args(args=session.argv)
    if len(arguments) < 2:
        raise CppException("robot_description parameter must not be empty")
    node.get_logger().warning(
        "No robot_description parameter, but command-line argument available."
        "  Assuming argument is name of URDF file."
        "  This backwards compatibility fallback will be removed in the future."
    )
    try:
        return read_description(session.cwd / arguments[1])
    except OSError as error:
        what = f"Failed to open URDF file: {arguments[1]}: {error.strerror}"
        raise CppException(what, "std::system_error") from error


async def _report(text: str, size: int) -> Report:
    if size > MAX_BYTES:
        return too_large(size)
    return check_robot(text) if size <= SHORT else await in_thread(lambda: check_robot(text))


async def main(session: Session) -> int:
    node = create_node(session, "robot_state_publisher")
    if _listens(node):
        RobotStatePublisher(node, session.print_error, listens=True).wait()
    else:
        description, size = _description(session, node)
        publisher = RobotStatePublisher(node, session.print_error)
        publisher.start(description, await _report(description, size))
    try:
        await session.spin(node)
    except STOPPED:
        log_interrupt(session)
    return 0

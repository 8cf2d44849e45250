"""The world as a ROS node: commands in, sensors out, its clock, and its services."""

from __future__ import annotations

import math
import time
from collections import deque
from collections.abc import Callable
from dataclasses import replace
from typing import TYPE_CHECKING, Any

from builtin_interfaces.msg import Time
from day6_world.srv import SetSpeed, Step
from geometry_msgs.msg import Twist, TwistStamped
from rosgraph_msgs.msg import Clock
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from std_srvs.srv import Empty, SetBool

from day6_core.ros.programs.day6_world._admission import AdmissionStatus, refusals, status, warnings
from day6_core.ros.programs.day6_world._drive import find_drive
from day6_core.ros.programs.day6_world._sensors import Sensors
from day6_core.ros.programs.day6_world._simulation import LostGround, Simulation
from day6_core.ros.programs.day6_world.model import SPEEDS, WorldModel, WorldSnapshot
from day6_core.ros.programs.day6_world.scenery import Scenery
from day6_core.ros.programs.real_time_factor import RealTimeFactor
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.task import Future

if TYPE_CHECKING:
    from day6_urdf.model import Robot
    from rclpy.node import Node

LATCHED = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
MOST_STEPS = 100_000
"""In one call of the service `step`."""

STEPPING_SECONDS = 0.008
"""How long a tick works on such calls: every program of this machine waits for it."""

BUMP_STEPS = 50
"""How long a bump is shown: a line that appears and disappears many times a second cannot be read."""

ALIGN_NS = 1_000_000_000
"""After this much silence a source of wheel angles starts again: its first angle means the wheel's current one."""


class WorldNode:
    """The node `world`. `tick()` is one period of the machine's clock; how many steps that is depends on the speed.

    `timer_ns` is the time that timers run by, `wall_ns` measures (nanoseconds).
    """

    def __init__(self, node: Node, scenery: Scenery, timer_ns: Callable[[], int], wall_ns: Callable[[], int]) -> None:
        self._node = node
        self._timer_ns = timer_ns
        self._wall_ns = wall_ns
        self._pace = RealTimeFactor()
        self.model = WorldModel()
        self.waiting_description: str | None = None
        self.on_description: Callable[[], object] | None = None
        self._description: str | None = None
        parameter = node.declare_parameter
        self._simulation = Simulation(scenery, int(parameter("seed", 0).value))
        start = [float(parameter(name, value).value) for name, value in zip("xy", scenery.start, strict=False)]
        self._start = (start[0], start[1], float(parameter("yaw", scenery.start[2]).value))
        self._stamped = bool(parameter("stamped", False).value)
        self._follows = bool(parameter("follow_joint_states", False).value)
        self._sides = tuple(list(parameter(name, [""]).value) for name in ("left_wheels", "right_wheels"))
        self._clock = bool(parameter("publish_clock", True).value)
        parameter("speed", 1.0)
        self._paused = False
        self._ordered: deque[tuple[int, Future[None]]] = deque()
        """For each call of `step` that isn't over: how many steps are left, and who waits for the last one."""
        self._due = 0.0
        self._admission: tuple[AdmissionStatus, ...] = ()
        self._remarks: tuple[AdmissionStatus, ...] = ()
        self._sideways = False
        self._bumped_until = -1
        self._aligned: dict[str, tuple[float, int]] = {}
        self._snapshot = WorldSnapshot(scenery=scenery)
        self._sensors = Sensors(node, self._simulation, publishes_joints=not self._follows)
        self._clock_publisher = node.create_publisher(Clock, "/clock", 10) if self._clock else None
        self._listen()
        self._serve()
        self.look_around()

    def _listen(self) -> None:
        node = self._node
        if self._stamped:
            node.create_subscription(TwistStamped, "cmd_vel", lambda message: self._drive(message.twist), 10)
        else:
            node.create_subscription(Twist, "cmd_vel", self._drive, 10)
        node.create_subscription(JointState, "joint_commands", self._hear_joints, 10)
        if self._follows:
            node.create_subscription(JointState, "joint_states", self._hear_joints, 10)
        node.create_subscription(String, "robot_description", lambda message: self.hear_text(message.data), LATCHED)

    def _serve(self) -> None:
        node = self._node
        node.create_service(SetBool, "~/pause", self._on_pause)
        node.create_service(Step, "~/step", self._on_step)
        node.create_service(SetSpeed, "~/set_speed", self._on_speed)
        node.create_service(Empty, "~/reset", self._on_reset)

    # -- the robot -----------------------------------------------------------------------------------------------------

    def hear_text(self, text: str) -> None:
        """Accept a robot description; it is read elsewhere, and `admit` is called with the result."""
        if text != self._description:
            self._description = self.waiting_description = text
            if self.on_description is not None:
                self.on_description()

    def admit(self, robot: Robot | None, problem: str) -> None:
        """Let a robot in, or report why it may not enter; the previous robot is removed.

        `problem` says why there is none, or what the parser left out of an accepted one.
        """
        self.waiting_description = None
        self._simulation.robot = None
        name = robot.name if robot is not None else "robot"
        lines: list[AdmissionStatus] = []
        if robot is None:
            lines = [status("error", "world.bad_description", text=problem)]
        else:
            left, right = ([name for name in side if name] for side in self._sides)
            drive = None
            reasons = []
            try:
                drive = find_drive(robot, left, right)
            except (ValueError, OverflowError):  # sizes that are no numbers
                reasons = refusals(robot, drive)
            reasons = reasons or refusals(robot, drive)
            if not reasons and drive is not None:
                try:
                    self._simulation.enter(robot, drive, self._start)
                    self._sensors.mount(robot)
                    self.model.trail.clear()
                    lines = warnings(robot, drive)
                except LostGround:
                    reasons = [status("error", "world.stands_in_wall", x=self._start[0], y=self._start[1])]
            if problem:
                lines.append(status("warning", "world.left_away", text=problem))
            if reasons:
                lines = [status("error", "world.refused", robot=name), *reasons]
        if self._simulation.robot is None:
            self._sensors.unmount()
        self._admission = tuple(lines)
        self._log(name)
        self._sideways = False
        self._aligned.clear()
        self.look_around()

    def _log(self, name: str) -> None:
        logger = self._node.get_logger()
        for line in self._admission:
            # Two lines: rclpy refuses another severity from the same one.
            if line.level == "error":
                logger.error(line.text)
            else:
                logger.warning(line.text)
        if self._simulation.robot is not None:
            x, y, yaw = self._simulation.pose
            logger.info(f"{name} stands at x={x:.2f}, y={y:.2f}, yaw={yaw:.2f}")

    # -- commands ------------------------------------------------------------------------------------------------------

    def _drive(self, twist: Any) -> None:
        linear, angular = twist.linear.x, twist.angular.z
        if math.isfinite(linear) and math.isfinite(angular):
            self._simulation.order_velocity(linear, angular)
            self._sideways = abs(twist.linear.y) > 0

    def _hear_joints(self, message: JointState) -> None:
        now_ns = self._timer_ns()
        for index, name in enumerate(message.name):
            angle = message.position[index] if index < len(message.position) else math.nan
            speed = message.velocity[index] if index < len(message.velocity) else math.nan
            if math.isfinite(angle):
                self._simulation.order_angle(name, self._align(name, angle, now_ns))
            elif math.isfinite(speed):
                self._simulation.order_speed(name, speed)

    def _align(self, joint: str, angle: float, now_ns: int) -> float:
        """Return the angle for our wheel: the first one a source says is where the wheel is, so nothing jumps."""
        offset, heard_ns = self._aligned.get(joint, (math.nan, 0))
        if math.isnan(offset) or now_ns - heard_ns > ALIGN_NS or now_ns < heard_ns:
            offset = self._simulation.angles.get(joint, 0.0) - angle
        self._aligned[joint] = (offset, now_ns)
        return angle + offset

    # -- time ----------------------------------------------------------------------------------------------------------

    @property
    def speed(self) -> float:
        value = self._node.get_parameter("speed").value
        return min(max(float(value), 0.0), SPEEDS[-1]) if isinstance(value, (int, float)) else 1.0

    def tick(self) -> None:
        """Run the steps that are due, then show the world."""
        for request in self.model.take_requests():
            self._handle(request)
        if not self._paused:
            self._due += self.speed
            while self._due >= 1 - 1e-9:
                self._due -= 1
                self._step()
            self._pace.note(self._simulation.time_ns, self._wall_ns())
        else:
            self._pace.forget()
        self._take_ordered()
        self._show()

    def _take_ordered(self) -> None:
        """Run steps that calls of the service asked for, as many as there is time for."""
        end = time.perf_counter() + STEPPING_SECONDS
        while self._ordered and time.perf_counter() < end:
            self._step()
            left, over = self._ordered.popleft()
            if left > 1:
                self._ordered.appendleft((left - 1, over))
            else:
                over.set_result(None)

    def _step(self) -> None:
        self._simulation.step()
        stamp = self._now()
        if self._clock_publisher is not None:
            self._clock_publisher.publish(Clock(clock=stamp))
        if self._simulation.robot is not None:
            self._sensors.publish(stamp, self.model.wants_rays)
            x, y, _ = self._simulation.pose
            self.model.trail.add(x, y)

    def _now(self) -> Time:
        if not self._clock:
            return self._node.get_clock().now().to_msg()
        seconds, nanoseconds = divmod(self._simulation.time_ns, 1_000_000_000)
        return Time(sec=seconds, nanosec=nanoseconds)

    def _handle(self, request: str) -> None:
        if request == "pause":
            self._paused = not self._paused
        elif request == "step":
            self._paused = True
            self._step()
        elif request in ("faster", "slower"):
            near = min(range(len(SPEEDS)), key=lambda index: abs(SPEEDS[index] - self.speed))
            self._set_speed(SPEEDS[min(max(near + (1 if request == "faster" else -1), 0), len(SPEEDS) - 1)])
        elif request == "reset":
            self._reset()
        elif request == "clear":
            self.model.trail.clear()

    def _set_speed(self, speed: float) -> None:
        from rclpy.parameter import Parameter

        self._node.set_parameters([Parameter("speed", value=float(speed))])

    def _reset(self) -> None:
        self._simulation.reset()
        self._bumped_until = -1
        self.model.trail.clear()
        self._aligned.clear()

    def _on_pause(self, request: Any, response: Any) -> Any:
        self._paused = request.data
        response.success, response.message = True, "paused" if self._paused else "running"
        return response

    async def _on_step(self, request: Any, response: Any) -> Any:
        self._paused = True
        over: Future[None] = Future(executor=self._node.executor)
        self._ordered.append((min(max(request.steps, 1), MOST_STEPS), over))
        await over
        response.clock = self._now()
        return response

    def _on_speed(self, request: Any, response: Any) -> Any:
        response.success = 0 < request.factor <= SPEEDS[-1]
        if response.success:
            self._set_speed(request.factor)
        else:
            response.message = f"the factor has to be greater than 0 and at most {SPEEDS[-1]:g}"
        return response

    def _on_reset(self, _: Any, response: Any) -> Any:
        self._reset()
        return response

    # -- what can be seen ----------------------------------------------------------------------------------------------

    def look_around(self) -> None:
        """Find the publishers that drive the robot or interfere; called a few times a second."""
        lines = list(self._admission)
        if self._simulation.robot is None:
            if not lines:
                lines = [status("warning", "world.waiting_for_robot")]
        else:
            lines += self._traffic()
        self._remarks = tuple(lines)

    def _traffic(self) -> list[AdmissionStatus]:
        lines = []
        node = self._node
        topic, wanted = node.resolve_topic_name("cmd_vel"), "TwistStamped" if self._stamped else "Twist"
        drivers = node.get_publishers_info_by_topic(topic)
        for kind in sorted({info.topic_type for info in drivers} - {f"geometry_msgs/msg/{wanted}"}):
            stamped = str(not self._stamped).lower()
            lines.append(status("error", "world.wrong_type", topic=topic, type=kind, wanted=wanted, stamped=stamped))
        states = node.resolve_topic_name("joint_states")
        names = [info.node_name for info in node.get_publishers_info_by_topic(states)]
        orders = node.get_publishers_info_by_topic(node.resolve_topic_name("joint_commands"))
        others = sorted(name for name in names if name != node.get_name())
        if others and not self._follows:
            lines.append(status("warning", "world.two_joint_states", nodes=", ".join(others), topic=states))
        elif not drivers and not orders and not (others and self._follows):
            moves = any(self._simulation.wheel_velocity)
            lines.append(status("info", "world.keeps_going" if moves else "world.nobody_drives", topic=topic))
        return lines

    def _show(self) -> None:
        simulation, old = self._simulation, self._snapshot
        lines = list(self._remarks)
        if simulation.robot is not None:
            if simulation.bumped:
                self._bumped_until = simulation.steps + BUMP_STEPS
            lines += [status("warning", "world.bumped")] if simulation.steps < self._bumped_until else []
            lines += [status("info", "world.sideways")] if self._sideways else []
        self._snapshot = new = replace(
            old,
            seconds=simulation.time_ns / 1e9,
            robot=simulation.robot,
            pose=simulation.pose,
            velocity=simulation.velocity,
            angles=dict(simulation.angles),
            bumped=simulation.bumped,
            line=self._sensors.line,
            scan=self._sensors.newest if self.model.wants_rays else None,
            status=tuple(lines),
            paused=self._paused,
            speed=self.speed,
            real_time_factor=self._pace.value,
        )
        if new != old:
            self._snapshot = replace(new, version=old.version + 1)
            self.model.show(self._snapshot)

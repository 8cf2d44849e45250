"""2D Pose Estimate and 2D Goal Pose: a place on the ground and a direction (rviz_default_plugins/tools/pose)."""

from __future__ import annotations

import math
from typing import Any

from day6_core.ros.programs.rviz2.model.key_steps import FINE, FINE_TURN, TURN, step_at
from day6_core.ros.programs.rviz2.model.properties import floats, number_text
from day6_core.ros.programs.rviz2.model.scene import Colour, Lines, Scene
from day6_core.ros.programs.rviz2.model.tools.tool import GROUND, Pointer, Tool, ToolTopic
from day6_urdf.kinematics import Transform
from day6_urdf.model import Quaternion, Vector

GREEN: Colour = (0.0, 1.0, 0.0, 1.0)
SHAFT, SHAFT_DIAMETER, HEAD, HEAD_DIAMETER = 2.0, 0.2, 0.5, 0.35
"""Of the arrow (pose_tool.cpp)."""

CROSS = 3
"""Arms of the cursor, in steps of the arrow keys."""


class PoseTool(Tool):
    """Press where, drag whither, let go. With keys: arrows and Enter for the place, arrows and Enter for the direction."""

    arrows = GROUND
    message_type = ""
    default_topic = ""
    designation = ""
    """What the log calls the pose."""

    def build(self) -> None:
        self.topic = ToolTopic(self, self.message_type, self.default_topic)
        self._place: Vector | None = None
        """Where the pose is, once that is settled."""
        self._angle = 0.0
        """Radians; a click that is not dragged takes that of the pose before, as the original's does."""
        self._seen = False
        """Whether the arrow is shown."""
        self._cursor: Vector | None = None
        """Where the keys are on the ground."""
        self._step = 1.0

    def open(self) -> None:
        self.topic.open()

    def close(self) -> None:
        self.topic.close()

    @property
    def status(self) -> str:
        text = "Click and drag mouse to set position/orientation."
        if (place := self._place or self._cursor) is None:
            return text
        where = f"[{number_text(place[0])},{number_text(place[1])}]"
        return f"{text} {where} {math.degrees(self._angle):.0f}°" if self._place is not None else f"{text} {where}"

    @property
    def placed(self) -> bool:
        """Whether the place is settled, so that the direction is next."""
        return self._place is not None

    def activate(self) -> None:
        self._place = self._cursor = None
        self._seen = False

    deactivate = activate

    # -- the mouse -----------------------------------------------------------------------------------------------------

    def press(self, pointer: Pointer) -> bool:
        self._cursor = None
        self._place = pointer.ground
        return False

    def drag(self, pointer: Pointer) -> bool:
        place, ground = self._place, pointer.ground
        if place is not None and ground is not None:
            self._angle = math.atan2(ground[1] - place[1], ground[0] - place[0])
            self._seen = True
        return False

    def release(self, pointer: Pointer) -> bool:
        return self._finish()

    # -- keys ----------------------------------------------------------------------------------------------------------

    def arrow_key(self, right: int, up: int, *, fine: bool) -> bool:
        if self._place is not None:
            self._angle = math.remainder(self._angle - right * (FINE_TURN if fine else TURN), math.tau)
        elif self._cursor is None:
            self._to_middle()
        else:
            step = self._step * FINE if fine else self._step
            ahead = self._ahead()
            x = self._cursor[0] + step * (up * ahead[0] + right * ahead[1])
            y = self._cursor[1] + step * (up * ahead[1] - right * ahead[0])
            self._cursor = _rounded(x, step), _rounded(y, step), 0.0
        return False

    def _to_middle(self) -> None:
        """Begin in the middle of the view, with steps that fit its distance."""
        camera = self.rviz.view.camera()
        middle = Pointer(camera.position, camera.forward).ground or (0.0, 0.0, 0.0)
        self._step = step_at(camera, middle)
        self._cursor = _rounded(middle[0], self._step), _rounded(middle[1], self._step), 0.0

    def _ahead(self) -> tuple[int, int]:
        """The axis of the ground that lies nearest to the view's direction: so coordinates stay round numbers."""
        camera = self.rviz.view.camera()
        # What is up in the picture, for a camera that looks straight down.
        x, y = (camera.forward[axis] + camera.up[axis] for axis in (0, 1))
        return (1 if x > 0 else -1, 0) if abs(x) >= abs(y) else (0, 1 if y > 0 else -1)

    def enter_key(self) -> bool:
        if self._place is not None:
            return self._finish()
        if self._cursor is None:
            self._to_middle()
        else:
            self._place, self._seen = self._cursor, True
        return False

    # -- what comes of it ----------------------------------------------------------------------------------------------

    def _finish(self) -> bool:
        if self._place is None:
            return False
        x, y, _ = self._place
        message = self.topic.message()
        self.fill(message, x, y, about_z(self._angle))
        self.topic.publish(message)
        self._log(x, y)
        return True

    def fill(self, message: Any, x: float, y: float, turn: Quaternion) -> None:
        """Put the pose into the message."""
        raise NotImplementedError

    def _log(self, x: float, y: float) -> None:
        position = ", ".join(number_text(part) for part in (x, y, 0.0))
        turn = ", ".join(number_text(part) for part in about_z(self._angle))
        self.rviz.log_info(
            f"Setting {self.designation} pose: Frame:{self.rviz.fixed_frame}, Position({position}), "
            f"Orientation({turn}) = Angle: {number_text(self._angle)}"
        )

    def draw(self, scene: Scene) -> None:
        if self._place is not None and self._seen:
            pose = Transform(self._place, about_z(self._angle))
            scene.arrow(pose, SHAFT, SHAFT_DIAMETER, HEAD, HEAD_DIAMETER, GREEN)
        elif self._cursor is not None:
            x, y, _ = self._cursor
            arm = CROSS * self._step
            ends = [(x - arm, y, 0.0), (x + arm, y, 0.0), (x, y - arm, 0.0), (x, y + arm, 0.0)]
            scene.lines.append(Lines(ends, [GREEN]))


class SetInitialPose(PoseTool):
    """Says where the robot is."""

    type, title, short, key = "SetInitialPose", "2D Pose Estimate", "Estimate", "p"
    message_type = "geometry_msgs/msg/PoseWithCovarianceStamped"
    default_topic = "initialpose"
    designation = "estimate"

    def build(self) -> None:
        super().build()
        self.variances = [
            (index, self.add(floats(f"Covariance {name}", value)))
            for index, name, value in ((0, "x", 0.25), (7, "y", 0.25), (35, "yaw", (math.pi / 12) ** 2))
        ]

    def fill(self, message: Any, x: float, y: float, turn: Quaternion) -> None:
        _set_pose(message.pose.pose, x, y, turn)
        for index, variance in self.variances:
            message.pose.covariance[index] = variance.value


class SetGoal(PoseTool):
    """Says where the robot shall go."""

    type, title, short, key = "SetGoal", "2D Goal Pose", "Goal", "g"
    message_type = "geometry_msgs/msg/PoseStamped"
    default_topic = "goal_pose"
    designation = "goal"

    def fill(self, message: Any, x: float, y: float, turn: Quaternion) -> None:
        _set_pose(message.pose, x, y, turn)


def about_z(angle: float) -> Quaternion:
    """A rotation by radians about the z axis."""
    return 0.0, 0.0, math.sin(angle / 2), math.cos(angle / 2)


def _rounded(metres: float, step: float) -> float:
    """The nearest multiple of a step, without the noise of the last digits."""
    return round(round(metres / step) * step, 9)


def _set_pose(pose: Any, x: float, y: float, turn: Quaternion) -> None:
    pose.position.x, pose.position.y = x, y
    pose.orientation.z, pose.orientation.w = turn[2:]

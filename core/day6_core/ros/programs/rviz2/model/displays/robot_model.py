"""RobotModel (rviz_default_plugins/displays/robot_model and …/robot): a robot by its description and by /tf."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.robot_links import RobotLinks
from day6_core.ros.programs.rviz2.model.properties import (
    BOOL,
    ENUM,
    FILE,
    GROUP,
    TEXT,
    Property,
    floats,
    pose_lines,
)
from day6_core.ros.programs.rviz2.model.robot_parts import RobotPart, RobotParts
from day6_core.ros.programs.rviz2.model.scene import Colour, Scene, Shape, Triangles
from day6_core.ros.programs.rviz2.model.status import ERROR, OK
from day6_core.ros.programs.rviz2.model.topics import TopicDisplay
from day6_urdf.kinematics import IDENTITY, Transform, compose

WHITE: Colour = (1.0, 1.0, 1.0, 1.0)
"""Of links without a transform (material BaseWhiteNoLighting)."""


class RobotModelDisplay(TopicDisplay):
    """Links that have no transform stay where they were (at first in the origin) and turn white, as in reality."""

    type = "RobotModel"
    selectable = True
    message_type = "std_msgs/msg/String"
    topic_name = "Description Topic"
    usual_topic = "/robot_description"
    default_topic = ""
    depth = 1
    transient_local = True
    asks_who_sent = True

    def build(self) -> None:
        changed = self.changed
        self.visual = self.add(Property("Visual Enabled", BOOL, True, on_change=changed))
        self.collision = self.add(Property("Collision Enabled", BOOL, False, on_change=changed))
        masses = self.add(Property("Mass Properties", GROUP))
        self.mass = masses.add(Property("Mass", BOOL, False, on_change=changed))
        self.inertia = masses.add(Property("Inertia", BOOL, False, on_change=changed))
        self.interval = self.add(floats("Update Interval", 0, 0, on_change=changed))
        self.alpha = self.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.source = self.add(
            Property("Description Source", ENUM, "Topic", options=("Topic", "File"), on_change=self._source_changed)
        )
        self.file = self.add(Property("Description File", FILE, "", hidden=True, on_change=changed))
        super().build()
        self.prefix = self.add(Property("TF Prefix", TEXT, "", on_change=self._prefix_changed))
        self.links = RobotLinks(self)
        self.parts = RobotParts()
        self._poses: dict[str, Transform] = {}
        self.lost: set[str] = set()
        """Links without a transform."""
        self._reading = 0
        self._updated_ns = -(10**18)

    def _topics(self) -> list[str]:
        return super()._topics()

    def _source_changed(self) -> None:
        from_file = self.source.value == "File"
        self.file.hidden, self.topic.hidden = not from_file, from_file
        self.changed()

    def _prefix_changed(self) -> None:
        self.clear_statuses()
        self.changed()

    # -- the description -----------------------------------------------------------------------------------------------

    def _wanted(self) -> tuple[Any, ...]:
        if self.source.value == "File":
            return ("File", self.file.value)
        return super()._wanted()

    def _subscribe(self) -> None:
        if self.source.value == "Topic":
            super()._subscribe()
            return
        self._subscribed = self._wanted()
        if self.file.value:
            self.rviz.read_file(self.file.value, self._file_is_here)

    def _file_is_here(self, text: str) -> None:
        if not text.strip():
            self.reset()
            self.put_status(ERROR, "URDF", "URDF is empty")
        else:
            self._read(text)

    def process(self, message: Any) -> None:
        self._read(message.data)

    def _read(self, text: str) -> None:
        self._reading += 1
        number = self._reading
        from_file = self.source.value == "File"
        folder = self.file.value if from_file else ""
        trusted = from_file or self.rviz.is_of_this_machine(self.sender)

        def done(parts: RobotParts) -> None:
            if number == self._reading and self.enabled:
                self._take_over(parts)

        self.rviz.read_robot(text, folder, trusted, done, lambda: number != self._reading)

    def _take_over(self, parts: RobotParts) -> None:
        self._forget_robot()
        self.parts = parts
        if parts.robot is None:
            self.clear_statuses()
            self.put_status(ERROR, "URDF", "URDF failed Model parse")
            self.rviz.hint("rviz.hint.description", reason=parts.problem)
        else:
            for line in parts.log:
                self.rviz.log_error(line)
            self.put_status(OK, "URDF", "URDF parsed OK")
            if errors := parts.geometry_errors:
                self.put_status(ERROR, "URDF", errors)
            self.links.show(parts)
        self.rviz.tree_changed()
        self.rviz.touch()

    def _forget_robot(self) -> None:
        self.parts = RobotParts()
        self._poses.clear()
        self.links.clear()

    def reset(self) -> None:
        """A reset keeps the robot (its topic is latched and would not speak again); another topic loses it."""
        super().reset()
        if self._subscribed != self._wanted() or not self.enabled:
            self._reading += 1
            self._forget_robot()
        elif self.parts.robot is not None:
            self.put_status(OK, "URDF", "URDF parsed OK")
            if errors := self.parts.geometry_errors:
                self.put_status(ERROR, "URDF", errors)

    def on_fixed_frame(self) -> None:
        """Only the transforms are others."""

    # -- transforms ----------------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        super().refresh()
        robot = self.parts.robot
        now_ns = self.rviz.timer_ns()
        if robot is None or (self.interval.value >= 0.0001 and now_ns - self._updated_ns < self.interval.value * 1e9):
            return
        self._updated_ns = now_ns
        prefix = f"{self.prefix.value}/" if self.prefix.value else ""
        frames, fixed = self.rviz.frames, self.rviz.fixed_frame
        lost = set()
        for link in robot.links:
            frame = prefix + link.name
            pose = frames.pose(frame)
            if pose is None:
                lost.add(link.name)
                self.put_status(ERROR, frame, f"No transform from [{frame}] to [{fixed}]")
            else:
                self._poses[link.name] = pose
                self.put_status(OK, frame, "Transform OK")
        self.lost = lost
        self.links.place(self._poses)

    def pose(self, link: str) -> Transform:
        """Where a link is drawn."""
        return self._poses.get(link, IDENTITY)

    # -- drawing -------------------------------------------------------------------------------------------------------

    def draw(self, scene: Scene) -> None:
        for name, parts in self.parts.links.items():
            if not self.links.enabled(name):
                continue
            scene.begin(self, name)
            pose, alpha = self.pose(name), self.alpha.value * self.links.alpha(name)
            lost = name in self.lost
            shown: list[RobotPart] = [*parts.visual] if self.visual.value else []
            if self.collision.value:
                shown += parts.collision
            for part in shown:
                _draw_part(scene, part, pose, name, alpha, lost)
            if self.mass.value and parts.mass is not None:
                _draw_part(scene, parts.mass, pose, "", 1.0, False)
            if self.inertia.value and parts.inertia is not None:
                _draw_part(scene, parts.inertia, pose, "", 1.0, False)
        scene.begin(None)
        self.links.draw(scene, self._poses)

    def describe(self, key: str) -> tuple[str, list[Property]] | None:
        pose = self.pose(key)
        return (f"Link {key}", pose_lines(pose.xyz, pose.rotation)) if key in self.parts.links else None

    # -- configuration -------------------------------------------------------------------------------------------------

    def save_extras(self) -> dict[str, Any]:
        return {"Links": self.links.save(), "Mass Properties": {"Inertia": self.inertia.value, "Mass": self.mass.value}}

    def load_extras(self, config: dict[str, Any]) -> None:
        self.links.load(config.get("Links"))
        self._source_changed()


def _draw_part(scene: Scene, part: RobotPart, pose: Transform, name: str, alpha: float, lost: bool) -> None:
    red, green, blue, opacity = WHITE if lost else part.colour
    colour = (red, green, blue, opacity * alpha)
    place = compose(pose, part.pose)
    if part.kind == "mesh":
        colours = None if lost else part.mesh.colours
        scene.triangles.append(
            Triangles(part.mesh.vertices, part.mesh.faces, place, part.size, colour, colours, name, not lost)
        )
    else:
        scene.shapes.append(Shape(part.kind, place, part.size, colour, name, part.wheel and not lost, not lost))

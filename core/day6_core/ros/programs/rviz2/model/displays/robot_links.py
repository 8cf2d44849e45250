"""The part `Links` of a RobotModel: a check box for every link, its details, trails and axes (robot/robot.cpp)."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rviz2.model.properties import BOOL, ENUM, QUATERNION, TEXT, VECTOR, Property, floats
from day6_core.ros.programs.rviz2.model.robot_parts import RobotParts
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene
from day6_urdf.kinematics import Transform, compose
from day6_urdf.model import Joint, Vector

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.displays.robot_model import RobotModelDisplay

LINKS, JOINTS, LINK_TREE, JOINT_TREE = (
    "Links in Alphabetic Order",
    "Joints in Alphabetic Order",
    "Tree of links",
    "Tree of links and joints",
)

TRAIL_LENGTH, TRAIL_POINTS, TRAIL_COLOUR = 2.0, 100, (0.0, 0.5, 0.5, 1.0)
"""A ribbon of two metres (robot_link.cpp)."""

AXES_LENGTH, AXES_RADIUS = 0.1, 0.01


class _LinkLine:
    """The properties of one link and its trail."""

    def __init__(self, name: str, links: RobotLinks) -> None:
        changed = links.display.changed
        self.enabled = Property(name, BOOL, True, on_change=links.link_switched)
        self.alpha = self.enabled.add(floats("Alpha", 1, 0, 1, on_change=changed))
        self.trail = self.enabled.add(Property("Show Trail", BOOL, False, on_change=changed))
        self.axes = self.enabled.add(Property("Show Axes", BOOL, False, on_change=changed))
        self.position = self.enabled.add(Property("Position", VECTOR, (0.0, 0.0, 0.0), read_only=True))
        self.orientation = self.enabled.add(Property("Orientation", QUATERNION, (0.0, 0.0, 0.0, 1.0), read_only=True))
        self.way: list[Vector] = []

    def follow(self, place: Vector) -> None:
        """Go on with the trail."""
        if not self.trail.value:
            self.way.clear()
        elif not self.way or _distance(self.way[-1], place) > TRAIL_LENGTH / TRAIL_POINTS:
            self.way = [*self.way[-TRAIL_POINTS + 1 :], place]


class _JointLine:
    """The properties of one joint."""

    def __init__(self, joint: Joint, links: RobotLinks) -> None:
        self.joint = joint
        changed = links.display.changed
        self.line = Property(joint.name, BOOL, True, on_change=changed)
        self.axes = self.line.add(Property("Show Axes", BOOL, False, on_change=changed))
        self.position = self.line.add(Property("Position", VECTOR, (0.0, 0.0, 0.0), read_only=True))
        self.orientation = self.line.add(Property("Orientation", QUATERNION, (0.0, 0.0, 0.0, 1.0), read_only=True))
        self.line.add(Property("Type", TEXT, joint.type, read_only=True))
        if joint.limit is not None and joint.type in ("revolute", "prismatic"):
            self.line.add(floats("Lower Limit", joint.limit.lower, read_only=True))
            self.line.add(floats("Upper Limit", joint.limit.upper, read_only=True))
        self.show_axis: Property | None = None
        if joint.type in ("revolute", "continuous", "prismatic"):
            self.show_axis = self.line.add(Property("Show Joint Axis", BOOL, False, on_change=changed))
            self.line.add(Property("Joint Axis", VECTOR, joint.axis, read_only=True))


class RobotLinks:
    """Builds and keeps the tree; hidden until a robot is there."""

    def __init__(self, display: RobotModelDisplay) -> None:
        self.display = display
        changed = display.changed
        self.root = display.add(Property("Links", saved=False, hidden=True))
        self.style = Property(
            "Link Tree Style", ENUM, LINKS, options=(LINKS, JOINTS, LINK_TREE, JOINT_TREE), on_change=self._arrange
        )
        self.expand_tree = Property("Expand Tree", BOOL, False, on_change=self._expand)
        self.expand_links = Property("Expand Link Details", BOOL, False, on_change=self._expand)
        self.expand_joints = Property("Expand Joint Details", BOOL, False, on_change=self._expand)
        self.all = Property("All Links Enabled", BOOL, True, on_change=self._all_switched)
        self.options = [self.style, self.expand_tree, self.expand_links, self.expand_joints, self.all]
        for option in self.options:
            self.root.add(option)
        self._lines: dict[str, _LinkLine] = {}
        self._joints: dict[str, _JointLine] = {}
        self._saved: dict[str, Any] = {}
        self._switching = False
        self._changed = changed
        self._parts = RobotParts()

    # -- the tree ------------------------------------------------------------------------------------------------------

    def show(self, parts: RobotParts) -> None:
        """Build the lines of a robot."""
        assert parts.robot is not None
        self._parts = parts
        self._lines = {link.name: _LinkLine(link.name, self) for link in parts.robot.links}
        self._joints = {joint.name: _JointLine(joint, self) for joint in parts.robot.joints}
        self._switching = True
        for name, line in self._lines.items():
            saved = self._saved.get(name)
            if isinstance(saved, dict):
                line.enabled.load(saved)
        self._switching = False
        self.link_switched()
        self._arrange()
        self.root.hidden = False

    def clear(self) -> None:
        """There is no robot any more."""
        if self._lines:
            self._saved = {**self._saved, **self._saved_lines()}
        self._lines, self._joints = {}, {}
        self._parts = RobotParts()
        self.root.children = list(self.options)
        self.root.hidden = True

    def _arrange(self) -> None:
        """Put the lines into the order or tree that is wanted."""
        robot = self._parts.robot
        self.root.children = list(self.options)
        if robot is None:
            return
        style = self.style.value
        for line in self._lines.values():
            line.enabled.children = [each for each in line.enabled.children if each.kind != BOOL or each in _own(line)]
        for joint in self._joints.values():
            joint.line.children = [
                each for each in joint.line.children if each.kind != BOOL or each in _own_joint(joint)
            ]
        if style == LINKS:
            for name in sorted(self._lines):
                self.root.add(self._lines[name].enabled)
        elif style == JOINTS:
            for name in sorted(self._joints):
                self.root.add(self._joints[name].line)
        else:
            self._grow(robot.root, self.root, style == JOINT_TREE)
        self._expand()

    def _grow(self, root: str, above: Property, with_joints: bool) -> None:
        robot = self._parts.robot
        assert robot is not None
        waiting = [(root, above)]
        grown = set()
        while waiting:
            name, parent = waiting.pop()
            if name in grown or name not in self._lines:
                continue
            grown.add(name)
            line = parent.add(self._lines[name].enabled)
            for joint in reversed(robot.children_of(name)):
                waiting.append((joint.child, line.add(self._joints[joint.name].line) if with_joints else line))

    def _expand(self) -> None:
        tree = self.style.value in (LINK_TREE, JOINT_TREE) and self.expand_tree.value
        for line in self._lines.values():
            line.enabled.expanded = bool(self.expand_links.value or tree)
        for joint in self._joints.values():
            joint.line.expanded = bool(self.expand_joints.value or tree)
        self.display.rviz.tree_changed()

    # -- switches ------------------------------------------------------------------------------------------------------

    def _all_switched(self) -> None:
        if not self._switching:
            self._switching = True
            for line in self._lines.values():
                line.enabled.set(self.all.value)
            self._switching = False
        self._changed()

    def link_switched(self) -> None:
        """A link's check box: `All Links Enabled` says whether all are on."""
        if not self._switching:
            self._switching = True
            self.all.set(all(line.enabled.value for line in self._lines.values()))
            self._switching = False
        self._changed()

    def enabled(self, name: str) -> bool:
        line = self._lines.get(name)
        return line is None or bool(line.enabled.value)

    def alpha(self, name: str) -> float:
        line = self._lines.get(name)
        return 1.0 if line is None else float(line.alpha.value)

    # -- poses and pictures --------------------------------------------------------------------------------------------

    def place(self, poses: dict[str, Transform]) -> None:
        """Show where the links and joints are."""
        for name, line in self._lines.items():
            if name in poses:
                line.position.value, line.orientation.value = poses[name].xyz, poses[name].rotation
                line.follow(poses[name].xyz)
        for joint in self._joints.values():
            if joint.joint.parent in poses:
                pose = compose(poses[joint.joint.parent], joint.joint.origin)
                joint.position.value, joint.orientation.value = pose.xyz, pose.rotation

    def draw(self, scene: Scene, poses: dict[str, Transform]) -> None:
        """Trails and axes."""
        for name, line in self._lines.items():
            if line.axes.value and name in poses:
                scene.axes(poses[name], AXES_LENGTH, AXES_RADIUS)
            if len(line.way) > 1:
                ends = [point for pair in zip(line.way, line.way[1:], strict=False) for point in pair]
                scene.lines.append(Lines(ends, [TRAIL_COLOUR]))
        for joint in self._joints.values():
            if joint.joint.parent not in poses:
                continue
            pose = Transform(joint.position.value, joint.orientation.value)
            if joint.axes.value:
                scene.axes(pose, AXES_LENGTH, AXES_RADIUS)
            if joint.show_axis is not None and joint.show_axis.value:
                from day6_core.ros.programs.rviz2.model.scene import placed, pointing

                arrow = pointing(pose.xyz, placed(pose, joint.joint.axis))
                scene.arrow(arrow, 0.15, 0.05, 0.05, 0.08, (1.0, 0.0, 0.0, 1.0))

    # -- configuration -------------------------------------------------------------------------------------------------

    def _saved_lines(self) -> dict[str, Any]:
        lines = {}
        for name, line in self._lines.items():
            lines[name] = {"Alpha": line.alpha.save(), "Show Axes": line.axes.value, "Show Trail": line.trail.value}
            if self._parts.links[name].visual or self._parts.links[name].collision:
                lines[name]["Value"] = line.enabled.value
        return lines

    def save(self) -> dict[str, Any]:
        options = {option.name: option.value for option in self.options}
        return {**self._saved, **options, **self._saved_lines()}

    def load(self, config: Any) -> None:
        if not isinstance(config, dict):
            return
        for option in self.options:
            if option.name in config and option is not self.all:
                option.load(config[option.name])
        names = {option.name for option in self.options}
        self._saved = {str(name): entry for name, entry in config.items() if name not in names}


def _own(line: _LinkLine) -> list[Property]:
    return [line.trail, line.axes]


def _own_joint(joint: _JointLine) -> list[Property]:
    return [joint.axes, *([joint.show_axis] if joint.show_axis is not None else [])]


def _distance(a: Vector, b: Vector) -> float:
    return float(sum((x - y) ** 2 for x, y in zip(a, b, strict=True)) ** 0.5)

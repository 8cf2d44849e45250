"""TF (rviz_default_plugins/displays/tf): every frame with its axes, its name, and an arrow to its parent."""

from __future__ import annotations

import re
from typing import Any

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.properties import (
    BOOL,
    GROUP,
    QUATERNION,
    TEXT,
    VECTOR,
    Property,
    floats,
    pose_lines,
)
from day6_core.ros.programs.rviz2.model.scene import Label, Scene, pointing
from day6_core.ros.programs.rviz2.model.status import OK, WARN
from day6_core.user_pattern import user_pattern
from day6_urdf.kinematics import IDENTITY, Transform

AXIS_LENGTH, AXIS_RADIUS = 0.2, 0.02
ARROW_SHAFT = (0.8, 0.8, 0.3, 1.0)
ARROW_HEAD = (1.0, 0.1, 0.6, 1.0)
ARROW_DIAMETER, HEAD_DIAMETER, HEAD_LENGTH = 0.01, 0.04, 0.1
GREY = 0.7


class _Frame:
    """What the panel and the picture know of one frame."""

    def __init__(self, name: str, display: TFDisplay) -> None:
        self.name = name
        self.enabled = Property(name, BOOL, display.config.get(name, True), on_change=display.frame_switched)
        self.parent = Property("Parent", TEXT, "", read_only=True)
        self.position = Property("Position", VECTOR, (0.0, 0.0, 0.0), read_only=True)
        self.orientation = Property("Orientation", QUATERNION, (0.0, 0.0, 0.0, 1.0), read_only=True)
        self.relative_position = Property("Relative Position", VECTOR, (0.0, 0.0, 0.0), read_only=True)
        self.relative_orientation = Property("Relative Orientation", QUATERNION, (0.0, 0.0, 0.0, 1.0), read_only=True)
        for each in (self.parent, self.position, self.orientation, self.relative_position, self.relative_orientation):
            self.enabled.add(each)
        self.tree = Property(name, GROUP)
        self.pose: Transform | None = None
        self.latest_ns: int | None = None
        self.heard_ns = 0

    def age(self, now_ns: int, latest_ns: int | None) -> float:
        """Seconds since its transform was last renewed; fixed frames (time 0) are always new (tf/frame_info.cpp)."""
        if latest_ns != self.latest_ns or not latest_ns:
            self.latest_ns = latest_ns
            self.heard_ns = now_ns
        return (now_ns - self.heard_ns) / 1e9


class TFDisplay(Display):
    """Frames, as the buffer knows them."""

    type = "TF"
    selectable = True

    def build(self) -> None:
        changed = self.changed
        self.names = self.add(Property("Show Names", BOOL, False, on_change=changed))
        self.axes = self.add(Property("Show Axes", BOOL, True, on_change=changed))
        self.arrows = self.add(Property("Show Arrows", BOOL, True, on_change=changed))
        self.scale = self.add(floats("Marker Scale", 1, on_change=changed))
        self.interval = self.add(floats("Update Interval", 0, 0, on_change=changed))
        self.timeout = self.add(floats("Frame Timeout", 15, 1, on_change=changed))
        self.whitelist = self.add(Property("Filter (whitelist)", TEXT, "", on_change=changed))
        self.blacklist = self.add(Property("Filter (blacklist)", TEXT, "", on_change=changed))
        self.list = self.add(Property("Frames", GROUP))
        self.all = Property("All Enabled", BOOL, True, on_change=self._all_switched)
        self.list.add(self.all)
        self.tree = self.add(Property("Tree", GROUP))
        self.config: dict[str, bool] = {}
        self.frames: dict[str, _Frame] = {}
        self._updated_ns = -(10**18)
        self._switching = False

    # -- switches ------------------------------------------------------------------------------------------------------

    def _all_switched(self) -> None:
        if not self._switching:
            for frame in self.frames.values():
                frame.enabled.set(self.all.value)
        self.changed()

    def frame_switched(self) -> None:
        """A frame's own check box: one that is off switches `All Enabled` off."""
        for frame in self.frames.values():
            self.config[frame.name] = bool(frame.enabled.value)
            if self.all.value and not frame.enabled.value:
                self._switching = True
                self.all.set(False)
                self._switching = False
        self.changed()

    # -- frames --------------------------------------------------------------------------------------------------------

    def on_fixed_frame(self) -> None:
        self._updated_ns = -(10**18)

    def on_disable(self) -> None:
        self._forget(set())

    def reset(self) -> None:
        super().reset()
        self._forget(set())

    def refresh(self) -> None:
        now_ns = self.rviz.timer_ns()
        if self.interval.value >= 0.0001 and now_ns - self._updated_ns <= self.interval.value * 1e9:
            return
        self._updated_ns = now_ns
        names = [name for name in self.rviz.frames.names() if self._wanted(name)]
        self._forget(set(names))
        for name in names:
            if name not in self.frames:
                frame = self.frames[name] = _Frame(name, self)
                self.list.add(frame.enabled)
                self.rviz.tree_changed()
            self._update(self.frames[name], now_ns)

    def _wanted(self, name: str) -> bool:
        return _matches(self.whitelist.value, name, True) and not _matches(self.blacklist.value, name, False)

    def _forget(self, keep: set[str]) -> None:
        for name in [name for name in self.frames if name not in keep]:
            frame = self.frames.pop(name)
            self.list.remove(frame.enabled)
            if frame.tree.parent is not None:
                frame.tree.parent.remove(frame.tree)
            self.drop_status(name)
            self.rviz.tree_changed()

    def _update(self, frame: _Frame, now_ns: int) -> None:
        frames = self.rviz.frames
        latest = frames.latest_ns(frame.name)
        if frame.age(now_ns, latest) > self.timeout.value:
            frame.pose = None
            return
        frame.pose = frames.pose(frame.name)
        if frame.pose is None:
            fixed = self.rviz.fixed_frame
            self.put_status(WARN, frame.name, f"No transform from [{frame.name}] to [{fixed}]")
            return
        self.put_status(OK, frame.name, "Transform OK")
        frame.position.value, frame.orientation.value = frame.pose.xyz, frame.pose.rotation
        parent = frames.parent(frame.name) or ""
        above = self.frames[parent].tree if parent in self.frames else self.tree
        if frame.tree.parent is not above:
            if frame.tree.parent is not None:
                frame.tree.parent.remove(frame.tree)
            above.add(frame.tree)
            self.rviz.tree_changed()
        frame.parent.value = parent
        relative = frames.between(parent, frame.name) if parent else None
        relative = relative or IDENTITY
        frame.relative_position.value, frame.relative_orientation.value = relative.xyz, relative.rotation

    @property
    def fading(self) -> bool:
        """Whether a frame is growing old, so that the picture changes without news."""
        third = self.timeout.value / 3
        now_ns = self.rviz.timer_ns()
        return any(frame.pose is not None and (now_ns - frame.heard_ns) / 1e9 > third for frame in self.frames.values())

    def draw(self, scene: Scene) -> None:
        now_ns = self.rviz.timer_ns()
        scale = self.scale.value
        for frame in self.frames.values():
            if frame.pose is None or not frame.enabled.value:
                continue
            scene.begin(self, frame.name)
            grey, alpha = _faded((now_ns - frame.heard_ns) / 1e9, self.timeout.value)
            if self.axes.value:
                scene.axes(frame.pose, AXIS_LENGTH * scale, AXIS_RADIUS * scale, alpha, grey)
            if self.names.value:
                scene.labels.append(Label(frame.name, frame.pose.xyz, (1.0, 1.0, 1.0, alpha), is_name=True))
            parent = self.rviz.frames.pose(frame.parent.value) if frame.parent.value else None
            if self.arrows.value and parent is not None:
                _draw_arrow(scene, frame.pose, parent, scale, grey, alpha)

    def describe(self, key: str) -> tuple[str, list[Property]] | None:
        frame = self.frames.get(key)
        if frame is None or frame.pose is None:
            return None
        parent = Property("Parent", TEXT, frame.parent.value, read_only=True)
        enabled = Property("Enabled", BOOL, frame.enabled.value, read_only=True)
        return f"Frame {key}", [enabled, parent, *pose_lines(frame.pose.xyz, frame.pose.rotation)]

    # -- configuration -------------------------------------------------------------------------------------------------

    def save_extras(self) -> dict[str, Any]:
        frames: dict[str, Any] = {name: {"Value": on} for name, on in self.config.items()}
        frames.update({name: {"Value": bool(frame.enabled.value)} for name, frame in self.frames.items()})
        frames["All Enabled"] = bool(self.all.value)
        tree = {child.name: _branch(child) for child in self.tree.children}
        return {"Frames": frames, "Tree": tree}

    def load_extras(self, config: dict[str, Any]) -> None:
        frames = config.get("Frames")
        for name, entry in frames.items() if isinstance(frames, dict) else ():
            if isinstance(entry, dict) and name != "All Enabled":
                self.config[str(name)] = bool(entry.get("Value", True))


def _branch(tree: Property) -> dict[str, Any]:
    return {child.name: _branch(child) for child in tree.children}


def _matches(pattern: str, name: str, without: bool) -> bool:
    """Whether a filter finds the name; `without` is the answer of no filter and of one that is no regular expression."""
    if not pattern:
        return without
    try:
        return user_pattern(pattern).search(name) is not None
    except re.error:
        return without


def _faded(age: float, timeout: float) -> tuple[float, float]:
    """How grey and how opaque a frame is: a third of the time as new, a third turning grey, a third vanishing."""
    third = timeout / 3
    if age <= third:
        return 0.0, 1.0
    if age <= 2 * third:
        return (age - third) / third, 1.0
    return 1.0, max(0.0, (timeout - age) / third)


def _draw_arrow(scene: Scene, pose: Transform, parent: Transform, scale: float, grey: float, alpha: float) -> None:
    start, end = pose.xyz, parent.xyz
    distance = sum((a - b) ** 2 for a, b in zip(start, end, strict=True)) ** 0.5
    if distance <= 0.001:
        return
    # tf/frame_info.cpp: the head takes a tenth of a metre; on a shorter way a tenth of the way.
    head = HEAD_LENGTH * scale * (distance if distance < HEAD_LENGTH * scale else 1.0)
    shaft_colour, head_colour = (
        (*((1 - grey) * part + grey * GREY for part in colour[:3]), alpha) for colour in (ARROW_SHAFT, ARROW_HEAD)
    )
    scene.arrow(
        pointing(start, end),
        distance - head,
        ARROW_DIAMETER * scale,
        head,
        HEAD_DIAMETER * scale,
        shaft_colour,  # type: ignore[arg-type]
        head_colour,  # type: ignore[arg-type]
    )

"""One interactive marker: its pose, what is drawn of it, and what it sends as mouse or keys take one of its controls."""

from __future__ import annotations

import math
from dataclasses import dataclass
from functools import partial
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rviz2.model.displays.control_drag import (
    DRAGGABLE,
    FREE,
    Eye,
    Grab,
    Ray,
    facing,
    plus,
    pushed,
    rolled,
    turned,
)
from day6_core.ros.programs.rviz2.model.displays.control_keys import Axes, Steps, stepped
from day6_core.ros.programs.rviz2.model.displays.control_shapes import (
    BUTTON,
    FIXED,
    MENU,
    MOVE_3D,
    MOVE_AXIS,
    MOVE_PLANE,
    MOVE_ROTATE,
    MOVE_ROTATE_3D,
    NONE,
    ROTATE_3D,
    ROTATE_AXIS,
    VIEW_FACING,
    completed,
    title_of,
)
from day6_core.ros.programs.rviz2.model.displays.marker_shapes import MESH, TEXT, draw_marker
from day6_core.ros.programs.rviz2.model.scene import Lines, Scene, placed
from day6_core.ros.programs.rviz2.model.status import ERROR, OK
from day6_core.ros.programs.rviz2.model.tools.tool import Pointer
from day6_core.ros.programs.rviz2.model.topics import pose_of, stamp_ns
from day6_core.ros.programs.rviz2.model.views import FIELD_OF_VIEW, NOMINAL_HEIGHT
from day6_urdf.kinematics import IDENTITY, Transform, compose, inverse, multiply, rotate
from day6_urdf.model import Quaternion, Vector
from rclpy.time import Time

if TYPE_CHECKING:
    from day6_core.ros.programs.rviz2.model.displays.interactive_markers import InteractiveMarkersDisplay

POSE_UPDATE, MENU_SELECT, BUTTON_CLICK, MOUSE_DOWN, MOUSE_UP = range(1, 6)

MOVE_Z = "Shift + Left-Click / Left-Click + Wheel: Move Z. "
WORDS = {
    MENU: "Left-Click: Show menu.",
    BUTTON: "Left-Click: Activate. ",
    MOVE_AXIS: "Left-Click: Move. ",
    MOVE_PLANE: "Left-Click: Move. ",
    ROTATE_AXIS: "Left-Click: Rotate. ",
    MOVE_ROTATE: "Left-Click: Move / Rotate. ",
    MOVE_3D: f"Left-Click: Move X/Y. {MOVE_Z}",
    ROTATE_3D: "Left-Click: Rotate around X/Y. Shift-Left-Click: Rotate around Z. ",
    MOVE_ROTATE_3D: f"Left-Click: Move X/Y. {MOVE_Z}"
    "Ctrl + Left-Click: Rotate around X/Y. Ctrl + Shift + Left-Click: Rotate around Z. ",
}
"""What the status bar says, of what can be done here."""

Y, Z = (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)

LOWER = 10.0
"""Pixels between the two places by which the scale of a picture is measured."""
NOTCH = 2.0
"""Pixels that a notch of the wheel is worth (the original forgets to scale them, and jumps two metres)."""
AIDED = (MOVE_AXIS, MOVE_ROTATE, ROTATE_AXIS)
"""Modes of controls that a line shows the axis of."""
FAR = 10000.0
"""Metres of the visual aid to both sides."""


@dataclass
class _Held:
    """A control that mouse or keys have taken."""

    control: Any
    grab: Grab | None
    """What follows the mouse; None of a control that does not."""
    angle: float
    """The control's angle when it was taken."""
    pointer: Pointer
    """Where the mouse was last."""
    metres: float
    """What one of the mouse's pixels moves the marker away."""


class InteractiveMarker:
    """A marker whose header has no time moves with its frame; another one is put into the Fixed Frame once."""

    def __init__(self, display: InteractiveMarkersDisplay, message: Any) -> None:
        self._display = display
        self._angles: dict[str, float] = {}
        """By control: how far it was turned about its axis."""
        self._held: _Held | None = None
        self._requested: Any = None
        """A pose that came while a control was held."""
        self.reference: Transform | None = None
        self.take(message)

    def take(self, message: Any) -> None:
        """A new description."""
        self.message = completed(message, bool(self._display.transparent.value))
        self._title = title_of(self.message)
        self._set_pose(message)
        text = f"Locked to frame {self.frame}" if self.locked else "Position is fixed."
        if self.reference is not None:
            self._display.put_status(OK, self.message.name, text)

    def take_pose(self, message: Any) -> None:
        """A pose from the server; while the user holds a control, it waits."""
        if self._held is not None:
            self._requested = message
        else:
            self._set_pose(message)

    def _set_pose(self, message: Any) -> None:
        self.frame, self.locked = message.header.frame_id, stamp_ns(message.header.stamp) == 0
        self.pose = pose_of(message.pose)
        if not self.locked:
            # The client transforms such a message into its target frame.
            pose = self._display.rviz.frames.pose(self.frame, stamp_ns(message.header.stamp))
            if pose is not None:
                self.frame, self.pose = self._display.rviz.fixed_frame, compose(pose, self.pose)
        self.follow()

    def follow(self) -> None:
        """Find the reference frame anew."""
        frames = self._display.rviz.frames
        self.reference = frames.pose(self.frame)
        if self.reference is None:
            self._display.put_status(ERROR, self.message.name, frames.transform_problem(self.frame) or "")

    # -- drawing -------------------------------------------------------------------------------------------------------

    @property
    def turns_with_view(self) -> bool:
        """Whether its picture changes with the view."""
        return any(
            control.orientation_mode == VIEW_FACING and any(marker.type != TEXT for marker in control.markers)
            for control in self.message.controls
        )

    def draw(self, scene: Scene, interaction: bool, title: bool, axes: bool) -> None:
        """Add to the scene; without `interaction` only the control that is held, and those that are always visible."""
        if self.reference is None:
            return
        name = self.message.name
        held = self._held.control if self._held is not None else None
        for control in self.message.controls:
            if not interaction and not control.always_visible and control is not held:
                continue
            touchable = (interaction or control is held) and control.interaction_mode != NONE
            scene.begin(self._display if touchable else None, (name, control.name))
            frame = compose(self.reference, Transform(self.pose.xyz, self._markers_turn(control)))
            for marker in control.markers:
                self._draw_marker(scene, marker, frame)
            if light := self._display.lights.get((name, control.name)):
                scene.lighten(light)
        scene.begin(None)
        if held is not None and self._display.aids.value and held.interaction_mode in AIDED:
            self._draw_aid(scene, held)
        if title and self.message.description:
            above = self._facing((0.0, 0.0, 0.0, 1.0), 0.0)
            draw_marker(scene, self._title, compose(self.reference, Transform(self.pose.xyz, above)))
        if axes:
            scene.axes(compose(self.reference, self.pose), self.message.scale, self.message.scale * 0.05)

    def _draw_aid(self, scene: Scene, control: Any) -> None:
        """The line along which a control moves, or about which it turns."""
        if self.reference is not None and control.orientation_mode != VIEW_FACING:
            ends = [placed(self.reference, plus(self.pose.xyz, self._axis(control), way)) for way in (FAR, -FAR)]
            scene.lines.append(Lines(ends, [(1.0, 1.0, 1.0, 1.0)]))

    def _draw_marker(self, scene: Scene, marker: Any, frame: Transform) -> None:
        if marker.header.frame_id:
            own = self._display.rviz.frames.pose(marker.header.frame_id)
            if own is None:
                return
            frame = own
        mesh = self._display.mesh(marker) if marker.type == MESH else None
        draw_marker(scene, marker, frame, mesh)

    def _turn(self, control: Any) -> Quaternion:
        """The control's own orientation in the reference frame."""
        angle = self._angles.get(control.name, 0.0)
        own = _orientation(control)
        if control.orientation_mode == VIEW_FACING:
            return self._facing(own, angle)
        if control.orientation_mode == FIXED:
            axis = rotate(own, (1.0, 0.0, 0.0))
            half = math.sin(angle / 2)
            return axis[0] * half, axis[1] * half, axis[2] * half, math.cos(angle / 2)
        return self.pose.rotation

    def _markers_turn(self, control: Any) -> Quaternion:
        if control.orientation_mode == VIEW_FACING and control.independent_marker_orientation:
            return self.pose.rotation
        return self._turn(control)

    def _facing(self, own: Quaternion, angle: float) -> Quaternion:
        camera = self._display.rviz.view.camera()
        turn = facing(own, camera.forward, camera.up, angle)
        return multiply(inverse(self.reference or IDENTITY).rotation, turn)

    # -- mouse and keys ------------------------------------------------------------------------------------------------

    def control(self, name: str) -> Any:
        """A control by its name; None if there is none."""
        return next((each for each in self.message.controls if each.name == name), None)

    def words(self, control: Any) -> str:
        """What the status bar says of a control."""
        words = f"{control.description} {WORDS.get(control.interaction_mode, '')}"
        if self.message.menu_entries and control.interaction_mode != MENU:
            words += "Right-Click: Show context menu."
        return words.strip()

    def touchable(self) -> list[str]:
        """The names of the controls that can be used, in their order."""
        return [each.name for each in self.message.controls if each.interaction_mode != NONE]

    def _axis(self, control: Any, of: Vector = (1.0, 0.0, 0.0)) -> Vector:
        """An axis of a control, its x by default."""
        return rotate(multiply(self._turn(control), _orientation(control)), of)

    def _ray(self, start: Vector, along: Vector) -> Ray:
        back = inverse(self.reference or IDENTITY)
        return Ray(placed(back, start), rotate(back.rotation, along))

    @property
    def _eye(self) -> Eye:
        back, camera = inverse(self.reference or IDENTITY).rotation, self._display.rviz.view.camera()
        return Eye(*(rotate(back, axis) for axis in (camera.right, camera.up, camera.forward)))

    def press(self, name: str, pointer: Pointer) -> None:
        """The left button went down on a control."""
        control = self.control(name)
        if control is None or self.reference is None:
            return
        grab, metres = None, 0.0
        if control.interaction_mode in DRAGGABLE:
            # What was found under the mouse lies a part of a cell beside it.
            ray = self._ray(pointer.start, pointer.along)
            point = self.pose.xyz
            if pointer.hit is not None:
                point = ray.beside(placed(inverse(self.reference), pointer.hit.point))
            grab = Grab(control.interaction_mode, point, self._axis(control), self._eye, self.pose)
            metres = grab.metres(ray, self._lower(pointer), LOWER)
        self._held = _Held(control, grab, self._angles.get(name, 0.0), pointer, metres)
        self._tell(POSE_UPDATE, name, pointer)
        self._tell(MOUSE_DOWN, name, pointer)

    def _lower(self, pointer: Pointer) -> Ray:
        """The ray some pixels below the mouse."""
        camera = self._display.rviz.view.camera()
        if camera.metres is not None:
            return self._ray(plus(pointer.start, camera.up, -LOWER * camera.metres / NOMINAL_HEIGHT), pointer.along)
        depth = sum(a * b for a, b in zip(pointer.along, camera.forward, strict=True))
        down = depth * LOWER * 2 * math.tan(FIELD_OF_VIEW / 2) / NOMINAL_HEIGHT
        return self._ray(pointer.start, plus(pointer.along, camera.up, -down))

    def drag(self, pointer: Pointer) -> None:
        """The mouse moved with the button down."""
        held = self._held
        if held is None or held.grab is None or self.reference is None:
            return
        before, held.pointer = held.pointer, pointer
        ray, mode = self._ray(pointer.start, pointer.along), held.control.interaction_mode
        if mode in FREE and (pointer.shift, pointer.control) != (before.shift, before.control):
            held.grab = held.grab.again(ray, self.pose)
        turning = mode == ROTATE_3D or (mode == MOVE_ROTATE_3D and pointer.control)
        dx, dy = pointer.pixel[0] - before.pixel[0], pointer.pixel[1] - before.pixel[1]
        if mode in FREE and (turning or pointer.shift):
            if not dx and not dy:
                return
            if turning:
                self.pose = (rolled if pointer.shift else turned)(self.pose, held.grab.eye, dx, dy)
            else:
                self.pose = pushed(self.pose, ray.along, dx, dy, held.metres)
        elif (found := held.grab.follow(ray)) is not None:
            self.pose, turned_by = found
            self._angles[held.control.name] = held.angle + turned_by
        else:
            return
        self._tell(POSE_UPDATE, held.control.name)

    def wheel(self, notches: float) -> None:
        """The wheel was turned with the button down."""
        held = self._held
        if held is None or held.grab is None or held.control.interaction_mode not in (MOVE_3D, MOVE_ROTATE_3D):
            return
        ray = self._ray(held.pointer.start, held.pointer.along)
        self.pose = pushed(self.pose, ray.along, 0.0, -notches * NOTCH, held.metres)
        held.grab = held.grab.again(ray, self.pose)
        self._tell(POSE_UPDATE, held.control.name)

    def step(self, steps: Steps, turning: bool) -> None:
        """Keys move or turn the control that is held."""
        held = self._held
        if held is None or held.grab is None:
            return
        name, mode = held.control.name, held.control.interaction_mode
        axes = Axes(self._axis(held.control), (self._axis(held.control, Y), self._axis(held.control, Z)))
        self.pose, angle = stepped(mode, self.pose, axes, self._eye, steps, turning)
        self._angles[name] = self._angles.get(name, 0.0) + angle
        self._tell(POSE_UPDATE, name)

    def release(self, pointer: Pointer) -> None:
        """The button went up."""
        if self._held is None:
            return
        control = self._held.control
        if control.interaction_mode == BUTTON:
            self._tell(BUTTON_CLICK, control.name, pointer)
        self._tell(POSE_UPDATE, control.name, pointer)
        self._tell(MOUSE_UP, control.name, pointer)
        if control.interaction_mode == MENU:
            self.open_menu(control.name, pointer)
        self._held = None
        if self._requested is not None:
            requested, self._requested = self._requested, None
            self._set_pose(requested)

    # -- the menu --------------------------------------------------------------------------------------------------------

    @property
    def choices(self) -> list[tuple[int, str]]:
        """Numbers and titles of the menu's entries that send feedback; those of a submenu after its title."""
        entries = {entry.id: entry for entry in self.message.menu_entries}
        parents = {entry.parent_id for entry in entries.values()}
        found = []
        for entry in entries.values():
            titles, above, seen = [_checked(entry.title)], entries.get(entry.parent_id), {entry.id}
            while above is not None and above.id not in seen:
                seen.add(above.id)
                titles.insert(0, _checked(above.title))
                above = entries.get(above.parent_id)
            if entry.id not in parents and entry.command_type == entry.FEEDBACK:
                found.append((entry.id, " ▸ ".join(titles)))
        return found

    def open_menu(self, name: str, pointer: Pointer) -> None:
        """Let the user choose of the menu, for a control."""
        if choices := self.choices:
            self._display.rviz.menu = [
                (title, partial(self._tell, MENU_SELECT, name, pointer, number)) for number, title in choices
            ]

    def _tell(self, event: int, control: str, pointer: Pointer | None = None, entry: int = 0) -> None:
        """Send feedback: in the marker's frame if it is locked to it, else in the Fixed Frame."""
        from visualization_msgs.msg import InteractiveMarkerFeedback

        reference = self.reference or IDENTITY
        feedback = InteractiveMarkerFeedback(event_type=event, control_name=control, marker_name=self.message.name)
        feedback.menu_entry_id = entry
        hit = pointer.hit if pointer is not None else None
        point = hit.point if hit is not None else None
        rviz = self._display.rviz
        pose = self.pose
        if self.locked:
            feedback.header.frame_id = self.frame
            if self.frame != rviz.fixed_frame and (latest := rviz.frames.latest_ns(self.frame)) is not None:
                feedback.header.stamp = Time(nanoseconds=latest).to_msg()
            point = placed(inverse(reference), point) if point is not None else None
        else:
            feedback.header.frame_id = rviz.fixed_frame
            pose = compose(reference, pose)
        position, turn = feedback.pose.position, feedback.pose.orientation
        position.x, position.y, position.z = pose.xyz
        turn.x, turn.y, turn.z, turn.w = pose.rotation
        if point is not None:
            feedback.mouse_point_valid = True
            feedback.mouse_point.x, feedback.mouse_point.y, feedback.mouse_point.z = _floats(point)
        self._display.send(feedback)


def _checked(title: str) -> str:
    """A title; `[x]` and `[ ]` before it are boxes."""
    return {"[x]": "☑", "[ ]": "☐"}.get(title[:3], title[:3]) + title[3:]


def _orientation(control: Any) -> Quaternion:
    turn = control.orientation
    norm = math.sqrt(turn.x**2 + turn.y**2 + turn.z**2 + turn.w**2)
    return turn.x / norm, turn.y / norm, turn.z / norm, turn.w / norm


def _floats(point: Vector) -> Vector:
    x, y, z = map(float, point)
    return x, y, z

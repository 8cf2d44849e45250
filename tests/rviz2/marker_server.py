"""A server of interactive markers written with the package interactive_markers, in the way of its tutorials."""

from __future__ import annotations

import math
from typing import Any

from geometry_msgs.msg import Quaternion
from interactive_markers import InteractiveMarkerServer, MenuHandler
from visualization_msgs.msg import InteractiveMarker, InteractiveMarkerControl, InteractiveMarkerFeedback, Marker

from rclpy.qos import QoSProfile

EVENTS = {
    getattr(InteractiveMarkerFeedback, name): name
    for name in ("POSE_UPDATE", "MENU_SELECT", "BUTTON_CLICK", "MOUSE_DOWN", "MOUSE_UP")
}


class Controls:
    """The markers of the server `controls`, in the frame `stand`; `events` is what came back."""

    def __init__(self, node: Any) -> None:
        # Of the default depth, 1, only the newest of what comes at once is seen.
        self.server = InteractiveMarkerServer(node, "controls", feedback_sub_qos=QoSProfile(depth=100))
        self.menu = MenuHandler()
        self.events: list[str] = []
        self.last = InteractiveMarkerFeedback()
        self.chosen: list[str] = []

    def heard(self, feedback: InteractiveMarkerFeedback) -> None:
        self.events.append(EVENTS[feedback.event_type])
        self.last = feedback

    def taken(self) -> list[str]:
        """The events since the last call."""
        events, self.events = self.events, []
        return events

    def add(self, name: str, *controls: InteractiveMarkerControl, y: float = 0.0) -> InteractiveMarker:
        marker = InteractiveMarker(name=name, description=name.replace("_", " "), scale=1.0)
        marker.header.frame_id = "stand"
        marker.pose.position.y = y
        marker.controls = list(controls)
        self.server.insert(marker, feedback_callback=self.heard)
        self.server.applyChanges()
        return marker

    def give_menu(self, name: str) -> None:
        lamp = self.menu.insert("lamp", callback=self.switch)
        assert lamp is not None
        self.menu.setCheckState(lamp, MenuHandler.UNCHECKED)
        drive = self.menu.insert("drive")
        self.menu.insert("home", parent=drive, callback=lambda feedback: self.chosen.append("home"))
        self.menu.apply(self.server, name)
        self.server.applyChanges()

    def switch(self, feedback: InteractiveMarkerFeedback) -> None:
        handle = feedback.menu_entry_id
        on = self.menu.getCheckState(handle) == MenuHandler.CHECKED
        self.menu.setCheckState(handle, MenuHandler.UNCHECKED if on else MenuHandler.CHECKED)
        self.menu.reApply(self.server)
        self.server.applyChanges()
        self.chosen.append(f"lamp {'off' if on else 'on'}")


def control(name: str, mode: int, turn: Quaternion | None = None, cube: float = 0.0) -> InteractiveMarkerControl:
    """A control of a mode (a constant of InteractiveMarkerControl); `cube` is the size of a cube that is grasped."""
    made = InteractiveMarkerControl(name=name, interaction_mode=mode, always_visible=bool(cube))
    made.orientation = turn or Quaternion(w=1.0)
    if cube:
        made.markers = [Marker(type=Marker.CUBE)]
        size, colour = made.markers[0].scale, made.markers[0].color
        size.x = size.y = size.z = cube
        colour.r = colour.g = colour.b = 0.5
        colour.a = 1.0
    return made


def upright() -> Quaternion:
    """Turns x to z: a control that turns about the vertical, or moves on the ground."""
    return Quaternion(w=math.sqrt(0.5), y=-math.sqrt(0.5))

"""Camera (rviz_default_plugins/displays/camera): the picture of a camera, and the scene as that camera sees it."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.displays.image import ImageDisplay
from day6_core.ros.programs.rviz2.model.properties import BOOL, ENUM, Property, floats
from day6_core.ros.programs.rviz2.model.scene import Overlay, Scene, Sight
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN
from day6_core.ros.programs.rviz2.model.topics import FilteredDisplay, all_finite
from day6_core.ros.programs.rviz2.model.views import Camera
from day6_urdf.kinematics import Transform, rotate
from rclpy.qos import qos_profile_sensor_data

BACKGROUND, OVERLAY, BOTH = "background", "overlay", "background and overlay"
CAMERA_INFO = "Camera Info"
"""The status line."""
INFO_TYPE = "sensor_msgs/msg/CameraInfo"


class CameraDisplay(FilteredDisplay, ImageDisplay):
    """Needs `camera_info` beside the image's topic, and the transform of the image's frame."""

    type = "Camera"
    message_type = "sensor_msgs/msg/Image"

    def build(self) -> None:
        super().build()
        # The original's filter always holds ten, and its picture is always normalised.
        self.topic.remove(self.filter_size)
        for each in (self.normalize, self.least, self.most, self.window):
            self.remove(each)
        changed = self.changed
        self.visibility = self.add(Property("Visibility", BOOL, True, on_change=changed), 0)
        self.rendering = self.add(
            Property("Image Rendering", ENUM, BOTH, options=(BACKGROUND, OVERLAY, BOTH), on_change=changed)
        )
        self.alpha = self.add(floats("Overlay Alpha", 0.5, 0, 1, on_change=changed))
        self.zoom = self.add(floats("Zoom Factor", 1, 0.00001, 100000, on_change=changed))
        self.far = self.add(floats("Far Plane Distance", 100, 0.00001, 100000, on_change=changed))
        self._info: Any = None
        self._info_subscription: Any = None
        self._switches: dict[int, Property] = {}
        self._wanted_visible: dict[str, bool] = {}

    # -- messages ------------------------------------------------------------------------------------------------------

    @property
    def info_topic(self) -> str:
        """`camera_info` beside the topic of the image (image_transport's getCameraInfoTopic)."""
        return f"{str(self.topic.value).rpartition('/')[0]}/camera_info"

    def _subscribe(self) -> None:
        from day6_core.interfaces import get_message

        super()._subscribe()
        if self.subscription is None:
            return
        self._no_info()
        self._info_subscription = self.rviz.node.create_subscription(
            get_message(INFO_TYPE), self.info_topic, self._info_came, qos_profile_sensor_data
        )

    def _unsubscribe(self) -> None:
        super()._unsubscribe()
        if self._info_subscription is not None:
            self.rviz.node.destroy_subscription(self._info_subscription)
            self._info_subscription = None

    def _info_came(self, message: Any) -> None:
        self._info = message
        self.rviz.touch()

    def reset(self) -> None:
        super().reset()
        self._info = None
        if self.subscription is not None:
            self._no_info()

    def _no_info(self) -> None:
        self.put_status(WARN, CAMERA_INFO, f"No CameraInfo received on [{self.info_topic}]. Topic may not exist.")

    def show(self, message: Any) -> None:
        self.process(message)

    # -- the picture ---------------------------------------------------------------------------------------------------

    def _sight(self) -> Sight | None:
        """The scene from the camera; None, with a status, while it is not known from where."""
        info, message = self._info, self._message
        if info is None:
            text = f"Expecting Camera Info on topic [{self.info_topic}]. No CameraInfo received. Topic may not exist."
            self.put_status(WARN, CAMERA_INFO, text)
            return None
        if not all_finite([*info.d, *info.k, *info.r, *info.p]):
            self.put_status(ERROR, CAMERA_INFO, "Contains invalid floating point values (nans or infs)")
            return None
        pose = self.place(message.header)
        if pose is None:
            return None
        width, height = info.width or message.width, info.height or message.height
        if not width or not height:
            text = "Could not determine width/height of image due to malformed CameraInfo (either width or height is 0)"
            self.put_status(ERROR, CAMERA_INFO, text)
            return None
        fx, fy, cx, cy = info.p[0], info.p[5], info.p[2], info.p[6]
        if not fx or not fy:
            text = "CameraInfo/P resulted in an invalid position calculation (nans or infs)"
            self.put_status(ERROR, CAMERA_INFO, text)
            return None
        self.put_status(OK, "Time", "ok")
        self.put_status(OK, CAMERA_INFO, "ok")
        zoom = self.zoom.value
        return Sight(
            self._scene(),
            _camera(pose, -info.p[3] / fx, -info.p[7] / fy),
            (fx / width * zoom, fy / height * zoom),
            ((cx / width - 0.5) * zoom, (cy / height - 0.5) * zoom),
            zoom,
            self.far.value,
            self.rendering.value != OVERLAY,
            self.alpha.value if self.rendering.value != BACKGROUND else 0.0,
        )

    def _scene(self) -> Scene:
        """What the other displays show that shall be seen through the camera."""
        scene = Scene(self.rviz.background.value)
        if self.visibility.value:
            for display in self.rviz.displays:
                switch = self._switches.get(id(display))
                if display.enabled and switch is not None and switch.value and not isinstance(display, ImageDisplay):
                    display.draw(scene)
        scene.marks.clear()
        return scene

    def refresh(self) -> None:
        super().refresh()
        self._follow_displays()

    def _follow_displays(self) -> None:
        """One switch for each of the other displays."""
        others = [display for display in self.rviz.displays if display is not self]
        names = [display.name for display in others]
        if [id(display) for display in others] == list(self._switches) and names == [
            each.name for each in self.visibility.children
        ]:
            return
        switches = {}
        for display in others:
            on = self._wanted_visible.get(display.name, True)
            switch = self._switches.get(id(display)) or Property("", BOOL, on, on_change=self.changed)
            switch.name, switch.parent = display.name, self.visibility
            switches[id(display)] = switch
        self._switches, self.visibility.children = switches, list(switches.values())
        self.rviz.tree_changed()

    def load_extras(self, config: dict[str, Any]) -> None:
        waiting = [config.get("Visibility")]
        while waiting:
            saved = waiting.pop()
            for name, on in saved.items() if isinstance(saved, dict) else ():
                self._wanted_visible[str(name)] = bool(on.get("Value", True) if isinstance(on, dict) else on)
                waiting.append(on)

    def save_extras(self) -> dict[str, Any]:
        return {"Visibility": {**self._saved_visible(self.rviz.outermost), "Value": self.visibility.value}}

    def _saved_visible(self, displays: list[Display]) -> dict[str, Any]:
        """What the switches say, a group's with those of its displays (display_group_visibility_property.cpp)."""
        saved: dict[str, Any] = {}
        for display in displays:
            if display is not self:
                switch = self._switches.get(id(display))
                on = bool(switch.value) if switch is not None else self._wanted_visible.get(display.name, True)
                group = display.type == "Group"
                saved[display.name] = {**self._saved_visible(display.displays), "Value": on} if group else on
        return saved

    def draw(self, scene: Scene) -> None:
        if self._overlay is not None and (sight := self._sight()) is not None:
            scene.overlays.append(Overlay(self.name, self._overlay.pixels, sight))


def _camera(pose: Transform, right: float, down: float) -> Camera:
    """A camera in its optical frame (x right, y down, z ahead), moved by metres: the other eye of a pair."""
    x, y, z = (rotate(pose.rotation, axis) for axis in ((1.0, 0.0, 0.0), (0.0, 1.0, 0.0), (0.0, 0.0, 1.0)))
    # The original moves by the axes of its own camera, whose y is up.
    at = tuple(start + right * a - down * b for start, a, b in zip(pose.xyz, x, y, strict=True))
    return Camera((at[0], at[1], at[2]), x, (-y[0], -y[1], -y[2]), z)

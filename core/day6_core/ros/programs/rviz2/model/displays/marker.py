"""Marker and MarkerArray (rviz_default_plugins/displays/marker): shapes that programs publish."""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rviz2.model.displays.marker_shapes import MESH, draw_marker, problem_of
from day6_core.ros.programs.rviz2.model.properties import BOOL, GROUP, Property, pose_lines
from day6_core.ros.programs.rviz2.model.scene import Scene
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN
from day6_core.ros.programs.rviz2.model.topics import (
    FilteredDisplay,
    TopicDisplay,
    all_finite,
    pose_numbers,
    pose_of,
    stamp_ns,
)
from day6_urdf.kinematics import Transform, compose

ADD, DELETE, DELETE_ALL = 0, 2, 3
MOST_MARKERS = 20_000

Key = tuple[str, int]


class _Marker:
    """One marker: its message, its frame's pose, when it ends."""

    def __init__(self, message: Any, now_ns: int) -> None:
        self.message = message
        self.frame: Transform | None = None
        self.mesh: Any = None
        lifetime = stamp_ns(message.lifetime)
        self.ends_ns = now_ns + lifetime if lifetime > 100_000 else None


class Markers:
    """What Marker and MarkerArray have in common (marker_common.cpp)."""

    def __init__(self, display: Any) -> None:
        self.display = display
        self.namespaces = display.add(Property("Namespaces", GROUP))
        self._switches: dict[str, Property] = {}
        self.wanted: dict[str, bool] = {}
        self._markers: dict[Key, _Marker] = {}
        self._meshes: dict[tuple[str, bool], Any] = {}
        """By URI, and whether it came from this machine."""

    # -- messages ------------------------------------------------------------------------------------------------------

    def take_array(self, message: Any) -> None:
        """A message of many markers."""
        seen: set[Key] = set()
        twice: Key | None = None
        for marker in message.markers:
            key = (marker.ns, marker.id)
            twice = key if twice is None and key in seen else twice
            seen.add(key)
            self.take(marker)
        if twice is not None:
            text = "Multiple Markers in the same MarkerArray message had the same ns and id: "
            self.display.put_status(ERROR, "Duplicate Marker Check", f"{text}({twice[0]}, {twice[1]})")
        else:
            self.display.drop_status("Duplicate Marker Check")

    def take(self, marker: Any) -> None:
        """One marker."""
        key = (marker.ns, marker.id)
        numbers = [*pose_numbers(marker.pose), marker.scale.x, marker.scale.y, marker.scale.z]
        numbers += [marker.color.r, marker.color.g, marker.color.b, marker.color.a]
        numbers += [part for point in marker.points for part in (point.x, point.y, point.z)]
        if not all_finite(numbers):
            self._set_status(key, ERROR, "Contains invalid floating point values (nans or infs)")
        elif marker.action == ADD:
            self._add(key, marker)
        elif marker.action == DELETE:
            self._delete(key)
        elif marker.action == DELETE_ALL:
            for each in [each for each in self._markers if not marker.ns or each[0] == marker.ns]:
                self._delete(each)
        else:
            self.display.rviz.log_error(f"Unknown marker action: {marker.action}")

    def _add(self, key: Key, marker: Any) -> None:
        if not self._switch(marker.ns).value:
            return
        self.display.drop_status(_line(key))
        if key not in self._markers and len(self._markers) >= MOST_MARKERS:
            del self._markers[next(iter(self._markers))]
        entry = self._markers[key] = _Marker(marker, self.display.rviz.timer_ns())
        self._place(key, entry)
        if marker.type == MESH:
            self._read_mesh(key, entry)
        if problem := problem_of(marker):
            self._set_status(key, WARN if problem.startswith("Scale") else ERROR, problem)

    def _read_mesh(self, key: Key, entry: _Marker) -> None:
        rviz, uri = self.display.rviz, entry.message.mesh_resource
        trusted = rviz.is_of_this_machine(self.display.sender)
        if (uri, trusted) in self._meshes:
            self._mesh_is_here(key, entry, self._meshes[uri, trusted])
            return

        def done(mesh: Any) -> None:
            self._meshes[uri, trusted] = mesh
            self._mesh_is_here(key, entry, mesh)

        rviz.read_mesh(uri, trusted, done)

    def _mesh_is_here(self, key: Key, entry: _Marker, mesh: Any) -> None:
        entry.mesh = mesh
        if mesh is None and self._markers.get(key) is entry:
            name, uri = _line(key), entry.message.mesh_resource
            self._set_status(key, ERROR, f"Mesh resource marker [{name}] could not load [{uri}]")

    def _place(self, key: Key, entry: _Marker) -> None:
        frames = self.display.rviz.frames
        header = entry.message.header
        stamp = 0 if entry.message.frame_locked else stamp_ns(header.stamp)
        entry.frame = frames.pose(header.frame_id, stamp)
        if entry.frame is None:
            self._set_status(key, ERROR, frames.transform_problem(header.frame_id, stamp_ns(header.stamp)) or "")

    def _delete(self, key: Key) -> None:
        self.display.drop_status(_line(key))
        self._markers.pop(key, None)

    def _set_status(self, key: Key, level: int, text: str) -> None:
        self.display.put_status(level, _line(key), text)

    # -- namespaces ----------------------------------------------------------------------------------------------------

    def _switch(self, name: str) -> Property:
        if name not in self._switches:
            switch = Property(name, BOOL, self.wanted.get(name, True), on_change=lambda: self._switched(name))
            self._switches[name] = switch
            self.namespaces.add(switch)
            self.display.rviz.tree_changed()
        return self._switches[name]

    def _switched(self, name: str) -> None:
        self.wanted[name] = on = bool(self._switches[name].value)
        if not on:
            for key in [key for key in self._markers if key[0] == name]:
                self._delete(key)
        self.display.changed()

    # -- pictures ------------------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        """Let old markers end, and those move that are locked to their frames."""
        now_ns = self.display.rviz.timer_ns()
        for key, entry in list(self._markers.items()):
            if entry.ends_ns is not None and now_ns >= entry.ends_ns:
                self._delete(key)
            elif entry.message.frame_locked:
                self._place(key, entry)

    @property
    def mortal(self) -> bool:
        """Whether one of them ends by itself."""
        return any(entry.ends_ns is not None for entry in self._markers.values())

    def draw(self, scene: Scene) -> None:
        for key, entry in self._markers.items():
            if entry.frame is not None:
                scene.begin(self.display, key)
                draw_marker(scene, entry.message, entry.frame, entry.mesh)

    def describe(self, key: Key) -> tuple[str, list[Property]] | None:
        """What the panel Selection says of a marker."""
        entry = self._markers.get(key)
        if entry is None or entry.frame is None:
            return None
        pose = compose(entry.frame, pose_of(entry.message.pose))
        return f"Marker {_line(key)}", pose_lines(pose.xyz, pose.rotation)

    def clear(self) -> None:
        self._markers.clear()
        self._switches.clear()
        self.namespaces.children = []


def _line(key: Key) -> str:
    return f"{key[0]}/{key[1]}"


class _MarkerDisplay(TopicDisplay):
    """A display of markers, however they come."""

    asks_who_sent = True
    selectable = True

    def build(self) -> None:
        super().build()
        self.markers = Markers(self)

    def reset(self) -> None:
        super().reset()
        self.markers.clear()

    def refresh(self) -> None:
        super().refresh()
        self.markers.refresh()

    @property
    def fading(self) -> bool:
        return self.markers.mortal

    def draw(self, scene: Scene) -> None:
        self.markers.draw(scene)

    def describe(self, key: Key) -> tuple[str, list[Property]] | None:
        return self.markers.describe(key)

    def save_extras(self) -> dict[str, Any]:
        return {"Namespaces": {each.name: each.value for each in self.markers.namespaces.children}}

    def load_extras(self, config: dict[str, Any]) -> None:
        saved = config.get("Namespaces")
        for name, on in saved.items() if isinstance(saved, dict) else ():
            self.markers.wanted[str(name)] = bool(on)


class MarkerDisplay(_MarkerDisplay, FilteredDisplay):
    """Markers one by one; `<topic>_array` is heard too."""

    type = "Marker"
    message_type = "visualization_msgs/msg/Marker"
    default_topic = "visualization_marker"

    def build(self) -> None:
        super().build()
        self._array: Any = None

    def _subscribe(self) -> None:
        super()._subscribe()
        if self.topic.value:
            topic, kind = f"{self.topic.value}_array", "visualization_msgs/msg/MarkerArray"
            self._array = self._try_to_subscribe(topic, kind, self._array_came, "Array Topic")
            if self._array is not None:
                self.put_status(OK, "Array Topic", "OK")

    def _array_came(self, message: Any) -> None:
        self.markers.take_array(message)
        self.rviz.touch()

    def _unsubscribe(self) -> None:
        super()._unsubscribe()
        if self._array is not None:
            self.rviz.node.destroy_subscription(self._array)
            self._array = None

    def show(self, message: Any) -> None:
        self.markers.take(message)


class MarkerArrayDisplay(_MarkerDisplay):
    """Markers by the array."""

    type = "MarkerArray"
    message_type = "visualization_msgs/msg/MarkerArray"
    default_topic = "visualization_marker_array"

    def process(self, message: Any) -> None:
        self.markers.take_array(message)

"""InteractiveMarkers (rviz_default_plugins/displays/interactive_markers): things of a server that mouse and keys move.

The server's topics are `update` and `feedback` below its namespace, its service is `get_interactive_markers`.
"""

from __future__ import annotations

from typing import Any

from day6_core.ros.programs.rclcpp import CppException
from day6_core.ros.programs.rviz2.model.display import Display
from day6_core.ros.programs.rviz2.model.displays.control_keys import Steps
from day6_core.ros.programs.rviz2.model.displays.interactive_marker import InteractiveMarker
from day6_core.ros.programs.rviz2.model.properties import BOOL, TEXT, Property
from day6_core.ros.programs.rviz2.model.scene import Scene, placed
from day6_core.ros.programs.rviz2.model.status import ERROR, OK, WARN
from day6_core.ros.programs.rviz2.model.tools.tool import Pointer
from day6_core.ros.programs.rviz2.model.topics import all_finite, pose_numbers, stamp_ns
from day6_urdf.kinematics import IDENTITY
from day6_urdf.model import Vector
from rclpy.qos import QoSProfile

CLIENT = "Interactive Marker Client"
"""The status line."""
IDLE, INITIALIZE, RUNNING = range(3)
QUEUE = 100
TIMEOUT_NS = 1_000_000_000
"""After which the markers are asked for again."""
PACKAGE = "visualization_msgs"


class InteractiveMarkersDisplay(Display):
    """Connects to one server (interactive_marker_client.cpp)."""

    type = "InteractiveMarkers"
    message_type = "visualization_msgs/msg/InteractiveMarkerUpdate"

    def build(self) -> None:
        changed = self.changed
        self.namespace = self.add(Property("Interactive Markers Namespace", TEXT, "", on_change=changed))
        self.descriptions = self.add(Property("Show Descriptions", BOOL, True, on_change=changed))
        self.axes = self.add(Property("Show Axes", BOOL, False, on_change=changed))
        self.aids = self.add(Property("Show Visual Aids", BOOL, False, on_change=changed))
        self.transparent = self.add(Property("Enable Transparency", BOOL, True, on_change=changed))
        self.markers: dict[str, InteractiveMarker] = {}
        self._connected: tuple[Any, ...] = ()
        self._state = IDLE
        self._client: Any = None
        self._publisher: Any = None
        self._subscription: Any = None
        self._response: Any = None
        self._asked = 0
        """The number of the newest request; answers to older ones are ignored."""
        self._asked_ns = 0
        self._updates: list[Any] = []
        self._last_update: int | None = None
        self._meshes: dict[str, Any] = {}
        self._held: InteractiveMarker | None = None
        self.lights: dict[Any, float] = {}
        """Marker and control -> how much brighter it is drawn, as one in use."""

    def choose_topic(self, topic: str) -> None:
        """Add by topic: the namespace is the first part of `/namespace/update`."""
        end = topic.find("/", 1)
        self.namespace.set(topic if end < 0 else topic[:end])

    # -- connecting ----------------------------------------------------------------------------------------------------

    def on_enable(self) -> None:
        self._connect()

    def on_disable(self) -> None:
        self._disconnect()

    def on_fixed_frame(self) -> None:
        self.reset()

    def reset(self) -> None:
        super().reset()
        self._disconnect()
        self._connect()

    def _wanted(self) -> tuple[Any, ...]:
        return self.namespace.value, self.transparent.value

    def _connect(self) -> None:
        from day6_core.interfaces import get_message, get_service

        self._connected = self._wanted()
        namespace = self.namespace.value
        if not namespace:
            self.put_status(ERROR, CLIENT, "Error connecting: empty namespace")
            return
        node = self.rviz.node
        try:
            self._client = node.create_client(
                get_service(f"{PACKAGE}/srv/GetInteractiveMarkers"), f"{namespace}/get_interactive_markers"
            )
            self._publisher = node.create_publisher(
                get_message(f"{PACKAGE}/msg/InteractiveMarkerFeedback"),
                f"{namespace}/feedback",
                QoSProfile(depth=QUEUE),
            )
            self._subscription = node.create_subscription(
                get_message(self.message_type), f"{namespace}/update", self._update_came, QoSProfile(depth=QUEUE)
            )
        except CppException as error:
            self._disconnect()
            self._say(ERROR, f"Failed to connect: {error}")
            return
        self._say(OK, f"Connected on namespace: {namespace}")

    def _disconnect(self) -> None:
        node = self.rviz.node
        if self._client is not None:
            node.destroy_client(self._client)
        if self._publisher is not None:
            node.destroy_publisher(self._publisher)
        if self._subscription is not None:
            node.destroy_subscription(self._subscription)
        self._client = self._publisher = self._subscription = None
        self._forget()

    def _forget(self) -> None:
        """Back to the beginning: the server is asked anew."""
        self._state = IDLE
        self._asked += 1
        self._response = self._last_update = self._held = None
        self._updates.clear()
        self._erase_all()

    def _erase_all(self) -> None:
        self.markers.clear()
        self.drop_status(CLIENT)

    def _say(self, level: int, text: str) -> None:
        if level == WARN:
            self.rviz.node.get_logger().warning(text)
        elif level == ERROR:
            self.rviz.log_error(text)
        self.put_status(level, CLIENT, text)

    def _ask(self) -> None:
        self._asked += 1
        number = self._asked
        self._asked_ns = self.rviz.timer_ns()
        self._say(OK, "Sending request for interactive markers")

        def answered(future: Any) -> None:
            if number == self._asked and future.exception() is None:
                self._response = future.result()
                self._say(OK, "Service response received for initialization")
                self.rviz.touch()

        request = self._client.srv_type.Request()
        self._client.call_async(request).add_done_callback(answered)

    def _update_came(self, message: Any) -> None:
        if message.type == message.KEEP_ALIVE:
            return
        if self._last_update is not None and message.seq_num != self._last_update + 1:
            expected = self._last_update + 1
            text = f"Update sequence number is out of order. {expected} (expected) vs. {message.seq_num} (received)"
            self._say(WARN, text)
            self._forget()
        else:
            self._last_update = message.seq_num
            self._updates.append(message)
            del self._updates[:-QUEUE]
        self.rviz.touch()

    # -- what the server says ------------------------------------------------------------------------------------------

    def refresh(self) -> None:
        if self._connected != self._wanted():
            self.reset()
        if self._client is None:
            return
        ready = self._client.service_is_ready()
        if self._state == IDLE and ready:
            self._state = INITIALIZE
            self._ask()
        elif self._state == INITIALIZE:
            self._initialize(ready)
        elif self._state == RUNNING:
            if not ready:
                self._say(WARN, "Server not available while running, resetting")
                self._forget()
            else:
                self._push_updates()
        for marker in self.markers.values():
            if marker.locked:
                marker.follow()

    def _initialize(self, ready: bool) -> None:
        if not ready:
            self._say(WARN, "Server not available during initialization, resetting")
            self._forget()
        elif self._response is None:
            if self.rviz.timer_ns() - self._asked_ns > TIMEOUT_NS:
                self._say(WARN, "Did not receive response with interactive markers, resending request...")
                self._ask()
        elif not self._known(self._response.markers):
            self.put_status(OK, CLIENT, "Initialization: Waiting for TF info")
        else:
            self._erase_all()
            self._updates = [each for each in self._updates if each.seq_num > self._response.sequence_number]
            self._state = RUNNING
            self.put_status(OK, CLIENT, f"Change state to: {RUNNING}")
            self._take_markers(self._response.markers)
            self._push_updates()

    def _known(self, messages: list[Any]) -> bool:
        """Whether the frames of messages with a time are known at that time."""
        frames = self.rviz.frames
        return all(
            stamp_ns(each.header.stamp) == 0
            or frames.pose(each.header.frame_id, stamp_ns(each.header.stamp)) is not None
            for each in messages
        )

    def _push_updates(self) -> None:
        while self._state == RUNNING and self._updates:
            update = self._updates[0]
            if not self._known([*update.markers, *update.poses]):
                return
            self._updates.pop(0)
            self.put_status(OK, CLIENT, f"Pushing update with sequence number {update.seq_num}")
            self._take_markers(update.markers)
            self._take_poses(update.poses)
            for name in update.erases:
                self.markers.pop(name, None)
                self.drop_status(name)

    def _take_markers(self, messages: list[Any]) -> None:
        for message in messages:
            if not all_finite(_numbers(message)):
                self.put_status(ERROR, message.name, "Marker contains invalid floats!")
            elif not message.controls:
                self.put_status(OK, message.name, "Marker empty.")
                self._give_up()
                return
            elif message.name in self.markers:
                self.markers[message.name].take(message)
            else:
                self.markers[message.name] = InteractiveMarker(self, message)

    def _take_poses(self, messages: list[Any]) -> None:
        for message in messages:
            if not all_finite(pose_numbers(message.pose)):
                self.put_status(ERROR, message.name, "Pose message contains invalid floats!")
                return
            if message.name not in self.markers:
                self._give_up()
                text = f"Pose received for non-existing marker '{message.name}"
                self.put_status(ERROR, message.name, text)
                return
            self.markers[message.name].take_pose(message)

    def _give_up(self) -> None:
        """The original disconnects from a server that it does not understand."""
        self._disconnect()

    # -- pictures and the mouse ----------------------------------------------------------------------------------------

    @property
    def fading(self) -> bool:
        """Controls that face the view follow it."""
        return any(marker.turns_with_view for marker in self.markers.values())

    def draw(self, scene: Scene) -> None:
        for marker in self.markers.values():
            marker.draw(scene, self.rviz.interaction, bool(self.descriptions.value), bool(self.axes.value))

    def mesh(self, marker: Any) -> Any:
        """The mesh of a marker, None until it is read."""
        uri = marker.mesh_resource
        if uri not in self._meshes:
            self._meshes[uri] = None
            self.rviz.read_mesh(uri, False, lambda mesh: self._meshes.__setitem__(uri, mesh))
        return self._meshes[uri]

    def mode_of(self, key: Any) -> int | None:
        """The interaction mode of a control; None if it is gone."""
        marker = self.markers.get(key[0])
        control = marker.control(key[1]) if marker is not None else None
        return int(control.interaction_mode) if control is not None else None

    def has_menu(self, key: Any) -> bool:
        """Whether the marker of a control has a menu."""
        marker = self.markers.get(key[0])
        return marker is not None and bool(marker.choices)

    def words_of(self, key: Any) -> str:
        """What the status bar says of a control."""
        marker = self.markers.get(key[0])
        control = marker.control(key[1]) if marker is not None else None
        return marker.words(control) if marker is not None and control is not None else ""

    def controls(self) -> list[tuple[str, str]]:
        """Marker and name of every control that can be used; any thread."""
        shown = [(name, marker) for name, marker in list(self.markers.items()) if marker.reference is not None]
        return [(name, control) for name, marker in shown for control in marker.touchable()]

    def place_of(self, key: Any) -> Vector:
        """Where a control is seen, in the Fixed Frame: something of it that is drawn, or the marker's origin."""
        for mark, part in self.rviz.scene.parts():
            if mark.owner is self and mark.key == key and (point := part.some_point()) is not None:
                return point
        marker = self.markers.get(key[0])
        return placed(marker.reference or IDENTITY, marker.pose.xyz) if marker is not None else (0.0, 0.0, 0.0)

    def press(self, key: Any, pointer: Pointer) -> None:
        """The left button went down on a control: marker and name."""
        self._held = self.markers.get(key[0])
        if self._held is not None:
            self._held.press(key[1], pointer)

    def open_menu(self, key: Any, pointer: Pointer) -> None:
        """The right button went down on a control."""
        if (marker := self.markers.get(key[0])) is not None:
            marker.open_menu(key[1], pointer)

    def drag(self, pointer: Pointer) -> None:
        if self._held is not None:
            self._held.drag(pointer)

    def wheel(self, notches: float) -> None:
        if self._held is not None:
            self._held.wheel(notches)

    def step(self, steps: Steps, turning: bool) -> None:
        if self._held is not None:
            self._held.step(steps, turning)

    def release(self, pointer: Pointer) -> None:
        if self._held is not None:
            self._held.release(pointer)
            self._held = None

    def send(self, feedback: Any) -> None:
        """Publish feedback in this RViz's name."""
        if self._publisher is not None:
            feedback.client_id = self.rviz.node.get_fully_qualified_name()
            self._publisher.publish(feedback)


def _numbers(message: Any) -> list[float]:
    numbers = [*pose_numbers(message.pose), message.scale]
    for control in message.controls:
        turn = control.orientation
        numbers += [turn.x, turn.y, turn.z, turn.w]
        for marker in control.markers:
            numbers += [*pose_numbers(marker.pose), marker.scale.x, marker.scale.y, marker.scale.z]
            numbers += [marker.color.r, marker.color.g, marker.color.b, marker.color.a]
            numbers += [part for point in marker.points for part in (point.x, point.y, point.z)]
    return numbers

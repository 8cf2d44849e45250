"""The server of interactive markers (interactive_markers 2.5.4): its topics `update` and `feedback`, and its service."""

from __future__ import annotations

from collections.abc import Callable
from dataclasses import dataclass, field
from threading import Lock
from typing import TYPE_CHECKING, Any

from builtin_interfaces.msg import Time
from geometry_msgs.msg import Pose
from std_msgs.msg import Header
from visualization_msgs.msg import (
    InteractiveMarker,
    InteractiveMarkerFeedback,
    InteractiveMarkerPose,
    InteractiveMarkerUpdate,
)
from visualization_msgs.srv import GetInteractiveMarkers

from rclpy.duration import Duration
from rclpy.qos import QoSProfile
from rclpy.time import Time as RclpyTime

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.publisher import Publisher
    from rclpy.service import Service
    from rclpy.subscription import Subscription

FeedbackCallback = Callable[[InteractiveMarkerFeedback], object]


@dataclass
class _Callbacks:
    """Who hears of feedback: callbacks by the type of event, and one for all other types."""

    default: FeedbackCallback | None = None
    by_type: dict[int, FeedbackCallback] = field(default_factory=dict)

    def put(self, callback: FeedbackCallback | None, event_type: int) -> None:
        """Set or, with None, take away one of them."""
        if event_type == InteractiveMarkerServer.DEFAULT_FEEDBACK_CALLBACK:
            self.default = callback
        elif callback is not None:
            self.by_type[event_type] = callback
        else:
            self.by_type.pop(event_type, None)


@dataclass
class MarkerContext:
    """A marker that clients know, and the client that moved it last."""

    last_feedback: RclpyTime
    int_marker: InteractiveMarker
    callbacks: _Callbacks
    last_client_id: str = ""


@dataclass
class UpdateContext:
    """What clients shall be told of a marker."""

    FULL_UPDATE = 0
    POSE_UPDATE = 1
    ERASE = 2

    update_type: int = FULL_UPDATE
    int_marker: InteractiveMarker = field(default_factory=InteractiveMarker)
    callbacks: _Callbacks = field(default_factory=_Callbacks)


class InteractiveMarkerServer:
    """Shows markers to clients such as RViz, and tells the program what people do with them.

    What `insert`, `setPose`, `erase` and `clear` change comes to the clients with `applyChanges`.
    """

    DEFAULT_FEEDBACK_CALLBACK = 255

    def __init__(
        self,
        node: Node,
        namespace: str,
        *,
        update_pub_qos: QoSProfile | None = None,
        feedback_sub_qos: QoSProfile | None = None,
    ) -> None:
        """Open the topics `namespace/update` (depth 100) and `namespace/feedback` (depth 1), and the service."""
        self.node = node
        self.namespace = namespace
        self.seq_num = 0
        self.mutex = Lock()
        self.marker_contexts: dict[str, MarkerContext] = {}
        self.pending_updates: dict[str, UpdateContext] = {}
        self.get_interactive_markers_srv: Service[Any, Any] | None = None
        self.update_pub: Publisher[InteractiveMarkerUpdate] | None = None
        self.feedback_sub: Subscription[InteractiveMarkerFeedback] | None = None
        self.get_interactive_markers_srv = node.create_service(
            GetInteractiveMarkers, f"{namespace}/get_interactive_markers", self.getInteractiveMarkersCallback
        )
        self.update_pub = node.create_publisher(
            InteractiveMarkerUpdate, f"{namespace}/update", update_pub_qos or QoSProfile(depth=100)
        )
        self.feedback_sub = node.create_subscription(
            InteractiveMarkerFeedback,
            f"{namespace}/feedback",
            self.processFeedback,
            feedback_sub_qos or QoSProfile(depth=1),
        )

    def shutdown(self) -> None:
        """Take all markers away from the clients, and close topics and service; call it before the node is destroyed."""
        if self.update_pub is not None and self.node.context.ok():
            self.clear()
            self.applyChanges()
        if self.get_interactive_markers_srv is not None:
            self.node.destroy_service(self.get_interactive_markers_srv)
            self.get_interactive_markers_srv = None
        if self.update_pub is not None:
            self.node.destroy_publisher(self.update_pub)
            self.update_pub = None
        if self.feedback_sub is not None:
            self.node.destroy_subscription(self.feedback_sub)
            self.feedback_sub = None

    def __del__(self) -> None:
        self.shutdown()

    # -- changes, until the next applyChanges ----------------------------------------------------------------------------

    def insert(
        self,
        marker: InteractiveMarker,
        *,
        feedback_callback: FeedbackCallback | None = None,
        feedback_type: int = DEFAULT_FEEDBACK_CALLBACK,
    ) -> None:
        """Add a marker, or replace the one of its name; the callback counts at once."""
        with self.mutex:
            update = self.pending_updates.setdefault(marker.name, UpdateContext())
            update.update_type, update.int_marker = UpdateContext.FULL_UPDATE, marker
        if feedback_callback is not None:
            self.setCallback(marker.name, feedback_callback, feedback_type)

    def setPose(self, name: str, pose: Pose, header: Header | None = None) -> bool:
        """Move a marker; without a frame in `header` it stays in its own. False if there is none that clients know."""
        with self.mutex:
            context, update = self.marker_contexts.get(name), self.pending_updates.get(name)
            if context is None or (update is not None and update.update_type == UpdateContext.FULL_UPDATE):
                return False
            self.doSetPose(update, name, pose, header if header and header.frame_id else context.int_marker.header)
            return True

    def erase(self, name: str) -> bool:
        """Take a marker away; False if there is none."""
        with self.mutex:
            if name not in self.pending_updates and name not in self.marker_contexts:
                return False
            self.pending_updates.setdefault(name, UpdateContext()).update_type = UpdateContext.ERASE
            return True

    def clear(self) -> None:
        """Take all markers away."""
        self.pending_updates = {}
        for name in self.marker_contexts:
            self.erase(name)

    def setCallback(
        self, name: str, feedback_callback: FeedbackCallback | None, feedback_type: int = DEFAULT_FEEDBACK_CALLBACK
    ) -> bool:
        """Say who hears of feedback of a type, or of every type that nobody else hears of; False if there is no such marker.

        None takes a callback away. It counts at once.
        """
        with self.mutex:
            holders = [self.marker_contexts.get(name), self.pending_updates.get(name)]
            for holder in holders:
                if holder is not None:
                    holder.callbacks.put(feedback_callback, feedback_type)
            return any(holder is not None for holder in holders)

    def applyChanges(self) -> None:
        """Let the clients know what changed since the last call."""
        with self.mutex:
            if not self.pending_updates:
                return
            message = InteractiveMarkerUpdate(type=InteractiveMarkerUpdate.UPDATE)
            for name, update in self.pending_updates.items():
                self._apply(name, update, message)
            self.pending_updates = {}
        self.seq_num += 1
        self.publish(message)

    def _apply(self, name: str, update: UpdateContext, message: InteractiveMarkerUpdate) -> None:
        context = self.marker_contexts.get(name)
        if update.update_type == UpdateContext.FULL_UPDATE:
            if context is None:
                now = self.node.get_clock().now()
                self.marker_contexts[name] = MarkerContext(now, update.int_marker, update.callbacks)
            else:
                context.int_marker = update.int_marker
            message.markers.append(update.int_marker)
        elif context is not None and update.update_type == UpdateContext.POSE_UPDATE:
            marker = context.int_marker
            marker.pose, marker.header = update.int_marker.pose, update.int_marker.header
            message.poses.append(InteractiveMarkerPose(header=marker.header, pose=marker.pose, name=marker.name))
        elif context is not None:
            del self.marker_contexts[name]
            message.erases.append(name)

    def get(self, name: str) -> InteractiveMarker | None:
        """The marker of a name, as it will be after the next `applyChanges`; None if there will be none."""
        context, update = self.marker_contexts.get(name), self.pending_updates.get(name)
        if update is None:
            return context.int_marker if context is not None else None
        if update.update_type == UpdateContext.FULL_UPDATE:
            return update.int_marker
        if update.update_type == UpdateContext.ERASE or context is None:
            return None
        context.int_marker.pose = update.int_marker.pose
        return context.int_marker

    # -- what clients say ------------------------------------------------------------------------------------------------

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Move the marker as a client says, call the callback, and apply the changes.

        Who moved a marker has it for a second: feedback of another client is ignored so long.
        """
        with self.mutex:
            context = self.marker_contexts.get(feedback.marker_name)
            if context is None:
                return
            now = self.node.get_clock().now()
            other = context.last_client_id != feedback.client_id
            if other and now - context.last_feedback < Duration(seconds=1.0):
                self.node.get_logger().debug(
                    f"Rejecting feedback for '{feedback.marker_name}': conflicting feedback from separate clients"
                )
                return
            context.last_feedback, context.last_client_id = now, feedback.client_id
            if feedback.event_type == InteractiveMarkerFeedback.POSE_UPDATE:
                own = context.int_marker.header
                header = own if own.stamp == Time() else feedback.header
                update = self.pending_updates.get(feedback.marker_name)
                self.doSetPose(update, feedback.marker_name, feedback.pose, header)
        callback = context.callbacks.by_type.get(feedback.event_type, context.callbacks.default)
        if callback is not None:
            callback(feedback)
        self.applyChanges()

    def getInteractiveMarkersCallback(
        self, request: GetInteractiveMarkers.Request, response: GetInteractiveMarkers.Response
    ) -> GetInteractiveMarkers.Response:
        """Tell a client that comes all markers there are."""
        with self.mutex:
            response.sequence_number = self.seq_num
            response.markers = [context.int_marker for context in self.marker_contexts.values()]
            return response

    def publish(self, update: InteractiveMarkerUpdate) -> None:
        """Send an update with the present number."""
        update.seq_num = self.seq_num
        if self.update_pub is not None:
            self.update_pub.publish(update)

    def doSetPose(self, update: UpdateContext | None, name: str, pose: Pose, header: Header) -> None:
        """Note a new pose for the next `applyChanges`; the caller holds the mutex."""
        if update is None:
            update = self.pending_updates[name] = UpdateContext(UpdateContext.POSE_UPDATE)
        elif update.update_type != UpdateContext.FULL_UPDATE:
            update.update_type = UpdateContext.POSE_UPDATE
        update.int_marker.pose, update.int_marker.header = pose, header

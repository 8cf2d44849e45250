"""The recorder without any waiting: `ros2 bag record` and `Recorder` call `poll` regularly."""

from __future__ import annotations

import time
from typing import TYPE_CHECKING, Any, Protocol

from rosbag2_interfaces.msg import WriteSplitEvent
from rosbag2_interfaces.srv import IsPaused, Pause, Resume, Snapshot

from day6_core.interfaces import type_name
from day6_core.ros.differences import value
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rosbag2_py._compression import CompressionOptions, compression_mode_from_string
from rosbag2_py._console import Log, to_console
from rosbag2_py._options import RecordOptions
from rosbag2_py._qos import from_rclpy
from rosbag2_py._storage import ConverterOptions, StorageOptions, TopicMetadata
from rosbag2_py._topic_filter import TopicFilter
from rosbag2_py._writer import FLUSH_SECONDS, SequentialCompressionWriter, SequentialWriter

if TYPE_CHECKING:
    from collections.abc import Callable

    from rclpy.node import Node
    from rclpy.subscription import MessageInfo, Subscription
    from rclpy.topic_endpoint_info import TopicEndpointInfo

NODE_NAME = "rosbag2_recorder"
DEPTH = 1000
"""Messages of one topic that may wait to be written; the real one has 10 and a thread for receiving."""


class RecordingHost(Protocol):
    """A program with a node of its own that records beside other things: then nobody controls the recording by services."""

    def received(self, topic: str, received_ns: int) -> None:
        """A message was written."""

    def failed(self, error: OSError) -> None:
        """A message could not be written: the disk is full, or the folder is gone."""


class Recording:
    """Records topics on `node`: call `start`, then `poll` at every polling interval, finally `stop`.

    `start` raises RuntimeError if the bag can't be created. `keyboard`: whether keys can control it.
    """

    def __init__(
        self,
        node: Node,
        storage: StorageOptions,
        options: RecordOptions,
        *,
        keyboard: bool,
        host: RecordingHost | None = None,
        log: Log = to_console,
    ) -> None:
        self._node = node
        self._host = host
        self.types: dict[str, str] = {}
        """The types of the recorded topics, by name."""
        self._storage = storage
        self._options = options
        self._log = node.get_logger()
        self._subscriptions: dict[str, Subscription[Any]] = {}
        self._warned: set[str] = set()
        self.paused = options.start_paused
        self.recording = False
        self._discovering = True
        self._waits_for_clock = options.use_sim_time
        if options.use_sim_time and options.is_discovery_disabled:
            raise RuntimeError(
                "use_sim_time and is_discovery_disabled both set, but are incompatible settings. "
                "The /clock topic needs to be discovered to record with sim time."
            )
        for name in ("topics", "exclude_topics", "services", "exclude_service_events"):
            setattr(options, name, [self._full(topic) for topic in getattr(options, name)])
        self._filter = TopicFilter(options, node, self._log.warning)
        if keyboard:
            self._log.info("Press SPACE for pausing/resuming")
        self._writer = self._make_writer(log)

    def _full(self, topic: str) -> str:
        from rclpy.expand_topic_name import expand_topic_name

        return expand_topic_name(topic, self._node.get_name(), self._node.get_namespace())

    def _make_writer(self, log: Log) -> SequentialWriter:
        options = self._options
        mode = compression_mode_from_string(options.compression_mode)
        if not mode:
            return SequentialWriter(log)
        return SequentialCompressionWriter(CompressionOptions(options.compression_format or "zstd", mode), log)

    # -- start and stop ------------------------------------------------------------------------------------------------

    def start(self) -> None:
        """Create the bag and the services, and subscribe to the present topics."""
        self._writer.open(self._storage, ConverterOptions("cdr", "cdr"))
        bag = self._writer._opened()
        if self._host is None:
            bag.on_split = self._on_split
        self.recording = True
        if self._host is None:
            self._offer_services(self._node)
            self._log.info("Event publisher thread: Starting")
        self._log.info("Listening for topics...")
        if self._options.use_sim_time:
            self._log.info("use_sim_time set, waiting for /clock before starting recording...")
        else:
            self._subscribe()
        if self._options.is_discovery_disabled:
            self._discovering = False
        waits = f"{value('bag.recorder_waits')}: Press SPACE to start."
        self._log.info(waits if self.paused else "Recording...")
        self._flushed = time.monotonic()

    def _offer_services(self, node: Node) -> None:
        if self._storage.snapshot_mode:
            node.create_service(Snapshot, "~/snapshot", self._snapshot)
        if value("bag.recorder_can_pause"):
            from rosbag2_interfaces.srv import SplitBagfile

            node.create_service(SplitBagfile, "~/split_bagfile", self._split)
            node.create_service(Pause, "~/pause", self._callback(self.pause))
            node.create_service(Resume, "~/resume", self._callback(self.resume))
            node.create_service(IsPaused, "~/is_paused", self._is_paused)
        self._splits = node.create_publisher(WriteSplitEvent, "events/write_split", 1)

    def poll(self) -> None:
        """Look for new topics, and flush received messages to the disk."""
        if self._waits_for_clock:
            if self._node.get_clock().now().nanoseconds == 0:
                return
            self._waits_for_clock = False
            self._log.info("Sim time /clock found, starting recording.")
        if self._discovering:
            self._discover()
        if time.monotonic() - self._flushed > FLUSH_SECONDS:
            self._flushed = time.monotonic()
            self._writer.flush()

    def stop(self) -> None:
        """Finish the bag; a second call does nothing."""
        if not self.recording:
            return
        self.recording = False
        if value("bag.recorder_logs_pause_at_end"):
            self.pause()
        self.paused = True
        for subscription in self._subscriptions.values():
            self._node.destroy_subscription(subscription)
        self._subscriptions.clear()
        self._writer.close()
        if self._host is None:
            self._log.info("Event publisher thread: Exiting")
        self._log.info("Recording stopped")

    # -- topics --------------------------------------------------------------------------------------------------------

    def _discover(self) -> None:
        for topic in list(self._subscriptions):
            self._warn_of_new_qos(topic)
        self._subscribe()
        if self._options.topics and len(self._subscriptions) == len(self._options.topics):
            self._discovering = False
            self._log.info("All requested topics are subscribed. Stopping discovery...")

    def _subscribe(self) -> None:
        for topic, kind in self._filter.wanted().items():
            if topic not in self._subscriptions:
                self._take(topic, kind)

    def _take(self, topic: str, kind: type[Any]) -> None:
        offers = self._node.get_publishers_info_by_topic(topic)
        hashes = {str(offer.topic_type_hash) for offer in offers}
        metadata = TopicMetadata(
            id=0,
            name=topic,
            type=type_name(kind),
            serialization_format="cdr",
            offered_qos_profiles=[from_rclpy(offer.qos_profile) for offer in offers],
            type_description_hash=hashes.pop() if len(hashes) == 1 else "",
        )
        self._writer.create_topic(metadata)
        write, clock = self._writer.write, self._node.get_clock()
        simulated, host = self._options.use_sim_time, self._host

        def receive(data: bytes, info: MessageInfo) -> None:
            if self.paused:
                return
            received = clock.now().nanoseconds if simulated else info["received_timestamp"]
            try:
                write(topic, data, received, info["source_timestamp"])
            except OSError as error:
                if host is None:
                    raise
                host.failed(error)
            else:
                if host is not None:
                    host.received(topic, received)

        self.types[topic] = metadata.type

        self._subscriptions[topic] = self._node.create_subscription(
            kind, topic, receive, self._profile(topic, offers), raw=True
        )
        self._log.info(f"Subscribed to topic '{topic}'")

    def _profile(self, topic: str, offers: list[TopicEndpointInfo]) -> QoSProfile:
        """Return a profile compatible with every publisher (rosbag2_storage, adapt_request_to_offers)."""
        override = self._options.topic_qos_profile_overrides.get(topic)
        if override is not None:
            self._log.info(f"Overriding subscription profile for {topic}")
            return override
        profiles = [offer.qos_profile for offer in offers]
        reliable = [each for each in profiles if each.reliability == ReliabilityPolicy.RELIABLE]
        latched = [each for each in profiles if each.durability == DurabilityPolicy.TRANSIENT_LOCAL]
        some = f'Some, but not all, publishers on topic "{topic}" are offering RMW_QOS_POLICY_'
        back = "as it will connect to all publishers."
        if reliable and len(reliable) < len(profiles):
            self._log.warning(
                f"{some}RELIABILITY_RELIABLE. Falling back to RMW_QOS_POLICY_RELIABILITY_BEST_EFFORT {back} "
                "Some messages from Reliable publishers could be dropped."
            )
        if latched and len(latched) < len(profiles):
            self._log.warning(
                f"{some}DURABILITY_TRANSIENT_LOCAL. Falling back to RMW_QOS_POLICY_DURABILITY_VOLATILE {back} "
                "Previously-published latched messages will not be retrieved."
            )
        lasting = bool(profiles) and len(latched) == len(profiles)
        return QoSProfile(
            depth=DEPTH,
            reliability=(
                ReliabilityPolicy.RELIABLE if len(reliable) == len(profiles) else ReliabilityPolicy.BEST_EFFORT
            ),
            durability=DurabilityPolicy.TRANSIENT_LOCAL if lasting else DurabilityPolicy.VOLATILE,
        )

    def _warn_of_new_qos(self, topic: str) -> None:
        if topic in self._warned:
            return
        used = self._subscriptions[topic].qos_profile
        for offer in self._node.get_publishers_info_by_topic(topic):
            new = offer.qos_profile
            pair = None
            if new.reliability == ReliabilityPolicy.BEST_EFFORT and used.reliability != ReliabilityPolicy.BEST_EFFORT:
                pair = ("RELIABILITY_BEST_EFFORT", "rosbag", "RELIABILITY_RELIABLE")
            elif new.durability == DurabilityPolicy.VOLATILE and used.durability != DurabilityPolicy.VOLATILE:
                pair = ("DURABILITY_VOLATILE", "rosbag2", "DURABILITY_TRANSIENT_LOCAL")
            if pair is not None:
                self._warned.add(topic)
                self._log.warning(
                    f"A new publisher for subscribed topic {topic} was found offering RMW_QOS_POLICY_{pair[0]}, but "
                    f"{pair[1]} already subscribed requesting RMW_QOS_POLICY_{pair[2]}. Messages from this new publisher "
                    "will not be recorded."
                )
                return

    # -- control -------------------------------------------------------------------------------------------------------

    def pause(self) -> None:
        """Write nothing until `resume`."""
        if not self.paused:
            self.paused = True
            self._log.info("Pausing recording.")

    def resume(self) -> None:
        """Continue to write."""
        if self.paused:
            self.paused = False
            self._log.info("Resuming recording.")

    def press(self, key: str) -> None:
        """Handle a key: space pauses and resumes."""
        if key == " ":
            (self.resume if self.paused else self.pause)()

    def _on_split(self, closed: str, opened: str) -> None:
        name = self._node.get_fully_qualified_name()
        event = WriteSplitEvent(closed_file=closed, opened_file=opened)
        if hasattr(event, "node_name"):  # not in Humble
            event.node_name = name
        self._splits.publish(event)

    def _callback(self, action: Callable[[], object]) -> Callable[[Any, Any], Any]:
        def serve(request: Any, response: Any) -> Any:
            action()
            return response

        return serve

    def _is_paused(self, request: Any, response: Any) -> Any:
        response.paused = self.paused
        return response

    def _snapshot(self, request: Any, response: Any) -> Any:
        response.success = self._writer.take_snapshot()
        return response

    def _split(self, request: Any, response: Any) -> Any:
        self._writer.split_bagfile()
        return response

"""The recorder without any waiting: `ros2 bag record` and `Recorder` call `poll` regularly."""

from __future__ import annotations

import threading
import time
from pathlib import Path
from typing import TYPE_CHECKING, Any, Protocol

from rosbag2_interfaces.msg import WriteSplitEvent

from day6_core.interfaces import type_name
from day6_core.ros.differences import value
from rclpy.qos import DurabilityPolicy, QoSProfile, ReliabilityPolicy
from rosbag2_py._compression import CompressionOptions, compression_mode_from_string
from rosbag2_py._console import Log, to_console
from rosbag2_py._lost_messages import LostMessages
from rosbag2_py._options import RecordOptions
from rosbag2_py._qos import from_rclpy
from rosbag2_py._record_services import RecordServices
from rosbag2_py._storage import ConverterOptions, StorageOptions, TopicMetadata
from rosbag2_py._topic_filter import TopicFilter, read_static_topics
from rosbag2_py._writer import FLUSH_SECONDS, SequentialCompressionWriter, SequentialWriter

if TYPE_CHECKING:
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

    `start` raises RuntimeError if the bag can't be created. `keyboard`: whether keys can control it. Another thread than the
    one that spins the node may call the methods.
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
        self.discovering = False
        self._waits_for_clock = False
        self._lock = threading.RLock()
        self._services: RecordServices | None = None
        self._lost = LostMessages(node, options.statistics_max_publishing_rate)
        self._newer: bool = value("bag.recorder_starts_again")
        if options.use_sim_time and options.is_discovery_disabled:
            raise RuntimeError(
                "use_sim_time and is_discovery_disabled both set, but are incompatible settings. "
                "The /clock topic needs to be discovered to record with sim time."
            )
        actions = ("actions", "exclude_actions") if value("bag.records_actions") else ()
        for name in ("topics", "exclude_topics", "services", "exclude_service_events", *actions):
            setattr(options, name, [self._full(topic) for topic in getattr(options, name)])
        self._repeated = {self._full(topic): depth for topic, depth in options.repeat_transient_local_messages.items()}
        self._static = {
            self._full(topic): kind for topic, kind in read_static_topics(options.static_topics_uri, self._log).items()
        }
        self._filter = TopicFilter(options, node, self._log.warning, self._static)
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

    def offer(self) -> None:
        """Create the services and event topics, once; `start` does it too."""
        if self._host is None and self._services is None:
            self._services = RecordServices(self._node, self, snapshot=self._storage.snapshot_mode)
            self._splits = self._node.create_publisher(WriteSplitEvent, "events/write_split", 1)
            self._lost.offer()
            self._log.info("Event publisher thread: Starting")

    def start(self, uri: str = "") -> None:
        """Create the bag, in another place than the options' with `uri`, and the services; subscribe to the present topics."""
        with self._lock:
            self._start(uri)

    def _start(self, uri: str) -> None:
        options = self._options
        if self._newer:
            self._storage.uri = uri or self._storage.uri
            if self._host is None:
                self.offer()
                self._log.info(f"Starting recording to '{self._storage.uri}'")
                self._choose_free_folder()
        self._writer.open(self._storage, ConverterOptions("cdr", "cdr"))
        bag = self._writer._opened()
        if self._host is None:
            bag.on_split = self._on_split
        self.recording = True
        self.offer()
        self._waits_for_clock = options.use_sim_time
        only_static = self._static and not self._filter.selects_from_graph
        self._flushed = time.monotonic()
        self.discovering = not (options.is_discovery_disabled or only_static)
        if not self._newer:
            self._log.info("Listening for topics...")
        if options.use_sim_time:
            self._log.info("use_sim_time set, waiting for /clock before starting recording...")
        else:
            self._subscribe()
        if self._newer and self.discovering:
            self._log.info("Topics discovery started.")
            self._log.info("Listening for topics...")
        waits = f"{value('bag.recorder_waits')}: Press SPACE to start."
        self._log.info(waits if self.paused else "Recording...")

    def _choose_free_folder(self) -> None:
        """Take the folder's name with (1), (2) … behind it if it exists, as the recorder of Lyrical."""
        folder = self._storage.uri
        number = 0
        while Path(self._storage.uri).is_dir():
            number += 1
            self._storage.uri = f"{folder}({number})"
        if number:
            self._log.warning(f"Bag directory '{folder}' already exists.")
            self._log.warning(f"Changing bag directory to '{self._storage.uri}'.")

    def poll(self) -> None:
        """Look for new topics, tell of lost messages, and flush received messages to the disk."""
        with self._lock:
            if self.recording:
                self._poll()

    def _poll(self) -> None:
        if self._waits_for_clock:
            if self._node.get_clock().now().nanoseconds == 0:
                return
            self._waits_for_clock = False
            self._log.info("Sim time /clock found, starting recording.")
        if self.discovering:
            self._discover()
        self._lost.tell()
        if time.monotonic() - self._flushed > FLUSH_SECONDS:
            self._flushed = time.monotonic()
            self._writer.flush()

    def stop(self) -> None:
        """Finish the bag; a second call does nothing."""
        with self._lock:
            if self.recording:
                self._stop()

    def _stop(self) -> None:
        self.recording = False
        self.stop_discovery()
        if value("bag.recorder_logs_pause_at_end"):
            self.pause()
        if not self._newer:
            self.paused = True
        for subscription in self._subscriptions.values():
            self._node.destroy_subscription(subscription)
        self._subscriptions.clear()
        self._writer.close()
        if self._services is not None:
            self._services.forget()
            if not self._newer:
                self._log.info("Event publisher thread: Exiting")
        self._log.info("Recording stopped")
        if warning := self._lost.report():
            self._log.warning(warning)

    def start_discovery(self) -> None:
        """Look for new topics again."""
        if not self.discovering:
            self.discovering = True
            self._log.info("Topics discovery started.")

    def stop_discovery(self) -> None:
        """Look for no more topics."""
        if self.discovering:
            self.discovering = False
            if self._newer:
                self._log.info("Topics discovery stopped.")

    # -- topics --------------------------------------------------------------------------------------------------------

    def _discover(self) -> None:
        for topic in list(self._subscriptions):
            self._warn_of_new_qos(topic)
        self._subscribe()
        if self._options.topics and len(self._subscriptions) == len(self._options.topics):
            self._log.info("All requested topics are subscribed. Stopping discovery...")
            self.stop_discovery()

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
        depth = self._repetitions(topic, offers)
        if depth:
            self._writer._opened().repeat(topic, depth)
        write, clock = self._writer.write, self._node.get_clock()
        simulated, host = self._options.use_sim_time, self._host

        services = self._services if self._newer else None

        def receive(data: bytes, info: MessageInfo) -> None:
            with self._lock:
                if self.recording:
                    take(data, info)

        def take(data: bytes, info: MessageInfo) -> None:
            sent = info["source_timestamp"]
            received = clock.now().nanoseconds if simulated else info["received_timestamp"]
            if services is not None:
                services.before(topic, sent, received)
            if self.paused:
                return
            try:
                write(topic, data, received, sent)
            except OSError as error:
                if host is None:
                    raise
                host.failed(error)
            else:
                if host is not None:
                    host.received(topic, received)
                if services is not None:
                    services.after(topic)

        self.types[topic] = metadata.type

        self._subscriptions[topic] = self._node.create_subscription(
            kind, topic, receive, self._profile(topic, offers), raw=True, **self._lost.events_of(topic)
        )
        repeated = f" (repeat-transient-local, depth={depth})" if depth else ""
        self._log.info(f"Subscribed to topic '{topic}'{repeated}")

    def _repetitions(self, topic: str, offers: list[TopicEndpointInfo]) -> int:
        """Return how many of a topic's last messages each new file begins with."""
        chosen, depth = self._repeated, self._options.repeat_all_transient_local_depth
        if topic not in chosen and depth:
            if not offers:
                self._log.warning(
                    f"No publishers found for topic '{topic}', cannot determine if it is transient-local. "
                    "Use --repeat-transient-local to explicitly specify this topic."
                )
            elif any(offer.qos_profile.durability == DurabilityPolicy.TRANSIENT_LOCAL for offer in offers):
                chosen[topic] = depth
        return chosen.get(topic, 0)

    def _profile(self, topic: str, offers: list[TopicEndpointInfo]) -> QoSProfile:
        """Return a profile compatible with every publisher (rosbag2_storage, adapt_request_to_offers)."""
        override = self._options.topic_qos_profile_overrides.get(topic)
        repeated = topic in self._repeated
        if override is not None:
            self._log.info(f"Overriding subscription profile for {topic}")
            if repeated and override.durability != DurabilityPolicy.TRANSIENT_LOCAL:
                self._log.warning(
                    f"Topic '{topic}' has a QoS profile override without transient_local durability, but "
                    "repeat-transient-local is enabled. The QoS override takes precedence; repeat-transient-local will not "
                    "work unless the override includes transient_local durability."
                )
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
        if repeated and not lasting:
            self._log.warning(
                f"Overriding QoS durability to transient_local for topic '{topic}' because repeat-transient-local is enabled."
            )
            lasting = True
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

    def snapshot(self) -> bool:
        """Write what is kept in memory; False where nothing is."""
        with self._lock:
            return self._writer.take_snapshot()

    def split(self) -> None:
        """Continue in a new file."""
        with self._lock:
            self._writer.split_bagfile()

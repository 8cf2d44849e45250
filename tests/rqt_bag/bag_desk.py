"""A machine on which rqt_bag runs, and bags with numbers for it."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import rosbag2_py
from rosbag2_py._qos import QoS
from sensor_msgs.msg import Image
from std_msgs.msg import Float64, String

from day6_core.ros.programs.rqt_bag.model.bags import Bags
from rclpy.serialization import serialize_message
from tests.support.stepped_machine import Running, SteppedMachine

SECOND = 1_000_000_000
START = 1_690_000_000 * SECOND
"""When the first message of a bag was received."""

LATCHED = QoS(1).transient_local()


def write_bag(
    folder: Path,
    storage: str = "mcap",
    *,
    seconds: float = 10.0,
    preset: str = "",
    packed: bool = False,
    static: bool = True,
) -> Path:
    """Write /number with 0, 1, 2 … ten times a second, /word once a second, and /static twice at the beginning.

    `packed`: the whole file is compressed.
    """
    writer = rosbag2_py.SequentialCompressionWriter() if packed else rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(folder), storage_id=storage, storage_preset_profile=preset))
    for id_, (name, kind, qos) in enumerate((
        ("/number", "std_msgs/msg/Float64", [QoS(10)]),
        ("/word", "std_msgs/msg/String", []),
        ("/static", "std_msgs/msg/String", [LATCHED, LATCHED]),
    )):  # fmt: skip
        writer.create_topic(rosbag2_py.TopicMetadata(id_, name, kind, "cdr", qos))
    for word in ("first", "second") if static else ():
        writer.write("/static", serialize_message(String(data=word)), START)
    for number in range(round(seconds * 10)):
        at = START + number * SECOND // 10
        writer.write("/number", serialize_message(Float64(data=float(number))), at)
        if number % 10 == 5:
            writer.write("/word", serialize_message(String(data=f"at {number}")), at)
    writer.close()
    return folder


def write_images(folder: Path, encoding: str = "rgb8") -> Path:
    """Write /camera for ten seconds: red images, from the middle on green ones."""
    writer = rosbag2_py.SequentialWriter()
    writer.open(rosbag2_py.StorageOptions(str(folder)))
    writer.create_topic(rosbag2_py.TopicMetadata(0, "/camera", "sensor_msgs/msg/Image", "cdr", [QoS(10)]))
    for number in range(20):
        pixels = bytes([255, 0, 0] if number < 10 else [0, 255, 0]) * 40 * 30
        image = Image(width=40, height=30, encoding=encoding, step=120, data=pixels)
        writer.write("/camera", serialize_message(image), START + number * SECOND // 2)
    writer.close()
    return folder


class BagDesk:
    """`open` runs rqt_bag; `model` is what its window draws."""

    def __init__(self, folder: Path) -> None:
        self.folder = folder
        self.machine = SteppedMachine()
        self.model: Bags
        self.running: Running

    def open(self, *words: str, topics: int = 3) -> Bags:
        self.running = self.machine.start("rqt_bag", "rqt_bag", *words, screen=True)
        self.model = self.machine.display.windows[-1].model  # type: ignore[assignment]
        if topics:
            self.machine.until(lambda: len(self.model.topics) == topics and not self.model.loading)
        return self.model

    def jump(self, seconds: float) -> None:
        """Move the playhead, counted from the beginning of the bag, and wait for what is published."""
        self.model.request(lambda: self.model.player.jump(START + round(seconds * SECOND)))
        self.machine.until(lambda: self.playhead == seconds)
        self.arrive()

    def arrive(self) -> None:
        """Wait until the messages at the playhead are read and delivered."""
        player = self.model.player
        self.machine.until(lambda: not (self.model._requests or player._jumped or player.arriving or player._steps))
        self.machine.advance(0.001)

    @property
    def playhead(self) -> float:
        """Seconds from the beginning of the bag."""
        return (self.model.player.now() - START) / SECOND

    def publish(self, *topics: str) -> None:
        for topic in topics:
            self.model.toggle_publishing(topic)
        self.machine.until(lambda: self.model.player.publishing >= set(topics))
        self.arrive()

    def watch(self, kind: type, topic: str, qos: Any = 10) -> list[Any]:
        return self.machine.watch(kind, topic, qos)

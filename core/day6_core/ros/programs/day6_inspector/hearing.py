"""What is sent, as facts: of every publisher what was odd lately, the frames it names, how its stamps stand to the clock."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any, NamedTuple

from day6_core.ros.programs.day6_inspector.message_checks import Odd, is_worth_a_look, odd
from day6_core.ros.programs.day6_inspector.samples import TRANSFORMS, Sample, Samples
from day6_core.ros.programs.day6_inspector.transforms import TOPICS, Transforms

if TYPE_CHECKING:
    from day6_core.graph.endpoints import Publisher
    from day6_core.graph.node import Node

CLOCK, DESCRIPTION = "/clock", "/robot_description"
CLOCK_TYPE, STRING = "rosgraph_msgs/msg/Clock", "std_msgs/msg/String"
JOINT_STATE, TRAJECTORY = "sensor_msgs/msg/JointState", "trajectory_msgs/msg/JointTrajectory"
MOST_JOINTS = 200
HELD = 10
"""Looks for which something odd is remembered: what is odd only now and then doesn't flicker."""

BY_NAME = (CLOCK, DESCRIPTION)
"""Topics that are listened to although nothing in one of their messages alone can be wrong."""


OWN = ("/rosout", "/parameter_events")
"""Topics of rclpy itself: nobody can send wrong numbers there."""


class Heard(NamedTuple):
    """What one publisher sent lately."""

    topic: str
    node: str
    type: str
    messages: int = 0
    """That were looked at."""
    odd: tuple[Odd, ...] = ()
    frames: tuple[str, ...] = ()
    """Frames that the newest message names: of its header, of its child."""
    stamp: float | None = None
    """Seconds of the newest header.stamp, None without one, or if it may be old or of the world's clock and right.

    A message may have been kept for long; our own programs go by the world's clock, which may be slow or fast.
    """
    ahead: float = 0.0
    """Seconds by which that is ahead of the clock of the computer that sent it."""
    joints: tuple[tuple[str, float], ...] = ()
    """Joints that the newest message names, with their positions, as far as those are numbers (0 in a trajectory)."""


@dataclass
class _Lately:
    """What is kept of one publisher."""

    looks: list[int] = field(default_factory=list)
    """When messages were looked at."""
    odd: dict[Odd, int] = field(default_factory=dict)
    """What was odd, and when last."""
    newest: Sample | None = None


class Hearing:
    """Looks at samples. On the program's thread."""

    def __init__(self, node: Node) -> None:
        self._samples = Samples(
            node, lambda topic, cls: topic in BY_NAME or (topic not in OWN and is_worth_a_look(cls))
        )
        self._transforms = Transforms()
        self._lately: dict[Publisher, _Lately] = {}
        self._look = 0

    def look(self) -> None:
        """Take what has come since the last look."""
        self._look += 1
        for sample in self._samples.look():
            publisher = sample.publisher
            lately = self._lately.setdefault(publisher, _Lately())
            lately.newest = sample
            lately.looks.append(self._look)
            lately.odd.update(dict.fromkeys(odd(sample.message, publisher.type_name), self._look))
            if publisher.topic in TOPICS and publisher.type_name == TRANSFORMS:
                self._transforms.take(publisher, sample.message, sample.sent_ns)
        self._transforms.look(self._samples.publishers, TOPICS[0] in self._samples.open)
        self._lately = {
            publisher: lately for publisher, lately in self._lately.items() if publisher in self._samples.publishers
        }
        for publisher, lately in self._lately.items():
            self._forget(publisher, lately)

    def _forget(self, publisher: Publisher, lately: _Lately) -> None:
        lasts = publisher.cache is not None
        newest = lately.looks[-1]
        lately.looks = [look for look in lately.looks if self._look - look <= HELD or (lasts and look == newest)]
        lately.odd = {
            each: look for each, look in lately.odd.items() if self._look - look <= HELD or (lasts and look == newest)
        }
        if not lately.looks:
            lately.looks, lately.newest = [newest], None

    def facts(self) -> dict[str, Any]:
        """Return the facts, by their names."""
        newest = {publisher: lately.newest for publisher, lately in self._lately.items() if lately.newest is not None}
        robots = {
            publisher.node.full_name: sample.message.data
            for publisher, sample in newest.items()
            if publisher.topic == DESCRIPTION and publisher.type_name == STRING
        }
        clocks = [
            _seconds(sample.message.clock)
            for publisher, sample in newest.items()
            if publisher.topic == CLOCK and publisher.type_name == CLOCK_TYPE
        ]
        return {
            "heard": tuple(
                sorted(
                    (_heard(sample, self._lately[publisher]) for publisher, sample in newest.items()),
                    key=lambda heard: heard[:3],
                )
            ),
            "transforms": self._transforms.now(),
            "frames": self._transforms.frames,
            "unread": self._samples.unread,
            "passed_over": self._samples.passed_over,
            "rival_descriptions": tuple(sorted(robots)) if len(set(robots.values())) > 1 else (),
            "clock": clocks[-1] if clocks else None,
        }


def _heard(sample: Sample, lately: _Lately) -> Heard:
    publisher, message = sample.publisher, sample.message
    header = _header(message, publisher.type_name)
    frames: tuple[str, ...] = ()
    stamp = None
    if header is not None:
        stamp = _seconds(header.stamp)
        if publisher.cache is not None or (publisher.origin is None and stamp):
            stamp = None
        if publisher.type_name != TRANSFORMS:
            child = getattr(message, "child_frame_id", None)
            frames = (header.frame_id, *((child,) if isinstance(child, str) else ()))
    return Heard(
        publisher.topic,
        publisher.node.full_name,
        publisher.type_name,
        len(lately.looks),
        tuple(sorted(lately.odd)),
        frames,
        stamp,
        round(stamp - sample.sent_ns / 1e9, 1) + 0.0 if stamp is not None else 0.0,  # no -0.0
        _joints(message, publisher.type_name),
    )


def _joints(message: Any, type_name: str) -> tuple[tuple[str, float], ...]:
    if type_name == TRAJECTORY:
        return tuple((name, 0.0) for name in message.joint_names[:MOST_JOINTS])
    if type_name == JOINT_STATE and len(message.position) == len(message.name) <= MOST_JOINTS:
        pairs = zip(message.name, message.position, strict=True)
        return tuple((name, float(value)) for name, value in pairs if math.isfinite(value))
    return ()


def _header(message: Any, type_name: str) -> Any:
    """Return a message's header, or that of its first transform; None without one."""
    if type_name == TRANSFORMS:
        return message.transforms[0].header if message.transforms else None
    has_one = type(message).get_fields_and_field_types().get("header") == "std_msgs/Header"
    return message.header if has_one else None


def _seconds(time: Any) -> float:
    return float(time.sec + time.nanosec / 1e9)

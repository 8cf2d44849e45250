"""The lines below a topic that make its QoS profile (rviz_common/properties/qos_profile_property.cpp)."""

from __future__ import annotations

from collections.abc import Callable

from day6_core.ros.programs.rviz2.model.properties import ENUM, INT, Property
from rclpy.qos import DurabilityPolicy, HistoryPolicy, QoSProfile, ReliabilityPolicy

HISTORY = {
    "System Default": HistoryPolicy.SYSTEM_DEFAULT,
    "Keep Last": HistoryPolicy.KEEP_LAST,
    "Keep All": HistoryPolicy.KEEP_ALL,
}
RELIABILITY = {
    "System Default": ReliabilityPolicy.SYSTEM_DEFAULT,
    "Reliable": ReliabilityPolicy.RELIABLE,
    "Best Effort": ReliabilityPolicy.BEST_EFFORT,
}
DURABILITY = {
    "System Default": DurabilityPolicy.SYSTEM_DEFAULT,
    "Transient Local": DurabilityPolicy.TRANSIENT_LOCAL,
    "Volatile": DurabilityPolicy.VOLATILE,
}


class QosProperties:
    """Depth and the three policies, as the first children of a topic."""

    def __init__(
        self,
        topic: Property,
        on_change: Callable[[], object],
        *,
        depth: int = 5,
        durability: str = "Volatile",
    ) -> None:
        self.depth = topic.add(Property("Depth", INT, depth, low=1, on_change=on_change))
        self.history, self.reliability, self.durability = (
            topic.add(Property(name, ENUM, value, options=tuple(table), on_change=on_change))
            for name, value, table in (
                ("History Policy", "Keep Last", HISTORY),
                ("Reliability Policy", "Reliable", RELIABILITY),
                ("Durability Policy", durability, DURABILITY),
            )
        )

    @property
    def values(self) -> tuple[object, ...]:
        """What the lines say, to see whether it changed."""
        return self.depth.value, self.history.value, self.reliability.value, self.durability.value

    def profile(self) -> QoSProfile:
        """The profile that the lines make."""
        return QoSProfile(
            depth=self.depth.value,
            history=HISTORY[self.history.value],
            reliability=RELIABILITY[self.reliability.value],
            durability=DURABILITY[self.durability.value],
        )

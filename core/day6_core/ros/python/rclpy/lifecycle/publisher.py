"""Publishers of lifecycle nodes."""

from __future__ import annotations

from typing import Any, Generic

from rclpy._day6.incidental import also
from rclpy.lifecycle.managed_entity import SimpleManagedEntity
from rclpy.publisher import Publisher
from rclpy.type_support import MsgT

__getattr__ = also(__name__, "CallbackGroup PublisherEventCallbacks QoSProfile")


class LifecyclePublisher(SimpleManagedEntity, Publisher[MsgT], Generic[MsgT]):
    """A publisher that publishes only while its node is active."""

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        SimpleManagedEntity.__init__(self)
        Publisher.__init__(self, *args, **kwargs)

    @SimpleManagedEntity.when_enabled
    def publish(self, msg: MsgT | bytes) -> None:
        """Send a message if the node is active; see `Publisher.publish`."""
        Publisher.publish(self, msg)

"""The publishers and subscriptions of a topic."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from day6_core.ros.differences import value
from rclpy._day6.incidental import also
from rclpy.qos import HistoryPolicy, QoSPresetProfiles, QoSProfile
from rclpy.type_hash import TypeHash

__getattr__ = also(__name__, "TypeHashDictionary QoSHistoryPolicy")


class TopicEndpointTypeEnum(IntEnum):
    """Publisher or subscription; numbers of rmw_endpoint_type_t."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


_NO_HASH = TypeHash()
_NO_GID: list[int] = []


class TopicEndpointInfo:
    """One publisher or subscription: its node, type, GID (16 numbers) and QoS. Values of wrong types raise AssertionError."""

    __slots__ = (
        "_endpoint_gid",
        "_endpoint_type",
        "_node_name",
        "_node_namespace",
        "_qos_profile",
        "_topic_type",
        "_topic_type_hash",
    )

    def __init__(
        self,
        node_name: str = "",
        node_namespace: str = "",
        topic_type: str = "",
        topic_type_hash: TypeHash | dict[str, Any] = _NO_HASH,
        endpoint_type: TopicEndpointTypeEnum | int = TopicEndpointTypeEnum.INVALID,
        endpoint_gid: list[int] = _NO_GID,
        qos_profile: QoSProfile | dict[str, Any] = QoSPresetProfiles.UNKNOWN.value,
    ) -> None:
        self.node_name = node_name
        self.node_namespace = node_namespace
        self.topic_type = topic_type
        self.topic_type_hash = topic_type_hash
        self.endpoint_type = endpoint_type
        self.endpoint_gid = [] if endpoint_gid is _NO_GID else endpoint_gid
        self.qos_profile = qos_profile

    @property
    def node_name(self) -> str:
        """The node's name."""
        return self._node_name

    @node_name.setter
    def node_name(self, value: str) -> None:
        assert isinstance(value, str)
        self._node_name = value

    @property
    def node_namespace(self) -> str:
        """The node's namespace."""
        return self._node_namespace

    @node_namespace.setter
    def node_namespace(self, value: str) -> None:
        assert isinstance(value, str)
        self._node_namespace = value

    @property
    def topic_type(self) -> str:
        """The type's name."""
        return self._topic_type

    @topic_type.setter
    def topic_type(self, value: str) -> None:
        assert isinstance(value, str)
        self._topic_type = value

    @property
    def topic_type_hash(self) -> TypeHash:
        """The type's hash."""
        return self._topic_type_hash

    @topic_type_hash.setter
    def topic_type_hash(self, value: TypeHash | dict[str, Any]) -> None:
        assert isinstance(value, (TypeHash, dict))
        self._topic_type_hash = TypeHash(**value) if isinstance(value, dict) else value

    @property
    def endpoint_type(self) -> TopicEndpointTypeEnum:
        """Publisher or subscription."""
        return self._endpoint_type

    @endpoint_type.setter
    def endpoint_type(self, value: TopicEndpointTypeEnum | int) -> None:
        assert isinstance(value, int)
        self._endpoint_type = TopicEndpointTypeEnum(value)

    @property
    def endpoint_gid(self) -> list[int]:
        """The GID, 16 numbers that are unique to this endpoint."""
        return self._endpoint_gid

    @endpoint_gid.setter
    def endpoint_gid(self, value: list[int]) -> None:
        assert all(isinstance(each, int) for each in value)
        self._endpoint_gid = value

    @property
    def qos_profile(self) -> QoSProfile:
        """The QoS; discovery does not include history and depth."""
        return self._qos_profile

    @qos_profile.setter
    def qos_profile(self, value: QoSProfile | dict[str, Any]) -> None:
        assert isinstance(value, (QoSProfile, dict))
        self._qos_profile = QoSProfile(**value) if isinstance(value, dict) else value

    def __eq__(self, other: object) -> bool:
        if not isinstance(other, TopicEndpointInfo):
            return False
        return all(getattr(self, slot) == getattr(other, slot) for slot in self.__slots__)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        qos = self._qos_profile
        history = qos.history.name
        if qos.history == HistoryPolicy.KEEP_LAST:
            history += f" ({qos.depth})"
        lines = (
            f"Node name: {self._node_name}",
            f"Node namespace: {self._node_namespace}",
            f"Topic type: {self._topic_type}",
            *([f"Topic type hash: {self._topic_type_hash}"] if value("messages.have_hashes") else []),
            f"Endpoint type: {self._endpoint_type.name}",
            f"GID: {'.'.join(format(each, '02x') for each in self._endpoint_gid)}",
            "QoS profile:",
            f"  Reliability: {qos.reliability.name}",
            f"  History (Depth): {history}",
            f"  Durability: {qos.durability.name}",
            f"  Lifespan: {qos.lifespan}",
            f"  Deadline: {qos.deadline}",
            f"  Liveliness: {qos.liveliness.name}",
            f"  Liveliness lease duration: {qos.liveliness_lease_duration}",
        )
        return "\n".join(lines)

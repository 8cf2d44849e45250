"""What the graph tells of one publisher or subscription."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from day6_tui.core.graph import Endpoint, EndpointKind
from rclpy.qos import HistoryPolicy, QoSPresetProfiles, QoSProfile
from rclpy.type_hash import TypeHash


class TopicEndpointTypeEnum(IntEnum):
    """rmw_endpoint_type_t."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2


class TopicEndpointInfo:
    """Node, type, GID (16 integers) and QoS of an endpoint of a topic. Its text is what `ros2 topic info -v` prints."""

    __slots__ = [
        "_endpoint_gid",
        "_endpoint_type",
        "_node_name",
        "_node_namespace",
        "_qos_profile",
        "_topic_type",
        "_topic_type_hash",
    ]

    def __init__(
        self,
        node_name: str = "",
        node_namespace: str = "",
        topic_type: str = "",
        topic_type_hash: TypeHash | dict[str, Any] | None = None,
        endpoint_type: TopicEndpointTypeEnum | int = TopicEndpointTypeEnum.INVALID,
        endpoint_gid: list[int] | None = None,
        qos_profile: QoSProfile | dict[str, Any] | None = None,
    ) -> None:
        self.node_name = node_name
        self.node_namespace = node_namespace
        self.topic_type = topic_type
        self.topic_type_hash = TypeHash() if topic_type_hash is None else topic_type_hash
        self.endpoint_type = endpoint_type
        self.endpoint_gid = [] if endpoint_gid is None else endpoint_gid
        self.qos_profile = QoSPresetProfiles.UNKNOWN.value if qos_profile is None else qos_profile

    @classmethod
    def _of(cls, endpoint: Endpoint) -> TopicEndpointInfo:
        """Describe an endpoint as discovery would: history is not announced, so it is unknown."""
        publisher = endpoint.kind is EndpointKind.PUBLISHER
        return cls(
            node_name=endpoint.node.name,
            node_namespace=endpoint.node.namespace,
            topic_type=endpoint.type_name,
            topic_type_hash=TypeHash._parse(endpoint.type_hash),
            endpoint_type=TopicEndpointTypeEnum.PUBLISHER if publisher else TopicEndpointTypeEnum.SUBSCRIPTION,
            endpoint_gid=list(endpoint.gid),
            qos_profile=QoSProfile._from_graph(endpoint.qos, known_history=False),
        )

    @property
    def node_name(self) -> str:
        """Name of the endpoint's node."""
        return self._node_name

    @node_name.setter
    def node_name(self, value: str) -> None:
        assert isinstance(value, str)
        self._node_name = value

    @property
    def node_namespace(self) -> str:
        """Namespace of the endpoint's node."""
        return self._node_namespace

    @node_namespace.setter
    def node_namespace(self, value: str) -> None:
        assert isinstance(value, str)
        self._node_namespace = value

    @property
    def topic_type(self) -> str:
        """Type of the topic, `std_msgs/msg/String`."""
        return self._topic_type

    @topic_type.setter
    def topic_type(self, value: str) -> None:
        assert isinstance(value, str)
        self._topic_type = value

    @property
    def topic_type_hash(self) -> Any:
        """Hash of the type's definition, a TypeHash."""
        return self._topic_type_hash

    @topic_type_hash.setter
    def topic_type_hash(self, value: TypeHash | dict[str, Any]) -> None:
        assert isinstance(value, (TypeHash, dict))
        self._topic_type_hash = value if isinstance(value, TypeHash) else TypeHash(**value)

    @property
    def endpoint_type(self) -> Any:
        """Publisher or subscription, a TopicEndpointTypeEnum."""
        return self._endpoint_type

    @endpoint_type.setter
    def endpoint_type(self, value: TopicEndpointTypeEnum | int) -> None:
        assert isinstance(value, int)
        self._endpoint_type = TopicEndpointTypeEnum(value)

    @property
    def endpoint_gid(self) -> list[int]:
        """The 16 bytes that identify the endpoint."""
        return self._endpoint_gid

    @endpoint_gid.setter
    def endpoint_gid(self, value: list[int]) -> None:
        assert all(isinstance(each, int) for each in value)
        self._endpoint_gid = value

    @property
    def qos_profile(self) -> Any:
        """The endpoint's QoS, a QoSProfile."""
        return self._qos_profile

    @qos_profile.setter
    def qos_profile(self, value: QoSProfile | dict[str, Any]) -> None:
        assert isinstance(value, (QoSProfile, dict))
        self._qos_profile = value if isinstance(value, QoSProfile) else QoSProfile(**value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, TopicEndpointInfo) and all(
            getattr(self, slot) == getattr(other, slot) for slot in self.__slots__
        )

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        qos = self.qos_profile
        history = qos.history.name
        if qos.history == HistoryPolicy.KEEP_LAST:
            history += f" ({qos.depth})"
        return "\n".join(
            (
                f"Node name: {self.node_name}",
                f"Node namespace: {self.node_namespace}",
                f"Topic type: {self.topic_type}",
                f"Topic type hash: {self.topic_type_hash}",
                f"Endpoint type: {self.endpoint_type.name}",
                f"GID: {'.'.join(format(each, '02x') for each in self.endpoint_gid)}",
                "QoS profile:",
                f"  Reliability: {qos.reliability.name}",
                f"  History (Depth): {history}",
                f"  Durability: {qos.durability.name}",
                f"  Lifespan: {qos.lifespan}",
                f"  Deadline: {qos.deadline}",
                f"  Liveliness: {qos.liveliness.name}",
                f"  Liveliness lease duration: {qos.liveliness_lease_duration}",
            )
        )

"""The publishers and subscriptions of a topic, and the clients and servers of a service."""

from __future__ import annotations

from enum import IntEnum
from typing import Any

from rclpy._day6.incidental import also
from rclpy.qos import QoSProfile
from rclpy.topic_endpoint_info import TopicEndpointInfo as TopicEndpointInfo
from rclpy.type_hash import TypeHash

__getattr__ = also(__name__, "TypeHashDictionary QoSHistoryPolicy")


class EndpointTypeEnum(IntEnum):
    """The kinds of endpoint; numbers of rmw_endpoint_type_t."""

    INVALID = 0
    PUBLISHER = 1
    SUBSCRIPTION = 2
    CLIENT = 3
    SERVER = 4


_HALVES = {
    EndpointTypeEnum.CLIENT: ((1, "Request Writer"), (0, "Response Reader")),
    EndpointTypeEnum.SERVER: ((0, "Request Reader"), (1, "Response Writer")),
}
"""The two endpoints of DDS that a client or server consists of, as they are printed: index in the lists, name."""

_FIELDS: dict[str, tuple[Any, Any]] = {
    "node_name": (str, ""),
    "node_namespace": (str, ""),
    "service_type": (str, ""),
    "service_type_hash": ((TypeHash, dict), TypeHash()),
    "qos_profiles": (list, []),
    "endpoint_gids": (list, []),
    "endpoint_type": (int, EndpointTypeEnum.INVALID),
    "endpoint_count": (int, 0),
}
"""Field -> (what it takes, its default)."""


class ServiceEndpointInfo:
    """One client or server: its node, type, GIDs and QoS. Values of wrong types raise AssertionError."""

    node_name: str
    node_namespace: str
    service_type: str
    service_type_hash: TypeHash
    qos_profiles: list[QoSProfile]
    endpoint_gids: list[list[int]]
    endpoint_type: EndpointTypeEnum
    endpoint_count: int

    def __init__(
        self,
        node_name: str = "",
        node_namespace: str = "",
        service_type: str = "",
        service_type_hash: TypeHash | dict[str, Any] = _FIELDS["service_type_hash"][1],
        qos_profiles: list[QoSProfile | dict[str, Any]] = _FIELDS["qos_profiles"][1],
        endpoint_gids: list[list[int]] = _FIELDS["endpoint_gids"][1],
        endpoint_type: EndpointTypeEnum | int = EndpointTypeEnum.INVALID,
        endpoint_count: int = 0,
    ) -> None:
        given = (node_name, node_namespace, service_type, service_type_hash, qos_profiles, endpoint_gids)
        for name, value in zip(_FIELDS, (*given, endpoint_type, endpoint_count), strict=True):
            setattr(self, name, value)

    def __setattr__(self, name: str, value: Any) -> None:
        if name not in _FIELDS:
            raise AttributeError(f"'ServiceEndpointInfo' object has no attribute '{name}'")
        assert isinstance(value, _FIELDS[name][0])
        if name == "service_type_hash" and isinstance(value, dict):
            value = TypeHash(**value)
        elif name == "qos_profiles":
            value = [QoSProfile(**each) if isinstance(each, dict) else each for each in value]
        elif name == "endpoint_gids":
            assert all(isinstance(gid, list) and all(isinstance(each, int) for each in gid) for gid in value)
        elif name == "endpoint_type":
            value = EndpointTypeEnum(value)
        super().__setattr__(name, value)

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServiceEndpointInfo) and vars(self) == vars(other)

    __hash__ = None  # type: ignore[assignment]

    def __str__(self) -> str:
        lines = [
            f"Node name: {self.node_name}",
            f"Node namespace: {self.node_namespace}",
            f"Service type: {self.service_type}",
            f"Service type hash: {self.service_type_hash}",
            f"Endpoint type: {self.endpoint_type.name}",
            f"Endpoint count: {self.endpoint_count}",
        ]
        gids = [".".join(f"{each:02x}" for each in gid) for gid in self.endpoint_gids]
        if self.endpoint_count == 1:
            return "\n".join([*lines, f"GID: {gids[0]}", "QoS profile:", *_lines(self.qos_profiles[0], "  ")])
        halves = _HALVES.get(self.endpoint_type, _HALVES[EndpointTypeEnum.SERVER])
        lines += ["GIDs:", *(f"- {half} : {gids[index]}" for index, half in halves), "QoS profiles:"]
        for index, half in halves:
            lines += [f"- {half} :", *_lines(self.qos_profiles[index], "      ")]
        return "\n".join(lines)


def _lines(profile: QoSProfile, indent: str) -> list[str]:
    return [
        f"{indent}Reliability: {profile.reliability.name}",
        f"{indent}History (Depth): {profile.history.name} ({profile.depth})",
        f"{indent}Durability: {profile.durability.name}",
        f"{indent}Lifespan: {profile.lifespan}",
        f"{indent}Deadline: {profile.deadline}",
        f"{indent}Liveliness: {profile.liveliness.name}",
        f"{indent}Liveliness lease duration: {profile.liveliness_lease_duration}",
    ]

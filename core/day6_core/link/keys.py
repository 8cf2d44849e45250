"""rmw_zenoh's key expressions: those of data, and the liveliness tokens of nodes and endpoints.

    0/chatter/std_msgs::msg::dds_::String_/RIHS01_…                             messages of a topic, calls of a service
    @ros2_lv/0/<zid>/<node id>/<node id>/NN/%/%/talker                          a node: enclave, namespace, name
    @ros2_lv/0/<zid>/<node id>/<entity id>/MP/%/%/talker/%chatter/<type>/<hash>/<qos>   an endpoint

A slash inside a name is written %, so each part is one chunk of the key.
"""

from __future__ import annotations

import os
import re
from typing import NamedTuple

from day6_core.graph.endpoints import Endpoint, EndpointKind
from day6_core.graph.names import flaw_of_full_topic_name, flaw_of_namespace, flaw_of_node_name
from day6_core.graph.node import Node
from day6_core.graph.qos import QoS
from day6_core.link.qos_text import qos_from_text, qos_to_text

LIVELINESS_PREFIX = "@ros2_lv"
PRESENCE_PREFIX = "@day6/"
_NODE = "NN"
_NO_HASH = "TypeHashNotSupported"
_NODE_PARTS = 9
_ENDPOINT_PARTS = 13
_LONGEST_TOKEN = 2048
"""Characters: the longest names ROS allows, one of each, with their separators."""
_SESSION_ID = re.compile(r"[0-9a-fA-F]{1,32}", re.ASCII)
_ENTITY_ID = re.compile(r"[0-9]{1,20}", re.ASCII)
_TYPE = re.compile(r"(?=.{3,255}\Z)[A-Za-z]\w*(?:/[A-Za-z]\w*){1,2}", re.ASCII)
_HASH = re.compile(r"RIHS[0-9]{2}_[0-9a-f]{1,64}", re.ASCII)


class Announcement(NamedTuple):
    """A parsed liveliness token. The fields from `kind` on are empty for a node."""

    zid: str
    node_id: str
    enclave: str
    namespace: str
    node_name: str
    kind: EndpointKind | None = None
    topic: str = ""
    type_name: str = ""
    type_hash: str = ""
    qos: QoS = QoS()

    @property
    def node_key(self) -> tuple[str, str]:
        """A key shared by a node and its endpoints, and by nothing else."""
        return self.zid, self.node_id


def new_zid() -> str:
    """Return a session id: 16 hexadecimal digits, the first not 0 (Zenoh drops leading zeros)."""
    return f"{int.from_bytes(os.urandom(8), 'little') | 1 << 63:016x}"


def all_tokens(domain_id: int) -> str:
    """Return the key expression that matches every node and endpoint of a domain."""
    return f"{LIVELINESS_PREFIX}/{domain_id}/**"


def all_presence_tokens(domain_id: int) -> str:
    """Return the key expression that matches every `presence_token` of a domain."""
    return f"{PRESENCE_PREFIX}{domain_id}/**"


def presence_token(domain_id: int, kind: str, zid: str) -> str:
    """Return the token of a process that has announced all its entities (`here`), or of a meeting point (`meeting`)."""
    return f"{PRESENCE_PREFIX}{domain_id}/{kind}/{zid}"


def report_key(domain_id: int, zid: str) -> str:
    """Return the key under which a process answers with its report; `*` as `zid` means all of them."""
    return f"{PRESENCE_PREFIX}{domain_id}/insides/{zid}"


def node_token(node: Node, zid: str) -> str:
    """Return the token of a node of the session `zid`."""
    return f"{_session_part(node, zid)}/{node.entity_id}/{_NODE}/{_node_part(node)}"


def endpoint_token(endpoint: Endpoint, zid: str) -> str:
    """Return the token of an endpoint of the session `zid`."""
    node = endpoint.node
    return (
        f"{_session_part(node, zid)}/{endpoint.entity_id}/{endpoint.kind.value}/{_node_part(node)}"
        f"/{mangled(endpoint.topic)}/{dds_type(endpoint.type_name)}/{endpoint.type_hash or _NO_HASH}"
        f"/{qos_to_text(endpoint.qos)}"
    )


def data_key(endpoint: Endpoint) -> str:
    """Return the key expression of an endpoint's messages, or of its requests and responses."""
    domain_id = endpoint.node.graph.domain_id
    type_hash = endpoint.type_hash or _NO_HASH
    return f"{domain_id}/{endpoint.topic.strip('/')}/{dds_type(endpoint.type_name)}/{type_hash}"


def parse_token(token: str) -> Announcement | None:
    """Parse a token; returns None if rmw_zenoh would not produce it.

    Every part is checked by rcl's and rmw's rules, because anyone on the link can declare any token: a name with line breaks
    would otherwise be several entries of `ros2 node list`.
    """
    parts = token.split("/")
    if len(token) > _LONGEST_TOKEN or len(parts) < _NODE_PARTS or not all(parts):
        return None
    _, _, zid, node_id, entity_id, kind, enclave, namespace, node_name, *topic_parts = parts
    node = Announcement(zid, node_id, demangled(enclave), demangled(namespace), demangled(node_name))
    if not (_SESSION_ID.fullmatch(zid) and _ENTITY_ID.fullmatch(node_id) and _ENTITY_ID.fullmatch(entity_id)):
        return None
    # rcl_validate_enclave_name is rmw_validate_namespace with a larger limit.
    if flaw_of_node_name(node.node_name) or flaw_of_namespace(node.namespace) or flaw_of_namespace(node.enclave):
        return None
    if kind == _NODE:
        return node if len(parts) == _NODE_PARTS else None
    return _endpoint_of(node, kind, topic_parts) if len(parts) == _ENDPOINT_PARTS else None


def _endpoint_of(node: Announcement, kind: str, parts: list[str]) -> Announcement | None:
    topic, dds_name, type_hash, qos = parts
    topic, type_name = demangled(topic), ros_type(dds_name)
    type_hash = "" if type_hash == _NO_HASH else type_hash
    if flaw_of_full_topic_name(topic) or not _TYPE.fullmatch(type_name):
        return None
    if type_hash and not _HASH.fullmatch(type_hash):
        return None
    try:
        return node._replace(
            kind=EndpointKind(kind), topic=topic, type_name=type_name, type_hash=type_hash, qos=qos_from_text(qos)
        )
    except ValueError:
        return None


def mangled(name: str) -> str:
    """Return a name as one chunk of a key: `/team/talker` → `%team%talker`, an empty name → `%`."""
    return name.replace("/", "%") or "%"


def demangled(chunk: str) -> str:
    """Return the name `mangled` was given."""
    return chunk.replace("%", "/")


def dds_type(type_name: str) -> str:
    """Return the DDS name of a ROS type: `std_msgs/msg/String` → `std_msgs::msg::dds_::String_`."""
    package, _, name = type_name.rpartition("/")
    return f"{package.replace('/', '::')}::dds_::{name}_"


def ros_type(dds_name: str) -> str:
    """Return the ROS name of a DDS type: `std_msgs::msg::dds_::String_` → `std_msgs/msg/String`."""
    return demangled(dds_name).replace("::dds_::", "::").removesuffix("_").replace("::", "/")


def _session_part(node: Node, zid: str) -> str:
    return f"{LIVELINESS_PREFIX}/{node.graph.domain_id}/{zid}/{node.entity_id}"


def _node_part(node: Node) -> str:
    return f"{mangled(node.enclave)}/{mangled(node.namespace)}/{mangled(node.name)}"

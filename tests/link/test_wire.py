"""What goes over the wire is what rmw_zenoh writes: keys, tokens, QoS strings, attachments, GIDs."""

from __future__ import annotations

import pytest
from hypothesis import given
from hypothesis import strategies as st

from day6_core.graph import EndpointKind, Graph, QoS
from day6_core.graph.qos import INFINITE_NS, Durability, History, Liveliness, Reliability
from day6_core.link.attachment import Attachment, pack, unpack
from day6_core.link.classes import message_class, service_class
from day6_core.link.gid import gid_of
from day6_core.link.keys import data_key, endpoint_token, mangled, node_token, parse_token, ros_type
from day6_core.link.qos_text import qos_from_text, qos_to_text

STRING_HASH = "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18"


def test_a_talkers_keys_are_as_rmw_zenoh_writes_them() -> None:
    graph = Graph(3)
    node = graph.create_node("talker", "/team/a")
    publisher = node.create_publisher("/team/a/chatter", "std_msgs/msg/String", STRING_HASH, QoS(), list)
    assert data_key(publisher) == f"3/team/a/chatter/std_msgs::msg::dds_::String_/{STRING_HASH}"
    assert node_token(node, "abc") == "@ros2_lv/3/abc/1/1/NN/%/%team%a/talker"
    assert endpoint_token(publisher, "abc") == (
        "@ros2_lv/3/abc/1/2/MP/%/%team%a/talker/%team%a%chatter/std_msgs::msg::dds_::String_/"
        f"{STRING_HASH}/::,10:,:,:,,"
    )


def test_a_service_travels_under_the_name_and_hash_of_its_service_type() -> None:
    node = Graph().create_node("server")
    service = node.create_service("/add", "example_interfaces/srv/AddTwoInts", "RIHS01_e1", QoS(), list)
    assert data_key(service) == "0/add/example_interfaces::srv::dds_::AddTwoInts_/RIHS01_e1"
    assert "/SS/%/%/server/%add/" in endpoint_token(service, "abc")


@pytest.mark.parametrize("kind", list(EndpointKind))
def test_a_token_says_what_its_endpoint_is(kind: EndpointKind) -> None:
    node = Graph().create_node("n", "/a/b", enclave="/secret/place")
    make = {
        EndpointKind.PUBLISHER: lambda *rest: node.create_publisher(*rest, list),
        EndpointKind.SUBSCRIPTION: node.create_subscription,
        EndpointKind.SERVICE: lambda *rest: node.create_service(*rest, list),
        EndpointKind.CLIENT: lambda *rest: node.create_client(*rest, list),
    }
    qos = QoS(depth=7, durability=Durability.TRANSIENT_LOCAL, deadline=1_000_000_001).resolved()
    endpoint = make[kind]("/x/y_z", "pkg/action/Do_SendGoal", "RIHS01_00", qos)
    said = parse_token(endpoint_token(endpoint, "abc"))
    assert said is not None
    assert said.node_key == ("abc", "1")
    assert (said.enclave, said.namespace, said.node_name) == ("/secret/place", "/a/b", "n")
    assert (said.kind, said.topic, said.type_name, said.type_hash) == (
        kind,
        "/x/y_z",
        "pkg/action/Do_SendGoal",
        "RIHS01_00",
    )
    assert said.qos == qos


@pytest.mark.parametrize(
    "token",
    [
        "",
        "@ros2_lv/0",
        "@ros2_lv/0/abc/1/1/NN/%/%",
        "@ros2_lv/0/abc/1/1//%/%/n",
        "@ros2_lv/0/abc/1/2/MP/%/%/n",
        "@ros2_lv/0/abc/1/2/XX/%/%/n/%t/T/H/::,10:,:,:,,",
        "@ros2_lv/0/abc/1/2/MP/%/%/n/%t/T/H/nonsense",
        "@ros2_lv/0/abc/1/2/MP/%/%/n/%t/T/H/9:9:9,9:,:,:,,",
        "@ros2_lv/0/abc/1/2/MP/%/%/n/%t/T/H/::,x:,:,:,,",
        "@ros2_lv/0/abc/1/2/MP/%/%/n/%t/T/H/::,10:,:,:,,/more",
    ],
)
def test_a_token_nobody_should_make_says_nothing(token: str) -> None:
    assert parse_token(token) is None


def test_a_type_that_is_no_ros_type_keeps_its_name() -> None:
    assert ros_type("Strange") == "Strange"
    assert mangled("") == "%"


@pytest.mark.parametrize(
    ("qos", "text"),
    [
        (QoS(), "::,10:,:,:,,"),
        (QoS(depth=5, reliability=Reliability.BEST_EFFORT), "2::,5:,:,:,,"),
        (QoS(depth=1, durability=Durability.TRANSIENT_LOCAL), ":1:,1:,:,:,,"),
        (QoS(history=History.KEEP_ALL), "::2,10:,:,:,,"),
        (QoS(deadline=1_500_000_000, lifespan=2_000_000_000), "::,10:1,500000000:2,0:,,"),
        (QoS(deadline=INFINITE_NS), "::,10:,:,:,,"),
        (
            QoS(liveliness=Liveliness.MANUAL_BY_TOPIC, liveliness_lease_duration=3_000_000_000),
            "::,10:,:,:3,3,0",
        ),
    ],
)
def test_a_profile_has_the_text_rmw_zenoh_gives_it(qos: QoS, text: str) -> None:
    assert qos_to_text(qos.resolved()) == text


def test_what_is_left_out_of_a_text_is_rmw_zenohs_default() -> None:
    assert qos_from_text("::,:,:,:,,") == QoS(depth=42).resolved()
    assert qos_from_text("1:2:1,10:9223372036,854775807:9223372036,854775807:1,9223372036,854775807") == (
        QoS().resolved()
    )


durations = st.integers(0, 10**12)


@given(
    st.builds(
        QoS,
        depth=st.integers(1, 5000),
        history=st.sampled_from([History.KEEP_LAST, History.KEEP_ALL]),
        reliability=st.sampled_from([Reliability.RELIABLE, Reliability.BEST_EFFORT]),
        durability=st.sampled_from([Durability.VOLATILE, Durability.TRANSIENT_LOCAL]),
        liveliness=st.sampled_from([Liveliness.AUTOMATIC, Liveliness.MANUAL_BY_TOPIC]),
        deadline=durations,
        lifespan=durations,
        liveliness_lease_duration=durations,
        avoid_ros_namespace_conventions=st.just(False),
    )
)
def test_every_profile_survives_its_text(qos: QoS) -> None:
    assert qos_from_text(qos_to_text(qos)) == qos


@given(st.text(max_size=40))
def test_any_other_text_is_refused_with_a_value_error(text: str) -> None:
    try:
        qos_from_text(text)
    except ValueError:
        return
    assert text.count(":") == 5


def test_an_attachment_has_33_bytes_and_is_read_with_and_without_its_length_byte() -> None:
    gid = bytes(range(16))
    data = pack(7, 1_700_000_000_000_000_000, gid)
    assert len(data) == 33
    assert data[16] == 16
    assert unpack(data) == unpack(data[:16] + data[17:]) == Attachment(7, 1_700_000_000_000_000_000, gid)
    for broken in (b"", data[:-2], data[:15], data + b"x"):
        with pytest.raises(ValueError, match="attachment"):
            unpack(broken)


def test_a_gid_is_xxh3_128_with_its_low_half_first() -> None:
    assert gid_of("@ros2_lv/0/aac3178e146ba6f1/0/0/NN/%/%/listener").hex() == "13d0970ae7d35d37066c1d6c30efa073"


@pytest.mark.parametrize(
    ("type_name", "name"),
    [
        ("std_msgs/msg/String", "String"),
        ("example_interfaces/action/Fibonacci_FeedbackMessage", "Fibonacci_FeedbackMessage"),
        ("example_interfaces/srv/AddTwoInts_Event", "AddTwoInts_Event"),
    ],
)
def test_every_topic_type_has_a_class(type_name: str, name: str) -> None:
    assert message_class(type_name).__name__ == name


@pytest.mark.parametrize(
    ("type_name", "name"),
    [
        ("example_interfaces/srv/AddTwoInts", "AddTwoInts"),
        ("example_interfaces/action/Fibonacci_SendGoal", "Fibonacci_SendGoal"),
        ("example_interfaces/action/Fibonacci_GetResult", "Fibonacci_GetResult"),
        ("action_msgs/srv/CancelGoal", "CancelGoal"),
    ],
)
def test_every_service_type_has_a_class(type_name: str, name: str) -> None:
    assert service_class(type_name).__name__ == name

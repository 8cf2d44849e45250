"""Whoever is on the link can declare any token: what ROS could not have is refused before anything sees it."""

from __future__ import annotations

from itertools import product

import pytest

from day6_core.graph.graph import Graph
from day6_core.link.keys import parse_token
from day6_core.link.limits import Refusals
from day6_core.link.remote import RemoteGraph
from tests.support.folded import folded

PARTS = {
    "zid": "abc",
    "node_id": "1",
    "entity_id": "2",
    "kind": "MP",
    "enclave": "%",
    "namespace": "%team",
    "name": "talker",
    "topic": "%team%chatter",
    "type": "std_msgs::msg::dds_::String_",
    "hash": "RIHS01_df668c740482bbd48fb39d76a70dfd4bd59db1288021743503259e948f6b1a18",
    "qos": "::,10:,:,:,,",
}
HOSTILE = {
    "a newline": "\n",
    "a carriage return": "\r",
    "a title": "\x1b]0;owned\x07",
    "the clipboard": "\x1b]52;c;b3duZWQ=\x07",
    "C1": "\x9b31m",
    "a reversal": "\u202e",
    "an isolate": "\u2066",
    "no width": "\u200b",
    "a line separator": "\u2028",
    "a blank": " ",
    "another alphabet": "а",
    "other digits": "٣",
    "a tag": "\U000e0041",
    "markup": "[@click=app.quit]",
}


def token(**changed: str) -> str:
    return "/".join(["@ros2_lv", "0", *{**PARTS, **changed}.values()])


def test_the_token_that_the_others_are_made_of_is_a_good_one() -> None:
    said = parse_token(token())
    assert said is not None
    assert (said.namespace, said.node_name, said.topic) == ("/team", "talker", "/team/chatter")


@folded("part, what", product(PARTS.keys() - {"kind"}, HOSTILE))
def test_no_part_of_a_token_carries_signs_that_ros_names_cannot_have(part: str, what: str) -> None:
    value = PARTS[part]
    for bad in (value + HOSTILE[what], HOSTILE[what] + value, value[:1] + HOSTILE[what] + value[1:]):
        assert parse_token(token(**{part: bad})) is None, f"{bad!r} as {part}"


@pytest.mark.parametrize(
    ("part", "value"),
    [
        ("name", "n" * 256),
        ("name", "1n"),
        ("namespace", "%" + "n" * 245),
        ("namespace", "%a%%b"),
        ("namespace", "team"),
        ("topic", "%" + "t" * 247),
        ("topic", "%t%"),
        ("topic", "t"),
        ("topic", "%1t"),
        ("type", "p::msg::dds_::" + "T" * 250 + "_"),
        ("type", "String_"),
        ("type", "a::b::c::d::dds_::T_"),
        ("hash", "RIHS01_" + "0" * 65),
        ("hash", "anything"),
        ("qos", "::,-1:,:,:,,"),
        ("qos", "::,1_0:,:,:,,"),
        ("qos", "::,99999999999999999999:,:,:,,"),
        ("qos", "::," + "9" * 4000 + ":,:,:,,"),
        ("zid", "a" * 33),
        ("node_id", "1" * 21),
    ],
)
def test_what_is_too_long_or_no_name_is_refused(part: str, value: str) -> None:
    assert parse_token(token(**{part: value})) is None


@pytest.mark.parametrize(
    ("part", "value"),
    [
        ("name", "n" * 255),
        ("namespace", "%" + "n" * 244),
        ("topic", "%" + "t" * 246),
        ("hash", "RIHS01_" + "0" * 64),
        ("zid", "a" * 32),
        ("node_id", "1" * 20),
        ("qos", f"::,{2**64 - 1}:,:,:,,"),
    ],
)
def test_what_is_just_not_too_long_is_read(part: str, value: str) -> None:
    assert parse_token(token(**{part: value})) is not None


def test_a_token_has_2048_characters_at_most() -> None:
    def of_length(length: int) -> str:
        first, _, rest = token().split("/", 2)
        return f"{first}/{'0' * (length - len(first) - len(rest) - 2)}/{rest}"

    assert parse_token(of_length(2048)) == parse_token(token()) is not None
    assert parse_token(of_length(2049)) is None


def test_a_node_is_not_announced_with_more_behind_its_name() -> None:
    node = "@ros2_lv/0/abc/1/1/NN/%/%/talker"
    assert parse_token(node) is not None
    assert parse_token(node + "/more") is None


def test_what_is_refused_is_counted_and_makes_nothing() -> None:
    graph = Graph(0)
    refusals = Refusals()
    remote = RemoteGraph(graph, "def", refusals, lambda zid: True)
    remote.appear(token(name="a\nb"))
    remote.appear(token(topic="%a\n%b"))
    remote.vanish(token(name="a\nb"))
    assert refusals.counts == {"names": 2}
    assert list(graph.nodes) == []
    remote.appear(token())
    assert refusals.counts == {"names": 2}
    assert [node.name for node in graph.nodes] == ["talker"]

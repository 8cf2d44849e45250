"""Random bytes in every place where a stranger's can arrive: nothing but the refusals that are meant comes out."""

from __future__ import annotations

import random
import string
from contextlib import suppress

import pytest

from day6_core.graph import Graph
from day6_core.interfaces import DeserializationError, deserialize, get_message, get_service, serialize
from day6_core.link.admission import Admission, token_of
from day6_core.link.attachment import pack, unpack
from day6_core.link.keys import parse_token
from day6_core.link.limits import Refusals
from day6_core.link.remote import RemoteGraph

TOKENS = (
    "@ros2_lv/0/abc/1/1/NN/%/%/talker",
    "@ros2_lv/0/abc/1/2/MP/%/%/talker/%chatter/std_msgs::msg::dds_::String_/RIHS01_0/::,1:,:,:,,",
    "@ros2_lv/0/abc/1/3/SS/%/%/talker/%add/example_interfaces::srv::dds_::AddTwoInts_/RIHS01_0/::,1:,:,:,,",
    "0/chatter/std_msgs::msg::dds_::String_/RIHS01_0/@adv/pub/abc/1/_",
    "@day6/0/here/abc",
)
SIGNS = string.printable + "/%@:_,é五\x00\u202e"


def mutated(random_: random.Random, text: str) -> str:
    """A token with a few signs changed, added, taken away, or parts of it exchanged with another's."""
    for _ in range(random_.randint(0, 4)):
        where = random_.randrange(len(text) + 1)
        kind = random_.randrange(4)
        if kind == 0:
            text = text[:where] + random_.choice(SIGNS) + text[where + 1 :]
        elif kind == 1:
            text = text[:where] + random_.choice(SIGNS) * random_.choice((1, 1, 300)) + text[where:]
        elif kind == 2:
            text = text[:where] + text[where + random_.randint(1, 9) :]
        else:
            parts = text.split("/")
            parts[random_.randrange(len(parts))] = random_.choice(random_.choice(TOKENS).split("/"))
            text = "/".join(parts)
    return text


def test_random_tokens_come_and_go_and_leave_nothing_behind() -> None:
    random_, graph, refusals = random.Random(9), Graph(), Refusals()
    admission, remote = Admission(lambda zid: False, refusals), RemoteGraph(graph, "0", refusals, lambda zid: False)
    seen: list[str] = []
    for _ in range(20_000):
        token = mutated(random_, random_.choice(TOKENS))
        assert token_of(token) is None or len(token) <= 2048
        seen.append(token)
        if admission.admit(token) is not None:
            remote.appear(token)
        if random_.random() < 0.5:
            gone = random_.choice(seen[-50:])
            if admission.remove(gone) is not None:
                remote.vanish(gone)
    assert refusals.counts["names"] > 1000
    for token in seen:
        admission.remove(token)
        remote.vanish(token)
    assert graph.nodes == () and admission.tokens_of(None) == []
    assert not (admission._of_session or any(admission._total.values()) or admission._waiting)
    assert not (remote._nodes or remote._publishers or remote._waiting or remote._nodes_of or remote._endpoints_of)


@pytest.mark.parametrize("token", TOKENS[:3])
def test_the_tokens_the_random_ones_are_made_of_are_good(token: str) -> None:
    assert parse_token(token) is not None


def test_random_attachments_are_read_or_refused() -> None:
    random_, refused = random.Random(9), 0
    good = pack(1, 2, bytes(16))
    for _ in range(20_000):
        data = bytearray(good[: random_.randint(0, 40)] + random_.randbytes(random_.choice((0, 0, 1, 9))))
        if data and random_.random() < 0.5:
            data[random_.randrange(len(data))] = random_.randrange(256)
        try:
            assert len(unpack(bytes(data)).gid) == 16
        except ValueError:
            refused += 1
    assert refused > 1000


@pytest.mark.parametrize(
    "wanted",
    [
        get_message("std_msgs/msg/String"),
        get_message("tf2_msgs/msg/TFMessage"),
        get_message("rcl_interfaces/msg/ParameterEvent"),
        get_message("rcl_interfaces/msg/Log"),
        get_message("sensor_msgs/msg/JointState"),
        get_message("rosgraph_msgs/msg/Clock"),
        get_service("rcl_interfaces/srv/SetParameters").Request,
        get_service("rcl_interfaces/srv/GetParameters").Response,
    ],
    ids=lambda wanted: wanted.__name__,
)
def test_random_bytes_of_a_message_are_read_or_refused(wanted: type) -> None:
    random_, good = random.Random(9), serialize(wanted())
    for _ in range(2000):
        data = bytearray(good + random_.randbytes(random_.choice((0, 0, 4, 200))))
        for _ in range(random_.randint(0, 4)):
            data[random_.randrange(len(data))] = random_.choice((0, 1, 0x7F, 0x80, 0xFF, random_.randrange(256)))
        with suppress(DeserializationError):
            deserialize(bytes(data[: random_.choice((len(data), random_.randrange(len(data) + 1)))]), wanted)

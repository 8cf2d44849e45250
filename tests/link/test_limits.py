"""A hostile machine behind an open door: what it costs, what it cannot take from others, and that it is forgotten."""

from __future__ import annotations

import json
import subprocess
import sys
import time
from collections.abc import Callable, Iterator
from pathlib import Path
from typing import Any

import pytest

from day6_core.graph import Graph
from day6_core.graph.endpoints import Subscription
from day6_core.interfaces import get_message, serialize
from day6_core.link import doors_of, state_of
from day6_core.link.admission import Admission
from day6_core.link.attachment import pack
from day6_core.link.keys import data_key
from day6_core.link.limits import (
    MOST_ENDPOINTS_OF_ONE,
    MOST_NODES,
    MOST_NODES_OF_ONE,
    MOST_UNANNOUNCED,
    UNANNOUNCED_SECONDS,
    Refusals,
)
from day6_core.link.remote import Origin, RemoteGraph, lives_here
from day6_core.link.state import DoorState
from day6_core.link.unannounced import UnannouncedSenders
from tests.link.link_harness import World
from tests.link.link_peer import Peer
from tests.support.free_port import free_port
from tests.support.waiting import until

MANY = 3000
NODES = "@ros2_lv/0/ffffffffffffffff/{}/{}/NN/%/%/flood{}"
PEERS = "@ros2_lv/0/f{}0/1/1/NN/%/%/flood{}"
TOPIC = "@ros2_lv/0/ffffffffffffffff/1/{}/MP/%/%/flood/%topic{}/std_msgs::msg::dds_::String_/RIHS01_0/::,1:,:,:,,"


class Hostile:
    def __init__(self, port: int) -> None:
        script = Path(__file__).with_name("hostile_peer.py")
        self.process = subprocess.Popen(
            [sys.executable, str(script), str(port)], stdin=subprocess.PIPE, stdout=subprocess.PIPE, text=True
        )
        assert self._line() == "ready"

    def __getattr__(self, name: str) -> Callable[..., Any]:
        def call(*positional: Any, **named: Any) -> Any:
            assert self.process.stdin is not None
            self.process.stdin.write(json.dumps([name, positional, named]) + "\n")
            self.process.stdin.flush()
            return json.loads(self._line())

        return call

    def _line(self) -> str:
        assert self.process.stdout is not None
        return self.process.stdout.readline().strip()

    def kill(self) -> None:
        self.process.kill()
        self.process.wait()


@pytest.fixture
def open_desk(world: World, port: int) -> Peer:
    desk = world.here(listen=f"tcp/127.0.0.1:{port}")
    until(lambda: doors_of(desk.graph)[0].state == DoorState.OPEN)  # joining waits for it a second at most
    return desk


@pytest.fixture
def hostile(open_desk: Peer, port: int) -> Iterator[Hostile]:
    peer = Hostile(port)
    yield peer
    peer.kill()


def refused(peer: Peer, reason: str) -> int:
    return state_of(peer.graph).refused.get(reason, 0)


def remote_graph(neighbours: tuple[str, ...] = ()) -> tuple[Graph, RemoteGraph, Refusals]:
    graph, refusals = Graph(), Refusals()
    return graph, RemoteGraph(graph, "0", refusals, neighbours.__contains__), refusals


def test_one_process_has_so_many_nodes_and_no_more() -> None:
    graph, remote, refusals = remote_graph()
    for number in range(20_000):
        remote.appear(NODES.replace("{}", str(number)))
    assert len(graph.nodes) == MOST_NODES_OF_ONE
    assert refusals.counts == {"nodes": 20_000 - MOST_NODES_OF_ONE}
    for number in range(20_000):
        remote.vanish(NODES.replace("{}", str(number)))
    assert graph.nodes == ()
    remote.admit_waiting()
    assert graph.nodes == () and refusals.counts == {}


def test_who_came_too_late_is_let_in_when_another_goes() -> None:
    graph, remote, refusals = remote_graph()
    for number in range(MOST_NODES_OF_ONE + 2):
        remote.appear(NODES.replace("{}", str(number)))
    remote.vanish(NODES.replace("{}", "7"))
    remote.admit_waiting()
    names = [node.name for node in graph.nodes]
    assert len(names) == MOST_NODES_OF_ONE and names[-1] == f"flood{MOST_NODES_OF_ONE}"
    remote.vanish(NODES.replace("{}", "8"))
    remote.admit_waiting()
    assert graph.nodes[-1].name == f"flood{MOST_NODES_OF_ONE + 1}" and refusals.counts == {}


def test_many_that_give_themselves_many_names_leave_room_for_the_processes_of_this_machine() -> None:
    graph, remote, _ = remote_graph(neighbours=("abc1",))
    for number in range(20_000):
        remote.appear(PEERS.replace("{}", str(number)))
    assert len(graph.nodes) == MOST_NODES
    remote.appear("@ros2_lv/0/abc2/1/1/NN/%/%/stranger")
    remote.appear("@ros2_lv/0/abc1/1/1/NN/%/%/neighbour")
    remote.appear("@ros2_lv/0/abc1/1/2/MP/%/%/neighbour/%chatter/std_msgs::msg::dds_::String_/RIHS01_0/::,1:,:,:,,")
    assert graph.nodes[-1].name == "neighbour" and len(graph.nodes[-1].endpoints) == 1
    assert len(graph.nodes) == MOST_NODES + 1


@pytest.mark.long
def test_one_process_has_so_many_endpoints_and_no_more() -> None:
    graph, remote, refusals = remote_graph()
    for number in range(20_000):
        remote.appear(TOPIC.replace("{}", str(number)))
    (node,) = graph.nodes
    assert len(node.endpoints) == MOST_ENDPOINTS_OF_ONE
    assert refusals.counts == {"endpoints": 20_000 - MOST_ENDPOINTS_OF_ONE}
    for number in range(20_000):
        remote.vanish(TOPIC.replace("{}", str(number)))
    assert graph.nodes == ()
    remote.appear(TOPIC.replace("{}", "1"))
    assert len(graph.nodes) == 1


def test_senders_that_nothing_announced_do_not_pile_up() -> None:
    graph, remote, _ = remote_graph()
    node = graph.create_node("listener")
    peer = Peer(graph)
    peer.things.append(node)
    subscription: Subscription = peer.things[peer.subscription(0, "/chatter")]
    first = remote.publisher_for(bytes(16), subscription)
    assert remote.publisher_for(bytes(16), subscription) is first
    for number in range(10 * MOST_UNANNOUNCED):
        assert remote.publisher_for(number.to_bytes(16, "big"), subscription) is not None
    assert len(remote._unannounced) == MOST_UNANNOUNCED


@pytest.mark.process
def test_thousands_of_nodes_of_a_stranger_are_bounded_and_forgotten_and_nobody_else_notices(
    world: World, open_desk: Peer, hostile: Hostile
) -> None:
    beside = world.process()
    beside.node("pupil")
    assert hostile.tokens(NODES, MANY) == MANY
    assert until(lambda: refused(open_desk, "nodes") > 0)
    assert len(open_desk.graph.nodes) <= MOST_NODES_OF_ONE + 1
    late = world.process()
    late.node("late")
    for peer in (open_desk, beside, late):
        assert until(lambda peer=peer: {"/pupil", "/late"} <= set(peer.nodes()))
    publisher = late.publisher(late.node("talker"), "/chatter")
    subscription = open_desk.subscription(open_desk.node("listener"), "/chatter")
    assert until(lambda: late.matched(publisher) == 1 and open_desk.matched(subscription) == 1)
    late.publish(publisher, data="still here")
    assert until(lambda: open_desk.messages(subscription) == ["still here"])
    hostile.kill()
    everyone = ["/late", "/listener", "/pupil", "/talker"]
    assert until(lambda: open_desk.nodes() == beside.nodes() == late.nodes() == everyone)


@pytest.mark.process
def test_leaving_while_thousands_of_nodes_come_in_takes_no_longer_than_a_moment(
    open_desk: Peer, hostile: Hostile
) -> None:
    hostile.tokens(NODES, MANY)
    before = time.process_time()
    open_desk.leave()
    assert time.process_time() - before < 2.0
    assert open_desk.nodes() == []


@pytest.mark.process
def test_bad_messages_are_counted_and_the_good_ones_arrive(open_desk: Peer, hostile: Hostile) -> None:
    subscription = open_desk.subscription(open_desk.node("listener"), "/chatter")
    thing: Subscription = open_desk.things[subscription]
    key = data_key(thing)
    good = serialize(get_message("std_msgs/msg/String")(data="good")).hex()
    sender = pack(1, 1, b"\1" * 16).hex()
    assert until(lambda: hostile.messages(key, good, sender, 1) and open_desk.messages(subscription))
    claims_4_gigabytes = "00010000ffffffff41"
    bad = [
        ("", sender),
        ("00", sender),
        (claims_4_gigabytes, sender),
        ("ffff0000" + good[8:], sender),
        (good, sender[:-4]),
        (good, "00"),
        (good, sender + "00" * 1000),
    ]
    for payload, attachment in bad:
        hostile.messages(key, payload, attachment, 1)
    assert until(lambda: refused(open_desk, "messages") == len(bad))
    hostile.messages(key, good, sender, 1)
    assert until(lambda: "good" in open_desk.messages(subscription))
    assert all(len(problem) <= 500 for problem in open_desk.problems())


@pytest.mark.process
def test_a_flood_of_messages_from_ever_new_senders_fills_no_memory(open_desk: Peer, hostile: Hostile) -> None:
    subscription = open_desk.subscription(open_desk.node("listener"), "/chatter", depth=5)
    thing: Subscription = open_desk.things[subscription]
    good = serialize(get_message("std_msgs/msg/String")(data="x")).hex()
    sender = pack(1, 1, b"\2" * 16).hex()
    assert until(lambda: hostile.messages(data_key(thing), good, sender, 1) and open_desk.length(subscription))
    link: Any = open_desk.graph.transport

    def flood() -> None:  # again and again: a busy machine drops a part of it, and senders are forgotten after a while
        hostile.messages(data_key(thing), good, sender, 3 * MOST_UNANNOUNCED, vary=True)

    assert until(lambda: len(link._remote._unannounced) == MOST_UNANNOUNCED, every=0.5, meanwhile=flood)
    assert open_desk.length(subscription) == 5


@pytest.mark.process
def test_a_flood_of_bad_questions_leaves_the_server_answering(world: World, open_desk: Peer, hostile: Hostile) -> None:
    server = open_desk.service(open_desk.node("server"), "/add")
    key = data_key(open_desk.things[server])
    sender = pack(1, 1, b"\3" * 16).hex()
    assert until(lambda: hostile.queries(key, "00", sender, 1) and refused(open_desk, "messages"))
    hostile.queries(key, "00", sender, 500)
    hostile.queries(key, "00", "0102", 500)
    assert until(lambda: refused(open_desk, "messages") > 1000)
    beside = world.process()
    client = beside.client(beside.node("asker"), "/add")
    assert until(lambda: beside.matched(client) == 1)
    number = beside.call(client, 1, 2)
    assert until(lambda: beside.responses(client) == [[number, 3]])


@pytest.mark.process
def test_tokens_of_wrong_forms_are_counted_and_passed_over(world: World, open_desk: Peer, hostile: Hostile) -> None:
    for pattern in ("@day6/0/here", "@day6/0/nowhere/1", "@day6/0/here/1/2", "@ros2_lv/0/x", "@ros2_lv/0/a/b/c/d/e/f"):
        hostile.tokens(pattern, 1)
    # The first three are this machine's own way of telling, and nobody listens to it outside.
    assert until(lambda: refused(open_desk, "names") == 2)
    beside = world.process()
    beside.node("pupil")
    assert until(lambda: open_desk.nodes() == ["/pupil"])


@pytest.mark.process
def test_a_message_under_a_local_senders_name_is_passed_over(open_desk: Peer, hostile: Hostile) -> None:
    publisher = open_desk.publisher(open_desk.node("talker"), "/chatter")
    subscription = open_desk.subscription(open_desk.node("listener"), "/chatter")
    open_desk.publish(publisher, data="own")
    thing: Subscription = open_desk.things[subscription]
    link: Any = open_desk.graph.transport
    link.publish(open_desk.things[publisher], get_message("std_msgs/msg/String")(data="own"), 1, 2)
    (own,) = link._topics._own_gids
    key, sender = data_key(thing), pack(1, 1, b"\4" * 16).hex()
    text = {word: serialize(get_message("std_msgs/msg/String")(data=word)).hex() for word in ("forged", "theirs")}
    heard: list[Any] = open_desk.samples(subscription)  # at once: what may come in a burst leaves no room for it
    assert until(lambda: hostile.messages(key, text["theirs"], sender, 1) and open_desk.length(subscription))
    hostile.messages(key, text["forged"], pack(7, 7, own).hex(), 1)
    hostile.messages(key, text["theirs"], pack(9, 9, b"\4" * 16).hex(), 1)
    assert until(lambda: heard.extend(open_desk.samples(subscription)) or 9 in [it["number"] for it in heard])
    assert {it["data"] for it in heard} == {"own", "theirs"}


@pytest.mark.process
def test_nobody_outside_takes_the_name_of_a_process_of_this_machine(
    world: World, open_desk: Peer, hostile: Hostile
) -> None:
    beside = world.process()
    beside.node("pupil")
    assert until(lambda: open_desk.nodes() == ["/pupil"])
    ours = open_desk.graph.nodes[0].origin
    assert isinstance(ours, Origin) and lives_here(ours, 0)
    hostile.tokens(f"@ros2_lv/0/{ours.zid}/{{}}/{{}}/NN/%/%/forged{{}}", 600)
    hostile.tokens(NODES, 1)
    assert until(lambda: "/flood0" in open_desk.nodes())
    assert until(lambda: refused(open_desk, "sessions") == 600)
    assert open_desk.nodes() == ["/flood0", "/pupil"]
    assert until(lambda: beside.nodes() == ["/flood0", "/pupil"])
    (stranger,) = (node.origin for node in open_desk.graph.nodes if node.name == "flood0")
    assert not lives_here(stranger, 0)
    late = beside.node("late")
    assert until(lambda: "/late" in open_desk.nodes()), late


def test_a_machine_is_forgotten_with_its_last_link_and_not_token_by_token() -> None:
    admission = Admission(lambda zid: False, Refusals())
    for number in range(20_000):
        admission.admit(NODES.replace("{}", str(number)))
    admission.admit("@ros2_lv/0/abc/1/1/NN/%/%/other")
    inside = admission.tokens_of("f" * 16)
    assert len(inside) == MOST_NODES_OF_ONE and list(admission.admit_waiting()) == []
    for key in inside:
        assert admission.remove(key) is not None
    assert list(admission.admit_waiting()) == []
    assert admission.tokens_of(None) == ["@ros2_lv/0/abc/1/1/NN/%/%/other"]


@pytest.mark.process
def test_a_second_gate_of_the_same_user_waits_until_the_first_is_closed(world: World, open_desk: Peer) -> None:
    second = world.here(listen=f"tcp/127.0.0.1:{free_port()}")
    until(lambda: doors_of(second.graph)[0].state != DoorState.OPENING)
    (door,) = doors_of(second.graph)
    assert door.state == DoorState.FAILED and "another program of yours" in door.reason
    open_desk.leave()
    assert until(lambda: doors_of(second.graph)[0].state == DoorState.OPEN)


def test_who_was_never_announced_is_forgotten_after_a_while() -> None:
    """Last words come after their sender's token is gone: without this every program that ends would leave something."""
    now = [0.0]
    senders = UnannouncedSenders(lambda: now[0])
    made: list[object] = []

    def make() -> Any:
        made.append(object())
        return made[-1]

    first = senders.get((b"a", "/t"), make)
    now[0] = UNANNOUNCED_SECONDS - 1
    assert senders.get((b"a", "/t"), make) is first
    senders.get((b"b", "/t"), make)
    now[0] += UNANNOUNCED_SECONDS + 1
    senders.get((b"c", "/t"), make)
    assert len(senders) == 1
    now[0] += UNANNOUNCED_SECONDS + 1
    senders.forget_old()
    assert len(senders) == 0

"""The link seen from one process: when it serialises, what it does without an engine, who waits for whom."""

from __future__ import annotations

import gc
import os
import signal
import sys
import threading
import types
from typing import Any

import pytest
import zenoh
import zenoh.ext

from day6_core.graph import EndpointKind, Graph
from day6_core.graph.endpoints import Publisher
from day6_core.language import said
from day6_core.link import config, engine, join, leave, state_of
from tests.link.link_harness import World
from tests.link.link_peer import Peer
from tests.support.waiting import until


def no_copy(message: Any) -> Any:
    return message


@pytest.mark.process
def test_nothing_is_serialised_while_nobody_listens_elsewhere(world: World) -> None:
    here, there = world.here(), world.here()
    publisher: Publisher = here.things[here.publisher(here.node("talker"), "/chatter")]
    publisher.copy = no_copy
    publisher.publish("no message at all, so serialising it would fail")
    there.subscription(there.node("other"), "/another_topic")
    assert until(lambda: here.nodes() == ["/other", "/talker"])
    publisher.publish("nor this")
    assert here.problems() == []


@pytest.mark.process
def test_what_a_latched_publisher_said_before_its_process_joined_is_kept_for_late_joiners(world: World) -> None:
    early = world.here(joined=False)
    publisher = early.publisher(early.node("describer"), "/robot_description", latched=True, depth=2)
    early.publish_numbers(publisher, 0, 3)
    other = world.process()
    waiting = other.subscription(other.node("viewer"), "/robot_description", latched=True, depth=5)
    try:
        join(early.graph)
        assert until(lambda: other.length(waiting) == 2)
        early.publish(publisher, data="after")
        assert until(lambda: other.length(waiting) == 3)
        assert other.messages(waiting) == ["1", "2", "after"]
        late = other.subscription(other.node("late"), "/robot_description", latched=True, depth=5)
        assert until(lambda: other.length(late) == 2)
        assert other.messages(late) == ["2", "after"]
    finally:
        leave(early.graph)


@pytest.mark.process
def test_joining_twice_is_joining_once_and_leaving_takes_the_others_nodes_away(world: World) -> None:
    graph, other = Graph(), world.here()
    other.node("other")
    link = join(graph)
    assert join(graph) is link
    graph.create_node("mine")
    assert until(lambda: len(graph.nodes) == 2 and len(other.graph.nodes) == 2)
    leave(graph)
    leave(graph)
    assert [node.name for node in graph.nodes] == ["mine"]
    assert until(lambda: other.nodes() == ["/other"])
    assert graph.transport is None
    again = join(graph)
    assert again is not link
    assert until(lambda: len(graph.nodes) == 2 and len(other.graph.nodes) == 2)
    leave(graph)


@pytest.mark.process
def test_leaving_ends_every_thread_of_ours(world: World) -> None:
    before = set(threading.enumerate())
    graph = Graph()
    join(graph)
    assert len(set(threading.enumerate()) - before) == 1
    leave(graph)
    assert set(threading.enumerate()) <= before  # a timer of an earlier test may have ended meanwhile


@pytest.mark.process
def test_why_there_is_no_link_is_known_afterwards(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    graph = Graph()
    monkeypatch.setitem(sys.modules, "day6_core.link.link", None)
    with pytest.raises(ImportError):
        join(graph)
    assert "day6_core.link.link" in str(state_of(graph).problem)
    monkeypatch.undo()
    assert state_of(Graph()).problem is None
    join(graph)
    assert state_of(graph).problem is None
    leave(graph)


@pytest.mark.process
def test_remote_nodes_are_marked_and_not_told_on(world: World) -> None:
    first, second = world.here(), world.here()
    first.publisher(first.node("talker"), "/chatter")
    assert until(lambda: second.endpoints("/chatter"))
    (node,) = second.graph.nodes
    assert node.origin is not None and first.graph.nodes[0].origin is None
    (endpoint,) = second.graph.endpoints(EndpointKind.PUBLISHER)
    assert endpoint.origin == node.origin
    third = world.process()
    assert until(lambda: third.nodes() == ["/talker"])
    second.leave()
    third.node("witness")
    assert until(lambda: first.nodes() == ["/talker", "/witness"])
    assert third.nodes() == ["/talker", "/witness"]


@pytest.mark.process
def test_listeners_of_the_graph_hear_of_remote_nodes_and_endpoints(world: World) -> None:
    near, far = world.here(), world.process()
    heard: list[tuple[str, str]] = []

    def listen(event: Any) -> None:
        heard.append((event.change.value, getattr(event.subject, "topic", None) or event.subject.name))

    near.graph.add_listener(listen)
    node = far.node("talker")
    far.publisher(node, "/chatter")
    assert until(lambda: len(heard) == 2)
    far.destroy(node)
    assert until(lambda: len(heard) == 4)
    assert heard == [
        ("node added", "talker"),
        ("endpoint added", "/chatter"),
        ("endpoint removed", "/chatter"),
        ("node removed", "talker"),
    ]


@pytest.mark.process
def test_a_listener_that_fails_does_not_stop_the_link(world: World, caplog: pytest.LogCaptureFixture) -> None:
    near, far = world.here(), world.process()

    def fail(event: Any) -> None:
        raise RuntimeError("a bug in a window")

    end = near.graph.add_listener(fail)
    far.node("first")
    assert until(lambda: "a bug in a window" in caplog.text)
    end()
    far.node("second")
    assert until(lambda: near.nodes() == ["/first", "/second"])


@pytest.mark.process
@pytest.mark.skipif(sys.platform == "win32", reason="no SIGSTOP")
@pytest.mark.usefixtures("hour_of_lease")
def test_a_stopped_process_does_not_hold_up_one_that_never_waits(world: World, monkeypatch: pytest.MonkeyPatch) -> None:
    # Whoever waits for it would do so for an hour.
    block = "transport/link/tx/queue/congestion_control/block/wait_before_close"
    monkeypatch.setitem(config._COMMON, block, "3600000000")
    screen, sleeper, awake = world.here(never_wait=True), world.process(), world.process()
    publisher = screen.publisher(screen.node("screen"), "/pose")
    sleeper.subscription(sleeper.node("sleeper"), "/pose")
    heard = awake.subscription(awake.node("awake"), "/pose", depth=5000)
    assert until(lambda: screen.matched(publisher) == 2)
    pid = sleeper.pid()
    os.kill(pid, signal.SIGSTOP)
    try:
        texts = [f"{number:01000}" for number in range(3000)]
        flood = threading.Thread(target=lambda: [screen.publish(publisher, data=text) for text in texts], daemon=True)
        flood.start()
        assert until(lambda: not flood.is_alive())
        # On a busy machine the other one may not keep up with such a flood either; it is never cut off.
        assert until(lambda: screen.publish(publisher, data="after") or "after" in awake.messages(heard))
    finally:
        os.kill(pid, signal.SIGCONT)


@pytest.mark.process
def test_a_reliable_flood_loses_nothing(world: World) -> None:
    near, far = world.here(), world.process()
    publisher = near.publisher(near.node("talker"), "/flood", depth=30_000)
    subscription = far.subscription(far.node("listener"), "/flood", depth=30_000)
    assert until(lambda: near.matched(publisher) == 1)
    near.publish_numbers(publisher, 0, 20_000)
    assert until(lambda: far.length(subscription) == 20_000)
    assert far.messages(subscription) == [str(number) for number in range(20_000)]


@pytest.mark.process
def test_garbage_on_a_topic_is_passed_over(world: World) -> None:
    near, far = world.here(), world.here()
    publisher = near.publisher(near.node("talker"), "/chatter")
    subscription = far.subscription(far.node("listener"), "/chatter")
    assert until(lambda: near.matched(publisher) == 1)
    session = near.graph.transport._session
    from day6_core.link.attachment import pack
    from day6_core.link.keys import data_key

    near.publish(publisher, data="first")  # which waits for the way; what Zenoh itself is given doesn't
    assert until(lambda: far.length(subscription) == 1)
    key = data_key(near.things[publisher])
    session.put(key, b"no attachment")
    session.put(key, b"\x00\x01\x00\x00\xff\xff\xff\xffx", attachment=b"short")
    session.put(key, b"\x00\x01\x00\x00\xff\xff\xff\xffx", attachment=pack(1, 1, bytes(16)))
    session.liveliness().declare_token("@ros2_lv/0/abc/nonsense")
    near.publish(publisher, data="fine")
    assert until(lambda: far.length(subscription) >= 2)
    assert far.messages(subscription) == ["first", "fine"]
    assert len(far.problems()) == 2


@pytest.mark.process
def test_a_message_of_somebody_without_a_known_gid_is_delivered_with_it(world: World) -> None:
    near, far = world.here(), world.here()
    publisher = near.publisher(near.node("talker"), "/chatter")
    subscription = far.subscription(far.node("listener"), "/chatter")
    assert until(lambda: near.matched(publisher) == 1)
    from day6_core.interfaces import get_message, serialize
    from day6_core.link.attachment import pack
    from day6_core.link.keys import data_key

    near.publish(publisher, data="first")  # which waits for the way; what Zenoh itself is given doesn't
    assert until(lambda: far.length(subscription) == 1)
    data = serialize(get_message("std_msgs/msg/String")(data="hello"))
    near.graph.transport._session.put(data_key(near.things[publisher]), data, attachment=pack(5, 123, bytes(range(16))))
    assert until(lambda: far.length(subscription) == 2)
    _, sample = far.samples(subscription)
    assert sample == {"data": "hello", "number": 5, "gid": bytes(range(16)).hex(), "source": 123, "intra": False}


def test_without_zenoh_programs_see_each_other_all_the_same(
    world: World, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    monkeypatch.setattr(engine, "_missing", set())
    monkeypatch.setitem(sys.modules, "zenoh", None)
    near, far = world.here(), world.here()
    publisher = near.publisher(near.node("talker"), "/chatter")
    subscription = far.subscription(far.node("listener"), "/chatter")
    assert until(lambda: near.matched(publisher) == 1)
    near.publish(publisher, data="hello")
    assert until(lambda: far.messages(subscription) == ["hello"])
    assert caplog.text == "", "nothing is missing"


@pytest.mark.process
def test_who_uses_another_engine_is_not_seen_and_that_is_said_once(
    world: World, monkeypatch: pytest.MonkeyPatch, caplog: pytest.LogCaptureFixture
) -> None:
    with_zenoh = world.here()
    with_zenoh.node("with_zenoh")
    monkeypatch.setenv("DAY6_LINK", "local")
    without = world.here()
    without.node("without")
    assert caplog.messages == [said(engine.OTHER_ENGINE, "en").format(count=1)]
    assert state_of(without.graph).with_zenoh == 1
    assert without.nodes() == ["/without"] and with_zenoh.nodes() == ["/with_zenoh"]
    assert len(caplog.messages) == 1
    leave(without.graph)


def engine_objects(root: object) -> set[str]:
    """Return the types of Zenoh's objects that can be reached from `root`."""
    found, seen, waiting = set(), set(), [root]
    while waiting:
        thing = waiting.pop()
        if id(thing) in seen or isinstance(thing, (type, types.ModuleType)):
            continue
        seen.add(id(thing))
        kind = type(thing)
        if getattr(zenoh, kind.__name__, None) is kind or getattr(zenoh.ext, kind.__name__, None) is kind:
            found.add(kind.__name__)
        if isinstance(thing, types.FunctionType):
            waiting.extend(cell.cell_contents for cell in thing.__closure__ or ())
        else:
            waiting.extend(gc.get_referents(thing))
    return found


@pytest.mark.process
def test_a_closed_link_leaves_nothing_of_the_engine_to_a_garbage_collection(world: World) -> None:
    """Their destructors wait for Zenoh's threads, and a collection may run on one of those: seen once in 60 runs."""
    graph, other = Graph(), world.here()
    link = join(graph)
    peer = Peer(graph)
    node = peer.node("everything")
    for latched in (True, False):
        publisher = peer.publisher(node, f"/topic_{latched}".lower(), latched=latched)
        peer.subscription(node, f"/topic_{latched}".lower(), latched=latched)
        listener = other.subscription(other.node("listener"), f"/topic_{latched}".lower(), latched=latched)
        assert until(lambda publisher=publisher: peer.matched(publisher) == 2)
        peer.publish(publisher, data="x")
        assert until(lambda listener=listener: other.length(listener) == 1)
    server, client = peer.service(node, "/add", hold=True), other.client(other.node("asker"), "/add")
    other.service(other.node("server"), "/multiply", hold=True)
    asking = peer.client(node, "/multiply")
    assert until(lambda: other.matched(client) and peer.matched(asking))
    other.call(client, 1, 1)
    peer.call(asking, 1, 1)
    assert until(lambda: peer.holding(server) == 1)
    assert {"Session", "Publisher", "AdvancedPublisher", "Subscriber", "Queryable", "Query"} <= engine_objects(link)
    leave(graph)
    assert engine_objects(link) == set()


@pytest.mark.process
def test_no_python_of_ours_runs_inside_a_declaration_where_a_ctrl_c_would_be_lost(world: World) -> None:
    # Zenoh tells a process of its own tokens on the thread that declares them, and swallows what is raised there.
    here = world.here()
    called: list[str] = []

    def on_call(frame: types.FrameType, event: str, _: Any) -> None:
        if event == "call" and frame.f_code.co_filename.endswith("engine_thread.py") and frame.f_code.co_name == "call":
            called.append(frame.f_code.co_filename)

    sys.setprofile(on_call)
    try:
        nodes = [here.node(f"node_{number}") for number in range(5)]
        publisher = here.publisher(nodes[0], "/chatter")
        here.destroy(publisher)
    finally:
        sys.setprofile(None)
    assert called == []

"""The link's own thread, step by step: what it takes in, how long it waits, what it refuses. No session is opened."""

from __future__ import annotations

import json
import os
import shutil
import signal
import socket
import sys
import threading
from collections.abc import Callable, Iterator
from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest
import zenoh

from day6_core import link as package
from day6_core.graph import Graph, QoS
from day6_core.graph.endpoints import RequestId
from day6_core.graph.node import Node
from day6_core.link import engine_thread
from day6_core.link import link as link_module
from day6_core.link import meeting as meeting_module
from day6_core.link import pace as pace_module
from day6_core.link.engine_thread import callback, inside_callback
from day6_core.link.file_lock import FileLock
from day6_core.link.gid import gid_of
from day6_core.link.keys import endpoint_token, node_token
from day6_core.link.link import Link
from day6_core.link.meeting import MeetingPoint
from day6_core.link.paths import LinkError, MeetingPlace
from day6_core.link.state import Door, LinkState, write_doors
from tests.link.clock import Clock
from tests.link.fake_engine import FakeSession, StillThread


def listening(session: FakeSession, config: zenoh.Config) -> FakeSession:
    """The session, with a file in the place of each of its sockets."""
    for endpoint in json.loads(config.get_json("listen/endpoints") or "[]"):
        if endpoint.startswith("unixsock-stream/"):
            Path(endpoint.removeprefix("unixsock-stream/")).touch()
    return session


class FakeMeeting:
    """A meeting point that somebody else holds, until `held_here` is set."""

    files = ()

    def __init__(self, place: MeetingPlace, domain_id: int) -> None:
        self.held_here = False
        self.tried = 0
        self.calls: list[str] = []

    def try_to_hold(self) -> bool:
        self.tried += 1
        return self.held_here

    def close(self) -> None:
        self.calls.append("close")

    def keep(self) -> None:
        self.calls.append("keep")

    def release_copy(self) -> None:
        self.calls.append("release copy")


class Opened:
    """A link whose thread runs when the test asks for it."""

    def __init__(self, link: Link, session: FakeSession, clock: Clock) -> None:
        self.link, self.session, self.clock = link, session, clock
        self.graph = link.graph

    @property
    def meeting(self) -> FakeMeeting:
        meeting: Any = self.link._meeting
        assert isinstance(meeting, FakeMeeting)
        return meeting

    def take(self, *entries: Any) -> None:
        for entry in entries:
            self.link._take(entry)

    def run(self, *entries: Any) -> None:
        """Let the link's thread take these and stop before it would wait again."""
        inbox: Any = self.link._inbox
        for entry in entries:
            inbox.put(entry)
        link = self.link

        class Once:
            def get(self, *, timeout: float | None = 0.0) -> Any:
                if inbox.empty():
                    link._closed = True
                    return None
                return inbox.get()

            def __getattr__(self, name: str) -> Any:
                return getattr(inbox, name)

        once: Any = Once()
        link._inbox = once
        link._run()
        link._inbox, link._closed = inbox, False


Make = Callable[..., Opened]

pytestmark = pytest.mark.skipif(sys.platform == "win32", reason="the meeting place has no Unix sockets there")


@pytest.fixture
def make(short_folder: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Make]:
    monkeypatch.setenv("DAY6_RUNTIME_DIR", str(short_folder / "r"))
    monkeypatch.setenv("DAY6_LINK", "on")
    clock = Clock()
    monkeypatch.setattr(link_module, "time", clock)
    monkeypatch.setattr(pace_module, "time", clock)
    monkeypatch.setattr(link_module, "MeetingPoint", FakeMeeting)
    stand_in = {name: getattr(threading, name) for name in ("Condition", "Event", "current_thread")}
    monkeypatch.setattr(link_module, "threading", SimpleNamespace(Thread=StillThread, **stand_in))
    links: list[Link] = []

    def opened(**arguments: Any) -> Opened:
        session = FakeSession("own")
        monkeypatch.setattr(zenoh, "open", lambda config: listening(session, config))
        link = Link(Graph(arguments.pop("domain_id", 0)), **arguments)
        links.append(link)
        link.open()
        return Opened(link, session, clock)

    yield opened
    for link in links:
        link.close()


def here(zid: str) -> tuple[bool, str]:
    return True, f"@day6/0/here/{zid}"


def remote_node(zid: str, number: int = 1) -> str:
    return f"@ros2_lv/0/{zid}/{number}/{number}/NN/%/%/n{number}"


# -- joining -----------------------------------------------------------------------------------------------------------


def test_a_link_that_opens_watches_the_others_and_says_that_it_is_here(make: Make) -> None:
    it = make()
    assert it.session.keys("watch") == ["@day6/0/**", "@ros2_lv/0/**"]
    assert all(each.options == {"history": True} for each in it.session.declared if each.what == "watch")
    assert it.session.keys("token") == [f"@day6/0/here/{it.link.zid}"]
    assert it.link.connected and not it.link.closed and it.meeting.tried == 1
    assert it.graph.transport is it.link


def test_what_exists_before_joining_and_what_comes_later_is_announced_and_what_is_remote_is_not(
    make: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    it = make()
    node = it.graph.create_node("n")
    service = node.create_service("/s", "example_interfaces/srv/AddTwoInts", "", QoS(), lambda it: it)
    it.graph.create_node("other", origin="elsewhere")
    zid = it.link.zid
    assert it.session.keys("token")[1:] == [node_token(node, zid), endpoint_token(service, zid)]
    assert service.gid == gid_of(endpoint_token(service, zid))
    service.destroy()
    assert it.session.keys("token")[1:] == [node_token(node, zid)]
    it.link.close()
    late = Link(it.graph)
    session = FakeSession()
    monkeypatch.setattr(zenoh, "open", lambda config: session)
    late.open()
    assert session.keys("token") == [node_token(node, late.zid), f"@day6/0/here/{late.zid}"]
    late.close()


def test_a_change_inside_a_callback_of_the_engine_is_announced_by_the_links_thread(make: Make) -> None:
    it = make()
    node = it.graph.create_node("n")
    callback(node.destroy)()
    assert node_token(node, it.link.zid) in it.session.keys("token")
    it.link._take_backlog()
    assert node_token(node, it.link.zid) not in it.session.keys("token")


def test_what_the_engine_refuses_is_told_and_the_program_goes_on(make: Make) -> None:
    it = make()
    node = it.graph.create_node("n")
    publisher = node.create_publisher("/t", "std_msgs/msg/String", "", QoS(), lambda it: it)
    it.session.fails = True
    it.graph.create_node("m")
    it.link.publish(publisher, "x", 1, 1)
    client = node.create_client("/s", "example_interfaces/srv/AddTwoInts", "", QoS(), lambda it: it)
    from day6_core.interfaces import get_service

    it.link.send_request(client, get_service("example_interfaces/srv/AddTwoInts").Request(), 1)
    assert list(it.link.problems) == ["not announced: no", "not sent: no", "not announced: no", "not sent: no"]
    it.link._closed = True
    it.graph.create_node("k")
    it.link.publish(publisher, "x", 1, 1)
    assert len(it.link.problems) == 4
    it.link._closed = False


def test_nothing_is_sent_before_there_is_a_session(make: Make) -> None:
    it = make(one_shot=True)
    assert not it.link.connected
    nothing: Any = None
    it.link.publish(nothing, "x", 1, 1)
    it.link.send_request(nothing, "x", 1)
    it.link.send_response(nothing, RequestId(b"", 1), "x")
    assert list(it.link.problems) == []


def test_problems_are_short_and_the_latest_fifty(make: Make) -> None:
    it = make()
    for number in range(60):
        it.link._report(f"{number}", ValueError("x" * 1000))
    assert len(it.link.problems) == 50 and {len(each) for each in it.link.problems} == {500}
    assert it.link.problems[0].startswith("10: ")


# -- who is here -------------------------------------------------------------------------------------------------------


@pytest.mark.parametrize(
    "key",
    [
        "@day6/0/here",
        "@day6/0/here/a/b",
        "@day6/0/nowhere/a",
        "@day6/0/here/" + "a" * 33,
        "@day6/",
    ],
)
def test_a_presence_token_of_another_form_is_counted(make: Make, key: str) -> None:
    it = make()
    it.take((True, key))
    assert it.link.refusals.counts == {"names": 1} and not any(it.link._presence.values())


def test_processes_and_meeting_points_come_and_go(make: Make) -> None:
    it = make()
    longest = "a" * 32
    it.take(here("a"), here(longest), (True, "@day6/0/meeting/a"), None)
    assert it.link._presence == {"here": {"a", longest}, "meeting": {"a"}}
    it.take((False, "@day6/0/here/a"), (False, "@day6/0/here/zzz"))
    assert it.link._presence == {"here": {longest}, "meeting": {"a"}}
    assert it.link.refusals.counts == {}


def test_only_so_many_processes_are_noted_but_neighbours_always(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(link_module, "MOST_PRESENCE_TOKENS", 2)
    it = make()
    it.take(here("a"), here("b"), here("c"))
    assert it.link._presence["here"] == {"a", "b"} and it.link.refusals.counts == {"processes": 1}
    sign_of("abc", it.link._place)
    it.take(here("abc"))
    assert it.link._presence["here"] == {"a", "b", "abc"} and it.link.refusals.counts == {"processes": 1}


def sign_of(zid: str, place: MeetingPlace | None) -> Path:
    """Leave the socket file of a process that lives (this one) under another session's id."""
    assert place is not None
    path = place.own_socket(zid)
    path.touch()
    changed = place.folder.stat().st_mtime_ns + 10**9
    os.utime(place.folder, ns=(changed, changed))
    return path


def test_neighbours_are_those_with_a_socket_in_the_place_now(make: Make) -> None:
    it = make()
    assert not it.link._is_neighbour("abc")
    path = sign_of("abc", it.link._place)
    assert it.link._is_neighbour("abc") and not it.link._is_neighbour("abd")
    path.unlink()
    sign_of("abd", it.link._place)
    assert it.link._is_neighbour("abd") and not it.link._is_neighbour("abc")
    assert not Link(Graph())._is_neighbour("abd")


# -- the thread --------------------------------------------------------------------------------------------------------


def test_the_thread_waits_as_long_as_nothing_can_have_changed(make: Make) -> None:
    it = make()
    assert it.link._patience() == 0.05, "no meeting point is known"
    it.take((True, "@day6/0/meeting/a"))
    assert it.link._patience() == 1.0
    it.meeting.held_here = True
    assert it.link._patience() == 1.0, "somebody may clear the meeting place"
    it.link._remote._room = True
    it.link._remote._waiting["x"] = None
    assert it.link._patience() == 1.0
    it.link._remote._waiting.clear()
    alone = make(one_shot=True)
    assert alone.link._patience() == 0.05
    alone.link._session = alone.session  # type: ignore[assignment]
    assert alone.link._patience() is None


def test_the_thread_takes_all_there_is_and_looks_after_the_meeting_point(make: Make) -> None:
    it = make()
    it.run((True, remote_node("abc", 1)), (True, remote_node("abc", 2)), (False, remote_node("abc", 1)))
    assert [node.name for node in it.graph.nodes] == ["n2"]
    assert it.meeting.tried == 2
    it.run(None)
    assert it.meeting.tried == 3


def test_who_is_found_no_more_begins_anew_as_soon_as_there_is_a_place(
    make: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    it = make()
    node = it.graph.create_node("mine")
    it.run((True, remote_node("abc", 1)))
    meeting, place = it.meeting, it.link._place
    assert place is not None

    def refused(domain_id: int) -> MeetingPlace:
        raise LinkError("nowhere")

    shutil.rmtree(place.folder)
    with monkeypatch.context() as without:
        without.setattr(link_module, "meeting_place", refused)
        it.run(None)
    assert list(it.link.problems) == ["the link's thread: nowhere"]
    assert len(it.graph.nodes) == 2 and it.link.connected, "those who have met stay together"
    publisher = node.create_publisher("t", "std_msgs/msg/String", "", QoS(), lambda message: message)
    zid, gid = it.link.zid, publisher.gid
    it.session.log.clear()
    it.run(None)
    assert it.link.zid != zid and not place.own_socket(zid).exists()
    assert publisher.gid == gid_of(endpoint_token(publisher, it.link.zid)) != gid
    assert place.own_socket(it.link.zid).exists() and it.meeting is not meeting and meeting.calls == ["close"]
    assert it.graph.nodes == (node,) and it.graph.transport is it.link
    assert it.session.log[0] == "close own" and any("mine" in line for line in it.session.log[1:])
    it.session.log.clear()
    it.run(None)
    assert it.session.log == [], "once is enough"


def test_who_finds_nobody_though_somebody_runs_the_meeting_point_begins_anew(make: Make) -> None:
    it = make()
    for present, kind in ((True, "meeting"), (False, "meeting"), (True, "here"), (False, "here")):
        it.clock.now += 4.0
        it.run((present, f"@day6/0/{kind}/abc"), (True, here(it.link.zid)[1]))
        assert "close own" not in it.session.log
    it.clock.now += 0.9
    it.run(None)
    assert "close own" not in it.session.log, "somebody was there 4.9 s ago"
    it.clock.now += 0.2
    it.run(None)
    assert it.session.log.count("close own") == 1
    it.clock.now += 4.0
    it.run(None)
    assert it.session.log.count("close own") == 1, "it waits as long as before"
    it.meeting.held_here = True
    it.clock.now += 100.0
    it.run(None)
    assert it.session.log.count("close own") == 1, "it is the one that others look for"


def test_what_fails_on_the_thread_is_told_and_the_next_is_taken(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    it = make()

    def fail(*_: Any) -> None:
        raise RuntimeError("a bug")

    with monkeypatch.context() as broken:
        broken.setattr(it.link._remote, "appear", fail)
        it.run((True, remote_node("abc", 1)))
    it.run((True, remote_node("abc", 2)))
    assert list(it.link.problems) == ["the link's thread: a bug"]
    assert [node.name for node in it.graph.nodes] == ["n2"]


def test_what_waits_for_room_is_tried_once_a_second(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    it = make()
    tried: list[float] = []
    monkeypatch.setattr(it.link._remote, "admit_waiting", lambda: tried.append(it.clock.now))
    for _ in range(5):
        it.link._maintain_connection()
        it.clock.now += 0.6
    assert tried == pytest.approx([1000.0, 1001.2, 1002.4])


def test_a_long_backlog_is_taken_in_slices(make: Make) -> None:
    it = make()

    def slow(node: Node) -> None:
        it.clock.now += 0.002

    it.link._follow = slow  # type: ignore[method-assign, assignment]
    node = it.graph.create_node("n")
    it.clock.now = 1000.0
    for _ in range(6):
        it.link._inbox.put(node)
    it.link._take_backlog()
    assert it.clock.slept == [0.001, 0.001] and it.link._inbox.empty()


def test_after_a_flood_tokens_are_dropped_and_asked_for_again_but_own_changes_are_not_lost(
    make: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    it = make()
    it.take((True, remote_node("abc", 1)))
    monkeypatch.setattr(link_module, "MOST_WAITING", 3)
    event = threading.Event()
    gone = it.graph.create_node("gone")
    callback(gone.destroy)()
    it.link._inbox.put((True, remote_node("abc", 2)))
    it.link._inbox.put(event)
    it.session.log.clear()
    it.link._inbox.put((True, remote_node("abc", 3)))
    it.link._inbox.put((True, here("abc")[1]))
    last = threading.Event()
    it.link._inbox.put(None)
    original = it.link._start_over

    def start_over() -> None:
        original()
        it.link._inbox.put(last)

    monkeypatch.setattr(it.link, "_start_over", start_over)
    it.link._take_backlog()
    assert it.link.refusals.counts == {"floods": 1}
    assert event.is_set() and last.is_set()
    assert it.graph.nodes == () and node_token(gone, it.link.zid) not in it.session.keys("token")
    assert it.session.log[1:] == [
        "undeclare watch @ros2_lv/0/**",
        "undeclare watch @day6/0/**",
        "declare watch @day6/0/**",
        "declare watch @ros2_lv/0/**",
    ]


def test_three_waiting_are_no_flood_where_three_may_wait(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(link_module, "MOST_WAITING", 3)
    it = make()
    for number in range(3):
        it.link._inbox.put((True, remote_node("abc", number + 1)))
    it.link._take_backlog()
    assert it.link.refusals.counts == {} and len(it.graph.nodes) == 3


# -- waiting for the others --------------------------------------------------------------------------------------------


def test_who_has_no_link_waits_for_nobody(make: Make) -> None:
    assert Link(Graph()).wait_settled(5.0)
    it = make()
    sign_of("abc", it.link._place)
    it.link.problem = "none"
    assert it.link.wait_settled(5.0) and it.session.asked == []


def test_a_one_shot_command_waits_for_nobody_where_nobody_is(make: Make) -> None:
    it = make(one_shot=True)
    assert it.link.wait_settled(5.0)
    sign_of("abc", it.link._place)
    it.clock.now = 1000.0
    assert waited(it) is False, "a process is there, and no session to ask it"


def waited(it: Opened, timeout: float = 0.5) -> bool:
    """Wait with a clock that a wait moves on."""
    condition: Any = it.link._changed
    waits: list[float] = []

    class Moving:
        def __enter__(self) -> None:
            condition.acquire()

        def __exit__(self, *_: object) -> None:
            condition.release()

        def wait(self, seconds: float) -> None:
            assert 0 < seconds <= 0.02
            waits.append(seconds)
            it.clock.now += seconds

    moving: Any = Moving()
    it.link._changed = moving
    try:
        return it.link.wait_settled(timeout)
    finally:
        it.link._changed = condition
        assert not waits or sum(waits) == pytest.approx(timeout)


def test_a_process_that_has_not_said_it_is_here_is_waited_for(make: Make) -> None:
    it = make()
    sign_of("abc", it.link._place)
    assert waited(it) is False
    assert it.clock.now == pytest.approx(1000.5) and it.session.asked == []


def test_when_all_are_here_their_tokens_are_read_once_more(make: Make) -> None:
    it = make()
    sign_of("abc", it.link._place)
    it.take(here("abc"))
    it.session.present = [remote_node("abc", 1), remote_node("abc", 2)]
    thread = threading.Thread(target=follow, args=(it.link, 3))
    thread.start()
    assert it.link.wait_settled(20.0)
    thread.join()
    assert [node.name for node in it.graph.nodes] == ["n1", "n2"]
    (question,) = it.session.asked
    assert (question.key, question.options) == ("@ros2_lv/0/**", {"timeout": 5.0})


def follow(link: Link, number: int) -> None:
    for _ in range(number):
        link._take(link._inbox.get(timeout=20.0))


def test_who_does_not_get_the_tokens_in_time_is_told_so(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    it = make()
    assert it.link.wait_settled(0.0) is False, "the link's thread has not taken them"
    monkeypatch.setattr(it.session, "liveliness", lambda: SimpleNamespace(get=lambda *_, **__: None))
    while not it.link._inbox.empty():
        it.link._inbox.get()
    assert it.link.wait_settled(0.0) is False and it.link._inbox.empty()


def test_a_link_that_is_closed_while_it_asks_for_the_tokens_gets_none(make: Make) -> None:
    it = make()
    it.session.fails = True
    assert it.link.wait_settled(5.0) is False


def test_the_thread_gets_a_moment_for_the_tokens_even_when_the_time_is_over(
    make: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    it = make()
    waits: list[float] = []

    class Noted(threading.Event):
        def wait(self, timeout: float | None = None) -> bool:
            assert timeout is not None
            waits.append(timeout)
            return True

    monkeypatch.setattr(link_module.threading, "Event", Noted)
    assert it.link.wait_settled(2.0) and waits == [2.0, 2.0]
    assert it.link.wait_settled(-1.0) and waits[2:] == [0.0, 0.05]


# -- a one-shot command ------------------------------------------------------------------------------------------------


def test_a_one_shot_command_joins_when_there_is_a_meeting_point(make: Make, monkeypatch: pytest.MonkeyPatch) -> None:
    it = make(one_shot=True)
    assert it.link._meeting is None and it.session.log == []
    it.link._maintain_connection()
    assert not it.link.connected
    assert it.link._place is not None
    (it.link._place.folder / "meet").touch()

    def refuse(config: object) -> None:
        raise zenoh.ZError("nobody")

    working = zenoh.open
    monkeypatch.setattr(zenoh, "open", refuse)
    it.link._maintain_connection()
    assert not it.link.connected and list(it.link.problems) == ["no meeting point: nobody"]
    monkeypatch.setattr(zenoh, "open", working)
    it.link._maintain_connection()
    assert it.link.connected and it.session.keys("token") == []
    it.link._maintain_connection()
    assert len(it.session.keys("watch")) == 2, "it joins once"


def test_a_session_that_opens_after_the_end_is_closed(make: Make) -> None:
    it = make(one_shot=True)
    assert it.link._place is not None
    (it.link._place.folder / "meet").touch()
    it.link.close()
    it.link._try_as_client()
    assert it.session.log == ["close own"] and not it.link.connected


# -- leaving -----------------------------------------------------------------------------------------------------------


def test_leaving_gives_everything_back_once(make: Make) -> None:
    it = make()
    it.take((True, remote_node("abc", 1)))
    node = it.graph.create_node("n")
    thread: Any = it.link._thread
    it.session.log.clear()
    meeting = it.meeting
    for _ in range(2):
        it.link.close()
    assert it.session.log == ["close own"] and meeting.calls == ["close"] and thread.joined == [2.0]
    assert it.graph.nodes == (node,) and it.graph.transport is None
    assert it.link.closed and not it.link.connected
    it.graph.create_node("later")
    assert it.session.log == ["close own"]
    subscription = node.create_subscription("/t", "std_msgs/msg/String", "", QoS())
    assert subscription.gid != gid_of(endpoint_token(subscription, it.link.zid))
    assert it.link._session is None and it.link._presence_token is None and it.link._token_subscribers == []


def test_a_process_that_is_ending_keeps_its_meeting_point(make: Make) -> None:
    it = make()
    meeting = it.meeting
    it.link.close(ending=True)
    assert it.session.log[-1:] == ["close own"] and meeting.calls == ["keep"]


def test_a_session_that_does_not_close_in_order_is_told_and_the_meeting_point_is_closed(make: Make) -> None:
    it = make()
    meeting = it.meeting
    it.session.fails = True
    it.link.close()
    assert list(it.link.problems) == ["not closed in an orderly way: no"] and meeting.calls == ["close"]


def test_where_sockets_are_tcp_a_sign_stands_for_the_process_as_long_as_it_is_joined(
    make: Make, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("DAY6_LINK", "tcp")
    it = make()
    assert it.link._place is not None
    sign = it.link._place.own_socket(it.link.zid)
    assert sign.exists()
    it.link.close()
    assert not sign.exists()


@pytest.mark.parametrize(
    ("error", "words"),
    [
        (zenoh.ZError("no sockets left"), r"/r/0: no sockets left$"),
        (OSError("disk full"), r"/r/0: disk full$"),
        (LinkError("secret holds no password"), r"^secret holds no password$"),
    ],
)
def test_a_link_that_cannot_be_opened_is_closed_and_says_why(
    make: Make, monkeypatch: pytest.MonkeyPatch, error: Exception, words: str
) -> None:
    make()

    def refuse(config: object) -> None:
        raise error

    monkeypatch.setattr(zenoh, "open", refuse)
    link = Link(Graph())
    with pytest.raises(LinkError, match=words):
        link.open()
    thread: Any = link._thread
    assert link.closed and not thread.started


@pytest.mark.skipif(not Path("/dev/fd").is_dir(), reason="open files cannot be listed")
def test_a_forked_child_drops_the_link_without_touching_the_engine(make: Make) -> None:
    it = make()
    assert it.link._place is not None
    own = socket.socket(socket.AF_UNIX)
    own.bind(str(it.link._place.folder / "x"))
    it.session.log.clear()
    it.link.abandon()
    with pytest.raises(OSError):
        os.fstat(own.fileno())
    own.detach()
    assert it.meeting.calls == ["release copy"] and it.session.log == []
    assert it.link.closed and it.graph.transport is None
    node = it.graph.create_node("n")
    first, second = (node.create_subscription("/t", "std_msgs/msg/String", "", QoS()) for _ in range(2))
    assert first.gid != second.gid and first.gid != gid_of(endpoint_token(first, it.link.zid))
    assert it.session.log == []


# -- what people are told ----------------------------------------------------------------------------------------------


def test_doors_of_a_link_that_is_not_open_are_those_that_were_asked_for() -> None:
    link = Link(Graph(), listen=("tcp/a:1",), connect=("tcp/b:2",), secret="12345678")
    doors = (Door("tcp/a:1", True, secret=True), Door("tcp/b:2", False, secret=True))
    assert link.doors == doors and link.state == LinkState(None, doors, {}, ())
    assert not Link(Graph(), listen=("tcp/a:1",)).doors[0].secret


def test_the_state_tells_the_doors_of_all_processes_and_adds_what_the_gate_refused(make: Make) -> None:
    it = make()
    it.link.refusals.add("names")
    assert it.link.state == LinkState(None, (), {"names": 1}, ())
    assert it.link._place is not None
    write_doors(it.link._place, (Door("tcp/c:3", True),))
    gate: Any = SimpleNamespace(refusals=SimpleNamespace(counts={"names": 2, "nodes": 3}), close=lambda: None, doors=())
    it.link._gate = gate
    assert it.link.state == LinkState(None, (Door("tcp/c:3", True),), {"names": 3, "nodes": 3}, ())


def test_a_graph_without_a_link_has_no_state() -> None:
    assert package.state_of(Graph()) == LinkState() and package.doors_of(Graph()) == ()


def test_a_graph_of_a_program_that_stays_alone_has_a_link_that_says_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    graph = Graph()
    link = package.join(graph)
    assert package.state_of(graph).problem == link.problem == "ROS_AUTOMATIC_DISCOVERY_RANGE is OFF"
    assert package.join(graph) is link and not link.connected
    package.leave(graph)
    assert package.state_of(graph) == LinkState()


@pytest.fixture
def links(monkeypatch: pytest.MonkeyPatch) -> dict[Graph, Any]:
    """What the package knows of its links, as in a process that has just started."""
    made: dict[Graph, Any] = {}
    for name, value in {"_links": made, "_abandoned": [], "_forked": False, "_lock": threading.Lock()}.items():
        monkeypatch.setattr(package, name, value)
    return made


def test_the_child_of_a_fork_drops_all_links_for_good_and_says_why_it_has_none(
    links: dict[Graph, Any], caplog: pytest.LogCaptureFixture
) -> None:
    dropped: list[str] = []
    first, second = (SimpleNamespace(abandon=lambda name=name: dropped.append(name)) for name in "ab")
    links.update({Graph(): first, Graph(): second})
    lock = package._lock
    assert lock.acquire(), "a thread of the parent was just joining"
    package.after_fork()
    assert dropped == ["a", "b"] and links == {} and package._abandoned == [first, second]
    package.after_fork()
    graph = Graph()
    link = package.join(graph)
    assert link.problem == "this process was forked from one that had joined already" and link.problem in caplog.text
    assert package.join(graph) is link and not link.connected


def test_the_child_of_a_process_that_had_not_joined_is_as_free_as_its_parent(links: dict[Graph, Any]) -> None:
    package.after_fork()
    assert not package._forked and package._abandoned == []


def test_every_link_is_closed_when_the_interpreter_ends(links: dict[Graph, Any]) -> None:
    closed: list[tuple[str, bool]] = []
    links.update(
        {Graph(): SimpleNamespace(close=lambda ending, name=name: closed.append((name, ending))) for name in "ab"}
    )
    before = signal.getsignal(signal.SIGINT)
    try:
        package._leave_all()
        assert signal.getsignal(signal.SIGINT) == signal.SIG_IGN
    finally:
        signal.signal(signal.SIGINT, before)
    assert closed == [("a", True), ("b", True)] and links == {}


@pytest.mark.parametrize(
    ("given", "names"), [(None, ()), ("tcp/a:1", ("tcp/a:1",)), (["tcp/a:1", "tcp/b:2"], ("tcp/a:1", "tcp/b:2"))]
)
def test_doors_may_be_given_one_or_several_and_are_asked_for_though_discovery_is_off(
    links: dict[Graph, Any], monkeypatch: pytest.MonkeyPatch, given: Any, names: tuple[str, ...]
) -> None:
    monkeypatch.setenv("ROS_AUTOMATIC_DISCOVERY_RANGE", "OFF")
    opened: list[Link] = []
    monkeypatch.setattr(Link, "open", lambda link: opened.append(link))
    for how in ("listen", "connect"):
        graph = Graph()
        link = package.join(graph, **{how: given}, secret="12345678")
        assert package.doors_of(graph) == tuple(Door(name, how == "listen", secret=True) for name in names)
        assert (link in opened) == bool(names) and (link.problem is None) == bool(names)


def test_a_callback_of_the_engine_is_known_as_one_also_when_it_fails() -> None:
    seen: list[tuple[bool, int]] = []

    def fail(number: int) -> None:
        seen.append((inside_callback(), number))
        raise ValueError

    assert not inside_callback()
    with pytest.raises(ValueError):
        callback(fail)(5)
    assert seen == [(True, 5)] and not inside_callback()


def test_a_thread_with_many_messages_keeps_its_state_once_and_one_with_few_does_not(
    monkeypatch: pytest.MonkeyPatch,
) -> None:
    kept: list[int] = []
    monkeypatch.setattr(engine_thread, "_keep_thread_state", lambda: kept.append(threading.get_ident()))
    heard: list[int] = []
    rare, often = callback(heard.append), callback(heard.append, often=True)

    def many() -> None:
        for number in range(3 * engine_thread.OFTEN):
            rare(number)
        assert kept == []
        for number in range(3 * engine_thread.OFTEN):
            often(number)

    thread = threading.Thread(target=many)
    thread.start()
    thread.join()
    assert kept == [thread.ident] and len(heard) == 6 * engine_thread.OFTEN


# -- the meeting point -------------------------------------------------------------------------------------------------


@pytest.mark.parametrize("tcp", [False, True])
def test_one_process_holds_the_meeting_point_and_another_takes_over(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tcp: bool
) -> None:
    sessions: list[FakeSession] = []
    monkeypatch.setattr(zenoh, "open", lambda config: sessions.append(FakeSession(str(len(sessions)))) or sessions[-1])
    monkeypatch.setattr(meeting_module, "meeting_config", lambda place: None)
    place = MeetingPlace(tmp_path, tcp)
    one, other = MeetingPoint(place, 4), MeetingPoint(place, 4)
    assert (one.try_to_hold(), one.try_to_hold(), one.held_here) == (True, True, True)
    assert (other.try_to_hold(), other.held_here) == (False, False)
    assert [session.keys("token") for session in sessions] == [["@day6/4/meeting/zid-0"]]
    one.close()
    one.close()
    assert sessions[0].log[1:] == ["close 0"] and not one.held_here
    assert other.try_to_hold() and len(sessions) == 2
    other.release_copy()
    assert FileLock(place.meeting_lock).try_acquire(), "the copy of the lock was given back"


def test_a_kept_meeting_point_is_held_until_the_process_ends_but_not_by_its_forked_children(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    session = FakeSession()
    monkeypatch.setattr(zenoh, "open", lambda config: session)
    monkeypatch.setattr(meeting_module, "meeting_config", lambda place: None)
    monkeypatch.setattr(meeting_module, "_kept", [])
    place = MeetingPlace(tmp_path, tcp=False)
    MeetingPoint(place, 4).keep()
    one = MeetingPoint(place, 4)
    assert one.try_to_hold()
    one.keep()
    assert not MeetingPoint(place, 4).try_to_hold() and "close " not in session.log
    (tmp_path / "meet").touch()
    meeting_module.remove_kept_sockets()
    assert not (tmp_path / "meet").exists(), "nobody looks for it in vain"
    meeting_module.release_copies()
    assert FileLock(place.meeting_lock).try_acquire()


@pytest.mark.parametrize(("tcp", "failures", "held"), [(False, 1, False), (True, 1, True), (True, 2, False)])
def test_a_meeting_point_that_cannot_be_opened_is_left_to_others_and_a_taken_port_gives_way_to_another(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch, tcp: bool, failures: int, held: bool
) -> None:
    ports: list[int] = []
    place = MeetingPlace(tmp_path, tcp)
    monkeypatch.setattr(meeting_module, "meeting_config", lambda place: ports.append(place.meeting_port))

    def opened(config: object) -> FakeSession:
        if len(ports) <= failures:
            raise zenoh.ZError("in use")
        return FakeSession()

    monkeypatch.setattr(zenoh, "open", opened)
    point = MeetingPoint(place, 4)
    if held:
        assert point.try_to_hold()
    else:
        with pytest.raises(zenoh.ZError):
            point.try_to_hold()
        assert FileLock(place.meeting_lock).try_acquire()
    assert point.held_here is held
    assert len(set(ports)) == (2 if tcp else 1)

"""What the bridge mirrors, forwards, refuses and forgets, between two sessions that go nowhere."""

from __future__ import annotations

from queue import Empty
from types import SimpleNamespace
from typing import Any

import pytest
import zenoh

from day6_core.link import admission as admission_module
from day6_core.link import bridge as bridge_module
from day6_core.link import pace as pace_module
from day6_core.link.bridge import Bridge
from day6_core.link.gid import gid_of
from day6_core.link.limits import Refusals
from tests.link.clock import Clock
from tests.link.fake_engine import FakeQuery, FakeSession, StillThread, sample

TYPE = "std_msgs::msg::dds_::String_"
REMOTE = zenoh.Locality.REMOTE
TOKENS, CACHES = "@ros2_lv/3/**", "3/**/@adv/**"
DATA = f"3/t/{TYPE}/RIHS01_0"


def node(zid: str, number: int) -> str:
    return f"@ros2_lv/3/{zid}/{number}/{number}/NN/%/%/n{number}"


def endpoint(zid: str, entity: int, kind: str) -> str:
    return f"@ros2_lv/3/{zid}/1/{entity}/{kind}/%/%/n1/%t/{TYPE}/RIHS01_0/::,1:,:,:,,"


class Bridged:
    """A bridge whose thread's work is done when the test asks for it."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        self.clock = Clock()
        monkeypatch.setattr(bridge_module, "time", self.clock)
        monkeypatch.setattr(pace_module, "time", self.clock)
        monkeypatch.setattr(bridge_module, "threading", SimpleNamespace(Thread=StillThread))
        self.log: list[str] = []
        self.inner, self.outer = FakeSession("inner", self.log), FakeSession("outer", self.log)
        self.neighbours: set[str] = set()
        self.refusals = Refusals()
        self.problems: list[str] = []
        inner: Any = self.inner
        outer: Any = self.outer
        self.bridge = Bridge(inner, outer, 3, self._report, self.refusals, self.neighbours.__contains__)
        thread: Any = self.bridge._thread
        self.thread: StillThread = thread
        self.log.clear()

    def _report(self, what: str, error: Exception) -> None:
        self.problems.append(f"{what}: {error}")

    def work(self) -> None:
        """Do all that waits for the bridge's thread."""
        self.bridge._work.put(None)
        self.bridge._run()

    def token(self, session: FakeSession, key: str, *, present: bool = True) -> None:
        """Let a token appear or disappear in a session."""
        session.one("watch", TOKENS).call(sample(key, present=present))
        self.work()

    def link(self, zid: str, *, present: bool = True) -> None:
        kind = zenoh.SampleKind.PUT if present else zenoh.SampleKind.DELETE
        self.outer.one("links").call(SimpleNamespace(kind=kind, link=SimpleNamespace(zid=zid)))
        self.work()


@pytest.fixture
def it(monkeypatch: pytest.MonkeyPatch) -> Bridged:
    return Bridged(monkeypatch)


def test_both_sides_are_watched_from_the_beginning(it: Bridged) -> None:
    assert it.thread.started and it.thread.daemon
    for session in (it.inner, it.outer):
        assert sorted(session.keys("watch")) == [CACHES, TOKENS]
        assert all(each.options == {"history": True} for each in session.declared if each.what == "watch")
        assert session.one("subscriber").key == session.one("queryable").key == CACHES
        assert session.one("subscriber").options == {"allowed_origin": REMOTE}
        assert session.one("queryable").options == {"allowed_origin": REMOTE, "complete": True}
    assert it.outer.one("links").options == {"history": True} and it.inner.keys("links") == []


@pytest.mark.parametrize("kind, receiver", [("MS", "subscriber"), ("SS", "queryable"), ("MP", None), ("SC", None)])
@pytest.mark.parametrize("outward", [True, False])
def test_an_endpoint_is_mirrored_on_the_other_side_with_what_receives_for_it(
    it: Bridged, kind: str, receiver: str | None, outward: bool
) -> None:
    side, other = (it.inner, it.outer) if outward else (it.outer, it.inner)
    key = endpoint("abc", 2, kind)
    heard = [f"{receiver} {DATA}"] if receiver else []
    for _ in range(2):
        it.token(side, key)
    assert it.log == [f"declare {each}" for each in (*heard, f"token {key}")]
    assert other.keys("token") == [key] and side.keys("token") == []
    it.log.clear()
    it.token(other, key)
    it.token(other, key, present=False)
    assert it.log == [], "that was our own mirror"
    for _ in range(2):
        it.token(side, key, present=False)
    assert it.log == [f"undeclare {each}" for each in (f"token {key}", *heard)]
    assert it.problems == [] and it.refusals.counts == {}


def test_endpoints_of_one_topic_share_what_receives_for_them(it: Bridged) -> None:
    first, second = endpoint("abc", 2, "MS"), endpoint("abc", 3, "MS")
    for key in (first, second):
        it.token(it.inner, key)
    assert it.outer.keys("subscriber") == [CACHES, DATA]
    it.token(it.inner, first, present=False)
    assert it.outer.keys("subscriber") == [CACHES, DATA]
    it.token(it.inner, second, present=False)
    assert it.outer.keys("subscriber") == [CACHES]
    it.token(it.inner, first)
    assert it.outer.keys("subscriber") == [CACHES, DATA]


def test_a_session_is_of_this_machine_as_long_as_one_of_its_tokens_is_here(it: Bridged) -> None:
    for number in (1, 2):
        it.token(it.inner, node("abc", number))
    it.token(it.inner, "nonsense")
    forged = node("abc", 9)
    it.token(it.outer, forged)
    it.token(it.inner, node("abc", 1), present=False)
    it.token(it.outer, forged)
    assert it.refusals.counts == {"sessions": 2} and it.inner.keys("token") == []
    it.token(it.inner, node("abc", 2), present=False)
    it.token(it.outer, forged)
    assert it.refusals.counts == {"sessions": 2} and it.inner.keys("token") == [forged]
    it.neighbours.add("def")
    it.token(it.outer, node("def", 1))
    assert it.refusals.counts == {"sessions": 3} and it.inner.keys("token") == [forged]


def passed(attachment: bytes) -> dict[str, Any]:
    return {
        "key": DATA,
        "payload": b"payload",
        "encoding": "encoding",
        "attachment": attachment,
        "congestion_control": "congestion",
        "priority": "priority",
        "timestamp": "timestamp",
        "allowed_destination": REMOTE,
    }


def test_messages_pass_as_they_are_except_those_in_the_name_of_somebody_here(it: Bridged) -> None:
    publisher, client, subscription = (endpoint("abc", number, kind) for number, kind in enumerate(("MP", "SC", "MS")))
    for key in (publisher, client, subscription):
        it.token(it.inner, key)
    it.token(it.outer, endpoint("def", 1, "MS"))
    outside, inside = it.outer.one("subscriber", DATA), it.inner.one("subscriber", DATA)
    for key in (publisher, client, subscription):
        outside.call(sample(DATA, b"payload", b"x" * 17 + gid_of(key)))
    outside.call(sample(DATA, b"payload"))
    inside.call(sample(DATA, b"payload", gid_of(publisher)))
    it.work()
    ours = {**passed(b""), "attachment": None}
    assert it.inner.puts == [passed(b"x" * 17 + gid_of(subscription)), ours]
    assert it.outer.puts == [passed(gid_of(publisher))]
    assert it.refusals.counts == {"sessions": 2}
    for key in (publisher, client):
        it.token(it.inner, key, present=False)
        outside.call(sample(DATA, b"payload", gid_of(key)))
    it.work()
    assert len(it.inner.puts) == 4 and it.refusals.counts == {"sessions": 2}


def test_with_so_many_waiting_messages_are_dropped_and_questions_of_others_too(
    it: Bridged, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr(bridge_module, "_MOST_MESSAGES", 2)
    outside, inside = it.outer.one("subscriber"), it.inner.one("subscriber")
    for number in range(3):
        outside.call(sample("o", str(number).encode()))
    inside.call(sample("i"))
    theirs, ours = FakeQuery(), FakeQuery()
    it.outer.one("queryable").call(theirs)
    it.inner.one("queryable").call(ours)
    it.work()
    assert [each["payload"] for each in it.inner.puts] == [b"0", b"1"] and it.outer.puts == []
    assert (theirs.dropped, ours.dropped) == (1, 0)
    assert (len(it.inner.asked), len(it.outer.asked)) == (0, 1)
    it.outer.one("queryable").call(FakeQuery())
    it.work()
    assert len(it.inner.asked) == 1, "there is room again"


@pytest.mark.parametrize("outward", [True, False])
@pytest.mark.parametrize("payload", [b"request", None])
def test_a_question_passes_with_its_answers_and_ends_after_the_last(
    it: Bridged, outward: bool, payload: bytes | None
) -> None:
    side, other = (it.inner, it.outer) if outward else (it.outer, it.inner)
    query = FakeQuery(payload, b"attachment", "selector")
    side.one("queryable").call(query)
    it.work()
    assert side.asked == []
    (question,) = other.asked
    options = dict(question.options)
    assert options.pop("timeout") >= 3600
    assert (question.key, options) == (
        "selector",
        {
            "target": zenoh.QueryTarget.ALL if payload is None else zenoh.QueryTarget.ALL_COMPLETE,
            "consolidation": zenoh.ConsolidationMode.NONE,
            "accept_replies": "any",
            "payload": payload,
            "encoding": "encoding",
            "attachment": b"attachment",
            "allowed_destination": REMOTE,
        },
    )
    question.call(SimpleNamespace(ok=sample("key", b"one", b"a")))
    question.call(SimpleNamespace(ok=None))
    question.call(SimpleNamespace(ok=sample("key", b"two", b"b")))
    question.handler.drop()
    assert (query.replies, query.dropped) == ([], 0), "the engine's thread does not answer"
    it.work()
    same = {"key": "key", "encoding": "encoding", "timestamp": "timestamp"}
    assert query.replies == [
        {**same, "payload": b"one", "attachment": b"a"},
        {**same, "payload": b"two", "attachment": b"b"},
    ]
    assert query.dropped == 1 and it.problems == []


def test_a_question_in_the_name_of_somebody_here_ends_at_once(it: Bridged) -> None:
    client = endpoint("abc", 2, "SC")
    it.token(it.inner, client)
    forged, ours = FakeQuery(b"", gid_of(client)), FakeQuery(b"", gid_of(client))
    it.outer.one("queryable").call(forged)
    it.inner.one("queryable").call(ours)
    it.work()
    assert (forged.dropped, ours.dropped) == (1, 0)
    assert it.inner.asked == [] and len(it.outer.asked) == 1
    assert it.refusals.counts == {"sessions": 1}


def test_a_machine_goes_with_its_last_link_and_all_go_with_the_last_of_all(it: Bridged) -> None:
    for zid in ("abc", "abc", "def"):
        it.link(zid)
    keys = [node("abc", 1), node("def", 2), node("fee", 3)]
    for key in keys:
        it.token(it.outer, key)
    it.link("abc", present=False)
    assert it.inner.keys("token") == keys
    it.link("abc", present=False)
    assert it.inner.keys("token") == keys[1:], "the third may be behind the second"
    it.link("def", present=False)
    assert it.inner.keys("token") == []
    it.token(it.outer, keys[0])
    assert it.inner.keys("token") == keys[:1]


def test_after_a_flood_of_tokens_all_of_others_are_forgotten_and_asked_for_again(
    it: Bridged, monkeypatch: pytest.MonkeyPatch
) -> None:
    it.token(it.outer, node("abc", 1))
    it.token(it.inner, node("def", 1))
    monkeypatch.setattr(bridge_module, "MOST_WAITING", 2)
    watch = it.outer.one("watch", TOKENS)
    for number in (2, 3):
        watch.call(sample(node("abc", number)))
    assert not it.bridge._flooded
    watch.call(sample(node("abc", 4)))
    it.inner.one("watch", TOKENS).call(sample(node("def", 2)))
    it.log.clear()
    it.work()
    assert it.refusals.counts == {} and it.inner.keys("token") == [node("abc", number) for number in (1, 2, 3)]
    it.bridge._do_upkeep()
    it.bridge._do_upkeep()
    assert it.refusals.counts == {"floods": 1} and it.inner.keys("token") == []
    assert it.outer.keys("token") == [node("def", 1), node("def", 2)]
    assert sorted(it.outer.keys("watch")) == sorted(it.inner.keys("watch")) == [CACHES, TOKENS]
    assert it.log.count(f"undeclare watch {TOKENS}") == it.log.count(f"undeclare watch {CACHES}") == 1
    it.token(it.outer, node("abc", 4))
    assert it.inner.keys("token") == [node("abc", 4)]


def test_who_was_refused_is_looked_at_again_every_second(it: Bridged, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(admission_module, "MOST_NODES_OF_ONE", 1)
    it.token(it.outer, node("abc", 1))
    it.token(it.outer, node("abc", 2))
    it.token(it.outer, node("abc", 1), present=False)
    assert it.inner.keys("token") == []
    it.clock.now += 0.9
    it.bridge._do_upkeep()
    assert it.inner.keys("token") == []
    it.clock.now += 0.2
    it.bridge._do_upkeep()
    assert it.inner.keys("token") == [node("abc", 2)]


def test_upkeep_is_done_when_a_second_brings_no_work(it: Bridged) -> None:
    waits: list[float] = []

    class Quiet:
        def get(self, *, timeout: float) -> Any:
            waits.append(timeout)
            if len(waits) == 1:
                raise Empty
            return None

        def empty(self) -> bool:
            return True

    work: Any = Quiet()
    it.bridge._work = work
    it.bridge._flooded = True
    it.bridge._run()
    assert waits == [1.0, 1.0] and it.refusals.counts == {"floods": 1}


def test_what_cannot_be_forwarded_is_told_and_the_rest_is_forwarded(it: Bridged) -> None:
    it.inner.fails = True
    it.outer.one("subscriber").call(sample("o"))
    it.inner.one("subscriber").call(sample("i"))
    it.work()
    assert it.problems == ["the bridge to other machines: no"]
    assert [each["key"] for each in it.outer.puts] == ["i"]


def test_long_work_leaves_the_program_a_turn_every_five_milliseconds(it: Bridged) -> None:
    def busy() -> None:
        it.clock.now += 0.002

    for _ in range(6):
        it.bridge._work.put(busy)
    it.work()
    assert it.clock.slept == [0.001, 0.001]


def test_ten_thousand_messages_wait_and_no_more(it: Bridged) -> None:
    for _ in range(10_002):
        it.inner.one("subscriber").call(sample("i"))
    it.work()
    assert len(it.outer.puts) == 10_000


def test_at_the_end_both_sessions_are_closed_this_machines_first_and_nothing_is_kept(it: Bridged) -> None:
    it.token(it.outer, endpoint("abc", 2, "MS"))
    it.token(it.inner, endpoint("def", 2, "SS"))
    it.inner.fails = True
    it.log.clear()
    it.bridge.close()
    assert it.log == ["close inner", "close outer"]
    assert it.thread.joined == [1.0] and it.bridge._work.get_nowait() is None
    kept = (*it.bridge._tokens, it.bridge._routes, it.bridge._declared, it.bridge._token_subscribers)
    assert not any(kept) and it.bridge._sessions == ()

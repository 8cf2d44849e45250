"""Who is let in, who waits, who is forgotten: the bookkeeping of the gate and of the remote graph, without any network."""

from __future__ import annotations

from typing import Any

import pytest

from day6_core.graph import Graph
from day6_core.graph.endpoints import EndpointKind
from day6_core.link import admission as gate_rules
from day6_core.link import remote as remote_rules
from day6_core.link.admission import Admission, Token, token_of
from day6_core.link.gid import gid_of
from day6_core.link.limits import Refusals
from day6_core.link.remote import Origin, RemoteGraph

OWN = "0dd"
TYPE = "std_msgs::msg::dds_::String_"


def node(zid: str, number: int, name: str = "n") -> str:
    return f"@ros2_lv/0/{zid}/{number}/{number}/NN/%/%/{name}{number}"


def endpoint(zid: str, number: int, entity: int, kind: str = "MP", topic: str = "%t", dds: str = TYPE) -> str:
    return f"@ros2_lv/0/{zid}/{number}/{entity}/{kind}/%/%/n{number}/{topic}/{dds}/RIHS01_0/::,1:,:,:,,"


CACHE = f"0/a/b/{TYPE.replace('::', '__')}/@adv/pub/abc/1"


@pytest.mark.parametrize(
    ("key", "token"),
    [
        (node("abc", 1), Token("abc", True)),
        (endpoint("abc", 1, 2), Token("abc", False, "MP", f"0/t/{TYPE}/RIHS01_0")),
        (endpoint("abc", 1, 2, "SS", "%a%b"), Token("abc", False, "SS", f"0/a/b/{TYPE}/RIHS01_0")),
        (CACHE, Token("abc", False)),
        (CACHE.replace("pub", "sub"), Token("abc", False)),
        (CACHE.replace("pub", "pup"), None),
        (f"{CACHE}/2/3", None),
        (f"x{CACHE}", None),
        ("@ros2_lv/0/abc", None),
        ("", None),
        ("a/" * 1100, None),
    ],
)
def test_a_token_says_whose_it_is_and_of_what(key: str, token: Token | None) -> None:
    assert token_of(key) == token


def test_a_caches_token_may_have_2048_characters() -> None:
    def cache(length: int) -> str:
        head, tail = "0", "/@adv/pub/abc/1"
        body = ("/" + "a" * 200) * 9
        return head + body + "/" + "b" * (length - len(head) - len(body) - 1 - len(tail)) + tail

    assert token_of(cache(2048)) == Token("abc", False)
    assert token_of(cache(2049)) is None


class Gate:
    """An admission with small limits; `here` are the sessions of this machine."""

    def __init__(self, monkeypatch: pytest.MonkeyPatch) -> None:
        limits = {"MOST_NODES": 4, "MOST_NODES_OF_ONE": 2, "MOST_ENDPOINTS": 5, "MOST_ENDPOINTS_OF_ONE": 3}
        for name, most in {**limits, "MOST_WAITING_FOR_ROOM": 2}.items():
            monkeypatch.setattr(gate_rules, name, most)
            monkeypatch.setattr(remote_rules, name, most)
        self.here: set[str] = set()
        self.refusals = Refusals()
        self.admission = Admission(self.here.__contains__, self.refusals)

    def come(self, *keys: str) -> list[bool]:
        return [self.admission.admit(key) is not None for key in keys]


@pytest.fixture
def gate(monkeypatch: pytest.MonkeyPatch) -> Gate:
    return Gate(monkeypatch)


def test_one_session_has_so_many_nodes_and_so_many_endpoints(gate: Gate) -> None:
    assert gate.come(*(node("a", number) for number in range(1, 4))) == [True, True, False]
    assert gate.come(*(endpoint("a", 1, number) for number in range(1, 5))) == [True, True, True, False]
    assert gate.refusals.counts == {"nodes": 1, "endpoints": 1}


def test_all_sessions_together_have_so_many(gate: Gate) -> None:
    assert gate.come(*(node(zid, 1) for zid in "abcde")) == [True] * 4 + [False]
    assert gate.come(*(endpoint(zid, 1, 1) for zid in "abcdef")) == [True] * 5 + [False]


def test_what_is_let_in_is_told_once(gate: Gate) -> None:
    assert gate.admission.admit(node("a", 1)) == Token("a", True)
    assert gate.admission.admit(node("a", 1)) is None
    assert gate.refusals.counts == {}
    assert gate.admission.remove(node("a", 1)) == Token("a", True)
    assert gate.admission.remove(node("a", 1)) is None
    assert gate.admission.admit(node("a", 1)) == Token("a", True)


def test_a_session_of_this_machine_and_a_token_of_no_form_are_refused_for_good(gate: Gate) -> None:
    gate.here.add("a")
    assert gate.come(node("a", 1), "nonsense") == [False, False]
    assert gate.refusals.counts == {"sessions": 1, "names": 1}
    gate.here.clear()
    assert list(gate.admission.admit_waiting()) == []


def test_who_waits_is_let_in_when_another_has_gone_and_is_counted_once(gate: Gate) -> None:
    first, second, third = (node("a", number) for number in (1, 2, 3))
    gate.come(first, second, third, third)
    assert gate.refusals.counts == {"nodes": 1}
    assert list(gate.admission.admit_waiting()) == [], "nothing has gone yet"
    gate.admission.remove(first)
    assert list(gate.admission.admit_waiting()) == [(third, Token("a", True))]
    assert gate.refusals.counts == {}, "nobody waits any more"
    assert sorted(gate.admission.tokens_of("a")) == [second, third]


def test_room_for_one_lets_in_the_one_that_waits_longest(gate: Gate) -> None:
    keys = [node("a", number) for number in (1, 2, 3, 4)]
    gate.come(*keys)
    gate.admission.remove(keys[1])
    assert [key for key, _ in gate.admission.admit_waiting()] == [keys[2]]
    assert gate.refusals.counts == {"nodes": 2}, "one waits still"
    gate.admission.remove(keys[0])
    assert [key for key, _ in gate.admission.admit_waiting()] == [keys[3]]


def test_who_went_while_waiting_is_not_let_in(gate: Gate) -> None:
    keys = [node("a", number) for number in (1, 2, 3)]
    gate.come(*keys)
    assert gate.admission.remove(keys[2]) is None
    gate.admission.remove(keys[0])
    assert list(gate.admission.admit_waiting()) == []


def test_only_so_many_wait(gate: Gate) -> None:
    keys = [node("a", number) for number in range(1, 7)]
    gate.come(*keys)
    assert gate.refusals.counts == {"nodes": 4}
    gate.admission.remove(keys[0])
    gate.admission.remove(keys[1])
    assert [key for key, _ in gate.admission.admit_waiting()] == keys[2:4]
    assert list(gate.admission.admit_waiting()) == []


def test_who_turns_out_to_live_here_stays_outside(gate: Gate) -> None:
    keys = [node("a", number) for number in (1, 2, 3)]
    gate.come(*keys)
    gate.admission.remove(keys[0])
    gate.here.add("a")
    assert list(gate.admission.admit_waiting()) == []


def test_the_tokens_of_one_session_or_of_all_are_found_and_what_waits_of_them_is_forgotten(gate: Gate) -> None:
    inside = [node("a", 1), node("a", 2), endpoint("a", 1, 3), node("b", 1)]
    gate.come(*inside, node("a", 3))
    assert gate.admission.tokens_of("a") == inside[:3]
    assert gate.admission.tokens_of(None) == inside
    for key in inside[:3]:
        gate.admission.remove(key)
    assert list(gate.admission.admit_waiting()) == []
    assert gate.admission.tokens_of("c") == []


def test_nothing_is_said_to_wait_when_who_waited_has_gone(gate: Gate) -> None:
    gate.come(*(node(zid, 1) for zid in "abcde"))
    assert gate.refusals.counts == {"nodes": 1}
    assert gate.admission.tokens_of("e") == []
    assert list(gate.admission.admit_waiting()) == [] and gate.refusals.counts == {}


# -- the graph of what is remote ---------------------------------------------------------------------------------------


class Remote:
    """A remote graph with the same small limits."""

    def __init__(self, gate: Gate) -> None:
        self.graph = Graph()
        self.refusals = gate.refusals
        self.remote = RemoteGraph(self.graph, OWN, self.refusals, gate.here.__contains__)

    def appear(self, *tokens: str) -> None:
        for token in tokens:
            self.remote.appear(token)

    @property
    def nodes(self) -> list[str]:
        return [each.name for each in self.graph.nodes]

    def topics(self, *kinds: EndpointKind) -> list[tuple[str, list[str]]]:
        return self.graph.names_and_types(*kinds)


@pytest.fixture
def remote(gate: Gate) -> Remote:
    gate.here.clear()
    return Remote(gate)


def test_a_node_comes_with_its_origin_and_goes_with_its_endpoints(remote: Remote) -> None:
    remote.appear(node("a", 1), endpoint("a", 1, 2), endpoint("a", 1, 3, "MS"))
    (found,) = remote.graph.nodes
    assert (found.name, found.origin) == ("n1", Origin("a"))
    assert remote.topics(EndpointKind.PUBLISHER) == [("/t", ["std_msgs/msg/String"])]
    remote.remote.vanish(node("a", 1))
    assert remote.nodes == [] and remote.topics(EndpointKind.PUBLISHER) == []
    remote.remote.vanish(node("a", 1))


@pytest.mark.parametrize(
    ("kind", "dds"), [("MP", TYPE), ("MS", TYPE), ("SS", "a::srv::dds_::B_"), ("SC", "a::srv::dds_::B_")]
)
def test_each_kind_of_endpoint_becomes_what_it_is(remote: Remote, kind: str, dds: str) -> None:
    token = endpoint("a", 1, 2, kind, dds=dds)
    remote.appear(token)
    type_name = "std_msgs/msg/String" if dds == TYPE else "a/srv/B"
    for each in EndpointKind:
        expected = [("/t", [type_name])] if each.value == kind else []
        assert remote.topics(each) == expected
    remote.remote.vanish(token)
    assert all(remote.topics(each) == [] for each in EndpointKind)


def test_what_is_this_processs_own_is_passed_over(remote: Remote) -> None:
    remote.appear(node(OWN, 1))
    assert remote.nodes == [] and remote.refusals.counts == {}


def test_an_endpoint_may_come_before_its_node_and_go_after_it(remote: Remote) -> None:
    remote.appear(endpoint("a", 1, 2))
    assert remote.nodes == ["n1"]
    remote.appear(node("a", 1))
    assert remote.nodes == ["n1"], "the same one"
    remote.remote.vanish(endpoint("a", 1, 2))
    assert remote.nodes == ["n1"], "it has announced itself"
    remote.remote.vanish(node("a", 1))
    remote.remote.vanish(endpoint("a", 1, 2))
    assert remote.nodes == []


def test_a_node_that_never_announced_itself_goes_with_its_last_endpoint(remote: Remote) -> None:
    remote.appear(endpoint("a", 1, 2), endpoint("a", 1, 3))
    remote.remote.vanish(endpoint("a", 1, 2))
    assert remote.nodes == ["n1"]
    remote.remote.vanish(endpoint("a", 1, 3))
    assert remote.nodes == []


def test_the_same_token_twice_makes_one_endpoint(remote: Remote) -> None:
    remote.appear(*[endpoint("a", 1, 2)] * 3, *[node("a", 1)] * 3)
    assert len(remote.graph.nodes) == len(remote.graph.endpoints(EndpointKind.PUBLISHER)) == 1
    remote.remote.vanish(endpoint("a", 1, 2))
    assert remote.graph.endpoints(EndpointKind.PUBLISHER) == []
    assert remote.nodes == ["n1"]


def test_limits_hold_for_one_and_for_all_but_neighbours_find_room(remote: Remote, gate: Gate) -> None:
    remote.appear(*(node("a", number) for number in (1, 2, 3)))
    assert remote.nodes == ["n1", "n2"] and remote.refusals.counts == {"nodes": 1}
    remote.appear(node("b", 1), node("c", 1), node("d", 1))
    assert len(remote.nodes) == 4
    gate.here.add("e")
    remote.appear(node("e", 1), node("e", 2), node("e", 3))
    assert len(remote.nodes) == 6, "of one process there are never more than its share"


def test_limits_of_endpoints_hold_for_one_and_for_all_but_neighbours_find_room(remote: Remote, gate: Gate) -> None:
    def count(zid: str) -> int:
        remote.appear(*(endpoint(zid, 1, number, topic=f"%{zid}{number}") for number in range(1, 6)))
        return sum(name.startswith(f"/{zid}") for name, _ in remote.topics(EndpointKind.PUBLISHER))

    gate.here.add("e")
    assert [count(zid) for zid in ("a", "b", "c", "e")] == [3, 2, 0, 3]


def test_what_waits_comes_when_there_is_room(remote: Remote) -> None:
    remote.appear(*(node("a", number) for number in (1, 2, 3, 4, 5)))
    assert not remote.remote.has_room
    remote.remote.admit_waiting()
    assert remote.nodes == ["n1", "n2"]
    remote.remote.vanish(node("a", 4))
    assert not remote.remote.has_room, "one that waited has gone, none that was inside"
    remote.remote.vanish(node("a", 1))
    assert remote.remote.has_room
    remote.remote.admit_waiting()
    assert remote.nodes == ["n2", "n3"]
    assert remote.refusals.counts == {}
    assert not remote.remote.has_room


def test_clear_removes_all_and_forgets_who_waits(remote: Remote) -> None:
    remote.appear(*(node("a", number) for number in (1, 2, 3)), endpoint("a", 1, 7))
    remote.remote.clear()
    assert remote.nodes == []
    remote.remote.admit_waiting()
    assert remote.nodes == []
    remote.appear(*(node("a", number) for number in (1, 2)), *(endpoint("a", 1, number) for number in (1, 2, 3)))
    assert len(remote.nodes) == 2 and remote.refusals.counts.get("endpoints") is None, "nothing is counted twice"


def test_a_message_is_from_who_has_its_gid_if_they_match(remote: Remote) -> None:
    from day6_core.graph import QoS
    from day6_core.graph.qos import Reliability

    here = remote.graph.create_node("here", "/")
    hears = here.create_subscription("/t", "std_msgs/msg/String", "RIHS01_0", QoS(depth=1))
    strict = QoS(depth=1, reliability=Reliability.RELIABLE)
    other_type = here.create_subscription("/t", "std_msgs/msg/Int32", "RIHS01_1", strict)
    token = endpoint("a", 1, 2)
    remote.appear(token)
    sender: Any = remote.remote.publisher_for(gid_of(token), hears)
    assert remote.graph.endpoints(EndpointKind.PUBLISHER) == [sender] and sender.gid == gid_of(token)
    assert remote.remote.publisher_for(gid_of(token), other_type) is None
    stranger: Any = remote.remote.publisher_for(b"?" * 16, hears)
    assert stranger.gid == b"?" * 16 and stranger.topic == "/t"
    assert remote.remote.publisher_for(b"?" * 16, hears) is stranger
    remote.remote.vanish(token)
    assert remote.remote.publisher_for(gid_of(token), hears) is not sender, "who has gone is a stranger"

"""A class on a network: each pupil's graph is a graph of its own, the teacher has all of them below their names."""

from __future__ import annotations

from collections.abc import Iterator
from functools import partial
from pathlib import Path
from typing import Any

import pytest
import zenoh

from day6_core.classroom import handed
from day6_core.classroom.handed import LARGEST
from day6_core.link import leave, state_of
from day6_core.link.classroom.keys import DOWN, SHOWN, file_key, is_name, note_key, order_key
from day6_core.link.classroom.pupil import Pupil
from day6_core.link.classroom.teacher import Teacher
from day6_core.link.state import DoorState
from tests.link.link_harness import Peer, World
from tests.support.free_port import free_port
from tests.support.waiting import until


class Class:
    """Makes the machines of a class: each has a meeting place of its own, as it would have."""

    def __init__(self, folder: Path, short: Path, monkeypatch: pytest.MonkeyPatch) -> None:
        self._folder, self._short, self._monkeypatch = folder, short, monkeypatch
        self._worlds: list[World] = []
        self.endpoint = f"tcp/127.0.0.1:{free_port()}"

    def machine(self, **arguments: Any) -> Peer:
        runtime = self._short / str(len(self._worlds))
        self._monkeypatch.setenv("DAY6_RUNTIME_DIR", str(runtime))
        world = World(self._folder, runtime)
        self._worlds.append(world)
        peer: Peer = world.here(**arguments)
        return peer

    def teacher(self, part: Teacher | None = None, **arguments: Any) -> Peer:
        return self.machine(listen=self.endpoint, part=part or Teacher(), **arguments)

    def pupil(self, name: str, part: Pupil | None = None, **arguments: Any) -> Peer:
        return self.machine(connect=self.endpoint, part=part or Pupil(name), **arguments)

    def close(self) -> None:
        for world in reversed(self._worlds):
            world.close()


@pytest.fixture
def school(short_folder: Path, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Iterator[Class]:
    monkeypatch.setenv("DAY6_LINK", "on")
    made = Class(tmp_path, short_folder, monkeypatch)
    yield made
    made.close()


def state(peer: Peer) -> DoorState:
    (only,) = state_of(peer.graph).doors
    return only.state


def sees(peer: Peer, *nodes: str) -> bool:
    return peer.nodes() == list(nodes)


@pytest.mark.process
def test_the_teacher_sees_each_pupil_below_a_name_and_no_pupil_another(school: Class) -> None:
    teacher, anna, ben = school.teacher(), school.pupil("anna"), school.pupil("ben", domain_id=7)
    for pupil in (anna, ben):
        pupil.node("turtlesim")
    teacher.node("desk")
    assert until(lambda: teacher.nodes() == ["/anna/turtlesim", "/ben/turtlesim", "/desk"])
    assert anna.nodes() == ben.nodes() == ["/turtlesim"]
    assert state(anna) == state(ben) == DoorState.OPEN


@pytest.mark.process
def test_messages_go_both_ways_and_to_one_pupil_only(school: Class) -> None:
    teacher, anna, ben = school.teacher(), school.pupil("anna"), school.pupil("ben", domain_id=7)
    turtles = [pupil.subscription(pupil.node("turtlesim"), "/turtle1/cmd_vel") for pupil in (anna, ben)]
    desk, talker = teacher.node("desk"), ben.node("talker")
    drive, news = teacher.publisher(desk, "/anna/turtle1/cmd_vel"), ben.publisher(talker, "/news")
    teacher.subscription(desk, "/anna/news")
    heard = teacher.subscription(desk, "/ben/news")
    assert until(lambda: teacher.matched(drive) == 1 and ben.matched(news) == 1)
    assert until(lambda: anna.nodes() == ["/teacher/desk", "/turtlesim"])
    # It says that it listens before it does: what is published in between is lost, as between any two of ROS.
    told = until(lambda: anna.messages(turtles[0]), meanwhile=lambda: teacher.publish(drive, data="forward"))
    assert set(told) == {"forward"}
    told = until(lambda: teacher.messages(heard), meanwhile=lambda: ben.publish(news, data="hello"))
    assert set(told) == {"hello"}
    assert ben.messages(turtles[1]) == []


@pytest.mark.process
def test_services_and_kept_messages_reach_through_the_names(school: Class) -> None:
    teacher, anna = school.teacher(), school.pupil("anna", domain_id=5)
    node = anna.node("turtlesim")
    anna.service(node, "/spawn", offset=100)
    map_ = anna.publisher(node, "/map", latched=True)
    anna.publish(map_, data="kept")
    desk = teacher.node("desk")
    client = teacher.client(desk, "/anna/spawn")
    assert until(lambda: teacher.matched(client))
    teacher.call(client, 1, 2)
    assert [total for _, total in until(lambda: teacher.responses(client))] == [103]
    late = teacher.subscription(desk, "/anna/map", latched=True)
    assert until(lambda: teacher.messages(late) == ["kept"])


@pytest.mark.process
def test_a_name_is_given_once_and_again_when_it_is_free(school: Class) -> None:
    part, turned_away = Teacher(), list[tuple[str, str]]()
    part.turned_away = lambda *who: turned_away.append(who)
    school.teacher(part)
    first = school.pupil("anna")
    assert until(lambda: state(first) == DoorState.OPEN)
    second = school.pupil("anna")
    assert until(lambda: state(second) == DoorState.NAME_TAKEN)
    assert until(lambda: turned_away[:2] == [("anna", "taken")] * 2) and part.joined == 1  # as long as it asks
    third = school.pupil("Anna")
    assert until(lambda: state(third) == DoorState.NAME_ALIKE and ("Anna", "alike") in turned_away)
    leave(third.graph)
    leave(first.graph)
    assert until(lambda: state(second) == DoorState.OPEN)
    assert until(lambda: not part._refused.keys() & set(part._here.values()))


@pytest.mark.process
def test_a_pupil_waits_for_the_teacher_and_finds_the_next_one(school: Class) -> None:
    met: list[bool] = []
    part = Pupil("anna")
    part.met = met.append
    anna = school.pupil("anna", part)
    anna.node("turtlesim")
    assert until(lambda: state(anna) == DoorState.NOBODY)
    for _ in range(2):
        teacher = school.teacher()
        assert until(partial(sees, teacher, "/anna/turtlesim"))
        assert until(lambda: met[-1:] == [True])
        leave(teacher.graph)
        assert until(lambda: met[-1] is False)


@pytest.mark.process
def test_notes_come_and_orders_go(school: Class) -> None:
    part, pupil, notes, orders, came = Teacher(), Pupil("anna"), [], [], []
    part.noted, part.came = (lambda *note: notes.append(note)), (lambda *who: came.append(who))
    met: list[bool] = []
    pupil.ordered, pupil.met = orders.append, met.append
    school.teacher(part)
    anna = school.pupil("anna", pupil)
    # The teacher may know first; and the pupil tells nothing before it knows that it was let in.
    assert until(lambda: came == [("anna", True)] and met)
    pupil.tell(b"a note")
    assert until(lambda: notes == [("anna", b"a note")])
    assert part.order("anna", b"an order")
    assert until(lambda: orders == [b"an order"])
    assert not part.order("ben", b"an order")
    leave(anna.graph)
    assert until(lambda: came[1:] == [("anna", False)])


@pytest.mark.process
def test_whoever_connects_past_the_class_reaches_no_pupil(school: Class) -> None:
    teacher, anna = school.teacher(), school.pupil("anna")
    turtle = anna.subscription(anna.node("turtlesim"), "/turtle1/cmd_vel")
    desk = teacher.node("desk")
    drive = teacher.publisher(desk, "/anna/turtle1/cmd_vel")
    assert until(lambda: teacher.matched(drive) == 1)
    stranger = school.machine(connect=school.endpoint)
    own = stranger.publisher(stranger.node("stranger"), "/anna/turtle1/cmd_vel")
    assert until(lambda: state(stranger) == DoorState.OPEN)
    config = zenoh.Config.from_json5(f'{{mode: "client", connect: {{endpoints: ["{school.endpoint}"]}}}}')
    with zenoh.open(config) as session:
        spied: list[str] = []
        spy = session.declare_subscriber("**", lambda sample: spied.append(str(sample.key_expr)))
        tokens = session.liveliness().get("day6_class/up/*/@ros2_lv/**", timeout=2.0)
        session.put("day6_class/down/anna/0/turtle1/cmd_vel/std_msgs::msg::dds_::String_/x", b"prank")
        stranger.publish(own, data="prank")
        heard = until(lambda: anna.messages(turtle), meanwhile=lambda: teacher.publish(drive, data="real"))
        assert set(heard) == {"real"}
        assert list(tokens) == []
        assert all(key.startswith("day6_class/down/anna/") for key in spied if "prank" not in key)
        spy.undeclare()
    assert stranger.nodes() == ["/stranger"]
    assert "/stranger" not in teacher.nodes()


@pytest.mark.process
@pytest.mark.parametrize("room", [False, True])
def test_the_teacher_shows_to_all_and_no_pupil_does(school: Class, room: bool) -> None:
    teacher, parts = Teacher(room=room), [Pupil("anna"), Pupil("ben")]
    seen: list[list[bytes]] = [[], []]
    orders: list[bytes] = []
    for part, pictures in zip(parts, seen, strict=True):
        part.shown, part.ordered = pictures.append, orders.append
        school.pupil(part.name, part)
    school.teacher(teacher)
    assert until(lambda: all(seen), meanwhile=lambda: teacher.show(b"real"))
    config = zenoh.Config.from_json5(f'{{mode: "client", connect: {{endpoints: ["{school.endpoint}"]}}}}')
    with zenoh.open(config) as session:
        for key in (
            SHOWN,
            f"{DOWN}/teacher/*",
            f"{DOWN}/**",
            "day6_class/**",
            "**",
            f"{DOWN}/*/order",
            order_key("anna"),
        ):
            session.put(key, b"prank")
        session.put(note_key("anna"), b"the last")  # which is let through, after all of these
        heard: list[bytes] = []
        teacher.noted = lambda name, note: heard.append(note)
        assert until(lambda: b"the last" in heard, meanwhile=lambda: session.put(note_key("anna"), b"the last"))
    count = len(seen[0])
    assert until(lambda: len(seen[0]) > count and len(seen[1]) > 1, meanwhile=lambda: teacher.show(b"real"))
    assert set(seen[0]) == set(seen[1]) == {b"real"} and orders == []


@pytest.mark.process
@pytest.mark.parametrize("room", [False, True])
def test_the_teacher_hands_a_file_and_no_pupil_does(school: Class, tmp_path: Path, room: bool) -> None:
    teacher, anna = Teacher(room=room), Pupil("anna")
    anna.handed = partial(handed.receive, tmp_path)
    school.teacher(teacher)
    school.pupil("anna", anna)
    sent = handed.message("talker.py", b"a" * LARGEST)
    answer = until(lambda: teacher.hand("anna", sent))
    assert handed.read_answer(answer) == handed.Answer("handed/talker.py")
    assert teacher.hand("anna", sent) == answer and teacher.hand("ben", sent) is None
    config = zenoh.Config.from_json5(f'{{mode: "client", connect: {{endpoints: ["{school.endpoint}"]}}}}')
    with zenoh.open(config) as session:
        for key in (file_key("anna"), f"{DOWN}/*/file", f"{DOWN}/**", "**"):
            prank = handed.message("prank.py", b"prank")
            assert not [reply for reply in session.get(key, payload=prank, timeout=1.0) if reply.ok is not None]
    assert [path.name for path in (tmp_path / "handed").iterdir()] == ["talker.py"]


@pytest.mark.process
def test_in_a_room_all_are_in_one_graph(school: Class) -> None:
    teacher = school.teacher(Teacher(room=True))
    anna, ben = school.pupil("anna"), school.pupil("ben")
    other = school.pupil("cem", domain_id=3)
    anna.node("turtlesim", "/anna")
    ben.node("turtlesim", "/ben")
    both = ["/anna/turtlesim", "/ben/turtlesim"]
    assert until(lambda: teacher.nodes() == anna.nodes() == ben.nodes() == both)
    assert until(lambda: state(other) == DoorState.OTHER_DOMAIN)
    assert other.nodes() == []


@pytest.mark.process
def test_a_pupil_follows_a_teacher_who_begins_again_with_a_room_and_back(school: Class) -> None:
    anna = school.pupil("anna")
    anna.node("turtlesim")
    for room, seen in ((False, "/anna/turtlesim"), (True, "/turtlesim"), (False, "/anna/turtlesim")):
        teacher = school.teacher(Teacher(room=room))
        assert until(partial(sees, teacher, seen)), seen
        leave(teacher.graph)


@pytest.mark.parametrize(
    ("name", "may"), [("anna", True), ("Anna_2", True), ("a" * 33, False), ("安娜", False), ("", False)]
)
def test_a_name_is_a_part_of_a_ros_name(name: str, may: bool) -> None:
    assert is_name(name) == may

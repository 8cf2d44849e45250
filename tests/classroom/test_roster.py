"""The teacher's list of the class."""

from __future__ import annotations

from day6_core.classroom.note import LessonPlace, Note, Trouble
from day6_core.classroom.order import Order
from day6_core.classroom.roster import FROZEN_SECONDS, STUCK_SECONDS, Roster

ERROR = Trouble({"en": "Not found"}, "Package 'turtlesin' not found")


class Clock:
    now = 100.0

    def __call__(self) -> float:
        return self.now


class Carrier:
    def __init__(self, *reached: str) -> None:
        self.reached, self.sent = reached, list[tuple[str, Order]]()

    def send(self, name: str, order: Order) -> bool:
        self.sent.append((name, order))
        return name in self.reached


def names(roster: Roster) -> list[str]:
    return [row.name for row in roster.rows()]


def test_who_needs_somebody_comes_first() -> None:
    clock = Clock()
    roster = Roster(clock=clock)
    for name in ("anna", "ben", "carl", "dora", "emil"):
        roster.heard(name, Note())
    roster.gone("anna")
    roster.heard("dora", Note(trouble=ERROR))
    clock.now += 5
    roster.heard("emil", Note(hand=True))
    clock.now += 5
    roster.heard("carl", Note(hand=True))
    assert names(roster) == ["emil", "carl", "ben", "dora", "anna"]
    clock.now += STUCK_SECONDS
    assert names(roster) == ["emil", "carl", "dora", "ben", "anna"]
    roster.heard("dora", Note(trouble=ERROR))  # the same error stands, whatever else has changed
    assert names(roster) == ["emil", "carl", "dora", "ben", "anna"]
    roster.heard("dora", Note())
    roster.heard("emil", Note())
    assert names(roster) == ["carl", "ben", "dora", "emil", "anna"]


def test_idle_time_goes_on_while_nothing_is_heard() -> None:
    clock = Clock()
    roster = Roster(clock=clock)
    roster.heard("anna", Note(idle=10))
    clock.now += 50
    row = roster.row("anna")
    assert row is not None and row.idle(roster.now) == 60


def test_orders_go_to_those_who_are_reached() -> None:
    carrier = Carrier("anna")
    roster = Roster(carrier, Clock())
    for name in ("anna", "ben"):
        roster.heard(name, Note())
    say = Order("say", text="hello")
    assert roster.order(roster.everybody(), say) == ["ben"]
    assert carrier.sent == [("anna", say), ("ben", say)]
    roster.gone("ben")
    assert roster.everybody() == ["anna"]


def test_the_report_tells_how_far_everybody_came() -> None:
    roster = Roster(clock=Clock())
    for step in (1, 5, 3):
        roster.heard("anna", Note(lesson=LessonPlace("day3", {}, step, 12)))
    roster.heard("anna", Note(lesson=LessonPlace("day4", {}, 1, 9)))
    roster.here("ben")
    assert roster.report() == [("anna", "day3", 5, 12), ("anna", "day4", 1, 9), ("ben", "", 0, 0)]


def test_a_crowd_that_is_no_class_has_an_end() -> None:
    roster = Roster(clock=Clock())
    for number in range(1000):
        roster.heard(f"n{number}", Note())
    assert len(roster.rows()) == 200


def test_who_is_expected_and_has_not_come_is_in_the_list_at_its_end() -> None:
    roster = Roster(clock=Clock())
    roster.expect(["anna", "ben", "carl"])
    roster.here("carl")
    roster.here("ben")
    roster.gone("ben")
    assert [(row.name, row.is_here, row.has_come) for row in roster.rows()] == [
        ("carl", True, True),
        ("ben", False, True),
        ("anna", False, False),
    ]
    assert roster.everybody() == ["carl"]


def test_who_comes_while_the_class_is_frozen_is_frozen_too() -> None:
    clock, carrier = Clock(), Carrier("anna", "ben")
    roster = Roster(carrier, clock)
    roster.attend(True)
    roster.here("anna")
    assert roster.freeze(True) == [] and roster.is_frozen
    carrier.sent.clear()
    roster.here("ben")
    assert carrier.sent == [("ben", Order("attend", on=True)), ("ben", Order("freeze", on=True))]
    roster.freeze(False)
    carrier.sent.clear()
    roster.here("anna")
    assert carrier.sent == [("anna", Order("attend", on=True))]
    carrier.sent.clear()
    roster.heard("anna", Note())  # what was sent had not arrived
    roster.heard("anna", Note(attended=True))
    roster.heard("anna", Note(attended=True, frozen=True))
    assert carrier.sent == [("anna", Order("attend", on=True)), ("anna", Order("freeze"))]
    roster.freeze(True)
    clock.now += FROZEN_SECONDS
    assert not roster.is_frozen


def test_one_pupil_is_frozen_and_stays_so_or_is_let_go_on_alone() -> None:
    carrier = Carrier("anna", "ben")
    roster = Roster(carrier, Clock())
    roster.attend(True)
    for name in ("anna", "ben"):
        roster.heard(name, Note(attended=True))
    carrier.sent.clear()
    assert roster.freeze(True, "anna") == [] and not roster.is_frozen
    roster.heard("anna", Note(attended=True, frozen=True))
    roster.heard("ben", Note(attended=True))
    assert carrier.sent == [("anna", Order("freeze", on=True))]
    roster.freeze(True)
    roster.freeze(False, "ben")
    carrier.sent.clear()
    roster.heard("anna", Note(attended=True, frozen=True))
    roster.heard("ben", Note(attended=True))
    assert carrier.sent == []
    roster.freeze(False)
    roster.heard("anna", Note(attended=True))
    assert carrier.sent == [("anna", Order("freeze")), ("ben", Order("freeze"))]


def test_a_teacher_who_goes_leaves_nobody_frozen() -> None:
    carrier = Carrier("anna")
    roster = Roster(carrier, Clock())
    roster.here("anna")
    roster.attend(True)
    roster.freeze(True)
    carrier.sent.clear()
    roster.attend(False)
    roster.attend(False)
    assert carrier.sent == [("anna", Order("attend"))] and not roster.is_frozen


def test_what_happened_in_the_lesson_is_kept_with_its_time() -> None:
    wall = Clock()
    roster = Roster(clock=Clock(), wall=wall)
    roster.here("anna")
    for note in (
        Note(lesson=LessonPlace("day3", {}, 1, 12)),
        Note(lesson=LessonPlace("day3", {}, 1, 12), trouble=ERROR),
        Note(lesson=LessonPlace("day3", {}, 1, 12), trouble=ERROR, hand=True),
        Note(lesson=LessonPlace("day3", {}, 2, 12)),
    ):
        wall.now += 1
        roster.heard("anna", note)
    roster.gone("anna")
    roster.gone("anna")
    assert [tuple(event) for event in roster.events] == [
        (100.0, "anna", "came", ""),
        (101.0, "anna", "lesson", "day3 1/12"),
        (102.0, "anna", "error", ERROR.line),
        (103.0, "anna", "hand", ""),
        (104.0, "anna", "step", "day3 2/12"),
        (104.0, "anna", "mended", ERROR.line),
        (104.0, "anna", "lowered", ""),
        (104.0, "anna", "left", ""),
    ]

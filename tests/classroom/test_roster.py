"""The teacher's list of the class."""

from __future__ import annotations

import json
from pathlib import Path

import pytest

from day6_core.classroom.asked import Questions
from day6_core.classroom.journal import Journal
from day6_core.classroom.kept import KeptFile
from day6_core.classroom.note import LessonPlace, Note, Reply, Trouble
from day6_core.classroom.order import Order
from day6_core.classroom.roster import FROZEN_SECONDS, STUCK_SECONDS, TYPED_SECONDS, Roster

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
    assert roster.freeze(True, ["anna"]) == [] and not roster.is_frozen
    roster.heard("anna", Note(attended=True, frozen=True))
    roster.heard("ben", Note(attended=True))
    assert carrier.sent == [("anna", Order("freeze", on=True))]
    roster.freeze(True)
    roster.freeze(False, ["ben"])
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
    roster = Roster(clock=Clock(), journal=Journal(wall=wall))
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
    assert [tuple(event) for event in roster.journal.events()] == [
        (100.0, "anna", "came", ""),
        (101.0, "anna", "lesson", "day3 1/12"),
        (102.0, "anna", "error", ERROR.line),
        (103.0, "anna", "hand", ""),
        (104.0, "anna", "step", "day3 2/12"),
        (104.0, "anna", "mended", ERROR.line),
        (104.0, "anna", "lowered", ""),
        (104.0, "anna", "left", ""),
    ]


def happened(roster: Roster) -> list[tuple[str, str, str]]:
    """Who did what to whom."""
    return [(event.by, event.what, event.name) for event in roster.journal.events()]


def class_of(*pupils: str) -> tuple[Roster, Clock]:
    clock = Clock()
    roster = Roster(Carrier(*pupils), clock)
    for name in pupils:
        roster.here(name)
    return roster, clock


def test_what_the_teacher_does_is_in_the_journal_and_only_what_reached_somebody() -> None:
    roster, _ = class_of("anna", "ben")
    roster.attend(True)
    roster.order(["anna", "ben", "carl"], Order("say", text="Look up"))
    roster.order(["anna"], Order("lesson", text="day3"))
    roster.order(["carl"], Order("say", text="Where are you?"))
    roster.order(["anna"], Order("watch", seconds=6))
    roster.freeze(True)
    roster.here("anna")  # the desktop came again: it is frozen again, which is no news
    roster.freeze(False, ["ben"])
    roster.attend(False)
    assert happened(roster)[2:] == [
        ("teacher", "attended", ""),
        ("teacher", "said", ""),
        ("teacher", "started_lesson", "anna"),
        ("teacher", "froze", ""),
        ("teacher", "unfroze", "ben"),
        ("teacher", "away", ""),
    ]
    assert [event.text for event in roster.journal.events() if event.text] == ["Look up", "day3"]


def at(step: int, **more: bool) -> Note:
    flags = {name: more.pop(name) for name in ("may_type", "hand") if name in more}
    return Note(lesson=LessonPlace("day3", {}, step, 12, **more), **flags)  # type: ignore[arg-type]


def test_a_step_that_the_teachers_keys_may_have_solved_is_no_pupils_alone() -> None:
    roster, clock = class_of("anna")
    roster.heard("anna", at(1))
    roster.order(["anna"], Order("type", text="refused, as nobody has agreed"))
    roster.heard("anna", at(1, solved=True))
    roster.heard("anna", at(2, may_type=True))
    for key in "ls\r":
        roster.order(["anna"], Order("type", text=key))
    roster.heard("anna", at(2, may_type=True, solved=True))
    roster.order(["anna"], Order("stop_typing"))
    roster.heard("anna", at(3))
    clock.now += TYPED_SECONDS + 1
    roster.heard("anna", at(3))
    roster.heard("anna", at(3, solved=True))
    assert [what for _, what, _ in happened(roster)] == [
        *("came", "lesson", "solved", "step", "allowed", "typed", "solved_typing", "stopped", "step_typing", "solved"),
    ]


def test_what_a_pupil_answers_to_each_question_is_in_the_journal() -> None:
    roster, _ = class_of("anna")
    no = "class.refused.no"
    for note in (
        Note(asked=True),
        Note(refused=no),
        Note(asked_show=True),
        Note(refused=no),
        Note(asked_show=True),
        Note(may_show=True),
        Note(shown=True, may_show=True),
    ):
        roster.heard("anna", note)
    assert [what for _, what, _ in happened(roster)] == ["came", "declined", "declined_show", "allowed_show"]


def test_a_hand_is_lowered_by_the_pupil_or_by_the_teacher_not_by_both() -> None:
    roster, _ = class_of("anna")
    roster.heard("anna", at(1, hand=True))
    roster.order(["anna"], Order("lower_hand"))
    roster.heard("anna", at(1))
    roster.heard("anna", at(1, hand=True))
    roster.heard("anna", at(1))
    assert happened(roster)[2:] == [
        ("pupil", "hand", "anna"),
        ("teacher", "saw_hand", "anna"),
        ("pupil", "hand", "anna"),
        ("pupil", "lowered", "anna"),
    ]


def test_what_a_desktop_that_has_ended_said_last_is_no_word_of_the_next_one() -> None:
    roster = Roster(Carrier())
    roster.here("anna")
    roster.heard("anna", Note(hand=True, attended=True, may_type=True, lesson=LessonPlace("day1", {}, 2, 3)))
    roster.gone("anna")
    roster.here("anna")
    note = roster.row("anna").note
    assert note is not None and (note.hand, note.attended, note.may_type) == (False, False, False)
    assert note.lesson is not None and note.lesson.step == 2


class Killed(BaseException):
    """The program is gone at this moment."""


class Dying(Carrier):
    """Takes an order to the first pupil and is gone."""

    def send(self, name: str, order: Order) -> bool:
        if self.sent:
            raise Killed
        return super().send(name, order)


def test_a_program_killed_while_it_asks_and_hands_out_has_written_that_ahead(tmp_path: Path) -> None:
    troubles: list[object] = []

    def roster(carrier: Carrier) -> Roster:
        return Roster(carrier, kept=KeptFile(tmp_path / "kept" / "asked.json", troubles.append, troubles.append))

    dying = Dying("anna", "ben")
    with pytest.raises(Killed):
        roster(dying).ask(["anna", "ben"], "Done?")
    number = dying.sent[0][1].number
    again = roster(Dying("anna", "ben"))
    again.here("anna")
    again.heard("anna", Note(replies=(Reply(number, "yes"),)))
    with pytest.raises(Killed):
        again.hand(["anna", "ben"], Order("link", text="https://a.b/"))
    last = roster(Carrier("anna"))
    (question,), (handout,) = last.questions.open, last.handed.all
    assert (question.number, question.asked, question.replies) == (
        number,
        ("anna", "ben"),
        {"anna": Reply(number, "yes")},
    )
    assert handout.given == ["anna", "ben"] and handout.number > number
    assert last.ask(["eva"], "Who?") == ["eva"] and last.questions.open == [question]  # it reached nobody
    assert roster(Carrier()).questions.open == [question] and troubles == []


def test_no_number_is_used_twice_by_a_clock_that_is_put_back_and_the_last_lesson_is_forgotten(tmp_path: Path) -> None:
    clock = Clock()
    clock.now = 2e9

    def questions() -> Questions:
        found = Questions(clock)
        if data:
            found.restore(json.loads(data))
        return found

    data = ""
    first = questions()
    first.add(number := first.next_number(), "Done?", ["anna"])
    data = json.dumps(first.data())
    clock.now -= 3600
    assert questions().next_number() > number and len(questions().open) == 1
    clock.now += 2 * 24 * 3600
    assert questions().open == []


def test_a_full_disk_is_told_once_and_the_class_goes_on(tmp_path: Path) -> None:
    (tmp_path / "file").write_text("where a folder should be")
    troubles: list[object] = []
    roster = Roster(Carrier("anna"), kept=KeptFile(tmp_path / "file" / "asked.json", troubles.append, print))
    for text in ("Done?", "Now?"):
        assert roster.ask(["anna"], text) == []
    assert len(roster.questions.open) == 2 and len(troubles) == 1

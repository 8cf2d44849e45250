"""A pupil's way through a lesson: steps, hints, what was done before it was asked, progress, files that change, drills."""

from __future__ import annotations

import errno
import json
import os
import threading
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from functools import partial
from pathlib import Path

import pytest

from day6_core.lessons import catalogue, kept_progress
from day6_core.lessons.course import Course, new_course
from day6_core.lessons.demonstration import Demonstration
from day6_core.lessons.progress import Progress, StepDone, file_of, load
from day6_core.session.session import Session
from day6_core.session.streams import InputStream, OutputStream
from day6_core.shell.desk import Desk
from day6_core.shell.language.redirection import Streams
from tests.support.waiting import until

pytestmark = pytest.mark.process

TEXT = """
## zh 题目

文字

### do

做

### hints

1. 一
2. 二
3. 三
{zh}
## en Title

text

### do

do

### hints

1. one
2. two
3. three
{en}
"""

HEAD = "---\nlesson: {name}\norder: 1\nminutes: 5\ntitle: {{zh: 课, en: Lesson}}\n---\n"

STEPS = {
    "touch": "check:\n  - file: ~/one.txt\nsolve:\n  - type: touch one.txt\n",
    "list": "check:\n  - ran: ^ls\nsolve:\n  - type: ls\nneeds: [touch]\n",
    "ask": "check:\n  - answer: b\nsolve:\n  - answer: b\n",
}


def write_lesson(path: Path, steps: dict[str, str], head: str = HEAD.format(name="small")) -> Path:
    answers = "\n### answers\n\n- a: A | because\n- b: B\n"
    parts = [
        f"# {name}\n\n~~~yaml\n{data}~~~\n"
        + TEXT.format_map(dict.fromkeys(("zh", "en"), answers if "answer" in data else ""))
        for name, data in steps.items()
    ]
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text(head + "\n" + "\n".join(parts), encoding="utf-8")
    return path


class Classroom:
    """A desk with a lesson window of one pupil."""

    def __init__(self, home: Path, folder: Path) -> None:
        self.home, self.folder = home, folder
        self.desk = Desk(home, domain_id=0, join_link=False)
        self.course: Course = self.begin()

    def begin(self, pupil: str = "anna", since_ns: int | None = None) -> Course:
        made: list[Course] = []

        async def main(session: Session) -> int:
            made.append(await new_course(self.desk, session, pupil, self.folder, since_ns))
            await made[0].run()
            return 0

        streams = Streams(InputStream(), OutputStream(), OutputStream())
        self.program = self.desk.start_program(["lesson"], main, streams, env=self.desk.environment(), cwd=self.home)
        self.wait(lambda: made)
        return made[0]

    def wait(self, condition: Callable[[], object]) -> None:
        until(lambda: self.desk.scheduler.run(lambda: bool(condition()), 0.05), every=0.0, told=self.told)

    def told(self) -> str:
        return repr(self.course.state) if hasattr(self, "course") else ""

    def ask(self, action: Callable[[], object]) -> None:
        self.course.request(action)

    def go(self, seconds: float = 0.4) -> None:
        self.desk.scheduler.run(lambda: False, seconds)

    def at(self) -> str:
        state = self.course.state
        return state.step.name if state.step is not None else ""

    def open(self, name: str = "small") -> None:
        self.ask(lambda: self.course.open(name))
        self.wait(lambda: self.course.state.lesson is not None)

    def solved(self) -> bool:
        return self.course.state.solved

    def saved(self) -> bool:
        path = file_of(self.home, "anna")
        return path.is_file() and load(path).steps == self.course.progress.steps


@pytest.fixture
def room(tmp_path: Path) -> Iterator[Classroom]:
    write_lesson(tmp_path / "lessons" / "small.md", STEPS)
    made = Classroom(tmp_path / "home", tmp_path / "lessons")
    yield made
    made.desk.hurry()
    made.desk.close()


def test_a_step_is_solved_by_what_the_pupil_does_and_the_next_one_comes_when_asked(room: Classroom) -> None:
    room.open()
    room.go()
    assert (room.at(), room.solved()) == ("touch", False)
    assert room.course.state.verdicts[0].text("en") == "the file ~/one.txt exists (not yet)"
    (room.home / "one.txt").touch()
    room.wait(room.solved)
    assert room.at() == "touch"
    room.ask(room.course.next)
    room.wait(lambda: room.at() == "list")
    assert not room.solved()


def test_what_was_done_before_it_was_asked_is_recognised(room: Classroom) -> None:
    (room.home / "one.txt").touch()
    room.open()
    room.wait(room.solved)
    assert room.course.state.before_asked
    terminal = room.desk.open_terminal()
    room.wait(lambda: terminal.idle)
    terminal.run_line("ls -l")
    room.wait(lambda: terminal.runs.count == 1 and terminal.idle)
    room.ask(room.course.next)
    room.wait(lambda: room.at() == "list" and room.solved())
    assert room.course.state.before_asked


@pytest.mark.parametrize("once", ["lesson", "step"])
def test_what_was_typed_since_the_lesson_was_asked_for_counts_and_nothing_before(room: Classroom, once: str) -> None:
    room.program.kill()
    check = f"check:\n  - command: {{words: ls, since: {once}}}\nsolve:\n  - type: ls\n"
    write_lesson(room.folder / "small.md", {"typed": check, "again": check})
    terminal = room.desk.open_terminal()
    room.wait(lambda: terminal.idle)

    def type_line() -> int:
        terminal.run_line("clear; ls")
        count = terminal.runs.count + 1
        room.wait(lambda: terminal.runs.count == count and terminal.idle)
        return room.desk.clock.now_ns()

    yesterday = type_line() + 1
    room.course = room.begin(since_ns=yesterday)
    room.open()
    assert not room.solved()
    room.program.kill()
    type_line()
    room.course = room.begin(since_ns=yesterday)
    room.open()
    assert room.solved() and room.course.state.before_asked
    room.ask(room.course.next)
    room.wait(lambda: room.at() == "again")
    assert room.solved() == (once == "lesson")


def test_hints_are_counted_until_the_step_is_solved(room: Classroom) -> None:
    room.open()
    for _ in range(5):
        room.ask(room.course.hint)
    room.wait(lambda: room.course.state.hints == 3)
    (room.home / "one.txt").touch()
    room.wait(room.solved)
    assert room.course.progress.step("small", "touch").hints == 3


def test_a_step_that_is_passed_over_is_not_solved(room: Classroom) -> None:
    room.open()
    room.ask(room.course.next)
    room.wait(lambda: room.at() == "list")
    done = room.course.progress.step("small", "touch")
    assert (done.passed_over, done.solved) == (True, 0.0)


def test_a_missing_earlier_step_is_told_and_prepared(room: Classroom) -> None:
    room.open()
    room.ask(room.course.next)
    room.wait(lambda: room.course.state.missing == ("touch",))
    room.ask(room.course.prepare)
    room.wait(lambda: (room.home / "one.txt").exists() and not room.course.state.missing)
    assert room.at() == "list"


def test_a_question_tells_why_an_answer_is_wrong_and_counts_it(room: Classroom) -> None:
    room.open()
    room.ask(room.course.next)
    room.ask(room.course.next)
    room.wait(lambda: room.at() == "ask")
    room.ask(lambda: room.course.choose("a"))
    room.wait(lambda: room.course.state.refused == "a")
    assert not room.solved()
    room.ask(lambda: room.course.choose("b"))
    room.wait(room.solved)
    assert room.course.progress.step("small", "ask").refused == 1


def test_progress_is_kept_after_every_step_and_goes_on_there(room: Classroom) -> None:
    room.open()
    (room.home / "one.txt").touch()
    room.wait(lambda: room.solved() and room.saved())
    data = json.loads(file_of(room.home, "anna").read_text())
    assert data["steps"]["small"]["touch"]["solved"] > 0
    room.program.kill()
    room.course = room.begin()
    room.open()
    room.wait(lambda: room.at() == "list")


def test_another_pupil_begins_at_the_beginning(room: Classroom) -> None:
    room.open()
    (room.home / "one.txt").touch()
    room.wait(lambda: room.solved() and room.saved())
    (room.home / "one.txt").unlink()
    room.program.kill()
    room.course = room.begin("bert")
    room.open()
    room.wait(lambda: room.at() == "touch")
    assert not room.solved()


def test_progress_of_another_version_is_left_alone_and_told(room: Classroom) -> None:
    path = file_of(room.home, "anna")
    path.parent.mkdir(parents=True, exist_ok=True)
    path.write_text('{"version": 99}')
    room.program.kill()
    room.course = room.begin()
    room.open()
    (room.home / "one.txt").touch()
    room.wait(lambda: room.solved() and "version 99" in room.course.kept.failed)
    assert path.read_text() == '{"version": 99}'


def test_progress_that_a_full_disk_does_not_take_is_told_and_written_later(
    room: Classroom, monkeypatch: pytest.MonkeyPatch
) -> None:
    real, full = kept_progress.save, [True]

    def save(path: Path, progress: Progress) -> Progress:
        if full[0]:
            raise OSError(errno.ENOSPC, os.strerror(errno.ENOSPC), str(path))
        return real(path, progress)

    monkeypatch.setattr(kept_progress, "save", save)
    monkeypatch.setattr(kept_progress, "RETRY_SECONDS", 0.0)
    room.open()
    (room.home / "one.txt").touch()
    room.wait(lambda: room.solved() and room.course.kept.failed == os.strerror(errno.ENOSPC))
    full[0] = False
    room.wait(lambda: room.saved() and not room.course.kept.failed)


def test_what_was_not_yet_written_when_the_desktop_is_closed_is_written_and_nothing_after_that(
    room: Classroom, monkeypatch: pytest.MonkeyPatch
) -> None:
    real, closed, late = kept_progress.save, threading.Event(), []

    def save(path: Path, progress: Progress) -> Progress:
        time.sleep(0.3)  # a slow disk
        late.append(closed.is_set())
        return real(path, progress)

    room.open()
    room.wait(room.saved)
    monkeypatch.setattr(kept_progress, "save", save)
    (room.home / "one.txt").touch()
    room.wait(room.solved)
    room.desk.hurry()
    room.desk.close()
    closed.set()
    assert room.saved() and load(file_of(room.home, "anna")).step("small", "touch").solved
    time.sleep(0.5)
    assert True not in late


def test_a_lesson_that_is_being_written_is_read_again(room: Classroom) -> None:
    room.open()
    path = room.folder / "small.md"
    good = path.read_text()
    path.write_text(good.replace("file: ~/one.txt", "flie: ~/one.txt"))
    room.wait(lambda: room.course.state.mistakes is not None)
    assert "there is no check 'flie'" in str(room.course.state.mistakes)
    path.write_text(good.replace("file: ~/one.txt", "file: ~/two.txt"))
    room.wait(lambda: room.course.state.mistakes is None)
    (room.home / "two.txt").touch()
    room.wait(room.solved)


def test_a_check_that_fails_is_told_and_the_step_can_be_passed_over(room: Classroom) -> None:
    write_lesson(room.folder / "small.md", {"odd": "check:\n  - trail: pentagram\nsolve: []\n", **STEPS})
    room.program.kill()
    room.course = room.begin()
    room.open()
    room.ask(lambda: room.desk.display and room.desk.display.open("turtlesim", "T", object()))
    room.wait(lambda: any(verdict.broken for verdict in room.course.state.verdicts))
    assert "itself failed" in room.course.state.verdicts[0].text("en")
    assert not room.solved()
    room.ask(room.course.next)
    room.wait(lambda: room.at() == "touch")


def test_a_folder_with_broken_lessons_shows_the_others(room: Classroom) -> None:
    (room.folder / "bad.md").write_text("no lesson")
    room.program.kill()
    room.course = room.begin()
    assert [lesson.name for lesson in room.course.offer.lessons] == ["small"]
    assert [mistakes.path.name for mistakes in room.course.offer.broken] == ["bad.md"]


DRILL = "check:\n  - file: {path: ~/a.txt, has: right}\nbefore:\n  - write: {file: ~/a.txt, text: wrong}\nsolve: []\n"


def test_a_drill_happens_in_a_home_of_its_own(room: Classroom) -> None:
    head = "---\ndrill: slip\norder: 1\nminutes: 3\nfault: 1\ntopic: names\ntitle: {zh: 练, en: Drill}\n---\n"
    write_lesson(room.folder / "slip.md", {"slip": DRILL}, head)
    (room.home / "a.txt").write_text("mine")
    room.program.kill()
    room.course = room.begin()
    room.open("slip")
    place = room.home / "drills" / "slip"
    room.wait(lambda: (place / "a.txt").is_file() and not room.course.state.working)
    assert (room.home / "a.txt").read_text() == "mine"
    terminal = room.desk.open_terminal()
    room.wait(lambda: terminal.idle)
    terminal.run_line("echo right > ~/a.txt")
    room.wait(room.solved)
    assert (room.home / "a.txt").read_text() == "mine"
    room.ask(room.course.next)
    room.wait(lambda: room.course.state.lesson is None)
    assert room.desk.login_home == room.home
    room.open("slip")
    room.wait(lambda: (room.home / "drills" / "slip-2" / "a.txt").is_file())


def test_a_drill_waits_until_nothing_else_runs(room: Classroom) -> None:
    head = "---\ndrill: slip\norder: 1\nminutes: 3\nfault: 1\ntopic: names\ntitle: {zh: 练, en: Drill}\n---\n"
    write_lesson(room.folder / "slip.md", {"slip": DRILL}, head)
    room.program.kill()
    room.course = room.begin()
    room.desk.graph.create_node("mine")
    (room.home / "a.txt").write_text("right")
    room.open("slip")
    room.wait(lambda: room.course.state.leftovers == ("/mine",))
    assert not (room.home / "drills").exists() and not room.course.state.problem
    room.go(1.0)
    assert not room.solved(), "without the fault there was nothing to mend"
    assert not room.course.progress.step("slip", "slip").solved
    room.desk.graph.nodes[0].destroy()
    room.wait(lambda: (room.home / "drills" / "slip" / "a.txt").is_file() and room.course.state.verdicts)
    assert not room.solved()


def test_what_is_in_the_way_of_a_drill_is_ended_on_request_and_the_drill_begins(room: Classroom) -> None:
    drills(room, 1)
    terminal = room.desk.open_terminal()
    room.wait(lambda: terminal.idle)
    terminal.run_line("ros2 run demo_nodes_cpp talker")
    room.wait(lambda: room.desk.graph.nodes)
    room.open("slip0")
    room.wait(lambda: room.course.state.leftovers == ("/talker",))
    room.ask(room.course.clear_up)
    room.wait(lambda: room.course.opened.injected)
    assert not room.course.state.leftovers and terminal.idle


def test_a_drill_that_is_closed_while_it_waits_makes_no_fault(room: Classroom) -> None:
    drills(room, 1)
    room.desk.graph.create_node("mine")
    room.open("slip0")
    room.wait(lambda: room.course.state.leftovers)
    room.ask(room.course.close)
    room.wait(lambda: room.course.state.lesson is None)
    room.desk.graph.nodes[0].destroy()
    room.go(1.0)
    assert not (room.home / "drills").exists() and room.desk.room is None


def test_the_shipped_lessons_and_drills_are_offered(tmp_path: Path) -> None:
    room = Classroom(tmp_path / "home", catalogue.HERE / "days")
    try:
        assert len(room.course.offer.lessons) == len(list((catalogue.HERE / "days").glob("*.md")))
        assert len(room.course.offer.drills) == len(list((catalogue.HERE / "drills").glob("*.md")))
    finally:
        room.desk.hurry()
        room.desk.close()


def test_what_runs_from_before_is_told_and_ended_on_request(room: Classroom) -> None:
    terminals = [room.desk.open_terminal() for _ in range(3)]
    room.wait(lambda: all(each.idle for each in terminals))
    terminals[0].run_line("ros2 run demo_nodes_cpp talker")
    terminals[1].run_line("ros2 run demo_nodes_cpp listener &")
    terminals[2].run_line("nano poem.txt")
    room.wait(lambda: len(room.desk.graph.nodes) == 2 and terminals[2].busy)
    room.open()
    room.wait(lambda: room.course.state.leftovers == ("/listener", "/talker"))
    room.ask(room.course.clear_up)
    room.wait(lambda: not room.course.state.leftovers and not room.desk.graph.nodes)
    room.wait(lambda: terminals[0].idle and terminals[1].idle)
    assert terminals[2].busy


def test_a_step_begins_with_the_file_it_gives_but_not_over_one_of_the_pupil(room: Classroom) -> None:
    given = "before:\n  - write: {file: ~/one.py, text: given}\n  - write: {file: ~/two.py, text: given}\n"
    write_lesson(room.folder / "small.md", {"start": f"check:\n  - file: ~/done.txt\n{given}"})
    (room.home / "two.py").write_text("mine")
    room.program.kill()
    room.course = room.begin()
    room.open()
    room.wait(lambda: (room.home / "one.py").exists() and not room.course.state.working)
    assert ((room.home / "one.py").read_text(), (room.home / "two.py").read_text()) == ("given", "mine")
    (room.home / "one.py").write_text("changed")
    room.ask(room.course.again)
    room.go()
    assert (room.home / "one.py").read_text() == "changed"


def test_a_needed_step_of_events_alone_is_missing_until_it_was_solved(room: Classroom) -> None:
    steps = {
        "said": "check:\n  - ran: ^echo\nsolve:\n  - type: echo hello\n",
        "after": "check:\n  - file: ~/after.txt\nneeds: [said]\n",
    }
    write_lesson(room.folder / "small.md", steps)
    room.program.kill()
    room.course = room.begin()
    room.open()
    room.ask(room.course.next)
    room.wait(lambda: room.course.state.missing == ("said",))
    room.ask(room.course.prepare)
    room.wait(lambda: not room.course.state.missing and not room.course.state.working)


def own_file(room: Classroom, solve: str) -> Path:
    """A step whose solution writes a file that the pupil has already written; the solution is shown."""
    write_lesson(
        room.folder / "small.md", {"poem": f"check:\n  - file: {{path: ~/poem.txt, has: theirs}}\nsolve:\n{solve}"}
    )
    mine = room.home / "poem.txt"
    mine.write_text("mine, an hour of work\n")
    room.program.kill()
    room.course = room.begin()
    room.open()
    room.ask(room.course.show_solution)
    room.wait(lambda: room.solved() and not room.course.state.working)
    return mine


@pytest.mark.parametrize(
    ("solve", "text"),
    [
        ("  - write: {file: ~/poem.txt, text: theirs}\n", "theirs\n"),
        ("  - replace: {file: ~/poem.txt, old: an hour, new: theirs}\n", "mine, theirs of work\n"),
    ],
    ids=["write", "replace"],
)
def test_a_solution_that_is_shown_keeps_what_the_pupil_had_written(room: Classroom, solve: str, text: str) -> None:
    mine = own_file(room, solve)
    assert mine.read_text() == text
    assert (room.home / "poem.txt.mine").read_text() == "mine, an hour of work\n"


def test_what_solutions_have_written_themselves_is_not_kept(room: Classroom) -> None:
    twice = "  - write: {file: ~/poem.txt, text: first}\n  - write: {file: ~/poem.txt, text: theirs}\n"
    own_file(room, twice)
    assert sorted(path.name for path in room.home.glob("poem*")) == ["poem.txt", "poem.txt.mine"]


def drills(room: Classroom, count: int) -> None:
    for number in range(count):
        head = (
            f"---\ndrill: slip{number}\norder: {number}\nminutes: 3\nfault: {number + 1}\ntopic: t{number % 2}\n"
            "title: {zh: 练, en: Drill}\n---\n"
        )
        write_lesson(room.folder / f"slip{number}.md", {"slip": DRILL}, head)
    room.program.kill()
    room.course = room.begin()
    only_drills(room, "slip")


def only_drills(room: Classroom, start: str) -> None:
    """Let chance choose only of the drills whose name begins so."""
    offer = room.course.offer
    room.course.offer = replace(offer, drills=tuple(drill for drill in offer.drills if drill.name.startswith(start)))


def test_an_exam_is_five_drills_with_time_and_hints_counted(room: Classroom) -> None:
    drills(room, 7)
    room.ask(room.course.start_exam)
    for number in range(5):
        room.wait(lambda number=number: room.course.exam and len(room.course.exam.results) == number)
        room.wait(lambda: room.course.state.verdicts and not room.course.state.working)
        place = room.desk.login_home
        if number == 1:
            room.ask(room.course.hint)
            room.wait(lambda: room.course.state.hints == 1)
        if number != 2:
            (place / "a.txt").write_text("right")
            room.wait(room.solved)
        room.ask(room.course.next)
    room.wait(lambda: room.course.exam is not None and room.course.exam.over)
    exam = room.course.exam
    assert exam is not None
    assert len(set(exam.drills)) == 5
    assert [result.solved for result in exam.results] == [True, True, False, True, True]
    assert [result.hints for result in exam.results] == [0, 1, 0, 0, 0]
    assert room.course.state.lesson is None
    room.wait(lambda: load(file_of(room.home, "anna")).exams)
    assert load(file_of(room.home, "anna")).exams == [exam.kept()]


def test_an_exam_of_a_teacher_has_the_given_drills_and_does_not_begin_again(room: Classroom) -> None:
    drills(room, 3)
    given = partial(room.course.start_exam, ["slip2", "slip0"])
    room.ask(given)
    room.wait(lambda: room.course.state.verdicts and not room.course.state.working)
    room.ask(room.course.next)
    room.wait(lambda: room.course.exam and room.course.exam.results)
    room.ask(given)  # handed out once more
    room.go(0.6)
    exam = room.course.exam
    assert exam is not None and exam.drills == ("slip2", "slip0") and exam.at == "slip0"


def test_hints_of_earlier_practice_are_not_shown_in_an_exam_and_do_not_count_there(room: Classroom) -> None:
    drills(room, 1)
    room.course.progress.note("slip0", "slip", StepDone(hints=3))
    room.ask(room.course.start_exam)
    room.wait(lambda: room.course.state.verdicts and not room.course.state.working)
    assert room.course.state.hints == 0
    room.ask(room.course.next)
    room.wait(lambda: room.course.exam is not None and room.course.exam.over)
    assert room.course.exam is not None and [each.hints for each in room.course.exam.results] == [0]
    assert room.course.progress.step("slip0", "slip").hints == 3


def test_in_an_exam_a_solution_that_was_shown_is_no_solved_drill_and_time_does_not_begin_again(room: Classroom) -> None:
    drills(room, 1)
    (drill,) = room.course.offer.drills
    path = drill.path
    path.write_text(path.read_text().replace("solve: []", "solve:\n  - write: {file: ~/a.txt, text: right}"))
    room.program.kill()
    room.course = room.begin()
    only_drills(room, drill.name)
    room.ask(room.course.start_exam)
    room.wait(lambda: room.course.state.verdicts and not room.course.state.working)
    opened = room.course.opened
    assert opened is not None
    began = opened.began
    room.ask(room.course.show_solution)
    room.wait(lambda: room.solved() and not room.course.state.working)
    room.ask(room.course.again)
    room.go(0.6)
    assert room.solved() and opened.began == began
    room.ask(room.course.next)
    room.wait(lambda: room.course.exam is not None and room.course.exam.over)
    assert room.course.exam is not None and [each.solved for each in room.course.exam.results] == [False]


def test_any_drill_is_one_that_is_not_solved_yet(room: Classroom) -> None:
    drills(room, 2)
    room.course.progress.note("slip0", "slip", StepDone(solved=1.0))
    room.ask(room.course.random_drill)
    room.wait(lambda: room.course.state.lesson is not None)
    assert room.course.state.lesson is not None
    assert room.course.state.lesson.name == "slip1"


def demonstrated(room: Classroom) -> Demonstration:
    """Open the lesson, and let it be played by itself."""
    room.open()
    room.ask(lambda: room.course.demonstrate("en"))
    room.wait(lambda: room.course.demonstration is not None)
    assert room.course.demonstration is not None
    return room.course.demonstration


def test_a_demonstration_plays_the_lesson_where_everybody_sees_it(room: Classroom) -> None:
    demonstration = demonstrated(room)
    for _ in range(5):
        demonstration.change_speed(1)
    assert demonstration.speed == 4.0

    def taken_on() -> bool:
        demonstration.go_on()
        return room.course.demonstration is None

    room.wait(taken_on)
    assert (room.course.progress.solved("small"), room.at(), room.solved()) == (0, "ask", True)
    lines = [run.source for terminal in room.desk.terminals for run in terminal.runs.all]
    assert lines == ["touch one.txt", "ls"]


def test_a_demonstration_is_held_and_stopped(room: Classroom) -> None:
    demonstration = demonstrated(room)
    demonstration.change_speed(1)
    demonstration.go_on()
    demonstration.hold()
    room.go(1.0)
    assert not any(terminal.runs.all for terminal in room.desk.terminals)
    room.ask(lambda: room.course.demonstrate("en"))
    demonstration.hold()
    room.wait(lambda: room.course.demonstration is None)
    room.go(0.5)
    assert room.at() == "touch"


def test_a_demonstration_ends_with_its_lesson(room: Classroom) -> None:
    demonstration = demonstrated(room)
    room.ask(room.course.close)
    room.wait(lambda: room.course.state.lesson is None)
    assert room.course.demonstration is None
    demonstration.go_on()
    room.open()
    room.go(1.0)
    assert not any(terminal.runs.all for terminal in room.desk.terminals)


def test_what_is_demonstrated_is_not_the_pupils_work(room: Classroom) -> None:
    room.open()
    room.ask(room.course.show_solution)
    room.wait(room.solved)
    done = room.course.progress.step("small", "touch")
    assert (done.passed_over, done.solved) == (True, 0.0)

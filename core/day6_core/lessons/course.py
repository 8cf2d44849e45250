"""Goes through lessons with a pupil: the model of the lesson window.

Everything happens on the scheduler's thread. The window reads `state` and `progress`, which are replaced as a whole, and asks by
`request` from any thread.
"""

from __future__ import annotations

import logging
import random
import threading
import time
from collections import deque
from collections.abc import Awaitable, Callable, Iterable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.lessons.catalogue import Found, by_topic, days, drills, lessons_in
from day6_core.lessons.demonstration import Demonstration
from day6_core.lessons.document import HINTS, Action, Lesson, Step
from day6_core.lessons.exam import Exam, ExamResult, new_exam
from day6_core.lessons.following import FollowedFile
from day6_core.lessons.live import Live
from day6_core.lessons.player import StageError, Steering
from day6_core.lessons.progress import (
    LONGEST_ANSWERS,
    Progress,
    ProgressError,
    StepDone,
    file_of,
    load,
    save,
)
from day6_core.lessons.source import LessonMistakes
from day6_core.lessons.stage import Stage
from day6_core.lessons.state import State
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from day6_core.shell.desk import Desk
    from day6_core.shell.terminal import Terminal

_log = logging.getLogger(__name__)

LOOK_SECONDS = 0.25
"""Between two looks at the machine."""

ENDING_SECONDS = 6.0
"""How long a drill waits for what ran before it."""


class Course:
    """One pupil's way through the lessons. `folder`: lessons of a teacher, instead of the six days."""

    def __init__(self, desk: Desk, session: Session, pupil: str = "", folder: Path | None = None) -> None:
        self._desk = desk
        self._session = session
        self._folder = folder
        self._live: Live | None = None
        self._stage: Stage | None = None
        self._requests: deque[Callable[[], Awaitable[None] | None]] = deque()
        self._wanted = Signal()
        self._unsaved = False
        self._saving = False
        self._file: FollowedFile | None = None
        self._began = 0.0
        self._prepared: set[str] = set()
        """The steps of this lesson that have got what they begin with."""
        self._performed: set[str] = set()
        """The steps of this lesson whose solution was played because a later one needs it."""
        self._shown = False
        """Whether the solution of this step was played for the pupil."""
        self._injected = False
        """Whether the fault of this drill is there: what is right without it is no solution."""
        self.version = 0
        """Grows with every change of what is shown."""
        self.state = State()
        self.progress = Progress(pupil)
        self.saving_failed = ""
        """Why the progress could not be kept."""
        self.lessons: tuple[Lesson, ...] = ()
        self.drills: tuple[Lesson, ...] = ()
        self.broken: tuple[LessonMistakes, ...] = ()
        """Lessons of the folder that cannot be used."""
        self.unknown = ""
        """The name of a lesson that was asked for and is not there."""
        self.exam: Exam | None = None
        self.demonstration: Demonstration | None = None
        self.finished: Lesson | None = None
        """The lesson whose last step was left just now."""
        self.ready = False
        """Whether the lessons and the progress have been read."""

    @property
    def letters_awaited(self) -> str:
        """The answers of the question that is open now ('abc'), '' for none; what is typed at a prompt may be one."""
        state = self.state
        return "" if state.step is None or state.solved else "".join(a.letter for a in state.step.pages["zh"].answers)

    # -- for the window, any thread ------------------------------------------------------------------------------------

    def request(self, action: Callable[[], Awaitable[None] | None]) -> None:
        """Do something on the program's thread; a coroutine runs beside the looking."""
        self._requests.append(action)
        self._desk.scheduler.call_soon_threadsafe(self._wanted.set)

    @property
    def _in_exam(self) -> bool:
        return self.exam is not None and not self.exam.over

    def lesson(self, name: str) -> Lesson | None:
        return next((each for each in (*self.lessons, *self.drills) if each.name == name), None)

    def searching(self) -> str:
        """'drill' or 'exam' while the pupil is to find a fault himself: until it is mended, or the solution was shown."""
        state = self.state
        if state.lesson is None or not state.lesson.is_drill or state.solved or self._shown:
            return ""
        return "exam" if self._in_exam else "drill"

    # -- life ----------------------------------------------------------------------------------------------------------

    async def run(self) -> None:
        """Go on until the window is closed."""
        try:
            while True:
                self.handle_requests()
                await self._follow_file()
                self.look()
                if self._unsaved and not self._saving:
                    self._session.spawn(self._save())
                self._wanted.clear()
                if not self._requests:
                    await self._session.wait(self._wanted, LOOK_SECONDS)
        finally:
            self.leave()

    def handle_requests(self) -> None:
        """Do what was asked for."""
        while self._requests:
            work = self._requests.popleft()()
            if work is not None:
                self._session.spawn(self._guarded(work))

    def leave(self) -> None:
        """Stop looking; a drill's home folder is no longer the terminals'."""
        if self._live is not None:
            self._live.close()
            self._live = None
        self.demonstration = None
        self._desk.searching = lambda: ""
        room, self._desk.room = self._desk.room, None
        if room is not None:
            theirs = [each for each in self._desk.terminals if each.shell.variables.get("HOME") == str(room)]
            threading.Thread(target=_close, args=(theirs,), name="day6-close-terminals", daemon=True).start()

    async def load(self) -> None:
        """Read the lessons and how far the pupil is."""
        pupil, folder = self.progress.pupil, self._folder
        found = await in_thread(lambda: lessons_in(folder) if folder is not None else Found(days(), []))
        self.lessons = tuple(lesson for lesson in found.lessons if not lesson.is_drill)
        own = [lesson for lesson in found.lessons if lesson.is_drill]
        self.drills = (*by_topic(own), *await in_thread(drills))
        self.broken = tuple(found.mistakes)
        try:
            progress = await in_thread(lambda: load(file_of(self._desk.home, pupil)))
        except (ProgressError, OSError) as error:
            self.saving_failed = str(error)
            progress = Progress()
        progress.pupil = pupil
        self.progress = progress
        self.ready = True
        self._changed()

    async def _guarded(self, work: Awaitable[None]) -> None:
        """Type or prepare something for the pupil; what goes wrong is told, and the lesson goes on."""
        self._set(working=True, problem="")
        try:
            await work
        except (StageError, OSError, ValueError, KeyError) as error:
            self._set(problem=str(error))
        finally:
            self._set(working=False)

    def _changed(self) -> None:
        self.version += 1
        self._desk.scheduler.announce_activity()

    def _set(self, **changes: object) -> None:
        new = replace(self.state, **changes)  # type: ignore[arg-type]
        if new != self.state:
            self.state = new
            self._changed()

    # -- going through -------------------------------------------------------------------------------------------------

    def open(self, name: str, step: str = "") -> Awaitable[None] | None:
        """Open a lesson where the pupil stopped, or at a step ('*': the first); a drill prepares its fault first."""
        lesson = self.lesson(name)
        self.unknown = name if lesson is None else ""
        if lesson is None:
            self._changed()
            return None
        self.leave()
        self.finished = None
        wanted = step or self.progress.at.get(name, "")
        index = next((at for at, each in enumerate(lesson.steps) if each.name == wanted), 0)
        if not step and index < len(lesson.steps) - 1 and self.progress.step(name, lesson.steps[index].name).solved:
            index += 1  # it was solved, and then the pupil stopped
        self._live = Live(self._desk, self._session, lesson.path.parent)
        self._stage = Stage(self._live, self._session)
        self._file = FollowedFile(lesson.path)
        self._prepared, self._performed = set(), set()
        self.state = State(lesson)
        self._shown = self._injected = False
        self._desk.searching = self.searching
        if not lesson.is_drill:
            self.progress.last, self.progress.last_title = name, dict(lesson.title)
        else:
            self._go_to(0)
            return self._inject(lesson)
        self._go_to(index)
        if not index:
            self._set(leftovers=tuple(dict.fromkeys(self._live.nodes())))
        return None

    def open_last(self) -> Awaitable[None] | None:
        """Go on where the pupil stopped the last time, if that lesson is here; after its end with the list."""
        lesson = self.lesson(self.progress.last)
        if lesson is None:
            return None
        last = lesson.steps[-1].name
        if self.progress.at.get(lesson.name, "") == last and self.progress.step(lesson.name, last).solved:
            self.finished = lesson
            self._changed()
            return None
        return self.open(lesson.name)

    async def _inject(self, lesson: Lesson) -> None:
        """Make the fault of a drill in a home folder of its own, so that no file of the pupil's is touched."""
        live, stage = self._live, self._stage
        if live is None or stage is None:
            return
        # Those of the drill before may just be ending.
        if not await self._session.until(lambda: not live.nodes(), ENDING_SECONDS, LOOK_SECONDS):
            raise StageError("something-runs")
        folder = self._desk.home / "drills"
        number = 1
        while (room := folder / (lesson.name if number == 1 else f"{lesson.name}-{number}")).exists():
            number += 1
        (room / "ros2_ws" / "src").mkdir(parents=True)
        self._desk.room = room
        await stage.perform([{"terminal": "new"}, *lesson.steps[0].before])
        live.begin_step()
        live.lesson_began_ns = live.step_began_ns
        self._injected = True

    def close(self) -> None:
        """Back to the list of lessons; an exam ends."""
        self.leave()
        self.state = State()
        self.exam = None
        self._changed()

    def start_exam(self) -> Awaitable[None] | None:
        """Some drills in a row, time and hints counted."""
        if not self.drills:
            return None
        self.exam = new_exam(self.drills)
        return self.open(self.exam.at)

    def random_drill(self) -> Awaitable[None] | None:
        """A drill that is not solved yet, by chance."""
        names = [drill.name for drill in self.drills if not self.progress.solved(drill.name)]
        names = names or [drill.name for drill in self.drills]
        return self.open(random.choice(names)) if names else None

    def _next_of_exam(self, exam: Exam) -> Awaitable[None] | None:
        state = self.state
        seconds = round(time.monotonic() - self._began, 1)
        solved = state.solved and not self._shown
        exam = self.exam = exam.with_result(ExamResult(exam.at, solved, seconds, state.hints))
        if not exam.over:
            return self.open(exam.at)
        self.progress.exams.append(exam.kept())
        self._unsaved = True
        self.leave()
        self.state = State()
        self._changed()
        return None

    def _go_to(self, index: int) -> None:
        lesson = self.state.lesson
        if lesson is None or self._live is None:
            return
        step = lesson.steps[index]
        self._live.begin_step()
        self._began = time.monotonic()
        done = self.progress.step(lesson.name, step.name)
        self.state = State(
            lesson, index, done_before=bool(done.solved), hints=0 if self._in_exam else min(done.hints, HINTS)
        )
        self._shown = False
        if step.before and not lesson.is_drill and step.name not in self._prepared:
            self._prepared.add(step.name)
            self._session.spawn(self._guarded(self._begin(step)))
        if self.demonstration is None:
            self.progress.at[lesson.name] = step.name
            self._unsaved = True
        self.look()
        self._set(before_asked=self.state.solved)
        self._changed()

    async def _begin(self, step: Step) -> None:
        """Prepare what a step begins with; a file that the pupil has already is left as it is."""
        if (stage := self._stage) is not None:
            stage.spares = True
            try:
                await stage.perform(step.before)
            finally:
                stage.spares = False

    def next(self) -> Awaitable[None] | None:
        """To the next step; after the last one back to the list. A step that is not solved is passed over."""
        state = self.state
        if state.lesson is None or state.step is None:
            return None
        if not state.solved:
            done = self.progress.step(state.lesson.name, state.step.name)
            if not done.solved:
                self._note(replace(done, passed_over=True))
        if self.exam is not None and self._in_exam:
            return self._next_of_exam(self.exam)
        if state.is_last:
            self.close()
            self.finished = state.lesson
        else:
            self._go_to(state.index + 1)
        return None

    def back(self) -> None:
        """To the step before."""
        if self.state.lesson is not None and self.state.index:
            self._go_to(self.state.index - 1)

    def again(self) -> Awaitable[None] | None:
        """Begin the step once more: what was done counts no longer. Not in an exam, whose time runs on.

        A drill whose fault could not be made is begun once more.
        """
        lesson = self.state.lesson
        if lesson is None or self._in_exam:
            return None
        if lesson.is_drill and not self._injected:
            return None if self.state.working else self.open(lesson.name)
        self._go_to(self.state.index)
        return None

    def hint(self) -> None:
        """Show one more hint; it is counted."""
        state = self.state
        if state.lesson is None or state.step is None or state.hints >= HINTS:
            return
        self._set(hints=state.hints + 1)
        if not state.solved:
            done = self.progress.step(state.lesson.name, state.step.name)
            self._note(replace(done, hints=max(done.hints, state.hints + 1)))

    def choose(self, letter: str) -> None:
        """Answer the step's question."""
        state, live = self.state, self._live
        if state.step is None or live is None or state.solved:
            return
        live.answer = letter
        if state.lesson is not None:
            done = self.progress.step(state.lesson.name, state.step.name)
            self._note(replace(done, answers=(done.answers + letter)[:LONGEST_ANSWERS]))
        self.look()
        if not self.state.solved and state.lesson is not None:
            done = self.progress.step(state.lesson.name, state.step.name)
            self._note(replace(done, refused=done.refused + 1))
        self._set(answer=letter, refused="" if self.state.solved else letter)

    def prepare(self) -> Awaitable[None] | None:
        """Play the solutions of the earlier steps that are needed, visibly."""
        state = self.state
        if state.lesson is None or not state.missing or state.working:
            return None
        return self._prepare(state.lesson, state.missing)

    async def _prepare(self, lesson: Lesson, names: tuple[str, ...]) -> None:
        for name in names:
            step = lesson.step(name)
            if step is not None:
                await self.perform(step.solve)
                self._performed.add(name)

    def clear_up(self) -> Awaitable[None] | None:
        """End what runs from before, so that the lesson begins with nothing."""
        if not self.state.leftovers or self.state.working or self._stage is None:
            return None
        return self._stage.clear_up()

    def show_solution(self) -> Awaitable[None] | None:
        """Play this step's solution, visibly; the step counts as passed over, not as solved by the pupil."""
        state = self.state
        if state.step is None or state.working or self._stage is None:
            return None
        return self.perform(state.step.solve)

    async def perform(self, actions: Sequence[Action], steering: Steering | None = None) -> None:
        """Do what a lesson says where everybody can see it. Raises StageError."""
        if self._stage is not None:
            self._shown = self._shown or (self.state.step is not None and actions is self.state.step.solve)
            self._stage.steering = steering or Steering(seen=True)
            try:
                await self._stage.perform([{"terminal": "idle"}, *actions])
            finally:
                self._stage.steering = Steering()

    def demonstrate(self, language: str) -> Awaitable[None] | None:
        """Play the rest of the lesson by itself, or stop that."""
        if self.demonstration is not None:
            self.demonstration.stop()
            return None
        if self.state.lesson is None or self.state.lesson.is_drill:
            return None
        self.demonstration = Demonstration(self, language)
        return self._demonstrate(self.demonstration)

    async def _demonstrate(self, demonstration: Demonstration) -> None:
        try:
            await demonstration.play()
        finally:
            if self.demonstration is demonstration:
                self.demonstration = None
            self._changed()

    async def sleep(self, seconds: float) -> None:
        """World time, so that a paused world holds a demonstration too."""
        await self._session.sleep(seconds)

    async def until(self, holds: Callable[[], object], seconds: float, every: float) -> bool:
        """Wait, in world time, for something to hold; False if it does not."""
        return await self._session.until(holds, seconds, every)

    def touch(self) -> None:
        """Something changed that is shown."""
        self._changed()

    # -- looking -------------------------------------------------------------------------------------------------------

    def look(self) -> None:
        """Ask the checks of the step."""
        state, live = self.state, self._live
        if state.lesson is None or state.step is None or live is None:
            return
        if state.solved or (state.lesson.is_drill and (state.working or not self._injected)):
            return
        if state.leftovers:
            running = live.nodes()
            self._set(leftovers=tuple(name for name in state.leftovers if name in running))
        checks = state.step.checks
        verdicts = tuple(check.judge(live) for check in checks)
        solved = all(verdict.ok for verdict in verdicts)
        ending = any(verdict.ok for check, verdict in zip(checks, verdicts, strict=True) if check.name == "no_node")
        missing = () if solved or ending else self._missing(state.lesson, state.step, live)
        self._set(verdicts=verdicts, solved=solved, missing=missing)
        if solved:
            done = self.progress.step(state.lesson.name, state.step.name)
            if self._shown and not done.solved:
                self._note(replace(done, passed_over=True))
            elif not done.solved:
                seconds = done.seconds + time.monotonic() - self._began
                self._note(replace(done, solved=time.time(), seconds=round(seconds, 1), passed_over=False))

    def _missing(self, lesson: Lesson, step: Step, live: Live) -> tuple[str, ...]:
        """The needed steps whose state is not there, and those of events alone that were never solved."""
        found = []
        for name in step.needs:
            needed = lesson.step(name)
            states = [check for check in needed.checks if not check.is_event] if needed is not None else []
            there = states or name in self._performed or self.progress.step(lesson.name, name).solved
            if not there or not all(check.judge(live).ok for check in states):
                found.append(name)
        return tuple(found)

    def _note(self, done: StepDone) -> None:
        lesson, step = self.state.lesson, self.state.step
        if lesson is not None and step is not None:
            self.progress.note(lesson.name, step.name, done)
            self._unsaved = True
            self._changed()

    # -- files ---------------------------------------------------------------------------------------------------------

    async def _save(self) -> None:
        self._unsaved, self._saving = False, True
        path, progress = file_of(self._desk.home, self.progress.pupil), self.progress.copy()
        try:
            await in_thread(lambda: save(path, progress))
            self.saving_failed = ""
        except (ProgressError, OSError) as error:
            self.saving_failed = str(error)
        finally:
            self._saving = False
            self._changed()

    async def _follow_file(self) -> None:
        """Show the lesson as its file is now."""
        if self.state.lesson is None or self._file is None:
            return
        try:
            new = await self._file.changed()
        except LessonMistakes as mistakes:
            self._set(mistakes=mistakes)
            return
        if new is None or self.state.step is None:
            return
        name = self.state.step.name
        here = min(self.state.index, len(new.steps) - 1)  # its name may be what was changed
        index = next((at for at, step in enumerate(new.steps) if step.name == name), here)
        self.lessons = tuple(new if each.path == new.path else each for each in self.lessons)
        self.drills = tuple(new if each.path == new.path else each for each in self.drills)
        self.state = replace(self.state, lesson=new)
        self._go_to(index)


def _close(terminals: Iterable[Terminal]) -> None:
    for terminal in terminals:
        terminal.close()

"""Goes through lessons with a pupil: the model of the lesson window.

Everything happens on the scheduler's thread. The window reads (`state`, `offer` and `exam` are replaced as a whole) and asks by
`request` from any thread. An action is done at once; what takes time it starts, to run beside the looking.
"""

from __future__ import annotations

import random
import time
from collections import deque
from collections.abc import Awaitable, Callable, Sequence
from dataclasses import replace
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.lessons.catalogue import LessonOffer, offer
from day6_core.lessons.demonstration import Demonstration
from day6_core.lessons.document import HINTS, Lesson
from day6_core.lessons.exam import Exam, new_exam
from day6_core.lessons.kept_progress import KeptProgress
from day6_core.lessons.open_lesson import CALM_LOOKS, CALM_SECONDS, LOOK_SECONDS, OpenLesson
from day6_core.lessons.player import StageError
from day6_core.lessons.progress import LONGEST_ANSWERS, Progress, StepDone
from day6_core.lessons.source import LessonMistakes
from day6_core.lessons.state import State
from day6_core.reason import named_reason
from day6_core.session.task import Signal
from day6_core.session.threads import in_thread

if TYPE_CHECKING:
    from day6_core.session.session import Session
    from day6_core.shell.desk import Desk


async def new_course(
    desk: Desk, session: Session, pupil: str = "", folder: Path | None = None, since_ns: int | None = None
) -> Course:
    """Read how far a pupil is in the lessons; `folder`: those of a teacher, instead of the six days.

    `since_ns`: when the lessons were asked for (epoch nanoseconds). What is typed counts from then on in the one that is opened
    first.
    """
    kept = KeptProgress(desk.home, pupil)
    lessons = await in_thread(lambda: offer(folder))
    await kept.load()
    return Course(desk, session, lessons, kept, since_ns)


class Course:
    """One pupil's way through the lessons."""

    def __init__(
        self, desk: Desk, session: Session, offer: LessonOffer, kept: KeptProgress, since_ns: int | None = None
    ) -> None:
        self._desk = desk
        self._session = session
        self._requests: deque[Callable[[], object]] = deque()
        self._wanted = Signal()
        self._since_ns = since_ns
        self.version = 0
        """Grows with every change of what is shown."""
        self._news: object = None
        self._calm = 0
        """How many looks found no news."""
        self.state = State()
        self.offer = offer
        self.kept = kept
        self.opened: OpenLesson | None = None
        self.exam: Exam | None = None
        """The one that goes on, or whose report is shown."""

    @property
    def progress(self) -> Progress:
        """How far the pupil is."""
        return self.kept.progress

    @property
    def demonstration(self) -> Demonstration | None:
        """What plays the open lesson by itself."""
        return self.opened.demonstration if self.opened is not None else None

    @property
    def letters_awaited(self) -> str:
        """The answers of the question that is open now ('abc'), '' for none; what is typed at a prompt may be one."""
        state = self.state
        return "" if state.step is None or state.solved else "".join(a.letter for a in state.step.pages["zh"].answers)

    # -- for the window, any thread ------------------------------------------------------------------------------------

    def request(self, action: Callable[[], object]) -> None:
        """Do something on the program's thread."""
        self._requests.append(action)
        self._desk.scheduler.call_soon_threadsafe(self._wanted.set)

    @property
    def _in_exam(self) -> bool:
        return self.exam is not None and not self.exam.over

    def searching(self) -> str:
        """'drill' or 'exam' while the pupil is to find a fault himself: until it is mended, or the solution was shown."""
        opened = self.opened
        if opened is None or not opened.lesson.is_drill or self.state.solved or opened.shown:
            return ""
        return "exam" if self._in_exam else "drill"

    # -- life ----------------------------------------------------------------------------------------------------------

    async def run(self) -> None:
        """Go on until the window is closed."""
        try:
            while True:
                while self._requests:
                    self._requests.popleft()()
                await self._follow_file()
                self.look()
                if self.kept.is_due:
                    self._session.spawn(self._save())
                self._wanted.clear()
                if not self._requests:
                    await self._session.wait(self._wanted, CALM_SECONDS if self._is_calm() else LOOK_SECONDS)
        finally:
            self._leave()
            if self.kept.unwritten:
                self._desk.in_background(self.kept.last_writing(), "day6-progress")

    def _is_calm(self) -> bool:
        """Whether there has been no news for a while."""
        news = self.opened.live.stirring if self.opened is not None else None
        self._calm = self._calm + 1 if news == self._news else 0
        self._news = news
        return self._calm > CALM_LOOKS

    def _leave(self) -> None:
        if self.opened is not None:
            self.opened.close()
            self.opened = None

    def _start(self, work: Awaitable[None]) -> None:
        """Let something that takes time go on beside the looking."""
        self._session.spawn(self._guarded(work))

    async def _guarded(self, work: Awaitable[None]) -> None:
        """Type or prepare something for the pupil; what goes wrong is told, and the lesson goes on."""
        self._set(working=True, problem="")
        try:
            await work
        except (StageError, OSError, ValueError, KeyError) as error:
            self._set(problem=named_reason(error))
        finally:
            self._set(working=False)

    def changed(self) -> None:
        """Something is shown in another way."""
        self.version += 1
        self._desk.scheduler.announce_activity()

    def _set(self, **changes: object) -> None:
        new = replace(self.state, **changes)  # type: ignore[arg-type]
        if new != self.state:
            self.state = new
            self.changed()

    # -- going through -------------------------------------------------------------------------------------------------

    def open(self, name: str, step: str = "") -> None:
        """Open a lesson where the pupil stopped, or at a step ('*': the first); a drill prepares its fault first."""
        lesson = self.offer.named(name)
        if lesson is None:
            self._set(unknown=name)
            return
        self._leave()
        progress = self.progress
        wanted = step or progress.at.get(name, "")
        index = next((at for at, each in enumerate(lesson.steps) if each.name == wanted), 0)
        if not step and index < len(lesson.steps) - 1 and progress.step(name, lesson.steps[index].name).solved:
            index += 1  # it was solved, and then the pupil stopped
        opened = self.opened = OpenLesson(self._desk, self._session, lesson, self._since_ns)
        self._since_ns = None
        self._desk.searching = self.searching
        if lesson.is_drill:
            self._go_to(opened, 0)
            return
        progress.last, progress.last_title = name, dict(lesson.title)
        self._go_to(opened, index)
        if not index:
            self._set(leftovers=tuple(dict.fromkeys(opened.live.nodes())))

    def open_last(self) -> None:
        """Go on where the pupil stopped the last time, if that lesson is here; after its end with the list."""
        lesson = self.offer.named(self.progress.last)
        if lesson is None:
            return
        last = lesson.steps[-1].name
        if self.progress.at.get(lesson.name, "") == last and self.progress.step(lesson.name, last).solved:
            self._set(finished=lesson)
        else:
            self.open(lesson.name)

    def close(self) -> None:
        """Back to the list of lessons; an exam ends."""
        self.exam = None
        self._show_list(self.state.finished)

    def _show_list(self, finished: Lesson | None = None) -> None:
        self._leave()
        self.state = State(finished=finished)
        self.changed()

    def start_exam(self, drills: Sequence[str] = ()) -> None:
        """Some drills in a row, time and hints counted: these, unless they are just being done, or some by chance."""
        if self._in_exam and self.exam is not None and self.exam.drills == tuple(drills):
            return
        if drills:
            self.exam = Exam(tuple(drills), round(time.time(), 1))
        elif self.offer.drills:
            self.exam = new_exam(self.offer.drills)
        else:
            return
        self.open(self.exam.at)

    def random_drill(self) -> None:
        """A drill that is not solved yet, by chance."""
        unsolved = [drill for drill in self.offer.drills if not self.progress.solved(drill.name)]
        if drills := unsolved or self.offer.drills:
            self.open(random.choice(drills).name)

    def _go_on_with(self, exam: Exam, opened: OpenLesson) -> None:
        """Count how the drill of an exam went; the next one, or the report."""
        state = self.state
        seconds = time.monotonic() - opened.began
        exam = self.exam = exam.with_result(state.solved and not opened.shown, seconds, state.hints)
        if not exam.over:
            self.open(exam.at)
            return
        self.progress.exams.append(exam.kept())
        self.kept.unsaved = True
        self._show_list()

    def _go_to(self, opened: OpenLesson, index: int) -> None:
        lesson, step = opened.lesson, opened.lesson.steps[index]
        opened.begin(step)
        done = self.progress.step(lesson.name, step.name)
        hints = 0 if self._in_exam else min(done.hints, HINTS)
        self.state = State(lesson, index, done_before=bool(done.solved), hints=hints)
        if step.before and not lesson.is_drill and step.name not in opened.prepared:
            opened.prepared.add(step.name)
            self._start(opened.prepare(step))
        if opened.demonstration is None:
            self.progress.at[lesson.name] = step.name
            self.kept.unsaved = True
        self.look()
        self._set(before_asked=self.state.solved)
        self.changed()

    def next(self) -> None:
        """To the next step; after the last one back to the list. A step that is not solved is passed over."""
        opened, state = self.opened, self.state
        if opened is None:
            return
        if not state.solved and not self._done.solved:
            self._note(passed_over=True)
        if self.exam is not None and not self.exam.over:
            self._go_on_with(self.exam, opened)
        elif state.is_last:
            self.exam = None
            self._show_list(opened.lesson)
        else:
            self._go_to(opened, state.index + 1)

    def back(self) -> None:
        """To the step before."""
        if self.opened is not None and self.state.index:
            self._go_to(self.opened, self.state.index - 1)

    def again(self) -> None:
        """Begin the step once more: what was done counts no longer. Not in an exam, whose time runs on.

        A drill whose fault could not be made is begun once more.
        """
        opened = self.opened
        if opened is None or self._in_exam:
            return
        if opened.injected or not opened.lesson.is_drill:
            self._go_to(opened, self.state.index)
        elif not self.state.working:
            self.open(opened.lesson.name)

    def hint(self) -> None:
        """Show one more hint; it is counted."""
        hints = self.state.hints + 1
        if self.opened is None or hints > HINTS:
            return
        self._set(hints=hints)
        if not self.state.solved:
            self._note(hints=max(self._done.hints, hints))

    def choose(self, letter: str) -> None:
        """Answer the step's question."""
        if self.opened is None or self.state.solved:
            return
        self.opened.live.answer = letter
        self._note(answers=(self._done.answers + letter)[:LONGEST_ANSWERS])
        self.look()
        if not self.state.solved:
            self._note(refused=self._done.refused + 1)
        self._set(answer=letter, refused="" if self.state.solved else letter)

    def prepare(self) -> None:
        """Play the solutions of the earlier steps that are needed, visibly."""
        if self.opened is not None and self.state.missing and not self.state.working:
            self._start(self.opened.solve_needed(self.state.missing))

    def clear_up(self) -> None:
        """End what runs from before, so that the lesson begins with nothing."""
        if self.opened is not None and self.state.leftovers and not self.state.working:
            self._start(self.opened.stage.clear_up())

    def show_solution(self) -> None:
        """Play this step's solution, visibly; the step counts as passed over, not as solved by the pupil."""
        if self.opened is not None and not self.state.working:
            self._start(self.opened.solve(self.opened.step))

    def demonstrate(self, language: str) -> None:
        """Play the rest of the lesson by itself, or stop that."""
        opened = self.opened
        if opened is None or opened.lesson.is_drill:
            return
        if opened.demonstration is not None:
            opened.demonstration.stop()
            return
        opened.demonstration = Demonstration(self, opened, language)
        self._start(opened.demonstration.play())

    # -- looking -------------------------------------------------------------------------------------------------------

    def look(self) -> None:
        """Ask the checks of the step."""
        opened, state = self.opened, self.state
        if opened is None or state.solved or (opened.lesson.is_drill and state.working):
            return
        if opened.lesson.is_drill and not opened.injected:
            self._begin_drill(opened)
            return
        if state.leftovers:
            running = opened.live.nodes()
            self._set(leftovers=tuple(name for name in state.leftovers if name in running))
        checks = opened.step.checks
        verdicts = tuple(check.judge(opened.live) for check in checks)
        solved = all(verdict.ok for verdict in verdicts)
        ending = any(verdict.ok for check, verdict in zip(checks, verdicts, strict=True) if check.name == "no_node")
        missing = () if solved or ending else opened.missing(self.progress)
        self._set(verdicts=verdicts, solved=solved, missing=missing)
        done = self._done
        if not solved or done.solved:
            return
        if opened.shown:
            self._note(passed_over=True)
        else:
            seconds = done.seconds + time.monotonic() - opened.began
            self._note(solved=time.time(), seconds=round(seconds, 1), passed_over=False)

    def _begin_drill(self, opened: OpenLesson) -> None:
        """Make the fault of a drill as soon as nothing else runs, and tell what does."""
        running = tuple(dict.fromkeys(opened.live.nodes()))
        self._set(leftovers=running)
        if not running and not opened.injecting:
            opened.injecting = True
            self._start(opened.inject())

    @property
    def _done(self) -> StepDone:
        """What is known of this step."""
        opened = self.opened
        return self.progress.step(opened.lesson.name, opened.step.name) if opened is not None else StepDone()

    def _note(self, **changes: object) -> None:
        """Keep something of this step."""
        if self.opened is not None:
            done = replace(self._done, **changes)  # type: ignore[arg-type]
            self.progress.note(self.opened.lesson.name, self.opened.step.name, done)
            self.kept.unsaved = True
            self.changed()

    # -- files ---------------------------------------------------------------------------------------------------------

    async def _save(self) -> None:
        before = self.kept.failed
        await self.kept.save()
        if self.kept.failed != before:  # all else that it changes isn't shown
            self.changed()

    async def _follow_file(self) -> None:
        """Show the lesson as its file is now."""
        opened = self.opened
        if opened is None:
            return
        try:
            new = await opened.file.changed()
        except LessonMistakes as mistakes:
            self._set(mistakes=mistakes)
            return
        if new is None:
            return
        name = opened.step.name
        here = min(self.state.index, len(new.steps) - 1)  # its name may be what was changed
        index = next((at for at, step in enumerate(new.steps) if step.name == name), here)
        self.offer = self.offer.with_file_of(new)
        opened.lesson = new
        self._go_to(opened, index)

"""At 80x24 every step of the six days has on the screen what it speaks of, and the keyboard where it is done.

A day is played once, as its solutions say, and what the screen shows is noted at the beginning of each step and at its end.
"""

from __future__ import annotations

import asyncio
from collections.abc import Callable
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import pytest

from day6_core.lessons.catalogue import HERE, days
from day6_core.lessons.document import Lesson, Step
from day6_core.lessons.rehearsal import apart
from day6_core.shell.desk import Desk
from day6_tui.app import Day6App, make_look
from day6_tui.features.step_view import EDITOR, LEAST_PAGE, NARROWEST, kind_of
from day6_tui.options import Options
from tests.support.waiting import Deadline
from tests.tui.screens import UTF8, screen_text

pytestmark = [pytest.mark.process, pytest.mark.long]

FAST = 2.0
"""How fast the world is. The program of day 3 sleeps for fifteen seconds of the wall's; forty of the world's are waited."""

LONGEST = 90.0


class Seen(NamedTuple):
    """What there is to see at one moment."""

    kinds: list[str]
    """Those of the panes that are shown, and as large as they need."""
    keyboard: str
    """The kind of the pane that has it."""
    text: str

    def lacks(self, step: Step, *, begins: bool) -> list[str]:
        """What a step has to show, and does not: at its end all that it speaks of, at its beginning where it is done."""
        task = f"▸ {step.pages['zh'].do.replace('`', '')[:2].strip()}"
        asks = all(check.name == "answer" for check in step.checks)
        at_work = {"lesson"} if asks else {step.see[0], EDITOR}
        found = [] if "lesson" in self.kinds else ["the page"]
        found += [] if task in self.text else [task]
        if begins:
            return found + [f"the keyboard in {' or '.join(at_work)}"] * (self.keyboard not in at_work)
        return found + [kind for kind in set(step.see) if self.kinds.count(kind) < step.see.count(kind)]


class Played(NamedTuple):
    """A day: what was seen when each step began and when it was solved, and why it did not go on."""

    seen: dict[str, tuple[Seen, Seen]]
    ended: str


class Player:
    """One day, played on the desktop."""

    def __init__(self, app: Day6App, pilot: Any) -> None:
        self._app, self._pilot = app, pilot
        self.seen: dict[str, tuple[Seen, Seen]] = {}

    @property
    def _course(self) -> Any:
        return self._app.lessons.pane.course if self._app.lessons.pane is not None else None

    async def _until(self, condition: Callable[[], object]) -> None:
        deadline = Deadline(LONGEST)
        while not condition():
            assert not deadline.is_over(), screen_text(self._app)
            self._app.frames.step()
            await self._pilot.pause(0.02)

    async def _look(self, step: Step, *, begins: bool) -> Seen:
        """What there is to see when all that is wanted has come, or does not come."""
        deadline = Deadline()
        while (seen := self._seen()).lacks(step, begins=begins) and not deadline.is_over():
            self._app.frames.step()
            await self._pilot.pause(0.02)
        return seen

    def _seen(self) -> Seen:
        desktop = self._app.desktop
        plan = desktop.plan_now().places
        kinds = [
            kind_of(desktop.slots[slot])
            for slot, place in plan.items()
            if place.width >= NARROWEST and place.height >= self._least_rows(slot)
        ]
        keyboard = desktop.focused_pane
        return Seen(kinds, kind_of(keyboard) if keyboard is not None else "", screen_text(self._app))

    def _least_rows(self, slot: int) -> int:
        desktop = self._app.desktop
        return LEAST_PAGE if desktop.slots[slot] is self._app.lessons.pane else desktop.needs(slot).least.rows

    async def play(self, lesson: Lesson) -> None:
        await self._until(lambda: self._course is not None and self._course.state.step is not None)
        for number, step in enumerate(lesson.steps):
            await self._until(lambda number=number: self._course.state.index == number)
            begun = await self._look(step, begins=True)
            if not self._course.state.solved:
                self._course.request(self._course.show_solution)
                await self._until(lambda: self._course.state.solved or self._course.state.problem)
                await self._until(lambda: not self._course.state.working)
            assert not self._course.state.problem, (step.name, self._course.state.problem)
            self.seen[step.name] = begun, await self._look(step, begins=False)
            await self._pilot.press("f5")


def played(lesson: Lesson) -> Played:
    """Play a day."""

    async def play(home: Path) -> Played:
        given = Options(fps=0, lang="zh", lesson=lesson.name)
        desk = Desk(home, domain_id=0)
        desk.set_speed(FAST)
        app = Day6App(given, desk=desk, look=make_look(given, UTF8))
        desk.start()
        try:
            async with app.run_test(size=(80, 24)) as pilot:
                player, ended = Player(app, pilot), ""
                try:
                    await player.play(lesson)
                except AssertionError as error:
                    ended = str(error)
                return Played(player.seen, ended)
        finally:
            desk.hurry()
            desk.close()

    with apart(), TemporaryDirectory() as folder:
        return asyncio.run(play(Path(folder)))


@pytest.mark.virtual_time
@pytest.mark.parametrize("name", sorted(path.stem for path in (HERE / "days").glob("*.md")))
def test_a_step_has_what_it_speaks_of_on_the_screen(name: str) -> None:
    lesson = next(lesson for lesson in days() if lesson.name == name)
    day = played(lesson)
    wrong: list[str] = []
    for step in lesson.steps:
        if step.name not in day.seen:
            wrong.append(f"{step.name} is not reached: {day.ended}")
            break
        for begins, seen in zip((True, False), day.seen[step.name], strict=True):
            if lacking := seen.lacks(step, begins=begins):
                wrong.append(f"{step.name}, {'begun' if begins else 'done'}: no {', '.join(lacking)} in\n{seen.text}")
    assert wrong == [], "\n".join(wrong)
    if lesson.name == "day3":
        the_echo_is_seen_whole_beside_the_remote_control(day.seen["echo"][1].text)


def the_echo_is_seen_whole_beside_the_remote_control(text: str) -> None:
    wanted = ["linear:", "  x: 2.0", "  y: 0.0", "  z: 0.0", "angular:", "  x: 0.0", "  y: 0.0", "  z: 0.0", "---"]
    echoed = [line[1:].split("│")[0].split("┃")[0].rstrip() for line in text.split("\n")]
    assert any(echoed[at : at + len(wanted)] == wanted for at in range(len(echoed))), text
    assert "'q' to quit." in text and "θ" in text

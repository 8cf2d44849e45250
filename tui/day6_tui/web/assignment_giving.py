"""Hands assignments out to whoever is here, and to whoever comes later as soon as the desktop takes orders."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Awaitable, Callable
from dataclasses import replace

from day6_core.classroom.homes import same_name
from day6_core.classroom.order import Order
from day6_core.lessons.work import EXAM, FOLDER, Task
from day6_tui.locale import Texts
from day6_tui.web.assignment_standing import FAILURES, Standing, title_of, why
from day6_tui.web.assignment_texts import due_text
from day6_tui.web.assignments import Assignment, AssignmentStore
from day6_tui.web.sessions import Sessions

PAUSE = 0.3
"""Between two looks at who has come."""
SETTLED_SECONDS = 5.0
"""After which a desktop that has not refused an order has taken it."""
BUSY = "class.refused.busy"
AGAIN_SECONDS = 60.0
"""Between two tries where a folder could not be placed."""


class Giving:
    """Gives what is open, and keeps who has got it."""

    def __init__(
        self,
        store: AssignmentStore,
        sessions: Sessions,
        texts: Texts,
        open_: Callable[[], list[Standing]],
        keep: Callable[[Standing], Awaitable[None]],
    ) -> None:
        self._store = store
        self._sessions = sessions
        self._roster = sessions.feed.roster
        self._texts = texts
        self._open = open_
        self._keep = keep
        self._quiet: dict[str, float] = {}
        """Who is here and has said nothing since: when the last note before came. An order would be lost."""
        self._here: set[str] = set()
        self._given: dict[tuple[str, str], float] = {}
        """What was just handed out, and when, by the roster's clock: a note may follow that refuses it."""
        self._later: dict[tuple[str, str], float] = {}
        """What could not be handed out, and when it is tried again."""
        self._giving = asyncio.Lock()
        self._looking: asyncio.TimerHandle | None = None

    def begin(self) -> None:
        """Look at who comes, for as long as the server runs."""
        self._notice_who_came(first=True)
        self._sessions.feed.subscribe(self._look_soon)

    def _look_soon(self) -> None:
        self._notice_who_came()
        if self._looking is None:
            self._looking = asyncio.get_running_loop().call_later(PAUSE, self._look_round)

    def _look_round(self) -> None:
        self._looking = None
        if not self._giving.locked() and any(self._waiting(each) or self._refused(each) for each in self._open()):
            self._sessions.background.begin("serve.failed.assignments", self.give_who_waits())

    def _notice_who_came(self, *, first: bool = False) -> None:
        """A desktop takes orders when it has said something; what it said last time does not count."""
        rows = {row.name: row for row in self._roster.rows() if row.is_here}
        self._here &= rows.keys()
        self._quiet = {name: heard for name, heard in self._quiet.items() if name in rows and rows[name].heard == heard}
        for name in rows.keys() - self._here:
            self._here.add(name)
            if not first or rows[name].note is None:
                self._quiet[name] = rows[name].heard

    def _waiting(self, standing: Standing) -> list[str]:
        """Who can be given it now and has not got it."""
        assignment, now = standing.assignment, self._roster.now
        rows = (self._roster.row(name) for name in sorted(self._here - self._quiet.keys()))
        return [
            row.name for row in rows
            if row is not None and row.note is not None and row.note.refused != BUSY and assignment.is_for(row.name)
            and same_name(row.name) not in assignment.given and now >= self._later.get((assignment.id, row.name), 0.0)
        ]  # fmt: skip

    def _refused(self, standing: Standing) -> list[str]:
        """To whom it was given while a question stood open there, so that it was not opened."""
        found, id_ = [], standing.assignment.id
        for key, at in [each for each in self._given.items() if each[0][0] == id_]:
            row = self._roster.row(key[1])
            if self._roster.now - at > SETTLED_SECONDS:
                del self._given[key]
            elif row is not None and row.note is not None and row.heard >= at and row.note.refused == BUSY:
                found.append(key[1])
        return found

    async def give_who_waits(self) -> None:
        """Give everything to everybody who is here and has not got it."""
        async with self._giving:
            for standing in self._open():
                before = standing.assignment.given
                refused = self._refused(standing)
                given = {key: when for key, when in before.items() if key not in map(same_name, refused)}
                standing.assignment = replace(standing.assignment, given=given)
                for name in refused:
                    del self._given[standing.assignment.id, name]
                for name in self._waiting(standing):
                    if await self._give(standing.assignment, name, standing.trouble):
                        given[same_name(name)] = round(time.time(), 3)
                if given != before:
                    await self._keep(standing)

    async def _give(self, assignment: Assignment, name: str, trouble: dict[str, str]) -> bool:
        task, texts = assignment.task, self._texts
        if task.kind == FOLDER:
            try:
                await self._place(assignment, name)
            except FAILURES as error:
                trouble[same_name(name)] = why(error, texts)
                self._later[assignment.id, name] = self._roster.now + AGAIN_SECONDS
                return False
        values = {
            "title": title_of(assignment, texts),
            "due": due_text(texts, assignment.due),
            "folder": f"~/{task.name}",
        }
        said = texts("assign.say.folder" if task.kind == FOLDER else "assign.say", **values)
        self._given[assignment.id, name] = self._roster.now
        return not any(self._roster.order([name], each) for each in [*_orders(task), Order("say", text=said)])

    async def _place(self, assignment: Assignment, name: str) -> None:
        """Put the files of a folder into the home; what the pupil has there already stays. Raises some of FAILURES."""
        for path, data in (await asyncio.to_thread(self._store.files, assignment.id)).items():
            try:
                await self._sessions.files.put(name, f"{assignment.task.name}/{path}", data, renames=False)
            except FileExistsError:
                continue


def _orders(task: Task) -> list[Order]:
    """What opens it on a desktop."""
    if task.kind == FOLDER:
        return []
    return [Order("exam", text=" ".join(task.names)) if task.kind == EXAM else Order("lesson", text=task.name)]

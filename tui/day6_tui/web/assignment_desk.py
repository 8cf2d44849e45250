"""Hands assignments out, collects, has graded and gives back. Everything is done in the event loop, what blocks in threads."""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import re
import secrets
import time
from collections.abc import Awaitable, Callable, Iterable, Mapping
from dataclasses import replace
from pathlib import Path
from typing import Any

from day6_core.classroom.homes import same_name
from day6_core.classroom.order import Order
from day6_core.isolation.cell import IsolationError
from day6_core.lessons import work
from day6_core.lessons.catalogue import offer
from day6_core.lessons.document import Lesson
from day6_core.lessons.grading.grader import answers_of
from day6_core.lessons.grading.scenarios import gradings
from day6_core.lessons.work import EXAM, FOLDER, LESSON, Task
from day6_core.reason import named_reason
from day6_tui.locale import Texts
from day6_tui.web.assignment_giving import Giving
from day6_tui.web.assignment_standing import FAILURES, Standing, title_of, why
from day6_tui.web.assignment_texts import marks_text
from day6_tui.web.assignments import Assignment, AssignmentStore, Word
from day6_tui.web.collecting import Collector
from day6_tui.web.grading_room import GradingRoom, NotGraded
from day6_tui.web.sessions import Sessions

AT_A_TIME = 4
"""Homes that are read at once."""
LOOK_SECONDS, AGAIN_SECONDS = 30.0, 60.0
"""Between two looks at who has changed what was collected; and between two tries where the disk was full when it was due."""


class AssignmentDesk:
    """The assignments of a class. `changed` is called after every change."""

    def __init__(
        self,
        store: AssignmentStore,
        sessions: Sessions,
        collector: Collector,
        room: GradingRoom,
        lessons: Path | None,
        texts: Texts,
    ) -> None:
        self._store = store
        self._sessions = sessions
        self._roster = sessions.feed.roster
        self._collector = collector
        self._room = room
        self._folder = lessons
        self._texts = texts
        self.standings: dict[str, Standing] = {}
        self.version = 0
        self._giving = Giving(store, sessions, texts, self._open, self._keep)

    def load(self) -> None:
        """Read what is kept. It blocks."""
        for each in self._store.all():
            standing = self.standings[each.id] = Standing(each)
            standing.collected = {same_name(found.pupil): found for found in self._store.everybodys(each.id)}
            try:
                standing.words = self._store.words(each.id)
            except OSError as error:
                self._sessions.feed.say("assign.unread", title=each.id, reason=named_reason(error))
        with contextlib.suppress(OSError, IsolationError):  # what is left is in nobody's way
            self._room.sweep()

    def begin(self) -> None:
        """Look at who comes, what is due and what has changed, for as long as the server runs."""
        self._giving.begin()
        self._sessions.background.repeat("serve.failed.assignments", 5.0, self.take_what_is_due)
        self._sessions.background.repeat("serve.failed.assignments", LOOK_SECONDS, self.look_for_changes)

    def _open(self) -> list[Standing]:
        return [each for each in self.standings.values() if not each.assignment.closed]

    def tell(self) -> None:
        """Something is shown in another way."""
        self.version += 1
        self._sessions.feed.tell()

    # -- who it is for -------------------------------------------------------------------------------------------------

    def names(self, standing: Standing) -> list[str]:
        """Everybody who is meant to do it, and whoever has handed something in."""
        found = {same_name(each.pupil): each.pupil for each in standing.collected.values()}
        found |= {same_name(name): name for name in standing.assignment.to or ()}
        rows = (row.name for row in self._roster.rows())
        found |= {same_name(name): name for name in rows if standing.assignment.is_for(name)}
        return sorted(found.values())

    def _chosen(self, standing: Standing, names: Iterable[str] | None) -> list[str]:
        wanted = None if names is None else set(map(same_name, names))
        return [name for name in self.names(standing) if wanted is None or same_name(name) in wanted]

    # -- handing out ---------------------------------------------------------------------------------------------------

    async def hand_out(
        self, task: Task, title: Mapping[str, str], to: tuple[str, ...] | None, due: float, files: Mapping[str, bytes]
    ) -> Assignment:
        """Give it to all or to these, and to who comes later. Raises TooMany, OSError."""

        def keep() -> Assignment:
            made = self._store.new(task, title, to, due)
            for path, data in files.items():
                self._store.put_file(made.id, path, data)
            self._store.keep(made)  # now it is one
            return made

        made = await asyncio.to_thread(keep)
        self.standings[made.id] = Standing(made)
        self.tell()
        return made

    # -- collecting ----------------------------------------------------------------------------------------------------

    async def collect(self, standing: Standing, names: Iterable[str] | None = None) -> list[str]:
        """Collect everybody's work or that of these, whether they are here or not; return from whom nothing could be taken."""

        async def one(name: str) -> None:
            key = same_name(name)
            each, owed = standing.assignment, standing.owed
            found = await self._collector.find(name, each.task)
            was_taken = each.due_taken or (owed is not None and key not in owed)
            late = bool(each.due) and was_taken and time.time() > each.due
            kept = await asyncio.to_thread(
                self._collector.collect, each, name, found, standing.collected.get(key), late=late
            )
            if kept is not None:
                standing.collected[key] = kept
            if standing.owed is not None:
                standing.owed.discard(key)
            standing.changed.discard(key)

        async with standing.working_lock:
            return await self._each(standing, "collect", self._chosen(standing, names), one, AT_A_TIME)

    async def take_what_is_due(self) -> None:
        """Collect by itself when it is due: whatever is collected later and differs is late."""
        now = time.time()
        for standing in self._open():
            each = standing.assignment
            if each.due and not each.due_taken and each.due <= now and now >= standing.again:
                failed = await self.collect(standing, standing.owed)
                standing.owed = set(map(same_name, failed))
                if failed:  # the others are late from now on
                    standing.again = now + AGAIN_SECONDS
                    continue
                standing.assignment = replace(standing.assignment, due_taken=True)
                await self._keep(standing)

    async def look_for_changes(self) -> None:
        """See whose work is not as it was collected. Who is not here changes nothing."""
        if not self._roster.is_attended:
            return
        for standing in self._open():
            before = set(standing.changed)
            for key, collected in list(standing.collected.items()):
                row = self._roster.row(collected.pupil)
                if row is not None and row.is_here:
                    task = standing.assignment.task
                    try:
                        found = await self._collector.find(collected.pupil, task)
                    except FAILURES:
                        continue  # collecting says why
                    mark = await asyncio.to_thread(work.fingerprint, task, found)
                    if standing.collected.get(key) is collected:  # else it was collected meanwhile
                        (standing.changed.add if mark != collected.print else standing.changed.discard)(key)
            if standing.changed != before:
                self.tell()

    async def _each(
        self, standing: Standing, what: str, names: list[str], one: Callable[[str], Awaitable[None]], at_a_time: int
    ) -> list[str]:
        """Do this for each, a few at a time, and show how far it is; return for whom it failed."""
        standing.working, standing.done, standing.all = what, 0, len(names)
        self.tell()
        room, failed = asyncio.Semaphore(at_a_time), []

        async def heard(name: str) -> None:
            async with room:
                standing.trouble.pop(same_name(name), None)
                try:
                    await one(name)
                except FAILURES as error:
                    failed.append(name)
                    standing.trouble[same_name(name)] = why(error, self._texts)
                standing.done += 1
                self.tell()

        try:
            await asyncio.gather(*map(heard, names))
        finally:
            standing.working = ""
            self.tell()
        return sorted(failed)

    # -- grading -------------------------------------------------------------------------------------------------------

    async def grade(self, standing: Standing, names: Iterable[str] | None = None) -> list[str]:
        """Play the hidden scenarios with what was collected last and has no grade yet; return for whom that failed.

        With `names` these are graded anew.
        """
        task, seed = standing.assignment.task, secrets.token_hex(8)
        lesson = await asyncio.to_thread(self.lesson, task)
        played = [
            each for each in await asyncio.to_thread(gradings) if task.kind == LESSON and each.lesson == task.name
        ]
        answers = answers_of([lesson] if lesson is not None and task.kind == LESSON else [])

        async def one(name: str) -> None:
            collected = standing.collected[same_name(name)]
            packed = await asyncio.to_thread(collected.file.read_bytes)
            key = f"{standing.assignment.id}/{same_name(name)}"
            found = await self._room.grade(key, packed, played, answers, seed)
            if found["problem"]:
                raise NotGraded(found["problem"])
            report = {**found, "seed": seed, "when": round(time.time(), 3)}
            kept = await asyncio.to_thread(self._store.keep_grade, collected, report)
            standing.collected[same_name(name)] = kept

        async with standing.working_lock:
            chosen = [each for each in self._chosen(standing, names) if same_name(each) in standing.collected]
            if names is None:
                chosen = [each for each in chosen if standing.collected[same_name(each)].grade is None]
            if not played and not answers:
                return []
            return await self._each(standing, "grade", chosen, one, len(chosen) or 1)

    def lesson(self, task: Task) -> Lesson | None:
        """The lesson or drill of a task. It blocks."""
        return None if task.kind in (FOLDER, EXAM) else offer(self._folder).named(task.name)

    # -- the teacher's own, and back -----------------------------------------------------------------------------------

    async def word(self, standing: Standing, name: str, **said: Any) -> None:
        """Keep what the teacher says (`mark`, `line`). Raises OSError; then nothing has changed."""
        key = same_name(name)
        async with standing.writing:
            words = {**standing.words, key: replace(standing.words.get(key, Word()), **said)}
            await asyncio.to_thread(self._store.keep_words, standing.assignment.id, words)
            standing.words = words
        self.tell()

    async def give_back(self, standing: Standing, names: Iterable[str] | None = None) -> list[str]:
        """Put marks and lines into the homes of those who have something new; return for whom that failed."""
        path = f"marks/{_file_name(standing.assignment, self._texts)}.md"

        async def one(name: str) -> None:
            text = self.text_for(standing, name)
            assert text is not None
            file = await self._sessions.files.put(name, path, text)
            self._roster.order([name], Order("file", text=file))
            await self.word(standing, name, returned=round(time.time(), 3), print=_print(text))

        async with standing.working_lock:
            chosen = [each for each in self._chosen(standing, names) if self.has_news(standing, each)]
            return await self._each(standing, "return", chosen, one, 1)  # each writes the same file of the store

    def text_for(self, standing: Standing, name: str) -> bytes | None:
        """What is given back to a pupil; None while there is nothing to say."""
        key = same_name(name)
        collected, word = standing.collected.get(key), standing.words.get(key, Word())
        if not (word.mark or word.line) and (collected is None or collected.grade is None):
            return None
        return marks_text(self._texts, standing.assignment, collected, word)

    def has_news(self, standing: Standing, name: str) -> bool:
        """Whether there is something for the pupil that was not given back."""
        text = self.text_for(standing, name)
        return text is not None and standing.words.get(same_name(name), Word()).print != _print(text)

    async def close(self, standing: Standing, on: bool) -> None:
        """Hand it out to nobody any more, or again."""
        standing.assignment = replace(standing.assignment, closed=on)
        await self._keep(standing)

    async def _keep(self, standing: Standing) -> None:
        async with standing.writing:
            try:
                await asyncio.to_thread(self._store.keep, standing.assignment)
            except OSError as error:  # a full disk: the lesson goes on
                title = title_of(standing.assignment, self._texts)
                self._sessions.feed.say("assign.unkept", title=title, reason=named_reason(error))
        self.tell()


def _print(text: bytes) -> str:
    return hashlib.sha256(text).hexdigest()


def _file_name(assignment: Assignment, texts: Texts) -> str:
    return re.sub(r"[^\w-]+", "_", title_of(assignment, texts)).strip("_")[:40] or assignment.id

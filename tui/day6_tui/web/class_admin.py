"""What the teacher does to desktops, on the teacher's page: {"t":"desk","do","names","lesson"}.

`do` is a word of DEEDS. Whatever it is, the desktop ends first and starts again where its tab is. The rows come with `desks`:
what was done, for how many, where what was before is kept, and for whom it failed and why.
"""

from __future__ import annotations

import asyncio
import itertools
import os
from collections import deque
from collections.abc import Callable
from dataclasses import dataclass, field
from functools import partial
from typing import Any, NamedTuple

from aiohttp import web

from day6_core.classroom.homes import Strange, same_name
from day6_core.isolation.cell import Cell, IsolationError, Phrase
from day6_core.isolation.mode import Mode
from day6_core.lessons.progress import ProgressError
from day6_core.reason import reason
from day6_tui.locale import Texts
from day6_tui.web import resets
from day6_tui.web.class_part import Answer, Hear, names_of
from day6_tui.web.sessions import Sessions

AT_ONCE = 4
"""Desktops that are ended at a time."""
MOST_TOLD = 10
"""Orders of which the page is told what came of them."""
LONGEST_LESSON = 100


class Deed(NamedTuple):
    """What is done while no desktop is there, given the mode and the lesson, and what it is called in the log."""

    what: str
    work: Callable[[Mode, Cell, str], str]
    runs: bool = False
    """Whether there has to be a desktop."""
    is_for_one: bool = False


DEEDS = {
    "restart": Deed("restarted", lambda mode, cell, lesson: "", runs=True),
    "clear": Deed("cleared", lambda mode, cell, lesson: resets.clear_desk(cell)),
    "lesson": Deed("reset_lesson", lambda mode, cell, lesson: resets.reset_lesson(cell, lesson)),
    "home": Deed("reset_home", lambda mode, cell, lesson: resets.reset_home(mode, cell), is_for_one=True),
}


@dataclass
class Done:
    """An order, and what has come of it so far."""

    id: int
    do: str
    lesson: str
    names: list[str]
    count: int = 0
    kept: str = ""
    """Where what was is kept: of one pupil."""
    failed: list[tuple[str, Phrase | str]] = field(default_factory=list)
    """Names and reasons."""


class ClassAdmin:
    """Restarts desktops and lets what is in homes begin anew."""

    def __init__(self, sessions: Sessions) -> None:
        self._sessions = sessions
        self._feed = sessions.feed
        self._numbers = itertools.count(1)
        self._done: deque[Done] = deque(maxlen=MOST_TOLD)
        self._busy: set[str] = set()
        """Pupils to whom something is done just now."""
        self._free = asyncio.Semaphore(AT_ONCE)

    def hears(self) -> dict[str, Hear]:
        """What the teacher has done."""
        return {"desk": self._order}

    def routes(self) -> list[web.RouteDef]:
        """It has none."""
        return []

    def state(self, texts: Texts) -> dict[str, Any]:
        """What has come of the last orders."""
        return {"desks": [_told(each, texts) for each in self._done]}

    async def _order(self, found: dict[str, Any]) -> Answer:
        deed, names = DEEDS[found["do"]], names_of(found)
        if deed.is_for_one and (names is None or len(names) != 1):
            raise ValueError("that is for one pupil")
        lesson = str(found["lesson"])[:LONGEST_LESSON] if found["do"] == "lesson" else ""
        known = {same_name(name): name for name in self._feed.roster.names()}
        wanted = known if names is None else dict.fromkeys(same_name(name) for name in names)
        chosen = [known[key] for key in wanted if key in known and self._is_for(deed, known[key])]
        done = Done(next(self._numbers), found["do"], lesson, chosen)
        if names is not None and len(names) == 1 and not chosen:
            done.failed.append((names[0], Phrase("serve.desk.none" if deed.runs else "serve.desk.no_home")))
        self._done.append(done)
        self._feed.tell()
        for name in chosen:
            self._sessions.background.begin("serve.failed.desk", self._do(done, deed, name))
        return None

    def _is_for(self, deed: Deed, name: str) -> bool:
        runs = same_name(name) in self._sessions.running
        return runs or (not deed.runs and os.path.lexists(self._sessions.home_of(name)))

    async def _do(self, done: Done, deed: Deed, name: str) -> None:
        key = same_name(name)
        if key in self._busy:
            done.failed.append((name, Phrase("serve.desk.busy")))
            self._feed.tell()
            return
        self._busy.add(key)
        try:
            async with self._free:
                work = partial(_work, deed, self._sessions.mode, done.lesson)
                done.kept = await self._sessions.apart(name, work)
                self._feed.roster.journal.note(deed.what, name, " ".join(filter(None, (done.lesson, done.kept))))
                done.count += 1
        except IsolationError as error:
            done.failed.append((name, error.words))
        except (ProgressError, Strange):
            done.failed.append((name, Phrase("serve.desk.progress")))
        except OSError as error:
            done.failed.append((name, reason(error)))
        finally:
            self._busy.discard(key)
            self._feed.tell()


def _work(deed: Deed, mode: Mode, lesson: str, cell: Cell) -> str:
    return deed.work(mode, cell, lesson)


def _told(done: Done, texts: Texts) -> dict[str, Any]:
    def words(why: Phrase | str) -> str:
        return why if isinstance(why, str) else texts(why.key, **why.values)

    return {
        "id": done.id,
        "do": done.do,
        "lesson": done.lesson,
        "name": done.names[0] if len(done.names) == 1 else "",
        "all": len(done.names),
        "count": done.count,
        "kept": done.kept,
        "failed": [[name, words(why)] for name, why in done.failed],
    }

"""Files that the teacher hands to pupils. The page sends one to `class/hand?name=…` and is told {"id","name"}.

Then {"t":"hand","names","id"} puts it into the homes, below `handed/`; the rows come with `handed`: how far that is, and for whom
it failed and why. Whoever is not here is told of it on coming. (A link is an order.) `handouts` is who has opened which.
"""

from __future__ import annotations

import asyncio
import itertools
from collections import deque
from dataclasses import asdict, dataclass, field
from typing import Any, NamedTuple

from aiohttp import web

from day6_core.classroom.handed import FOLDER, LARGEST, clean_file_name
from day6_core.classroom.handouts import HandOut
from day6_core.classroom.order import Order
from day6_core.isolation.cell import IsolationError
from day6_core.reason import reason
from day6_tui.locale import Texts
from day6_tui.web.class_part import Answer, Hear, names_of
from day6_tui.web.gate import Gate
from day6_tui.web.sessions import Sessions
from day6_tui.web.tokens import TEACHER

MOST_KEPT = 4
"""Files that wait to be handed out."""
AT_ONCE = 8
"""Homes that are written to at a time."""
MOST_UNTOLD = 20
"""Files of which a pupil is told on coming."""


class Upload(NamedTuple):
    """A file that came from the page."""

    id: int
    name: str
    data: bytes


@dataclass
class Handing:
    """How far the handing out of a file is."""

    id: int
    name: str
    all: int
    number: int
    """By which the desktops tell that it was opened."""
    count: int = 0
    failed: list[tuple[str, str]] = field(default_factory=list)
    """Names and reasons."""


class ClassHanded:
    """Takes files from the page and puts them into homes."""

    def __init__(self, gate: Gate, sessions: Sessions) -> None:
        self._gate = gate
        self._sessions = sessions
        self._uploads: deque[Upload] = deque(maxlen=MOST_KEPT)
        self._ids = itertools.count(1)
        self._handings: deque[Handing] = deque(maxlen=MOST_KEPT)
        self._untold: dict[str, deque[tuple[Handing, str]]] = {}
        """name -> files that this pupil has not been told of"""
        sessions.feed.subscribe(self._tell_who_came)

    def hears(self) -> dict[str, Hear]:
        """To whom a file goes."""
        return {"hand": self._hand}

    def routes(self) -> list[web.RouteDef]:
        """Where the page sends a file."""
        return [web.post("/class/hand", self._take)]

    def state(self, texts: Texts) -> dict[str, Any]:
        """What was handed out last."""
        roster = self._sessions.feed.roster
        known = set(roster.names())
        handouts = [{"number": each.number, "text": each.text, **_opened(each, known)} for each in roster.handed.all]
        return {"handed": [asdict(each) for each in self._handings], "handouts": handouts}

    async def _take(self, request: web.Request) -> web.StreamResponse:
        if self._gate.ticket(request, TEACHER) is None:
            return web.Response(status=403, text="No token.\n")
        data = await self._gate.body(request, LARGEST)
        if data is None:
            return web.Response(status=413, text=f"At most {LARGEST} bytes.\n")
        upload = Upload(next(self._ids), clean_file_name(request.query.get("name", "")), data)
        self._uploads.append(upload)
        return web.json_response({"id": upload.id, "name": upload.name})

    async def _hand(self, found: dict[str, Any]) -> Answer:
        number, roster, chosen = int(found["id"]), self._sessions.feed.roster, names_of(found)
        upload = next((each for each in self._uploads if each.id == number), None)
        if upload is None:
            raise KeyError(number)
        known = roster.names()
        names = known if chosen is None else [name for name in dict.fromkeys(chosen) if name in known]
        handing = Handing(next(self._ids), upload.name, len(names), roster.questions.next_number())
        self._handings.append(handing)
        self._sessions.background.begin("serve.failed.hand", self._put_all(names, upload, handing))
        return {"t": "handing", "id": handing.id}

    async def _put_all(self, names: list[str], upload: Upload, handing: Handing) -> None:
        gate = asyncio.Semaphore(AT_ONCE)
        await asyncio.gather(*(self._put(gate, name, upload, handing) for name in names))

    async def _put(self, gate: asyncio.Semaphore, name: str, upload: Upload, handing: Handing) -> None:
        """Put it into one home."""
        async with gate:
            try:
                path = await self._sessions.files.put(name, f"{FOLDER}/{upload.name}", upload.data)
            except IsolationError as error:
                handing.failed.append((name, self._sessions.words(error.words)))
            except OSError as error:
                handing.failed.append((name, reason(error)))
            else:
                handing.count += 1
                self._untold.setdefault(name, deque(maxlen=MOST_UNTOLD)).append((handing, path))
        self._sessions.feed.tell()

    def _tell_who_came(self) -> None:
        """Tell those whose desktops listen by now: one that has just begun knows of no teacher yet."""
        roster = self._sessions.feed.roster
        for name in list(self._untold):
            row = roster.row(name)
            if row is None:
                del self._untold[name]
            elif row.is_here and row.note is not None and row.note.attended:
                for handing, path in self._untold.pop(name):
                    roster.hand([name], Order("file", text=path, number=handing.number), handing.name)


def _opened(handout: HandOut, known: set[str]) -> dict[str, Any]:
    """Who has it and has opened it, of those who are in the class."""
    given = [name for name in handout.given if name in known]
    return {"given": given, "opened": [name for name in given if name in handout.opened]}

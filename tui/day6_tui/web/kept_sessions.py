"""What the server remembers of the desktops that run, so that the next one finds them if this one is killed."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Iterable

from day6_core.isolation.mode import Mode
from day6_core.isolation.modes import survey
from day6_core.reason import reason
from day6_tui.web import records, starting
from day6_tui.web.places import Places
from day6_tui.web.records import Record
from day6_tui.web.session import WebSession
from day6_tui.web.settings import ServerSettings


class KeptSessions:
    """The file, and what is done with a desktop of it that cannot go on. `tell` prints a text of the catalogue."""

    def __init__(self, settings: ServerSettings, places: Places, mode: Mode, tell: Callable[..., None]) -> None:
        self._settings = settings
        self._mode = mode
        self._tell = tell
        self._file = places.server / "sessions.json"
        self._writing = asyncio.Lock()

    async def write(self, running: Iterable[WebSession]) -> None:
        """Write down that these run now."""
        async with self._writing:  # or an older list might be written last
            found = [Record(each.name, self._mode.name, each.domain) for each in running]
            try:
                await asyncio.to_thread(records.write, self._file, found)
            except OSError as error:  # a full disk: the class goes on
                self._tell("serve.no_record", file=str(self._file), reason=reason(error))

    async def read(self) -> list[Record]:
        """Return what the last server wrote down. Raises OSError."""
        try:
            return await asyncio.to_thread(records.read, self._file)
        except ValueError:
            self._tell("serve.bad_record", file=str(self._file))
            return []

    async def end_other(self, record: Record) -> None:
        """A desktop of a server that kept pupils apart in another way: it cannot go on. Raises IsolationError, OSError."""
        (offer,) = await asyncio.to_thread(survey, (record.mode,))
        if offer.mode is None:
            self._tell("serve.left", name=record.name)
            return
        places = Places(self._settings.data, offer.mode)
        cell = await asyncio.to_thread(places.cell, record.name, offer.mode, self._settings.limits)
        gone = await asyncio.to_thread(starting.stop, offer.mode, cell, places.keepers)
        self._tell("serve.other_mode" if gone else "serve.left", name=record.name, mode=record.mode)

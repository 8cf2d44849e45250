"""What the desktops take of this machine, on the teacher's page: {"t":"measure"}, again and again as long as somebody looks.

The rows come with `machine`: what becomes short and who takes it, always; and, while somebody looks, how many desktops there is
room for and the figures of each desktop and home. All are measured here, or None. Nobody is measured while no page is open.
"""

from __future__ import annotations

import asyncio
import contextlib
import shutil
import time
from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass, field
from typing import Any, NamedTuple

from aiohttp import web

from day6_core.classroom.homes import same_name
from day6_core.isolation import machine
from day6_core.isolation.cell import Cell
from day6_core.isolation.machine import Taken
from day6_core.isolation.mode import disk_of
from day6_core.system import memory
from day6_core.system.memory import Memory
from day6_tui.locale import Texts
from day6_tui.web import room
from day6_tui.web.class_part import Answer, Hear
from day6_tui.web.names import TEACHERS
from day6_tui.web.sessions import Sessions
from day6_tui.web.told import told

SECONDS = 10.0
"""Between two looks at what is left of the machine."""
WANTED_SECONDS = 4.0
"""Between two looks at the desktops while somebody wants to see them."""
ALL_SECONDS = 60.0
"""Between two looks at them otherwise, for what a desktop takes here."""
DISK_SECONDS = 30.0
"""Between two looks at the homes, which are walked."""
PATIENCE = 12.0
"""Seconds after which a page that does not ask again looks no more."""

LEAST_MEMORY, LEAST_SHARE = 512 << 20, 1 / 8
"""Memory is short below both: so many bytes, and this share of all."""
LEAST_DISK = 1 << 30


class Desktop(NamedTuple):
    """What one takes, its programs included."""

    taken: Taken
    processes: int
    at: float
    cpu: float | None
    """Of a core, since it was looked at before."""


@dataclass
class Look:
    """What was measured last."""

    memory: Memory | None = None
    cores: float = 0.0
    disk: int | None = None
    """Bytes left for the class."""
    desktops: dict[str, Desktop] | None = None
    """None: this system does not tell."""
    homes: dict[str, int] = field(default_factory=dict)
    """Bytes of each, by the pupil's name."""
    room: room.Room | None = None


class ClassMachine:
    """Measures, as far as somebody looks."""

    def __init__(self, sessions: Sessions) -> None:
        self._sessions = sessions
        self._feed = sessions.feed
        self._look = Look()
        self._is_looking = False
        self._is_due = False
        """Whether somebody has just begun to look, and waits for more than was measured before."""
        self._until = self._at = self._all_at = self._homes_at = float("-inf")
        self._known = room.remembered(sessions.folder)
        """What a desktop takes here."""

    def hears(self) -> dict[str, Hear]:
        """That somebody looks."""
        return {"measure": self._want}

    def routes(self) -> list[web.RouteDef]:
        """It has none."""
        return []

    async def _want(self, found: dict[str, Any]) -> Answer:
        self._is_due |= not self._is_wanted
        self._until = time.monotonic() + PATIENCE
        self._look_again()
        return None

    @property
    def _is_wanted(self) -> bool:
        return time.monotonic() < self._until

    # -- measuring -----------------------------------------------------------------------------------------------------

    def _look_again(self) -> None:
        """Measure anew if the last time is long ago. It is a page that asks for this, by being shown the rows."""
        is_old = time.monotonic() - self._at >= (WANTED_SECONDS if self._is_wanted else SECONDS)
        if not self._is_looking and (is_old or self._is_due):
            self._is_looking, self._is_due = True, False
            self._sessions.background.begin("serve.failed.machine", self._measure())

    async def _measure(self) -> None:
        try:
            cells = {each.name: each.cell for each in self._sessions.running.values() if not each.is_over}
            self._look = await asyncio.to_thread(self._measured, cells, self._feed.roster.names())
        finally:
            self._at, self._is_looking = time.monotonic(), False
        self._feed.tell()

    def _measured(self, cells: Mapping[str, Cell], names: Sequence[str]) -> Look:
        """In a thread; one at a time."""
        now, last = time.monotonic(), self._look
        look = Look(memory.available(), memory.cores(), shutil.disk_usage(self._sessions.folder).free)
        look.desktops, look.homes = last.desktops, last.homes
        is_all_wanted = self._is_wanted or _is_short(look)
        if is_all_wanted or now - self._all_at >= ALL_SECONDS:
            look.desktops, self._all_at = self._desktops(cells, last.desktops or {}), now
        if is_all_wanted and now - self._homes_at >= DISK_SECONDS:
            homes = ((name, self._sessions.home_of(name)) for name in names)
            look.homes, self._homes_at = {name: disk_of(home) for name, home in homes if home.is_dir()}, now
        running = [each.taken.memory for each in (look.desktops or {}).values()]
        self._learn(look.desktops or {})
        look.room = room.room(look.memory, look.cores, running, self._known, self._sessions.settings.most)
        return look

    def _desktops(self, cells: Mapping[str, Cell], before: Mapping[str, Desktop]) -> dict[str, Desktop] | None:
        try:
            pids = self._sessions.mode.processes_of(list(cells.values()))
        except OSError:
            return None
        found = {}
        for name, those in zip(cells, pids, strict=True):
            taken, at, last = machine.taken(those), time.monotonic(), before.get(name)
            if not taken.seconds:
                continue  # it has just ended, or nothing of it is seen
            cpu = None if last is None else machine.share(last.taken, taken, at - last.at)
            found[name] = Desktop(taken, len(taken.seconds), at, cpu)
        return found

    def _learn(self, desktops: Mapping[str, Desktop]) -> None:
        """Keep what the smallest takes: it is the nearest to one in which nothing runs. One that has just begun isn't whole."""
        whole = [each.taken.memory for each in desktops.values() if each.cpu is not None and each.taken.memory]
        if whole and (self._known is None or abs(min(whole) - self._known) > self._known / 10):
            self._known = min(whole)
            with contextlib.suppress(OSError):  # the next server measures it again
                room.remember(self._sessions.folder, self._known)

    # -- what is told --------------------------------------------------------------------------------------------------

    def state(self, texts: Texts) -> dict[str, Any]:
        """What is short, and while somebody looks everything."""
        self._look_again()
        look, found = self._look, {"warnings": list(self._warnings(texts))}
        if not self._is_wanted or look.room is None:
            return {"machine": found}
        return {
            "machine": found
            | {
                "memory": None if look.memory is None else look.memory._asdict(),
                "disk": look.disk,
                "cores": look.cores,
                "room": told(texts, "serve.room", {"room": look.room.desktops, "why": look.room.why}),
                "measured": look.desktops is not None,
                "most": {"memory": self._sessions.settings.limits.memory, "disk": self._sessions.settings.limits.disk},
                "desktops": list(self._rows(look)),
            }
        }

    def _rows(self, look: Look) -> Iterator[dict[str, Any]]:
        for name in dict.fromkeys((*(look.desktops or {}), *look.homes)):
            row: dict[str, Any] = {"name": name, "teacher": name == TEACHERS, "disk": look.homes.get(name)}
            if (desktop := (look.desktops or {}).get(name)) is not None:
                row |= {"memory": desktop.taken.memory, "cpu": desktop.cpu, "processes": desktop.processes}
            yield row

    def _warnings(self, texts: Texts) -> Iterator[str]:
        look = self._look
        if look.memory is not None and _is_memory_short(look.memory):
            taking = {name: each.taken.memory for name, each in (look.desktops or {}).items()}
            yield texts("serve.short.memory", left=look.memory.free >> 20) + _most(texts, taking)
        if look.disk is not None and look.disk < LEAST_DISK:
            yield texts("serve.short.disk", left=look.disk >> 20) + _most(texts, look.homes)
        names = {same_name(name) for name in self._feed.roster.names()}
        if look.room is not None and look.room.desktops < len(names):
            values = {"room": look.room.desktops, "wanted": len(names), "why": look.room.why}
            yield told(texts, "serve.room.small", values)


def _is_memory_short(memory: Memory) -> bool:
    return memory.free < min(LEAST_MEMORY, memory.total * LEAST_SHARE)


def _is_short(look: Look) -> bool:
    return (look.memory is not None and _is_memory_short(look.memory)) or (look.disk or LEAST_DISK) < LEAST_DISK


def _most(texts: Texts, taking: Mapping[str, int]) -> str:
    """Who takes most of it, if anybody was measured."""
    found = {name: size for name, size in taking.items() if name != TEACHERS}
    if not found:
        return ""
    name = max(found, key=lambda each: found[each])
    return texts("serve.short.who", name=name, taken=found[name] >> 20)

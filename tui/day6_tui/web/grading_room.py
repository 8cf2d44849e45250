"""Grades what was collected: each work in a cell of its own, kept apart like a desktop and, inside, by the shield of `grade`.

A program of a pupil's thus never runs as the server, sees no token and no other pupil's work, and what is said of it is not
believed before its shape was checked.
"""

from __future__ import annotations

import asyncio
import contextlib
import hashlib
import json
import math
import shutil
import sys
from collections.abc import Mapping, Sequence
from dataclasses import replace
from typing import Any

from day6_core.isolation.cell import Cell, Limits
from day6_core.isolation.mode import Mode
from day6_core.language import LANGUAGES
from day6_core.lessons.grading import scenarios
from day6_core.lessons.grading.scenarios import Grading
from day6_core.lessons.lag import cores
from day6_core.session.harmless import one_line
from day6_tui.web import starting
from day6_tui.web.in_time import in_time
from day6_tui.web.places import Places

APART = "day6_core.lessons.grading.apart"
LARGEST_REPORT = 2_000_000
PATIENCE = 60.0
"""Seconds beyond what the scenarios may take: twice, as what a busy machine held up is played again."""
MOST_SCENARIOS, MOST_CHECKS, LONGEST = 100, 30, 400
"""Of a report are kept, and characters of a text in it."""
MARKS = ("right", "wrong", "late", "unplayed")


class NotGraded(Exception):
    """There is no report; the message says why."""


class GradingRoom:
    """Plays hidden scenarios, a few works at a time: the lesson goes on beside it."""

    def __init__(self, mode: Mode, places: Places, limits: Limits) -> None:
        self._mode = mode
        self._places = places
        self._limits = replace(limits, cpu_weight=max(1, limits.cpu_weight // 4))
        self._room = asyncio.Semaphore(max(1, cores() // 2))

    async def grade(
        self, key: str, packed: bytes, gradings: Sequence[Grading], answers: Mapping[str, Mapping[str, str]], seed: str
    ) -> dict[str, Any]:
        """Return the report on a packed work; `key` tells it from others. Raises NotGraded, IsolationError, OSError."""
        async with self._room:
            cell = await asyncio.to_thread(self._cell, key)
            try:
                return await self._play(cell, packed, gradings, answers, seed)
            finally:
                await asyncio.shield(asyncio.to_thread(self._clear, cell))

    def sweep(self) -> None:
        """Leave nothing of what a killed server was grading. It blocks. Raises IsolationError, OSError."""
        for folder in self._places.grading.iterdir():
            self._clear(self._named(folder.name))

    def _cell(self, key: str) -> Cell:
        """Raises IsolationError, OSError."""
        cell = self._named(
            f"g{hashlib.sha256(key.encode(errors='replace')).hexdigest()[:6]}"
        )  # short: its folder holds sockets
        self._clear(cell)
        self._mode.prepare(cell)
        return cell

    def _named(self, name: str) -> Cell:
        homes = self._places.grading
        return Cell(
            name=name,
            home=homes / name,
            runtime=self._places.runtimes / name,
            uid=self._mode.uid_of(name, homes),
            limits=self._limits,
            hidden=self._places.hidden,
        )

    def _clear(self, cell: Cell) -> None:
        self._mode.end(cell)
        for folder in (cell.home, cell.runtime):
            shutil.rmtree(folder, ignore_errors=True)

    async def _play(
        self, cell: Cell, packed: bytes, gradings: Sequence[Grading], answers: Mapping[str, Any], seed: str
    ) -> dict[str, Any]:
        job = {"size": len(packed), "seed": seed, "gradings": [str(each.path) for each in gradings], "answers": answers}
        program = self._mode.command(cell, [sys.executable, "-I", "-m", APART])
        process = await asyncio.create_subprocess_exec(
            *program, stdin=asyncio.subprocess.PIPE, stdout=asyncio.subprocess.PIPE, stderr=asyncio.subprocess.DEVNULL,
            env=starting.environment(0), cwd="/", start_new_session=True,
        )  # fmt: skip
        seconds = 2 * scenarios.longest(gradings) + PATIENCE
        try:
            said = await in_time(_answer(process, json.dumps(job).encode() + b"\n" + packed), seconds)
            await in_time(process.wait(), PATIENCE)
        except asyncio.TimeoutError:
            raise NotGraded(f"> {seconds:g} s") from None
        finally:
            if process.returncode is None:
                process.kill()
                await process.wait()
        return report_of(said)


async def _answer(process: asyncio.subprocess.Process, told: bytes) -> bytes:
    assert process.stdin is not None and process.stdout is not None
    with contextlib.suppress(ConnectionError):  # it has ended: what it said tells
        process.stdin.write(told)
        await process.stdin.drain()
        process.stdin.close()
    said = bytearray()
    while (piece := await process.stdout.read(1 << 16)) and len(said) <= LARGEST_REPORT:
        said += piece
    return bytes(said)


# -- what comes back, as far as it makes sense -------------------------------------------------------------------------


def report_of(said: bytes) -> dict[str, Any]:
    """Raises NotGraded."""
    try:
        found = json.loads(said) if len(said) <= LARGEST_REPORT else None
        if not isinstance(found, dict):
            raise NotGraded("?")
        rows = [_scenario(each) for each in list(found["scenarios"])[:MOST_SCENARIOS]]
        return {
            "points": round(sum(each["points"] for each in rows), 2), "most": sum(each["most"] for each in rows),
            "unplayed": sum(each["mark"] == "unplayed" for each in rows), "scenarios": rows,
            "refused": None if found["refused"] is None else _texts(found["refused"]),
            "shielded": found["shielded"] is True, "problem": _line(found["problem"]),
        }  # fmt: skip
    except (ValueError, TypeError, KeyError, AttributeError, RecursionError) as error:
        raise NotGraded(type(error).__name__) from None


def _scenario(found: Mapping[str, Any]) -> dict[str, Any]:
    if found["mark"] not in MARKS:
        raise ValueError(found["mark"])
    most = _number(found["most"], 1000)
    return {
        "lesson": _line(found["lesson"]), "scenario": _line(found["scenario"]), "title": _texts(found["title"]),
        "mark": found["mark"], "points": _number(found["points"], most), "most": most,
        "checks": [_check(each) for each in list(found["checks"])[:MOST_CHECKS]],
    }  # fmt: skip


def _check(found: Mapping[str, Any]) -> dict[str, Any]:
    return {"ok": found["ok"] is True, **{what: _texts(found[what]) for what in ("asked", "seen", "where")}}


def _number(value: float, most: float) -> float:
    if isinstance(value, bool) or not math.isfinite(value) or not 0 <= value <= most:
        raise ValueError(value)
    return value


def _texts(found: Mapping[str, Any]) -> dict[str, str]:
    return {language: _line(found[language]) for language in LANGUAGES}


def _line(value: str) -> str:
    if not isinstance(value, str):
        raise TypeError
    return one_line(value[:LONGEST])

"""Measures how soon keys are answered while others drive: tabs of a real `day6-tui serve`, each of 120x40. One table.

    python -m tests.perf.keys [--pupils 1 8 16 30] [--echoes N] [--pixels] [--busy LOOPS] [--lone SECONDS]

One pupil types, the others drive their turtle (ten commands a second) or let it stand. Milliseconds, median and the worst but one
in twenty, from the key to
- the echo of a letter at a prompt, while all others stand, and while all drive: `stands`;
- the same beside a turtle of the pupil's own that is driven, too: `drives`;
- the first change in TurtleSim after an arrow in teleop: `steers`.

Only ratios within one run compare: between a row's columns, and of the same row before and after a change. The tabs are one
process, which goes first where that is allowed, because real browsers are on other machines. With --pixels the tabs show real
pixels, as those of a browser do; --busy adds programs that compute without end, as a busy machine has them. At last the lone
desktop: frames a second and CPU while its turtle drives. Linux only.
"""

from __future__ import annotations

import argparse
import asyncio
import contextlib
import os
import statistics
import sys
import tempfile
import time
from pathlib import Path

import aiohttp

from tests.perf.bench import BOTH_ANSWER, PIXEL_ANSWERS
from tests.perf.load import PUBLISH, TURTLE
from tests.perf.runs import loops
from tests.perf.served import WORD, Server

DRIVE = PUBLISH + " &\n"
TELEOP = "ros2 run turtlesim turtle_teleop_key\n"
LETTERS = b"zqwj"
"""Letters that nothing on the screen shows by itself."""
ARROWS = b"\x1b[A", b"\x1b[B"
ANYTHING = b"\x1b["
"""What is drawn when a turtle moves that stood: teleop echoes nothing."""
MOST_SECONDS = 10.0
ACK_BYTES = 32 << 10


class Tab:
    """A pupil's tab: acknowledges as our page does, and answers what a terminal is asked."""

    def __init__(self, server: Server, name: str, pixels: bool) -> None:
        self._server, self._name, self._pixels = server, name, pixels
        self.output = bytearray()
        self.received = self.frames = 0
        self._came = asyncio.Event()

    async def open(self) -> None:
        """Enter the class, and wait for the whole screen."""
        base = self._server.base
        self._session = aiohttp.ClientSession(cookie_jar=aiohttp.CookieJar(unsafe=True))
        headers = {"Origin": base[:-1]}
        async with self._session.post(
            f"{base}enter", data={"word": WORD, "name": self._name}, headers=headers
        ) as answer:
            answer.raise_for_status()
        size = "&w=1200&h=800" if self._pixels else ""
        self._ws = await self._session.ws_connect(f"{base}ws?cols=120&rows=40{size}", headers=headers)
        self._reading = asyncio.create_task(self._read())
        while len(self.output) < 1500:
            await asyncio.wait_for(self._came.wait(), 120)
            self._came.clear()

    async def _read(self) -> None:
        acknowledged = 0
        async for message in self._ws:
            if message.type != aiohttp.WSMsgType.BINARY:
                continue
            self.output += message.data
            self.received += len(message.data)
            self.frames += 1
            self._came.set()
            if self._pixels:
                await self._answer(message.data)
            if self.received - acknowledged >= ACK_BYTES:
                acknowledged = self.received
                await self._ws.send_json({"t": "ack", "bytes": acknowledged})

    async def _answer(self, data: bytes) -> None:
        questions = {**BOTH_ANSWER, **PIXEL_ANSWERS["sixel"]}
        asked = sorted((data.find(each), reply) for each, reply in questions.items() if each in data)
        if asked:
            await self.type(b"".join(reply for _, reply in asked))

    async def type(self, keys: bytes) -> None:
        """Press keys."""
        await self._ws.send_bytes(keys)

    async def answer_to(self, key: bytes, sign: bytes) -> float:
        """Press a key; the milliseconds until the sign has come."""
        self.output.clear()
        began = time.perf_counter()
        await self.type(key)
        while sign not in self.output:
            left = began + MOST_SECONDS - time.perf_counter()
            if left <= 0:
                break
            self._came.clear()
            with contextlib.suppress(asyncio.TimeoutError):
                await asyncio.wait_for(self._came.wait(), left)
        return 1000 * (time.perf_counter() - began)

    async def close(self) -> None:
        """Close the tab; the desktop stays."""
        await self._ws.close()
        await self._session.close()


def told(times: list[float]) -> str:
    """Median and the worst but one in twenty."""
    return f"{statistics.median(times):.0f} / {statistics.quantiles(times, n=20, method='inclusive')[-1]:.0f}"


async def echoes(tab: Tab, count: int) -> str:
    """Type letters at the prompt."""
    times = []
    for number in range(count):
        letter = LETTERS[number % len(LETTERS) :][:1]
        times.append(await tab.answer_to(letter, letter))
        await asyncio.sleep(0.15)
        if number % 40 == 39:
            await tab.type(b"\x15")  # Ctrl-U
            await asyncio.sleep(0.5)
    await tab.type(b"\x15")
    return told(times)


async def steers(tab: Tab, count: int) -> str:
    """Press an arrow in teleop while the turtle stands."""
    times = []
    for number in range(count):
        await asyncio.sleep(1.3)  # it runs for a second
        for _ in range(40):
            quiet = tab.received
            await asyncio.sleep(0.25)
            if quiet == tab.received:
                break
        times.append(await tab.answer_to(ARROWS[number % 2], ANYTHING))
    return told(times)


def cpu_seconds(server: Server) -> dict[str, float]:
    """What each kind of process below the data folder has used, and the server."""
    used = {"keepers": 0.0, "desktops": 0.0, "server": server.cpu_seconds()}
    for folder in Path("/proc").iterdir():
        with contextlib.suppress(OSError):
            if folder.name.isdecimal():
                words = (folder / "cmdline").read_bytes()
                if os.fsencode(server.homes) in words:
                    kind = "keepers" if b"keeper" in words else "desktops"
                    used[kind] += sum(
                        int((task / "schedstat").read_text(encoding="ascii").split()[0]) / 1e9
                        for task in (folder / "task").iterdir()
                    )
    return used


async def usage(server: Server, tabs: list[Tab], seconds: float) -> str:
    """CPU of all, and frames and bytes of one, in words."""
    before, frames, received = cpu_seconds(server), sum(t.frames for t in tabs), sum(t.received for t in tabs)
    began = time.perf_counter()
    await asyncio.sleep(seconds)
    took = time.perf_counter() - began
    parts = [f"{kind} {100 * (now - before[kind]) / took:.1f} %" for kind, now in cpu_seconds(server).items()]
    each = took * len(tabs)
    rate = (sum(tab.frames for tab in tabs) - frames) / each
    flow = (sum(tab.received for tab in tabs) - received) / each
    return f"{', '.join(parts)}; a tab {rate:.1f} frames, {flow:.0f} bytes a second"


async def a_class(count: int, options: argparse.Namespace) -> list[str]:
    """Measure so many pupils; the cells of the row."""
    server = await asyncio.to_thread(Server, Path(tempfile.mkdtemp(prefix="day6-keys-")))
    tabs = [Tab(server, f"pupil{number}", options.pixels) for number in range(1, count + 1)]
    notes = []
    try:
        for first in range(0, count, 4):
            await asyncio.gather(*(tab.open() for tab in tabs[first : first + 4]))
        typist, others = tabs[0], tabs[1:]
        for tab in tabs:
            await tab.type(TURTLE.encode())
        await asyncio.sleep(4 + count / 4)
        cells = [str(count), await echoes(typist, options.echoes)]
        if not others:
            notes.append(await usage(server, tabs, options.lone / 2))
        for tab in others:
            await tab.type(DRIVE.encode())
        await asyncio.sleep(4 + count / 4)
        cells.append(await echoes(typist, options.echoes) if others else "-")
        if others:
            notes.append(await usage(server, others, options.lone))
        await typist.type(DRIVE.encode())
        await asyncio.sleep(4)
        if not others:
            notes.append(await usage(server, tabs, options.lone))
        cells.append(await echoes(typist, options.echoes))
        await typist.type(b"kill %2\n")
        await asyncio.sleep(3)
        await typist.type(TELEOP.encode())
        await asyncio.sleep(4 + count / 8)
        cells.append(await steers(typist, options.echoes // 2))
        cells.append(f"{os.getloadavg()[0]:.1f}")
        if options.stay:
            await asyncio.sleep(options.stay)
        for tab in tabs:
            await tab.close()
    finally:
        await asyncio.to_thread(server.close)
    return [*cells, " · ".join(notes)]


HEADS = ("pupils", "all stand", "stands", "drives", "steers", "load", "use")


def go_first() -> None:
    """The tabs stand for browsers on other machines: they shall not wait for what they measure."""
    with contextlib.suppress(OSError):
        os.setsid()
    with contextlib.suppress(OSError):
        Path("/proc/self/autogroup").write_text("-15", encoding="ascii")


def main() -> int:
    """Print the table."""
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--pupils", type=int, nargs="+", default=[1, 8, 16, 30], metavar="N")
    parser.add_argument("--echoes", type=int, default=40)
    parser.add_argument("--pixels", action="store_true")
    parser.add_argument("--busy", type=int, default=0, metavar="LOOPS")
    parser.add_argument("--lone", type=float, default=8.0, metavar="SECONDS")
    parser.add_argument("--stay", type=float, default=0.0, metavar="SECONDS", help="wait at the end, for py-spy")
    options = parser.parse_args()
    go_first()
    print(f"{os.cpu_count()} cores, load {os.getloadavg()[0]:.1f} at the beginning, {options.busy} loops beside\n")
    print(f"| {' | '.join(HEADS)} |\n|{' --- |' * len(HEADS)}", flush=True)
    with loops(options.busy):
        for count in options.pupils:
            print(f"| {' | '.join(asyncio.run(a_class(count, options)))} |", flush=True)
    return 0


if __name__ == "__main__":
    sys.exit(main())

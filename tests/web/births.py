"""A desktop that is started singly and one that is forked: `main` prints what the system says of both."""

from __future__ import annotations

import json
import os
import select
import sys
import time
from collections.abc import Mapping, Sequence
from contextlib import suppress
from pathlib import Path
from typing import TYPE_CHECKING, Any

from day6_core.isolation import modes
from day6_core.isolation.cell import Cell
from day6_core.isolation.mode import Mode
from day6_tui.detached import view, wire
from day6_tui.web import nursery as nursery_module
from day6_tui.web import starting
from day6_tui.web.nursery import Nursery

assert not TYPE_CHECKING or sys.platform == "linux"

STATUS = (
    "Uid",
    "Gid",
    "Groups",
    "NoNewPrivs",
    "CapInh",
    "CapPrm",
    "CapEff",
    "CapBnd",
    "CapAmb",
    "Umask",
    "SigIgn",
    "SigCgt",
)
PATIENCE = 120.0
SECRET = "x31337"
environment = starting.environment


def kept(place: Path) -> set[tuple[str, str]]:
    """What descriptors are open all the time, with what they stand for: a desktop opens one for a moment now and then."""
    looks: list[set[tuple[str, str]]] = []
    for _ in range(10):
        looks.append(set())
        for number in os.listdir(place):
            with suppress(FileNotFoundError):
                looks[-1].add((number, os.readlink(place / number)))
        time.sleep(0.05)  # the moment is longer if it is not its turn just then
    return set.intersection(*looks)


def facts(pid: int) -> dict[str, Any]:
    """What the system shows of a process; a program's own numbers are left out."""
    place = Path("/proc", str(pid))
    status = dict(line.split(":\t", 1) for line in (place / "status").read_text().splitlines() if ":\t" in line)
    kinds = [
        target if target.startswith("/dev/null") else target.partition(":")[0].partition("/pts/")[0]
        for _, target in kept(place / "fd")
    ]
    return {
        "words": (place / "cmdline").read_bytes().rstrip(b"\0").decode().split("\0"),
        "knows a secret": SECRET.encode() in (place / "environ").read_bytes(),
        "owner": place.stat().st_uid,
        "folder": os.readlink(place / "cwd"),
        "nice": os.getpriority(os.PRIO_PROCESS, pid),
        "limits": (place / "limits").read_text(),
        "groups": (place / "cgroup").read_text(),
        "session leader": os.getsid(pid) == pid,
        "descriptors": sorted(kinds),
    } | {name: status[name] for name in STATUS if name in status}


def one(mode: Mode, top: Path, nursery: Nursery | None) -> list[dict[str, Any]]:
    """Start anna's desktop, look at its processes when it shows a prompt, and end it."""
    homes = top / "homes"
    cell = Cell("anna", homes / "anna", top / "run" / "anna", mode.uid_of("anna", homes))
    keepers = top / "keepers"
    mode.prepare(cell)
    (cell.home / "random.py").write_text("raise SystemExit(1)")  # of the pupil's, and no module of the desktop's
    line = wire.Connection(starting.start(mode, cell, keepers, 3, ["--lang", "en"], nursery))
    line.send(wire.HELLO, view.hello([24, 80, 0, 0]))
    output = b""

    def wait_for(wanted: bytes) -> None:
        nonlocal output
        until = time.monotonic() + PATIENCE
        while wanted not in output:
            if line.closed or time.monotonic() > until:
                raise TimeoutError(output)
            select.select([line], [], [], 1)
            output += b"".join(data for kind, data in line.receive() if kind == wire.OUTPUT)

    wait_for(b"anna@day6")
    found = sorted((facts(pid) for pid in mode.processes(cell)), key=lambda each: each["words"])  # numbers start over
    line.send(wire.INPUT, f"cat {top}/secret; echo tried-$((1+1))\r".encode())
    wait_for(b"tried-2")
    found.append({"reads the server's files": SECRET.encode() in output})
    line.close()
    if not starting.stop(mode, cell, keepers) or mode.processes(cell):
        raise RuntimeError("something is left of the cell")
    return found


def without_a_link(domain: int) -> dict[str, str]:
    """What a desktop sees of the world, and no link: it opens some time after the prompt, with descriptors of its own."""
    return {**environment(domain), "DAY6_LINK": "off"}


class Counting(Nursery):
    """Knows whether desktops were forked."""

    born: list[bool]

    def bear(self, order: Mapping[str, Any], descriptors: Sequence[int]) -> bool:
        self.born = [*getattr(self, "born", []), super().bear(order, descriptors)]
        return self.born[-1]


def main() -> None:
    """Print it, or why this machine does not have the mode."""
    name, top = sys.argv[1], Path(sys.argv[2])
    (offer,) = modes.survey((name,))
    if offer.mode is None:
        print(json.dumps(str(offer.reason)))
        return
    for part, rights in (("homes", 0o711), ("run", 0o711), ("keepers", 0o700)):
        (top / part).mkdir()
        (top / part).chmod(rights)
    (top / "secret").write_text(SECRET)
    (top / "secret").chmod(0o600)
    starting.environment = without_a_link
    nursery_module.BEAR_SECONDS = PATIENCE  # the first one waits for all imports
    nursery = Counting(starting.environment(0))
    found = {"started": one(offer.mode, top, None), "forked": one(offer.mode, top, nursery)}
    nursery.close()
    assert nursery.born == [True], "it was not forked"
    print(json.dumps(found))

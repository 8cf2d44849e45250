"""What the console shows: the messages of /rosout, and which of them are left out or stand out.

The window runs on another thread: it reads, changes what is shown, and requests what has to do with files.
"""

from __future__ import annotations

import time
from collections.abc import Callable, Iterable, Sequence
from dataclasses import dataclass, replace
from pathlib import Path
from typing import Any

from day6_core.ros.programs.rqt_console.filters import Filter, FilterChoice
from day6_core.ros.programs.rqt_py_common.requests import Requests
from day6_core.whole_file import replace_file

MOST = 20_000
"""Messages that are kept (rqt_console's own limit)."""

SLICE, SLICE_SECONDS = 100, 0.05
"""Messages that are looked at together, and after how much time the rest has to wait: for some regular expressions."""

SEVERITIES: dict[int, str] = {10: "Debug", 20: "Info", 30: "Warn", 40: "Error", 50: "Fatal"}
"""rcl_interfaces/msg/Log, in the words of rqt_console's table."""


@dataclass(frozen=True, slots=True)
class Record:
    """One message. `stamp_ns` is the node's time, nanoseconds since 1970; `location` is file:function:line."""

    number: int
    text: str
    level: int
    node: str
    stamp_ns: int
    location: str

    @property
    def severity(self) -> str:
        """The word for the level."""
        return SEVERITIES.get(self.level, str(self.level))


class Console(Requests):
    """The model. The window reads `shown()` and calls the methods of its side; the program calls `receive`."""

    def __init__(self, path_of: Callable[[str], Path] = Path) -> None:
        super().__init__()
        self._path_of = path_of
        self._records: list[Record] = []
        self._count = 0
        self.paused = False
        self.choice = FilterChoice()
        self.version = 0
        """Grows with everything that changes the picture."""
        self.message = ""
        """What became of the last file."""
        self.on_load: Callable[[Path], object] | None = None
        """Called with a file whose messages are to be shown."""
        self._seen: tuple[FilterChoice, list[Record], int, list[Record]] = (self.choice, self._records, 0, [])

    # -- the program's side --------------------------------------------------------------------------------------------

    def receive(self, log: Any) -> None:
        """Store a rcl_interfaces/msg/Log, unless paused."""
        if self.paused:
            return
        stamp = log.stamp.sec * 1_000_000_000 + log.stamp.nanosec
        place = ":".join(part for part in (log.file, log.function, str(log.line) if log.line else "") if part)
        self._keep(Record(self._count + 1, log.msg, log.level, log.name, stamp, place))
        self.version += 1

    def take_loaded(self, records: Iterable[Record]) -> None:
        """Show messages of a file behind those that are here, and pause, as rqt_console does."""
        for each in records:
            self._keep(replace(each, number=self._count + 1))
        self.paused = True
        self.version += 1

    def tell(self, message: str) -> None:
        """Show what became of a file."""
        self.message = message
        self.version += 1

    def _keep(self, record: Record) -> None:
        self._count = record.number
        if len(self._records) >= 2 * MOST:
            # A new list, because the window may be going through the old one.
            self._records = self._records[-MOST:]
        self._records.append(record)

    # -- the window's side ---------------------------------------------------------------------------------------------

    @property
    def total(self) -> int:
        """How many messages are kept, those left out included."""
        return min(len(self._records), MOST)

    def shown(self) -> Sequence[Record]:
        """The messages that are not left out, oldest first; while `is_behind`, as many as have been looked at."""
        records, choice = self._records, self.choice
        count = len(records)
        before, source, done, found = self._seen
        if before is not choice or source is not records:
            done, found = max(0, count - MOST), []
        end = time.perf_counter() + SLICE_SECONDS
        while done < count:
            found.extend(record for record in records[done : min(count, done + SLICE)] if choice.shows(record))
            done = min(count, done + SLICE)
            if time.perf_counter() > end:
                break
        self._seen = (choice, records, done, found)
        return found if len(found) <= MOST else found[-MOST:]

    @property
    def is_behind(self) -> bool:
        """Whether `shown` has not looked at all messages yet."""
        choice, records, done, _ = self._seen
        return choice is not self.choice or records is not self._records or done < len(records)

    def nodes(self) -> set[str]:
        """The names of the nodes of all messages."""
        return {record.node for record in list(self._records)}

    def set_filter(self, side: str, at: int, each: Filter | None) -> None:
        """Put a filter in this place of the excluding or highlighting ones; None takes away the one that is there."""
        self._choose(self.choice.with_filter(side, at, each))

    def toggle_level(self, level: int) -> None:
        """Leave out a severity, or show it again."""
        self._change("excludes", "severity", levels=self.choice.first("excludes", "severity").levels ^ {level})

    def toggle_node(self, node: str) -> None:
        """Leave out the messages of a node, or show them again."""
        self._change("excludes", "node", nodes=self.choice.first("excludes", "node").nodes ^ {node})

    def _change(self, side: str, kind: str, **changes: Any) -> None:
        """Change the first filter of a kind, which is added if there is none."""
        at = self.choice.place_of(side, kind)
        self.set_filter(side, at, replace(self.choice.first(side, kind), enabled=True, **changes))

    def show_highlighted_only(self, only: bool) -> None:
        """Leave out all that does not stand out, or no longer."""
        self._choose(replace(self.choice, only_highlighted=only))

    def show_everything(self) -> None:
        """Leave nothing out."""
        self._choose(FilterChoice(highlights=self.choice.highlights))

    def _choose(self, choice: FilterChoice) -> None:
        self.choice = choice
        self.version += 1

    def toggle_paused(self) -> None:
        """Pause or resume; messages received while paused are not kept, as in rqt_console."""
        self.paused = not self.paused
        self.version += 1

    def clear(self) -> None:
        """Forget all messages."""
        self._records = []
        self.version += 1

    def path(self, name: str) -> Path:
        """The file that a user of this program means; without an ending it gets that of such files."""
        path = self._path_of(name.strip())
        return path if path.suffix else path.with_name(f"{path.name}.csv")

    def save(self, name: str, records: Iterable[Record]) -> Path:
        """Write messages to a file. Raises OSError."""
        from day6_core.ros.programs.rqt_console.files import written

        path = self.path(name)
        replace_file(path, written(records).encode("utf-8", "surrogateescape"))
        return path

    def load(self, name: str) -> None:
        """Show the messages of a file."""
        if self.on_load is not None:
            path, on_load = self.path(name), self.on_load
            self.post(lambda: on_load(path))

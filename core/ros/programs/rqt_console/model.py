"""What the console shows: the messages of /rosout, and which of them are left out or stand out."""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass, field, replace
from typing import Any

MOST = 20_000
"""Messages that are kept (rqt_console's own limit)."""

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


@dataclass(frozen=True)
class Choice:
    """What is left out (levels, texts in the message, nodes), and what stands out. Texts are found anywhere, in any case."""

    levels: frozenset[int] = field(default_factory=frozenset)
    text: str = ""
    nodes: frozenset[str] = field(default_factory=frozenset)
    highlight: str = ""

    def shows(self, record: Record) -> bool:
        """Whether a message is not left out."""
        if record.level in self.levels or record.node in self.nodes:
            return False
        return not self.text or self.text.casefold() not in record.text.casefold()

    def highlights(self, record: Record) -> bool:
        """Whether a message is highlighted."""
        return bool(self.highlight) and self.highlight.casefold() in record.text.casefold()


class Console:
    """The model. The window reads `shown()` and calls the methods of its side; the program calls `receive`."""

    def __init__(self) -> None:
        self._records: list[Record] = []
        self._count = 0
        self.paused = False
        self.choice = Choice()
        self.version = 0
        """Grows with everything that changes the picture."""
        self._seen: tuple[Choice, list[Record], int, list[Record]] = (self.choice, self._records, 0, [])

    # -- the program's side --------------------------------------------------------------------------------------------

    def receive(self, log: Any) -> None:
        """Store a rcl_interfaces/msg/Log, unless paused."""
        if self.paused:
            return
        self._count += 1
        stamp = log.stamp.sec * 1_000_000_000 + log.stamp.nanosec
        place = ":".join(part for part in (log.file, log.function, str(log.line) if log.line else "") if part)
        record = Record(self._count, log.msg, log.level, log.name, stamp, place)
        if len(self._records) >= 2 * MOST:
            # A new list, because the window may be going through the old one.
            self._records = self._records[-MOST:]
        self._records.append(record)
        self.version += 1

    # -- the window's side ---------------------------------------------------------------------------------------------

    @property
    def total(self) -> int:
        """How many messages are kept, those left out included."""
        return min(len(self._records), MOST)

    def shown(self) -> Sequence[Record]:
        """The messages that are not left out, oldest first."""
        records, choice = self._records, self.choice
        count = len(records)
        before, source, done, found = self._seen
        if before is not choice or source is not records:
            done, found = max(0, count - MOST), []
        found.extend(record for record in records[done:count] if choice.shows(record))
        self._seen = (choice, records, count, found)
        return found if len(found) <= MOST else found[-MOST:]

    def toggle_level(self, level: int) -> None:
        """Leave out a severity, or show it again."""
        self._choose(levels=self.choice.levels ^ {level})

    def exclude_text(self, text: str) -> None:
        """Leave out messages that contain a text; '' shows them again."""
        self._choose(text=text)

    def toggle_node(self, node: str) -> None:
        """Leave out the messages of a node, or show them again."""
        self._choose(nodes=self.choice.nodes ^ {node})

    def highlight(self, text: str) -> None:
        """Let messages that contain a text stand out; '' none."""
        self._choose(highlight=text)

    def show_everything(self) -> None:
        """Leave nothing out."""
        self.choice = Choice(highlight=self.choice.highlight)
        self.version += 1

    def _choose(self, **changes: Any) -> None:
        self.choice = replace(self.choice, **changes)
        self.version += 1

    def toggle_paused(self) -> None:
        """Pause or resume; messages received while paused are not kept, as in rqt_console."""
        self.paused = not self.paused
        self.version += 1

    def clear(self) -> None:
        """Forget all messages."""
        self._records = []
        self.version += 1

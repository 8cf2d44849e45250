"""A file that a teacher hands out to a class on a network: who has it, and why somebody has not.

Each pupil's desktop answers when it has written the file, which takes a while; a few are asked at a time, in threads.
"""

from __future__ import annotations

import threading
from collections.abc import Callable, Sequence
from functools import partial
from queue import Empty, SimpleQueue

from day6_core.classroom import handed
from day6_core.classroom.handed import Answer
from day6_core.classroom.order import Order
from day6_core.classroom.roster import Roster
from day6_core.link.classroom.teacher import Teacher

AT_ONCE = 4
"""Pupils to whom it is on its way."""

Soon = Callable[[Callable[[], object]], None]
"""Calls a function in the event loop, from any thread."""


class Handing:
    """The file, and how far it is. Everything but `asked` in the event loop."""

    def __init__(self, file: str, data: bytes, names: Sequence[str]) -> None:
        self.file = handed.clean_file_name(file)
        self.names = tuple(names)
        self.reached: list[str] = []
        self.failed: list[tuple[str, str]] = []
        """Names and reasons; '': there was no answer."""
        self._message = handed.message(self.file, data)

    def asked(self, part: Teacher, name: str) -> Answer:
        """Send it to a pupil and wait."""
        data = part.hand(name, self._message)
        try:
            return Answer() if data is None else handed.read_answer(data)
        except ValueError:
            return Answer()

    def answered(self, roster: Roster, name: str, answer: Answer) -> None:
        """A pupil's desktop has it, and is told so; or it has not."""
        if answer.path:
            self.reached.append(name)
            roster.order([name], Order("file", text=answer.path))
        else:
            self.failed.append((name, answer.why))


def hand(part: Teacher, roster: Roster, handing: Handing, soon: Soon, changed: Callable[[Handing], None]) -> None:
    """Begin to hand out; `changed` is called after each answer."""
    waiting: SimpleQueue[str] = SimpleQueue()
    for name in handing.names:
        waiting.put(name)

    def take(name: str, answer: Answer) -> None:
        handing.answered(roster, name, answer)
        changed(handing)

    def work() -> None:
        while True:
            try:
                name = waiting.get_nowait()
            except Empty:
                return
            soon(partial(take, name, handing.asked(part, name)))

    for _ in range(min(AT_ONCE, len(handing.names))):
        threading.Thread(target=work, name="day6-class-file", daemon=True).start()

"""Sessions of our engine in one process, which have only each other."""

from __future__ import annotations

import sys
from pathlib import Path
from typing import Any

from day6_core.link.local import Config, CongestionControl, Session, handlers
from day6_core.link.paths import MeetingPlace

KEY = "0/chatter/std_msgs::msg::dds_::String_/RIHS01_0"


class Sessions:
    """Each has a session id of its own: 'a', 'b', …."""

    def __init__(self, folder: Path, *, tcp: bool = sys.platform == "win32") -> None:
        folder.mkdir(mode=0o700, exist_ok=True)
        self.place = MeetingPlace(folder, tcp)
        self.made: list[Session] = []

    def one(self, zid: str = "") -> Session:
        self.made.append(Session(Config(self.place, zid or "abcdefgh"[len(self.made)])))
        return self.made[-1]

    def close(self) -> None:
        for each in self.made:
            each.close()


class Heard(list[Any]):
    """What a handler was called with."""

    def __init__(self) -> None:
        self.ended = False
        self.handler = handlers.Callback(self.append, self._end, indirect=False)

    def _end(self) -> None:
        self.ended = True

    @property
    def texts(self) -> list[bytes]:
        return [each.payload.to_bytes() for each in self]

    @property
    def tokens(self) -> list[tuple[str, str]]:
        return [(each.key_expr, each.kind.value) for each in self]


def publisher(session: Session, *, waits: bool = True, keeps: int = 0) -> Any:
    control = CongestionControl.BLOCK if waits else CongestionControl.DROP
    return session.declare_publisher(KEY, congestion_control=control, keeps=keeps)

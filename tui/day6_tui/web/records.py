"""Which desktops run: a file by which the server finds them again after it was killed."""

from __future__ import annotations

import json
from dataclasses import asdict, dataclass
from pathlib import Path

from day6_core.whole_file import write_private

_VERSION = 1


@dataclass(frozen=True)
class Record:
    """A desktop that was started."""

    name: str
    mode: str
    """How its pupil is kept apart: only that mode can end everything of it."""
    domain: int
    """Its ROS_DOMAIN_ID."""


def read(path: Path) -> list[Record]:
    """The desktops of the file; none if there is no file. Raises ValueError if it is not ours, OSError."""
    try:
        found = json.loads(path.read_bytes())
        return [Record(str(each["name"]), str(each["mode"]), int(each["domain"])) for each in found["sessions"]]
    except FileNotFoundError:
        return []
    except (ValueError, TypeError, KeyError):
        raise ValueError(str(path)) from None


def write(path: Path, records: list[Record]) -> None:
    """Write the file whole. Raises OSError."""
    text = json.dumps(
        {"version": _VERSION, "sessions": [asdict(each) for each in records]}, ensure_ascii=False, indent=1
    )
    write_private(path, text.encode())

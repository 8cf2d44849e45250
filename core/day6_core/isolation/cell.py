"""What one pupil gets of the machine: two folders, perhaps a Unix user, and limits."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path


@dataclass(frozen=True)
class Limits:
    """What a pupil may take at most. Who enforces each of them depends on the machine: `Mode.enforces` names them."""

    memory: int = 1 << 30
    """Bytes of all the pupil's processes together where a control group counts them, else of each process."""
    processes: int = 256
    """Processes and threads together (a thread counts as a process in Linux)."""
    disk: int = 512 << 20
    """Bytes in the home folder: no file can become larger, and `Mode.used` tells the sum, which the server must look at."""
    open_files: int = 1024
    """Descriptors of each process."""
    cpu_weight: int = 100
    """The share of the processors when all want them: 1 to 10000, 100 is everyone's (as in systemd's CPUWeight)."""


@dataclass(frozen=True)
class Cell:
    """One pupil's place. The folders are absolute and resolved; each pupil's are siblings of the others'."""

    name: str
    home: Path
    runtime: Path
    """For sockets; see `day6_core/link/paths.py`."""
    uid: int | None = None
    """The pupil's Unix user, where the mode has one (`Mode.uid_of`)."""
    limits: Limits = field(default_factory=Limits)
    network: bool = False
    """Whether programs reach the network (pip). With bubblewrap, pupils then share the ports of 127.0.0.1."""
    hidden: tuple[Path, ...] = ()
    """Files and folders of the server that no pupil may read, if they lie where programs are read from (tokens)."""

    @property
    def mark(self) -> str:
        """One word by which the processes that hold this cell are found again, also after the server was killed."""
        return f"day6-cell={self.name}:{self.runtime}"


@dataclass(frozen=True)
class Used:
    """What a cell takes now; bytes."""

    memory: int
    processes: int
    disk: int


@dataclass(frozen=True)
class Phrase:
    """A text of the catalogues: its key and what fills its braces."""

    key: str
    values: dict[str, str] = field(default_factory=dict)


class IsolationError(Exception):
    """A cell cannot be prepared; `words` say why."""

    def __init__(self, key: str, **values: str) -> None:
        super().__init__(f"{key} {values}")
        self.words = Phrase(key, values)

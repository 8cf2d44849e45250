"""Where the files of a class are: a home for each pupil, what the server remembers, and short folders for sockets."""

from __future__ import annotations

import getpass
import os
import sys
from pathlib import Path
from zlib import crc32

from day6_core.classroom.homes import ASSIGNMENTS, BEFORE, HOMES, SERVER, folder_name, same_name
from day6_core.isolation.cell import Cell, Limits
from day6_core.isolation.mode import Mode
from day6_core.isolation.modes import NAMES
from day6_core.link.kept_files import mark_as_used
from day6_core.link.paths import base_folders
from day6_core.places import default_home
from day6_core.whole_file import write_private
from day6_tui.web.names import TEACHERS

OPEN_TO_PASS = 0o711
"""Pupils that are Unix users of their own have to go through, and see no names."""

_ISOLATION = "isolation"
"""In the folder of the server: the name of the mode."""

_FOR_ALL_USERS = Path("/run/day6-tui")


def isolation_before(data: Path) -> str | None:
    """Return how the pupils of this folder were kept apart by the last server; None if there was none."""
    try:
        name = (data / SERVER / _ISOLATION).read_text(encoding="utf-8").strip()
    except (OSError, ValueError):
        return None
    return name if name in NAMES else None


def login_name() -> str:
    """Return the user's name, as JupyterHub knows it or this machine does."""
    try:
        return os.environ.get("JUPYTERHUB_USER") or getpass.getuser()
    except (KeyError, OSError):  # nobody's number, as in some containers
        return "student"


def own_home(given: Path | None) -> Path:
    """Return the folder that is ~ in the desktop of a user who is alone."""
    return (default_home() if given is None else given).expanduser().resolve()


class Places:
    """The folders of one class."""

    def __init__(self, data: Path, mode: Mode) -> None:
        self.data = data
        self.homes = data / HOMES
        self.server = data / SERVER
        """What the server remembers: tokens and sessions. No pupil's business."""
        self.log = self.server / "log"
        """What happened in the class, a file a day."""
        self.assignments = data / ASSIGNMENTS
        """What was handed out and collected. No pupil's business, either."""
        self.grading = data / "grading"
        """Where programs of pupils are graded: a home for each while that takes."""
        base = _FOR_ALL_USERS if mode.name == "users" and "DAY6_RUNTIME_DIR" not in os.environ else base_folders()[0]
        self._isolation = mode.name
        self._run = base.resolve() / f"c{crc32(os.fsencode(data)):08x}"
        self.runtimes = self._run / "p"
        """The runtime folders of the pupils."""
        self.keepers = self._run / "k"
        """Where the keepers are met; pupils cannot put anything there."""
        self.lock = self._run / "lock"
        """Held while the server runs, wherever its data is."""

    @property
    def hidden(self) -> tuple[Path, ...]:
        """What no pupil may read."""
        return (self.server, self.keepers, self.assignments, self.data / BEFORE)

    def make(self) -> None:
        """Create the folders. Raises OSError."""
        for folder in (self.data, self.homes, self.grading, self._run, self.runtimes):
            is_the_users = folder == self.data and folder.exists()
            folder.mkdir(mode=OPEN_TO_PASS, parents=True, exist_ok=True)
            if sys.platform != "win32" and not is_the_users:
                folder.chmod(OPEN_TO_PASS)
        for folder in self.hidden:
            folder.mkdir(mode=0o700, parents=True, exist_ok=True)
            if sys.platform != "win32":
                folder.chmod(0o700)

    def mark_as_used(self) -> None:
        """Keep the folders of sockets from cleaners: a pupil's program may not touch all of them, and the lock is ours."""
        mark_as_used(self._run.parent)
        for folder, _, names in os.walk(self._run):
            for name in (".", *names):
                mark_as_used(Path(folder, name))

    def own_cell(self, mode: Mode, limits: Limits, home: Path | None) -> Cell:
        """The cell of a user who is alone: the user's own runtime folder, so that all of the user's programs share a graph."""
        return Cell(
            name=login_name(),
            home=own_home(home),
            runtime=base_folders()[0].resolve(),
            limits=limits,
        )

    def remember(self) -> None:
        """Write down how pupils are kept apart. Raises OSError."""
        write_private(self.server / _ISOLATION, f"{self._isolation}\n".encode())

    def home(self, name: str) -> Path:
        """The home folder of a pupil."""
        return self.homes / (name if name == TEACHERS else folder_name(name))

    def cell(self, name: str, mode: Mode, limits: Limits, *, network: bool = False) -> Cell:
        """The cell of a pupil. Raises IsolationError."""
        home = self.home(name)
        return Cell(
            name=same_name(name),
            home=home,
            runtime=self.runtimes / f"{crc32(same_name(name).encode()):08x}",
            uid=mode.uid_of(home.name, self.homes),
            limits=limits,
            network=network,
            hidden=self.hidden,
        )

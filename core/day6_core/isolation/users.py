"""A Unix user for each pupil; the server must be root."""

from __future__ import annotations

import itertools
import os
import stat
import subprocess
import sys
import zlib
from collections.abc import Iterable, Sequence
from pathlib import Path
from typing import TYPE_CHECKING

from day6_core.isolation import enter, groups, left
from day6_core.isolation.cell import Cell, IsolationError
from day6_core.isolation.mode import Mode, key
from day6_core.system.control_groups import Tree
from day6_core.whole_file import replace_file

assert not TYPE_CHECKING or sys.platform == "linux"

FIRST_UID = 70000
"""The users have numbers and no entry in /etc/passwd: 65536–99999 is given to nobody by systemd, adduser or /etc/subuid."""
MOST_USERS = 9000
FOR_TRIALS = range(FIRST_UID + MOST_USERS, FIRST_UID + MOST_USERS + 1000)
"""Users whose processes nobody misses when a trial ends them."""
FOR_GRADING = range(FOR_TRIALS.stop, FOR_TRIALS.stop + 1000)
"""Users whose the programs of submissions are while root grades them."""

CLAIMS = Path("/run/day6-tui/uids")
"""A file for each number in use, with the home it is for; gone with a restart, after which the owners of the homes still tell."""


class Users(Mode):
    """Each pupil is a user of his own, as on any Unix machine with several people."""

    name = "users"
    _counts = frozenset({"processes"})  # RLIMIT_NPROC counts those of a user

    def __init__(self, trees: Iterable[Tree] = (), first_uid: int = FIRST_UID) -> None:
        super().__init__(trees)
        self._uids = range(first_uid, first_uid + MOST_USERS)

    def uid_of(self, name: str, homes: Path) -> int:
        """Return the owner of the pupil's home, or a number that no other home of this machine has.

        Raises IsolationError, OSError.
        """
        return self.claim(homes / name, self._uids)

    def claim(self, home: Path, uids: range) -> int:
        """Keep a number for this home. What holds it is a file in CLAIMS, as two servers may run on one machine.

        Raises IsolationError, OSError.
        """
        CLAIMS.mkdir(parents=True, exist_ok=True)
        owner = _owner(home)
        if owner in uids:
            if not _claim(owner, home):
                raise IsolationError("isolation.no.taken", folder=str(home), uid=str(owner))
            return owner
        first = zlib.crc32(os.fsencode(home)) % len(uids)
        home.mkdir(mode=0o700, parents=True, exist_ok=True)  # a claim is given on where the home is no more
        for uid in itertools.chain(uids[first:], uids[:first]):
            if _claim(uid, home):
                _give(home, uid)  # at once: it may be long before it is this desktop's turn
                return uid
        raise IsolationError("isolation.no.uids", first=str(uids[0]), last=str(uids[-1]))

    def closed_before(self, folders: Iterable[Path]) -> Path | None:
        """Return the first folder through which other users cannot get to one of these."""
        return next((closed for folder in folders if (closed := closed_above(folder)) is not None), None)

    def prepare(self, cell: Cell) -> None:
        """Make the folders, the pupil's alone, and the control groups. Raises IsolationError, OSError."""
        assert cell.uid is not None
        for folder in (cell.home, cell.runtime, self.temporary(cell)):
            _give(folder, cell.uid)
        if (closed := self.closed_before((cell.home, cell.runtime))) is not None:
            raise IsolationError("isolation.no.closed", folder=str(closed))
        self._make_groups(cell)

    def rlimits(self, cell: Cell) -> dict[str, int]:
        """Return the limits of each process, and of the number of the user's."""
        return {**super().rlimits(cell), "NPROC": cell.limits.processes}

    def plan(self, cell: Cell, descriptors: Iterable[int] = ()) -> enter.SandboxPlan:
        """Return how the launcher gives up the server's rights."""
        return enter.SandboxPlan(
            folder=str(cell.home),
            environment=self.environment(cell),
            uid=cell.uid,
            groups=self.group_files(cell),
            limits=self.rlimits(cell),
            scoped=True,
            descriptors=list(descriptors),
        )

    def processes_of(self, cells: Sequence[Cell]) -> list[list[int]]:
        """Return the ids of the processes of each user."""
        found = left.of_users([cell.uid for cell in cells if cell.uid is not None])
        return [[] if cell.uid is None else found[cell.uid] for cell in cells]

    def end(self, cell: Cell) -> bool:
        """Kill every process of the user; return whether nothing is left."""
        assert cell.uid is not None and (cell.uid in self._uids or cell.uid in FOR_TRIALS)
        gone = left.end_user(cell.uid)
        return groups.end(self.trees, key(cell)) and gone


def closed_above(path: Path) -> Path | None:
    """Return the first folder above `path` through which other users cannot go."""
    for folder in reversed(path.parents):
        try:
            if not folder.stat().st_mode & stat.S_IXOTH:
                return folder
        except OSError:
            return folder
    return None


def cannot_run_python(uid: int) -> Path | None:
    """Return the folder that keeps a user from our Python and this package; None if it starts."""
    program = "import day6_core.isolation.enter"
    try:
        subprocess.run(
            [sys.executable, "-I", "-c", program],
            user=uid,
            group=uid,
            extra_groups=[],
            cwd="/",
            stdin=subprocess.DEVNULL,
            capture_output=True,
            timeout=30,
            check=True,
        )
        return None
    except (OSError, subprocess.SubprocessError):
        pass
    places = (sys.executable, os.path.realpath(sys.executable), __file__)
    return next((closed for place in places if (closed := closed_above(Path(place))) is not None), Path(sys.prefix))


def _claim(uid: int, home: Path) -> bool:
    """Return whether this number is this home's now: it was, nobody's, or that of a home that is no more."""
    file = CLAIMS / str(uid)
    text = os.fsencode(home)
    try:
        with open(file, "xb") as made:
            made.write(text)
        return True
    except FileExistsError:
        pass
    holder = file.read_bytes()
    if holder != text and os.path.lexists(holder or "/"):
        return False
    replace_file(file, text, mode=0o600, sync=False)
    return True


def _owner(path: Path) -> int:
    try:
        return path.lstat().st_uid
    except OSError:
        return -1


def _give(folder: Path, uid: int) -> None:
    """Make a folder, the user's alone. One that exists must be his, or empty: nobody's files are given away."""
    folder.mkdir(mode=0o700, parents=True, exist_ok=True)
    number = os.open(folder, os.O_RDONLY | os.O_DIRECTORY | os.O_NOFOLLOW)
    try:
        found = os.fstat(number)
        if found.st_uid != uid:
            if os.listdir(number):
                raise IsolationError("isolation.no.owner", folder=str(folder), uid=str(uid))
            os.fchown(number, uid, uid)
        os.fchmod(number, 0o700)
    finally:
        os.close(number)

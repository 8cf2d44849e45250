"""Where the processes of one user, one machine and one ROS domain meet: a folder nobody else may enter.

    <base>/<domain>/meet                 socket of the meeting point
    <base>/<domain>/meeting.lock         held by the process that runs the meeting point
    <base>/<domain>/p-<zid>-<pid>        socket of one process (with TCP sockets: an empty marker file)
    <base>/local/<domain>/…              the same of those that use our own engine: they have no meeting point

`base` is DAY6_RUNTIME_DIR, or else the first of these that nobody else can have prepared: `day6` in XDG_RUNTIME_DIR,
/tmp/day6-<uid>, ~/.cache/day6-tui/run. Without Unix sockets (Windows, or DAY6_LINK=tcp) everything is on 127.0.0.1, and a
user name and password from a file of mode 0600 keep others out. They also keep our processes away from a program that takes
the port of a dead holder: Zenoh connects to nobody that does not ask for the password (which itself is never sent). Only a
modified Zenoh that asks for it and accepts any reply could get in there; Unix sockets do not have this gap.
"""

from __future__ import annotations

import os
import stat
import sys
import time
from collections.abc import Callable, Iterator
from contextlib import suppress
from pathlib import Path
from typing import NamedTuple
from zlib import crc32

from day6_core.link.engine import LOCAL_TCP, is_local
from day6_core.places import runtime_folders, shorter_runtime_folder
from day6_core.reason import reason
from day6_core.virtual.surroundings import is_virtual
from day6_core.whole_file import PRIVATE, replace_file

LONGEST_SOCKET_PATH = 100
"""Bytes. Systems allow 104 (macOS) to 108, including the final NUL."""
_SOCKET_NAME_LENGTH = len("p-0123456789abcdef-4194304.lock")
_YOUNG = 10.0
"""Seconds in which a socket that refuses connections may still be about to listen."""
_COARSE_NS = 100_000_000
"""More than the time within which two changes of a folder may bear the same time: a tick of the kernel's."""


class LinkError(OSError):
    """The processes of this machine cannot be reached; the message gives the reason."""


class MeetingPlace(NamedTuple):
    """The meeting place of one domain: its folder, and the endpoints Zenoh listens on and connects to there."""

    folder: Path
    tcp: bool
    passed_over: tuple[str, ...] = ()
    """Why better places could not be used."""

    @property
    def meeting_socket(self) -> Path:
        """The socket of the meeting point, where there are Unix sockets."""
        return self.folder / "meet"

    @property
    def meeting_endpoint(self) -> str:
        """The meeting point's endpoint."""
        return f"tcp/127.0.0.1:{self.meeting_port}" if self.tcp else f"unixsock-stream/{self.meeting_socket}"

    @property
    def meeting_port(self) -> int:
        """The TCP port of the meeting point: derived from the folder, so that two folders seldom share it."""
        with suppress(OSError, ValueError):
            return int((self.folder / "port").read_text(encoding="ascii")[:5])
        return 21000 + crc32(os.fsencode(self.folder)) % 10000

    def choose_another_port(self) -> None:
        """Take a free port because another program uses the meeting point's. Only for the holder of `meeting_lock`.

        Raises:
            OSError: no port is free, or the file `port` cannot be written.
        """
        import socket

        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        replace_file(self.folder / "port", str(port).encode(), mode=PRIVATE, sync=False, follow=False)

    @property
    def meeting_lock(self) -> Path:
        """The file that the holder of the meeting point has locked."""
        return self.folder / "meeting.lock"

    def own_socket(self, zid: str) -> Path:
        """Return the path of the socket (or marker file) of this process's session."""
        return self.folder / f"p-{zid}-{os.getpid()}"

    def own_endpoint(self, zid: str) -> str:
        """Return the endpoint on which this process's session listens."""
        return "tcp/127.0.0.1:0" if self.tcp else f"unixsock-stream/{self.own_socket(zid)}"


class Neighbour(NamedTuple):
    """One process that joined: session id, process id and the path of its socket."""

    zid: str
    pid: int
    path: Path


def meeting_place(domain_id: int) -> MeetingPlace:
    """Return the place for a domain, with its folder created and checked.

    All processes of a user find the same one: the first that is in use, else the first that is safe.

    Raises:
        LinkError: no folder is safe.
    """
    tcp = sys.platform == "win32" or os.environ.get("DAY6_LINK") in ("tcp", LOCAL_TCP)
    found: list[MeetingPlace] = []
    refusals: list[str] = []
    for base in runtime_folders():
        try:
            found.append(MeetingPlace(_domain_folder(base, domain_id, tcp), tcp, tuple(refusals)))
        except LinkError as error:
            refusals.append(str(error))
    if not found:
        raise LinkError("; ".join(refusals))
    return next((place for place in found if len(found) > 1 and any(neighbours(place))), found[0])


def _domain_folder(base: Path, domain_id: int, tcp: bool) -> Path:
    is_beside_zenoh = is_local() and not is_virtual()
    inside = ("local", str(domain_id)) if is_beside_zenoh else (str(domain_id),)
    if not tcp:
        base = _with_room(base, len("/".join(("", *inside, ""))) + _SOCKET_NAME_LENGTH)
    _private_folder(folder := base)
    for name in inside:
        _private_folder(folder := folder / name)
    return folder


def _with_room(base: Path, length: int) -> Path:
    """Return `base`, or a shorter folder in its place if a socket's path with `length` more bytes would be too long."""
    shorter = shorter_runtime_folder(base)
    names = base, os.path.realpath(base)  # macOS's /tmp is /private/tmp
    if shorter is None or max(len(os.fsencode(name)) for name in names) + length <= LONGEST_SOCKET_PATH:
        return base
    _private_folder(shorter.parent)
    return shorter


def base_folders() -> list[Path]:
    """Return the folders for this user's sockets that are safe, the preferred one first; they exist.

    Raises:
        LinkError: no folder is safe.
    """
    found: list[Path] = []
    refusals: list[str] = []
    for base in runtime_folders():
        try:
            folder = _with_room(base, 1 + _SOCKET_NAME_LENGTH)
            _private_folder(folder)
            found.append(folder)
        except LinkError as error:
            refusals.append(str(error))
    if not found:
        raise LinkError("; ".join(refusals))
    return found


def neighbours(place: MeetingPlace) -> Iterator[Neighbour]:
    """Yield the living processes that have a socket, including this one."""
    for neighbour in _sockets(place):
        if process_exists(neighbour.pid):
            yield neighbour


def count_with_zenoh(place: MeetingPlace) -> int:
    """Return how many processes of this user and domain use Zenoh while this one uses our own engine: it can't see them."""
    if not is_local() or is_virtual():
        return 0
    folder = place.folder.parents[1] / place.folder.name
    with suppress(OSError):
        return sum(1 for _ in neighbours(place._replace(folder=folder)))
    return 0


class Neighbourhood:
    """The sessions of the processes in a meeting place, where nobody else can be: `zid in neighbourhood`.

    The folder is read again only when it has changed; one that changed just now may change once more at the same time of its
    clock, which is a coarse one. OSError where it is gone.
    """

    def __init__(self, place: MeetingPlace) -> None:
        self._place = place
        self._read_at = -1
        self._pids: dict[str, int] = {}

    def __contains__(self, zid: str) -> bool:
        changed = self._place.folder.stat().st_mtime_ns
        if self._read_at != changed:
            is_old = time.time_ns() - changed > _COARSE_NS
            self._pids = {each.zid: each.pid for each in neighbours(self._place)}
            self._read_at = changed if is_old else -1
        pid = self._pids.get(zid)
        return pid is not None and process_exists(pid)  # a killed one leaves its socket


def remove_dead_sockets(place: MeetingPlace) -> None:
    """Remove the sockets and lock files that killed processes left behind."""
    for neighbour in _sockets(place):
        if not process_exists(neighbour.pid) and (place.tcp or _refuses(neighbour.path)):
            remove_socket(neighbour.path)


def remove_socket(path: Path) -> None:
    """Remove a socket of ours, and the lock file that Zenoh puts beside it. Raises OSError."""
    for each in (path, path.with_name(path.name + ".lock")):
        each.unlink(missing_ok=True)


def remove_if_deaf(neighbour: Neighbour) -> bool:
    """Remove a socket nobody listens on, its process id now being another process's; return whether it is gone."""
    try:
        young = time.time() - neighbour.path.stat().st_mtime < _YOUNG
    except FileNotFoundError:
        return True
    if young or not stat.S_ISSOCK(neighbour.path.stat().st_mode) or not _refuses(neighbour.path):
        return False
    neighbour.path.unlink(missing_ok=True)
    return True


def close_inherited_sockets(place: MeetingPlace) -> None:
    """In a forked child: close the copies of the link's sockets, or the others would not notice when the parent dies."""
    import socket

    folder = f"{place.folder}/".encode()
    for name in os.listdir("/dev/fd"):
        descriptor = int(name)
        try:
            if not stat.S_ISSOCK(os.fstat(descriptor).st_mode):
                continue
            with socket.socket(fileno=os.dup(descriptor)) as copy:
                ours = _is_in(folder, copy.getsockname) or _is_in(folder, copy.getpeername)
        except OSError:
            continue
        if ours:
            os.close(descriptor)


def _is_in(folder: bytes, address: Callable[[], object]) -> bool:
    try:
        name = address()
    except OSError:
        return False
    return os.fsencode(name).startswith(folder) if isinstance(name, (str, bytes)) else False


def password(place: MeetingPlace) -> str:
    """Return the password this user's processes present to each other on TCP; created on first use, mode 0600.

    Raises:
        LinkError: the file holds no password.
    """
    path = place.folder / "secret"
    try:
        descriptor = os.open(path, os.O_WRONLY | os.O_CREAT | os.O_EXCL, 0o600)
    except FileExistsError:
        pass
    else:
        with os.fdopen(descriptor, "wb") as file:
            file.write(os.urandom(16).hex().encode())
    deadline = time.monotonic() + 1.0
    while len(secret := path.read_text(encoding="ascii", errors="replace")) != 32:
        if time.monotonic() > deadline:
            raise LinkError(f"{path} holds no password; remove it")
        time.sleep(0.01)
    users = place.folder / "users"
    if not users.exists():
        replace_file(users, f"day6:{secret}\n".encode(), mode=PRIVATE, sync=False, follow=False)
    return secret


def _private_folder(folder: Path) -> None:
    try:
        folder.mkdir(mode=0o700, parents=True, exist_ok=True)
        status = folder.lstat()
        above = folder.parent.stat()
        if sys.platform == "win32":
            return
        if not stat.S_ISDIR(status.st_mode):
            raise LinkError(f"{folder} is not a folder")
        if status.st_uid != os.geteuid():
            raise LinkError(f"{folder} belongs to another user")
        if above.st_mode & 0o002 and not above.st_mode & stat.S_ISVTX:
            raise LinkError(f"other users could replace {folder}")
        if status.st_mode & 0o022:
            raise LinkError(f"other users could write to {folder}")
        if status.st_mode & 0o077:
            folder.chmod(0o700)
    except LinkError:
        raise
    except OSError as error:
        raise LinkError(f"{folder}: {reason(error)}") from error


def _sockets(place: MeetingPlace) -> Iterator[Neighbour]:
    for name in sorted(os.listdir(place.folder)):  # in the same order each time that the same processes are there
        kind, _, rest = name.partition("-")
        zid, _, pid = rest.partition("-")
        if kind == "p" and pid.isdecimal():
            yield Neighbour(zid, int(pid), place.folder / name)


def process_exists(pid: int) -> bool:
    """Return whether a process with this id runs (under any user)."""
    if sys.platform == "win32":
        return _windows_process_exists(pid)
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


def _windows_process_exists(pid: int) -> bool:
    # os.kill(pid, 0) would send a Ctrl-C there.
    import ctypes

    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined,unused-ignore]
    handle = kernel.OpenProcess(0x1000, False, pid)
    if handle:
        kernel.CloseHandle(handle)
    return bool(handle)


def _refuses(path: Path) -> bool:
    """Return whether nobody listens on a Unix socket (a process in another container may, with an id unknown here)."""
    if sys.platform == "win32":
        return False
    import socket

    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as probe:
        probe.settimeout(0.2)
        try:
            probe.connect(str(path))
        except (ConnectionRefusedError, FileNotFoundError):
            return True
        except OSError:
            return False
    return False

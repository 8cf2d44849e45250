"""Where the processes of one user, one machine and one ROS domain meet: a folder nobody else may enter.

    <base>/<domain>/meet                 socket of the meeting point
    <base>/<domain>/meeting.lock         held by the process that keeps the meeting point
    <base>/<domain>/p-<zid>-<pid>        socket of one process (where sockets are TCP: an empty file as its sign)

`base` is DAY6_RUNTIME_DIR, or else the first of these that nobody else can have prepared: `day6` in XDG_RUNTIME_DIR,
/tmp/day6-<uid>, ~/.cache/day6-tui/run. Without Unix sockets (Windows, or DAY6_LINK=tcp) everything is on 127.0.0.1, and a
user and password from a file of mode 0600 keep others out, and keep our processes from whoever takes the port of a keeper that
died: Zenoh joins nobody that does not ask for the password (the word itself is never sent). Only a program that speaks
a Zenoh of its own making, asks and accepts any answer, could get in there; Unix sockets do not have this gap.
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

LONGEST_SOCKET_PATH = 100
"""Bytes. Systems allow 104 (macOS) to 108, the NUL at the end included."""
_SOCKET_NAME_LENGTH = len("p-0123456789abcdef-4194304.lock")
_YOUNG = 10.0
"""Seconds in which a socket that refuses connections may still be about to listen."""


class LinkError(OSError):
    """The processes of this machine cannot be reached from here; the text says why."""


class Place(NamedTuple):
    """The meeting place of one domain: its folder, and the endpoints Zenoh listens on and connects to there."""

    folder: Path
    tcp: bool
    passed_over: tuple[str, ...] = ()
    """Why better places could not be used."""

    @property
    def meeting_endpoint(self) -> str:
        """The meeting point's endpoint."""
        return f"tcp/127.0.0.1:{self.meeting_port}" if self.tcp else f"unixsock-stream/{self.folder / 'meet'}"

    @property
    def meeting_port(self) -> int:
        """The port of the meeting point where there are no Unix sockets: the same for one folder, seldom for two."""
        with suppress(OSError, ValueError):
            return int((self.folder / "port").read_text(encoding="ascii")[:5])
        return 21000 + crc32(os.fsencode(self.folder)) % 10000

    def choose_another_port(self) -> None:
        """Where another program has the meeting point's port: take a free one. Only for who holds `meeting_lock`; OSError."""
        import socket

        with socket.socket() as probe:
            probe.bind(("127.0.0.1", 0))
            port = probe.getsockname()[1]
        new = self.folder / f"port-{os.getpid()}"
        with os.fdopen(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "wb") as file:
            file.write(str(port).encode())
        os.replace(new, self.folder / "port")

    @property
    def meeting_lock(self) -> Path:
        """The file that the keeper of the meeting point holds locked."""
        return self.folder / "meeting.lock"

    def own_socket(self, zid: str) -> Path:
        """Return the path of the socket (or of the sign) of this process's session."""
        return self.folder / f"p-{zid}-{os.getpid()}"

    def own_endpoint(self, zid: str) -> str:
        """Return the endpoint on which this process's session listens."""
        return "tcp/127.0.0.1:0" if self.tcp else f"unixsock-stream/{self.own_socket(zid)}"


class Neighbour(NamedTuple):
    """One process that joined: its session's id and the path of its socket."""

    zid: str
    pid: int
    path: Path


def meeting_place(domain_id: int) -> Place:
    """Return the place for a domain, its folder made and verified; raises LinkError when there is none that is safe.

    All processes of a user find the same one: the first in which somebody is, else the first that is safe.
    """
    tcp = sys.platform == "win32" or os.environ.get("DAY6_LINK") == "tcp"
    found: list[Place] = []
    refusals: list[str] = []
    for base in _base_folders():
        try:
            found.append(Place(_domain_folder(base, domain_id, tcp), tcp, tuple(refusals)))
        except LinkError as error:
            refusals.append(str(error))
    if not found:
        raise LinkError("; ".join(refusals))
    return next((place for place in found if len(found) > 1 and any(neighbours(place))), found[0])


def _domain_folder(base: Path, domain_id: int, tcp: bool) -> Path:
    length = len(os.fsencode(base)) + len(f"/{domain_id}/") + _SOCKET_NAME_LENGTH
    if sys.platform != "win32" and not tcp and length > LONGEST_SOCKET_PATH:
        base = Path(f"/tmp/day6-{os.getuid()}") / f"{crc32(os.fsencode(base)):08x}"
        _private_folder(base.parent)
    for folder in (base, base / str(domain_id)):
        _private_folder(folder)
    return base / str(domain_id)


def neighbours(place: Place) -> Iterator[Neighbour]:
    """Yield the processes whose sockets are there and that are alive, this one included."""
    for neighbour in _sockets(place):
        if process_exists(neighbour.pid):
            yield neighbour


def remove_dead_sockets(place: Place) -> None:
    """Remove what killed processes left behind."""
    for neighbour in _sockets(place):
        if not process_exists(neighbour.pid) and (place.tcp or _refuses(neighbour.path)):
            for path in (neighbour.path, neighbour.path.with_name(neighbour.path.name + ".lock")):
                path.unlink(missing_ok=True)


def remove_if_deaf(neighbour: Neighbour) -> bool:
    """Remove a socket whose process id was given to another process since; say whether it is gone."""
    try:
        young = time.time() - neighbour.path.stat().st_mtime < _YOUNG
    except FileNotFoundError:
        return True
    if young or not stat.S_ISSOCK(neighbour.path.stat().st_mode) or not _refuses(neighbour.path):
        return False
    neighbour.path.unlink(missing_ok=True)
    return True


def close_inherited_sockets(place: Place) -> None:
    """In a forked child: close the copies of the link's sockets, or the others would not notice the parent's death."""
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


def password(place: Place) -> str:
    """Return what the processes of this user show one another on TCP; made on first use, in a file of mode 0600."""
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
        new = users.with_name(f"users-{os.getpid()}")
        with os.fdopen(os.open(new, os.O_WRONLY | os.O_CREAT | os.O_TRUNC, 0o600), "wb") as file:
            file.write(f"day6:{secret}\n".encode())
        os.replace(new, users)
    return secret


def _base_folders() -> list[Path]:
    named = os.environ.get("DAY6_RUNTIME_DIR")
    if named:
        return [Path(named).absolute()]
    if sys.platform == "win32":
        return [Path(os.environ.get("LOCALAPPDATA") or Path.home()) / "day6" / "run"]
    folders = [Path(f"/tmp/day6-{os.getuid()}"), Path("~/.cache/day6-tui/run").expanduser()]
    runtime = os.environ.get("XDG_RUNTIME_DIR")
    if runtime and os.path.isdir(runtime) and os.access(runtime, os.W_OK):
        folders.insert(0, Path(runtime) / "day6")
    return folders


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
        raise LinkError(f"{folder}: {error.strerror or error}") from error


def _sockets(place: Place) -> Iterator[Neighbour]:
    for name in os.listdir(place.folder):
        kind, _, rest = name.partition("-")
        zid, _, pid = rest.partition("-")
        if kind == "p" and pid.isdecimal():
            yield Neighbour(zid, int(pid), place.folder / name)


def process_exists(pid: int) -> bool:
    """Say whether a process with this number runs (of whatever user)."""
    if sys.platform == "win32":
        return _windowsprocess_exists(pid)
    try:
        os.kill(pid, 0)
    except ProcessLookupError:
        return False
    except PermissionError:
        return True
    return True


def _windowsprocess_exists(pid: int) -> bool:
    # os.kill(pid, 0) would send a Ctrl-C there.
    import ctypes

    kernel = ctypes.windll.kernel32  # type: ignore[attr-defined,unused-ignore]
    handle = kernel.OpenProcess(0x1000, False, pid)
    if handle:
        kernel.CloseHandle(handle)
    return bool(handle)


def _refuses(path: Path) -> bool:
    """Say whether nobody listens on a Unix socket (a process of another container may, whose id means nothing here)."""
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

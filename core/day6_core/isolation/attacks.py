"""What a pupil may try against another, and what a survey of the machine therefore tries: `python -m …isolation.attacks`.

A victim stands in one cell (`stand`) with a file, sockets and a process; the attacker in another cell gets to know where all of
it is, more than a pupil would. A name in the answer means: this went through.
"""

from __future__ import annotations

import contextlib
import ctypes
import json
import os
import select
import socket
import sys
from collections.abc import Callable
from dataclasses import asdict, dataclass
from pathlib import Path
from typing import TYPE_CHECKING

assert not TYPE_CHECKING or sys.platform == "linux"

SECRET = b"what only the victim may read"
_PTRACE_ATTACH, _PTRACE_DETACH = 16, 17


@dataclass(frozen=True)
class Victim:
    """Where everything of the victim is, in the server's view."""

    home: str
    runtime: str
    pid: int
    abstract: str
    shared: str
    """A name in /tmp and /dev/shm."""
    server: int
    token: str
    """A file of the server."""
    numbers: str
    """The namespace in which the process ids above mean something."""

    @property
    def socket(self) -> str:
        """The victim's listening socket: as its keeper's, through which one could type into its desktop."""
        return os.path.join(self.runtime, "desk")


def _read(path: str) -> bool:
    with open(path, "rb") as file:
        return SECRET in file.read(1 << 20)


def _read_home(victim: Victim) -> bool:
    return _read(os.path.join(victim.home, "secret"))


def _list_home(victim: Victim) -> bool:
    return "secret" in os.listdir(victim.home)


def _list_runtime(victim: Victim) -> bool:
    return "desk" in os.listdir(victim.runtime)


def _write_home(victim: Victim) -> bool:
    Path(victim.home, "written").write_bytes(b"")
    return True


def _append(victim: Victim) -> bool:
    with open(os.path.join(victim.home, "secret"), "ab"):
        return True


def _remove(victim: Victim) -> bool:
    os.unlink(os.path.join(victim.home, "spare"))
    return True


def _through_symlink(victim: Victim) -> bool:
    link = os.path.join(os.getcwd(), "link")
    os.symlink(victim.home, link)
    return _read(os.path.join(link, "secret"))


def _through_hardlink(victim: Victim) -> bool:
    link = os.path.join(os.getcwd(), "hard")
    os.link(os.path.join(victim.home, "secret"), link)
    return _read(link)


def _read_token(victim: Victim) -> bool:
    return _read(victim.token)


def _shared_file(folder: str) -> Callable[[Victim], bool]:
    return lambda victim: _read(os.path.join(folder, victim.shared))


def _signal(number: int) -> Callable[[Victim], bool]:
    def attack(victim: Victim) -> bool:
        os.kill(victim.pid, number)
        return True

    return attack


def _signal_server(victim: Victim) -> bool:
    os.kill(victim.server, 0)
    return True


def _trace(victim: Victim) -> bool:
    library = ctypes.CDLL(None, use_errno=True)
    if library.ptrace(_PTRACE_ATTACH, ctypes.c_long(victim.pid), None, None) < 0:
        return False
    os.waitpid(victim.pid, 0x40000000)  # __WALL
    library.ptrace(_PTRACE_DETACH, ctypes.c_long(victim.pid), None, None)
    return True


def _proc(name: str) -> Callable[[Victim], bool]:
    def attack(victim: Victim) -> bool:
        path = f"/proc/{victim.pid}/{name}"
        if name == "fd":
            return any(os.readlink(f"{path}/{each}").startswith("socket:") for each in os.listdir(path))
        if name in ("root", "cwd"):
            return _read(f"{path}{victim.home if name == 'root' else ''}/secret")
        with open(path, "rb") as file:
            return name == "mem" or bool(file.read(1))

    return attack


def _command_line(victim: Victim) -> bool:
    with open(f"/proc/{victim.pid}/cmdline", "rb") as file:
        return bool(file.read(1))


def _connect(victim: Victim) -> bool:
    return _connects(victim.socket)


def _connect_through_proc(victim: Victim) -> bool:
    return _connects(f"/proc/{victim.pid}/root{victim.socket}")


def _connect_abstract(victim: Victim) -> bool:
    return _connects("\0" + victim.abstract)


def _connects(address: str) -> bool:
    with socket.socket(socket.AF_UNIX, socket.SOCK_STREAM) as connection:
        connection.settimeout(1.0)
        connection.connect(address)
        return connection.recv(64) == SECRET[:64]


def _connect_port(victim: Victim) -> bool:
    port = int(victim.abstract.rpartition("-")[2])
    with socket.create_connection(("127.0.0.1", port), 1.0) as connection:
        return connection.recv(64) == SECRET[:64]


def _become_root(_victim: Victim) -> bool:
    """A setuid program may give no rights: the kernel tells whether it would."""
    with open("/proc/self/status", encoding="ascii") as file:
        fields = dict(line.rstrip("\n").split(":\t", 1) for line in file if ":\t" in line)
    return fields["NoNewPrivs"] != "1" or (int(fields["CapEff"], 16) != 0 and os.geteuid() == 0)


ATTACKS: dict[str, dict[str, Callable[[Victim], bool]]] = {
    "files": {
        "read": _read_home,
        "list": _list_home,
        "list_runtime": _list_runtime,
        "write": _write_home,
        "append": _append,
        "remove": _remove,
        "symlink": _through_symlink,
        "hardlink": _through_hardlink,
        "tmp": _shared_file("/tmp"),
        "shm": _shared_file("/dev/shm"),
        "token": _read_token,
        "root": _proc("root"),
        "cwd": _proc("cwd"),
    },
    "processes": {
        "signal": _signal(18),  # SIGCONT; Windows has no name for it
        "kill_0": _signal(0),
        "kill_server": _signal_server,
        "ptrace": _trace,
        "environ": _proc("environ"),
        "mem": _proc("mem"),
        "fd": _proc("fd"),
        "setuid": _become_root,
    },
    "sockets": {
        "keeper": _connect,
        "keeper_by_proc": _connect_through_proc,
        "abstract": _connect_abstract,
    },
    "visible": {
        "port": _connect_port,
        "cmdline": _command_line,
    },
}
"""What may go through by what it reaches. "visible" does not decide whether a mode separates: it is told as it is."""


def attack(victim: Victim) -> list[str]:
    """Try everything; return what went through, as `group.name`."""
    return [name for name in names() if _succeeds(name, victim)]


def names() -> list[str]:
    """Return all attacks, as `group.name`."""
    return [f"{group}.{name}" for group, attacks in ATTACKS.items() for name in attacks]


def namespace() -> str:
    """Return a word for the processes that have numbers here."""
    return os.readlink("/proc/self/ns/pid")


BY_NUMBER = frozenset(
    {"root", "cwd", "signal", "kill_0", "kill_server", "ptrace", "environ", "mem", "fd", "cmdline", "keeper_by_proc"}
)
"""Attacks on a process by its number."""


def _succeeds(name: str, victim: Victim) -> bool:
    group, _, one = name.partition(".")
    if one in BY_NUMBER and namespace() != victim.numbers:
        return False  # the number would be another process here
    try:
        return ATTACKS[group][one](victim)
    except (OSError, ValueError):
        return False


def stand(home: str, runtime: str) -> None:
    """Be the victim: lay everything out, say where, and stay until standard input ends."""
    shared = f"day6-trial-{os.urandom(8).hex()}"
    listeners = [socket.socket(socket.AF_UNIX), socket.socket(socket.AF_UNIX), socket.socket()]
    listeners[2].bind(("127.0.0.1", 0))
    abstract = f"{shared}-{listeners[2].getsockname()[1]}"
    files = [Path(home, "secret"), Path(home, "spare"), Path("/tmp", shared), Path("/dev/shm", shared)]
    for file in files:
        with contextlib.suppress(OSError):  # a mode may leave no /dev/shm
            file.write_bytes(SECRET)
    os.chdir(home)
    listeners[0].bind(os.path.join(runtime, "desk"))
    listeners[1].bind("\0" + abstract)
    print(json.dumps({"abstract": abstract, "shared": shared}), flush=True)
    _answer(listeners)
    for file in (*files, Path(runtime, "desk")):
        file.unlink(missing_ok=True)


def _answer(listeners: list[socket.socket]) -> None:
    for listener in listeners:
        listener.listen()
    while True:
        waiting: list[int | socket.socket] = [0, *listeners]
        ready = select.select(waiting, [], [])[0]
        if 0 in ready:
            return
        for listener in (each for each in listeners if each in ready):
            connection, _ = listener.accept()
            with connection, contextlib.suppress(OSError):
                connection.sendall(SECRET)


def main(words: list[str]) -> int:
    """`stand HOME RUNTIME` or `attack VICTIM`."""
    if words[0] == "stand":
        stand(words[1], words[2])
    else:
        print(json.dumps(attack(Victim(**json.loads(words[1])))))
    return 0


def described(victim: Victim) -> str:
    """Return a victim as the word the attacker gets."""
    return json.dumps(asdict(victim))


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))

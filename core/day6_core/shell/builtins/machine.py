"""nproc, lsb_release, locale: the first commands of an installation guide."""

from __future__ import annotations

import os
import platform
from pathlib import Path

from day6_core.session.session import Session
from day6_core.session.threads import in_thread

_RELEASE = Path("/etc/os-release")


async def nproc(session: Session) -> int:
    """How many processors there are."""
    session.print(os.cpu_count() or 1)
    return 0


async def lsb_release(session: Session) -> int:
    """`lsb_release -a`, `lsb_release -cs`: the name and version of this system, from its own files."""
    letters = "".join(word.lstrip("-") for word in session.argv[1:])
    everything = not letters or "a" in letters
    if everything:
        session.print_error("No LSB modules are available.")
    for letter, name, value in await in_thread(_system):  # Python's platform may start uname
        if everything or letter in letters:
            session.print(value if "s" in letters else f"{name}:\t{value}")
    return 0


def _system() -> list[tuple[str, str, str]]:
    try:
        lines = _RELEASE.read_text(encoding="utf-8").splitlines()
    except OSError:
        lines = []
    release = {name: value.strip("\"'") for name, _, value in (line.partition("=") for line in lines)}
    return [
        ("i", "Distributor ID", release.get("ID", platform.system()).capitalize()),
        ("d", "Description", release.get("PRETTY_NAME", platform.platform(terse=True))),
        ("r", "Release", release.get("VERSION_ID", platform.release())),
        ("c", "Codename", release.get("VERSION_CODENAME", "n/a")),
    ]


async def locale(session: Session) -> int:
    """The language settings of this terminal."""
    variables = session.env
    language = variables.get("LANG", "")
    session.print(f"LANG={language}\nLANGUAGE={variables.get('LANGUAGE', '')}")
    for name in ("CTYPE", "NUMERIC", "TIME", "COLLATE", "MONETARY", "MESSAGES"):
        own = variables.get(f"LC_{name}")
        session.print(f"LC_{name}={own}" if own else f'LC_{name}="{variables.get("LC_ALL") or language or "POSIX"}"')
    session.print(f"LC_ALL={variables.get('LC_ALL', '')}")
    return 0

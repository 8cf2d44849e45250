"""How this day6-tui was installed, and the command that removes it."""

from __future__ import annotations

import json
import os
import shlex
import subprocess
import sys
from importlib.metadata import Distribution, PackageNotFoundError, distribution
from pathlib import Path
from typing import NamedTuple
from urllib.parse import urlsplit
from urllib.request import url2pathname

from day6_core.places import shortened

NAME = "day6-tui"


class Installation(NamedTuple):
    """An installed package, or a checkout that is merely on the path."""

    kind: str
    """'pip', 'uv', 'pipx', 'uv tool'; '' for a checkout."""
    version: str = ""
    source: Path | None = None
    """The folder of an editable installation or of a checkout."""

    def removal(self) -> str:
        """Return the command that removes the package; '' for a checkout, which is a folder of the user's."""
        python = [shortened(sys.executable)]
        return {
            "pipx": f"pipx uninstall {NAME}",
            "uv tool": f"uv tool uninstall {NAME}",
            "uv": _line(["uv", "pip", "uninstall", "--python", *python, NAME]),
            "pip": _line([*python, "-m", "pip", "uninstall", NAME]),
        }.get(self.kind, "")


def installation() -> Installation:
    """Return how the package was installed of which this program is."""
    try:
        metadata = distribution(NAME)
    except PackageNotFoundError:
        return Installation("", source=Path(__file__).resolve().parents[3])
    parts = Path(sys.prefix).parts
    tool = next((kind for kind, folders in _TOOLS.items() if _holds(parts, folders)), "")
    installer = (metadata.read_text("INSTALLER") or "pip").strip()
    return Installation(tool or ("uv" if installer == "uv" else "pip"), metadata.version, _source(metadata))


_TOOLS = {"pipx": ("pipx", "venvs", NAME), "uv tool": ("uv", "tools", NAME)}
"""The folders in which programs of their own are, one after the other."""


def _holds(parts: tuple[str, ...], wanted: tuple[str, ...]) -> bool:
    return any(parts[at : at + len(wanted)] == wanted for at in range(len(parts)))


def _source(metadata: Distribution) -> Path | None:
    """The folder of an editable installation (PEP 610)."""
    try:
        described = json.loads(metadata.read_text("direct_url.json") or "{}")
    except ValueError:
        return None
    if not described.get("dir_info", {}).get("editable"):
        return None
    return Path(url2pathname(urlsplit(described.get("url", "")).path))


def _line(words: list[str]) -> str:
    """A command line to be typed: ~ at the beginning of a word stays outside of quotes."""
    return subprocess.list2cmdline(words) if os.name == "nt" else " ".join(map(quoted, words))


def quoted(path: str) -> str:
    """Quote a word for a shell, in which ~/ stands for the home folder."""
    return f"~/{shlex.quote(path[2:])}" if path.startswith("~/") and path[2:] else shlex.quote(path)

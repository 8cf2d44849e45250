"""What `day6-tui serve` was asked for."""

from __future__ import annotations

from dataclasses import dataclass, field
from pathlib import Path

from day6_core.isolation.cell import Limits


@dataclass(frozen=True)
class ServerSettings:
    """The options of the command line, checked."""

    data: Path
    """Where the homes of the pupils are, and what the server remembers."""
    host: str = "127.0.0.1"
    port: int = 8006
    unix: Path | None = None
    """Listen on this socket, not on `host` and `port`."""
    certificate: Path | None = None
    key: Path | None = None
    word: str | None = None
    """The class word: who knows it chooses a name."""
    word_is_seen: bool = False
    """Whether the word was on the command line, where every user of the machine can read it."""
    unasked: int = 8
    """Newcomers from one address who come in by the word before the teacher is asked; 0: the teacher is asked about everybody."""
    class_file: Path | None = None
    """The names of the class."""
    new_links: bool = False
    """Make all links anew; the old ones are no longer good."""
    isolation: str = "auto"
    """A name of core.isolation.modes, or "auto": the best this machine has."""
    trust_pupils: bool = False
    limits: Limits = field(default_factory=Limits)
    """What each pupil may take at most."""
    most: int = 40
    """Desktops at a time."""
    idle: float = 120.0
    """Minutes without a key after which a desktop is ended; 0: never."""
    keep: bool = False
    """Whether the desktops go on when the server is told to end."""
    lessons: Path | None = None
    lang: str = "en"
    """Of what the server says, and of pages for browsers that ask for no language of ours."""
    desktop_lang: str = ""
    """Of all desktops; "": each begins in the language of the browser that it is started for."""
    base_url: str = ""
    """The address at which the pupils reach the server, where it is not the one it listens on."""
    proxied: bool = False
    """Who reaches the socket is the user: one desktop, no token, in the user's own ROS graph."""
    domain: int = 0
    """With `proxied`: the ROS_DOMAIN_ID of the user's other programs."""
    home: Path | None = None
    """With `proxied`: the folder that is ~ in the desktop; None: that of a desktop without a server."""

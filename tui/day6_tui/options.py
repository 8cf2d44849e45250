"""The command line options of the desktop."""

from __future__ import annotations

from dataclasses import dataclass
from pathlib import Path
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from day6_core.link.classroom.pupil import Pupil
    from day6_core.link.classroom.teacher import Teacher
    from day6_tui.features.rewind import Past


@dataclass(frozen=True)
class Options:
    """None (or False) for options that were not given."""

    scene: str | None = None
    """The name of a scene."""
    robot: str | None = None
    """A URDF file in place of the shipped car's."""
    distro: str | None = None
    """The distribution of ROS 2 that `--distro` named: it is already this process's, and is remembered."""
    lang: str | None = None
    glyphs: str | None = None
    theme: str | None = None
    """A name of `themes.NAMES`; None: as chosen last."""
    fps: float | None = None
    """Most frames a second; with 0 only `Frames.step` draws (tests)."""
    home: Path | None = None
    """The folder that is ~ in the terminals."""
    lessons: Path | None = None
    """A folder of lessons, in place of the six days."""
    lesson: str | None = None
    """A lesson that is opened at once."""
    demo: bool = False
    """Whether it is played by itself."""
    listen: str | None = None
    connect: str | None = None
    secret: str | None = None
    part: Teacher | Pupil | None = None
    """Whose desktop this is in a class on a network."""
    reduced_motion: bool = False
    record: Path | None = None
    """A new file into which the screen is recorded."""
    past: Past | None = None
    """What is played again before the person goes on."""
    keeper: int | None = None
    """The descriptor of the line to the keeper that holds the terminal (`--detach`)."""

    @property
    def has_doors(self) -> bool:
        """Whether the desktop listens for other machines or connects to them."""
        return bool(self.listen or self.connect)

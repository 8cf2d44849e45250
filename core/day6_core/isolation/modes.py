"""Which ways of keeping pupils apart this machine has, found out by trying each."""

from __future__ import annotations

import sys
from dataclasses import dataclass

from day6_core.isolation.cell import IsolationError, Phrase
from day6_core.isolation.mode import Mode
from day6_core.reason import named_reason
from day6_core.system.control_groups import trees

NAMES = ("users", "bubblewrap", "landlock", "none")
"""Best first."""


@dataclass(frozen=True)
class ModeOffer:
    """A way and whether this machine has it."""

    name: str
    mode: Mode | None
    reason: Phrase | None = None
    """Why it is not to be had, or why it does not separate."""

    @property
    def what_it_is(self) -> Phrase:
        """What pupils can and cannot do to each other: the text for the start page and the command line."""
        return Phrase(f"isolation.is.{self.name}")


def survey(names: tuple[str, ...] = NAMES) -> list[ModeOffer]:
    """Try these ways, best first. It starts a few processes and takes about a second."""
    return [_try(name) for name in names]


def available() -> tuple[Mode, ...]:
    """Return the ways this machine has, best first; whether one separates is `Mode.separates`."""
    return tuple(offer.mode for offer in survey() if offer.mode is not None)


def _try(name: str) -> ModeOffer:
    if sys.platform != "linux":
        return _elsewhere(name)
    from day6_core.isolation import groups, trial

    try:
        mode = trial.make(name, groups.usable(trees()))
        trial.run(mode)
    except IsolationError as error:
        return ModeOffer(name, None, error.words)
    except OSError as error:
        return ModeOffer(name, None, Phrase("isolation.no.fails", {"reason": named_reason(error)}))
    if name == "none":
        return ModeOffer(name, mode)
    if not mode.separates:
        opened = ", ".join(sorted(each for each in mode.open or () if not each.startswith("visible.")))
        return ModeOffer(name, mode, Phrase("isolation.no.open", {"names": opened}))
    return ModeOffer(name, mode)


def _elsewhere(name: str) -> ModeOffer:
    """macOS has the last only, and there nobody adopts what a pupil's programs leave behind; Windows has none."""
    if name != "none" or sys.platform == "win32":
        return ModeOffer(name, None, Phrase("isolation.no.linux"))
    from day6_core.isolation.same_user import Nothing

    return ModeOffer(name, Nothing())

"""Which ways of keeping pupils apart this machine has, found out by trying each."""

from __future__ import annotations

import sys
from dataclasses import dataclass

from day6_core.isolation.cell import IsolationError, Words
from day6_core.isolation.mode import Mode

NAMES = ("users", "bubblewrap", "landlock", "none")
"""Best first."""


@dataclass(frozen=True)
class Offer:
    """A way and whether this machine has it."""

    name: str
    mode: Mode | None
    reason: Words | None = None
    """Why it is not to be had, or why it does not separate."""

    @property
    def what_it_is(self) -> Words:
        """What pupils can and cannot do to each other: the text for the start page and the command line."""
        return Words(f"isolation.is.{self.name}")


def survey(names: tuple[str, ...] = NAMES) -> list[Offer]:
    """Try these ways, best first. It starts a few processes and takes about a second."""
    return [_try(name) for name in names]


def available() -> tuple[Mode, ...]:
    """Return the ways this machine has, best first; whether one separates is `Mode.separates`."""
    return tuple(offer.mode for offer in survey() if offer.mode is not None)


def _try(name: str) -> Offer:
    if sys.platform != "linux":
        return _elsewhere(name)
    from day6_core.isolation import groups, trial

    try:
        mode = trial.make(name, groups.usable(groups.trees()))
        trial.run(mode)
    except IsolationError as error:
        return Offer(name, None, error.words)
    except OSError as error:
        return Offer(name, None, Words("isolation.no.fails", {"reason": str(error)}))
    if name == "none":
        return Offer(name, mode)
    if not mode.separates:
        opened = ", ".join(sorted(each for each in mode.open or () if not each.startswith("visible.")))
        return Offer(name, mode, Words("isolation.no.open", {"names": opened}))
    return Offer(name, mode)


def _elsewhere(name: str) -> Offer:
    """macOS has the last only, and there nobody adopts what a pupil's programs leave behind; Windows has none."""
    if name != "none" or sys.platform == "win32":
        return Offer(name, None, Words("isolation.no.linux"))
    from day6_core.isolation.same_user import Nothing

    return Offer(name, Nothing())

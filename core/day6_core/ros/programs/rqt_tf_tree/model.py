"""What the TF tree shows: every frame below its parent, how old its newest transform is, how often and by whom it is sent."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import NamedTuple

from day6_core.reason import reason
from day6_core.ros.programs._drawn_pdf import laid_out
from day6_core.ros.programs.rqt_graph.model.image import check_suffix, write_image
from day6_core.ros.programs.tf2_tools.frame_tree import Frame, as_dot, as_graph, roots
from day6_core.whole_file import replace_file

OLD_SECONDS, OLD_PERIODS = 1.0, 3.0
"""A moving frame is old when its newest transform is older than both: so long, and so many of its own periods."""


@dataclass(frozen=True, slots=True)
class FrameLine:
    """A frame in the tree. `frame` is None for a root, of which nothing is known but its name.

    `ends` says for each level down to this one whether the branch ends there. `again` marks a frame in a circle that stands
    above already; nothing follows below it.
    """

    name: str
    frame: Frame | None
    ends: tuple[bool, ...] = ()
    again: bool = False


@dataclass(frozen=True, slots=True)
class Snapshot:
    """The tree as it was when it was recorded (seconds of the node's clock)."""

    frames: tuple[Frame, ...]
    recorded: float
    lines: tuple[FrameLine, ...]

    def age(self, frame: Frame) -> float | None:
        """Seconds since the newest transform; None for a static frame, which holds at all times."""
        return None if is_static(frame) else self.recorded - frame.most_recent_transform

    def is_old(self, frame: Frame) -> bool:
        """Whether it has not been sent for longer than it used to be."""
        age = self.age(frame)
        return age is not None and age > OLD_SECONDS and age * frame.rate > OLD_PERIODS


class Saved(NamedTuple):
    """The file that was written last, '' for none, and why it could not be."""

    name: str
    problem: str


def is_static(frame: Frame) -> bool:
    """Whether it came from /tf_static: tf2 keeps the time 0 with it."""
    return frame.most_recent_transform == 0.0


def snapshot(frames: Iterable[Frame], recorded: float) -> Snapshot:
    """Return the tree of these frames: roots and children sorted by name, then what hangs in circles."""
    frames = tuple(frames)
    about = {frame.name: frame for frame in frames}
    children: dict[str, list[str]] = {}
    for name in sorted(about):
        children.setdefault(about[name].parent, []).append(name)
    lines: list[FrameLine] = []
    shown: set[str] = set()
    for top in (*sorted(roots(frames)), *sorted(about)):
        waiting: list[tuple[str, tuple[bool, ...]]] = [(top, ())] if top not in shown else []
        while waiting:
            name, ends = waiting.pop()
            again = name in shown
            lines.append(FrameLine(name, about.get(name), ends, again))
            shown.add(name)
            below = [] if again else children.get(name, [])
            waiting += [(child, (*ends, child == below[-1])) for child in reversed(below)]
    return Snapshot(frames, recorded, tuple(lines))


class TfTree:
    """The model of one TF tree.

    `snapshot` is replaced as a whole and `version` raised by every refresh; windows on other threads read both. What the
    window wants it sets here and calls `on_request`.
    """

    def __init__(self, path: Callable[[str], Path], *, auto_refresh: bool = True) -> None:
        self.path = path
        """The file that a user of this program means."""
        self.auto_refresh = auto_refresh
        self.version = 0
        self.snapshot = snapshot((), 0.0)
        self.problem = ""
        """Why the last refresh failed."""
        self.saved = Saved("", "")
        self.clear_wanted = False
        self.save_wanted = ""
        """The file to be written, '' for none."""
        self.on_request: Callable[[], None] | None = None
        """Called (any thread) when the window wants something."""

    # -- the window's side ---------------------------------------------------------------------------------------------

    def request_refresh(self) -> None:
        """The button "Refresh TF Tree"."""
        self._request()

    def request_clear(self) -> None:
        """The button "Clear TF Buffer": all transforms but the static ones are forgotten."""
        self.clear_wanted = True
        self._request()

    def set_auto_refresh(self, on: bool) -> None:
        """Look again and again, or only when asked to."""
        self.auto_refresh = on
        self._request()

    def request_save(self, name: str) -> None:
        """Have the tree written to a file, see `save`; `saved` then says how it went. Raises ValueError for a wrong suffix."""
        check_suffix(self.path(name))
        self.save_wanted = name
        self._request()

    def _request(self) -> None:
        if self.on_request is not None:
            self.on_request()

    # -- the program's side --------------------------------------------------------------------------------------------

    def save(self, name: str) -> None:
        """Write the tree to a file, a relative name where the program was started; it may take seconds.

        `.dot` is the graph for Graphviz, `.svg`, `.pdf`, `.png` and others are the picture. What goes wrong is in `saved`.
        """
        path, shot = self.path(name), self.snapshot
        try:
            if path.suffix.lower() == ".dot":
                replace_file(path, as_dot(shot.frames, shot.recorded).encode("utf-8"))
            else:
                write_image(laid_out(*as_graph(shot.frames, shot.recorded)), path)
            self.saved = Saved(path.name, "")
        except (OSError, ValueError) as error:
            self.saved = Saved(path.name, reason(error))
        self.version += 1

    def show(self, found: Snapshot) -> None:
        """Show a new tree."""
        self.snapshot, self.problem = found, ""
        self.version += 1

    def fail(self, problem: str) -> None:
        """Say why there is no new tree; the last one stays."""
        self.problem = problem
        self.version += 1

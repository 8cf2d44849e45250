"""Has on the screen what a step of a lesson speaks of: its page, what it is done in, its pictures."""

from __future__ import annotations

from collections.abc import Iterable, Sequence

from day6_tui.panes.desktop import Desktop
from day6_tui.panes.layouts import lesson
from day6_tui.panes.pane import Pane
from day6_tui.panes.splits import Extent
from day6_tui.terminals.pane import TerminalPane
from day6_tui.windows import WindowPane

TERMINAL, EDITOR = "terminal", "editor"
TYPED_INTO = (TERMINAL, EDITOR)
"""What a step can be done in that is no picture."""

NARROWEST = 30
"""Columns, with the frame, in which a terminal or a picture can be used."""

LEAST_TO_WRITE = 16
"""Rows of an editor beside a page with a program."""

LEAST_PAGE = 10
"""Rows of a page that shares its column."""

LEAST_COLUMN = Extent(34, 16)
"""The smallest place for a page or a picture that need not share its column."""

ONE_COLUMN = 2
"""As many panes have room in the column beside the page."""


def kind_of(pane: Pane) -> str:
    """'terminal', or the kind of a window; '' for what is neither."""
    if isinstance(pane, WindowPane):
        return str(pane.window.kind)
    return TERMINAL if isinstance(pane, TerminalPane) else ""


def show_step(desktop: Desktop, page: Pane, see: Sequence[str], work: Pane, new: Iterable[Pane]) -> None:
    """Arrange the panes anew, unless the page, what `see` names, what was opened just now and `work` are seen as they are."""
    used = [pane for slot in desktop.recent if (pane := desktop.slots[slot]) is not page and kind_of(pane)]
    typed = [pane for pane in dict.fromkeys((work, *used)) if kind_of(pane) in TYPED_INTO]
    seen = see if kind_of(typed[0]) == TERMINAL else ()  # whoever writes a file looks at nothing but the page
    named = [next((pane for pane in used if kind_of(pane) == kind), None) for kind in seen if kind != TERMINAL]
    pictures = [pane for pane in dict.fromkeys((*named, *new)) if pane in used and pane not in typed]
    count = seen.count(TERMINAL) or (not pictures or work in typed)
    done_in = sorted(typed[:count], key=lambda pane: pane.slot)
    shown = [*done_in, *pictures]
    leasts = {pane: Extent(NARROWEST, _least_rows(desktop, pane)) for pane in shown}
    leasts[page] = LEAST_COLUMN if len(shown) <= ONE_COLUMN else Extent(NARROWEST, LEAST_PAGE)
    if len(done_in) > 1:
        leasts[done_in[-1]] = Extent(NARROWEST, desktop.needs(done_in[-1].slot).good.rows)  # a whole message
    if pictures and len(shown) == 1:
        leasts[shown[0]] = LEAST_COLUMN
    if all(_has(desktop, pane, least) for pane, least in leasts.items()):
        return
    others = [pane for pane in used if pane not in shown]
    tree = lesson(
        page.slot,
        [pane.slot for pane in done_in],
        [pane.slot for pane in pictures],
        [pane.slot for pane in others if pane in typed],
        [pane.slot for pane in others if pane not in typed],
        desktop.size.width,
    )
    desktop.arrange_as(tree)


def _least_rows(desktop: Desktop, pane: Pane) -> int:
    return LEAST_TO_WRITE if kind_of(pane) == EDITOR else desktop.needs(pane.slot).least.rows


def _has(desktop: Desktop, pane: Pane, least: Extent) -> bool:
    place = desktop.plan_now().places.get(pane.slot)
    return place is not None and place.width >= least.columns and place.height >= least.rows

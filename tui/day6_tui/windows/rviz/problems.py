"""What the tree would show as wrong, as one line above the description while the tree is folded away."""

from __future__ import annotations

from day6_core.ros.programs.rviz2.model.manager import RViz
from day6_core.ros.programs.rviz2.model.status import Status
from day6_tui.appearance.look import Look
from day6_tui.panes.cells import cell_len, fit


class ProblemLine:
    """The worst problem, and how many more there are."""

    def __init__(self, rviz: RViz, look: Look) -> None:
        self._rviz = rviz
        self._look = look
        self._seen: tuple[object, ...] = ()
        self._texts: list[str] = []
        self.status: Status | None = None
        """The line of the tree that says it; None if all is well, or the tree is there to be read."""

    def pull(self, *, folded: bool) -> bool:
        """Look what is wrong; return whether the line reads otherwise now."""
        state = (self._rviz.version, self._rviz.tree_version, folded)
        if state == self._seen:
            return False
        self._seen, before = state, self._texts
        problems = sorted(self._rviz.problems(), key=lambda each: -each[1].level) if folded else []
        self.status = problems[0][1] if problems else None
        self._texts = [self._sentence(owner, status) for owner, status in problems]
        return self._texts != before

    def _sentence(self, owner: str, status: Status) -> str:
        """A problem and whose it is; RViz's own, as that of the Fixed Frame, name what they are about."""
        text = f"{status.name}: {status.value}"
        return text if owner == self._rviz.statuses.word else f"{owner}: {text}"

    def text(self, width: int) -> str:
        """The line in exactly `width` cells."""
        more = f" +{len(self._texts) - 1} " if len(self._texts) > 1 else ""
        first = self._texts[0] if self._texts else ""
        ellipsis = self._look.glyphs.ellipsis
        return fit(f" {self._look.glyphs.warning} {first}", max(0, width - cell_len(more)), ellipsis) + more[:width]

"""A finding: a problem, its level, and the command that helps.

"error" keeps something from working, "warning" is probably unintended, "info" is worth knowing.
"""

from __future__ import annotations

from dataclasses import dataclass, replace
from pathlib import PurePath

from day6_core.advice.card_files import finding_cards
from day6_core.advice.wording import at_home
from day6_core.ros.programs.remark import Remark

ORDER = {"error": 0, "warning": 1, "info": 2}


@dataclass(frozen=True)
class Finding(Remark):
    """One thing that is wrong."""

    next: str = ""
    """What to type next, '' where no one command helps."""

    def of_card(self, language: str) -> str:
        """Return it in the words of the card that is about it, '' if there is none."""
        card = finding_cards().get(self.id.removeprefix("inspector."))
        return card.words[language].finding.format(**dict(self.parameters)) if card is not None else ""

    def at_home(self, home: str) -> Finding:
        """Return it with ~ for the home folder, as one types it: the folder of a desktop may have a long path."""
        said = {
            name: at_home(str(value), home) for name, value in self.parameters if isinstance(value, (str, PurePath))
        }
        parameters = tuple((dict(self.parameters) | said).items())
        return replace(self, parameters=parameters, next=at_home(self.next, home))

    @property
    def text(self) -> str:
        """The English words."""
        return self.of_card("en") or super().text


def finding(level: str, key: str, *, then: str = "", **parameters: object) -> Finding:
    """Make the finding `inspector.KEY`; `then` is the next command.

    A name with a control character, which might press Return, makes a command that is not offered.
    """
    then = then if then.isprintable() else ""
    return replace(Finding.of(level, f"inspector.{key}", **parameters), next=then)

"""What the lookers of cards see, and what they answer: files, the terminal's variables, the live graph, what was run."""

from __future__ import annotations

import re
import shlex
from collections.abc import Callable, Mapping
from dataclasses import dataclass, field
from pathlib import Path

from day6_core.advice.fault import Fault
from day6_core.advice.rules import Surroundings
from day6_core.facts.graph import GraphFacts


@dataclass(frozen=True)
class Situation:
    """What a looker may look at; `graph` is None where nobody can ask one."""

    around: Surroundings
    values: Mapping[str, str] = field(default_factory=dict)
    command: str = ""
    """The line that was run in the terminal, '' if that is not known."""
    fault: Fault | None = None
    graph: GraphFacts | None = None
    commands: tuple[str, ...] = ()
    """The commands that the terminal knows."""
    letters: str = ""
    """The answers that a question of the lesson waits for: 'abc'."""
    said: str = ""
    """The line of the output that is explained."""
    line: str = ""
    """All that was run in one line with that command."""

    @property
    def variables(self) -> Mapping[str, str]:
        return self.around.variables

    @property
    def cwd(self) -> Path:
        return self.around.cwd

    @property
    def home(self) -> Path:
        return Path(self.variables.get("HOME", "/"))

    def words(self) -> list[str]:
        """Return the words of the line that was run; [] if they cannot be told apart."""
        try:
            return shlex.split(self.command)
        except ValueError:
            return []

    def with_word(self, wrong: str, right: str) -> str:
        """Return the line that was run with one word put right; '' if that word is not there once."""
        pattern = rf"(?<!\S){re.escape(wrong)}(?!\S)"
        plain = all(shlex.quote(word) == word for word in right.split(" "))
        return (
            re.sub(pattern, lambda _: right, self.command)
            if plain and len(re.findall(pattern, self.command)) == 1
            else ""
        )

    def value(self, name: str) -> str:
        """Return what the card's pattern found, '' if it has no such name."""
        return self.values.get(name, "")


@dataclass(frozen=True)
class Found:
    """A cause that is certain: the text for it (`texts.py`) with its values, and what to type next ('': what the card says)."""

    key: str
    values: Mapping[str, object]
    next: str = ""


Looker = Callable[[Situation], Found | None]

LOOKERS: dict[str, Looker] = {}
"""By the name that cards call them."""

ASK_GRAPH: set[str] = set()
"""Those that ask the live graph."""


def looker(function: Looker) -> Looker:
    """Register a function under its own name."""
    LOOKERS[function.__name__] = function
    return function


def graph_looker(function: Callable[[Situation, GraphFacts], Found | None]) -> Looker:
    """Register a function that is not asked where nobody can ask a graph."""

    def look(scene: Situation) -> Found | None:
        return function(scene, scene.graph) if scene.graph is not None else None

    ASK_GRAPH.add(function.__name__)
    LOOKERS[function.__name__] = look
    return look


def found(key: str, next_: str = "", **values: object) -> Found:
    """Return a cause in short."""
    return Found(key, values, next_)

"""What rules look at: each declares it with `looks_at`, and `sights` counts what of it was there."""

from __future__ import annotations

from collections.abc import Callable, Iterator, Sequence
from dataclasses import dataclass

from day6_core.ros.programs.day6_inspector.facts import Facts
from day6_core.ros.programs.day6_inspector.finding import Finding

Judge = Callable[[Facts], Iterator[Finding]]

SIGHTS: dict[str, Callable[[Facts], int | None]] = {
    "nodes": lambda facts: len(facts.nodes),
    "topics": lambda facts: len(facts.topics),
    "messages": lambda facts: sum(each.messages for each in facts.heard),
    "services": lambda facts: len({*facts.servers, *facts.clients}),
    "frames": lambda facts: len(facts.frames),
    "joints": lambda facts: len(facts.joints or ()),
    "windows": lambda facts: facts.windows,
    "programs": lambda facts: len(facts.processes),
    "terminals": lambda facts: None if facts.terminals is None else len(facts.terminals),
    "packages": lambda facts: None if facts.files is None else facts.files.packages,
    "machines": lambda facts: len(facts.link.doors),
}
"""What can be looked at -> how many of it there are, None where nobody could look."""


@dataclass(frozen=True)
class Rule:
    """A rule, and what it looks at in the words of `SIGHTS`."""

    judge: Judge
    of: tuple[str, ...]

    def __call__(self, facts: Facts) -> Iterator[Finding]:
        """Judge facts."""
        return self.judge(facts)


def looks_at(*of: str) -> Callable[[Judge], Rule]:
    """Declare what a rule looks at."""
    return lambda judge: Rule(judge, of)


def sights(rules: tuple[Rule, ...], facts: Facts) -> tuple[tuple[str, int], ...]:
    """Return what some rules looked at, and how many of it there are, in the order of `SIGHTS`."""
    used = {sight for rule in rules for sight in rule.of}
    counts = ((sight, count(facts)) for sight, count in SIGHTS.items() if sight in used)
    return tuple((sight, found) for sight, found in counts if found is not None)


def not_seen(facts: Facts) -> tuple[tuple[str, str], ...]:
    """Return what nobody could look at: a key of `inspector.unseen`, and the names it is about."""
    found = {
        "terminals": "" if facts.terminals is None else None,
        "files": "" if facts.files is None else None,
        "programs": ", ".join(facts.unreported) or None,
        "messages": ", ".join(facts.unread) or None,
        "topics": str(facts.passed_over or "") or None,
    }
    return tuple((key, names) for key, names in found.items() if names is not None)


def said_of(
    looked: Sequence[tuple[str, int]], unseen: Sequence[tuple[str, str]], texts: Callable[..., str]
) -> Iterator[str]:
    """Yield the lines that say what was looked at and what not, in somebody's language."""
    there = [f"{texts(f'inspector.sight.{key}')} {count}" for key, count in looked if count]
    absent = [texts(f"inspector.sight.{key}") for key, count in looked if not count]
    for key, those in (("looked", there), ("absent", absent)):
        if those:
            yield texts(f"inspector.{key}", sights=" · ".join(those))
    for key, names in unseen:
        yield texts(f"inspector.unseen.{key}", names=names)

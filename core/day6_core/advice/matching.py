"""Finds the card for a line of output, and the lines of an output that have one."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass, replace
from typing import NamedTuple

from day6_core.advice.card_files import Card, all_cards
from day6_core.advice.fault import Fault, faults_in
from day6_core.session.plain import without_sequences

MOST_LINES = 400
"""Lines at the end of an output in which cards are looked for."""

LONGEST_LINE = 2000
"""Characters of a line that are looked at."""

_LAUNCHED = re.compile(r"^\[[\w.-]+-\d+\] ")
"""What launch puts before each line of a node."""

_BEFORE = (
    _LAUNCHED,
    re.compile(r"\[?(?:DEBUG|INFO|WARN|WARNING|ERROR|FATAL)\]? \[[\d.]+\] \[[^\]]*\]: "),  # rclpy and rclcpp
    re.compile(r"\[(?:WARNING|WARN|ERROR|CRITICAL)\] \[[^\]]*\]: "),  # launch, ros2 bag
    re.compile(r"Caught exception in launch \(see debug for traceback\): \"?(?!Caught multiple)"),
    re.compile(r"(?:\[[\d.]+s\] )?(?:WARNING|ERROR):[\w.]+:"),  # colcon
    re.compile(r"(?:bash|sh): (?:line \d+: )?"),
    re.compile(r"(?: - |E +)"),  # launch, of several exceptions; pytest
    re.compile(r"(?:error: |(?:Error|Warning): +)(?=[A-Z'\"\[]|\w+ [\['])"),  # some tools; urdfdom
    re.compile(r"(?:[a-z_]\w*\.)+(?=_?[A-Z]\w*(?:Error|Exception|Warning|Interrupt|Cycle|Full|Exit)\b)"),
)
"""What says where a line comes from, not what it says."""


EXPLAINED = re.compile(r"(?:提示：|意思：|hint: )")
"""What our own explanations begin with."""

_CALM = re.compile(r"(?:\[[\w.-]+-\d+\] )?\[(?:INFO|DEBUG)\] \[[^\]]*\] \[(?!rclcpp\])")
"""A line of a log that tells of no trouble."""


@dataclass(frozen=True)
class Match:
    """A line, its card, what the card's pattern found in it, and the exception if the line is one's of a traceback."""

    line: str
    card: Card
    values: Mapping[str, str]
    fault: Fault | None = None


def plain_lines(output: str) -> list[str]:
    """Return the lines of what a terminal was given, without colours and what was overwritten."""
    return [line.rpartition("\r")[2].rstrip()[:LONGEST_LINE] for line in without_sequences(output).split("\n")]


def forms(line: str) -> list[str]:
    """Return a line as it is, then without what stands before its message."""
    found = [line]
    changed = True
    while changed and len(found) < 6:
        changed = False
        for before in _BEFORE:
            match = before.match(found[-1])
            if match is not None and match.end() < len(found[-1]):
                found.append(found[-1][match.end() :])
                changed = True
    return found


def card_for(line: str, fault: Fault | None = None) -> Match | None:
    """Return the first card for a line, None if there is none; `fault` is the exception that the line tells of."""
    if not line or line.isspace() or _CALM.match(line):
        return None
    candidates = forms(line[:LONGEST_LINE])[::-1]
    words_of_program = fault is not None and not fault.in_words_of_tools
    for card in all_cards():
        for pattern in card.patterns:
            if pattern.loose and words_of_program:
                continue
            values = next((found for form in candidates if (found := pattern.match(form)) is not None), None)
            seen = card.seen_in(fault) if values is not None else None
            if values is not None and seen is not None:
                placed = replace(fault, line=fault.number) if fault is not None and card.line is not None else fault
                return Match(line, card, values | seen, placed)
    return None


def _outside_reports(lines: Iterable[str]) -> Iterator[str]:
    """The lines of an output without those of programs that a report of Python repeats: their texts are no messages."""
    inside = False
    for line in lines:
        said = _LAUNCHED.sub("", line)
        indented = said.startswith("  ")
        if not (inside and indented):
            yield line
        inside = said.startswith("Traceback (most recent call last):") or (inside and indented)


def cards_in(output: str) -> Iterator[Match]:
    """Yield the lines of an output that have a card, the last first; after all others those that only echo another one."""
    echoes: list[Match] = []
    seen: set[str] = set()
    faults = {fault.said: fault for fault in reversed(faults_in(output))}
    for line in reversed([*_outside_reports(plain_lines(output)[-MOST_LINES:])]):
        if line in seen or EXPLAINED.match(line):
            continue
        seen.add(line)
        fault = next((faults[form] for form in forms(line) if form in faults), None)
        match = card_for(line, fault)
        if match is None:
            continue
        if match.card.echo:
            echoes.append(match)
        else:
            yield match
    yield from echoes


def unfinished(source: str) -> Match | None:
    """Return the card of the prompt `> `, with what was typed so far."""
    line = next(iter(source.strip().splitlines()), "")
    match = card_for(f"the prompt > waits for the end of: {line}")
    return replace(match, line=line) if match is not None else None


class Sighting(NamedTuple):
    """A line of an output in which a card's finding was seen, what was found in it, and what came after it."""

    line: str
    values: Mapping[str, str]
    rest: str


def sightings(card: Card, text: str) -> list[Sighting]:
    """Return where in an output the finding of a card is seen."""
    patterns = [pattern for pattern in card.finds or card.patterns if pattern.literal in text]
    found: list[Sighting] = []
    lines = text.split("\n") if patterns else []
    for number, line in enumerate(lines):
        candidates = (
            pattern.search(line) if card.finds else pattern.match(form)
            for pattern in patterns
            if pattern.literal in line
            for form in ((line,) if card.finds else reversed(forms(line)))
        )
        values = next((each for each in candidates if each is not None), None)
        if values is not None:
            found.append(Sighting(line, values, "\n".join(lines[number + 1 :])))
    return found

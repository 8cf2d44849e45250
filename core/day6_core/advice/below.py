"""The grey line below what failed, where no hint is certain: the cause that a card's lookers find here, else its first line."""

from __future__ import annotations

from collections.abc import Iterable

from day6_core.advice.explain import explain, scene_of
from day6_core.advice.matching import EXPLAINED, cards_in, plain_lines
from day6_core.advice.rules import Surroundings
from day6_core.advice.texts import TEXTS
from day6_core.advice.wording import at_home, filled_in
from day6_core.language import language_of
from day6_urdf.explain import hints_wanted


def wants_first_lines(around: Surroundings) -> bool:
    """Return whether the line is to appear by itself: in Chinese, unless hints are switched off."""
    return hints_wanted(around.variables) and language_of(around.variables) == "zh"


def first_line_below(
    output: str, around: Surroundings, *, command: str = "", commands: Iterable[str] = (), letters: str = ""
) -> str:
    """Return the line for what a failed command printed, where Chinese is spoken; '' if there is no card for it.

    `command`, `commands` and `letters` are what lookers may know (`Situation`). Reads files: not for the scheduler's thread.
    """
    if not wants_first_lines(around) or any(map(EXPLAINED.match, plain_lines(output))):
        return ""
    match = next(cards_in(output), None)
    if match is None or match.card.echo:
        return ""
    scene = scene_of(match, around, output=output, command=command, commands=commands, letters=letters)
    shown = explain(match, scene, "zh")
    if shown.here and shown.next:
        told = TEXTS["card.below_with_next"][1].format(here=shown.here.rstrip("。？"), next=shown.next)
    else:
        first = filled_in(match.card.words["zh"].first, match.values, match.fault)
        told = TEXTS["card.below"][1].format(first=shown.here or first)
    return at_home(told, around.home)

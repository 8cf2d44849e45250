"""From a line to its explanation: the card's words, what the lookers found here, what to type next; as text too."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from dataclasses import dataclass

from day6_core.advice import (  # they register themselves
    lookers_files,
    lookers_graph,
    lookers_line,
    lookers_programs,
    lookers_values,
)
from day6_core.advice.card_files import Card, topics
from day6_core.advice.fault import fault_in
from day6_core.advice.looking import ASK_GRAPH, LOOKERS, Found, Situation
from day6_core.advice.matching import Match
from day6_core.advice.rules import Surroundings
from day6_core.advice.texts import TEXTS
from day6_core.advice.wording import at_home, command_of, filled_in, sentence, with_gaps
from day6_core.facts.graph import GraphFacts
from day6_core.language import said
from day6_core.session.harmless import one_line
from day6_core.width import char_width, text_width

LONGEST_SHOWN = 300
"""Characters of the line that an explanation repeats."""

NARROWEST = 20

_MODULES = (lookers_files, lookers_graph, lookers_line, lookers_programs, lookers_values)
"""Their functions have registered themselves in LOOKERS."""


@dataclass(frozen=True)
class Explanation:
    """What is shown of a card. `here` is '' where no looker found a cause; then the checks say in which order to look."""

    line: str
    means: str
    here: str
    looked: bool
    """Whether anybody looked for the cause."""
    checks: tuple[str, ...]
    next: str
    robot: str
    """'' : the same as here."""


def scene_of(
    match: Match,
    around: Surroundings,
    *,
    output: str = "",
    command: str = "",
    graph: GraphFacts | None = None,
    commands: Iterable[str] = (),
    letters: str = "",
) -> Situation:
    """Return what lookers may look at for a line of `output`, which `command` printed."""
    fault = match.fault or fault_in(output or match.line)
    simple = simple_command(command, match.values)
    return Situation(around, match.values, simple, fault, graph, tuple(commands), letters, match.line, command)


def simple_command(source: str, values: Mapping[str, str]) -> str:
    """Return the one command of a line (`a; b && c`) that what was found is about: one that names it, else the last one."""
    commands, quote = [""], ""
    for char in source:
        if quote or char in "'\"":
            quote = "" if char == quote else quote or char
        elif char in ";&|\n":
            commands.append("")
            continue
        commands[-1] += char
    commands = [command.strip() for command in commands if command.split()[:1] not in ([], ["why"], ["explain"])]
    named = [command for command in commands if any(value and value in command for value in values.values())]
    return (named or commands or [""])[-1]


def explain(match: Match, scene: Situation, language: str) -> Explanation:
    """Return a card's words for this line and this place. Reads files: not for the scheduler's thread."""
    card, words = match.card, match.card.words[language]
    here, next_ = "", ""
    cause = _cause(card, scene)
    if cause is not None:
        template = said(TEXTS[cause.key], language)
        values = {key: one_line(str(value)) for key, value in cause.values.items()}
        here, next_ = at_home(sentence(template, language).format(**values), scene.around.home), cause.next
    if not here and card.next:
        next_ = command_of(card.next, match.values)

    def filled(text: str) -> str:
        return at_home(filled_in(text, match.values, match.fault), scene.around.home)

    first = filled(words.first)
    means = "\n".join(
        filter(None, (sentence(first, language) if not words.first.startswith("{") else first, filled(words.more)))
    )
    return Explanation(
        line=one_line(match.line.strip())[:LONGEST_SHOWN],
        means=means,
        here=here,
        looked=bool(card.look),
        checks=() if here else tuple(map(filled, words.checks)),
        next=next_ if next_.isprintable() else "",
        robot=filled(words.robot),
    )


def _cause(card: Card, scene: Situation) -> Found | None:
    """What the first looker that finds something says; before all others a Chinese sign in the command."""
    if scene.command and (cause := lookers_line.chinese_cause(scene)) is not None:
        return cause
    for name in card.look:
        try:
            cause = LOOKERS[name](scene)
        except (OSError, ValueError):
            continue  # a folder that may not be read, a name that no file can have: nothing was found
        if cause is not None:
            return cause
    return None


def parts(shown: Explanation, language: str) -> list[tuple[str, str]]:
    """Return what is shown of an explanation as pairs of heading and text, without the line itself and without `next`."""
    say = {key: said(TEXTS[f"card.{key}"], language) for key in ("means", "here", "unknown", "checks", "robot")}
    found = [(say["means"], shown.means)]
    listed = "\n".join(f"{number}. {check}" for number, check in enumerate(shown.checks, 1))
    if shown.here:
        found.append((say["here"], shown.here))
    elif listed:
        found.append((say["here"], f"{say['unknown']}\n{listed}") if shown.looked else (say["checks"], listed))
    if shown.robot:
        found.append((say["robot"], shown.robot))
    return found


def as_text(shown: Explanation, language: str, columns: int) -> str:
    """Return an explanation as lines of at most `columns` cells, without colours."""
    width = max(NARROWEST, columns - 3)
    found = [*parts(shown, language)]
    if shown.next:
        found.insert(len(found) - bool(shown.robot), (said(TEXTS["card.next"], language), shown.next))
    lines = wrapped(shown.line, max(NARROWEST, columns - 1))
    for heading, text in found:
        lines += ["", heading, *(f"  {line}" for line in wrapped(text, width))]
    return "\n".join(lines)


def explanation_of_card(card: Card, language: str) -> Explanation:
    """Return a card without a message and a place."""
    words = card.words[language]
    means = "\n".join(filter(None, (sentence(with_gaps(words.first), language), with_gaps(words.more))))
    checks = tuple(map(with_gaps, words.checks))
    line = with_gaps(card.patterns[0].text) if card.patterns[0].is_line else card.id
    return Explanation(line, means, "", False, checks, "", with_gaps(words.robot))


def asks_graph(card: Card) -> bool:
    """Return whether a looker of this card asks the live graph."""
    return not ASK_GRAPH.isdisjoint(card.look)


def topic_list(language: str) -> list[tuple[str, str, list[Card]]]:
    """Return the topics in their order: name, title, cards."""
    return [(name, titles[language], cards) for name, (titles, cards) in topics().items()]


def wrapped(text: str, width: int) -> list[str]:
    """Break a text into lines of at most `width` cells: at blanks, and between Chinese characters."""
    lines = []
    for paragraph in text.split("\n"):
        line = ""
        for piece in _pieces(paragraph):
            if text_width(line) + text_width(piece.rstrip()) > width and line:
                lines.append(line.rstrip())
                line = ""
            while text_width(piece) > width:
                cut = _fitting(piece, width)
                lines.append(piece[:cut])
                piece = piece[cut:]
            line += piece if line else piece.lstrip()
        lines.append(line.rstrip())
    return lines


_NEVER_FIRST = "，。、；：？！）」』》】…,.;:?!)"
_NEVER_LAST = "（「『《【("


def _pieces(text: str) -> list[str]:
    """A text in pieces that stay whole: words with the blank after them, Chinese characters with their punctuation."""
    pieces: list[str] = []
    for char in text:
        joins = pieces and (
            char in _NEVER_FIRST
            or pieces[-1][-1] in _NEVER_LAST
            or char == " "
            or (pieces[-1][-1] != " " and char_width(char) != 2 and char_width(pieces[-1][-1]) != 2)
        )
        if joins:
            pieces[-1] += char
        else:
            pieces.append(char)
    return pieces


def _fitting(text: str, width: int) -> int:
    used = 0
    for number, char in enumerate(text):
        used += char_width(char)
        if used > width:
            return max(1, number)
    return len(text)

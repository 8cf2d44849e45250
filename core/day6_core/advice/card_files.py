"""Cards: what a message means, what to do about it, and what is different on a real robot. They are data, in `cards/*.md`.

A file is one topic. It begins with `# TITLE | ENGLISH TITLE`; each card in it is

    ## id-of-the-card
    - says: `Package '{name}' not found`
    - look: package
    - from: own rclpy
    - line: `for (?P<what>[a-z]+) in`
    - next: `ros2 pkg list`

    **zh** What it means, in Chinese: the first line appears by itself, what follows explains it.
    1. what to check first, where no cause was found
    > what is different on a real robot

    **en** The same in English, with as many checks.

`says` is a whole line with {names} for what varies ({…}: not needed later), `match` a regular expression from the beginning
of the line; there may be several. `look` names functions of the modules `lookers_*.py`. `next` is what to type.
`from` is for a message that means something else where it comes from elsewhere: it names modules, one of which the pupil's line
had called when it failed, `own` for that line itself, or `anywhere`. `line` is a regular expression for the pupil's line, and its
named groups are filled in. A card with `from` or `line` is only for a traceback that shows so.
Words alone: `- hint` (the first line is certain enough to be shown as a hint, in every language), `- echo` (the message only
says that another one came before it), `- same` (on a real robot nothing is different). {names} in the texts are filled in; a
brace is written twice.

A card may be a finding of the inspector, too:

    - finding: error no_package `ros2 pkg list`
    - finds: `Package '(?P<name>[^']+)' not found`

It has a level, a key, and a command where it is another one than `next`. `finds` is a regular expression for anywhere in a line;
without one the finding is seen where the card is. Its sentence stands at the end of each language: `! {where}: {first}`, where
{where} is the place in the program, {line} what was run, {first} the card's first line.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache
from pathlib import Path
from string import Formatter

from day6_core.advice.fault import Fault
from day6_core.language import LANGUAGES
from day6_core.ros.differences import retold

TOPICS = ("nodes", "python", "syntax", "packages", "build", "setup", "launch", "graph", "messages", "parameters", "actions", "tf",
          "rviz", "urdf", "programs", "link", "bags", "files", "shell", "usage", "rclpy", "errors", "ends")  # fmt: skip
"""The files in the order in which their cards are tried: what is special comes before what is general."""

FOLDER = Path(__file__).parent / "cards"

_FLAGS = ("hint", "echo", "same")
_ITEM = re.compile(r"- (\w+)(?:: (.+))?$")
_HEAD = re.compile(r"## ([a-z0-9]+(?:-[a-z0-9]+)*)$")
_FINDING = re.compile(r"(error|warning|info) ([a-z_]+)(?: `(.+)`)?$")
_SAID = re.compile(r"\*\*(\w+)\*\* (.+)$")
_LOOSE = re.compile(r"(?:\(\?![^)]*\))?\(*(?:\?:)?\.\*|\{")
_HOLE = re.compile(r"\{(\w+|…)\}")
KNOWN_VALUES = ("line", "file")
"""What every text may name: the place in a program, where a traceback says it."""


class CardError(ValueError):
    """A card that is not written as it has to be."""

    def __init__(self, path: Path, line: int, reason: str) -> None:
        super().__init__(f"{path.name}, line {line}: {reason}")
        self.line = line


@dataclass(frozen=True)
class CardWords:
    """A card in one language: its first line, the rest, what to check in which order, what differs on a real robot."""

    first: str
    more: str = ""
    checks: tuple[str, ...] = ()
    robot: str = ""
    finding: str = ""
    """The sentence of the inspector's finding, '' where another card has it, or there is none."""


@dataclass
class Card:
    """One card, as it stands in its file."""

    id: str
    topic: str
    patterns: tuple[Pattern, ...] = ()
    look: tuple[str, ...] = ()
    origins: frozenset[str] = frozenset()
    """Where the exception has to come from; empty: from anywhere, known or not."""
    line: Pattern | None = None
    """What the pupil's line has to look like; None: anything, known or not."""
    next: str = ""
    hint: bool = False
    echo: bool = False
    same: bool = False
    finding: str = ""
    """The key of the inspector's finding, '' for none."""
    level: str = ""
    finding_next: str = ""
    finds: tuple[Pattern, ...] = ()
    words: dict[str, CardWords] = field(default_factory=dict)

    def seen_in(self, fault: Fault | None) -> dict[str, str] | None:
        """Return what the pupil's line gives to fill in, None where it is another line, or the exception comes from elsewhere.

        `fault` is None where nothing is known of either.
        """
        came_from = ("anywhere", "own" if fault.own else "", *fault.through) if fault is not None else ()
        if self.origins and self.origins.isdisjoint(came_from):
            return None
        if self.line is None:
            return {}
        found = self.line.match(fault.source) if fault is not None else None
        return {name: value for name, value in found.items() if not name.isdigit()} if found is not None else None


class Pattern:
    """A line with names for what varies, or a regular expression; compiled when a line has what both must have in common."""

    def __init__(self, text: str, *, is_line: bool) -> None:
        """Raises re.error for a regular expression that is none."""
        self.text = text
        self.is_line = is_line
        self.source = _expression(text) if is_line else text
        self.literal = max(_HOLE.split(text)[::2], key=len) if is_line else _longest_literal(text)
        self.loose = _LOOSE.match(text) is not None and not re.search(r"(?:Error|Exception)(?:: |\W*$)", text)
        """Whether any words may come before what it knows: then it is for what a tool says, not for what programs raise."""
        self._compiled: re.Pattern[str] | None = None
        if not is_line:
            re.compile(text)

    @property
    def names(self) -> set[str]:
        """What it finds: names, and the numbers of groups as text."""
        compiled = self.compiled
        return {*compiled.groupindex, *map(str, range(compiled.groups))}

    @property
    def compiled(self) -> re.Pattern[str]:
        if self._compiled is None:
            self._compiled = re.compile(self.source)
        return self._compiled

    def match(self, line: str) -> dict[str, str] | None:
        """Return what varies in this line, None if it is another one."""
        if self.literal not in line:
            return None
        return self._values(self.compiled.match(line))

    def search(self, line: str) -> dict[str, str] | None:
        """Return the same for a line that has it anywhere."""
        return self._values(self.compiled.search(line)) if self.literal in line else None

    @staticmethod
    def _values(found: re.Match[str] | None) -> dict[str, str] | None:
        if found is None:
            return None
        numbered = {str(number): group or "" for number, group in enumerate(found.groups())}
        return numbered | {name: group or "" for name, group in found.groupdict().items()}


def _expression(line: str) -> str:
    """`Package '{name}' not found` as a regular expression for the whole line."""
    parts = _HOLE.split(line)
    seen: set[str] = set()
    found = []
    for number, part in enumerate(parts):
        if number % 2 == 0:
            found.append(re.escape(part))
        elif part == "…":
            found.append(".*?")
        else:
            found.append(f"(?P={part})" if part in seen else f"(?P<{part}>.+?)")
            seen.add(part)
    return "".join(found) + r"\Z"


def _longest_literal(expression: str) -> str:
    """The longest text without anything special that a line must contain to match; '' if that cannot be told simply."""
    plain = re.sub(r"\\[.()\[\]{}'\"/ -]", "\0", expression)
    while (shorter := re.sub(r"\[[^\[\]]*\]|\([^()]*\)", "\1", plain)) != plain:
        plain = shorter
    if "|" in plain:
        return ""
    runs = re.findall(r"[\w ':,/-]+(?![?*{\w ':,/-])", re.sub(r"\\.", "\0", plain))
    return max(runs, key=len, default="")


# -- reading -------------------------------------------------------------------------------------------------------------


def read_topic(path: Path) -> tuple[dict[str, str], list[Card]]:
    """Return the titles of a topic by language, and its cards. Raises CardError with the line, OSError."""
    lines = retold(path.read_text(encoding="utf-8")).split("\n")
    titles = [title.strip() for title in lines[0].removeprefix("# ").split("|")]
    if not lines[0].startswith("# ") or len(titles) != len(LANGUAGES) or not all(titles):
        raise CardError(path, 1, "the first line has to be '# TITLE | ENGLISH TITLE'")
    reader = _Reader(path)
    for number, line in enumerate(lines[1:], 2):
        reader.take(number, line.rstrip())
    return dict(zip(LANGUAGES, titles, strict=True)), reader.close(len(lines))


class _Reader:
    """Takes the lines of one file."""

    def __init__(self, path: Path) -> None:
        self._path = path
        self._number = 0
        self._cards: list[Card] = []
        self._begun = 0
        """Where the card begins that is read."""
        self._language = ""
        self._said: dict[str, tuple[list[str], list[str], list[str], list[str]]] = {}
        """By language: what it means, checks, the real robot, the finding."""

    def _wrong(self, reason: str, line: int = 0) -> CardError:
        return CardError(self._path, line or self._number, reason)

    def take(self, number: int, line: str) -> None:
        self._number = number
        if line.startswith("#"):
            found = _HEAD.match(line)
            if found is None:
                raise self._wrong("a card begins with '## its-id'")
            self._finish()
            self._begun = number
            self._cards.append(Card(found[1], self._path.stem))
        elif not line:
            return
        elif not self._cards:
            raise self._wrong("text before the first card")
        elif self._language == "" and line.startswith("- "):
            self._item(line)
        elif (said := _SAID.match(line)) is not None:
            self._begin(said[1], said[2])
        elif not self._language:
            raise self._wrong("expected '- says: …' or '**zh** …'")
        else:
            self._say(line)

    def _item(self, line: str) -> None:
        found, card = _ITEM.match(line), self._cards[-1]
        name, value = (found[1], found[2]) if found is not None else ("", None)
        if name in _FLAGS and value is None:
            setattr(card, name, True)
            return
        if name not in ("says", "match", "look", "from", "line", "next", "finding", "finds") or value is None:
            raise self._wrong(
                "expected says, match, look, from, line, next, finding or finds with a value, or hint, echo or same without one"
            )
        if name == "finding":
            told = _FINDING.match(value)
            if told is None:
                raise self._wrong("a finding has a level and a key: error no_package")
            card.level, card.finding, card.finding_next = told[1], told[2], told[3] or ""
            return
        if name == "look":
            card.look = tuple(value.split())
            return
        if name == "from":
            card.origins = frozenset(value.split())
            return
        if not (len(value) > 2 and value[0] == value[-1] == "`"):
            raise self._wrong(f"what {name} names stands between `")
        if name == "next":
            card.next = value[1:-1]
            return
        try:
            pattern = Pattern(value[1:-1], is_line=name == "says")
        except re.error as error:
            raise self._wrong(f"this is not a regular expression: {error}") from None
        if name == "finds":
            card.finds += (pattern,)
        elif name == "line":
            card.line = pattern
        else:
            card.patterns += (pattern,)

    def _begin(self, language: str, text: str) -> None:
        if language not in LANGUAGES or language in self._said:
            raise self._wrong(f"each card speaks each of {', '.join(LANGUAGES)} once")
        self._language = language
        self._said[language] = ([text], [], [], [])

    def _say(self, line: str) -> None:
        means, checks, robot, finding = self._said[self._language]
        if line.startswith("! "):
            finding.append(line[2:].replace("{first}", means[0]))
        elif finding:
            raise self._wrong("nothing comes after the finding")
        elif line.startswith("> "):
            robot.append(line[2:])
        elif robot:
            raise self._wrong("nothing comes after the real robot")
        elif re.match(r"\d+\. ", line):
            if not line.startswith(f"{len(checks) + 1}. "):
                raise self._wrong(f"the next check has the number {len(checks) + 1}")
            checks.append(line.partition(" ")[2])
        elif checks:
            raise self._wrong("after the checks come only '> …' and the next language")
        else:
            means.append(line)

    def _finish(self) -> None:
        """Look at the whole card."""
        if not self._cards:
            return
        card = self._cards[-1]
        for language in LANGUAGES:
            if language not in self._said:
                raise self._wrong(f"the card {card.id} says nothing in '{language}'", self._begun)
            means, checks, robot, finding = self._said[language]
            join = "" if language == "zh" else " "
            card.words[language] = CardWords(
                means[0], join.join(means[1:]), tuple(checks), join.join(robot), join.join(finding)
            )
        self._said, self._language = {}, ""
        if not card.patterns:
            raise self._wrong(f"the card {card.id} matches nothing", self._begun)
        shapes = {
            (len(each.checks), bool(each.robot), frozenset(names_of(each.finding))) for each in card.words.values()
        }
        if len(shapes) > 1:
            raise self._wrong(f"the card {card.id} says less in one language", self._begun)
        ((count, has_robot, _),) = shapes
        if has_robot == card.same:
            raise self._wrong(f"the card {card.id} needs either '> …' about a real robot or '- same'", self._begun)
        if card.look and not count:
            raise self._wrong(
                f"the card {card.id} looks around, so it needs checks for when it finds nothing", self._begun
            )
        self._check_names(card)

    def _check_names(self, card: Card) -> None:
        """Every name in a text is found by every pattern of the card."""
        known = set(KNOWN_VALUES).union(set.intersection(*(pattern.names for pattern in card.patterns)))
        known |= card.line.names if card.line is not None else set()
        for words in card.words.values():
            for text in (words.first, words.more, *words.checks, words.robot, card.next):
                try:
                    named = names_of(text)
                except ValueError as error:
                    raise self._wrong(f"the card {card.id}: {error} (a brace is written twice)", self._begun) from None
                if named - known:
                    raise self._wrong(
                        f"the card {card.id} fills in {min(named - known)}, which is not found", self._begun
                    )

    def close(self, last: int) -> list[Card]:
        self._number = last
        self._finish()
        return self._cards


@lru_cache(maxsize=1)
def topics() -> dict[str, tuple[dict[str, str], list[Card]]]:
    """Return all topics in their order: titles and cards. Raises CardError."""
    return {name: read_topic(FOLDER / f"{name}.md") for name in TOPICS if (FOLDER / f"{name}.md").is_file()}


def all_cards() -> Iterator[Card]:
    """Return all cards in the order in which they are tried."""
    for _, cards in topics().values():
        yield from cards


def names_of(text: str) -> set[str]:
    """Return what a text fills in. Raises ValueError for a brace alone."""
    return {name for _, name, _, _ in Formatter().parse(text) if name is not None}


@lru_cache(maxsize=1)
def finding_cards() -> dict[str, Card]:
    """Return the cards with the sentence of a finding, by its key."""
    return {card.finding: card for card in all_cards() if card.words["en"].finding}

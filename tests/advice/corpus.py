"""The corpus of mistakes: how `mistakes/*.md` are read, played in a terminal, and judged.

A file is a family: whole programs that work, and mistakes, each of which changes one thing in them. It begins with a title; then

    ```python star.py shows: 第 3 步
    (a program that works, and what it prints when it does)
    ```

    ## id-of-the-mistake
    ```diff star.py
    -    def draw(self):
    +    def draw():
    ```
    - zh: `第 {line} 行` `def draw(self)`
    - en: `line {line}` `def draw(self)`

`zh` and `en` say what has to stand in the line that the pupil is told for it to name the true cause, and are written from the
mistake, never from what is told today; {line} is the first line that differs. A
mistake that replaces nothing brings files of its own. What is typed stands in a block `console`; without one it is
`python3 FILE`:

    $ python3 star.py        runs to its end (2$: in a second terminal)
    F6 key                   opens the inspector, and waits until it has found that
    $ ros2 launch …  # shows: text        goes on; the next line is typed when it has printed that
    ^C        ends what goes on (…: waits until it ends)

- `- harmless: card-id`: what is told is general and true but doesn't name the cause (`none`: nothing is told). This is the
  judgement of whoever wrote it, and holds for this card alone.
- `- silent`: nothing is wrong, and so nothing may be told.

What is told is the grey line below the output; where there is none, what the inspector (F6) finds in what goes on, and where
that is nothing, too, what `why` says.
"""

from __future__ import annotations

import re
from collections.abc import Iterator
from dataclasses import dataclass, field
from functools import lru_cache, partial
from pathlib import Path
from typing import TYPE_CHECKING, NamedTuple

from day6_core.advice.matching import cards_in
from day6_core.advice.texts import TEXTS
from day6_core.session.plain import without_sequences
from day6_core.shell.terminal import Terminal
from day6_tui.locale import Texts

if TYPE_CHECKING:
    from tests.inspector.lab import Lab

FOLDER = Path(__file__).parent / "mistakes"

_PROGRAM = re.compile(r"\w+ (\S+)(?: shows: (.+))?$")
_LINE = re.compile(r"(\d*)(?:\$ (.+?)|(\^C|…|F6 \w+))(?:  # shows: ?(.*))?$")
WAIT = "…"
"""What is written for waiting until what goes on has ended."""

HINT = re.compile(r"^(?:提示：|意思：|hint: )(.+)", re.MULTILINE)
_ITEM = re.compile(r"- (zh|en|harmless|silent)(?:: (.+))?$")


class Typed(NamedTuple):
    """A line that is typed, '' for Ctrl-C; with `shows` it goes on, and is waited for until it has printed that."""

    terminal: int
    line: str
    shows: str | None = None


@dataclass
class Mistake:
    """One mistake: the files with it, what is typed, and what would be right to say."""

    id: str
    family: str
    files: dict[str, str]
    typed: list[Typed] = field(default_factory=list)
    line: int = 0
    """The line with the mistake."""
    right: dict[str, list[str]] = field(default_factory=dict)
    harmless: str = ""
    silent: bool = False


@dataclass
class Family:
    """The programs of a file, which work, and the mistakes in them."""

    name: str
    files: dict[str, str] = field(default_factory=dict)
    shows: dict[str, str] = field(default_factory=dict)
    mistakes: list[Mistake] = field(default_factory=list)


# -- reading -----------------------------------------------------------------------------------------------------------


@lru_cache(maxsize=1)
def families() -> list[Family]:
    """Return all that is written in `mistakes`. Raises ValueError for what is not written as it has to be."""
    return [_read(path) for path in sorted(FOLDER.glob("*.md"))]


def mistakes() -> list[Mistake]:
    """Return all mistakes, in the order of their files."""
    return [mistake for family in families() for mistake in family.mistakes]


def _read(path: Path) -> Family:
    family = Family(path.stem)
    lines = iter(path.read_text(encoding="utf-8").split("\n"))
    for line in lines:
        if line.startswith("## "):
            family.mistakes.append(Mistake(line[3:], family.name, dict(family.files)))
        elif line.startswith("```"):
            _take(family, line[3:], "".join(f"{each}\n" for each in iter(lambda: next(lines), "```")))
        elif (item := _ITEM.match(line)) is not None:
            _note(family.mistakes[-1], item[1], item[2] or "")
        elif line and not line.startswith("# "):
            raise ValueError(f"{path.name}: {line}")
    for mistake in family.mistakes:
        _finish(mistake)
    return family


def _take(family: Family, head: str, text: str) -> None:
    """A block: a program, a change of one, or what is typed."""
    mistake = family.mistakes[-1] if family.mistakes else None
    if head == "console" and mistake is not None:
        mistake.typed = list(map(_typed, text.splitlines()))
        return
    named = _PROGRAM.match(head)
    if named is None:
        raise ValueError(f"a block begins with its kind and the file's name: {head}")
    name, shows = named.groups()
    if mistake is None:
        family.files[name] = text
        if shows:
            family.shows[name] = shows
    elif head.startswith("diff "):
        mistake.files[name], mistake.line = _changed(mistake.files[name], text, mistake.id)
        mistake.typed = mistake.typed or [Typed(0, f"python3 {name}")]
    else:
        mistake.files[name] = text
        mistake.typed = mistake.typed or [Typed(0, f"python3 {name}")]


def _changed(text: str, change: str, mistake: str) -> tuple[str, int]:
    """A text in which the lines with - gave way to those with +, and the first line that differs."""
    old = "".join(line[1:] for line in change.splitlines(keepends=True) if line[0] in "- ")
    new = "".join(line[1:] for line in change.splitlines(keepends=True) if line[0] in "+ ")
    if text.count(old) != 1 or not old:
        raise ValueError(f"{mistake}: what it replaces stands {text.count(old)} times in the file")
    before = change.splitlines().index(next(line for line in change.splitlines() if line[0] in "+-"))
    return text.replace(old, new), text[: text.index(old)].count("\n") + before + 1


def _typed(text: str) -> Typed:
    found = _LINE.match(text)
    if found is None:
        raise ValueError(f"typed is '$ …' or '^C': {text}")
    return Typed(int(found[1] or 1) - 1, found[2] or found[3].removeprefix("^C"), found[4])


def _note(mistake: Mistake, name: str, value: str) -> None:
    if name == "silent":
        mistake.silent = True
    elif name == "harmless":
        mistake.harmless = value
    else:
        mistake.right[name] = re.findall(r"`([^`]+)`", value)


def _finish(mistake: Mistake) -> None:
    if mistake.silent == bool(mistake.right) or not mistake.typed:
        raise ValueError(f"{mistake.id}: it says what is right in zh and en, or that nothing is; and what is typed")
    for language, wanted in mistake.right.items():
        mistake.right[language] = [each.replace("{line}", str(mistake.line)) for each in wanted]


# -- playing -----------------------------------------------------------------------------------------------------------


class Told(NamedTuple):
    """A sentence that the pupil was told, and the card of the output that it stands below ('' for none)."""

    text: str
    card: str = ""


def play(lab: Lab, files: dict[str, str], typed: list[Typed], language: str) -> list[Told]:
    """Write the files, type the lines; return what is told."""
    for name, text in files.items():
        lab.file(name, text)
    for terminal, line, shows in typed:
        if line == WAIT:
            lab.wait(partial(_is_idle, lab.terminal(terminal)))
        elif line.startswith("F6 "):
            assert lab.finds(line.removeprefix("F6 "))[0] is not None, sorted(lab.findings)
        elif not line:
            lab.interrupt(terminal)
        elif shows is None:
            lab.run(line, terminal)
        else:
            lab.start(line, terminal, shows)
    return list(below(lab)) or list(_alarms(lab, Texts(language))) or list(_asked(lab, typed[-1].terminal))


def below(lab: Lab) -> Iterator[Told]:
    """The hints, and the first lines of cards."""
    for terminal in lab.terminals:
        for run in terminal.runs.all:
            for text in HINT.findall(without_sequences(run.output)):
                match = next(cards_in(run.output), None)
                yield Told(text, match.card.id if match is not None else "")


def _asked(lab: Lab, terminal: int) -> Iterator[Told]:
    """What `why` says the message means, and what it has found to be the cause here."""
    if goes_on(lab.terminal(terminal)):
        lab.interrupt(terminal)
    runs = reversed(lab.terminal(terminal).runs.all)
    cards = [match.card.id for run in runs for match in cards_in(run.output)]
    number = next((number for number, card in enumerate(cards, 1) if card != "ctrl-c"), 0)
    if not number:
        return
    parts = without_sequences(lab.run(f"why {number}", terminal)).replace("\r", "").split("\n\n")
    said = {
        head: " ".join(map(str.strip, rest.split("\n"))) for head, _, rest in (part.partition("\n") for part in parts)
    }
    heads = [text for key in ("card.means", "card.here") for text in TEXTS[key]]
    unknown = TEXTS["card.unknown"]
    told = [text for head, text in said.items() if head in heads and not text.startswith(unknown)]
    if told:
        yield Told(" ".join(told), cards[number - 1])


def _alarms(lab: Lab, texts: Texts) -> Iterator[Told]:
    """What the inspector finds wrong with what goes on, once nothing changes any more."""
    if any(map(goes_on, lab.terminals)):
        lab.settle()
        for key, each in lab.findings.items():
            if each.level != "info" and key != "late":  # that this computer is too slow is no mistake of the pupil's
                yield Told(each.of_card(texts.language) or texts(each.id, **dict(each.parameters)), key)


def _is_idle(terminal: Terminal) -> bool:
    return not goes_on(terminal)


def goes_on(terminal: Terminal) -> bool:
    """Whether anything of what was typed there has not ended."""
    terminal.update()
    return any(run.status is None for run in terminal.runs.all)


# -- judging -----------------------------------------------------------------------------------------------------------


def judged(mistake: Mistake, told: list[Told], language: str) -> str:
    """Return `right`, `harmless` or `wrong`."""
    if mistake.silent:
        return "wrong" if told else "harmless"
    if any(_fits(each.text, mistake.right[language]) for each in told):
        return "right"
    general = all(each.card == mistake.harmless for each in told) if told else mistake.harmless == "none"
    return "harmless" if general else "wrong"


def recorded(mistake: Mistake) -> str:
    """Return how the mistake was judged when it was written down."""
    return "harmless" if mistake.silent or mistake.harmless else "right"


def _fits(text: str, wanted: list[str]) -> bool:
    return all(each in text for each in wanted)

"""No text that a user reads has the worst words of our own English: a German word order, or a word with another meaning."""

from __future__ import annotations

import re
from collections.abc import Callable, Iterator

import pytest

from day6_core.advice import texts as advice_texts
from day6_core.lessons.texts import TEXTS as LESSON_TEXTS
from day6_core.shell import manual
from day6_tui.locale import catalogue
from tests.support.source_files import ROOT

BETTER = {
    r"\banew\b": "again",
    r"\bfound out\b": "detected",
    r"\bmend(s|ed|ing)?\b": "fix",
    r"\bworked off\b": "processed",
    r"\bof one's own\b": "your own",
    r"\bother than it meant\b": "not as intended",
    r"\b(?:[Ii]t|[Tt]h(?:is|at)|[}`'\"]) is no (?!longer\b|more\b|match\b|\w+ (?:way|one)\b)[a-z]": "isn't a …",
    r"\bthere is to see\b": "you can see",
    r"\bwhich is told\b|\b(?:is|are) told by\b": "… shows",
    r"\b(?:a|no|each|every|with|four|eight) blanks?\b": "space",
    r"\bas long as one\b|\bif one (?:has|is|wants)\b": "you",
    r"\bgoes on in the background\b": "keeps running in the background",
}
"""What a machine can judge alone -> what a native speaker writes."""

PAGES = (
    "*.md",
    "tests/README.md",
    "docs/en/**/*.md",
    "core/day6_core/advice/cards/*.md",
    "core/day6_core/lessons/**/*.md",
)


def english_of_tables() -> Iterator[tuple[str, str]]:
    """Yield (place, text) of every English text in a table."""
    yield from catalogue("en").items()
    yield from ((key, pair[0]) for table in (advice_texts.TEXTS, LESSON_TEXTS) for key, pair in table.items())
    yield from ((name, manual.page(name, "en") or "") for name in ("man", "ls", "source", "why", "colcon"))


def english_of_pages() -> Iterator[tuple[str, str]]:
    """Yield (place, line) of every line of our pages that is prose: no block of code, no pattern of a card."""
    for path in sorted({path for pattern in PAGES for path in ROOT.glob(pattern)}):
        fence = ""
        for number, line in enumerate(path.read_text(encoding="utf-8").splitlines(), 1):
            if found := re.match(r"\s*(~~~|```)", line):
                fence = "" if fence else found[1]
            elif not fence and not re.match(r"- (?:says|match|finds|line|from): ", line):
                yield f"{path.relative_to(ROOT)}:{number}", re.sub(r"`[^`]*`", "``", line)


def wrong(text: str) -> list[str]:
    """Return what is wrong with a text: each bad word with the better one."""
    return [f"{found[0]!r} → {better}" for word, better in BETTER.items() if (found := re.search(word, text))]


@pytest.mark.parametrize("texts", [english_of_tables, english_of_pages])
def test_no_text_has_a_word_of_our_own_english(texts: Callable[[], Iterator[tuple[str, str]]]) -> None:
    every = list(texts())
    assert len(every) > 1000
    faults = [f"{place}: {', '.join(found)}" for place, text in every if (found := wrong(text))]
    assert not faults, "\n".join(faults)


@pytest.mark.parametrize(
    "text",
    [
        "this is no number",
        "made anew",
        "'x' is no file",
        "it is told by echo",
        "a blank after the colon",
        "fault mended",
    ],
)
def test_such_a_word_is_noticed(text: str) -> None:
    assert wrong(text)


@pytest.mark.parametrize(
    "text", ["there is no node", "it is no longer valid", "nobody told bash", "fill in the blanks"]
)
def test_plain_english_is_not(text: str) -> None:
    assert not wrong(text)

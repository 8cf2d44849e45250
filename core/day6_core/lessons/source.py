"""The files of teachers as text: front matter, YAML, and every mistake with its line, so that all are mended in one go."""

from __future__ import annotations

import re
from collections.abc import Iterable
from dataclasses import dataclass
from pathlib import Path
from typing import Any, Protocol

from day6_core.language import LANGUAGES
from day6_core.lessons.flaws import Flaw, MarkedMap, line_of, meant
from day6_core.lessons.plain_yaml import NotYaml, read_yaml
from day6_core.ros.differences import retold

NAME = re.compile(r"[a-z0-9][a-z0-9_-]*\Z")
LARGEST = 1_000_000
"""Bytes of a file."""

_CONTROL = re.compile(r"[\x00-\x08\x0b-\x1f\x7f-\x9f\u202a-\u202e\u2066-\u2069]")


@dataclass(frozen=True)
class Mistake:
    """What is wrong with a file, and where (line from 1)."""

    line: int
    text: str
    warning: bool = False
    """Whether it is a matter of taste."""


class LessonMistakes(Exception):
    """A file of a lesson, drill or grading that cannot be used."""

    def __init__(self, path: Path, mistakes: list[Mistake]) -> None:
        self.path = path
        self.mistakes = sorted(mistakes, key=lambda each: each.line)
        super().__init__("\n".join(f"{path.name}:{each.line}: {each.text}" for each in self.mistakes))


class LessonPart(Protocol):
    """A step or a scenario."""

    @property
    def name(self) -> str: ...
    @property
    def line(self) -> int: ...
    @property
    def needs(self) -> tuple[str, ...]: ...


_OURS = Path(__file__).resolve().parent
"""What is below is written for the usual distribution, and told for the present one."""


class LessonSource:
    """One file that is being read. Raises LessonMistakes if it is no text, or OSError where there is none."""

    def __init__(self, path: Path, data: bytes | None = None) -> None:
        """`data`: what is in it, where it may be closed to this process."""
        if data is None:
            if path.stat().st_size > LARGEST:
                raise LessonMistakes(path, [Mistake(1, f"the file is larger than {LARGEST} bytes")])
            data = path.read_bytes()
        try:
            text = data.decode("utf-8-sig")
        except UnicodeDecodeError as error:
            line = data[: error.start].count(b"\n") + 1
            told = "the file is not UTF-8: save it again, in your editor, with the encoding UTF-8"
            raise LessonMistakes(path, [Mistake(line, told)]) from None
        self.stretched = 0
        """By how many columns a row may have grown because another distribution's names are longer."""
        if _OURS in path.resolve().parents and (told := retold(text)) != text:
            pairs = zip(text.splitlines(), told.splitlines(), strict=True)
            self.stretched = max(len(new) - len(old) for old, new in pairs)
            text = told
        self.path = path
        self.lines = text.replace("\r\n", "\n").split("\n")
        self._mistakes: list[Mistake] = []
        self.remarks: list[Mistake] = []
        """What does not make the file useless, and has to be mended (or thought of: a warning) before it is given to a class."""
        for number, row in enumerate(self.lines, 1):
            if _CONTROL.search(row):
                self.wrong(number, "a control character: it could disturb the terminal")

    def wrong(self, line: int, text: str) -> None:
        """Note a mistake; reading goes on."""
        self._mistakes.append(Mistake(line, text))

    def flaw(self, line: int, what: str, flaw: str) -> None:
        """Note a mistake in `what`, in its own line if that is known."""
        self.wrong(flaw.line or line if isinstance(flaw, Flaw) else line, f"{what}: {flaw}")

    def remark(self, line: int, text: str, *, warning: bool = False) -> None:
        """Note what `lessons check` tells; the file can be used."""
        self.remarks.append(Mistake(line, text, warning))

    def judge(self) -> None:
        """Raise LessonMistakes if anything was wrong."""
        if self._mistakes:
            raise LessonMistakes(self.path, self._mistakes)

    def front_matter(self, first: str) -> tuple[MarkedMap, int]:
        """What stands between the two '---', and the index of the line after; `first` is its usual first key.

        Raises LessonMistakes where there is none: nothing can be said of the rest.
        """
        if self.lines[0].strip() != "---":
            self.wrong(1, f"the file has to begin with '---', then '{first}: NAME' …, then '---'; is this a lesson?")
            self.judge()
        end = next((at for at, line in enumerate(self.lines[1:], 1) if line.strip() == "---"), None)
        if end is None:
            self.wrong(1, "the '---' that ends the front matter is missing: it stands below the last of 'key: value'")
            self.judge()
        assert end is not None
        return self.yaml("\n".join(self.lines[1:end]) + "\n", 2), end + 1

    def yaml(self, text: str, line: int) -> MarkedMap:
        """'key: value' lines that begin in `line`; empty if there are none, and `broken` if they are no YAML."""
        broken = MarkedMap()
        broken.broken, broken.line = True, line
        try:
            found, twice = read_yaml(text, line)
        except NotYaml as error:
            self.wrong(error.flaw.line, f"not YAML: {error.flaw}")
            return broken
        for each in twice:
            self.wrong(each.line, each)
        if found is None:
            found = MarkedMap()
            found.line = line
        if not isinstance(found, MarkedMap):
            self.wrong(line, "expected 'key: value' lines")
            return broken
        return found

    def judge_keys(self, found: dict[str, Any], known: Iterable[str], line: int) -> bool:
        """Note the keys that do not exist; returns whether there were any."""
        unknown = [key for key in found if key not in known]
        for key in unknown:
            self.wrong(line_of(found, key) or line, f"unknown key '{key}'{meant(key, sorted(known))}")
        return bool(unknown)

    def title(self, head: dict[str, Any]) -> dict[str, str]:
        """The title of the file in every language."""
        title = head.get("title")
        if isinstance(title, dict) and all(isinstance(title.get(each), str) for each in LANGUAGES):
            return title
        if "title" in head or not getattr(head, "broken", False):
            self.wrong(
                line_of(head, "title") or 1, "'title' needs a text for 'zh' and for 'en', each in a line below it"
            )
        return {}

    def list(self, data: dict[str, Any], key: str, line: int) -> list[Any]:
        """A list of the YAML at `line`; empty if it is not there."""
        found = data.get(key)
        if found is None:
            return []
        if not isinstance(found, list):
            self.wrong(line_of(data, key) or line, f"'{key}' has to be a list: lines that begin with '- '")
            return []
        return found

    def judge_parts(self, parts: Iterable[LessonPart], kind: str) -> None:
        """Note names that are there twice, and needs of what does not come before."""
        names: list[str] = []
        for part in parts:
            if part.name in names:
                self.wrong(part.line, f"there are two {kind}s '{part.name}'")
            for needed in part.needs:
                if needed not in names:
                    self.wrong(part.line, f"needs: no earlier {kind} is called '{needed}'")
            names.append(part.name)
        if not names:
            self.wrong(len(self.lines), f"there is no {kind}: one begins with '# name'")

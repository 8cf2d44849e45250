"""Reads the commands of a CMakeLists.txt, as far as packages without C++ use them."""

from __future__ import annotations

import re
import textwrap
from collections.abc import Iterator, Mapping
from dataclasses import dataclass
from pathlib import Path

_COMMAND = re.compile(r"(?m)^[ \t]*([A-Za-z_]\w*)[ \t]*\(")
_WIDTH = 77
"""Cells of a line of an error, in which CMake sets its paragraphs."""
_WORD = re.compile(r'\s*(?:"((?:[^"\\]|\\.)*)"|([^\s"()#]+)|(\()|(\))|(#[^\n]*))')


class CMakeError(ValueError):
    """A command that CMake refuses; `line` is where it begins, `command` its name ('' for an error of the text itself)."""

    def __init__(self, text: str, line: int, command: str) -> None:
        super().__init__(text)
        self.line = line
        self.command = command

    def __str__(self) -> str:
        where = f" ({self.command})" if self.command else ""
        body = "\n".join(_set(line) for line in self.args[0].splitlines())
        return f"CMake Error at CMakeLists.txt:{self.line}{where}:\n{body}\n\n\n"


def _set(paragraph: str) -> str:
    """Break a paragraph as CMake does; one that begins with a space stays as it is."""
    if paragraph.startswith(" "):
        return f"  {paragraph}"
    indent = "  "
    return textwrap.fill(
        paragraph.replace(".  ", ".\0 "),  # two spaces behind a sentence stay
        _WIDTH,
        initial_indent=indent,
        subsequent_indent=indent,
        break_long_words=False,
        break_on_hyphens=False,
    ).replace("\0", " ")


@dataclass(frozen=True)
class Command:
    """One call. `words` are its arguments with variables filled in."""

    name: str
    words: list[str]
    line: int

    def after(self, keyword: str, *ends: str) -> list[str]:
        """Return the arguments behind a keyword, up to one of `ends`."""
        if keyword not in self.words:
            return []
        found = []
        for word in self.words[self.words.index(keyword) + 1 :]:
            if word in ends:
                break
            found.append(word)
        return found


def read_commands(text: str, variables: Mapping[str, str]) -> list[Command]:
    """Return the commands in their order, without those that only a test build runs. Raises CMakeError for a broken text."""
    text = _without_comments(text)
    known = dict(variables)
    commands: list[Command] = []
    skipped = 0
    at = 0
    while match := _COMMAND.search(text, at):
        line = text.count("\n", 0, match.start(1)) + 1
        words, at = _arguments(text, match.end(), line)
        name = match.group(1).lower()
        words = [part for word in words for part in _filled(word, known)]
        if skipped or (name == "if" and words[:1] == ["BUILD_TESTING"]):
            skipped += (name == "if") - (name == "endif")
            continue
        if name == "set" and words:
            known[words[0]] = ";".join(words[1:])
        elif name == "list" and words[:1] == ["APPEND"] and len(words) > 1:
            known[words[1]] = ";".join(filter(None, [known.get(words[1], ""), *words[2:]]))
        elif name == "file" and words[:1] in (["GLOB"], ["GLOB_RECURSE"]) and len(words) > 1:
            known[words[1]] = ";".join(_globbed(words[0], words[2:], Path(known.get("CMAKE_CURRENT_SOURCE_DIR", "."))))
        elif name == "project" and words:
            known["PROJECT_NAME"] = known["CMAKE_PROJECT_NAME"] = words[0]
        commands.append(Command(name, words, line))
    return commands


def _globbed(mode: str, words: list[str], folder: Path) -> Iterator[str]:
    """Yield the files that `file(GLOB …)` finds."""
    words = [word for word in words if word not in ("CONFIGURE_DEPENDS", "LIST_DIRECTORIES", "true", "false")]
    start = None
    if words[:1] == ["RELATIVE"] and len(words) > 1:
        start, words = folder / words[1], words[2:]
    for word in words:
        where, pattern = (folder / word).parent, Path(word).name
        for path in sorted(where.rglob(pattern) if mode == "GLOB_RECURSE" else where.glob(pattern)):
            yield (path.relative_to(start) if start is not None and start in path.parents else path).as_posix()


def _without_comments(text: str) -> str:
    """Blank comments, so that places stay the same."""
    return re.sub(r'"(?:[^"\\]|\\.)*"|#[^\n]*', lambda match: match[0] if match[0][0] == '"' else "", text)


def _arguments(text: str, at: int, line: int) -> tuple[list[str], int]:
    words: list[str] = []
    depth = 1
    while match := _WORD.match(text, at):
        at = match.end()
        quoted, plain, opening, closing, _ = match.groups()
        if quoted is not None:
            words.append(f'"{quoted}')
        elif plain is not None:
            words.append(plain)
        elif opening:
            depth += 1
        elif closing:
            depth -= 1
            if not depth:
                return words, at
    raise CMakeError('Parse error.  Function missing ending ")".  End of file reached.', line, "")


def _filled(word: str, variables: Mapping[str, str]) -> list[str]:
    quoted = word.startswith('"')
    value = re.sub(r"\$\{(\w+)\}", lambda match: variables.get(match[1], ""), word[1:] if quoted else word)
    return [value] if quoted else [part for part in value.split(";") if part]

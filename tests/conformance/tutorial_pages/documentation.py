"""The blocks of a page of the documentation: what is typed, what is shown, what belongs into files, and the words before each.

A page is read from a branch of a local clone. Of reStructuredText this knows what decides that: directives and their bodies,
tabs, included files, literal blocks, headings. Its macros (`{DISTRO}`) are those of the documentation's own conf.py.
"""

from __future__ import annotations

import re
import subprocess
from collections.abc import Iterator
from dataclasses import dataclass
from pathlib import Path, PurePosixPath

from day6_core.ros.differences import value

ELSEWHERE = ("macos", "windows", "rhel", "fedora", "opensplice", "powershell")
"""Tabs of other systems: nobody reads two."""
CPLUSPLUS = "c++"

_DIRECTIVE = re.compile(r"(?P<indent> *)\.\. (?P<name>[a-z-]+):: *(?P<argument>.*)$")
_OPTION = re.compile(r" *:([a-z-]+): *(.*)$")
_RULE = re.compile(r"([=\-^~\"'#*+`])\1{2,}\s*$")
_BODIES = {
    "note",
    "warning",
    "tip",
    "tabs",
    "hint",
    "important",
    "caution",
    "attention",
    "seealso",
    "container",
    "dropdown",
}


@dataclass(frozen=True)
class Block:
    """A block of a page: `text` without its indentation, and the words between the block before and this one."""

    language: str
    text: str
    before: str
    heading: str
    line: int
    tab: str
    since: str
    """The same, with what stood before the heading."""
    option: str = ""
    """A caption or a name that the block has."""


class Documentation:
    """A branch of a clone, bare or not."""

    def __init__(self, clone: Path, branch: str) -> None:
        self._clone = clone
        self.branch = branch
        self.macros = {
            "DISTRO": branch,
            "DISTRO_TITLE": branch.title(),
            "DISTRO_TITLE_LOWER": branch,
            "REPOS_FILE_BRANCH": branch,
        }

    def read(self, path: str) -> str:
        """Return a file of the branch; FileNotFoundError where there is none."""
        done = subprocess.run(["git", "-C", str(self._clone), "show", f"{self.branch}:{path}"], capture_output=True)
        if done.returncode:
            raise FileNotFoundError(done.stderr.decode(errors="replace").strip())
        text = done.stdout.decode("utf-8", "replace").expandtabs(8)
        for name, macro in self.macros.items():
            text = text.replace(f"{{{name}}}", macro)
        return as_of_today(text)

    def pages(self, under: str) -> list[str]:
        """Return the pages below a folder, sorted."""
        done = subprocess.run(
            ["git", "-C", str(self._clone), "ls-tree", "-r", "--name-only", self.branch, under + "/"],
            capture_output=True,
            check=True,
        )
        return sorted(path for path in done.stdout.decode().split("\n") if path.endswith(".rst"))

    def read_beside(self, page: str, path: str) -> str:
        """Return a file by its path as a page writes it."""
        return self.read(beside(page, path))

    def blocks(self, page: str) -> list[Block]:
        """Return the blocks of a page in their order, those of other systems left out."""
        return _Reader(self, page).blocks()


class _Reader:
    def __init__(self, documentation: Documentation, page: str) -> None:
        self._documentation = documentation
        self._page = PurePosixPath(page)
        self._words: list[str] = []
        self._since: list[str] = []
        self._heading = ""

    def blocks(self) -> list[Block]:
        lines = self._documentation.read(str(self._page)).splitlines()
        return list(self._body(list(enumerate(lines, 1)), ""))

    def _body(self, lines: list[tuple[int, str]], tab: str) -> Iterator[Block]:
        at = 0
        while at < len(lines):
            number, line = lines[at]
            directive = _DIRECTIVE.match(line)
            if directive is not None:
                end = _end_of_body(lines, at, len(directive["indent"]))
                yield from self._directive(
                    directive["name"], directive["argument"].strip(), lines[at + 1 : end], number, tab
                )
                at = end
                continue
            at += 1
            if at < len(lines) and _RULE.match(lines[at][1].strip()) and line.strip() and not _RULE.match(line.strip()):
                self._heading = line.strip()
                self._words = []
                at += 1
                continue
            self._words.append(line.strip())
            self._since.append(line.strip())
            if line.rstrip().endswith("::") and not line.lstrip().startswith(".. "):
                end = _end_of_body(lines, at - 1, len(line) - len(line.lstrip()))
                if end > at and any(each.strip() for _, each in lines[at:end]):
                    yield self._block("", _dedent([each for _, each in lines[at:end]]), number, tab)
                    at = end

    def _directive(
        self, name: str, argument: str, body: list[tuple[int, str]], number: int, tab: str
    ) -> Iterator[Block]:
        options: dict[str, str] = {}
        while body and (option := _OPTION.match(body[0][1])):
            options[option[1]] = option[2].strip()
            body = body[1:]
        shown = options.get("caption") or options.get("name") or ""
        if name in ("code-block", "code", "sourcecode", "parsed-literal"):
            yield self._block(argument.lower(), _dedent([line for _, line in body]), number, tab, shown)
        elif name == "literalinclude":
            language = options.get("language", "").lower() or PurePosixPath(argument).suffix.lstrip(".")
            text = self._documentation.read_beside(str(self._page), argument)
            yield self._block(language, _chosen(text, options), number, tab, shown or argument)
        elif name == "include":
            lines = self._documentation.read_beside(str(self._page), argument).splitlines()
            yield from self._body([(number, line) for line in lines], tab)
        elif name in ("group-tab", "tab"):
            if not any(word in argument.lower() for word in ELSEWHERE):
                self._words.append(argument)
                self._since.append(argument)
                yield from self._body(body, argument)
        elif name in _BODIES:
            yield from self._body([(number, argument), *body] if argument else body, tab)

    def _block(self, language: str, text: str, number: int, tab: str, option: str = "") -> Block:
        before, since = ("\n".join(words).strip() for words in (self._words, self._since))
        self._words, self._since = [], []
        return Block(language, text, before, self._heading, number, tab, since, option)


def as_of_today(text: str) -> str:
    """Return a page, or a file that it fetches, with turtlesim's interfaces imported from where they are now.

    A clone may be older than what mended that (ros2/ros2_documentation#5526); such a program would fail on a real machine too.
    """
    return re.sub(r"\bturtlesim(?=\.(?:msg|srv)\b)", str(value("turtlesim.interfaces")), text)


def _end_of_body(lines: list[tuple[int, str]], at: int, indent: int) -> int:
    end = at + 1
    while end < len(lines) and (not lines[end][1].strip() or len(lines[end][1]) - len(lines[end][1].lstrip()) > indent):
        end += 1
    return end


def _dedent(lines: list[str]) -> str:
    widths = [len(line) - len(line.lstrip()) for line in lines if line.strip()]
    width = min(widths, default=0)
    return "\n".join(line[width:].rstrip() for line in lines).strip("\n")


def _chosen(text: str, options: dict[str, str]) -> str:
    lines = text.splitlines()
    if wanted := options.get("lines"):
        chosen: list[str] = []
        for part in wanted.split(","):
            first, dash, last = part.strip().partition("-")
            begin = int(first or 1)
            chosen += lines[begin - 1 : (int(last) if last else len(lines)) if dash else begin]
        return _dedent(chosen)
    return text.rstrip("\n")


def beside(page: str, path: str) -> str:
    """Return the path below the clone's root that a page means by a path of its own."""
    if path.startswith("/"):
        return "source" + path
    parts: list[str] = []
    for part in (PurePosixPath(page).parent / path).parts:
        if part == "..":
            parts.pop()
        elif part != ".":
            parts.append(part)
    return "/".join(parts)

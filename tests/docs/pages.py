"""The pages of the documentation and the other documents, read by markdown-it, the parser of CommonMark that Textual brings.

What a page says of its code blocks stands in docs/*/contributing/tests.md: their languages and the comments before them.
"""

from __future__ import annotations

import functools
import re
import textwrap
import unicodedata
from collections import Counter
from collections.abc import Iterator
from pathlib import Path
from typing import NamedTuple

from markdown_it import MarkdownIt
from markdown_it.token import Token

from tests.support.source_files import ROOT

DOCS = ROOT / "docs"
LANGUAGES = ("en", "zh")
RUN = ("console", "python", "sh")
"""The languages of blocks that are run."""
PARSED = ("yaml", "json", "toml", "xml")
READ = ("text", "markdown", "diff", "csv", "powershell")
"""Those that are only looked at."""
KINDS = ("run", "not run", "file")
WORDS = {
    "background": ("console", "python"),
    "timeout": ("console", "python"),
    "fails": RUN,
    "retry": ("console",),
}
"""What `run:` may say, and of which languages."""

_DIRECTIVE = re.compile(rf"<!-- *({'|'.join(KINDS)}): *(.*?) *-->\s*")
_PARSER = MarkdownIt("commonmark").enable("table")


class Block(NamedTuple):
    """A fenced block of code."""

    place: str
    """`docs/en/start.md:12`."""
    language: str
    kind: str
    """One of KINDS: "run" without a comment before it."""
    says: str
    """What follows the colon of the comment."""
    code: str

    @property
    def words(self) -> dict[str, str]:
        """What a `run:` says: {"timeout": "3", "background": ""}."""
        pairs = (word.strip().partition("=") for word in self.says.split(",") if self.kind == "run" and word.strip())
        return {name: value for name, _, value in pairs}


class Heading(NamedTuple):
    """A heading of a page."""

    level: int
    text: str


class Page:
    """A document."""

    def __init__(self, path: Path) -> None:
        self.path = path
        self.name = path.relative_to(ROOT).as_posix() if path.is_relative_to(ROOT) else path.name
        self.tokens = _PARSER.parse(path.read_text(encoding="utf-8"))

    @property
    def language(self) -> str:
        """That of its text: README.zh.md, docs/zh/start.md."""
        return "zh" if ".zh." in self.name or self.name.startswith("docs/zh/") else "en"

    @property
    def in_its_language(self) -> str:
        """Its name, which it shares with the page in the other language."""
        return self.path.relative_to(DOCS / self.language).as_posix()

    def headings(self) -> list[Heading]:
        """Return all headings, in order."""
        return [
            Heading(int(token.tag[1:]), _text(inline))
            for token, inline in zip(self.tokens, self.tokens[1:], strict=False)
            if token.type == "heading_open"
        ]

    @functools.cached_property
    def anchors(self) -> set[str]:
        """What `page.md#…` may name: each heading by GitHub's rules, and `<a id>`."""
        seen: Counter[str] = Counter()
        found = set()
        for heading in self.headings():
            slug = slug_of(heading.text)
            found.add(f"{slug}-{seen[slug]}" if seen[slug] else slug)
            seen[slug] += 1
        return found | {
            name for token in self._inside() for name in re.findall(r'<a (?:id|name)="(.+?)"', token.content)
        }

    def links(self) -> Iterator[tuple[str, str]]:
        """Yield kind, "href" or "src", and target of every link and picture."""
        for token in self._inside():
            for name in ("href", "src"):
                if token.type in ("link_open", "image") and token.attrs.get(name):
                    yield name, str(token.attrs[name])
                elif token.type in ("html_inline", "html_block"):
                    yield from ((name, found) for found in re.findall(rf'<\w[^>]* {name}="(.*?)"', token.content))

    def code_words(self) -> Iterator[str]:
        """Yield what stands in backquotes."""
        return (token.content for token in self._inside() if token.type == "code_inline")

    def blocks(self) -> Iterator[Block]:
        """Yield the blocks of code, each with what the comment before it says. AssertionError where a comment has no block."""
        said: tuple[str, str] | None = None
        for token in self.tokens:
            place = f"{self.name}:{(token.map or [0])[0] + 1}"
            found = _DIRECTIVE.fullmatch(token.content) if token.type == "html_block" else None
            if token.type in ("fence", "code_block"):
                yield Block(place, token.info.strip(), *(said or ("run", "")), token.content)
            else:
                assert said is None, f"{place}: the comment above it has to stand right before a block of code"
            said = (found[1], found[2]) if found else None
        assert said is None, f"{self.name}: its last comment has no block of code"

    def _inside(self) -> Iterator[Token]:
        for token in self.tokens:
            yield token
            yield from token.children or ()


def slug_of(heading: str) -> str:
    """Return GitHub's anchor of a heading: letters, digits, marks and "_" of any script stay, blanks become "-"."""
    kept = (c for c in heading.strip().lower() if c in " -_" or unicodedata.category(c)[0] in "LNM")
    return "".join(kept).replace(" ", "-")


def _text(inline: Token) -> str:
    return "".join(child.content for child in inline.children or () if child.type in ("text", "code_inline"))


@functools.cache
def page(path: Path) -> Page:
    """Read a document, once."""
    return Page(path)


def of_docs(language: str) -> dict[str, Page]:
    """Return the pages in a language by the names that both languages have."""
    return {each.in_its_language: each for each in map(page, sorted((DOCS / language).rglob("*.md")))}


def with_blocks() -> list[Page]:
    """Return all documents whose blocks of code are run."""
    return _found("README*.md", "CONTRIBUTING*.md", "docs/*/**/*.md")


def documents() -> list[Page]:
    """Return all documents whose links are followed."""
    return _found("*.md", "hub/*.md", "tests/README.md", ".github/**/*.md", "docs/*/**/*.md")


def _found(*patterns: str) -> list[Page]:
    return [page(path) for pattern in patterns for path in sorted(ROOT.glob(pattern))]


COMMENTS = {
    **dict.fromkeys(
        ("console", "python", "sh", "powershell", "yaml", "toml"), re.compile(r"(?:^|\s+)#(?!!).*$", re.MULTILINE)
    ),
    "xml": re.compile(r"\s*<!--.*?-->", re.DOTALL),
}


def same_in_both(block: Block) -> tuple[str, ...]:
    """Return what a block has to share with that of the other language: not its comments, nor what commands print."""
    code = "" if block.language in ("text", "markdown") else block.code
    if block.language == "console":
        code = "\n".join(line for command, _ in commands(block) for line in command.splitlines())
    code = COMMENTS[block.language].sub("", code) if block.language in COMMENTS else code
    lines = [line.rstrip() for line in textwrap.dedent(code).splitlines() if line.strip()]
    return (block.language, block.kind, block.says, *lines)


def commands(block: Block) -> list[tuple[str, list[str]]]:
    """Return the commands of a console block, each with the lines that it prints."""
    found: list[tuple[str, list[str]]] = []
    for line in block.code.splitlines():
        if line.startswith("$ "):
            found.append((line[2:], []))
        elif found and line.startswith("> ") and not found[-1][1]:
            found[-1] = (f"{found[-1][0]}\n{line[2:]}", [])
        else:
            assert found, f"{block.place}: the first line of a console block begins with '$ '"
            found[-1][1].append(line.rstrip())
    assert found, f"{block.place}: nothing is typed in this console block"
    return found

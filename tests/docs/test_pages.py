"""What holds of the documents without running them: both languages say the same, links lead somewhere, code can be read."""

from __future__ import annotations

import csv
import io
import json
import re
import shlex
import sys
import textwrap
import xml.etree.ElementTree as ET
from collections.abc import Callable
from pathlib import Path
from urllib.parse import unquote, urlsplit

import yaml

from tests.docs.command_lines import mistake, own
from tests.docs.pages import (
    DOCS,
    LANGUAGES,
    PARSED,
    READ,
    RUN,
    WORDS,
    Block,
    Page,
    commands,
    documents,
    of_docs,
    page,
    same_in_both,
    slug_of,
    with_blocks,
)
from tests.support.folded import folded
from tests.support.source_files import ROOT

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

PICTURES = DOCS / "pictures"
BLOCKS = [block for page in with_blocks() for block in page.blocks()]
PAIRS = [
    *((name, each, of_docs("zh").get(name)) for name, each in of_docs("en").items()),
    *(
        (path.name, page(path), page(path.with_suffix(".zh.md")))
        for path in ROOT.glob("*.md")
        if path.with_suffix(".zh.md").exists()
    ),
]


def test_both_languages_have_the_same_pages() -> None:
    assert [*of_docs("en")] == [*of_docs("zh")] != []


@folded("name, english, chinese", PAIRS, ids=lambda pair: pair[0])
def test_both_languages_have_the_same_headings_and_code(name: str, english: Page, chinese: Page | None) -> None:
    assert chinese is not None, f"{name} is missing in Chinese"
    levels = [[heading.level for heading in each.headings()] for each in (english, chinese)]
    assert levels[0] == levels[1]
    code = [[same_in_both(block) for block in each.blocks()] for each in (english, chinese)]
    assert code[0] == code[1]


@folded("each", documents(), ids=lambda each: each.name)
def test_every_link_leads_somewhere(each: Page) -> None:
    lost = [target for _, target in each.links() if _lost(each.path, target)]
    assert not lost, ", ".join(lost)


def _lost(document: Path, target: str) -> bool:
    """Whether a relative link leads nowhere: no file, no such heading, or out of the repository."""
    if urlsplit(target).scheme:
        return False
    path, _, anchor = unquote(target).partition("#")
    found = (document.parent / path).resolve() if path else document
    if not found.exists() or not found.is_relative_to(ROOT):
        return True
    return bool(anchor) and not (found.suffix == ".md" and anchor in page(found).anchors)


@folded("each", documents(), ids=lambda each: each.name)
def test_pictures_are_in_the_repository_and_in_the_language_of_their_page(each: Page) -> None:
    pictures = [target for kind, target in each.links() if kind == "src"]
    assert [target for target in pictures if urlsplit(target).scheme] == []
    other = {"en": ".zh.", "zh": ".en."}[each.language]
    assert [target for target in pictures if other in target] == []


@folded("each", [page for language in LANGUAGES for page in of_docs(language).values()], ids=lambda each: each.name)
def test_a_page_begins_with_its_only_title(each: Page) -> None:
    assert each.tokens[0].type == "heading_open"
    assert [heading.level for heading in each.headings()].count(1) == 1


@folded(
    "heading, slug",
    [
        ("Install and run", "install-and-run"),
        ("What `ros2 run` does, and why?", "what-ros2-run-does-and-why"),
        ("第 5 天：话题（topic）", "第-5-天话题topic"),
        ("A -- B", "a----b"),
        ("setup.py, __init__", "setuppy-__init__"),
    ],
)
def test_anchors_are_githubs(heading: str, slug: str) -> None:
    assert slug_of(heading) == slug


# -- blocks of code ----------------------------------------------------------------------------------------------------

Reader = Callable[[str], object]
READERS: dict[str, Reader] = {
    "yaml": lambda text: [*yaml.safe_load_all(text)],
    "json": json.loads,
    "toml": tomllib.loads,
    "xml": ET.fromstring,
    "csv": lambda text: [*csv.reader(io.StringIO(text), strict=True)],
    "python": lambda text: compile(text, "block", "exec"),
}


@folded("block", BLOCKS, ids=lambda block: block.place)
def test_a_block_of_code_names_its_language_and_can_be_read(block: Block) -> None:
    assert block.language in (*RUN, *PARSED, *READ)
    READERS.get(block.language, str)(textwrap.dedent(block.code))
    if block.language == "text":
        assert not re.search(r"^\$ ", block.code, re.MULTILINE), "what is typed is in a console block"


@folded("block", BLOCKS, ids=lambda block: block.place)
def test_the_comment_before_a_block_is_understood(block: Block) -> None:
    if block.kind == "run":
        assert [name for name in block.words if block.language not in WORDS.get(name, ())] == []
        assert all((name == "timeout") == bool(value) for name, value in block.words.items())
        float(block.words.get("timeout", 0))
    elif block.kind == "file":
        assert block.language in ("python", *PARSED, "markdown", "text", "csv")
        path = Path(block.says.removeprefix("~/"))
        assert not path.is_absolute() and ".." not in path.parts
    else:
        assert block.language in RUN and block.says, "a block that isn't run says why"


def test_pages_hold_no_html_but_comments() -> None:
    found = [
        f"{each.name}: {token.content.strip()}"
        for language in LANGUAGES
        for each in of_docs(language).values()
        for token in each.tokens
        for part in (token, *(token.children or ()))
        if part.type in ("html_block", "html_inline") and not re.fullmatch(r"<!--.*-->\s*", part.content, re.DOTALL)
    ]
    assert found == []


def test_every_picture_is_made_by_a_script_in_both_languages_and_used_where_its_language_is_read() -> None:
    shown = [
        (each, (each.path.parent / link).resolve())
        for each in documents()
        for kind, link in each.links()
        if kind == "src"
    ]
    there = set(PICTURES.glob("*.svg"))
    made = {PICTURES / f"{script.stem}.{language}.svg" for script in PICTURES.glob("*.yaml") for language in LANGUAGES}
    assert sorted(there ^ made) == []
    assert sorted(there - {picture for _, picture in shown}) == []
    foreign = [
        (page.name, path.name) for page, path in shown if path in made and path.suffixes[0] != f".{page.language}"
    ]
    assert foreign == []


# -- day6-tui in lines for a real shell --------------------------------------------------------------------------------


def _lines(block: Block) -> list[str]:
    if block.language == "console":
        return [command for command, _ in commands(block)]
    joined = block.code.replace("\\\n", " ").replace("`\n", " ")
    return [re.sub(r"(^|\s)#.*", "", line) for line in joined.splitlines()]


@folded(
    "place, words",
    [
        (block.place, words)
        for block in BLOCKS
        if block.language in ("console", "sh", "powershell")
        for line in _lines(block)
        if "day6-tui" in line
        for words in own(line)
    ],
    ids=lambda case: f"{case[0]} {shlex.join(case[1])}",
)
def test_every_day6_tui_of_a_block_is_a_command_with_its_options(place: str, words: list[str]) -> None:
    assert mistake(words) == ""


@folded(
    "line, right",
    [
        ("day6-tui", True),
        ("uv run day6-tui --scene turtle --lang zh", True),
        (".venv\\Scripts\\day6-tui --glyphs ascii", True),
        ("ros2 run car go 2>&1 | day6-tui why", True),
        ("day6-tui --distro humble ros2 topic list", True),
        ("day6-tui python wheel_spinner.py --ros-args -r a:=b", True),
        ("day6-tui lessons play FILE --step NAME", True),
        ("day6-tui serve --class pupils.csv --host 0.0.0.0", True),
        ('eval "$(day6-tui env)"', True),
        ("day6-tui --scene desert", False),
        ("day6-tui lessons paly FILE", False),
        ("day6-tui serve --clas pupils.csv", False),
        ("day6-tui why; day6-tui nothing", False),
    ],
)
def test_a_command_line_is_judged_by_the_parsers(line: str, right: bool) -> None:
    found = [*own(line)]
    assert found and all(mistake(words) == "" for words in found) is right

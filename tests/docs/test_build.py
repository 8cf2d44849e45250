"""What `.ci/docs` refuses, and how it understands pages that are CommonMark: with a documentation of two pages."""

from __future__ import annotations

import shutil
import sys
from pathlib import Path

import pytest

from tests.support.source_files import ROOT
from tests.support.waiting import run

pytestmark = pytest.mark.process

SETTINGS = """
order = ["index"]
[language.en]
name = "English"
description = "d"
sections = {}
"""
PAGE = """# Title
a paragraph:
- one
  - below it

  ```text
  code
  ```
- two

## 第 5 天：话题（topic）
一行，
又一行
接着
> 引用，
> 还是引用

see [above](#第-5-天话题topic), ![picture](../pictures/p.en.svg), [program](../../program.py)
| a | b |
| --- | --- |
| `x \\| y` | z |
"""


@pytest.fixture
def tree(tmp_path: Path) -> Path:
    """A repository with the settings of ours, and one page."""
    pytest.importorskip("zensical", reason="zensical is not installed (the extra docs)")
    for folder in (".ci", "docs/en", "docs/pictures"):
        (tmp_path / folder).mkdir(parents=True)
    shutil.copy(ROOT / ".ci" / "docs", tmp_path / ".ci" / "docs")
    shutil.copytree(ROOT / "docs" / "site", tmp_path / "docs" / "site")
    project = (ROOT / "docs" / "site" / "site.toml").read_text(encoding="utf-8").partition("[project]")
    (tmp_path / "docs" / "site" / "site.toml").write_text(SETTINGS + "".join(project[1:]), encoding="utf-8")
    (tmp_path / "docs" / "pictures" / "p.en.svg").write_text(
        "<svg xmlns='http://www.w3.org/2000/svg'/>", encoding="utf-8"
    )
    (tmp_path / "program.py").touch()
    (tmp_path / "pyproject.toml").write_text(
        '[tool.hatch.metadata.hooks.custom]\nrepository = "https://example.org/r"\n', encoding="utf-8"
    )
    (tmp_path / "docs" / "en" / "index.md").write_text(PAGE, encoding="utf-8")
    return tmp_path


def _built(tree: Path, more: str = "") -> tuple[int, str]:
    with open(tree / "docs" / "en" / "index.md", "a", encoding="utf-8") as file:
        file.write(more)
    done = run([sys.executable, str(tree / ".ci" / "docs")])
    return done.returncode, done.stderr


def test_a_page_of_commonmark_becomes_what_it_says(tree: Path) -> None:
    assert _built(tree) == (0, "")
    html = (tree / "build" / "site" / "en" / "index.html").read_text(encoding="utf-8")
    for part in (
        'src="pictures/p.en.svg"',
        'href="https://example.org/r/blob/main/program.py"',
        "<code>x | y</code>",
        "一行，又一行接着",
        "引用，\n还是引用",
    ):
        assert part in html


@pytest.mark.parametrize(
    ("more", "said"),
    [
        ("\n[lost](nowhere.md)\n", "page does not exist"),
        ("\n[lost](#nowhere)\n", "anchor does not exist"),
        ("\n![lost](../pictures/nowhere.svg)\n", "nowhere.svg leads nowhere"),
        ("\n![foreign](https://example.org/p.svg)\n", "from other hosts"),
        ("\n- one\n1. two\n", "not as CommonMark reads it"),
    ],
)
def test_what_is_wrong_with_a_page_fails(tree: Path, more: str, said: str) -> None:
    status, printed = _built(tree, more)
    assert status == 1
    assert said in printed


def test_a_page_without_a_place_in_the_order_fails(tree: Path) -> None:
    (tree / "docs" / "en" / "other.md").write_text("# Other\n", encoding="utf-8")
    status, printed = _built(tree)
    assert status == 1
    assert "['other.md']" in printed

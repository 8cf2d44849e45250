"""The built site in a real Chromium, opened from disk, as a class without internet has it: search and the switch of language."""

from __future__ import annotations

import subprocess
import sys
from collections.abc import Iterator
from typing import TYPE_CHECKING

import pytest

from tests.support.source_files import ROOT
from tests.support.waiting import run

if TYPE_CHECKING:
    from pathlib import Path

    from tests.web.chromium import Chromium, Page

pytestmark = pytest.mark.browser


@pytest.fixture(scope="module")
def site() -> Path:
    pytest.importorskip("zensical", reason="zensical is not installed (the extra docs)")
    done: subprocess.CompletedProcess[str] = run([sys.executable, str(ROOT / ".ci" / "docs")])
    assert done.returncode == 0, done.stdout + done.stderr
    return ROOT / "build" / "site"


@pytest.fixture
def page(chromium: Chromium) -> Iterator[Page]:
    made = chromium.page()
    yield made
    assert [url for url in made.requests if not url.startswith(("file:", "data:", "about:", "blob:"))] == []
    assert made.troubles == []
    made.close()


SEARCH = "[...document.querySelectorAll('body > div')].map(each => each.shadowRoot).find(Boolean)"
"""The search is a root of its own at the end of the page."""


@pytest.mark.parametrize(("language", "words"), [("en", "turtle"), ("zh", "海龟"), ("zh", "终端里的命令")])
def test_the_search_finds_words_without_a_server(page: Page, site: Path, language: str, words: str) -> None:
    page.device(1200, 800)
    page.navigate((site / language / "index.html").as_uri())
    page.click_on(".md-search__button")
    page.wait_for(f"{SEARCH}?.activeElement?.tagName === 'INPUT'")
    page.ask("Input.insertText", text=words)
    page.wait_for(f"{SEARCH}.querySelectorAll('a[href]').length > 0")


def test_the_switch_of_language_stays_on_the_page(page: Page, site: Path) -> None:
    page.navigate((site / "en" / "pupils" / "lessons.html").as_uri())
    page.evaluate("document.querySelector('.md-select__link[hreflang=zh]').click()")
    page.wait_for("document.readyState === 'complete' && document.documentElement.lang === 'zh'")
    assert page.evaluate("location.href") == (site / "zh" / "pupils" / "lessons.html").as_uri()


def test_the_first_page_leads_to_the_language_of_the_browser(page: Page, site: Path) -> None:
    page.navigate((site / "index.html").as_uri())
    page.wait_for(f"location.href === '{(site / 'en' / 'index.html').as_uri()}'")

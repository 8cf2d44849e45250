"""The pages that are made from the program are as the program is."""

from __future__ import annotations

from tests.docs.pages import DOCS, LANGUAGES
from tests.docs.reference import PAGES
from tests.support.folded import folded


@folded(
    "name, language", [(name, language) for name in PAGES for language in LANGUAGES], ids="docs/{0[1]}/{0[0]}".format
)
def test_a_page_says_what_the_program_says(name: str, language: str) -> None:
    path = DOCS / language / name
    written = path.read_text(encoding="utf-8") if path.exists() else ""
    assert written == PAGES[name](language), "stale: python -m tests.docs.reference writes it"

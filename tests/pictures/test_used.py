"""The pictures in our documents: each that is named is there, in the document's language, and each that is there is named."""

from __future__ import annotations

import re
from collections.abc import Iterator
from pathlib import Path

from tests.pictures.script import FOLDER, LANGUAGES, names
from tests.support.source_files import ROOT


def pictures() -> Iterator[tuple[Path, Path]]:
    """Yield each document and each picture of ours that it shows."""
    for document in [*ROOT.glob("*.md"), *(ROOT / "docs").rglob("*.md")]:
        for target in re.findall(
            r"!\[[^\]]+\]\(([^)\s]+\.svg)|<img [^>]*src=\"([^\"]+\.svg)", document.read_text("utf-8")
        ):
            path = "".join(target)
            if "/pictures/" in path:
                yield document, FOLDER / path.rpartition("/pictures/")[2]


def test_every_picture_is_there_and_speaks_the_documents_language() -> None:
    for document, picture in pictures():
        assert picture.is_file(), f"{document.name} shows {picture.name}"
        lang = "zh" if "zh" in (*document.relative_to(ROOT).parts, *document.name.split(".")) else "en"
        assert picture.name.endswith(f".{lang}.svg"), f"{document.name} shows {picture.name}"


def test_every_picture_is_used() -> None:
    used = {picture.name for _, picture in pictures()}
    assert used == {f"{name}.{lang}.svg" for name in names() for lang in LANGUAGES}

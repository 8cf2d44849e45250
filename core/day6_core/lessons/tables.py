"""Tables for a teacher: on the terminal, as CSV for a spreadsheet, as one HTML page that needs nothing from elsewhere."""

from __future__ import annotations

import csv
import io
import os
from collections.abc import Iterable, Mapping, Sequence
from html import escape
from pathlib import Path

from day6_core.session.harmless import one_line
from day6_core.whole_file import replace_file
from day6_core.width import text_width

_FORMULA = ("=", "+", "-", "@", "\t", "\r")
_STYLE = """\
body{font-family:"Noto Sans CJK SC","Microsoft YaHei","PingFang SC",system-ui,sans-serif;margin:2rem;color:#222;background:#fff}
table{border-collapse:collapse;margin:1rem 0}
th,td{border:1px solid #bbb;padding:.3rem .6rem;text-align:left;vertical-align:top}
th{background:#eee;white-space:nowrap}
td.number{text-align:right}
.good{background:#e2f3e2}.bad{background:#fbe3e0}.late{background:#fdf3d0}.open{background:#e8e8ee}
small{color:#666}
@media print{body{margin:0}}"""

_CHOICE = "#zh:checked~main [lang=en],#en:checked~main [lang=zh]{display:none}\n@media print{input,label{display:none}}"
_LANGUAGES = {"zh": "中文", "en": "English"}


class Exists(Exception):
    """A file is there already, and nobody said that it may be overwritten."""


class Cell(str):
    """A cell of an HTML table with a class: 'good', 'bad', 'number'."""

    __slots__ = ("kind",)
    kind: str

    def __new__(cls, text: object, kind: str = "") -> Cell:
        made = super().__new__(cls, text)
        made.kind = kind
        return made


class Texts(dict[str, str]):
    """A text in each language for a page that has all of them, with a class as of a cell."""

    def __init__(self, texts: Mapping[str, str], kind: str = "") -> None:
        super().__init__(texts)
        self.kind = kind


def text_table(head: Sequence[str], rows: Iterable[Sequence[object]]) -> str:
    """Columns two blanks apart; a Chinese character is two columns wide. What could disturb the terminal is written out."""
    table = [[one_line(str(cell)) for cell in row] for row in (head, *rows)]
    wide = [max(text_width(row[at]) for row in table) for at in range(len(head))]
    lines = ("  ".join(cell + " " * (wide[at] - text_width(cell)) for at, cell in enumerate(row)) for row in table)
    return "\n".join(line.rstrip() for line in lines)


def csv_bytes(head: Sequence[str], rows: Iterable[Sequence[object]]) -> bytes:
    """UTF-8 with the mark by which spreadsheets know it; no cell is a formula."""
    text = io.StringIO()
    writer = csv.writer(text, lineterminator="\r\n")
    for row in (head, *rows):
        writer.writerow([_plain(cell) for cell in row])
    return text.getvalue().encode("utf-8-sig", errors="replace")


def _plain(cell: object) -> object:
    if isinstance(cell, (int, float)):
        return cell
    text = one_line(str(cell))
    return f"'{text}" if text.startswith(_FORMULA) else text


def without_guard(text: str) -> str:
    """What was given to `csv_bytes` for a cell."""
    return text[1:] if text.startswith("'") and text[1:].startswith(_FORMULA) else text


def html_table(head: Sequence[object], rows: Iterable[Sequence[object]]) -> str:
    """A table; every cell is escaped."""
    found = ["<table>", "<tr>" + "".join(f"<th>{_written(cell)}</th>" for cell in head) + "</tr>"]
    for row in rows:
        cells = []
        for cell in row:
            kind = getattr(cell, "kind", "") or ("number" if isinstance(cell, (int, float)) else "")
            cells.append(f'<td class="{kind}">{_written(cell)}</td>' if kind else f"<td>{_written(cell)}</td>")
        found.append("<tr>" + "".join(cells) + "</tr>")
    return "\n".join([*found, "</table>"])


def html_text(text: object, tag: str = "p") -> str:
    """A paragraph or a heading."""
    return f"<{tag}>{_written(text)}</{tag}>"


def _written(cell: object) -> str:
    if isinstance(cell, Texts):
        return "".join(f'<span lang="{language}">{_written(text)}</span>' for language, text in cell.items())
    return escape(one_line(str(cell)), quote=True)


def html_page(title: str, language: str, parts: Iterable[str], *, choice: bool = False) -> bytes:
    """A page with its style inside; it loads nothing and runs nothing. `choice`: of the language in which `Texts` are shown."""
    policy = "default-src 'none'; style-src 'unsafe-inline'"
    body, style = "\n".join(parts), _STYLE
    if choice:
        choices = "".join(
            f'<input type="radio" name="language" id="{each}"{" checked" if each == language else ""}>'
            f'<label for="{each}" lang="{each}">{name}</label>\n'
            for each, name in _LANGUAGES.items()
        )
        body, style = f"{choices}<main>\n{body}\n</main>", f"{_STYLE}\n{_CHOICE}"
    page = (
        f'<!DOCTYPE html>\n<html lang="{language}">\n<head>\n<meta charset="utf-8">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f"<title>{_written(title)}</title>\n<style>\n{style}\n</style>\n</head>\n<body>\n{body}\n</body>\n</html>\n"
    )
    return page.encode("utf-8", errors="replace")


def must_be_new(paths: Iterable[Path | None], force: bool) -> None:
    """Raises Exists for a file that is there, before any work is done."""
    for path in paths:
        if path is not None and os.path.lexists(path) and not force:
            raise Exists(str(path))


def write_table(path: Path, data: bytes, force: bool) -> None:
    """Write a file whole. Raises Exists, OSError."""
    must_be_new([path], force)
    replace_file(path, data, mode=0o666)

"""What was seen of submissions, as lines, JSON, CSV and a page: all of them made of the same plain data."""

from __future__ import annotations

import json
from collections.abc import Iterable, Mapping, Sequence
from typing import Any

from day6_core.language import LANGUAGES
from day6_core.lessons.grading.grades import Graded
from day6_core.lessons.grading.marks import both
from day6_core.lessons.tables import Cell, Texts, csv_bytes, html_page, html_table, html_text
from day6_core.lessons.texts import Say
from day6_core.session.harmless import one_line

VERSION = 1
SHOWN = 3
"""Checks of one scenario that are shown on the terminal; the files have all."""

Data = Mapping[str, Any]
_CLASSES = {"right": "good", "wrong": "bad", "late": "late", "unplayed": "open"}


def data_of(found: Iterable[Graded], words: Mapping[str, str], **about: object) -> dict[str, Any]:
    """Everything, as it is written down. `words` are the teacher's, by the submissions' files."""
    submissions = [{**graded.data(), "remark": words.get(graded.file.name, "")} for graded in found]
    return {"version": VERSION, **about, "submissions": submissions}


def as_json(data: Data) -> bytes:
    return json.dumps(data, ensure_ascii=False, indent=1).encode("utf-8", errors="replace") + b"\n"


def _text(key: str, language: str, **values: object) -> str:
    return Say(key, **values).text(language)


def _points(data: Data) -> Say:
    points = Say("grade.points", points=f"{data['points']:g}", most=f"{data['most']:g}")
    unplayed = data.get("unplayed", 0)
    return Say("grade.points_open", points=points, count=unplayed) if unplayed else points


def in_text(submission: Data, language: str) -> str:
    """A line for the submission, and some below for each scenario that it did not pass."""
    if submission["refused"] is not None:
        reason = submission["refused"][language]
        return one_line(_text("grade.line_refused", language, file=submission["file"], reason=reason))
    points = _points(submission)
    found = [_text("grade.line", language, file=submission["file"], pupil=submission["calls_itself"], points=points)]
    if submission["remark"]:
        found.append(f"    {_text('grade.line_remark', language, text=submission['remark'])}")
    for each in submission["scenarios"]:
        if each["mark"] != "right":
            mark = Say(f"grade.mark.{each['mark']}")
            values = {"name": _name(each), "title": each["title"][language], "mark": mark, "points": _points(each)}
            found.append(f"    {_text('grade.line_scenario', language, **values)}")
            for check in [check for check in each["checks"] if not check["ok"]][:SHOWN]:
                for what in ("asked", "seen", "where"):
                    if check[what][language]:
                        found.append(f"        {_text(f'grade.line_{what}', language, text=check[what][language])}")
    return "\n".join(map(one_line, found))


def _name(scenario: Data) -> str:
    return f"{scenario['lesson']} {scenario['scenario']}"


def _names(data: Data) -> list[str]:
    return list(dict.fromkeys(_name(each) for one in data["submissions"] for each in one["scenarios"]))


def as_csv(data: Data, language: str, words: Mapping[str, str]) -> bytes:
    """A row for each submission. `words` of submissions that were not graded now stay in rows of their own."""
    names = _names(data)
    heads = ["file", "calls_itself", "points", "most", "unplayed", "remark", "refused"]
    heads += [f"{name} {what}" for name in names for what in ("points", "mark", "why")]
    rows: list[list[object]] = []
    for one in data["submissions"]:
        by_name = {_name(each): each for each in one["scenarios"]}
        refused = (one["refused"] or {}).get(language, "")
        row: list[object] = [*(one[head] for head in heads[:6]), refused]
        for name in names:
            each = by_name.get(name)
            row += [each["points"], each["mark"], _why(each, language)] if each is not None else ["", "", ""]
        rows.append(row)
    graded = {one["file"] for one in data["submissions"]}
    others = sorted(words.keys() - graded)
    rows += [[name, "", "", "", "", words[name], *[""] * (len(heads) - 6)] for name in others]
    return csv_bytes(heads, rows)


def _why(scenario: Data, language: str) -> str:
    wrong = [check for check in scenario["checks"] if not check["ok"]]
    problem = (
        _text("grade.problem", language, asked=check["asked"][language], seen=_seen(check)[language]) for check in wrong
    )
    return " ".join(map(str.strip, problem))


def _seen(check: Data) -> dict[str, str]:
    """What was seen, and where that differs."""
    return {each: " ".join(filter(None, (check["seen"][each], check["where"][each]))) for each in LANGUAGES}


def _texts(key: str, **values: object) -> Texts:
    return Texts(both(Say(key, **values)))


def as_page(data: Data, language: str, total: Say) -> bytes:
    """A page in both languages: one table over all, then what was asked and seen of each submission."""
    names = _names(data)
    head = [_texts(f"grade.{each}") for each in ("file", "calls_itself", "points_head", "remark")]
    rows: list[Sequence[object]] = []
    for one in data["submissions"]:
        by_name = {_name(each): each for each in one["scenarios"]}
        points = _texts("grade.refused") if one["refused"] is not None else Texts(both(_points(one)))
        cells = [_mark(by_name[name]) if name in by_name else Cell("") for name in names]
        rows.append([one["file"], one["calls_itself"], points, one["remark"], *cells])
    parts = [html_text(_texts("grade.title"), "h1"), html_text(Texts(both(total))), html_table([*head, *names], rows)]
    for one in data["submissions"]:
        parts += _section(one)
    return html_page(_text("grade.title", language), language, parts, choice=True)


def _mark(scenario: Data) -> Texts:
    texts = both(Say(f"grade.mark.{scenario['mark']}"))
    points = f"{scenario['points']:g}"
    return Texts({each: f"{text} {points}" for each, text in texts.items()}, _CLASSES[scenario["mark"]])


def _section(one: Data) -> list[str]:
    parts = [html_text(f"{one['file']}  {one['calls_itself']}", "h2")]
    if one["remark"]:
        parts.append(html_text(_texts("grade.line_remark", text=one["remark"])))
    if one["refused"] is not None:
        return [*parts, html_text(Texts(one["refused"], "bad"))]
    head = [_texts(f"grade.{each}") for each in ("scenario", "mark", "asked", "seen", "where", "held")]
    rows: list[Sequence[object]] = []
    for each in one["scenarios"]:
        title = Texts({language: f"{_name(each)}: {text}" for language, text in each["title"].items()})
        for number, check in enumerate(each["checks"] or [{"ok": True, "at": None}]):
            first = [title, _mark(each)] if not number else ["", ""]
            texts = [
                Texts(check[what], "" if check["ok"] else _CLASSES[each["mark"]]) if what in check else ""
                for what in _WHAT
            ]
            held = Cell("" if check["at"] is None else f"{check['at']:.1f} s", "number")
            rows.append([*first, *texts, held])
    return [*parts, html_table(head, rows)]


_WHAT = ("asked", "seen", "where")

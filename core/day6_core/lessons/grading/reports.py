"""What was seen of submissions, as lines, as CSV and as a page, in the teacher's language."""

from __future__ import annotations

from day6_core.language import LANGUAGES
from day6_core.lessons.grading.grader import Grade, Graded
from day6_core.lessons.tables import Cell, csv_bytes, html_page, html_table, html_text
from day6_core.lessons.texts import Say
from day6_core.session.harmless import one_line

SHOWN = 3
"""Problems of one scenario that are shown on the terminal; the files have all."""


def _text(key: str, language: str, **values: object) -> str:
    return Say(key, **values).text(language)


def in_text(graded: Graded, language: str) -> str:
    """A line for the submission, and one below for each scenario that it did not pass."""
    if graded.refused is not None:
        return one_line(
            _text("grade.line_refused", language, file=graded.file.name, reason=graded.refused[language])
        )  # fmt: skip
    count = _text("grade.count", language, passed=graded.passed, all=len(graded.results))
    found = [one_line(_text("grade.line", language, file=graded.file.name, pupil=graded.pupil, count=count))]
    for result in graded.results:
        if not result.passed:
            found.append(one_line(f"    {result.lesson} {result.scenario}: {result.title[language]}"))
            for wanted, saw in result.problems[:SHOWN]:
                text = _text("grade.problem", language, wanted=wanted[language], saw=saw[language])
                found.append(one_line(f"        {text}"))
    return "\n".join(found)


def as_csv(found: list[Graded], language: str) -> bytes:
    """A row for each submission and scenario, in both languages."""
    heads = ["file", "calls_itself", "lesson", "scenario", "passed", "seconds"]
    heads += [f"{what}_{each}" for what in ("title", "wanted", "saw") for each in LANGUAGES]
    rows: list[list[object]] = []
    for graded in found:
        name = graded.file.name
        if graded.refused is not None:
            rows.append([name, graded.pupil, "", "", 0, graded.seconds, "", "", "", "", *_each(graded.refused)])
        for result in graded.results:
            wanted, saw = _joined(result)
            rows.append(
                [name, graded.pupil, result.lesson, result.scenario, int(result.passed), result.seconds,
                 *_each(result.title), *_each(wanted), *_each(saw)]
            )  # fmt: skip
    return csv_bytes(heads, rows)


def _each(texts: object) -> list[str]:
    assert hasattr(texts, "__getitem__")
    return [str(texts[language]) for language in LANGUAGES]


def _joined(result: Grade) -> tuple[dict[str, str], dict[str, str]]:
    """All that was wanted and not seen, and what was seen instead."""
    wanted = {each: "; ".join(problem[0][each] for problem in result.problems) for each in LANGUAGES}
    saw = {each: " ".join(filter(None, (problem[1][each] for problem in result.problems))) for each in LANGUAGES}
    return wanted, saw


def as_page(found: list[Graded], language: str, total: str) -> bytes:
    """A page: one table over all, then what each submission did not pass."""
    title = _text("grade.title", language)
    scenarios = list(dict.fromkeys((each.lesson, each.scenario) for graded in found for each in graded.results))
    head = [_text("grade.file", language), _text("grade.calls_itself", language), _text("grade.passed", language)]
    head += [f"{lesson} {scenario}" for lesson, scenario in scenarios]
    rows: list[list[object]] = []
    for graded in found:
        by_name = {(each.lesson, each.scenario): each for each in graded.results}
        count = _text("grade.count", language, passed=graded.passed, all=len(graded.results))
        if graded.refused is not None:
            count = _text("grade.refused", language)
        row: list[object] = [graded.file.name, graded.pupil, count]
        for key in scenarios:
            result = by_name.get(key)
            passed = result is not None and result.passed
            row.append(Cell("✓" if passed else "✗", "good" if passed else "bad"))
        rows.append(row)
    parts = [html_text(title, "h1"), html_text(total), html_table(head, rows)]
    for graded in found:
        parts += _section(graded, language)
    return html_page(title, language, parts)


def _section(graded: Graded, language: str) -> list[str]:
    parts = [html_text(f"{graded.file.name}  {graded.pupil}", "h2")]
    if graded.refused is not None:
        return [*parts, html_text(f"{_text('grade.refused', language)}: {graded.refused[language]}")]
    head = [_text(f"grade.{each}", language) for each in ("scenario", "passed", "wanted", "saw", "seconds")]
    rows: list[list[object]] = []
    for result in graded.results:
        wanted, saw = _joined(result)
        verdict = Cell(
            _text("grade.passed" if result.passed else "grade.not_passed", language), "good" if result.passed else "bad"
        )
        name = f"{result.lesson} {result.scenario}: {result.title[language]}"
        rows.append([name, verdict, wanted[language], saw[language], result.seconds])
    return [*parts, html_table(head, rows)]

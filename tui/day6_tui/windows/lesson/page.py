"""What the lesson window shows: the list of lessons, or the page of a step."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, NamedTuple

from rich.segment import Segment

from day6_core.lessons.catalogue import is_shipped
from day6_core.lessons.document import HINTS, Lesson
from day6_core.lessons.remarks import TOPICS
from day6_tui.panes.cells import cell_len, clip, fit, wrap
from day6_tui.windows.lesson.text import Line, text_lines

if TYPE_CHECKING:
    from rich.style import Style

    from day6_core.lessons.course import Course
    from day6_core.lessons.document import Answer, Page
    from day6_core.lessons.exam import Exam
    from day6_core.lessons.state import State
    from day6_tui.appearance.look import Look

Action = Callable[[], object]


class PageRow(NamedTuple):
    """A line of the page, and what a click on it does."""

    line: Line
    action: Action | None = None
    news: str = ""
    """What has come to be seen here: 'solved', 'hint', 'answer', 'problem', 'notes'."""


class LessonEntry(NamedTuple):
    """A lesson in the list."""

    name: str
    row: int


def list_rows(
    course: Course, look: Look, width: int, chosen: int, open_entry: Callable[[int], object]
) -> tuple[list[PageRow], list[LessonEntry]]:
    """The list of lessons and drills with how far the pupil is; also the entries with their lines."""
    texts, colours, state, offer = look.texts, look.colours, course.state, course.offer
    rows: list[PageRow] = []
    entries: list[LessonEntry] = []

    def heading(text: str) -> None:
        if rows:
            rows.append(PageRow([]))
        rows.append(PageRow([Segment(clip(f" {text}", width), colours.strong)]))

    def entry(lesson: Lesson, name: str) -> None:
        number = len(entries)
        on = number == chosen
        solved, all_steps = course.progress.solved(lesson.name), len(lesson.steps)
        far = (
            _mark(look, True)
            if solved >= all_steps
            else f"{solved}/{all_steps}"
            if solved
            else texts("lesson.minutes", minutes=lesson.minutes)
        )
        room = width - cell_len(far) - 2
        marker = look.glyphs.marker if on else " "
        style = colours.choice if on else colours.text
        done = colours.publisher if solved >= all_steps else colours.muted
        line = [Segment(fit(f" {marker} {name}", room), style), Segment(f" {far} ", done)]
        rows.append(PageRow(line, lambda: open_entry(number)))
        entries.append(LessonEntry(lesson.name, len(rows) - 1))

    if course.exam is not None and course.exam.over:
        rows += _exam_rows(course.exam, course, look, width)
    if state.unknown:
        rows += [
            PageRow([Segment(f" {line}", colours.warning)])
            for line in wrap(texts("lesson.unknown", name=state.unknown), width - 2)
        ]
    if state.finished is not None:
        rows += _finished_rows(state.finished, course, look, width)
    heading(texts("lesson.days" if all(map(is_shipped, offer.lessons)) else "lesson.own"))
    for lesson in offer.lessons:
        entry(lesson, lesson.title[texts.language])
    if not offer.lessons:
        rows.append(PageRow([Segment(clip(f"   {texts('lesson.none')}", width), colours.muted)]))
    for mistakes in offer.broken:
        for each in mistakes.mistakes[:3]:
            words = f"{mistakes.path.name}:{each.line}: {each.text}"
            rows += [PageRow([Segment(f"   {line}", colours.warning)]) for line in wrap(words, width - 4)]
    for key, shipped in (("lesson.drills.own", False), ("lesson.drills", True)):
        drills = [lesson for lesson in offer.drills if is_shipped(lesson) == shipped]
        if not drills:
            continue
        heading(texts(key))
        if drills[0] is offer.drills[0]:
            more = wrap(texts("lesson.drills.more"), width - 4)
            rows += [PageRow([Segment(f"   {line}", colours.muted)]) for line in more]
        for before, lesson in zip((None, *drills), drills, strict=False):
            if before is None or before.topic != lesson.topic:
                rows.append(PageRow([Segment(clip(f"   {_topic(lesson.topic, look)}", width), colours.accent)]))
            number = f"{lesson.fault:2} " if lesson.fault else ""
            entry(lesson, f"{number}{lesson.title[texts.language]}")
    return rows, entries


def _topic(topic: str, look: Look) -> str:
    """The name of a topic; one of a teacher's own as it is."""
    return look.texts(f"lesson.topic.{topic}") if topic in TOPICS else topic


def _finished_rows(lesson: Lesson, course: Course, look: Look, width: int) -> list[PageRow]:
    """What the pupil has done of the lesson that ends here."""
    done = [course.progress.step(lesson.name, step.name) for step in lesson.steps]
    solved, hints = sum(bool(each.solved) for each in done), sum(each.hints for each in done)
    complete = solved == len(done)
    how = ("all" if hints else "best") if complete else ("some" if hints else "unhelped")
    told = look.texts(f"lesson.finished.{how}", solved=solved, all=len(done), hints=hints)
    words = look.texts("lesson.finished", title=lesson.title[look.texts.language], how=told)
    return [PageRow([Segment(f" {line}", look.colours.publisher)]) for line in wrap(words, width - 2)]


def _exam_rows(exam: Exam, course: Course, look: Look, width: int) -> list[PageRow]:
    """The report of an exam that is over."""
    texts, colours = look.texts, look.colours
    head = texts("lesson.exam.over", solved=exam.solved, all=len(exam.drills))
    rows = [PageRow([Segment(clip(f" {head}", width), colours.strong)])]
    for result in exam.results:
        drill = course.offer.named(result.drill)
        name = drill.title[texts.language] if drill is not None else result.drill
        far = texts("lesson.exam.result", seconds=f"{result.seconds:.0f}", hints=result.hints)
        room = width - cell_len(far) - 6
        style = colours.publisher if result.solved else colours.warning
        rows.append(
            PageRow(
                [
                    Segment(f" {fit(_mark(look, result.solved), 3)} ", style),
                    Segment(fit(name, room), style),
                    Segment(f" {far}", colours.muted),
                ]
            )
        )
    return rows


def step_rows(
    course: Course,
    state: State,
    look: Look,
    width: int,
    doing: Callable[[str], Action],
    *,
    notes: bool = False,
    here: bool = True,
    picked: str = "",
    short: bool = False,
) -> list[PageRow]:
    """The page of the step: picture, text, what to do, how far the checks are, hints, answers, `notes` for the teacher.

    `here`: the keyboard is in this window, so that its keys need no F5 before them. `picked`: the answer that Enter gives.
    `short`: there is room for some lines only, so that what to do comes first.
    """
    assert state.step is not None
    page: Page = state.step.pages[look.texts.language]
    rows = _heading(state, page, look, width)
    body = [PageRow([Segment(" ", look.colours.text), *line]) for line in _text(page.body, width - 2, look)]
    parts = [_picture(page, look, width), [*body, PageRow([])], _do(page, look, width)]
    if short:
        parts = [[*parts[2], PageRow([])], parts[0], parts[1][:-1]]
    rows += [row for part in parts for row in part]
    rows += [PageRow([])] if page.answers else []
    for answer in page.answers:
        rows += _answer(answer, state, look, width, doing, picked=answer.letter == picked)
    if page.answers and not state.solved:
        letters = texts_list(look, [answer.letter for answer in page.answers])
        told = look.texts("lesson.answer.here" if here else "lesson.answer", letters=letters)
        rows += [
            PageRow([Segment(f"  {line}", look.colours.accent)], news="question") for line in wrap(told, width - 4)
        ]
    rows.append(PageRow([]))
    rows += _checks(state, look, width, doing, here=here)
    rows += _hints(state, page, look, width, doing)
    rows += _problems(course, state, look, width, doing)
    if notes and page.teacher:
        lines = [[Segment(look.texts("lesson.notes"), look.colours.accent)], *_text(page.teacher, width - 2, look)]
        rows += [PageRow([]), *(PageRow([Segment(" ", look.colours.text), *line], news="notes") for line in lines)]
    return rows


def _text(markdown: str, width: int, look: Look, style: Style | None = None) -> list[Line]:
    return text_lines(markdown, width, look.colours, style, goes_on="└ " if look.glyphs.unicode else "| ")


def texts_list(look: Look, words: list[str]) -> str:
    """'a, b, c' in the language that is shown."""
    return look.texts("list.comma").join(words)


def _heading(state: State, page: Page, look: Look, width: int) -> list[PageRow]:
    colours = look.colours
    assert state.lesson is not None
    return [PageRow([Segment(f" {line}", colours.strong)]) for line in wrap(page.title, width - 2)] + [PageRow([])]


def _picture(page: Page, look: Look, width: int) -> list[PageRow]:
    if not page.picture:
        return []
    colours = look.colours
    size = max(map(cell_len, page.picture))
    left = max(0, (width - size) // 2)
    rows = [
        PageRow([Segment(" " * left, colours.text), Segment(clip(line, width - left), colours.node)])
        for line in page.picture
    ]
    return [*rows, PageRow([])]


def _do(page: Page, look: Look, width: int) -> list[PageRow]:
    colours, glyphs = look.colours, look.glyphs
    lines = _text(page.do, width - 4, look, colours.strong)
    return [
        PageRow([Segment(f" {glyphs.marker if not at else ' '} ", colours.accent), *line])
        for at, line in enumerate(lines)
    ]


def _answer(
    answer: Answer, state: State, look: Look, width: int, doing: Callable[[str], Action], *, picked: bool
) -> list[PageRow]:
    colours, letter, reason = look.colours, answer.letter, answer.reason
    chosen = state.answer == letter
    style = colours.publisher if chosen and state.solved else colours.warning if chosen else colours.text
    style = colours.choice if picked else style
    lines = _text(answer.text, width - 6, look, style)
    rows = [
        PageRow([Segment(f"  {letter}) " if not at else "     ", style), *line], doing(f"answer {letter}"))
        for at, line in enumerate(lines)
    ]
    if chosen and reason:
        rows += [
            PageRow([Segment("     ", colours.text), *line]) for line in _text(reason, width - 6, look, colours.muted)
        ]
    return rows


def of_the_end(key: str, state: State) -> str:
    """The text that says what comes after this step: another one, or the end of the lesson."""
    if not state.is_last or state.lesson is None:
        return key
    return f"{key}.drill" if state.lesson.is_drill else f"{key}.day"


def _mark(look: Look, good: bool) -> str:
    if not look.glyphs.unicode:
        return "[x]" if good else "[ ]"
    return "✓" if good else "·"


def _checks(state: State, look: Look, width: int, doing: Callable[[str], Action], *, here: bool) -> list[PageRow]:
    colours, language = look.colours, look.texts.language
    rows: list[PageRow] = []
    if state.lesson is not None and state.lesson.is_drill and not state.hints and not state.solved:
        # What is checked would give the cause away.
        return [
            PageRow([Segment(f" {line}", colours.muted)]) for line in wrap(look.texts("lesson.drill.open"), width - 2)
        ]
    for verdict in state.verdicts:
        mark = _mark(look, verdict.ok)
        style = colours.publisher if verdict.ok else colours.text
        room = width - cell_len(mark) - 3
        for at, line in enumerate(_text(verdict.wanted.text(language), room, look, style)):
            rows.append(PageRow([Segment(f" {mark if not at else ' ' * cell_len(mark)} ", style), *line]))
        if not verdict.ok and verdict.saw is not None:
            for line in _text(verdict.saw.text(language), room, look, colours.muted):
                rows.append(PageRow([Segment(f" {' ' * cell_len(mark)} ", colours.muted), *line]))
    if state.done_before and not state.solved:
        told = wrap(look.texts("lesson.done_before"), width - 2)
        rows += [PageRow([]), *(PageRow([Segment(f" {line}", colours.publisher)]) for line in told)]
    if state.solved:
        key = "lesson.already" if state.before_asked else "lesson.solved"
        go_on = look.texts(of_the_end("lesson.go_on", state))
        told = wrap(look.texts(key, key="Enter" if here else "F5", go_on=go_on), width - 2)
        solved = [PageRow([Segment(f" {line}", colours.publisher)], doing("next"), "solved") for line in told]
        rows += [PageRow([]), *solved]
    return rows


def _hints(state: State, page: Page, look: Look, width: int, doing: Callable[[str], Action]) -> list[PageRow]:
    colours, texts = look.colours, look.texts
    rows: list[PageRow] = []
    for number, hint in enumerate(page.hints[: state.hints], 1):
        head = texts("lesson.hint", number=number, all=HINTS)
        rows.append(PageRow([]))
        rows.append(PageRow([Segment(f" {head}", colours.accent)]))
        rows += [
            PageRow([Segment(" ", look.colours.text), *line], news="hint") for line in _text(hint, width - 2, look)
        ]
    return rows


def _problems(course: Course, state: State, look: Look, width: int, doing: Callable[[str], Action]) -> list[PageRow]:
    """What stands in the way: missing earlier steps, a file that is wrong, progress that cannot be kept."""
    colours, texts = look.colours, look.texts
    rows: list[PageRow] = []

    def say(text: str, action: Action | None = None) -> None:
        rows.append(PageRow([]))
        rows.extend(
            PageRow([Segment(f" {line}", colours.warning)], action, "problem") for line in wrap(text, width - 2)
        )

    if state.leftovers and not state.working:
        say(texts("lesson.leftovers", names=texts_list(look, list(state.leftovers[:3]))), doing("clear"))
    if state.missing and state.lesson is not None and not state.working:
        steps = [state.lesson.step(name) for name in state.missing]
        names = texts_list(look, [step.pages[texts.language].title for step in steps if step is not None])
        say(texts("lesson.missing", names=names), doing("prepare"))
    if state.problem:
        key = "lesson.something_runs" if state.problem == "something-runs" else "lesson.problem"
        say(texts(key, reason=state.problem))
    if state.mistakes is not None:
        for each in state.mistakes.mistakes[:5]:
            say(f"{state.mistakes.path.name}:{each.line}: {each.text}")
    if course.kept.failed:
        say(texts("lesson.not_saved", reason=course.kept.failed))
    return rows

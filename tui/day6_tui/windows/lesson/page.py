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

PROSE_ROWS = 3
"""Lines that are left to read above a task that stays in sight."""

READ_ROWS = 8
"""Lines that are left to read above answers and checks that stay in sight: otherwise they scroll with the text."""

PICTURE_ROWS = 6
"""Where fewer lines of text would follow the picture, it comes after them: what it shows is on the screen by then."""


class PageRow(NamedTuple):
    """A line of the page, and what a click on it does."""

    line: Line
    action: Action | None = None
    news: str = ""
    """What has come to be seen here: 'hint', 'question', 'answer', 'problem', 'notes'."""


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
        for number, (before, lesson) in enumerate(zip((None, *drills), drills, strict=False), 1):
            if before is None or before.topic != lesson.topic:
                rows.append(PageRow([Segment(clip(f"   {_topic(lesson.topic, look)}", width), colours.accent)]))
            entry(lesson, f"{number:2} {lesson.title[texts.language]}")
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


class StepPage(NamedTuple):
    """The page of a step in its parts, each without empty lines around it."""

    title: list[PageRow]
    picture: list[PageRow]
    prose: list[PageRow]
    """What is read: text, hints, notes for the teacher."""
    problems: list[PageRow]
    do: list[PageRow]
    answers: list[PageRow]
    checks: list[PageRow]
    told: list[PageRow]
    """What comes next: that it is solved, how a question is answered."""

    def laid_out(self, height: int) -> tuple[list[PageRow], list[PageRow]]:
        """What scrolls in a window of so many lines, and what stays below it: as much of the task as leaves room to read."""
        head = [self.title, self.picture, self.prose]
        task = (self.problems, self.do, self.answers, self.checks, self.told)
        whole = _joined([*head, *task])
        if len(whole) <= height:
            return whole, []
        stays: list[list[PageRow]] = []
        weighty = ((self.do, PROSE_ROWS), (self.told, 1), (self.problems, PROSE_ROWS))
        for part, read in (*weighty, (self.answers, READ_ROWS), (self.checks, READ_ROWS)):
            if sum(map(len, (*stays, part))) + 1 + read <= height:  # with the line between them
                stays.append(part)
        if self.do not in stays:
            # No room for both: what to do comes first, and says where the rest is.
            return _joined([self.do, self.told, self.problems, self.answers, self.checks, *head]), []
        left = [part for part in task if part not in stays]
        pinned = [row for part in task if part in stays for row in part]
        if height - len(pinned) < len(self.title) + len(self.picture) + PICTURE_ROWS:
            return [*self.title, *_joined([self.prose, *left, self.picture])], pinned
        return _joined([*head, *left]), pinned


def _joined(parts: list[list[PageRow]]) -> list[PageRow]:
    """The parts with an empty line between them."""
    rows: list[PageRow] = []
    for part in filter(None, parts):
        rows += [*([PageRow([])] if rows else []), *part]
    return rows


def step_page(
    course: Course,
    state: State,
    look: Look,
    width: int,
    doing: Callable[[str], Action],
    *,
    notes: bool = False,
    here: bool = True,
    picked: str = "",
) -> StepPage:
    """The page of the step, with the `notes` for the teacher.

    `here`: the keyboard is in this window, so that its keys need no F5 before them. `picked`: the answer that Enter gives.
    """
    assert state.step is not None
    page: Page = state.step.pages[look.texts.language]
    prose = [_indented(_text(page.body, width - 2, look), look)]
    prose += _hints(state, page, look, width)
    if notes and page.teacher:
        lines = [[Segment(look.texts("lesson.notes"), look.colours.accent)], *_text(page.teacher, width - 2, look)]
        prose.append(_indented(lines, look, "notes"))
    return StepPage(
        _heading(page, look, width),
        _picture(page, look, width),
        _joined(prose),
        _problems(course, state, look, width, doing, here=here),
        _do(page, look, width),
        [row for each in page.answers for row in _answer(each, state, look, width, doing, each.letter == picked)],
        _checks(state, look, width),
        _told(state, page, look, width, doing, here=here),
    )


def _indented(lines: list[Line], look: Look, news: str = "") -> list[PageRow]:
    return [PageRow([Segment(" ", look.colours.text), *line], news=news) for line in lines]


def _text(markdown: str, width: int, look: Look, style: Style | None = None) -> list[Line]:
    return text_lines(markdown, width, look.colours, style, goes_on="└ " if look.glyphs.unicode else "| ")


def texts_list(look: Look, words: list[str]) -> str:
    """'a, b, c' in the language that is shown."""
    return look.texts("list.comma").join(words)


def _heading(page: Page, look: Look, width: int) -> list[PageRow]:
    return [PageRow([Segment(f" {line}", look.colours.strong)]) for line in wrap(page.title, width - 2)]


def _picture(page: Page, look: Look, width: int) -> list[PageRow]:
    if not page.picture:
        return []
    colours = look.colours
    size = max(map(cell_len, page.picture))
    left = max(0, (width - size) // 2)
    return [
        PageRow([Segment(" " * left, colours.text), Segment(clip(line, width - left), colours.node)])
        for line in page.picture
    ]


def _do(page: Page, look: Look, width: int) -> list[PageRow]:
    colours, glyphs = look.colours, look.glyphs
    lines = _text(page.do, width - 4, look, colours.strong)
    return [
        PageRow([Segment(f" {glyphs.marker if not at else ' '} ", colours.accent), *line])
        for at, line in enumerate(lines)
    ]


def _answer(
    answer: Answer, state: State, look: Look, width: int, doing: Callable[[str], Action], picked: bool
) -> list[PageRow]:
    colours, letter, reason = look.colours, answer.letter, answer.reason
    chosen = state.answer == letter
    style = colours.publisher if chosen and state.solved else colours.warning if chosen else colours.text
    style = colours.choice if picked else style
    lines = _text(answer.text, width - 6, look, style)
    news = "answer" if chosen else "question"
    rows = [
        PageRow([Segment(f"  {letter}) " if not at else "     ", style), *line], doing(f"answer {letter}"), news)
        for at, line in enumerate(lines)
    ]
    if chosen and reason:
        reasons = _text(reason, width - 6, look, colours.muted)
        rows += [PageRow([Segment("     ", colours.text), *line], news=news) for line in reasons]
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


def _checks(state: State, look: Look, width: int) -> list[PageRow]:
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
    return rows


def _told(
    state: State, page: Page, look: Look, width: int, doing: Callable[[str], Action], *, here: bool
) -> list[PageRow]:
    """What comes next."""
    texts, colours = look.texts, look.colours
    told: list[tuple[str, Style]] = []
    if state.solved:
        key = "lesson.already" if state.before_asked else "lesson.solved"
        go_on = texts(of_the_end("lesson.go_on", state))
        told.append((texts(key, key="Enter" if here else "F5", go_on=go_on), colours.publisher))
    elif state.done_before:
        told.append((texts("lesson.done_before"), colours.publisher))
    if page.answers and not state.solved:
        letters = texts_list(look, [answer.letter for answer in page.answers])
        told.append((texts("lesson.answer.here" if here else "lesson.answer", letters=letters), colours.accent))
    lines = [(line, style) for words, style in told for line in wrap(words, width - 2)]
    if state.solved:
        return [PageRow([Segment(f" {line}", style)], doing("next"), "solved") for line, style in lines]
    return [PageRow([Segment(f" {line}", style)]) for line, style in lines]


def _hints(state: State, page: Page, look: Look, width: int) -> list[list[PageRow]]:
    found: list[list[PageRow]] = []
    for number, hint in enumerate(page.hints[: state.hints], 1):
        head = PageRow([Segment(f" {look.texts('lesson.hint', number=number, all=HINTS)}", look.colours.accent)])
        found.append([head, *_indented(_text(hint, width - 2, look), look, "hint")])
    return found


def _problems(
    course: Course, state: State, look: Look, width: int, doing: Callable[[str], Action], *, here: bool
) -> list[PageRow]:
    """What stands in the way: missing earlier steps, a file that is wrong, progress that cannot be kept."""
    colours, texts = look.colours, look.texts
    rows: list[PageRow] = []

    def key(letter: str) -> str:
        return letter if here else texts("lesson.first", key=letter)

    def say(text: str, action: Action | None = None) -> None:
        rows.extend(
            PageRow([Segment(f" {line}", colours.warning)], action, "problem") for line in wrap(text, width - 2)
        )

    if state.leftovers and not state.working:
        told = "lesson.something_runs" if state.lesson is not None and state.lesson.is_drill else "lesson.leftovers"
        say(texts(told, names=texts_list(look, list(state.leftovers[:3])), key=key("C")), doing("clear"))
    if state.missing and state.lesson is not None and not state.working:
        steps = [state.lesson.step(name) for name in state.missing]
        names = texts_list(look, [step.pages[texts.language].title for step in steps if step is not None])
        say(texts("lesson.missing", names=names, key=key("P")), doing("prepare"))
    if state.problem:
        say(texts("lesson.problem", reason=state.problem))
    if state.mistakes is not None:
        for each in state.mistakes.mistakes[:5]:
            say(f"{state.mistakes.path.name}:{each.line}: {each.text}")
    if course.kept.failed:
        say(texts("lesson.not_saved", reason=course.kept.failed))
    return rows

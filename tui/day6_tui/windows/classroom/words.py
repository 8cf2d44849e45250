"""What there is to say of a pupil now, in words: what needs the teacher most comes first."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from rich.style import Style

from day6_core.classroom.asked import Asked
from day6_core.classroom.note import Note
from day6_core.classroom.roster import IDLE_SECONDS, PupilRow
from day6_tui.appearance.look import Look


class ColouredWords(NamedTuple):
    """A few words in their colour; `short` is for where there is little room."""

    text: str
    style: Style
    short: str = ""


def words_of(
    row: PupilRow, now: float, look: Look, *, is_room: bool, asked: Asked | None = None
) -> Iterator[ColouredWords]:
    """Yield what the table says of a pupil; `now` is the roster's time, `asked` what the pupil was asked last.

    In a room (`is_room`) all have one graph, of which only what stands below the pupil's name is the pupil's.
    """
    texts, colours, note = look.texts, look.colours, row.note
    if not row.is_here:
        yield ColouredWords(texts("teacher.state.gone"), colours.muted)
        return
    if note is None:
        yield ColouredWords(texts("teacher.state.silent"), colours.muted)
        return
    if row.raised is not None:
        yield _hand(int((now - row.raised) / 60), look)
    if asked is not None:
        yield _reply(asked, look)
    if (answer := answer_of(note, look)) is not None:
        yield answer
    if note.trouble is not None:
        title = note.trouble.title.get(texts.language) or note.trouble.line
        yield ColouredWords(title, colours.error if row.is_stuck(now) else colours.warning)
    if row.raised is not None and row.arrived is not None and (minutes := int((now - row.arrived) / 60)):
        text, short = (texts(f"teacher.state.step{form}", minutes=minutes) for form in ("", ".short"))
        yield ColouredWords(text, colours.muted, short)
    if note.frozen:
        yield ColouredWords(texts("teacher.state.frozen"), colours.muted)
    if row.idle(now) >= IDLE_SECONDS:
        minutes = int(row.idle(now) / 60)
        text, short = (texts(f"teacher.state.idle{form}", minutes=minutes) for form in ("", ".short"))
        yield ColouredWords(text, colours.muted, short)
    elif nodes := [name for name in note.nodes if not is_room or name.startswith(f"/{row.name}/")]:
        yield ColouredWords(" ".join(nodes), colours.node)


def answer_of(note: Note, look: Look) -> ColouredWords | None:
    """Return what came of the last thing that was asked of a pupil, if that is not settled."""
    texts, colours = look.texts, look.colours
    if note.may_type:
        return ColouredWords(texts("teacher.state.may_type"), colours.hint)
    for is_so, key in ((note.shown, "shown"), (note.asked_show, "asked_show")):
        if is_so:
            return ColouredWords(texts(f"teacher.state.{key}"), colours.hint)
    if note.asked:
        return ColouredWords(texts("teacher.state.asked"), colours.hint)
    return ColouredWords(texts(note.refused), colours.warning) if note.refused else None


def _reply(asked: Asked, look: Look) -> ColouredWords:
    """What came of the question; the pupil's own words in quotation marks."""
    texts, reply = look.texts, asked.reply
    if reply is None:
        return ColouredWords(texts("teacher.reply.none"), look.colours.muted)
    text = texts("teacher.reply.words", text=reply.text) if reply.text else texts(f"class.reply.{reply.kind}")
    return ColouredWords(text, look.colours.strong)


def _hand(minutes: int, look: Look) -> ColouredWords:
    texts, style = look.texts, look.colours.hint
    if not minutes:
        return ColouredWords(texts("teacher.state.hand_now"), style)
    text, short = (texts(f"teacher.state.hand{form}", minutes=minutes) for form in ("", ".short"))
    return ColouredWords(text, style, short)

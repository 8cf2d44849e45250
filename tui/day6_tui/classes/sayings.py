"""What the teacher has said to this pupil, asked and handed over: in one box over the panes, which stays until it was read.

A question or something handed over waits in the top line; one key opens it, and only as long as there is something to open, so
that no terminal misses the key.
"""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import TYPE_CHECKING, NamedTuple

from textual.notifications import Notification

from day6_core.classroom.note import LONGEST_REPLY, MOST_OPENED, MOST_REPLIES, Reply
from day6_core.session.harmless import one_line
from day6_tui.actions import BY_ID, Handlers
from day6_tui.classes.box import room_on, words_in
from day6_tui.panes.pane import Piece
from day6_tui.textual_private.access import driver_of, put_up, take_down

if TYPE_CHECKING:
    from day6_core.classroom.order import Order
    from day6_core.session.session import Session
    from day6_tui.app import Day6App

MOST_SAYINGS = 50
MOST_SHOWN = 3
"""In the box, which hides a part of the desktop; the newest."""
UNTIL_READ = 365 * 24 * 3600.0
"""Seconds: Textual's boxes go away at last."""
MOST_WAITING = 8
"""Questions and things handed over that wait for the pupil."""
CHOICES = {"yes": "y", "no": "n", "done": "d"}
"""An answer, and the key that gives it."""
OPEN_IN_PAGE = "\x1b]7701;open;{}\x07"
"""What our page in a browser takes for a link to open (`desk.js`)."""


class Saying(NamedTuple):
    """Something from the teacher: `kind` is the order that brought it (say, link, file)."""

    kind: str
    text: str
    number: int = 0
    """Of a question, or something handed over of which it is told that it was opened; 0 is neither."""

    @property
    def asks(self) -> bool:
        """Whether it is a question."""
        return self.kind == "say" and self.number > 0

    @property
    def waits(self) -> bool:
        """Whether the pupil is to do something with it."""
        return self.kind != "say" or self.asks


class Sayings:
    """Holds them; `changed` is called when there is something to tell the teacher."""

    def __init__(self, app: Day6App, changed: Callable[[], None]) -> None:
        self._app = app
        self._changed = changed
        self.all: list[Saying] = []
        self.waiting: list[Saying] = []
        """What is to be answered or opened, the latest last."""
        self.opened: Callable[[str], None] = lambda name: None
        """Told of a file that was opened."""
        self.replies: tuple[Reply, ...] = ()
        self.numbers_opened: tuple[int, ...] = ()
        self._unread: list[Saying] = []
        """What the pupil has not looked up, the latest last; what waits can be read and wait on."""
        self._box: Notification | None = None
        self._key = BY_ID["answer"].label

    def actions(self) -> Handlers:
        return {"answer": self.open, "sayings": self.show_all}

    # -- what comes ----------------------------------------------------------------------------------------------------

    def hear(self, order: Order) -> None:
        """The teacher says, asks or hands over something."""
        saying = Saying(order.do, one_line(order.text), order.number)
        self.all = [*self.all, saying][-MOST_SAYINGS:]
        self._unread.append(saying)
        if saying.waits:
            self.waiting = [*self.waiting, saying][-MOST_WAITING:]
        self._show_box()

    def settle(self, order: Order) -> None:
        """The teacher waits for this answer no longer."""
        settled = [each for each in self.waiting if each.asks and each.number == order.number]
        self.waiting = [each for each in self.waiting if each not in settled]
        if any(each in self._unread for each in settled):
            self._unread = [each for each in self._unread if each not in settled]
            self._show_box()

    def _show_box(self) -> None:
        """What is unread, in one box; no box if nothing is."""
        old, self._box = self._box, None
        if self._unread:
            self._box = self._made_box()
            put_up(self._app, self._box, instead_of=old)
        elif old is not None:
            take_down(self._app, old)

    def _made_box(self) -> Notification:
        texts, last = self._app.look.texts, self._unread[-1]
        if last.waits:
            how = texts("class.asks.how" if last.asks else "class.handed.how", key=self._key)
        else:
            how = texts("class.says.read", key=BY_ID["palette"].label, action=texts("action.sayings"))
        title, shown = texts("class.asks" if last.asks else "class.says"), self._unread[-MOST_SHOWN:]
        words = words_in(
            room_on(*self._app.size, title),
            [self._words(each) for each in shown],
            len(self._unread) - len(shown),
            how,
            self._app.look.glyphs.ellipsis,
        )
        return Notification(words, title, timeout=UNTIL_READ)

    def fit(self) -> None:
        """The desktop may have another size."""
        if self._box is not None and self._made_box().message != self._box.message:
            self._show_box()

    def _words(self, saying: Saying) -> str:
        key = {"link": "class.handed.link", "file": "class.handed.file"}.get(saying.kind)
        return saying.text if key is None else self._app.look.texts(key, what=saying.text)

    def taken_down(self, box: Notification | None) -> None:
        """A box has gone: by a click on it, it was read."""
        if box is not None and box is self._box:
            self._box, self._unread = None, []
            self._app.frames.wake()

    def _read(self) -> None:
        """Everything that was said is read now."""
        self._unread = []
        self._show_box()

    # -- the top line --------------------------------------------------------------------------------------------------

    def pieces(self, short: bool) -> list[Piece]:
        """What waits for the pupil."""
        if not self.waiting:
            return []
        what = "asks" if self.waiting[-1].asks else "handed"
        text = self._app.look.texts(f"class.bar.{what}" + ".short" * short, key=self._key)
        return [Piece(f" {text} ", self._app.look.colours.hint, self._app.actions["answer"])]

    def offers(self, short: bool) -> list[Piece]:
        """That the teacher said something; a click looks it up."""
        count = sum(not each.waits for each in self._unread)
        if not count:
            return []
        look = self._app.look
        text = look.texts("class.bar.unread" + ".short" * short, count=count)
        return [Piece(f" {text} ", look.colours.hint, self._app.actions["sayings"]), Piece("  ", look.colours.bar)]

    # -- what the pupil does -------------------------------------------------------------------------------------------

    def open(self) -> None:
        """What waits, the latest first; if nothing does, all that was said."""
        if not self.waiting:
            self.show_all()
            return
        saying = self.waiting[-1]
        self._read()
        (self._open_question if saying.asks else self._open_handed)(saying)
        self._app.frames.wake()

    def show_all(self) -> None:
        """Everything that was said and handed over."""
        from day6_tui.classes.modals import SaidModal

        look = self._app.look
        self._read()
        lines = [self._words(each) for each in self.all] or [look.texts("class.sayings.none")]
        handed = next((each for each in reversed(self.all) if each.kind != "say"), None)
        again = None if handed is None else partial(self._use, handed)
        self._app.desktop.open_overlay(SaidModal(look, lines, again))
        self._app.frames.wake()

    def _open_question(self, saying: Saying) -> None:
        from day6_tui.classes.modals import Asked
        from day6_tui.overlays.question import Answer

        texts = self._app.look.texts
        answers = [
            Answer(key, texts(f"class.reply.{kind}"), partial(self._reply, saying, kind))
            for kind, key in CHOICES.items()
        ]
        answers.append(Answer("w", texts("class.reply.words"), partial(self._ask_for_words, saying)))
        self._app.desktop.open_overlay(Asked(self._app.look, texts("class.asks"), saying.text, answers))

    def _ask_for_words(self, saying: Saying) -> None:
        from day6_tui.overlays.prompt import Prompt

        look = self._app.look
        note = look.texts("class.reply.note", most=LONGEST_REPLY)
        self._app.desktop.open_overlay(Prompt(look, saying.text, "", partial(self._take_words, saying), note=note))

    def _take_words(self, saying: Saying, text: str) -> str | None:
        text, texts = " ".join(text.split()), self._app.look.texts
        if not text or len(text) > LONGEST_REPLY:
            return texts("class.reply.nothing") if not text else texts("class.reply.long", most=LONGEST_REPLY)
        self._reply(saying, "words", text)
        return None

    def _reply(self, saying: Saying, kind: str, text: str = "") -> None:
        """Answer; a question that was closed meanwhile takes no answer any more."""
        texts = self._app.look.texts
        if saying not in self.waiting:
            self._app.notices.show(texts("class.reply.late"))
            return
        self.waiting.remove(saying)
        self.replies = (*self.replies, Reply(saying.number, kind, text))[-MOST_REPLIES:]
        self._app.notices.show(texts("class.replied", answer=one_line(text) or texts(f"class.reply.{kind}")))
        self._changed()

    def _open_handed(self, saying: Saying) -> None:
        from day6_tui.classes.modals import Asked
        from day6_tui.overlays.question import Answer

        texts = self._app.look.texts
        answers = [Answer("o", texts("class.handed.open"), partial(self._use, saying))]
        modal = Asked(self._app.look, texts("class.says"), self._words(saying), answers, careful=False)
        self._app.desktop.open_overlay(modal)

    def _use(self, saying: Saying) -> None:
        if saying in self.waiting:
            self.waiting.remove(saying)
        if (self._open_link if saying.kind == "link" else self._open_file)(saying.text) and saying.number:
            others = [each for each in self.numbers_opened if each != saying.number]
            self.numbers_opened = (*others, saying.number)[-MOST_OPENED:]
            self._changed()

    def _open_link(self, link: str) -> bool:
        """In a new tab beside our page; elsewhere it is shown and copied, as no browser may be there."""
        from day6_tui.overlays.message import LogModal

        app, driver = self._app, driver_of(self._app)
        if app.detachment.is_in_page and driver is not None:
            driver.write(OPEN_IN_PAGE.format(link))
            return True
        app.copy_to_clipboard(link)
        app.desktop.open_overlay(LogModal(app.look, app.look.texts("class.handed.copied"), [link]))
        return True

    def _open_file(self, name: str) -> bool:
        """In an editor, if it is a text; False if it is not there."""
        app = self._app
        home = app.machine.desk.home if app.machine.desk is not None else None
        try:
            if home is None or not (home / name).is_file():
                raise FileNotFoundError(name)
            (home / name).read_text(encoding="utf-8")
        except FileNotFoundError:
            app.notices.show(app.look.texts("class.handed.gone", file=name))
            return False
        except (OSError, UnicodeDecodeError):
            app.notices.show(app.look.texts("class.handed.no_text", file=name))
        else:
            app.machine.start("edit", partial(_edit, name))
            self.opened(name)
        return True


async def _edit(name: str, session: Session) -> int:
    from day6_core.shell.builtins.edit import edit

    return await session.execute(edit, ["edit", name])

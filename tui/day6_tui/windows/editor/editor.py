"""The editor's window: Textual's TextArea in a pane's frame, with save, find, go to line, and checks while typing."""

from __future__ import annotations

import contextlib
import os
import time
from collections.abc import Callable, Iterable
from functools import partial
from pathlib import Path

from rich.segment import Segment
from textual import events
from textual.app import ComposeResult
from textual.widget import Widget
from textual.widgets.text_area import Selection

from day6_core.reason import reason
from day6_core.session.display import Window
from day6_core.session.keys import split_keys
from day6_core.shell.editing.checks import Problem, language_of
from day6_core.shell.editing.copies import Holder
from day6_core.shell.editing.model import CannotEdit, Editor
from day6_tui.appearance.look import Look
from day6_tui.overlays.menu import Menu, MenuEntry
from day6_tui.overlays.question import Answer, Question
from day6_tui.panes.cells import wrap
from day6_tui.panes.pane import Piece
from day6_tui.panes.placement import PaneNeeds
from day6_tui.panes.splits import Extent
from day6_tui.terminals.keys import decode
from day6_tui.windows import WindowPane
from day6_tui.windows.editor.area import EditorArea, has_grammar

KEEP_SECONDS = 1.0
"""Seconds after the first key that the last copy lacks, at which the next one is written: also if one types without a pause."""

CHECK_SECONDS = 1.0
"""Seconds after the last key at which the text is checked."""

LOOK_SECONDS = 1.0
"""How often the file on the disk is looked at."""


class EditorPane(WindowPane[Editor]):
    """Draws the frame and the status lines; the text, its cursor and its history belong to the TextArea."""

    needs = PaneNeeds(Extent(45, 10), Extent(50, 24), Extent(90, 40), 1.5)

    takes_focus = True
    covers_keyboard = True
    closes_on_quit = True

    def __init__(self, window: Window[Editor], look: Look) -> None:
        super().__init__(window, look)
        self.editor = window.model
        self.area = EditorArea(self, look)
        self.problem: Problem | None = None
        self._version = -1
        self._edited = 0.0
        """When the text was changed last, 0 if it has been checked since."""
        self._unsafe = 0.0
        """When the first change was made that the copy lacks, 0 if it has all."""
        self._looked = 0.0
        self._kept: str | None = ""
        """The text that is in the file or in the copy; None if it is in neither."""
        self._others: list[Holder] = []
        self._outside = False
        self._message = ""
        self._sought = ""
        self._unkept = ""
        """Why there is no copy of the unsaved text; '' if there is one, or nothing to keep."""
        self._again = ""
        """The request that is carried out if it is repeated: 'save', 'close', 'lose', or ''."""
        self._gone = False
        """Whether the file existed and is gone."""
        self._discarded = False
        """Whether the user wants the changes thrown away."""
        self._agreed: Path | None = None
        """The file outside the home folder that the user allowed to be written."""

    def compose(self) -> ComposeResult:
        yield self.area

    # -- frame ---------------------------------------------------------------------------------------------------------

    @property
    def changed(self) -> bool:
        """Whether the text differs from the file."""
        return self.editor.file is not None and self.area.text != self.editor.saved

    @property
    def label(self) -> str:
        mark = f" {self.look.glyphs.news}" if self.changed else ""
        return f"{self.editor.name}  {self.editor.title()}{mark}"

    def status(self) -> list[Piece]:
        colours, texts = self.look.colours, self.look.texts
        if self._message:
            return [Piece(f" {self._message} ", colours.warning)]
        if self._unkept:
            return [Piece(f" {texts('editor.not_kept', reason=self._unkept)} ", colours.warning)]
        if self._outside:
            return [Piece(f" {texts('editor.gone' if self._gone else 'editor.outside')} ", colours.warning)]
        also = [Piece(f" {self._also_open_in(holder)} ", colours.warning) for holder in self._others[:1]]
        if self.problem is not None:
            return [*also, Piece(f" {self._problem_in_short(self.problem)} ", colours.warning)]
        if self.editor.recovered:
            return [*also, Piece(f" {texts('editor.recovered')} ", colours.warning)]
        return also

    def _also_open_in(self, holder: Holder) -> str:
        """That another window, or another desktop, has the file open."""
        here = holder.process == os.getpid()
        return self.look.texts("editor.also" if here else "editor.also.elsewhere", **holder._asdict())

    def _problem_in_short(self, problem: Problem) -> str:
        """What is wrong, in the reader's language where a card knows it, else in the checker's own words."""
        from day6_core.advice.rules import in_short

        texts = self.look.texts
        said = in_short(problem.message, problem.line, texts.language)
        if not said or not any(char.isdecimal() for char in said):
            said = texts("editor.problem", line=problem.line, text=said or problem.message)
        return said[0].upper() + said[1:]

    def status_right(self) -> list[Piece]:
        if self.editor.file is None:
            return []
        row, column = self.area.cursor_location
        return [Piece(f" {row + 1}:{column + 1} ", self.look.colours.muted)]

    def key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        if self.editor.file is None:
            return [("Enter", texts("editor.files")), ("^W", texts("editor.close"))]
        return [
            ("^S", texts("editor.save")),
            ("^X" if self._is_nano else "^W", texts("editor.close")),  # before the others: they go first without room
            ("^F", texts("editor.find")),
            ("^G", texts("editor.line")),
        ]

    def more_key_hints(self) -> list[tuple[str, str]]:
        texts = self.look.texts
        nano = [("^O", texts("editor.write")), ("^K ^U", texts("editor.cut"))] if self._is_nano else []
        return [
            *nano,
            ("Tab", texts("editor.tab")),
            ("Shift+Tab", texts("editor.outdent")),
            ("^Z ^Y", texts("editor.undo")),
            ("^T", texts("editor.open")),
            ("^R", texts("editor.reload")),
        ]

    @property
    def _is_nano(self) -> bool:
        return self.editor.name == "nano"

    def content_line(self, y: int, width: int) -> Iterable[Segment]:
        if self.editor.file is not None:
            return ()
        lines = wrap(self.look.texts("editor.choose"), width)
        return [Segment(lines[y], self.look.colours.muted)] if y < len(lines) else ()

    def restyle(self) -> None:
        super().restyle()
        self.area.take_look(self.look)

    # -- frames --------------------------------------------------------------------------------------------------------

    def pull(self, now: float) -> bool:
        if self.editor.version != self._version:
            self._version = self.editor.version
            self._show_file()
            self.touch()
        if self.editor.file is None:
            return False
        if keys := self.typed_ahead():
            self.area.call_next(self.area.take_keys, keys)
            self.post_message(self.KeyboardWanted(self))
        if self._unsafe and now - self._unsafe >= KEEP_SECONDS:
            self._keep(self.area.text)
            self.touch_frame()
        if self._edited and now - self._edited >= CHECK_SECONDS:
            self._check()
        if now - self._looked >= LOOK_SECONDS:
            self._looked = now
            self._look_at_the_disk()
        due = [(self._unsafe, KEEP_SECONDS), (self._edited, CHECK_SECONDS), (self._looked, LOOK_SECONDS)]
        self.look.wake_after(max(0.0, min(since + seconds for since, seconds in due if since) - now))
        return False

    def _look_at_the_disk(self) -> None:
        """Load what another program wrote, unless that would lose text that only this window has."""
        if self._unkept:
            self._keep(self.area.text)
            self.touch_frame()
        if self._others != (others := self.editor.others()):
            self._others = others
            self.touch_frame()
        outside = self.editor.changed_outside()
        gone = outside and not self.editor.exists()
        if gone and not self._gone:
            self.editor.saved = ""  # this text now exists nowhere else
            self._kept, self._unsafe = None, time.monotonic()
        before, self._gone = (self._outside, self._gone), gone
        if outside and not gone and not self.changed:
            self._reload()
        elif (outside, gone) != before:
            self._outside = outside
            self.touch_frame()

    def typed_ahead(self) -> list[events.Key]:
        """Return what was typed in the terminal that runs the editor, since the last call."""
        return [events.Key(*decode(key)) for key in split_keys(self.editor.take_typed())]

    def edited(self) -> None:
        """The text was changed."""
        self._edited = time.monotonic()
        self._unsafe = self._unsafe or self._edited
        self._message = ""
        self._again = ""
        self.touch_frame()
        self.look.wake()

    def _show_file(self) -> None:
        file = self.editor.file
        self.area.display = file is not None
        if file is None:
            return
        language = language_of(file.path)
        known = language in self.area.available_languages
        self.area.language = language if known and has_grammar(language) else None
        self.area.load_text(self.editor.text)
        self._kept = self.editor.text
        self._check()
        if self.editor.left:
            self._offer_what_was_left()

    def _offer_what_was_left(self) -> None:
        """Several editors died with this file unsaved: the text of the last one is shown, the others can be chosen."""
        entries = [MenuEntry(self.look.texts("editor.left.shown"), "", lambda: None)]
        for copy in self.editor.left:
            when = time.strftime("%Y-%m-%d %H:%M:%S", time.localtime(copy.time))
            about = self.look.texts("editor.left.copy", when=when, lines=copy.text.count("\n") + 1)
            entries.append(MenuEntry(about, "", partial(self.editor.choose, copy)))
        self.lay_over(Menu(self.look, "editor.left", entries))

    def _check(self) -> None:
        self._edited = 0.0
        problem = self.editor.check(self.area.text)
        if problem != self.problem:
            self.problem = problem
            self.area.forget_lines()
        self.touch_frame()

    def _keep(self, text: str) -> bool:
        """Keep a copy of the unsaved text; return False, and show why, if that is impossible."""
        self._unsafe = 0.0
        if text != self._kept or self._unkept:
            try:
                self.editor.keep(text)
            except OSError as error:
                self._unkept = reason(error)
                return False
            self._kept, self._unkept = text, ""
        return True

    def loses_at_the_end(self) -> str:
        if not self.changed or self._keep(self.area.text):
            return ""
        return f"{self.editor.title()} ({self._unkept})"

    def on_hide(self) -> None:
        """Nothing is drawn from now on: keep what was typed last."""
        if self._unsafe:
            self._keep(self.area.text)

    def on_unmount(self) -> None:
        """The program was ended from outside: keep what was typed last too."""
        if self.changed and not self._discarded:
            with contextlib.suppress(OSError):  # the window that would say so is gone
                self.editor.keep(self.area.text)
        self.editor.close()

    # -- doing ---------------------------------------------------------------------------------------------------------

    def save(self) -> bool:
        """Write the file; return False, and show why, if that failed."""
        if self.editor.file is None:
            return False
        path = self.editor.file.path
        self._outside = self.editor.changed_outside()  # since the last look at the disk
        beyond = self._agreed != path and self.editor.is_outside(path)
        if (self._outside or beyond) and self._again != "save":
            self._again = "save"
            self._message = self.look.texts("editor.overwrite" if self._outside else "editor.beyond")
            self.touch_frame()
            return False
        try:
            self.editor.save(self.area.text)
        except OSError as error:
            self._message = self.look.texts("editor.not_saved", reason=reason(error))
            self.touch_frame()
            return False
        self._kept, self._outside, self._message, self._again = self.area.text, False, "", ""
        self._unkept, self._gone = "", False
        self._agreed = path
        self.touch_frame()
        return True

    def close(self) -> None:
        """Close the window; with unsaved text ask first.

        nano throws away what shall not be saved; the others keep a copy, and need the answer twice if there is no room for one.
        """
        if self.changed:
            self._ask_before_leaving()
        else:
            self.window.close_by_user()

    def _ask_before_leaving(self) -> None:
        """Save (nano names the file once more), do not save, or go on writing."""
        texts = self.look.texts
        save = partial(self.write_as, leave=True) if self._is_nano else self._save_and_leave
        discard = self._discard if self._is_nano else self._leave_a_copy
        answers = [
            Answer("y", texts("editor.modified.save"), save),
            Answer("n", texts("editor.modified.discard"), discard),
        ]
        text = texts("editor.modified.text", file=self.editor.title())
        self.lay_over(Question(self.look, texts("editor.modified"), text, answers))

    def _discard(self) -> None:
        self._discarded = True
        self.editor.keep(self.editor.saved)
        self.window.close_by_user()

    def _save_and_leave(self) -> None:
        if self.save():
            self.window.close_by_user()

    def _leave_a_copy(self) -> None:
        if self._keep(self.area.text) or self._again == "lose":
            self.window.close_by_user()
            return
        self._again = "lose"
        self._message = self.look.texts("editor.lose", reason=self._unkept)
        self.touch_frame()

    def write_as(self, leave: bool = False) -> None:
        """nano's ^O: show the name and save when Enter is pressed; under another name if it was changed."""
        if self.editor.file is None:
            return
        own = self.editor.title()
        asked = ""

        def taken(name: str) -> str | None:
            nonlocal asked
            path = self.editor.folder / name
            if name == own:
                if not self.save():
                    return self._message
            elif not name.strip():
                return self.look.texts("editor.name")
            elif name != asked and (path.exists() or self.editor.is_outside(path)):
                asked = name
                beyond = self.editor.is_outside(path)
                return self.look.texts("editor.beyond" if beyond else "editor.exists", name=name)
            else:
                try:
                    self.editor.save_as(path, self.area.text)
                except OSError as error:
                    return self.look.texts("editor.not_saved", reason=reason(error))
            if leave:
                self.window.close_by_user()
            self.look.wake()
            return None

        self.ask(self.look.texts("editor.write.name"), own, taken)

    def _reload(self) -> None:
        place = self.area.cursor_location
        try:
            self.area.load_text(self.editor.reload())
        except CannotEdit as error:
            self._message = str(error)
        self.area.move_cursor(place)
        self._outside = False
        self._keep(self.area.text)
        self._check()

    def find(self) -> None:
        """Ask for a text and go to its next occurrence; the same text again goes to the one after that."""

        def taken(text: str) -> str | None:
            self._sought = text
            place = self._next_place(text)
            if place is None:
                return self.look.texts("editor.not_found", text=text) if text else None
            row, column = place
            self.area.selection = Selection((row, column), (row, column + len(text)))
            return None

        self.ask(self.look.texts("editor.find"), self._sought, taken)

    def _next_place(self, text: str) -> tuple[int, int] | None:
        """The next occurrence of `text` after the cursor, wrapping around at the end."""
        if not text:
            return None
        lines = self.area.text.split("\n")
        row, column = self.area.cursor_location
        for step in range(len(lines) + 1):
            at = (row + step) % len(lines)
            found = lines[at].lower().find(text.lower(), column if step == 0 else 0)
            if found >= 0:
                return at, found
        return None

    def go_to_line(self) -> None:
        """Ask for a line number and go there."""

        def taken(text: str) -> str | None:
            count = self.area.document.line_count
            if not text.isdigit() or not 1 <= int(text) <= count:
                return self.look.texts("editor.lines", count=count)
            self.area.move_cursor((int(text) - 1, 0), center=True)
            return None

        line = self.problem.line if self.problem is not None else self.area.cursor_location[0] + 1
        self.ask(self.look.texts("editor.line"), str(line), taken)

    def choose_file(self) -> None:
        """Offer the files of the folder, and a new one."""

        def chosen(path: Path) -> None:
            if self.changed and not self._keep(self.area.text):
                self.touch_frame()  # it says why: the text would be gone
                return
            try:
                self.editor.open(path)
            except CannotEdit as error:
                self._message = str(error)
                self.touch_frame()
            self.look.wake()

        files = self.editor.files()
        entries = [
            MenuEntry(path.relative_to(self.editor.folder).as_posix(), "", partial(chosen, path)) for path in files
        ]
        entries.append(MenuEntry(self.look.texts("editor.new"), "", partial(self._ask_new_file, chosen)))
        self.lay_over(Menu(self.look, "editor.files", entries))

    def offer(self, words: list[str], taken: Callable[[str], object]) -> None:
        """Offer the words of a completion."""
        self.lay_over(Menu(self.look, "editor.complete", [MenuEntry(word, "", partial(taken, word)) for word in words]))

    def _ask_new_file(self, chosen: Callable[[Path], object]) -> None:
        """Ask for the name of a new file; it is created when it is saved."""

        def taken(name: str) -> str | None:
            path = self.editor.folder / name.strip()
            if not name.strip() or path.is_dir():
                return self.look.texts("editor.name")
            if not path.parent.is_dir():
                return self.look.texts("editor.no_folder", name=path.parent.relative_to(self.editor.folder))
            chosen(path)
            return None

        self.ask(self.look.texts("editor.new"), "", taken)

    # -- keys ----------------------------------------------------------------------------------------------------------

    @property
    def focus_target(self) -> Widget:
        """The text, or the choice of files while there is none."""
        return self.area if self.editor.file is not None and self.area.is_attached else self

    def focus(self, scroll_visible: bool = True) -> EditorPane:
        if self.focus_target is self.area:
            self.area.focus(scroll_visible)
        else:
            super().focus(scroll_visible)
        return self

    def on_key(self, event: events.Key) -> None:
        if self.editor.file is None and event.key in ("enter", "ctrl+t", "ctrl+w"):
            (self.close if event.key == "ctrl+w" else self.choose_file)()
            event.stop()

    def used(self, key: str) -> bool:
        """Handle a key of the editor; return False if it isn't one."""
        actions: dict[str, Callable[[], object]] = {
            "ctrl+s": self.save,
            "ctrl+f": self.find,
            "ctrl+g": self.go_to_line,
            "ctrl+t": self.choose_file,
            "ctrl+r": self._reload,
            "ctrl+x" if self._is_nano else "ctrl+w": self.close,
        }
        if self._is_nano:
            actions |= {
                "ctrl+o": self.write_as,
                "ctrl+w": self.find,
                "ctrl+underscore": self.go_to_line,
                "ctrl+k": self.area.cut_line,
                "ctrl+u": self.area.put_line,
            }
        action = actions.get(key)
        if action is not None:
            action()
        return action is not None

"""The console's filters as menus: which there are, what each of them says, and what else the chosen message can become."""

from __future__ import annotations

import re
import time
from collections.abc import Callable, Iterator
from dataclasses import replace
from datetime import datetime
from functools import partial
from typing import TYPE_CHECKING, Any

from day6_core.ros.programs.rqt_console.filters import KINDS, MANY, SIDES, Filter
from day6_core.ros.programs.rqt_console.model import SEVERITIES, Console, Record
from day6_core.session.harmless import one_line
from day6_tui.overlays.menu import Menu, MenuEntry
from day6_tui.overlays.prompt import Prompt
from day6_tui.windows.console.table import time_of_day, whole_time

if TYPE_CHECKING:
    from day6_tui.appearance.look import Look
    from day6_tui.overlays.modal import Modal

_TIME = re.compile(r"(?:(\d{4})-(\d\d?)-(\d\d?)\s+)?(\d\d?):(\d\d)(?::(\d\d)(?:\.(\d{1,9}))?)?")

LONGEST = 200
"""Characters of a message that a filter looks for."""


class FilterMenus:
    """Opens menus over the desktop; every change takes effect at once, and the menu comes back where it was."""

    def __init__(
        self, look: Look, console: Console, lay_over: Callable[[Modal], None], type_text: Callable[[str, int], None]
    ) -> None:
        """`type_text` lets the text of a filter be typed: its side and place."""
        self._look, self._console, self._lay_over, self._type_text = look, console, lay_over, type_text

    def open(self, record: Record | None, chosen: int = 0) -> None:
        """Show the filters, and what can be done with a message."""
        texts, choice = self._look.texts, self._console.choice
        entries = []
        for side in SIDES:
            for each in getattr(choice, side):
                name = f"{_box(each.enabled)} {texts(f'console.{side}.kind.{each.kind}')}"
                remove = partial(self._change, side, each, None)
                entries.append(MenuEntry(name, brief(each), partial(self._edit, side, each, record), remove))
            entries.append(MenuEntry(texts(f"console.{side}.add"), "", partial(self._add, side, record)))
        entries.append(MenuEntry(f"{_box(choice.only_highlighted)} {texts('console.only')}", "", self._toggle_only))
        if record is not None:
            for side in SIDES:
                entries += self._of_record(side, record)
        self._lay_over(Menu(self._look, "console.filters.title", entries, chosen=chosen, keys="menu.keys.remove"))

    def _of_record(self, side: str, record: Record) -> Iterator[MenuEntry]:
        """What a right click offers in rqt_console."""
        texts = self._look.texts
        for kind, note, changes in (
            ("node", record.node, {"nodes": frozenset((record.node,))}),
            ("severity", record.severity, {"levels": frozenset((record.level,))}),
            ("message", " ".join(record.text[:LONGEST].split()), {"text": record.text[:LONGEST]}),
        ):
            yield MenuEntry(
                texts(f"console.{side}.this.{kind}"), one_line(note), partial(self._mean, side, kind, changes)
            )

    def _mean(self, side: str, kind: str, changes: dict[str, Any]) -> None:
        """Let a filter mean a message, too: of texts each has one of its own."""
        choice = self._console.choice
        before = choice.first(side, kind)
        at = choice.place_of(side, kind)
        if "text" in changes and before.text:
            before, at = Filter(kind), len(getattr(choice, side))
        merged = {name: getattr(before, name) | new if name != "text" else new for name, new in changes.items()}
        self._console.set_filter(side, at, replace(before, enabled=True, is_regex=False, **merged))
        self._look.wake()

    def _toggle_only(self) -> None:
        self._console.show_highlighted_only(not self._console.choice.only_highlighted)
        self._look.wake()

    def _change(self, side: str, each: Filter, new: Filter | None) -> None:
        filters = getattr(self._console.choice, side)
        at = next((at for at, other in enumerate(filters) if other is each), None)
        if at is not None:
            self._console.set_filter(side, at, new)
            self._look.wake()

    # -- one filter ----------------------------------------------------------------------------------------------------

    def _add(self, side: str, record: Record | None) -> None:
        texts, there = self._look.texts, {each.kind for each in getattr(self._console.choice, side)}
        entries = [
            MenuEntry(texts(f"console.kind.{kind}"), "", partial(self._begin, side, kind, record))
            for kind in KINDS
            if kind in MANY or kind not in there
        ]
        self._lay_over(Menu(self._look, f"console.{side}.add", entries))

    def _begin(self, side: str, kind: str, record: Record | None) -> None:
        since = (record.stamp_ns if record is not None else time.time_ns()) if kind == "time" else 0
        each, at = Filter(kind, start_ns=since), len(getattr(self._console.choice, side))
        self._console.set_filter(side, at, each)
        if kind in MANY:
            self._type_text(side, at)
        else:
            self._edit(side, each, record)
        self._look.wake()

    def _edit(self, side: str, each: Filter, record: Record | None, chosen: int = 0) -> None:
        texts = self._look.texts
        lines: list[tuple[str, str, Callable[[], object]]] = []

        def switch(text: str, on: bool, **changes: Any) -> None:
            lines.append((f"{_box(on)} {text}", "", partial(self._replace, side, each, changes, record, len(lines))))

        for part in KINDS[each.kind]:
            if part == "text":
                lines.append((texts("console.text"), each.text, partial(self._type, side, each)))
                switch(texts("console.regexp"), each.is_regex, is_regex=not each.is_regex)
            elif part == "levels":
                for level, name in SEVERITIES.items():
                    switch(name, level in each.levels, levels=each.levels ^ {level})
            elif part == "nodes":
                for node in sorted(self._console.nodes() | each.nodes):
                    switch(node, node in each.nodes, nodes=each.nodes ^ {node})
            else:
                value = getattr(each, part)
                note = whole_time(value) if value is not None else texts("console.no_end")
                lines.append((texts(f"console.{part}"), note, partial(self._ask_time, side, each, part, record)))
        switch(texts("console.enabled"), each.enabled, enabled=not each.enabled)
        lines.append((texts("console.remove"), "", partial(self._change, side, each, None)))
        entries = [MenuEntry(one_line(name), one_line(note), choose) for name, note, choose in lines]
        self._lay_over(Menu(self._look, f"console.{side}.kind.{each.kind}", entries, chosen=chosen))

    def _type(self, side: str, each: Filter) -> None:
        self._type_text(side, getattr(self._console.choice, side).index(each))

    def _replace(self, side: str, each: Filter, changes: dict[str, Any], record: Record | None, chosen: int) -> None:
        new = replace(each, **changes)
        self._change(side, each, new)
        self._edit(side, new, record, chosen)

    def _ask_time(self, side: str, each: Filter, part: str, record: Record | None) -> None:
        texts, before = self._look.texts, getattr(each, part)

        def taken(text: str) -> str | None:
            near = before if before is not None else each.start_ns
            value = None if part == "stop_ns" and not text.strip() else nanoseconds_of(text, near)
            if value is None and text.strip():
                return texts("console.wrong_time")
            changes: dict[str, Any] = {part: value if part == "stop_ns" else value or 0}
            self._change(side, each, replace(each, **changes))
            return None

        shown = whole_time(before) if before is not None else ""
        note = texts(f"console.{part}.note")
        self._lay_over(Prompt(self._look, texts(f"console.{part}"), shown, taken, note=note))


def _box(ticked: bool) -> str:
    return "[x]" if ticked else "[ ]"


def brief(each: Filter) -> str:
    """What a filter means, as short as possible; '' if it says nothing."""
    if each.kind == "time":
        end = time_of_day(each.stop_ns) if each.stop_ns is not None else ""
        return f"{time_of_day(each.start_ns)} - {end}".rstrip()
    quote = "/" if each.is_regex else '"'
    parts = [f"{quote}{' '.join(each.text.split())}{quote}"] if each.text else []
    parts += [", ".join(SEVERITIES.get(level, str(level)) for level in sorted(each.levels))] if each.levels else []
    parts += [", ".join(sorted(each.nodes))] if each.nodes else []
    return one_line(" + ".join(parts))


def nanoseconds_of(text: str, near_ns: int) -> int | None:
    """The stamp (ns since 1970) of a local time like 14:05, 14:05:01.250 or 2026-01-31 14:05; None for anything else.

    Without a date it is on the day of another stamp.
    """
    match = _TIME.fullmatch(text.strip())
    if match is None:
        return None
    year, month, day, hour, minute, second, fraction = match.groups()
    try:
        if year is None:
            year, month, day = time.localtime(near_ns // 1_000_000_000)[:3]
        moment = datetime(int(year), int(month), int(day), int(hour), int(minute), int(second or 0))
        whole = time.mktime(moment.timetuple())  # `timestamp` looks a day back, which Windows refuses in 1970
    except (OSError, OverflowError, ValueError):
        return None
    return int(whole) * 1_000_000_000 + int((fraction or "0").ljust(9, "0"))

"""Menus of interactive markers, whose entries call functions (interactive_markers 2.5.4)."""

from __future__ import annotations

import sys
from collections.abc import Callable
from dataclasses import dataclass, field
from typing import TYPE_CHECKING, Any

from visualization_msgs.msg import InteractiveMarkerFeedback, MenuEntry

if TYPE_CHECKING:
    from interactive_markers.interactive_marker_server import InteractiveMarkerServer


@dataclass
class EntryContext:
    """One entry."""

    title: str
    command: str
    command_type: int
    feedback_cb: Any
    """Called with the feedback; an entry without one that is chosen raises TypeError, as in the original."""
    sub_entries: list[int] = field(default_factory=list)
    visible: bool = True
    check_state: int = 0


class MenuHandler:
    """A tree of entries, known by handles from 1 on; `apply` gives it to a marker."""

    NO_CHECKBOX = 0
    CHECKED = 1
    UNCHECKED = 2

    def __init__(self) -> None:
        self.top_level_handles_: list[int] = []
        self.entry_contexts_: dict[int, EntryContext] = {}
        self.current_handle_ = 1
        self.managed_markers_: set[str] = set()

    def insert(
        self,
        title: str,
        parent: int | None = None,
        command_type: int = MenuEntry.FEEDBACK,
        command: str = "",
        callback: Callable[[InteractiveMarkerFeedback], object] | None = None,
    ) -> int | None:
        """Add an entry, below another one if `parent` is its handle; return the new handle, None if there is no parent."""
        handle = self.current_handle_
        self.current_handle_ += 1
        self.entry_contexts_[handle] = EntryContext(title, command, command_type, callback)
        if parent is None:
            self.top_level_handles_.append(handle)
        elif (above := self.entry_contexts_.get(parent)) is not None:
            above.sub_entries.append(handle)
        else:
            print(f"Parent menu entry '{parent}' not found", file=sys.stderr)
            return None
        return handle

    def setVisible(self, handle: int, visible: bool) -> bool:
        """Show or hide an entry and what is below it; False if there is no such entry."""
        if handle not in self.entry_contexts_:
            return False
        self.entry_contexts_[handle].visible = visible
        return True

    def setCheckState(self, handle: int, check_state: int) -> bool:
        """Give an entry a box, CHECKED or UNCHECKED, or none; False if there is no such entry."""
        if handle not in self.entry_contexts_:
            return False
        self.entry_contexts_[handle].check_state = check_state
        return True

    def getCheckState(self, handle: int) -> int | None:
        """The state of an entry's box; None if there is no such entry."""
        entry = self.entry_contexts_.get(handle)
        return entry.check_state if entry is not None else None

    def getTitle(self, handle: int) -> str | None:
        """The title of an entry; None if there is no such entry."""
        entry = self.entry_contexts_.get(handle)
        return entry.title if entry is not None else None

    def apply(self, server: InteractiveMarkerServer, marker_name: str) -> bool:
        """Give the menu to a marker, with the next `applyChanges` of its server.

        Returns False if the marker has gone since the last time. Raises KeyError if there never was one of that name.
        """
        marker = server.get(marker_name)
        if marker is None:
            self.managed_markers_.remove(marker_name)
            return False
        marker.menu_entries = self._entries(self.top_level_handles_, 0)
        server.insert(
            marker, feedback_callback=self.processFeedback, feedback_type=InteractiveMarkerFeedback.MENU_SELECT
        )
        self.managed_markers_.add(marker_name)
        return True

    def reApply(self, server: InteractiveMarkerServer) -> bool:
        """Give the menu, as it is now, to all markers that have it; False if one of them has gone."""
        given = [self.apply(server, name) for name in list(self.managed_markers_)]
        return all(given)

    def processFeedback(self, feedback: InteractiveMarkerFeedback) -> None:
        """Call the function of the entry that was chosen."""
        if feedback.menu_entry_id in self.entry_contexts_:
            self.entry_contexts_[feedback.menu_entry_id].feedback_cb(feedback)

    def _entries(self, handles: list[int], parent: int) -> list[MenuEntry]:
        boxes = {self.CHECKED: "[x] ", self.UNCHECKED: "[ ] "}
        found: list[MenuEntry] = []
        for handle in handles:
            entry = self.entry_contexts_[handle]
            if entry.visible:
                title = boxes.get(entry.check_state, "") + entry.title
                command, kind = entry.command, entry.command_type
                found.append(MenuEntry(id=handle, parent_id=parent, title=title, command=command, command_type=kind))
                found += self._entries(entry.sub_entries, handle)
        return found

"""The text of a message type with the types it contains, as it is stored in bags."""

from __future__ import annotations

from day6_core.interfaces import InterfaceNameError, UnknownInterfaceError, definition_text
from rosbag2_py._storage import MessageDefinition

_LINE = "=" * 80


class LocalMessageDefinitionSource:
    """Finds the texts of message types among the interfaces of this machine."""

    def get_full_text(self, root_type: str) -> MessageDefinition:
        """Return the text of 'package/msg/Name', followed by those of the types in it; an empty text is 'unknown'.

        Types that are derived from a service or action ('…_Event', '…_FeedbackMessage') have no text of their own.
        """
        texts: list[str] = []
        try:
            self._collect(root_type, texts, set())
        except (UnknownInterfaceError, InterfaceNameError, ValueError):
            return MessageDefinition(root_type, "unknown", "", "")
        return MessageDefinition(root_type, "ros2msg", "\n".join(texts), "")

    def _collect(self, name: str, texts: list[str], seen: set[str]) -> None:
        from day6_core.interfaces.registry import structure

        text = definition_text(name)
        if texts:
            package, _, base = name.split("/")
            text = f"{_LINE}\nMSG: {package}/{base}\n{text}"
        texts.append(text)
        for inner in sorted({field.type.base for field in structure(name).fields if field.type.nested}):
            if inner not in seen:
                seen.add(inner)
                self._collect(inner, texts, seen)

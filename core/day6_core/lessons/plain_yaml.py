"""YAML as teachers write it: with the lines of keys, no key twice, and problems told in plain words."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import yaml

from day6_core.lessons.flaws import Flaw, MarkedList, MarkedMap

MOST_NODES = 50_000
"""Values of a text, those that are repeated by '*NAME' counted each time."""

_COLON = "': ' inside a text: put the text in quotes, or a command below 'type: |', on lines of its own"
_INDENT = "this line is not indented like the lines it belongs to: those of one list begin in the same column"
_BRACKET = "a '[' or '{' that is not closed; a text that begins with one needs quotes"
_QUOTES = "a text that begins with '*', '&', '!', '%', '@' or '`' needs quotes"

_WORDS = (
    (r"found character '\\t'", "a tab: indent with blanks"),
    (r"mapping values are not allowed", ""),  # two causes: see _plain
    (r"expected <block end>", _INDENT),
    (r"expected ',' or '[\]}]'", _BRACKET),
    (r"did not find expected ',' or|while parsing a flow", _BRACKET),
    (r"could not find expected ':'", "expected 'key: value' here, or a line of the text above that is indented like it"),
    (r"unexpected end of stream|found unknown escape", "a quote that is not closed, or a '\\' in a text in \"…\": use '…'"),
    (r"undefined alias|cannot start any token|expected alphabetic|constructor for the tag|expected URI", _QUOTES),
    (r"special characters are not allowed", "a character that cannot be shown"),
    (r"recursion", "too many brackets in one another"),
)  # fmt: skip


class NotYaml(Exception):
    """A text that is no YAML; `flaw` says why and where."""

    def __init__(self, flaw: Flaw) -> None:
        super().__init__(str(flaw))
        self.flaw = flaw


def read_yaml(text: str, line: int) -> tuple[Any, list[Flaw]]:
    """The value of a text that begins in `line`, and the keys that are there twice. Raises NotYaml."""
    loader = None
    try:
        loader = _Loader(text)
        loader.first = line
        return loader.get_single_data(), loader.twice
    except yaml.YAMLError as error:
        raise NotYaml(_plain(error, text.split("\n"), line)) from None
    except (ValueError, RecursionError) as error:  # a date that does not exist; a thousand brackets
        reason = "too many brackets in one another" if isinstance(error, RecursionError) else str(error)
        raise NotYaml(Flaw(reason.split("\n")[0], line)) from None
    finally:
        if loader is not None:
            loader.dispose()


class _Loader(yaml.SafeLoader):
    """Makes MarkedMap and MarkedList."""

    first = 1

    def __init__(self, text: str) -> None:
        super().__init__(text)
        self.twice: list[Flaw] = []
        self._open: list[str] = []
        self._sizes: dict[int, int] = {}
        """id of a node -> how many values it has."""

    def compose_node(self, parent: Any, index: Any) -> Any:
        """Compose a node; nothing may contain itself, or grow without measure by what it repeats."""
        event: Any = self.peek_event()  # type: ignore[no-untyped-call]
        again, anchor = isinstance(event, yaml.AliasEvent), getattr(event, "anchor", None)
        if again and anchor in self._open:
            raise yaml.composer.ComposerError(None, None, "it contains itself", event.start_mark)
        if anchor and not again:
            self._open.append(anchor)
        node: Any = super().compose_node(parent, index)
        if anchor and not again:
            self._open.remove(anchor)
        if id(node) not in self._sizes:
            inside = node.value if isinstance(node.value, list) else []
            parts = [part for each in inside for part in (each if isinstance(each, tuple) else (each,))]
            self._sizes[id(node)] = 1 + sum(self._sizes[id(part)] for part in parts)
        if self._sizes[id(node)] > MOST_NODES:
            raise yaml.composer.ComposerError(None, None, "it repeats too much", event.start_mark)
        return node

    def line_at(self, node: yaml.Node) -> int:
        return self.first + int(node.start_mark.line)

    def marked_map(self, node: yaml.MappingNode) -> Iterator[MarkedMap]:
        made = MarkedMap()
        made.line = self.line_at(node)
        yield made
        for key_node, _ in node.value:
            key, line = str(self.construct_object(key_node, deep=True)), self.line_at(key_node)
            if key in made.lines:
                self.twice.append(Flaw(f"'{key}' is there twice (line {made.lines[key]}): put both into one", line))
            made.lines.setdefault(key, line)
        made.update((str(key), value) for key, value in self.construct_mapping(node).items())

    def marked_list(self, node: yaml.SequenceNode) -> Iterator[MarkedList]:
        made = MarkedList()
        made.line = self.line_at(node)
        yield made
        made.lines = dict(enumerate(map(self.line_at, node.value)))
        made.extend(self.construct_sequence(node))


_Loader.add_constructor("tag:yaml.org,2002:map", _Loader.marked_map)
_Loader.add_constructor("tag:yaml.org,2002:seq", _Loader.marked_list)


def _plain(error: yaml.YAMLError, rows: list[str], first: int) -> Flaw:
    problem = getattr(error, "problem", None) or getattr(error, "reason", None) or str(error).split("\n")[0]
    context = getattr(error, "context", None) or ""
    mark, begin = getattr(error, "problem_mark", None), getattr(error, "context_mark", None)
    at = mark.line if mark is not None else 0
    words = next((words for pattern, words in _WORDS if re.search(pattern, f"{problem} {context}")), problem)
    row = rows[at] if at < len(rows) else ""
    if not words:
        words = _COLON if mark is not None and row[: mark.column + 1].count(":") > 1 else _INDENT
    elif begin is not None and ("quoted" in context or words == _BRACKET):
        at = begin.line  # where the quote or the bracket was opened
    if "\t" in row[: len(row) - len(row.lstrip())]:
        words = "a tab: indent with blanks"
    return Flaw(words, first + min(at, max(0, len(rows) - 1)))

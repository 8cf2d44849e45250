"""Reads XML as TinyXML-2 does, the reader of urdfdom 4 (and so of check_urdf and robot_state_publisher).

It replaces expat because a student's result depends on TinyXML's behaviour: which malformed files it accepts (two roots, text
around the root, `&` anywhere, undeclared prefixes), which error it reports for the others and on which line. Entities other
than XML's five and character references are never expanded and nothing outside the text is ever opened, so neither a "billion
laughs" nor an external entity has any effect.
"""

from __future__ import annotations

import re
from bisect import bisect_left
from dataclasses import dataclass, field

MAX_DEPTH = 500
"""Nesting depth of elements, TinyXML-2 10 (TINYXML2_MAX_ELEMENT_DEPTH)."""

_ERROR_NUMBERS = {
    "XML_ERROR_PARSING_ELEMENT": 6,
    "XML_ERROR_PARSING_ATTRIBUTE": 7,
    "XML_ERROR_PARSING_TEXT": 8,
    "XML_ERROR_PARSING_CDATA": 9,
    "XML_ERROR_PARSING_COMMENT": 10,
    "XML_ERROR_PARSING_DECLARATION": 11,
    "XML_ERROR_PARSING_UNKNOWN": 12,
    "XML_ERROR_EMPTY_DOCUMENT": 13,
    "XML_ERROR_MISMATCHED_ELEMENT": 14,
    "XML_ERROR_PARSING": 15,
    "XML_ELEMENT_DEPTH_EXCEEDED": 18,
}

_SPACE = re.compile(r"[ \t\n\v\f\r]*")
_NAME = re.compile(r"[A-Za-z_:\x80-\U0010ffff][A-Za-z0-9_:.\-\x80-\U0010ffff]*")
_ENTITY = re.compile(r"&(?:(quot|amp|apos|lt|gt)|#([0-9]+)|#x([0-9A-Fa-f]+));")
_NEWLINE = re.compile(r"\r\n?|\n\r")
_NAMED = {"quot": '"', "amp": "&", "apos": "'", "lt": "<", "gt": ">"}

# Constructs that are skipped: opening, closing, the error if the closing is missing. The order matters ("<!" comes last).
_SKIPPED = (
    ("<?", "?>", "XML_ERROR_PARSING_DECLARATION"),
    ("<!--", "-->", "XML_ERROR_PARSING_COMMENT"),
    ("<![CDATA[", "]]>", "XML_ERROR_PARSING_CDATA"),
    ("<!", ">", "XML_ERROR_PARSING_UNKNOWN"),
)


class XmlError(Exception):
    """The text is not XML for TinyXML-2; `str()` is its error string, `offset` the start of the faulty construct."""

    def __init__(self, name: str, line: int, detail: str = "", offset: int = 0) -> None:
        number = _ERROR_NUMBERS[name]
        text = f"Error={name} ErrorID={number} (0x{number:x}) Line number={line}"
        super().__init__(f"{text}: {detail}" if detail else text)
        self.name = name
        self.line = line
        self.offset = offset


@dataclass(slots=True)
class Element:
    """One element: its tag, its attributes in order, the offset of its `<` in the text, and its child elements."""

    tag: str
    attributes: dict[str, str]
    offset: int
    children: list[Element] = field(default_factory=list)

    def first(self, tag: str) -> Element | None:
        """Return the first child with this tag, None if there is none."""
        for child in self.children:
            if child.tag == tag:
                return child
        return None

    def all(self, tag: str) -> list[Element]:
        """Return all children with this tag, in the order of the file."""
        return [child for child in self.children if child.tag == tag]


class Lines:
    """Converts offsets in a text to lines and columns."""

    def __init__(self, text: str) -> None:
        self._text = text
        self._breaks: list[int] | None = None

    def at(self, offset: int) -> tuple[int, int]:
        """Return line and column of an offset, both from 1."""
        if self._breaks is None:
            self._breaks = [match.start() for match in re.finditer("\n", self._text)]
        line = bisect_left(self._breaks, offset)
        start = self._breaks[line - 1] + 1 if line else 0
        return line + 1, offset - start + 1


def read_xml(text: str) -> list[Element]:
    """Return the top-level elements of the text (TinyXML-2 allows several).

    Raises:
        XmlError: TinyXML-2 refuses the text.
    """
    return _Reader(text).read()


class _Reader:
    def __init__(self, text: str) -> None:
        self._text = text.split("\0", 1)[0]
        self._lines = Lines(self._text)
        self._top: list[Element] = []
        self._open: list[Element] = []
        self._only_declarations = True

    def read(self) -> list[Element]:
        text = self._text
        position = self._skip_space(0)
        if text.startswith("\ufeff", position):
            position += 1
        if position >= len(text):
            raise XmlError("XML_ERROR_EMPTY_DOCUMENT", 0)
        while True:
            start = self._skip_space(position)
            if start >= len(text):
                if self._open:
                    raise self._error("XML_ERROR_PARSING", self._open[-1].offset)
                return self._top
            if text[start] != "<":
                position = text.find("<", start)
                if position < 0:
                    raise self._error("XML_ERROR_PARSING_TEXT", start)
                self._only_declarations = False
                continue
            after = self._skip_special(start)
            if after is None:
                after = self._read_tag(start)
                if after is None:
                    return self._top
            position = after

    def _skip_special(self, start: int) -> int | None:
        """Skip a declaration, comment, CDATA or `<!…>` at `start`; None if an element begins there."""
        text = self._text
        for opening, closing, error in _SKIPPED:
            if text.startswith(opening, start):
                end = text.find(closing, start + len(opening))
                if end < 0:
                    raise self._error(error, start)
                if opening == "<?":
                    if self._open or not self._only_declarations:
                        value = text[start + 2 : end]
                        raise self._error(error, start, f"XMLDeclaration value={value}")
                else:
                    self._only_declarations = False
                return end + len(closing)
        return None

    def _read_tag(self, start: int) -> int | None:
        """Read the tag at `start`; return the offset of its end, None if a closing tag ends the document."""
        text = self._text
        position = self._skip_space(start + 1)
        closing = text.startswith("/", position)
        if closing:
            position += 1
        name = _NAME.match(text, position)
        if name is None:
            raise self._error("XML_ERROR_PARSING", start)
        element = Element(name.group(), {}, start)
        self._only_declarations = False
        position, closed = self._read_attributes(element, name.end())
        if closing and not closed:
            if not self._open:
                return None
            opened = self._open.pop()
            if opened.tag != element.tag:
                raise self._mismatch(opened)
            return position
        (self._open[-1].children if self._open else self._top).append(element)
        if not closed:
            self._open.append(element)
            if len(self._open) >= MAX_DEPTH - 1:  # the document itself counts as one
                raise self._error("XML_ELEMENT_DEPTH_EXCEEDED", position, "Element nesting is too deep.")
        return position

    def _read_attributes(self, element: Element, position: int) -> tuple[int, bool]:
        """Read the attributes; return the offset of the tag's end and whether it ended with `/>`."""
        text = self._text
        attributes = element.attributes
        while True:
            position = self._skip_space(position)
            if position >= len(text):
                raise self._error("XML_ERROR_PARSING_ELEMENT", element.offset, f"XMLElement name={element.tag}")
            name = _NAME.match(text, position)
            if name is None:
                if text[position] == ">":
                    return position + 1, False
                if text.startswith("/>", position):
                    return position + 2, True
                raise self._error("XML_ERROR_PARSING_ELEMENT", element.offset)
            end = self._skip_space(name.end())
            quote = self._skip_space(end + 1)
            last = -1
            if text.startswith("=", end) and text[quote : quote + 1] in ('"', "'"):
                last = text.find(text[quote], quote + 1)
            if last < 0 or name.group() in attributes:
                raise self._error("XML_ERROR_PARSING_ATTRIBUTE", position, f"XMLElement name={element.tag}")
            attributes[name.group()] = _plain(text[quote + 1 : last])
            position = last + 1

    def _skip_space(self, position: int) -> int:
        match = _SPACE.match(self._text, position)
        return match.end() if match else position

    def _mismatch(self, element: Element) -> XmlError:
        return self._error("XML_ERROR_MISMATCHED_ELEMENT", element.offset, f"XMLElement name={element.tag}")

    def _error(self, name: str, offset: int, detail: str = "") -> XmlError:
        return XmlError(name, self._lines.at(offset)[0], detail, offset)


def _plain(raw: str) -> str:
    """Return an attribute's value: line ends normalised, the five entities and character references replaced, no others."""
    if "\r" in raw:
        raw = _NEWLINE.sub("\n", raw)
    return _ENTITY.sub(_character, raw) if "&" in raw else raw


def _character(match: re.Match[str]) -> str:
    name, decimal, hexadecimal = match.groups()
    if name:
        return _NAMED[name]
    digits = decimal or hexadecimal
    if len(digits) > 8:
        return match.group()
    code = int(digits, 10 if decimal else 16)
    if code == 0 or code > 0x10FFFF or 0xD800 <= code <= 0xDFFF:
        return match.group()
    return chr(code)


def write_xml(elements: list[Element]) -> str:
    """Return the elements as XML that every reader reads alike: without text, comments, document type or entities."""
    parts: list[str] = []
    steps: list[Element | str] = list(reversed(elements))
    while steps:
        step = steps.pop()
        if isinstance(step, str):
            parts.append(step)
            continue
        attributes = "".join(f' {name}="{_escape(value)}"' for name, value in step.attributes.items())
        if step.children:
            parts.append(f"<{step.tag}{attributes}>")
            steps.append(f"</{step.tag}>")
            steps.extend(reversed(step.children))
        else:
            parts.append(f"<{step.tag}{attributes}/>")
    return "".join(parts)


def _escape(value: str) -> str:
    for character, entity in (("&", "&amp;"), ("<", "&lt;"), ('"', "&quot;"), ("\n", "&#10;"), ("\t", "&#9;")):
        value = value.replace(character, entity)
    return value

"""XML without entities of its own, which could expand without end: what comes from files that others wrote."""

from __future__ import annotations

from typing import NoReturn
from xml.etree.ElementTree import Element, ParseError, TreeBuilder, XMLParser, fromstring


class _Plain(TreeBuilder):
    def doctype(self, name: str, public: str | None, system: str | None) -> NoReturn:
        """Refuse the place where entities are defined, whatever the encoding of the file."""
        raise ValueError("a document type is not allowed")


def plain_xml(text: str | bytes) -> Element:
    """Return the root element. Raises ValueError for a document type, for what isn't XML, and for an unknown encoding."""
    try:
        return fromstring(text, XMLParser(target=_Plain()))
    except (ParseError, LookupError) as error:
        raise ValueError(str(error)) from error

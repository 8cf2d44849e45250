"""Reads XML launch files."""

from __future__ import annotations

import io
import os
from typing import Any

from launch.frontend.parser import Parser as BaseParser

from launch_xml.entity import Entity


class Parser(BaseParser):
    """Parses a launch file in XML to entities."""

    @classmethod
    def load(cls, file: Any) -> tuple[Entity, BaseParser]:
        """Return the root tag of a file (path or open). Raises ValueError for a DTD, which no launch file needs."""
        from xml.etree import ElementTree
        from xml.parsers import expat

        if isinstance(file, (str, bytes, os.PathLike)):
            with open(file, encoding="utf-8") as opened:
                return cls.load(opened)
        text = file.read()
        _refuse_doctype(expat.ParserCreate(), text)
        return Entity(ElementTree.parse(io.StringIO(text)).getroot()), cls()

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        return {"launch.xml", "xml", "launch"}


def _refuse_doctype(parser: Any, text: str) -> None:
    """Raise ValueError for a DTD: its entities could name any file, or expand to more text than fits into memory."""

    def refuse(*ignored: Any) -> None:
        raise ValueError("a launch file must not have a document type declaration")

    parser.StartDoctypeDeclHandler = refuse
    from xml.parsers.expat import ExpatError

    try:
        parser.Parse(text, True)
    except ExpatError:
        return  # ElementTree reports it with the familiar text

"""Launch files in XML. It builds on launch, which imports it only by name (`launch/_entry_points`)."""

from __future__ import annotations

from launch_xml.entity import Entity
from launch_xml.parser import Parser

__all__ = ["Entity", "Parser"]

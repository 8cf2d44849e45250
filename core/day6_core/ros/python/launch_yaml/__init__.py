"""Launch files in YAML. It builds on launch, which imports it only by name (`launch/_entry_points`)."""

from __future__ import annotations

from launch_yaml.entity import Entity
from launch_yaml.parser import Parser

__all__ = ["Entity", "Parser"]

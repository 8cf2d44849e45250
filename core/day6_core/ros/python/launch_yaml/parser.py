"""Reads YAML launch files."""

from __future__ import annotations

import os
from typing import Any

from launch.frontend.parser import Parser as BaseParser

from launch_yaml.entity import Entity


class Parser(BaseParser):
    """Parses a launch file in YAML to entities."""

    @classmethod
    def load(cls, file: Any) -> tuple[Entity, BaseParser]:
        """Return the root of a file (path or open). Raises RuntimeError unless it has exactly one key."""
        import yaml

        if isinstance(file, (str, bytes, os.PathLike)):
            with open(file, encoding="utf-8") as opened:
                return cls.load(opened)
        tree = yaml.safe_load(file)
        if len(tree) != 1:
            raise RuntimeError("Expected only one root")
        name = next(iter(tree.keys()))
        return Entity(tree[name], name), cls()

    @classmethod
    def get_file_extensions(cls) -> set[str]:
        return {"launch.yaml", "launch.yml", "yaml", "yml", "launch"}

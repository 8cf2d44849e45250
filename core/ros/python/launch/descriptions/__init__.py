"""What is to be run, apart from how."""

from __future__ import annotations

from launch.descriptions.executable import Executable

__all__ = ["Executable"]

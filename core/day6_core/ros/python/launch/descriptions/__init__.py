"""Descriptions of executables, apart from how they are run."""

from __future__ import annotations

from launch.descriptions.executable import Executable

__all__ = ["Executable"]

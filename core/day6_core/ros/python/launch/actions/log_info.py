"""Logs a message."""

from __future__ import annotations

from launch.actions.log import LogInfo as LogInfo

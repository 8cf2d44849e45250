"""Matchers of texts and of lines."""

from __future__ import annotations

from launch_testing._text_match import build_line_match, build_text_match, normalize_lineseps

__all__ = ["build_line_match", "build_text_match", "normalize_lineseps"]

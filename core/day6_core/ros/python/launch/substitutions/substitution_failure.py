"""The error of substitutions."""

from __future__ import annotations


class SubstitutionFailure(RuntimeError):
    """Raised by a substitution that has no text at present."""

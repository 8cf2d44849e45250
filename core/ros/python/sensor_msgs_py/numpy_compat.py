"""Structured arrays as plain ones and back. The real module is for numpy older than 1.17; every numpy here has the functions."""

from __future__ import annotations

from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured

__all__ = ["structured_to_unstructured", "unstructured_to_structured"]

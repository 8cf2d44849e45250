"""Conversion of structured arrays. The real module is for numpy before 1.17; every supported numpy has the functions."""

from __future__ import annotations

from numpy.lib.recfunctions import structured_to_unstructured, unstructured_to_structured

__all__ = ["structured_to_unstructured", "unstructured_to_structured"]

"""Vectors of any shape."""

from __future__ import annotations

import math
from typing import Any

EPSILON = 4.0 * 2.220446049250313e-16
"""Smaller numbers count as zero."""


def vector_norm(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """Return the Euclidean length along an axis, a float for a plain vector; with `out` it is stored there."""
    import numpy

    data = numpy.array(data, dtype=numpy.float64)
    if out is not None:
        numpy.sum(data * data, axis=axis, out=out)
        numpy.sqrt(out, out)
        return None
    if data.ndim == 1:
        return math.sqrt(numpy.dot(data, data))
    return numpy.sqrt(numpy.atleast_1d(numpy.sum(data * data, axis=axis)))


def unit_vector(data: Any, axis: int | None = None, out: Any = None) -> Any:
    """Return `data` divided by its length along an axis; with `out` it is stored there."""
    import numpy

    given = numpy.array(data, dtype=numpy.float64)
    if out is None and given.ndim == 1:
        return given / math.sqrt(numpy.dot(given, given)) if given.size else given
    length = numpy.sqrt(numpy.atleast_1d(numpy.sum(given * given, axis)))
    if axis is not None:
        length = numpy.expand_dims(length, axis)
    if out is None:
        return given / length
    out[...] = given / length
    return None


def random_vector(size: Any) -> Any:
    """Return random numbers in [0, 1)."""
    import numpy

    return numpy.random.random(size)

"""Reads PointCloud2 messages as numpy arrays, and creates them from points.

Names, results and texts are those of sensor_msgs_py 5.4 (common_interfaces), including its oddities: an organized cloud has the
shape (width, height), and if the byte order differs the message's own data is swapped.
"""

from __future__ import annotations

import array
import sys
from collections import namedtuple
from collections.abc import Iterable
from typing import Any, NamedTuple

import numpy as np
from sensor_msgs.msg import PointCloud2, PointField
from std_msgs.msg import Header

from sensor_msgs_py.numpy_compat import structured_to_unstructured, unstructured_to_structured

DUMMY_FIELD_PREFIX = "unnamed_field"

_DATATYPES = {
    getattr(PointField, name): np.dtype(name.lower())
    for name in ("INT8", "UINT8", "INT16", "UINT16", "INT32", "UINT32", "FLOAT32", "FLOAT64")
}

# The real texts contain the indentation of their second line.
_ONE_TYPE_TO_CREATE = (
    f"All fields need to have the same datatype. Pass a structured NumPy array {'':19} with multiple dtypes otherwise."
)
_OTHER_TYPES = (
    f"PointFields and structured NumPy array dtype do not match for all fields! {'':19} "
    "Check their field order, names and types."
)
_TOO_MANY_DIMENSIONS = (
    f"Too many dimensions for organized cloud! {'':11} Points can only be organized in max. two dimensional space"
)


def read_points(
    cloud: PointCloud2,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray[Any, Any]:
    """Return the points of a cloud as a structured array: all of them, or those at the indices `uvs`.

    With `skip_nans` points with a NaN are left out unless the cloud is marked as dense. Raises AssertionError for anything
    but a cloud, and for a missing field.
    """
    assert isinstance(cloud, PointCloud2), "Cloud is not a sensor_msgs.msg.PointCloud2"
    kind = dtype_from_fields(cloud.fields, point_step=cloud.point_step)
    points: np.ndarray[Any, Any] = np.ndarray((cloud.width * cloud.height,), kind, cloud.data)
    if field_names is not None:
        known = kind.names or ()
        assert all(name in known for name in field_names), "Requests field is not in the fields of the PointCloud!"
        points = points[list(field_names)]
    if cloud.is_bigendian == (sys.byteorder == "little"):
        points = points.byteswap(inplace=True)
    if skip_nans and not cloud.is_dense:
        valid = np.ones(len(points), dtype=bool)
        for name in points.dtype.names or ():
            valid &= ~np.isnan(points[name])
        points = points[valid]
    if uvs is not None:
        points = points[uvs if isinstance(uvs, np.ndarray) else np.fromiter(uvs, int)]
    if reshape_organized_cloud and cloud.height > 1:
        points = points.reshape(cloud.width, cloud.height)
    return points


def read_points_numpy(
    cloud: PointCloud2,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
    reshape_organized_cloud: bool = False,
) -> np.ndarray[Any, Any]:
    """Return the points as a plain array, shape (N, fields). Raises AssertionError unless the fields have one type."""
    others = [field for field in cloud.fields[1:] if field_names is None or field.name in field_names]
    assert all(field.datatype == cloud.fields[0].datatype for field in others), (
        "All fields need to have the same datatype. Use `read_points()` otherwise."
    )
    plain: np.ndarray[Any, Any] = structured_to_unstructured(
        read_points(cloud, field_names, skip_nans, uvs, reshape_organized_cloud)
    )
    return plain


def read_points_list(
    cloud: PointCloud2,
    field_names: list[str] | None = None,
    skip_nans: bool = False,
    uvs: Iterable[int] | None = None,
) -> list[NamedTuple]:
    """Return the points as a list of named tuples, which is slower than the array."""
    assert isinstance(cloud, PointCloud2), "cloud is not a sensor_msgs.msg.PointCloud2"
    names = [field.name for field in cloud.fields] if field_names is None else field_names
    named_tuple: Any = namedtuple  # the names are known only at run time
    kind = named_tuple("Point", names)
    return [kind._make(point) for point in read_points(cloud, names, skip_nans, uvs)]


def dtype_from_fields(fields: Iterable[PointField], point_step: int | None = None) -> np.dtype[Any]:
    """Return the numpy dtype of a point of `point_step` bytes; a field with several values becomes `name_0`, `name_1` …

    Raises AssertionError for a field without values and for a duplicate name.
    """
    names: list[str] = []
    offsets: list[int] = []
    kinds: list[str] = []
    for number, field in enumerate(fields):
        kind = _DATATYPES[field.datatype]
        name = field.name or f"{DUMMY_FIELD_PREFIX}_{number}"
        assert field.count > 0, "Can't process fields with count = 0."
        for part in range(field.count):
            each = f"{name}_{part}" if field.count > 1 else name
            assert each not in names, "Duplicate field names are not allowed!"
            names.append(each)
            offsets.append(field.offset + part * kind.itemsize)
            kinds.append(kind.str)
    described: Any = {"names": names, "formats": kinds, "offsets": offsets}
    if point_step is not None:
        described["itemsize"] = point_step
    described_type: np.dtype[Any] = np.dtype(described)
    return described_type


def create_cloud(
    header: Header, fields: Iterable[PointField], points: Iterable[Any], point_step: int | None = None
) -> PointCloud2:
    """Return a cloud of points: tuples in the order of the fields, or a plain or structured array of up to two dimensions.

    Raises AssertionError for an array with a wrong type or shape.
    """
    values = _as_structured(fields, points, point_step)
    assert values.ndim <= 2, _TOO_MANY_DIMENSIONS
    width = values.shape[0]
    size = values.dtype.itemsize
    cloud = PointCloud2(
        header=header,
        height=values.shape[1] if values.ndim == 2 else 1,
        width=width,
        is_dense=False,
        is_bigendian=sys.byteorder != "little",
        fields=fields,
        point_step=size,
        row_step=size * width,
    )
    data = array.array("B")
    data.frombytes(memoryview(values.data).cast("B"))
    cloud.data = data
    return cloud


def _as_structured(fields: Any, points: Iterable[Any], point_step: int | None) -> np.ndarray[Any, Any]:
    if not isinstance(points, np.ndarray):
        return np.array([tuple(point) for point in points], dtype_from_fields(fields, point_step))
    if points.dtype.names is None:
        assert all(fields[0].datatype == field.datatype for field in fields[1:]), _ONE_TYPE_TO_CREATE
        structured: np.ndarray[Any, Any] = unstructured_to_structured(
            points, dtype=dtype_from_fields(fields, point_step)
        )
        return structured
    assert points.dtype == dtype_from_fields(fields, point_step), _OTHER_TYPES
    return points


def create_cloud_xyz32(header: Header, points: Iterable[Any]) -> PointCloud2:
    """Return a cloud of points with the fields x, y and z, each a float32."""
    fields = [
        PointField(name=name, offset=4 * number, datatype=PointField.FLOAT32, count=1)
        for number, name in enumerate("xyz")
    ]
    return create_cloud(header, fields, points)

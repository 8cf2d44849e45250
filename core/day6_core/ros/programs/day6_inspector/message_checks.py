"""What is wrong in one message, whatever else is known: numbers that are none, rotations that are none, sizes that do not fit.

Pure. `odd` walks every field; what belongs to one type is in `CHECKS`.
"""

from __future__ import annotations

import math
import re
from collections.abc import Callable, Iterator, Sequence
from functools import lru_cache
from itertools import islice
from typing import Any, NamedTuple

from day6_core.interfaces import type_name

MOST = 100
"""Elements of a sequence of messages that are looked at; of a sequence within such a sequence, a tenth."""

MOST_NUMBERS = 50_000
"""Elements of a sequence of numbers that are looked at: that takes less than a millisecond."""

NOT_UNIT = 0.01
"""How far the square of a quaternion's length may be from 1: tf2 ignores transforms beyond (buffer_core.cpp)."""

FULL_CIRCLES = 4 * math.pi
"""Radians: a laser that turns further than twice around counts in degrees."""

UNMEASURED = {
    "sensor_msgs/msg/LaserScan": {"ranges", "intensities"},
    "sensor_msgs/msg/MultiEchoLaserScan": {"ranges", "intensities"},
    "sensor_msgs/msg/Range": {"range"},
    "sensor_msgs/msg/JointState": {"velocity", "effort"},
    "trajectory_msgs/msg/JointTrajectory": {"velocities", "accelerations", "effort"},
    **{
        f"sensor_msgs/msg/{each}": {""}
        for each in ("BatteryState", "NavSatFix", "MagneticField", "RelativeHumidity", "Illuminance", "Temperature")
    },
}
"""Fields in which NaN or infinity says that nothing was measured, by type ('' for all): comments in the .msg files, REP 117."""

_FIELD = re.compile(r"(?P<many>sequence<)?(?P<base>double|float|\w+/\w+)(?P<array>\[\d+\])?")
_PIXEL = re.compile(r"(8|16|32|64)[USF]C(\d?)")
_NAMED_PIXELS = {
    **{f"{colours}{suffix}": size for suffix, size in (("8", 3), ("16", 6)) for colours in ("rgb", "bgr")},
    **{f"{colours}{suffix}": size for suffix, size in (("8", 4), ("16", 8)) for colours in ("rgba", "bgra")},
    "mono8": 1,
    "mono16": 2,
    "yuv422": 2,
    "yuv422_yuy2": 2,
    "uyvy": 2,
    "yuyv": 2,
    **{f"bayer_{order}{bits}": bits // 8 for bits in (8, 16) for order in ("rggb", "bggr", "gbrg", "grbg")},
}
"""Bytes of a pixel (sensor_msgs/image_encodings.hpp)."""

_POINT_BYTES = {1: 1, 2: 1, 3: 2, 4: 2, 5: 4, 6: 4, 7: 4, 8: 8}
"""sensor_msgs/msg/PointField.datatype -> bytes."""


class Odd(NamedTuple):
    """One thing that is wrong: the key of its finding, and the parameters besides topic and node."""

    key: str
    parameters: tuple[tuple[str, str], ...] = ()


def _odd(key: str, **parameters: object) -> Odd:
    return Odd(key, tuple((name, str(value)) for name, value in parameters.items()))


def odd(message: Any, type_name: str) -> list[Odd]:
    """Return what is wrong in a message, each once."""
    found = [*_of_fields(message, type_name), *CHECKS.get(type_name, _nothing)(message)]
    return list(dict.fromkeys(found))


def is_worth_a_look(cls: Any) -> bool:
    """Whether anything can be wrong in messages of a class: it has numbers with a fraction, a header, or sizes."""
    return type_name(cls) in CHECKS or bool(_plan(cls)) or "header" in cls.get_fields_and_field_types()


# -- every field -----------------------------------------------------------------------------------------------------------


@lru_cache(maxsize=500)
def _plan(cls: Any) -> tuple[tuple[str, str, bool], ...]:
    """The fields of a class in which a number with a fraction may be: name, type, whether there are several."""
    fields = cls.get_fields_and_field_types()
    found = []
    for name, text in fields.items():
        match = _FIELD.match(text)
        if match is not None and match["base"] not in ("builtin_interfaces/Time", "std_msgs/Header"):
            found.append((name, match["base"], bool(match["many"] or match["array"])))
    return tuple(found)


def walked(message: Any, path: str = "", most: int = MOST) -> Iterator[tuple[str, str, Any]]:
    """Yield every number and message within a message: where it is, its type, itself; lists of numbers as a whole."""
    for name, kind, many in _plan(message.__class__):
        value = getattr(message, name)
        at = f"{path}{name}"
        if kind in ("double", "float"):
            yield at, "numbers" if many else "number", value
            continue
        for index, each in enumerate(islice(value, most) if many else (value,)):
            here = f"{at}[{index}]" if many else at
            yield here, kind, each
            yield from walked(each, f"{here}.", most // 10 if many else most)


def _of_fields(message: Any, type_name: str) -> Iterator[Odd]:
    unmeasured = UNMEASURED.get(type_name, ())
    for path, kind, value in walked(message):
        if kind == "geometry_msgs/Quaternion":
            yield from _of_quaternion(message, path, value)
        elif kind in ("number", "numbers") and "" not in unmeasured:
            last = path.rpartition(".")[2]
            if last not in unmeasured and "covariance" not in last:
                yield from _of_numbers(path, [value] if kind == "number" else value[:MOST_NUMBERS])


def _of_numbers(path: str, values: Sequence[float]) -> Iterator[Odd]:
    if math.isfinite(sum(values)):
        return
    for index, value in enumerate(values):
        if not math.isfinite(value):
            yield _odd("not_finite", field=f"{path}[{index}]" if len(values) > 1 else path, value=str(float(value)))
            return


def _of_quaternion(message: Any, path: str, turned: Any) -> Iterator[Odd]:
    square = turned.x**2 + turned.y**2 + turned.z**2 + turned.w**2
    unknown = path == "orientation" and _first(getattr(message, "orientation_covariance", ())) == -1  # Imu.msg
    if math.isfinite(square) and abs(square - 1) > NOT_UNIT and not unknown:
        yield _odd("quaternion", field=path, length=f"{math.sqrt(square):.3g}")


def _first(values: Sequence[float]) -> float:
    return next(iter(values), 0.0)


# -- what belongs to one type ------------------------------------------------------------------------------------------------


def _nothing(message: Any) -> Iterator[Odd]:
    return iter(())


def _of_scan(scan: Any) -> Iterator[Odd]:
    count, step, span = len(scan.ranges), scan.angle_increment, scan.angle_max - scan.angle_min
    if max(abs(scan.angle_min), abs(scan.angle_max)) > FULL_CIRCLES:
        yield _odd("scan_degrees", angle=f"{max(abs(scan.angle_min), abs(scan.angle_max)):g}")
    elif not math.isfinite(span + step):
        pass  # said as a number that is none
    elif not step and count > 1:
        yield _odd("scan_angles", ranges=count, angles=1, step=0)
    elif step and abs(count - (round(span / step) + 1)) > max(2, count // 100):
        yield _odd("scan_angles", ranges=count, angles=max(0, round(span / step) + 1), step=f"{step:.4g}")
    if all(map(math.isnan, scan.ranges)):
        yield _odd("scan_empty", ranges=count)
    if scan.range_max <= scan.range_min:
        yield _odd("scan_ranges", low=f"{scan.range_min:g}", high=f"{scan.range_max:g}")


def _of_image(image: Any) -> Iterator[Odd]:
    encoding = image.encoding
    match = _PIXEL.fullmatch(encoding)
    pixel = int(match[1]) // 8 * int(match[2] or 1) if match else _NAMED_PIXELS.get(encoding, 0)
    if not pixel and encoding.lower() in _NAMED_PIXELS:
        yield _odd("image_encoding", encoding=encoding, right=encoding.lower())
    if image.step < image.width * pixel:
        yield _size("step", image.step, image.width * pixel)
    elif len(image.data) != image.step * image.height:
        yield _size("data", len(image.data), image.step * image.height)


def _of_cloud(cloud: Any) -> Iterator[Odd]:
    ends = [each.offset + _POINT_BYTES.get(each.datatype, 0) * max(1, each.count) for each in cloud.fields]
    if cloud.point_step < max(ends, default=0):
        yield _size("point_step", cloud.point_step, max(ends))
    elif cloud.row_step < cloud.width * cloud.point_step:
        yield _size("row_step", cloud.row_step, cloud.width * cloud.point_step)
    elif len(cloud.data) != cloud.row_step * cloud.height:
        yield _size("data", len(cloud.data), cloud.row_step * cloud.height)


def _of_grid(grid: Any) -> Iterator[Odd]:
    cells = grid.info.width * grid.info.height
    if len(grid.data) != cells:
        yield _size("data", len(grid.data), cells)
    if cells and grid.info.resolution <= 0:
        yield _odd("map_resolution", resolution=f"{grid.info.resolution:g}")


def _of_trajectory(trajectory: Any) -> Iterator[Odd]:
    names = len(trajectory.joint_names)
    for index, point in enumerate(islice(trajectory.points, MOST)):
        for field in ("positions", "velocities", "accelerations", "effort"):
            count = len(getattr(point, field))
            if count not in (0, names):
                yield _size(f"points[{index}].{field}", count, names)
                return


def _of_array(array: Any) -> Iterator[Odd]:
    if array.layout.dim:
        expected = math.prod(each.size for each in array.layout.dim)
        if len(array.data) - array.layout.data_offset != expected:
            yield _size("data", len(array.data) - array.layout.data_offset, expected)


def _of_battery(battery: Any) -> Iterator[Odd]:
    if battery.percentage > 1:
        yield _odd("out_of_range", field="percentage", value=f"{battery.percentage:g}", low=0, high=1)


def _of_fix(fix: Any) -> Iterator[Odd]:
    for field, most in (("latitude", 90), ("longitude", 180)):
        value = getattr(fix, field)
        if abs(value) > most:
            yield _odd("out_of_range", field=field, value=f"{value:g}", low=-most, high=most)


def _size(field: str, count: int, expected: int) -> Odd:
    return _odd("data_size", field=field, count=count, expected=expected)


CHECKS: dict[str, Callable[[Any], Iterator[Odd]]] = {
    "sensor_msgs/msg/LaserScan": _of_scan,
    "sensor_msgs/msg/Image": _of_image,
    "sensor_msgs/msg/PointCloud2": _of_cloud,
    "nav_msgs/msg/OccupancyGrid": _of_grid,
    "trajectory_msgs/msg/JointTrajectory": _of_trajectory,
    "sensor_msgs/msg/BatteryState": _of_battery,
    "sensor_msgs/msg/NavSatFix": _of_fix,
    **{
        f"std_msgs/msg/{kind}MultiArray": _of_array
        for kind in ("Float32", "Float64", "Int32", "Int64", "UInt8", "Int16")
    },
}
"""Type -> what its fields have to agree on."""

"""Bytes on the wire: layout, values that can not be sent, and bytes that are no message."""

from __future__ import annotations

import random
import struct
import tracemalloc
from array import array
from importlib.util import find_spec
from pathlib import Path
from typing import Any

import pytest

from day6_core.interfaces import (
    DeserializationError,
    SerializationError,
    deserialize,
    get_interface,
    interface_names,
    packages,
    registry,
    serialize,
)
from tests.support.folded import folded

HEADER = b"\x00\x01\x00\x00"
needs_numpy = pytest.mark.skipif(find_spec("numpy") is None, reason="no numpy")


def all_messages() -> list[str]:
    """Return the full names of all messages and of all requests and responses."""
    names = []
    for package in packages():
        names += [f"{package}/{name}" for name in interface_names(package, "msg")]
        for name in interface_names(package, "srv"):
            names += [f"{package}/{name}_Request", f"{package}/{name}_Response"]
        for name in interface_names(package, "action"):
            names += [f"{package}/{name}_Goal", f"{package}/{name}_Result", f"{package}/{name}_FeedbackMessage"]
    return names


def fill(cls: Any, rng: random.Random, depth: int = 0) -> Any:
    """Return a message of a class with random contents."""
    message = cls()
    for field in cls._structure.fields:
        type_ = field.type
        count = {"single": 1, "array": type_.size}.get(type_.count, rng.randrange(0, 4 if depth < 2 else 2))
        if type_.count == "bounded":
            count = min(count, type_.size)
        values = [element(type_, rng, depth) for _ in range(count)]
        setattr(message, field.name, values[0] if type_.count == "single" else values)
    return message


def element(type_: Any, rng: random.Random, depth: int) -> Any:
    """Return one random value of a field."""
    primitive = type_.primitive
    if type_.nested:
        return fill(get_interface(type_.base), rng, depth + 1)
    if primitive is None:
        return "".join(rng.choice("ab /é漢") for _ in range(rng.randrange(8)))
    if primitive.python is int:
        return rng.choice((primitive.low, primitive.high, rng.randrange(primitive.low, primitive.high + 1)))
    if primitive.python is bool:
        return rng.random() < 0.5
    if primitive.python is bytes:
        return bytes([rng.randrange(256)])
    return rng.choice((0.0, -2.5, float("inf"), rng.randrange(10**6) / 64))


@needs_numpy
@folded("name", all_messages())
def test_random_messages_come_back_as_they_were(name: str) -> None:
    rng = random.Random(name)
    cls = get_interface(name)
    for _ in range(5):
        message = fill(cls, rng)
        assert deserialize(serialize(message), cls) == message


def test_a_text_is_its_length_its_bytes_and_a_nul() -> None:
    from std_msgs.msg import String

    assert serialize(String(data="abc")) == HEADER + b"\x04\x00\x00\x00abc\x00"
    assert serialize(String()) == HEADER + b"\x01\x00\x00\x00\x00"


def test_numbers_are_aligned_from_after_the_header() -> None:
    from geometry_msgs.msg import Twist
    from std_msgs.msg import Header

    assert serialize(Twist()) == HEADER + bytes(48)
    header = Header(frame_id="ab")
    header.stamp.sec = 1
    assert serialize(header) == HEADER + struct.pack("<iII3s", 1, 0, 3, b"ab")


def test_elements_of_an_empty_sequence_are_not_aligned() -> None:
    from sensor_msgs.msg import JointState

    # stamp 0, frame_id 8 (its NUL at 12), and the counts of name 16, position 20, velocity 24, effort 28
    assert len(serialize(JointState())) == 4 + 32
    # the first velocity is aligned to 8: it begins at 32, not at 28
    assert serialize(JointState(velocity=[1.0]))[4:] == bytes(8) + struct.pack("<IxxxxIIIxxxxdI", 1, 0, 0, 1, 1.0, 0)


def test_an_empty_message_is_one_byte() -> None:
    from std_msgs.msg import Empty

    assert serialize(Empty()) == HEADER + b"\x00"
    assert deserialize(HEADER + b"\x00", Empty) == Empty()
    with pytest.raises(DeserializationError):
        deserialize(HEADER, Empty)


def test_a_wide_text_has_four_bytes_for_each_utf16_unit() -> None:
    from test_msgs.msg import WStrings

    data = serialize(WStrings(wstring_value="a😀"))
    assert data[4:20] == struct.pack("<IIII", 3, ord("a"), 0xD83D, 0xDE00)
    assert deserialize(data, WStrings).wstring_value == "a😀"


@pytest.mark.parametrize(
    ("data", "text"),
    [
        (b"\x00\x00\x00\x00", ""),
        (b"\x03\x00\x00\x00abc", "abc"),
        (b"\x05\x00\x00\x00a\x00bc\x00", "a"),
        (b"\x04\x00\x00\x00\xff\xfeA\x00", "��A"),
        (b"\x04\x00\x00\x00abc\x00\xde\xad\xbe\xef", "abc"),
    ],
)
def test_unusual_texts_are_read_as_real_ros_reads_them(data: bytes, text: str) -> None:
    from std_msgs.msg import String

    assert deserialize(HEADER + data, String).data == text


def test_bytes_may_come_in_any_container() -> None:
    from std_msgs.msg import String

    data = serialize(String(data="x"))
    for container in (data, bytearray(data), memoryview(data)):
        assert deserialize(container, String).data == "x"


@pytest.mark.parametrize(
    ("data", "reason"),
    [
        (b"", "std_msgs/msg/String: 0 bytes are too few for a CDR header of 4 bytes"),
        (b"\x00\x01", "std_msgs/msg/String: 2 bytes are too few for a CDR header of 4 bytes"),
        (b"\x00\x00\x00\x00\x00\x00\x00\x01\x00", "std_msgs/msg/String: big-endian CDR is not supported"),
        (b"\x00\x07\x00\x00\x01\x00\x00\x00\x00", "std_msgs/msg/String: unknown CDR encapsulation 0x00 0x07"),
        (b"hello", "std_msgs/msg/String: unknown CDR encapsulation 0x68 0x65"),
        (HEADER + b"\x01", "std_msgs/msg/String: 5 bytes are no such message: .*"),
        (
            HEADER + b"\xff\x00\x00\x00ab",
            "std_msgs/msg/String: 10 bytes are no such message: a count of 255 where at most 2 can follow",
        ),
    ],
)
def test_bytes_that_are_no_message_are_refused(data: bytes, reason: str) -> None:
    from std_msgs.msg import String

    with pytest.raises(DeserializationError, match=f"^{reason}$"):
        deserialize(data, String)


@pytest.mark.parametrize(
    "name",
    [
        "sensor_msgs/msg/PointCloud2", "tf2_msgs/msg/TFMessage", "rcl_interfaces/msg/ListParametersResult",
        "rcl_interfaces/msg/ParameterValue", "diagnostic_msgs/msg/DiagnosticArray", "test_msgs/msg/WStrings",
        "visualization_msgs/msg/InteractiveMarkerInit", "test_msgs/msg/UnboundedSequences",
    ],
)  # fmt: skip
def test_a_wild_count_allocates_nothing(name: str) -> None:
    cls = get_interface(name)
    good = serialize(cls())
    deserialize(good, cls)
    refused = 0
    for position in range(4, len(good) - 3):
        for count in (0x7FFFFFFF, 0xFFFFFFFF, 0x10000000):
            wild = good[:position] + struct.pack("<I", count) + good[position + 4 :]
            tracemalloc.start()
            try:
                deserialize(wild, cls)
            except DeserializationError:
                refused += 1
            peak = tracemalloc.get_traced_memory()[1]
            tracemalloc.stop()
            assert peak < 200_000
    assert refused > 0


@needs_numpy
@folded("name", all_messages())
def test_cut_and_spoilt_bytes_end_in_a_message_or_a_clean_error(name: str) -> None:
    rng = random.Random(name)
    cls = get_interface(name)
    data = serialize(fill(cls, rng))
    for _ in range(30):
        spoilt = bytearray(data[: rng.randrange(4, len(data) + 1)])
        for _ in range(rng.randrange(3)):
            if len(spoilt) > 4:
                spoilt[rng.randrange(4, len(spoilt))] = rng.randrange(256)
        try:
            message = deserialize(spoilt, cls)
        except DeserializationError:
            continue
        assert type(message) is cls


def test_every_shorter_piece_of_a_message_is_refused() -> None:
    from sensor_msgs.msg import JointState

    state = JointState(name=["a", "bc"], position=[1.0, 2.0], effort=[3.0])
    data = serialize(state)
    for length in range(len(data)):
        with pytest.raises(DeserializationError):
            deserialize(data[:length], JointState)


def test_more_elements_than_a_bound_are_refused_both_ways() -> None:
    from test_msgs.msg import BoundedSequences

    message = BoundedSequences(bool_values=[True, False, True])
    data = serialize(message)
    assert deserialize(data, BoundedSequences) == message
    with pytest.raises(DeserializationError, match="a count of 5 where at most 3 can follow"):
        deserialize(HEADER + b"\x05\x00\x00\x00" + data[8:], BoundedSequences)
    message.bool_values.append(True)
    with pytest.raises(SerializationError, match=r"BoundedSequences can not be serialized: 4 values where at most 3"):
        serialize(message)


def test_a_fixed_list_that_grew_is_refused() -> None:
    pytest.importorskip("numpy")
    from test_msgs.msg import Arrays

    message = Arrays()
    message.string_values.append("x")
    with pytest.raises(SerializationError, match="4 values where 3 belong"):
        serialize(message)


@pytest.mark.parametrize("wrong", [5, None, b"x", ["x"]])
def test_a_value_that_came_past_the_checks_is_an_error_when_sent(wrong: Any) -> None:
    from std_msgs.msg import String

    message = String(check_fields=False)
    message.data = wrong
    with pytest.raises(SerializationError, match=r"^std_msgs/msg/String can not be serialized: "):
        serialize(message)


def test_a_wrong_element_in_a_list_is_an_error_when_sent() -> None:
    from sensor_msgs.msg import JointState

    state = JointState(name=["a"])
    state.name.append(5)
    with pytest.raises(SerializationError, match="sensor_msgs/msg/JointState can not be serialized"):
        serialize(state)


def test_half_a_surrogate_pair_can_not_be_sent() -> None:
    from std_msgs.msg import String

    with pytest.raises(SerializationError, match="surrogates not allowed"):
        serialize(String(data="\ud800"))


def test_a_large_image_arrives_whole() -> None:
    from sensor_msgs.msg import Image

    image = Image(height=480, width=640, encoding="rgb8", step=1920, data=bytes(range(256)) * 3600)
    back = deserialize(serialize(image), Image)
    assert back == image
    assert back.data == array("B", bytes(range(256)) * 3600)


def test_types_that_hold_very_many_messages_do_not_grow_the_code_without_end(
    tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setenv("AMENT_PREFIX_PATH", str(tmp_path))
    folder = tmp_path / "share" / "deep" / "msg"
    folder.mkdir(parents=True)
    for number in range(12):
        text = f"N{number + 1} a\nN{number + 1} b\nN{number + 1}[] c\n" if number < 11 else "uint8 x 7\n"
        (folder / f"N{number}.msg").write_text(text)
    (folder / "N12.msg").write_text("uint8 x\n")
    try:
        cls = get_interface("deep/msg/N0")
        message = cls()
        data = serialize(message)
        assert deserialize(data, cls) == message
    finally:
        registry.forget("deep")

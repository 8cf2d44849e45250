"""The buffer without a node: lookups against 4x4 matrices, and every text it says."""

from __future__ import annotations

import math
import random
import warnings
from typing import Any

import numpy as np
import pytest
import tf2_py
from builtin_interfaces.msg import Time as TimeMsg
from geometry_msgs.msg import Pose
from hypothesis import given, settings
from hypothesis import strategies as st
from tf2_py import (
    BufferCore,
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TransformException,
)

from rclpy.duration import Duration
from rclpy.time import Time
from tests.tf2.conftest import Array, matrix_of, matrix_of_message, stamped

LATEST = Time()


def at(seconds: float) -> Time:
    return Time(nanoseconds=round(seconds * 1e9))


def random_rotation(chance: random.Random) -> list[float]:
    parts = [chance.gauss(0, 1) for _ in range(4)]
    return [part / math.sqrt(sum(each * each for each in parts)) for part in parts]


def random_offset(chance: random.Random) -> list[float]:
    return [chance.uniform(-5, 5) for _ in range(3)]


class Tree:
    """A random tree of frames with the matrix of each frame to its parent."""

    def __init__(self, seed: int, size: int) -> None:
        chance = random.Random(seed)
        self.buffer = BufferCore()
        self.parents: dict[str, str] = {}
        self.matrices: dict[str, Array] = {}
        self.frames = ["f0"]
        for number in range(1, size):
            child, parent = f"f{number}", chance.choice(self.frames)
            offset, turn = random_offset(chance), random_rotation(chance)
            self.parents[child] = parent
            self.matrices[child] = matrix_of(offset, turn)
            self.frames.append(child)
            put = self.buffer.set_transform_static if chance.random() < 0.5 else self.buffer.set_transform
            put(stamped(parent, child, 7.5, offset, turn), "test")

    def to_root(self, frame: str) -> Array:
        matrix = np.eye(4)
        while frame in self.parents:
            matrix = self.matrices[frame] @ matrix
            frame = self.parents[frame]
        return matrix


@given(seed=st.integers(0, 10_000), size=st.integers(2, 12))
@settings(max_examples=60, deadline=None)
def test_every_pair_of_frames_agrees_with_a_product_of_matrices(seed: int, size: int) -> None:
    tree = Tree(seed, size)
    for target in tree.frames:
        for source in tree.frames:
            for time in (LATEST, at(7.5)):
                found = tree.buffer.lookup_transform_core(target, source, time)
                expected = np.linalg.inv(tree.to_root(target)) @ tree.to_root(source)
                assert np.allclose(matrix_of_message(found), expected, atol=1e-9)
                assert (found.header.frame_id, found.child_frame_id) == (target, source)
                assert tree.buffer.can_transform_core(target, source, time) == (1, "")


@given(seed=st.integers(0, 10_000), ratio=st.floats(0.0, 1.0))
@settings(max_examples=100, deadline=None)
def test_between_two_stamps_a_frame_moves_straight_and_turns_evenly(seed: int, ratio: float) -> None:
    chance = random.Random(seed)
    offsets = [random_offset(chance), random_offset(chance)]
    turns = [random_rotation(chance), random_rotation(chance)]
    buffer = BufferCore()
    for number in (1, 0):  # also when they come in the wrong order
        buffer.set_transform(stamped("world", "arm", 5.0 + number, offsets[number], turns[number]), "test")
    found = buffer.lookup_transform_core("world", "arm", at(5.0 + ratio))
    exact = (found.header.stamp.sec - 5) + found.header.stamp.nanosec * 1e-9
    offset = found.transform.translation
    expected = (1 - exact) * np.array(offsets[0]) + exact * np.array(offsets[1])
    assert np.allclose([offset.x, offset.y, offset.z], expected, atol=1e-9)
    first, last = (matrix_of((0, 0, 0), turn)[:3, :3] for turn in turns)
    now = matrix_of_message(found)[:3, :3]
    whole, part = angle_between(first, last), angle_between(first, now)
    assert part == pytest.approx(exact * whole, abs=1e-6)
    assert part + angle_between(now, last) == pytest.approx(whole, abs=1e-6)


def angle_between(a: Array, b: Array) -> float:
    turn = a.T @ b
    sine = math.sqrt(((turn - turn.T) ** 2).sum()) / (2 * math.sqrt(2))
    return math.atan2(sine, (np.trace(turn) - 1) / 2)


def test_the_full_lookup_goes_through_the_fixed_frame() -> None:
    chance = random.Random(3)
    buffer = BufferCore()
    poses = {}
    for second in (1, 2):
        for frame in ("a", "b"):
            poses[frame, second] = (random_offset(chance), random_rotation(chance))
            buffer.set_transform(stamped("world", frame, second, *poses[frame, second]), "test")
    found = buffer.lookup_transform_full_core("a", at(2), "b", at(1), "world")
    expected = np.linalg.inv(matrix_of(*poses["a", 2])) @ matrix_of(*poses["b", 1])
    assert np.allclose(matrix_of_message(found), expected)
    assert found.header.stamp == TimeMsg(sec=2)
    assert buffer.can_transform_full_core("a", at(2), "b", at(1), "world") == (1, "")
    assert buffer.can_transform_full_core("a", at(2), "b", at(1), "moon") == (
        0,
        'Invalid frame ID "moon" passed to canTransform argument fixed_frame - frame does not exist',
    )
    with pytest.raises(LookupException, match='"moon" passed to lookupTransform argument fixed_frame does not exist'):
        buffer.lookup_transform_full_core("a", at(2), "b", at(1), "moon")


def test_the_latest_lookup_takes_the_latest_time_all_frames_know() -> None:
    buffer = BufferCore()
    for second in (1, 2, 3):
        buffer.set_transform(stamped("world", "base", second, (second, 0, 0)), "test")
    for second in (1, 2):
        buffer.set_transform(stamped("base", "arm", second), "test")
    buffer.set_transform_static(stamped("arm", "hand", 9), "test")
    found = buffer.lookup_transform_core("world", "hand", LATEST)
    assert (found.header.stamp.sec, found.transform.translation.x) == (2, 2.0)
    assert buffer.get_latest_common_time("world", "hand") == Time(seconds=2)
    assert buffer.get_latest_common_time("arm", "hand") == Time()


def moving() -> BufferCore:
    buffer = BufferCore()
    for second in (1, 2):
        buffer.set_transform(stamped("world", "car", second), "test")
    buffer.set_transform_static(stamped("car", "wheel"), "test")
    buffer.set_transform_static(stamped("island", "palm"), "test")
    return buffer


NOT_ONE_TREE = (
    "Could not find a connection between '{}' and '{}' because they are not part of the same tree."
    "Tf has two or more unconnected trees."
)


@pytest.mark.parametrize(
    ("target", "source", "seconds", "kind", "text"),
    [
        ("x", "car", 0, LookupException, '"x" passed to lookupTransform argument target_frame does not exist. '),
        ("car", "x", 0, LookupException, '"x" passed to lookupTransform argument source_frame does not exist. '),
        (
            "/car",
            "world",
            0,
            InvalidArgumentException,
            (
                'Invalid argument "/car" passed to lookupTransform argument target_frame'
                " - in tf2 frame_ids cannot start with a '/'"
            ),
        ),
        (
            "car",
            "",
            0,
            InvalidArgumentException,
            'Invalid argument "" passed to lookupTransform argument source_frame - in tf2 frame_ids cannot be empty',
        ),
        ("wheel", "palm", 0, ConnectivityException, NOT_ONE_TREE.format("wheel", "palm")),
        ("palm", "wheel", 1.5, ConnectivityException, NOT_ONE_TREE.format("palm", "wheel")),
        (
            "world",
            "wheel",
            2.25,
            ExtrapolationException,
            (
                "Lookup would require extrapolation into the future.  Requested time 2.250000 but the latest data is at time"
                " 2.000000, when looking up transform from frame [wheel] to frame [world]"
            ),
        ),
        (
            "wheel",
            "world",
            0.5,
            ExtrapolationException,
            (
                "Lookup would require extrapolation into the past.  Requested time 0.500000 but the earliest data is at time"
                " 1.000000, when looking up transform from frame [world] to frame [wheel]"
            ),
        ),
    ],
)
def test_a_failed_lookup_says_why(
    target: str, source: str, seconds: float, kind: type[TransformException], text: str
) -> None:
    buffer = moving()
    with pytest.raises(kind) as caught:
        buffer.lookup_transform_core(target, source, at(seconds))
    assert type(caught.value) is kind
    assert str(caught.value) == text
    possible, reason = buffer.can_transform_core(target, source, at(seconds))
    assert possible == 0
    if kind in (ConnectivityException, ExtrapolationException):
        assert reason == text


def test_one_single_transform_holds_only_at_its_own_time() -> None:
    buffer = BufferCore()
    buffer.set_transform(stamped("world", "car", 1), "test")
    assert buffer.can_transform_core("world", "car", at(1)) == (1, "")
    with pytest.raises(ExtrapolationException) as caught:
        buffer.lookup_transform_core("world", "car", at(3))
    assert str(caught.value).startswith(
        "Lookup would require extrapolation at time 3.000000, but only time 1.000000 is in the buffer, when"
    )


@pytest.mark.parametrize(
    ("frame", "reason"),
    [
        ("x", "frame does not exist"),
        ("", "in tf2 frame_ids cannot be empty"),
        ("/x", "in tf2 frame_ids cannot start with a '/'"),
    ],
)
def test_can_transform_names_the_frame_that_is_wrong(frame: str, reason: str) -> None:
    expected = (0, f'Invalid frame ID "{frame}" passed to canTransform argument source_frame - {reason}')
    assert moving().can_transform_core("world", frame, LATEST) == expected


def test_a_frame_can_always_be_transformed_to_itself_even_an_unknown_one() -> None:
    buffer = moving()
    found = buffer.lookup_transform_core("nowhere", "nowhere", at(4))
    assert (found.header.stamp.sec, found.transform.rotation.w) == (4, 1.0)
    assert buffer.lookup_transform_core("car", "car", LATEST).header.stamp.sec == 2
    assert buffer.can_transform_core("nowhere", "nowhere", LATEST) == (1, "")


def test_a_loop_is_found_out() -> None:
    buffer = BufferCore()
    for parent, child in (("a", "b"), ("b", "c"), ("c", "a"), ("world", "z")):
        buffer.set_transform_static(stamped(parent, child), "test")
    for time in (LATEST, at(1)):
        with pytest.raises(LookupException) as caught:
            buffer.lookup_transform_core("z", "a", time)
        assert (
            str(caught.value)
            == f"The tf tree is invalid because it contains a loop.\n{buffer.all_frames_as_string()}\n"
        )


def test_ten_seconds_are_remembered_and_older_data_is_refused(capfd: pytest.CaptureFixture[str]) -> None:
    buffer = BufferCore()
    for second in (1, 5, 12, 13):
        buffer.set_transform(stamped("world", "car", second, (second, 0, 0)), "the driver")
    assert buffer.can_transform_core("world", "car", at(1.5))[0] == 0
    assert buffer.can_transform_core("world", "car", at(5))[0] == 1
    buffer.set_transform(stamped("world", "car", 2.9), "the driver")
    assert capfd.readouterr().err.split("]: ", 1)[1] == (
        "TF_OLD_DATA ignoring data from the past for frame car at time 2.900000 according to authority the driver\n"
        "Possible reasons are listed at http://wiki.ros.org/tf/Errors%20explained\n"
    )
    buffer.set_transform(stamped("world", "car", 3.0), "the driver")
    assert capfd.readouterr().err == ""


def test_another_cache_time_remembers_longer() -> None:
    buffer = BufferCore(Duration(seconds=30))
    for second in (1, 25):
        buffer.set_transform(stamped("world", "car", second), "test")
    assert buffer.can_transform_core("world", "car", at(1))[0] == 1


def test_a_long_run_keeps_only_what_it_needs() -> None:
    buffer = BufferCore()
    for tick in range(5000):
        buffer.set_transform(stamped("world", "car", 1 + tick * 0.01, (tick, 0, 0)), "test")
    assert buffer.lookup_transform_core("world", "car", at(50.0)).transform.translation.x == pytest.approx(4900)
    assert buffer.can_transform_core("world", "car", at(41.5))[0] == 1
    assert buffer.can_transform_core("world", "car", at(40.5))[0] == 0
    assert "rate: 100." in buffer.all_frames_as_yaml()


NAN = math.nan


@pytest.mark.parametrize(
    ("message", "texts"),
    [
        (
            stamped("car", "car"),
            [
                (
                    'TF_SELF_TRANSFORM: Ignoring transform from authority "me" with frame_id and  child_frame_id "car"'
                    " because they are the same"
                )
            ],
        ),
        (
            stamped("car", ""),
            ['TF_NO_CHILD_FRAME_ID: Ignoring transform from authority "me" because child_frame_id not set '],
        ),
        (
            stamped("", "car"),
            [
                (
                    'TF_NO_FRAME_ID: Ignoring transform with child_frame_id "car"  from authority "me"'
                    " because frame_id not set"
                )
            ],
        ),
        (
            stamped("world", "car", 0, (NAN, 0, 1)),
            [
                (
                    'TF_NAN_INPUT: Ignoring transform for child_frame_id "car" from authority "me" because of a nan value in'
                    " the transform (nan 0.000000 1.000000) (0.000000 0.000000 0.000000 1.000000)"
                )
            ],
        ),
        (
            stamped("world", "car", 0, (0, 0, 0), (0, 0, 0, 0)),
            [
                (
                    'TF_NAN_INPUT: Ignoring transform for child_frame_id "car" from authority "me" because of a nan value in'
                    " the transform (0.000000 0.000000 0.000000) (-nan -nan -nan -nan)"
                ),
                (
                    'TF_DENORMALIZED_QUATERNION: Ignoring transform for child_frame_id "car" from authority "me" because of'
                    " an invalid quaternion in the transform (-nan -nan -nan -nan)"
                ),
            ],
        ),
    ],
)
def test_nonsense_is_logged_and_ignored(message: Any, texts: list[str], capfd: pytest.CaptureFixture[str]) -> None:
    buffer = BufferCore()
    buffer.set_transform(message, "me")
    lines = capfd.readouterr().err.splitlines()
    assert [line.split("]: ", 1)[1] for line in lines] == texts
    assert all(line.startswith("[ERROR] [") and "] []: " in line for line in lines)
    assert buffer._getFrameStrings() == []


def test_a_rotation_of_another_length_is_brought_to_length_one() -> None:
    buffer = BufferCore()
    buffer.set_transform(stamped("world", "car", 1, (0, 0, 0), (0, 0, 3, 3)), "test")
    turn = buffer.lookup_transform_core("world", "car", LATEST).transform.rotation
    assert (turn.z, turn.w) == (pytest.approx(math.sqrt(0.5)), pytest.approx(math.sqrt(0.5)))


def test_a_leading_slash_in_a_message_is_dropped() -> None:
    buffer = BufferCore()
    buffer.set_transform_static(stamped("/world", "/car"), "test")
    assert buffer.can_transform_core("world", "car", LATEST) == (1, "")


def test_a_frame_may_become_fixed_and_move_again() -> None:
    buffer = BufferCore()
    buffer.set_transform(stamped("world", "car", 1, (1, 0, 0)), "test")
    buffer.set_transform_static(stamped("world", "car", 1, (2, 0, 0)), "test")
    assert buffer.lookup_transform_core("world", "car", at(99)).transform.translation.x == 2.0
    buffer.set_transform(stamped("world", "car", 3, (3, 0, 0)), "test")
    assert buffer.can_transform_core("world", "car", at(99))[0] == 0


def test_clear_forgets_what_moves_and_keeps_what_stands() -> None:
    buffer = moving()
    buffer.clear()
    assert buffer.can_transform_core("world", "wheel", LATEST) == (0, NOT_ONE_TREE.format("world", "wheel"))
    assert buffer.can_transform_core("island", "palm", at(9)) == (1, "")
    assert "Frame car exists with parent NO_PARENT." in buffer.all_frames_as_string()


def test_all_frames_as_text() -> None:
    buffer = moving()
    assert buffer.all_frames_as_string() == (
        "Frame car exists with parent world.\nFrame wheel exists with parent car.\nFrame palm exists with parent island.\n"
    )
    assert buffer.all_frames_as_yaml().startswith(
        "car: \n  parent: 'world'\n  broadcaster: 'test'\n  rate: 2.000\n  most_recent_transform: 2.000000\n"
        "  oldest_transform: 1.000000\n  buffer_length: 1.000\nwheel: \n  parent: 'car'\n  broadcaster: 'test'\n"
        "  rate: 10000.000\n  most_recent_transform: 0.000000\n  oldest_transform: 0.000000\n  buffer_length: 0.000\n"
    )
    assert BufferCore().all_frames_as_yaml() == "[]"
    assert buffer._frameExists("palm") and not buffer._frameExists("tree")
    assert buffer._getFrameStrings() == ["car", "world", "wheel", "palm", "island"]


def test_the_chain_names_the_frames_on_the_way() -> None:
    buffer = BufferCore()
    for parent, child in (("world", "a"), ("a", "b"), ("b", "c"), ("world", "d")):
        buffer.set_transform_static(stamped(parent, child), "test")
    assert buffer._chain("a", LATEST, "c", LATEST, "a") == ["c", "b", "a"]
    assert buffer._chain("c", LATEST, "a", LATEST, "c") == ["c", "b", "a"]


def test_velocity_is_the_difference_of_two_lookups() -> None:
    buffer = BufferCore()
    for tick in range(101):
        time = 1 + tick * 0.1
        turn = 0.5 * time
        buffer.set_transform(
            stamped("world", "car", time, (2 * time, 0, 0), (0, 0, math.sin(turn / 2), math.cos(turn / 2))), "test"
        )
    linear, angular = buffer.lookupVelocityCore("car", "world", at(5), Duration(seconds=0.2))
    assert angular == pytest.approx((0, 0, 0.5), abs=1e-6)
    still, _ = BufferCoreAt((3, 4, 0)).lookupVelocityCore("car", "world", at(5), Duration(seconds=0.2))
    assert still == pytest.approx((0, 0, 0))
    assert all(map(math.isfinite, linear))


class BufferCoreAt(BufferCore):
    """A car that stands."""

    def __init__(self, place: tuple[float, float, float]) -> None:
        super().__init__()
        for second in (1, 9):
            self.set_transform(stamped("world", "car", second, place), "test")


def test_times_may_be_messages_but_not_numbers() -> None:
    buffer = moving()
    assert buffer.lookup_transform_core("world", "car", TimeMsg(sec=1)).header.stamp.sec == 1
    with pytest.raises(TypeError, match=r"^time must have sec and nanosec, or nanoseconds\.$"):
        buffer.lookup_transform_core("world", "car", 1.0)
    with pytest.raises(TypeError, match=r"^argument 1 must be str, not NoneType$|^argument 1 must be str, not None$"):
        buffer.lookup_transform_core(None, "car", LATEST)
    with pytest.raises(TypeError, match=r"^duration must have sec and nanosec, or nanoseconds\.$"):
        BufferCore(10)


def test_a_transform_must_look_like_one() -> None:
    class Odd:
        header = stamped("a", "b").header
        child_frame_id = "b"
        transform = Pose()

    with pytest.raises(AttributeError):
        BufferCore().set_transform(Odd(), "test")
    odd = Odd()
    odd.transform = type("T", (), {"translation": Pose().position, "rotation": Pose().orientation})()
    with warnings.catch_warnings(), pytest.raises(TypeError, match=r"transform\.translation must have members x, y, z"):
        warnings.simplefilter("ignore")
        BufferCore().set_transform(odd, "test")


def test_the_exceptions_are_of_one_family_and_called_as_in_real_tracebacks() -> None:
    for name in ("Connectivity", "Lookup", "Extrapolation", "InvalidArgument", "Timeout"):
        kind = getattr(tf2_py, f"{name}Exception")
        assert kind.__mro__[1] is TransformException
        assert f"{kind.__module__}.{kind.__qualname__}" == f"tf2.{name}Exception"

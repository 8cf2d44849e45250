"""Records what real ROS 2 message classes do into data/real.json.gz; run by hand where real rclpy is installed:

    REAL_PYTHON tests/interfaces/record_real.py OUR_PYTHON

OUR_PYTHON is an interpreter in which `day6_tui` can be imported. It is started once to read the bytes real ROS made and
to write them again; real ROS must read the same values from that. Only then are the bytes recorded. Besides the
recording this module holds the questions asked of every class, which test_real_classes.py asks ours.
"""

from __future__ import annotations

import array
import collections
import gzip
import json
import os
import random
import subprocess
import sys
from pathlib import Path
from typing import Any

DATA = Path(__file__).parent / "data" / "real.json.gz"
PACKAGES = [
    "action_msgs", "actionlib_msgs", "builtin_interfaces", "diagnostic_msgs", "geometry_msgs", "lifecycle_msgs",
    "nav_msgs", "rcl_interfaces", "rosgraph_msgs", "sensor_msgs", "service_msgs", "shape_msgs", "std_msgs", "std_srvs",
    "stereo_msgs", "test_msgs", "trajectory_msgs", "type_description_interfaces", "unique_identifier_msgs",
    "visualization_msgs",
]  # fmt: skip
PARTS = {
    "msg": [""],
    "srv": ["_Request", "_Response", "_Event"],
    "action": [
        "_Goal", "_Result", "_Feedback", "_SendGoal_Request", "_SendGoal_Response", "_SendGoal_Event",
        "_GetResult_Request", "_GetResult_Response", "_GetResult_Event", "_FeedbackMessage",
    ],
}  # fmt: skip
SAMPLES = 3
MARK = "\x01"
"""Stands for the name of the field in recorded texts, so that fields of one type share one record."""


def find_class(name: str) -> Any:
    """Return the class of 'test_msgs/action/Fibonacci_Goal' by importing its own module, as pickle does."""
    from importlib import import_module

    package, kind, own = name.split("/")
    base = own.partition("_")[0]
    snake = "".join(
        f"_{char.lower()}" if index and is_word_start(base, index) else char.lower() for index, char in enumerate(base)
    )
    return getattr(import_module(f"{package}.{kind}._{snake}"), own)


def is_word_start(name: str, index: int) -> bool:
    """Say whether rosidl puts an underscore before this character in the name of a module."""
    if not name[index].isupper():
        return False
    return name[index + 1 : index + 2].islower() or not name[index - 1].isupper()


# --- what a class is ------------------------------------------------------------------------------------------------


def type_text(type_: Any) -> str:
    """Return an entry of SLOT_TYPES as text: class name and attributes."""
    text = type(type_).__name__
    for attribute in ("typename", "namespaces", "name", "maximum_size", "size"):
        if hasattr(type_, attribute):
            text += f" {attribute}={getattr(type_, attribute)}"
    return text + (f" of {type_text(type_.value_type)}" if hasattr(type_, "value_type") else "")


def value_text(value: Any) -> str:
    """Return a value as text that does not depend on numpy's version."""
    if type(value).__name__ == "ndarray":
        return f"ndarray {value.dtype} {value.tolist()}"
    if isinstance(value, (list, tuple)):
        return f"{type(value).__name__} [{', '.join(map(value_text, value))}]"
    return repr(value)


def describe(cls: Any) -> dict[str, Any]:
    """Return everything about a class that can be read off it."""
    constants = {key: value_text(getattr(cls, key)) for key in dir(type(cls)) if key[0].isupper()}
    empty = cls()
    return {
        "slots": list(cls.__slots__),
        "fields": cls.get_fields_and_field_types(),
        "order": list(cls.get_fields_and_field_types()),
        "types": [type_text(type_) for type_ in cls.SLOT_TYPES],
        "constants": constants,
        "inherited": {key: value_text(getattr(empty, key)) for key in constants},
        "defaults": {field: value_text(getattr(empty, field)) for field in cls.get_fields_and_field_types()},
        "repr": repr(empty),
        "name": [cls.__module__, cls.__name__, cls.__qualname__, cls.__doc__, type(cls).__name__, type(cls).__doc__],
        "docs": [getattr(cls, field).__doc__ for field in cls.get_fields_and_field_types()],
    }


# --- what its fields accept -----------------------------------------------------------------------------------------


def questions(cls: Any, field: str) -> list[Any]:
    """Return the values every field is asked to take."""
    import numpy
    from std_msgs.msg import ColorRGBA

    floats, ints = [1.5, -2.0, 0.0], [1, 0, 2]
    nested = nested_class(cls, field)
    return [
        None, True, 0, 1, -1, 127, 128, 255, 256, 32768, 65535, 65536, 2**31, 2**32, 2**63, 2**64, 1.5, 1e39, -1e39,
        float("inf"), float("nan"), "", "text", "x" * 23, b"a", b"ab", bytearray(b"a"), 1j,
        collections.UserString("abc"), numpy.float64(1.5), numpy.float32(1.5), numpy.int64(1), numpy.bool_(True),
        [], (), set(), {}, "abc", b"abc", floats, ints, tuple(floats), tuple(ints), set(ints),
        collections.UserList(ints), collections.UserList(floats), collections.deque(ints), range(3), ["a"],
        ["a", "b", "c"], ("a", "b", "c"), {"a"}, ["a", 1], [b"a", b"b", b"c"], [b"abc"], [True], [True, False, True],
        [None], [1.5], [1.5, 1], [1], [-1, 0, 1], [256], [2**31], [2**64], [1e39, 1.0, 1.0], [float("nan"), 1e39, 0.0],
        [float("inf"), 0.0, 1.0], [0.0] * 4, [0] * 16, [0.0] * 9, [0.0] * 36, ["x" * 300], [[1]],
        array.array("d", floats), array.array("f", floats), array.array("i", ints), array.array("B", ints),
        array.array("b", ints), array.array("q", ints), array.array("d", [0.0] * 4), array.array("d"), numpy.zeros(3),
        numpy.zeros(3, dtype=numpy.float32), numpy.zeros(9), numpy.zeros(36), numpy.zeros((3, 3)),
        numpy.zeros(16, dtype=numpy.uint8), numpy.zeros(3, dtype=numpy.uint32), numpy.zeros(3, dtype=numpy.int8),
        ColorRGBA(), [ColorRGBA()], nested and nested(), [nested and nested()], [nested and nested() for _ in range(3)],
        [nested and nested() for _ in range(5)], (nested and nested(),),
    ]  # fmt: skip


def nested_class(cls: Any, field: str) -> Any:
    """Return the class of a field's messages, None where it holds none."""
    type_ = cls.SLOT_TYPES[list(cls.get_fields_and_field_types()).index(field)]
    type_ = getattr(type_, "value_type", type_)
    return find_class("/".join((*type_.namespaces, type_.name))) if hasattr(type_, "namespaces") else None


def answers(cls: Any, field: str) -> list[str]:
    """Return what happens for every question: set on a message, given to the constructor, set with checks off."""
    found = []
    for ask in (
        lambda value: set_field(cls(check_fields=True), field, value),
        lambda value: getattr(cls(check_fields=True, **{field: value}), field),
        lambda value: set_field(cls(check_fields=False), field, value),
    ):
        for value in questions(cls, field):
            try:
                kept = ask(value)
                text = f"kept {'the same ' if kept is value else ''}{type(kept).__name__}"
            except AssertionError as error:
                text = str(error)
            except Exception as error:  # texts of Python and numpy change between versions
                text = f"raised {type(error).__name__}"
            found.append(text.replace(f"'{field}'", MARK))
    return found


def set_field(message: Any, field: str, value: Any) -> Any:
    """Set a field; return what the message has there afterwards."""
    setattr(message, field, value)
    return getattr(message, field)


# --- messages with random contents ----------------------------------------------------------------------------------

_LETTERS = "abcxyz 0123456789/_-äßñ漢字ロボ"


def random_message(cls: Any, rng: random.Random) -> Any:
    """Return a message with random contents in every field."""
    message = cls()
    for field, type_ in zip(cls.get_fields_and_field_types(), cls.SLOT_TYPES, strict=True):
        setattr(message, field, random_value(type_, rng))
    return message


def random_value(type_: Any, rng: random.Random) -> Any:
    """Return a random value a field of this type accepts."""
    if hasattr(type_, "value_type"):
        if hasattr(type_, "size"):
            count = type_.size
        else:
            count = rng.choice((0, 1, 2, min(3, getattr(type_, "maximum_size", 3))))
            count = min(count, getattr(type_, "maximum_size", 3))
        return [random_value(type_.value_type, rng) for _ in range(count)]
    if hasattr(type_, "namespaces"):
        return random_message(find_class("/".join((*type_.namespaces, type_.name))), rng)
    if hasattr(type_, "typename"):
        return random_basic(type_.typename, rng)
    text = "".join(rng.choice(_LETTERS) for _ in range(rng.randrange(9)))
    return text + "😀" if "WString" in type(type_).__name__ and rng.random() < 0.5 else text


def random_basic(name: str, rng: random.Random) -> Any:
    """Return a random value of a basic type."""
    if name == "boolean":
        return rng.random() < 0.5
    if name == "octet":
        return bytes([rng.randrange(256)])
    if name in ("float", "double"):
        return rng.choice((0.0, -0.0, 0.5, -1.25e9, 3.0, float("inf"), rng.randrange(10**6) / 1024))
    bits = int(name.lstrip("uint"))
    low = 0 if name.startswith("u") else -(2 ** (bits - 1))
    return rng.choice((low, low + 2**bits - 1, 0, 1, rng.randrange(low, low + 2**bits)))


# --- texts of interfaces ----------------------------------------------------------------------------------------------

TEXTS = [
    "int32 a", "int32   a   # comment", "\tint32\ta", "int32 a 5", "int32 a  -5 # five", "int32 a 0x10",
    "int32 a 0b11", "uint8 a 256",
    "int8 a -129", "int32 a five", "int32 a 5.0", "float64 a 5", "float64 a 1e3", "float64 a x", "bool a true",
    "bool a 1",
    "bool a FALSE", "bool a yes", "byte a 255", "byte a 256", "char a 97", "char a a", "string a", "string a hello",
    "string a hello world", 'string a "quoted"', "string a 'quoted'", "string a 'it\\'s'", "string a 'it's'",
    'string a "# no comment"', "string a ''", "string<=5 a abc", "string<=5 a abcdef", "string<=0 a", "string<=x a",
    "wstring a 'ロボ'", "wstring<=3 a", "int32[] a", "int32[3] a", "int32[<=3] a", "int32[0] a", "int32[-1] a",
    "int32[x] a",
    "int32[<=0] a", "int32] a", "int32[3] a [1, 2, 3]", "int32[3] a [1, 2]", "int32[<=2] a [1, 2, 3]", "int32[] a []",
    "int32[] a 1, 2", "int32[] a [1, x]", "uint8[2] a [1, 300]", "bool[] a [true, 0]", "float32[] a [1, 2.5]",
    "string[] a ['x', \"y\"]", "string[] a ['x, y', z]", "string[] a [x, y]", "string[2] a ['x']", "string[] a ['x]",
    "string[] a [, x]", "string<=2[] a ['abc']", "Point a", "geometry_msgs/Point a", "geometry_msgs/Point[4] a",
    "geometry_msgs/msg/Point a", "Geometry/Point a", "geometry__msgs/Point a", "geometry_msgs/point a", "point a",
    "int a", "Point a 5", "Point[] a [1]", "int32", "int32 ", "int32 A", "int32 _a", "int32 a_", "int32 a__b",
    "int32 1a",
    "int32 ä", "int32 a\nint32 a", "int32 A=1\nint32 A=2", "int32 A=5", "int32 A = 5", "int32 A=", "int32 a=5",
    "int32 A_=5", "int32 A__B=5", "int32 A1_B2=5", "uint8 A=-1", "string A=text # c", "string A='text'",
    'string A="a b"',
    "string A=", "bool A=true", "float32 A=0.1", "byte A=7", "Point A=1", "int32[] A=[1]", "string a a=b",
    "# only a comment", "",
    "   ", "  int32 a", "int32 a # [m]\n  # more", "duration d", "time t", "int32 a\n---\nint32 b", "float64 a nan",
    "int32 a 1_0",
    "string a x ", "string a 'x' 'y'", "int64 a 9223372036854775808", "uint64 a 18446744073709551615",
]  # fmt: skip
PARTED_TEXTS = ["", "---", "int32 a\n---\nint32 a", "---\n---", "--- \n", "int32 a\n ---\n", "---\n---\n---"]


def real_outcome(kind: str, text: str) -> Any:
    """Return what ROS's own parser finds in a text, or its error."""
    from rosidl_adapter import parser

    try:
        if kind == "msg":
            found = parser.parse_message_string("pkg", "Name", text)
            return {
                "fields": [[str(field.type), field.name, repr(field.default_value)] for field in found.fields],
                "constants": [[constant.type, constant.name, repr(constant.value)] for constant in found.constants],
            }
        (parser.parse_service_string if kind == "srv" else parser.parse_action_string)("pkg", "Name", text)
        return "good"
    except Exception as error:
        return f"{type(error).__name__}: {error}"


# --- recording ------------------------------------------------------------------------------------------------------


def real_names() -> tuple[list[str], list[str]]:
    """Return the full names of all message-like classes, and of all services and actions, of the real installation."""
    share = Path(sys.prefix) / "share"
    classes, interfaces = [], []
    for package in PACKAGES:
        for kind, parts in PARTS.items():
            for path in sorted((share / package / kind).glob(f"*.{kind}")):
                classes += [f"{package}/{kind}/{path.stem}{part}" for part in parts]
                interfaces.append(f"{package}/{kind}/{path.stem}")
    return classes, interfaces


def real_hashes() -> dict[str, str]:
    """Return every hash in the JSON files of the real installation."""
    hashes = {}
    for package in PACKAGES:
        for kind in PARTS:
            folder = Path(sys.prefix) / "share" / package / kind
            for path in sorted(folder.glob("*.json")):
                if (folder / f"{path.stem}.{kind}").exists():
                    for entry in json.loads(path.read_text())["type_hashes"]:
                        hashes[entry["type_name"]] = entry["hash_string"]
    return hashes


def record(our_python: str) -> None:
    """Ask the real classes everything and write the answers."""
    from rclpy.serialization import deserialize_message, serialize_message

    rng = random.Random(6)
    classes, interfaces = real_names()
    lists: list[list[str]] = []
    numbers: dict[tuple[str, ...], int] = {}
    recorded: dict[str, Any] = {}
    real_bytes: dict[str, list[str]] = {}
    for name in classes:
        cls = find_class(name)
        entry = recorded[name] = describe(cls)
        entry["answers"] = {}
        for field in entry["order"]:
            found = answers(cls, field)
            number = numbers.setdefault(tuple(found), len(lists))
            if number == len(lists):
                lists.append(found)
            entry["answers"][field] = number
        messages = [cls(), *(random_message(cls, rng) for _ in range(SAMPLES))]
        real_bytes[name] = [serialize_message(message).hex() for message in messages]
        entry["contents"] = [value_texts(message) for message in messages]

    written_by_us = ask_ours(our_python, real_bytes)
    for name, entry in recorded.items():
        cls = find_class(name)
        for ours, contents in zip(written_by_us[name], entry["contents"], strict=True):
            read = value_texts(deserialize_message(bytes.fromhex(ours), cls))
            assert read == contents, f"{name}: real ROS reads {read} from our bytes, not {contents}"
        entry["real_bytes"] = real_bytes[name]
        entry["our_bytes"] = written_by_us[name]

    services = {name: type(find_class(name)).__name__ for name in interfaces if "/msg/" not in name}
    texts = [["msg", text, real_outcome("msg", text)] for text in TEXTS]
    texts += [[kind, text, real_outcome(kind, text)] for kind in ("srv", "action") for text in PARTED_TEXTS]
    data = {"texts": texts, "classes": recorded, "answers": lists, "hashes": real_hashes(), "services": services}
    DATA.parent.mkdir(exist_ok=True)
    with gzip.GzipFile(DATA, "wb", mtime=0) as file:
        file.write(json.dumps(data, separators=(",", ":"), ensure_ascii=False).encode())
    print(f"{len(recorded)} classes, {len(lists)} lists of answers, {DATA.stat().st_size} bytes")


def value_texts(message: Any) -> list[str]:
    """Return the contents of a message, field by field."""
    return [contents(getattr(message, field)) for field in message.get_fields_and_field_types()]


def contents(value: Any) -> str:
    """Return a value as text: messages by their contents, arrays of numbers as lists."""
    if hasattr(value, "get_fields_and_field_types"):
        return f"({', '.join(value_texts(value))})"
    if hasattr(value, "tolist"):
        return str(value.tolist())
    if isinstance(value, list):
        return f"[{', '.join(map(contents, value))}]"
    return repr(value)


def ask_ours(our_python: str, real_bytes: dict[str, list[str]]) -> dict[str, list[str]]:
    """Let our own codec read the real bytes and write them again."""
    root = Path(__file__).resolve().parents[2]
    env = {**os.environ, "PYTHONPATH": str(root / "core" / "day6_core" / "ros" / "python")}
    command = [our_python, __file__, "--rewrite"]
    done = subprocess.run(command, input=json.dumps(real_bytes), env=env, capture_output=True, text=True, check=True)
    answer: dict[str, list[str]] = json.loads(done.stdout)
    return answer


def rewrite() -> None:
    """Read real bytes from standard input, write what our codec makes of them to standard output."""
    from day6_core.interfaces import deserialize, serialize

    result = {}
    for name, samples in json.load(sys.stdin).items():
        cls = find_class(name)
        result[name] = [serialize(deserialize(bytes.fromhex(sample), cls)).hex() for sample in samples]
    json.dump(result, sys.stdout)


if __name__ == "__main__":
    os.environ["ROS_PYTHON_CHECK_FIELDS"] = "1"
    if sys.argv[1:] == ["--rewrite"]:
        rewrite()
    else:
        record(sys.argv[1])

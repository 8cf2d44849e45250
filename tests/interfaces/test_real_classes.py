"""Every class of every package real ROS was asked about equals the real one (data recorded by record_real.py)."""

from __future__ import annotations

import gzip
import importlib.util
import json
import warnings
from importlib.metadata import version
from pathlib import Path
from types import ModuleType
from typing import Any

import pytest

from day6_core.interfaces import deserialize, get_interface, registry, serialize, type_hash, type_name
from tests.support.folded import folded


def _load(name: str) -> ModuleType:
    spec = importlib.util.spec_from_file_location(name, Path(__file__).with_name(f"{name}.py"))
    assert spec is not None and spec.loader is not None
    module = importlib.util.module_from_spec(spec)
    spec.loader.exec_module(module)
    return module


real = _load("record_real")
DATA: dict[str, Any] = json.loads(gzip.decompress(real.DATA.read_bytes()))
CLASSES: dict[str, Any] = DATA["classes"]
of_numpy_2 = pytest.mark.skipif(
    version("numpy").startswith("1."), reason="recorded with NumPy 2: 1 has other names and defaults"
)


def test_the_recording_covers_every_package_with_a_wheel() -> None:
    assert {name.partition("/")[0] for name in CLASSES} == set(real.PACKAGES)
    assert len(CLASSES) == 270


def test_we_have_no_interface_in_these_packages_that_real_ros_has_not() -> None:
    ours = {f"{package}/{name}" for package in real.PACKAGES for name in registry.interface_names(package)}
    assert ours == {registry.base_name(name) for name in CLASSES}


@of_numpy_2
@folded("name", CLASSES)
def test_a_class_looks_like_the_real_one(name: str) -> None:
    recorded = CLASSES[name]
    described = real.describe(real.find_class(name))
    assert described == {key: recorded[key] for key in described}


@of_numpy_2
@folded("name", CLASSES)
def test_fields_accept_and_refuse_what_the_real_ones_do(name: str) -> None:
    cls = real.find_class(name)
    for field, number in CLASSES[name]["answers"].items():
        asked = [(way, value) for way in ("set", "argument", "unchecked") for value in real.questions(cls, field)]
        with warnings.catch_warnings():
            warnings.simplefilter("ignore", RuntimeWarning)  # numpy: overflow in a cast to float32
            answers = real.answers(cls, field)
        for question, ours, theirs in zip(asked, answers, DATA["answers"][number], strict=True):
            assert ours == theirs, (field, *question)


@folded("name", CLASSES)
def test_bytes_real_ros_made_are_read_as_the_values_it_wrote(name: str) -> None:
    cls = real.find_class(name)
    for sample, contents in zip(CLASSES[name]["real_bytes"], CLASSES[name]["contents"], strict=True):
        assert real.value_texts(deserialize(bytes.fromhex(sample), cls)) == contents


@folded("name", CLASSES)
def test_we_write_the_bytes_real_ros_has_read_back(name: str) -> None:
    cls = real.find_class(name)
    samples = zip(CLASSES[name]["real_bytes"], CLASSES[name]["our_bytes"], strict=True)
    for theirs, ours in samples:
        assert serialize(deserialize(bytes.fromhex(theirs), cls)).hex() == ours


def test_every_hash_is_the_real_one() -> None:
    hashes = {name: type_hash(get_interface(name)) for name in DATA["hashes"]}
    assert hashes == DATA["hashes"]
    assert len(hashes) > 300


def test_services_and_actions_have_the_parts_of_the_real_ones() -> None:
    for name, metaclass in DATA["services"].items():
        cls = real.find_class(name)
        assert type(cls).__name__ == metaclass
        parts = ("Request", "Response", "Event") if "/srv/" in name else ("Goal", "Result", "Feedback")
        assert [type_name(getattr(cls, part)) for part in parts] == [f"{name}_{part}" for part in parts]

"""Advice about robots that are correct and still not what was meant; a good robot gets none."""

from __future__ import annotations

import pytest

from day6_urdf import parse_robot, shipped_model, shipped_models
from day6_urdf.advice import advice_of

CAR = """<robot name="r">
  <link name="base"/>
  <link name="wheel"><visual>{origin}<geometry><cylinder radius="0.05" length="0.03"/></geometry></visual></link>
  <joint name="j" type="{kind}">
    <parent link="base"/><child link="wheel"/><axis xyz="{axis}"/>{limit}
  </joint>
</robot>
"""
LAID = '<origin rpy="1.5707963 0 0"/>'
LIMIT = '<limit effort="1" velocity="1"/>'


def advice(
    origin: str = LAID, kind: str = "continuous", axis: str = "0 1 0", limit: str = "", language: str = "en"
) -> str:
    text = CAR.format(origin=origin, kind=kind, axis=axis, limit=limit)
    hint = advice_of(parse_robot(text), text, language)
    return hint.sentence("car.urdf", language) if hint is not None else ""


@pytest.mark.parametrize("name", shipped_models())
def test_the_shipped_robots_get_none(name: str) -> None:
    text = shipped_model(name).read_text(encoding="utf-8")
    assert advice_of(parse_robot(text), text) is None


def test_a_wheel_as_it_should_be_gets_none() -> None:
    assert advice() == ""
    assert advice(origin="", axis="0 0 1") == ""  # a turntable


def test_a_cylinder_that_still_stands_upright_is_noticed() -> None:
    said = advice(origin="")
    assert said.startswith("hint: car.urdf, line 4, column 3: wheel wheel does not turn about its cylinder's axis")
    assert "会乱晃" in advice(origin="", language="zh")


def test_an_axis_along_the_road_is_noticed() -> None:
    assert "it tumbles" in advice(axis="1 0 0")


def test_no_axis_and_no_room_to_move_are_noticed() -> None:
    assert "0 0 0 is not a direction" in advice(axis="0 0 0")
    assert "from 0 to 0, so it cannot move" in advice(kind="revolute", limit=LIMIT)

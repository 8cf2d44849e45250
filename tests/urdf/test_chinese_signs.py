"""Chinese punctuation in a robot description is named wherever it stands, beside the parser's own message."""

from __future__ import annotations

import pytest

from day6_urdf import check_text
from day6_urdf.chinese import numbers, sign_in
from day6_urdf.explain import hint_of

ROBOT = """<robot name="车，一号">
  <link name="base">
    <visual>
      <origin xyz="0 0 7" rpy="0 0 8"/>
      <geometry><box size="1 2 3"/></geometry>
      <material name="m"><color rgba="1 0 0 1"/></material>
    </visual>
    <inertial>
      <mass value="5"/>
      <inertia ixx="6" ixy="0" ixz="0" iyy="1" iyz="0" izz="1"/>
    </inertial>
  </link>
  <link name="wheel">
    <visual><geometry><cylinder radius="0.4" length="0.1"/></geometry></visual>
    <collision><geometry><sphere radius="0.3"/></geometry></collision>
  </link>
  <joint name="j" type="revolute">
    <parent link="base"/>
    <child link="wheel"/>
    <axis xyz="0 1 0"/>
    <limit lower="-1.5" upper="1.5" effort="4" velocity="9"/>
    <dynamics damping="0.2" friction="0.6"/>
  </joint>
</robot>
"""


def hint(text: str, language: str = "en") -> str:
    found = hint_of(check_text(text), text, language)
    return found.sentence("car.urdf", language) if found is not None else ""


def test_a_name_may_have_any_sign() -> None:
    assert hint(ROBOT) == ""


@pytest.mark.parametrize(
    "value", ["0 0 7", "0 0 8", "1 2 3", "1 0 0 1", "0 1 0"], ids=["xyz", "rpy", "size", "rgba", "axis"]
)
@pytest.mark.parametrize("sign", ["，", "、", "\u3000"])
def test_a_sign_between_numbers_is_named_and_put_right(value: str, sign: str) -> None:
    wrong = value.replace(" ", sign)
    text = ROBOT.replace(f'"{value}"', f'"{wrong}"', 1)
    line = ROBOT[: ROBOT.index(f'"{value}"')].count("\n") + 1
    said = hint(text)
    assert f'write "{value}" instead of "{wrong}"' in said and f'not a Chinese "{sign}"' in said
    assert f'把 "{wrong}" 写成 "{value}"' in hint(text, "zh") and f"中文的「{sign}」" in hint(text, "zh")
    assert line - 1 <= int(said.split("line ")[1].split(",")[0]) <= line  # the element, or the one it is in


@pytest.mark.parametrize(
    "attribute",
    [
        'value="5"', 'ixx="6"', 'radius="0.4"', 'length="0.1"', 'radius="0.3"', 'lower="-1.5"', 'upper="1.5"', 'effort="4"',
        'velocity="9"', 'damping="0.2"', 'friction="0.6"',
    ],
)  # fmt: skip
def test_a_wide_sign_in_a_number_is_named_and_put_right(attribute: str) -> None:
    name, _, value = attribute.partition("=")
    value = value.strip('"')
    wide = value.translate({ord("."): "。", ord("-"): "－"} if "." in value else {ord(value): chr(ord(value) + 0xFEE0)})
    said = hint(ROBOT.replace(attribute, f'{name}="{wide}"', 1))
    assert (
        f'write "{value}" instead of "{wide}"' in said
        and f'a Chinese "{sign_in(wide)}" cannot be part of a number' in said
    )


@pytest.mark.parametrize(
    ("before", "after", "sign"),
    [
        ('xyz="0 1 0"', "xyz=“0 1 0”", "“"),
        ('size="1 2 3"', 'size="1 2 3”', "”"),
        ('name="j" type', 'name="j"，type', "，"),
        ('type="revolute"', 'type＝"revolute"', "＝"),
    ],
)
def test_a_sign_that_spoils_a_tag_is_named(before: str, after: str, sign: str) -> None:
    text = ROBOT.replace(before, after, 1)
    assert f'this tag has a Chinese "{sign}"' in hint(text) and f"这个标签里有中文的「{sign}」" in hint(text, "zh")


def test_only_numbers_with_a_chinese_sign_are_put_right() -> None:
    assert [numbers(value) for value in ("0，1", "1e－3", "0，a", "0 1", "一，二", "", "０")] == [
        "0 1",
        "1e-3",
        "",
        "",
        "",
        "",
        "0",
    ]

"""The hint beside urdfdom's messages: where to look in the file, and what is wanted, in the user's language."""

from __future__ import annotations

import json
from pathlib import Path

from day6_urdf import check_text
from day6_urdf.explain import hint_of, hints_wanted

GOLDEN = Path(__file__).resolve().parents[1] / "conformance" / "golden" / "check_urdf.jsonl"

CAR = """<robot name="r">
  <link name="base_link"/>
  <link name="left_wheel"/>
  <joint name="j" type="{type}">
    <parent link="base_link"/>
    <child link="{child}"/>
    {more}
  </joint>
</robot>
"""


def hint(text: str, language: str = "en") -> str:
    found = hint_of(check_text(text), text, language)
    assert found is not None
    return found.sentence("car.urdf", language)


def test_a_correct_file_needs_no_hint() -> None:
    text = CAR.format(type="continuous", child="left_wheel", more="")
    assert hint_of(check_text(text), text) is None


def test_a_tag_that_is_not_closed_is_found_by_line_and_column() -> None:
    text = '<robot name="r">\n  <link name="a">\n    <visual>\n  </link>\n</robot>\n'
    assert hint(text).startswith("hint: car.urdf, line 3, column 5: the tag <visual> that starts here isn't closed")
    assert hint(text, "zh").startswith("提示：car.urdf 第 3 行第 5 列：这里开始的标签 <visual> 没有关好")


def test_a_link_that_is_not_there_gets_the_nearest_name_suggested() -> None:
    text = CAR.format(type="continuous", child="wheel_left", more="")
    assert "there is no link with that name. Did you mean left_wheel?" in hint(text)
    assert "是不是想写 left_wheel？" in hint(text, "zh")


def test_a_hinge_is_told_which_types_there_are() -> None:
    assert hint(CAR.format(type="continous", child="left_wheel", more="")).endswith("Did you mean continuous?")


def test_a_revolute_joint_without_limits_is_told_how_to_write_them() -> None:
    said = hint(CAR.format(type="revolute", child="left_wheel", more=""))
    assert "line 4, column 3" in said and "a revolute joint moves between two limits" in said


def test_commas_between_numbers_are_named() -> None:
    text = CAR.format(type="fixed", child="left_wheel", more='<origin xyz="1,2,3"/>')
    assert "line 7, column 5" in hint(text) and "not with commas" in hint(text)


def test_every_recorded_mistake_has_a_hint_in_both_languages() -> None:
    cases = [json.loads(line) for line in GOLDEN.read_text(encoding="utf-8").splitlines()]
    broken = [case for case in cases if case["urdf"] is not None and "Error:   " in case["stderr"]]
    assert len(broken) > 20
    for case in broken:
        english, chinese = (hint(case["urdf"], language) for language in ("en", "zh"))
        assert english != chinese, case["name"]
        assert english.startswith("hint: ") and chinese.startswith("提示：")
        assert "{" not in english + chinese


def test_hints_can_be_switched_off() -> None:
    assert hints_wanted({}) and not hints_wanted({"DAY6_HINTS": "off"})

"""Messages as trees of fields, and what becomes of expressions in them."""

from __future__ import annotations

import pytest
from geometry_msgs.msg import PoseWithCovariance, Twist
from sensor_msgs.msg import Image, PointCloud2
from std_msgs.msg import Float64MultiArray, MultiArrayDimension, UInt8
from test_msgs.msg import Arrays

from day6_core.ros.programs.rqt_py_common.expressions import NAMES
from day6_core.ros.programs.rqt_py_common.message_form import MOST_ROWS, MessageForm, field_rows, value_text
from day6_core.ros.programs.rqt_service_caller.model import convert


def test_the_fields_stand_below_the_message_they_belong_to() -> None:
    rows = [(row.path, row.name, row.type, row.depth, row.text) for row in field_rows(Twist())]
    assert rows[:3] == [
        ("/linear", "linear", "geometry_msgs/Vector3", 0, ""),
        ("/linear/x", "x", "double", 1, "0.0"),
        ("/linear/y", "y", "double", 1, "0.0"),
    ]
    assert [row.path for row in field_rows(Twist()) if row.is_branch] == ["/linear", "/angular"]


def test_messages_in_an_array_have_their_number() -> None:
    message = Float64MultiArray()
    message.layout.dim = [MultiArrayDimension(label="rows"), MultiArrayDimension()]
    rows = {row.path: row for row in field_rows(message)}
    assert rows["/layout/dim[0]/label"].text == "'rows'" and rows["/layout/dim[1]"].is_branch


def test_numbers_are_written_as_a_list_whatever_keeps_them() -> None:
    assert {row.path: row.text for row in field_rows(PoseWithCovariance())}["/covariance"] == str([0.0] * 36)
    assert value_text(Image(data=[1, 2, 3]).data) == "[1, 2, 3]"
    assert value_text(Arrays().byte_values).startswith("[b'\\x00', ")


def test_a_huge_value_is_written_only_in_part() -> None:
    cloud = PointCloud2(data=bytes(3_000_000))
    text = {row.path: row.text for row in field_rows(cloud)}["/data"]
    assert len(text) < 5000 and text.endswith("...]")
    assert len(value_text("x" * 10_000_000)) < 10_000


def test_a_tree_of_thousands_of_fields_is_listed_only_in_part() -> None:
    message = Float64MultiArray()
    message.layout.dim = [MultiArrayDimension() for _ in range(1000)]
    rows = field_rows(message)
    assert len(rows) == MOST_ROWS + 1 and rows[-1].name == "..."


def _filled(message_class: type, **expressions: str) -> tuple[MessageForm, object]:
    form = MessageForm(message_class, convert)
    for path, text in expressions.items():
        form.set("/" + path.replace("__", "/"), text)
    return form, form.message(NAMES)


def test_an_expression_replaces_the_default_and_an_empty_one_brings_it_back() -> None:
    form, twist = _filled(Twist, linear__x="2 * pi", angular__z="-1")
    assert twist.linear.x == pytest.approx(6.2832, abs=1e-4) and twist.angular.z == -1.0
    form.set("/linear/x", " ")
    assert form.message(NAMES).linear.x == 0.0
    assert [row.text for row in form.rows() if row.path in ("/linear/x", "/angular/z")] == ["0.0", "-1"]


def test_every_message_is_a_new_one() -> None:
    form, first = _filled(Twist, linear__x="1.0")
    assert form.message(NAMES) is not first


def test_a_value_out_of_range_keeps_the_default_and_says_why() -> None:
    form, message = _filled(UInt8, data="300")
    assert message.data == 0
    assert form.problems == {
        "/data": "Failed to set data to 300\n\tThe 'data' field must be an unsigned integer in [0, 255]"
    }
    assert form.rows()[0].problem == form.problems["/data"]


def test_one_wrong_expression_does_not_stop_the_others() -> None:
    form, twist = _filled(Twist, linear__x="fast", linear__y="2")
    assert twist.linear.y == 2.0 and list(form.problems) == ["/linear/x"]


def test_the_elements_of_an_array_become_what_the_array_holds() -> None:
    _, message = _filled(Float64MultiArray, data="[1, 2, 3.5]")
    assert list(message.data) == [1.0, 2.0, 3.5]
    _, pose = _filled(PoseWithCovariance, covariance="[1] * 36")
    assert list(pose.covariance) == [1.0] * 36


@pytest.mark.parametrize("text", ["[1]", "7", "one, two", "[[1]]", "['a'] * 36"])
def test_what_is_no_such_array_is_refused(text: str) -> None:
    form, _ = _filled(PoseWithCovariance, covariance=text)
    assert form.problems


def test_a_whole_message_can_be_given_and_its_fields_give_way() -> None:
    form, twist = _filled(Twist, linear="geometry_msgs.msg.Vector3(x=1.0)", linear__x="9")
    assert twist.linear.x == 1.0 and form.problems == {}


def test_a_list_of_messages_can_be_given() -> None:
    _, message = _filled(Float64MultiArray, layout__dim="[std_msgs.msg.MultiArrayDimension(label='a', size=2)]")
    assert message.layout.dim[0].label == "a"


def test_bytes_are_written_as_numbers_or_as_python_writes_them() -> None:
    _, arrays = _filled(Arrays, byte_values="[1, b'a', 255]")
    assert list(arrays.byte_values) == [b"\x01", b"a", b"\xff"]


def test_a_field_that_there_is_not_is_refused() -> None:
    form = MessageForm(Twist, convert)
    with pytest.raises(LookupError):
        form.set("/linear/w", "1")


def test_an_array_is_a_branch_of_its_elements_unless_it_is_huge() -> None:
    rows = {row.path: row for row in field_rows(PoseWithCovariance())}
    assert rows["/covariance"].is_branch and rows["/covariance"].elements == 36
    assert (rows["/covariance[35]"].name, rows["/covariance[35]"].type) == ("[35]", "double")
    assert not field_rows(Float64MultiArray(data=[0.0] * 101))[-1].is_branch


def test_a_whole_array_takes_the_place_of_what_was_typed_for_its_elements() -> None:
    form, _ = _filled(Float64MultiArray, data="[1, 2]")
    form.set("/data[1]", "5")
    assert list(form.message(NAMES).data) == [1.0, 5.0]
    form.set("/data", "[7, 8, 9]")
    assert list(form.message(NAMES).data) == [7.0, 8.0, 9.0]
    form.set("/data[2]", "1")
    form.set("/data", "[7]")
    assert list(form.message(NAMES).data) == [7.0] and form.problems == {}


def test_one_message_many_times_is_many_messages() -> None:
    form, _ = _filled(Float64MultiArray, layout__dim="[std_msgs.msg.MultiArrayDimension()] * 2")
    form.set("/layout/dim[0]/size", "4")
    assert [each.size for each in form.message(NAMES).layout.dim] == [4, 0]

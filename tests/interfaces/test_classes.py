"""What a student can do with message, service and action classes, beyond what the recording of real ones covers."""

from __future__ import annotations

import copy
import pickle
import subprocess
import sys
from array import array
from typing import Any

import pytest

from day6_core.interfaces import copy_message, get_message, registry, serialize, type_name
from day6_core.ros.environment import PYTHON_PATH


def run(code: str, **env: str) -> subprocess.CompletedProcess[str]:
    """Run a plain Python that has nothing but our ROS packages on its path."""
    command = [sys.executable, "-S", "-c", code]
    return subprocess.run(command, env={"PYTHONPATH": str(PYTHON_PATH), **env}, capture_output=True, text=True)


@pytest.mark.process
def test_a_plain_python_imports_a_message_without_the_rest() -> None:
    heavy = ["rclpy", "numpy", "yaml", "asyncio", "typing", "re", "dataclasses", "json", "textual", "threading"]
    done = run(
        "import sys; before = set(sys.modules)\n"
        "from std_msgs.msg import String; String(data='x')\n"
        f"print([name for name in {heavy!r} if name in set(sys.modules) - before])"
    )
    assert (done.stdout, done.stderr) == ("[]\n", "")


@pytest.mark.process
def test_numpy_comes_with_the_first_message_that_holds_a_fixed_array_not_with_its_class() -> None:
    pytest.importorskip("numpy")
    code = (
        "import sys; from action_msgs.msg import GoalStatus; print(GoalStatus.STATUS_SUCCEEDED, 'numpy' in sys.modules)\n"
        "GoalStatus(); print('numpy' in sys.modules)"
    )
    command = [sys.executable, "-c", code]
    done = subprocess.run(command, env={"PYTHONPATH": str(PYTHON_PATH)}, capture_output=True, text=True)
    assert (done.stdout, done.stderr) == ("4 False\nTrue\n", "")


@pytest.mark.process
def test_a_misspelt_name_gives_the_import_error_of_any_module() -> None:
    done = run("from std_msgs.msg import Strng")
    path = PYTHON_PATH / "std_msgs" / "msg" / "__init__.py"
    expected = f"ImportError: cannot import name 'Strng' from 'std_msgs.msg' ({path})"
    assert done.stderr.splitlines()[-1].startswith(expected)


def test_an_attribute_a_module_has_not_gives_the_error_of_any_module() -> None:
    import std_msgs.msg

    with pytest.raises(AttributeError, match=r"^module 'std_msgs\.msg' has no attribute 'strin'$"):
        _ = std_msgs.msg.strin


def test_star_import_and_completion_know_all_names() -> None:
    namespace: dict[str, Any] = {}
    exec("from std_srvs.srv import *", namespace)
    assert {"Empty", "SetBool", "SetBool_Request", "SetBool_Response", "SetBool_Event", "Trigger"} <= set(namespace)
    import std_msgs.msg

    assert {"String", "UInt8MultiArray", "Header"} <= set(dir(std_msgs.msg))


def test_the_module_of_one_message_can_be_imported() -> None:
    from std_msgs.msg import ColorRGBA
    from std_msgs.msg._color_rgba import ColorRGBA as Same
    from std_msgs.msg._color_rgba import Metaclass_ColorRGBA
    from std_srvs.srv._set_bool import SetBool_Request

    assert Same is ColorRGBA
    assert type(ColorRGBA) is Metaclass_ColorRGBA
    assert type_name(SetBool_Request) == "std_srvs/srv/SetBool_Request"
    with pytest.raises(ImportError, match="cannot import name 'String' from"):
        exec("from std_msgs.msg._color_rgba import String")
    with pytest.raises(ModuleNotFoundError, match=r"No module named 'std_msgs\.msg\._colour'"):
        __import__("std_msgs.msg._colour")


@pytest.mark.process
def test_a_pickled_message_is_read_in_another_process() -> None:
    from geometry_msgs.msg import PoseStamped

    message = PoseStamped()
    message.header.frame_id = "map"
    data = pickle.dumps(message)
    assert pickle.loads(data) == message
    done = run(f"import pickle; print(pickle.loads({data!r}))")
    assert (done.stdout, done.stderr) == (f"{message}\n", "")


def test_copy_shares_the_parts_and_deepcopy_does_not() -> None:
    from geometry_msgs.msg import Twist

    twist = Twist()
    assert copy.copy(twist).linear is twist.linear
    deep = copy.deepcopy(twist)
    assert deep == twist
    assert deep.linear is not twist.linear


def test_a_copied_message_shares_nothing_that_can_change() -> None:
    from sensor_msgs.msg import JointState
    from tf2_msgs.msg import TFMessage

    state = JointState(name=["a"], position=[1.0])
    copied = copy_message(state)
    state.name.append("b")
    state.position.append(2.0)
    state.header.stamp.sec = 5
    assert (copied.name, copied.position, copied.header.stamp.sec) == (["a"], array("d", [1.0]), 0)
    transforms = TFMessage(transforms=[get_message("geometry_msgs/msg/TransformStamped")()])
    copied = copy_message(transforms)
    transforms.transforms[0].transform.translation.x = 1.0
    assert copied.transforms[0].transform.translation.x == 0.0


def test_a_fixed_array_is_copied_too() -> None:
    pytest.importorskip("numpy")
    from nav_msgs.msg import Odometry

    odometry = Odometry()
    copied = copy_message(odometry)
    odometry.pose.covariance[3] = 1.0
    assert copied.pose.covariance.sum() == 0.0
    assert copied != odometry


def test_every_class_is_copied_equal_and_of_its_own_class() -> None:
    pytest.importorskip("numpy")
    for package in registry.packages():
        for name in registry.interface_names(package, "msg"):
            message = get_message(f"{package}/{name}")()
            copied = copy_message(message)
            assert type(copied) is type(message)
            assert copied == message


def test_a_derived_class_is_sent_as_the_message_it_is() -> None:
    from std_msgs.msg import String

    class Greeting(String):
        def __init__(self) -> None:
            super().__init__(data="hello")
            self.note = "stays here"

    assert type(copy_message(Greeting())) is String
    assert serialize(Greeting()) == serialize(String(data="hello"))
    assert type_name(Greeting) == "std_msgs/msg/String"


@pytest.mark.parametrize("wrong", [5, "text", None, object(), [], str])
def test_what_is_no_message_is_refused(wrong: Any) -> None:
    with pytest.raises(TypeError, match="is not the class of a message"):
        copy_message(wrong)
    with pytest.raises(TypeError, match="is not the class of a message"):
        serialize(wrong)
    with pytest.raises(TypeError, match="is not the class of a message"):
        type_name(wrong)


def test_defaults_of_one_message_are_not_those_of_another() -> None:
    from test_msgs.msg import UnboundedSequences

    first = UnboundedSequences()
    first.int32_values_default.append(7)
    first.string_values_default.append("x")
    second = UnboundedSequences()
    assert 7 not in second.int32_values_default
    assert "x" not in second.string_values_default


def test_constants_can_be_read_but_not_changed() -> None:
    from sensor_msgs.msg import JoyFeedback

    assert JoyFeedback.TYPE_BUZZER == JoyFeedback().TYPE_BUZZER == 2
    with pytest.raises(AttributeError):
        JoyFeedback.TYPE_BUZZER = 5
    with pytest.raises(AttributeError, match="'JoyFeedback' object attribute 'TYPE_BUZZER' is read-only"):
        JoyFeedback().TYPE_BUZZER = 5


def test_a_misspelt_field_is_an_error() -> None:
    from std_msgs.msg import String

    with pytest.raises(AttributeError, match="'String' object has no attribute 'dta'"):
        String().dta = "x"
    with pytest.raises(AssertionError, match=r"^Invalid arguments passed to constructor: dta, foo$"):
        String(foo=1, dta="x")
    assert String(dta="x", check_fields=False) == String()


def test_arguments_without_names_are_refused() -> None:
    from std_msgs.msg import String

    with pytest.raises(TypeError, match=r"takes 1 positional argument but 2 were given$"):
        String("x")
    with pytest.raises(TypeError, match=r"takes 1 positional argument but 2 were given$"):
        String("x", data="y")


def test_a_message_can_not_be_a_key() -> None:
    from std_msgs.msg import String

    with pytest.raises(TypeError, match="unhashable type: 'String'"):
        hash(String())


def test_numeric_arrays_take_what_array_and_numpy_take() -> None:
    """As in real ROS, where nothing is checked by itself; what they refuse is refused in the words of the checks."""
    import numpy
    from geometry_msgs.msg import PoseWithCovariance
    from sensor_msgs.msg import JointState
    from std_msgs.msg import Int32MultiArray

    state = JointState(position=[0, 1.5])
    assert state.position == array("d", [0.0, 1.5])
    for value in (
        (0, 1),
        range(2),
        numpy.array([0, 1]),
        numpy.linspace(0.0, 1.0, 2),
        (x for x in (0, 1)),
        array("f", [0, 1]),
    ):
        state.position = value
        assert state.position == array("d", [0.0, 1.0])
    pose = PoseWithCovariance()
    pose.covariance = [1] * 36
    assert pose.covariance.dtype == numpy.float64 and pose.covariance.sum() == 36
    for message, field, wrong in (
        (state, "position", "12"), (state, "position", [1.0, "2"]), (state, "position", 1.0), (state, "position", None),
        (Int32MultiArray(), "data", [1.5]), (Int32MultiArray(), "data", [2**40]), (pose, "covariance", [0.0] * 35),
    ):  # fmt: skip
        with pytest.raises(AssertionError, match=f"The '{field}' field must be a set or sequence"):
            setattr(message, field, wrong)
    with pytest.raises(AssertionError):
        JointState(check_fields=True).position = [0, 1.5]


@pytest.mark.process
def test_checks_are_on_unless_the_environment_says_otherwise() -> None:
    code = "from std_msgs.msg import Int32; m = Int32(); m.data = 1.5; print(m.data)"
    for env in ({}, {"ROS_PYTHON_CHECK_FIELDS": "1"}):
        assert "AssertionError: The 'data' field must be of type 'int'" in run(code, **env).stderr
    assert run(code, ROS_PYTHON_CHECK_FIELDS="0").stdout == "1.5\n"


def test_services_and_actions_can_not_be_made() -> None:
    from example_interfaces.action import Fibonacci
    from example_interfaces.srv import AddTwoInts

    with pytest.raises(NotImplementedError, match=r"^Service classes can not be instantiated$"):
        AddTwoInts()
    with pytest.raises(NotImplementedError, match=r"^Action classes can not be instantiated$"):
        Fibonacci()
    with pytest.raises(TypeError, match=r"takes 1 positional argument but 2 were given$"):
        AddTwoInts(5)


def test_an_action_has_the_parts_of_its_protocol() -> None:
    from example_interfaces.action import Fibonacci

    names = {name: type_name(getattr(Fibonacci.Impl, name)) for name in dir(Fibonacci.Impl) if name[0] != "_"}
    assert names == {
        "SendGoalService": "example_interfaces/action/Fibonacci_SendGoal",
        "GetResultService": "example_interfaces/action/Fibonacci_GetResult",
        "FeedbackMessage": "example_interfaces/action/Fibonacci_FeedbackMessage",
        "CancelGoalService": "action_msgs/srv/CancelGoal",
        "GoalStatusMessage": "action_msgs/msg/GoalStatusArray",
    }
    request = Fibonacci.Impl.SendGoalService.Request(goal=Fibonacci.Goal(order=5))
    assert request.goal.order == 5
    assert (Fibonacci.Impl.__module__, Fibonacci.Impl.__qualname__) == (Fibonacci.__module__, "Fibonacci.Impl")


def test_an_assigned_array_is_copied_as_in_real_ros_and_kept_where_fields_are_checked() -> None:
    from sensor_msgs.msg import CameraInfo, JointState

    mine = array("d", [1.0])
    state = JointState(position=mine)
    mine[0] = 2.0
    assert state.position == array("d", [1.0])
    state.position = mine
    mine[0] = 3.0
    assert state.position == array("d", [2.0])
    strict = JointState(check_fields=True)
    strict.position = mine
    assert strict.position is mine
    info = CameraInfo()
    own = info.r
    info.k = own
    own[0] = 5.0
    assert info.k[0] == 0.0

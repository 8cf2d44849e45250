import rclpy
from rclpy.node import Node
from rclpy.parameter import *
from rcl_interfaces.msg import *


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init()
n = Node("n")
t(
    lambda: n.declare_parameter(
        "i", 5, ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=2)], description="d")
    )
)
t(
    lambda: (
        n.declare_parameter(
            "i",
            4,
            ParameterDescriptor(integer_range=[IntegerRange(from_value=0, to_value=10, step=2)], description="d"),
        ).value
    )
)
t(
    lambda: (
        n.declare_parameter(
            "f",
            0.5,
            ParameterDescriptor(floating_point_range=[FloatingPointRange(from_value=0.0, to_value=1.0, step=0.25)]),
        ).value
    )
)
t(lambda: n.declare_parameter("ro", 1, ParameterDescriptor(read_only=True)).value)
t(lambda: n.declare_parameter("dyn", 1, ParameterDescriptor(dynamic_typing=True)).value)
for name, v in (
    ("i", 6),
    ("i", 7),
    ("i", 12),
    ("i", 10),
    ("i", "x"),
    ("i", 1.0),
    ("f", 0.75),
    ("f", 0.6),
    ("f", 2.0),
    ("f", 1),
    ("ro", 2),
    ("dyn", "s"),
    ("dyn", None),
    ("nope", 1),
):
    t(lambda: n.set_parameters([Parameter(name, value=v)]))
t(lambda: n.set_parameters_atomically([Parameter("i", value=2), Parameter("f", value=5.0)]))
print(n.get_parameter("i").value)
t(lambda: n.set_parameters([5]))
t(lambda: n.set_parameters_atomically([]))
t(lambda: n.describe_parameter("i"))
t(lambda: n.describe_parameters(["f", "zz"]))
t(lambda: n.get_parameter_types(["i", "f"]))
t(lambda: n.get_parameters(["i", "zz"]))
t(lambda: n.get_parameter_type("zz"))
t(lambda: n.get_parameters([5]))
t(lambda: n.get_parameter_or("zz").type_)
t(lambda: n.get_parameter_or("zz", Parameter("zz", value=3)).value)
t(lambda: n.undeclare_parameter("ro"))
t(lambda: n.undeclare_parameter("zz"))
t(lambda: n.undeclare_parameter("i"))
print(n.has_parameter("i"))
t(lambda: n.list_parameters([], 0))
n.declare_parameters("a", [("b.c", 1), ("b.d", 2), ("e", 3)])
for pre, d in ((["a"], 0), (["a.b"], 1), ([], 1), ([], 2), (["a"], 1), (["x"], 0)):
    t(lambda: n.list_parameters(pre, d))
t(lambda: n.list_parameters("a", 0))
t(lambda: n.list_parameters([], -1))
t(lambda: n.declare_parameters("", [("q",)]))
t(lambda: n.declare_parameters("", [()]))
t(lambda: n.declare_parameters("", [("r", 1, ParameterDescriptor(), 4)]))
t(lambda: n.declare_parameter("s", Parameter.Type.NOT_SET))
t(lambda: n.declare_parameter("u", Parameter.Type.STRING, ParameterDescriptor(dynamic_typing=True)))
t(lambda: n.declare_parameter("v", None, ParameterDescriptor()))
t(lambda: n.declare_parameter("v", None, ParameterDescriptor(dynamic_typing=True)).value)
t(lambda: Parameter("x", Parameter.Type.INTEGER, "s"))
t(lambda: Parameter("x", 5, "s"))
t(lambda: Parameter("x", value=object))
t(lambda: Parameter("x").type_)
t(lambda: Parameter())
t(lambda: Parameter("x", Parameter.Type.BYTE_ARRAY, [b"a", b"bc"]))
t(lambda: Parameter("x", Parameter.Type.DOUBLE_ARRAY, [1, 2.0]))
t(lambda: Parameter("x", value=True).to_parameter_msg())
for s in ("1", "1.5", "true", "[1,2]", "[a,b]", "[1,a]", "x", "", "{a: 1}", "null", "[1.0,2]", "1e3", '"5"', "[true]"):
    t(lambda: get_parameter_value(s))
t(lambda: parameter_value_to_python(ParameterValue(type=9, string_array_value=["a"])))
t(lambda: parameter_value_to_python(ParameterValue(type=77)))
log = []


def pre(ps):
    log.append(("pre", [p.name for p in ps]))
    return ps + [Parameter("extra", value=1)] if ps and ps[0].name == "dyn2" else ps


def on(ps):
    log.append(("on", [(p.name, p.value) for p in ps]))
    return SetParametersResult(successful=all(p.value != 13 for p in ps), reason="unlucky")


def on2(ps):
    log.append("on2")
    return SetParametersResult(successful=True)


def post(ps):
    log.append(("post", [p.name for p in ps]))


n.add_pre_set_parameters_callback(pre)
n.add_on_set_parameters_callback(on)
n.add_on_set_parameters_callback(on2)
n.add_post_set_parameters_callback(post)
t(lambda: n.declare_parameter("dyn2", 1).value)
t(lambda: n.declare_parameter("extra", 1).value)
t(lambda: n.declare_parameter("bad", 13))
t(lambda: n.set_parameters([Parameter("dyn2", value=3)]))
t(lambda: n.set_parameters([Parameter("extra", value=13)]))
print(log)
print(n.get_parameter("extra").value, n.has_parameter("bad"))
n.remove_on_set_parameters_callback(on)
t(lambda: n.remove_on_set_parameters_callback(on))
t(lambda: n.add_on_set_parameters_callback(5))
t(lambda: n.add_post_set_parameters_callback(None))
n.remove_pre_set_parameters_callback(pre)
n.add_pre_set_parameters_callback(lambda ps: [])
t(lambda: n.set_parameters([Parameter("extra", value=2)]))
t(
    lambda: n.set_descriptor(
        "f", ParameterDescriptor(type=3, floating_point_range=[FloatingPointRange(from_value=0.0, to_value=0.5)])
    )
)
t(
    lambda: n.set_descriptor(
        "f",
        ParameterDescriptor(type=3, floating_point_range=[FloatingPointRange(from_value=0.0, to_value=0.5)]),
        ParameterValue(type=3, double_value=0.1),
    )
)
t(lambda: n.get_parameter("f").value)
t(lambda: n.set_descriptor("zz", ParameterDescriptor()))
print(sorted(n._parameters))
t(lambda: n.declare_parameter("use_sim_time", True))
t(lambda: n.set_parameters([Parameter("start_type_description_service", value=False)]))
t(lambda: n.describe_parameter("start_type_description_service"))
t(lambda: n.describe_parameter("use_sim_time"))
rclpy.shutdown()

import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init(
    args=[
        "x",
        "--ros-args",
        "-r",
        "c:=d",
        "-r",
        "~/p:=q",
        "-r",
        "/abs:=rel",
        "-r",
        "n:only:=yes",
        "-r",
        "s:=t",
        "-r",
        "rosservice://u:=w",
    ]
)
n = Node("n", namespace="/z")
m = Node("m")
for k in (n, m):
    for name in ("c", "~/p", "/abs", "only", "/c", "z/c", "u"):
        print(
            k.get_name(),
            name,
            k.resolve_topic_name(name),
            k.resolve_service_name(name),
            k.resolve_topic_name(name, only_expand=True),
        )
print(
    n.create_service(Trigger, "s", print).service_name,
    n.create_client(Trigger, "u").service_name,
    n.create_publisher(String, "u", 1).topic_name,
)
k = Node("k", cli_args=["--ros-args", "-r", "c:=own", "-p", "v:=3", "-r", "__ns:=/kk"])
print(k.resolve_topic_name("c"), k.get_fully_qualified_name())
k.declare_parameter("v", 1)
print(k.get_parameter("v").value)
k2 = Node("k2", use_global_arguments=False)
print(k2.resolve_topic_name("c"))
k3 = Node("k3", namespace="a/b")
print(k3.get_namespace())
rclpy.shutdown()

import rclpy
from rclpy.node import Node
from std_srvs.srv import SetBool
from std_msgs.msg import String

rclpy.init()
n = Node("a", namespace="/lab")


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__name__, "|", e)


for name in ("~x", "~", "~/x", "a~", "a/", "", "/", "x" * 300, "{node}", "{node", "a}", "1", "_x", "a__b"):
    t(lambda: n.create_service(SetBool, name, print).service_name)
    t(lambda: n.create_client(SetBool, name).service_name)
    t(lambda: n.resolve_service_name(name))
    t(lambda: n.resolve_topic_name(name))

import rclpy, time, threading
from rclpy.node import Node
from std_msgs.msg import String, Int32
from std_srvs.srv import SetBool, Trigger


def t(f):
    try:
        print("OK", repr(f()))
    except BaseException as e:
        print(type(e).__module__ + "." + type(e).__qualname__, "|", e)


rclpy.init()
n = Node("n", namespace="/x")
m = Node("m")
p = n.create_publisher(String, "c", 10)
s = m.create_subscription(String, "/x/c", print, 10)
v = m.create_service(Trigger, "/x/s", print)
c = n.create_client(Trigger, "s")
time.sleep(0.5)
print(
    n.count_publishers("c"),
    n.count_subscribers("c"),
    n.count_clients("s"),
    n.count_services("s"),
    m.count_publishers("c"),
)
print(n.get_publisher_names_and_types_by_node("n", "/x"))
print(n.get_subscriber_names_and_types_by_node("m", "/"))
print(n.get_client_names_and_types_by_node("n", "/x"))
print(sorted(n.get_fully_qualified_node_names()))
print([x for x in n.get_service_names_and_types() if x[0] == "/x/s"])
print(n.get_topic_names_and_types(no_demangle=True))
print(n.get_topic_names_and_types(True)[0])
print(n.get_publisher_names_and_types_by_node("n", "/x", no_demangle=True))
t(lambda: n.get_publishers_info_by_topic("rt/x/c", no_mangle=True)[0].topic_type)
t(lambda: n.get_publishers_info_by_topic("/x/c", no_mangle=True))
from rclpy.topic_endpoint_info import *

t(lambda: str(TopicEndpointInfo()))
t(lambda: TopicEndpointInfo(node_name=5))
t(lambda: TopicEndpointInfo() == TopicEndpointInfo())
i = n.get_subscriptions_info_by_topic("c")[0]
print(i.endpoint_type, len(i.endpoint_gid), i.topic_type_hash.version)
print(p.topic_name, p.topic, c.service_name, c.srv_name, v.service_name, p.logger_name, s.logger_name, c.logger_name)
rclpy.shutdown()

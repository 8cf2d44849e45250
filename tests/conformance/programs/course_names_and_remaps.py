"""Good and bad names."""

import rclpy
from rclpy.exceptions import InvalidNamespaceException, InvalidNodeNameException, InvalidTopicNameException
from rclpy.expand_topic_name import expand_topic_name
from rclpy.validate_full_topic_name import validate_full_topic_name
from rclpy.validate_namespace import validate_namespace
from rclpy.validate_node_name import validate_node_name
from rclpy.validate_topic_name import validate_topic_name

for topic in ("chatter", "/abs", "~/private", "{node}/x", "a/b"):
    print(topic, "->", expand_topic_name(topic, "node", "/ns"))
for check, name in (
    (validate_topic_name, "two words"),
    (validate_topic_name, "9lives"),
    (validate_topic_name, "a//b"),
    (validate_topic_name, ""),
    (validate_topic_name, "ends/"),
    (validate_topic_name, "ok_name"),
    (validate_node_name, "my-node"),
    (validate_node_name, ""),
    (validate_node_name, "fine"),
    (validate_namespace, "relative"),
    (validate_namespace, "/good/one"),
    (validate_namespace, "/bad ns"),
    (validate_full_topic_name, "chatter"),
    (validate_full_topic_name, "/fine"),
):
    try:
        print(check.__name__, repr(name), check(name))
    except Exception as error:
        print(check.__name__, repr(name), type(error).__name__, error)
rclpy.init()
for name, namespace in (("bad name", ""), ("good", "/bad ns"), ("good", "team")):
    try:
        print(rclpy.create_node(name, namespace=namespace).get_fully_qualified_name())
    except (InvalidNodeNameException, InvalidNamespaceException) as error:
        print(type(error).__name__, error)
try:
    rclpy.create_node("n").create_publisher(__import__("std_msgs.msg").msg.Empty, "no spaces please", 1)
except InvalidTopicNameException as error:
    print(error)
rclpy.shutdown()

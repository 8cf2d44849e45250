"""A subscription that wants only some messages."""

import rclpy
from rclpy.subscription_content_filter_options import ContentFilterOptions
from test_msgs.msg import BasicTypes

rclpy.init()
node = rclpy.create_node("picky")
publisher = node.create_publisher(BasicTypes, "numbers", 20)
got = []


def listen(expression, *parameters):
    got.clear()
    options = ContentFilterOptions(expression, list(parameters))
    subscription = node.create_subscription(
        BasicTypes, "numbers", lambda m: got.append(m.int32_value), 20, content_filter_options=options
    )
    while publisher.get_subscription_count() == 0:
        rclpy.spin_once(node, timeout_sec=0.01)
    for value in range(-2, 6):
        publisher.publish(BasicTypes(int32_value=value, bool_value=value % 2 == 0, float64_value=value / 2))
    for _ in range(30):
        rclpy.spin_once(node, timeout_sec=0.01)
    print(expression, parameters, got, subscription.is_cft_enabled)
    node.destroy_subscription(subscription)
    while publisher.get_subscription_count():
        rclpy.spin_once(node, timeout_sec=0.01)


listen("int32_value > %0", "2")
listen("int32_value >= %0 AND int32_value < %1", "0", "3")
listen("bool_value = TRUE")
listen("NOT (int32_value = 1 OR int32_value = 2)")
listen("float64_value BETWEEN 0.5 AND 1.5")
listen("int32_value <> 0")
rclpy.shutdown()

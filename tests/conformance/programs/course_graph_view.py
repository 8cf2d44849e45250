"""Who is there: names, types, counts, endpoint details."""

import rclpy
from geometry_msgs.msg import Twist
from std_srvs.srv import Empty

rclpy.init()
driver = rclpy.create_node("driver", namespace="/car")
joystick = rclpy.create_node("joystick")
driver.create_subscription(Twist, "/cmd_vel", lambda m: None, 10)
joystick.create_publisher(Twist, "/cmd_vel", 5)
driver.create_service(Empty, "stop", lambda q, r: r)
joystick.create_client(Empty, "/car/stop")
while driver.count_publishers("/cmd_vel") == 0 or joystick.count_clients("/car/stop") == 0:
    rclpy.spin_once(driver, timeout_sec=0.05)
print(sorted(joystick.get_node_names_and_namespaces()))
print(sorted(n for n in joystick.get_node_names()))
print([t for t in joystick.get_topic_names_and_types() if "cmd_vel" in t[0]])
print([s for s in joystick.get_service_names_and_types() if s[0].endswith("stop")])
print(
    joystick.count_publishers("/cmd_vel"), joystick.count_subscribers("/cmd_vel"), joystick.count_services("/car/stop")
)
print([t for t in joystick.get_subscriber_names_and_types_by_node("driver", "/car") if "cmd" in t[0]])
print([t for t in driver.get_publisher_names_and_types_by_node("joystick", "/") if "cmd" in t[0]])
for info in joystick.get_publishers_info_by_topic("/cmd_vel") + joystick.get_subscriptions_info_by_topic("/cmd_vel"):
    print(
        info.node_name,
        info.node_namespace,
        info.topic_type,
        info.endpoint_type,
        info.qos_profile.reliability.name,
        str(info.topic_type_hash),
        len(info.endpoint_gid),
    )
try:
    joystick.get_publisher_names_and_types_by_node("ghost", "/")
except Exception as error:
    print(type(error).__name__, error)
rclpy.shutdown()

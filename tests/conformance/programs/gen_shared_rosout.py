"""Two nodes of one name in one process log through one publisher, which belongs to the first."""
import rclpy
from rclpy.node import Node

rclpy.init()
first = Node('twin')
print(first.count_publishers('/rosout'))
second = Node('twin')
print(first.count_publishers('/rosout'), [each.node_name for each in first.get_publishers_info_by_topic('/rosout')])
print(second.get_publisher_names_and_types_by_node('twin', '/'))
first.destroy_node()
print(second.count_publishers('/rosout'))
second.get_logger().info('only on the terminal')
other = Node('twin', namespace='lab')
print(other.count_publishers('/rosout'))
rclpy.shutdown()

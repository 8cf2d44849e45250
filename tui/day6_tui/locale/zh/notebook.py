"""Notebooks."""

TEXTS = {
    "notebook.here": "ROS 2 已经就绪：可以 import rclpy，也可以用 %ros2 topic list。单元格运行完以后，节点会继续运行。",
    "notebook.init_again": "ROS 已经初始化过了，这次 rclpy.init() 什么都不做。rclpy.shutdown() 会结束 ROS。",
    "notebook.again": "{name}：之前在这里创建的节点已经销毁",
    "notebook.goes_on": "{name} 在后台继续运行；用 {end} 结束",
    "notebook.go_on": "{names} 在后台继续运行；destroy_node() 结束其中一个，rclpy.shutdown() 结束全部",
    "notebook.failed": "出了上面的错误，{name} 不再执行回调（如果是程序，到这里就结束了）。改好以后，重新运行创建节点的单元格。",
    "notebook.ended": "{name} 不再执行回调：有一个回调调用了 exit，程序到这里就会结束",
    "notebook.stuck": (
        "{name}：有一个回调 {seconds} 秒还没有返回{where}。在它返回之前，这个节点的其他回调都不会执行。"
        "destroy_node() 可以结束它。"
    ),
    "notebook.ros2.background": "在后台继续运行，直到内核结束；现在就结束：{end}",
}

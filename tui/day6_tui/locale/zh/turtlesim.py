"""Turtlesim."""

TEXTS = {
    "turtlesim.pose": "x {x:.2f}  y {y:.2f}  θ {theta:.2f}  v {v:.1f}",
    "turtlesim.none": "没有海龟",
    "turtlesim.more": "还有 {count} 只",
    "turtlesim.from": "来自",
    "turtlesim.undriven": "还没有节点发布；想开动它：",
    "turtlesim.label": "名字",
    "help.turtlesim": (
        "turtlesim 的世界，边长 11.09 米。节点 /turtlesim 订阅 /turtle1/cmd_vel 上的速度命令，"
        "并把海龟的位置发布到 /turtle1/pose。\n\n"
        "想驾驶它，就在一个终端里运行 ros2 run turtlesim turtle_teleop_key，并且让键盘留在那个终端里："
        "方向键只在运行它的终端里有用。\n\n"
        "在 turtlesim_node 的终端里按 Ctrl-C，这个窗口就会关闭。"
    ),
}

"""The world."""

TEXTS = {
    "world.factor": "RTF {factor:.2f}",
    "world.pose": "x {x:.2f}  y {y:.2f}  {degrees}°  v {v:.2f} m/s",
    "world.line": "巡线",
    "world.zoom": "缩放",
    "world.follow": "跟随",
    "world.lidar": "激光雷达",
    "world.step": "一步",
    "world.reset": "回到起点",
    "help.world": (
        "一个有物理规律的小世界，正式课程里用的是 Gazebo。轮子贴着地面，一转，车就往前走："
        "/cmd_vel 或 /joint_commands 让轮子转。/odom 报告按轮子算出来的位置，/scan 和 /line_sensor 是它的眼睛。\n\n"
        "想进来，每个 link 都要有 <inertial>；没有 <collision> 的部分会穿墙。\n\n"
        "+ 和 - 缩放，方向键移动画面，f 跟着车，0 看全图。l 显示激光雷达，t 擦掉轨迹。空格暂停，n 走一步，"
        "[ 和 ] 让时间变慢变快，r 回到起点。RTF 是实时系数，和 Gazebo 里的一样：你的手表走一秒，这里走了几秒。"
    ),
}

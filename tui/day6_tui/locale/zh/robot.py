"""The car from above, and the joint sliders."""

TEXTS = {
    # the car
    "car.zoom": "缩放",
    "car.letters": "ASCII 字符",
    # joint sliders
    "sliders.waiting": "正在等 /robot_description 上的机器人：robot_state_publisher 在运行吗？",
    "sliders.none": "这个机器人没有可以动的关节。",
    "sliders.conflict.short": "{nodes} 也在发布关节角度，会抖动",
    "sliders.conflict": "{nodes} 也在发布这些关节：两边各说各的，机器人就会抖动。同一时刻只留一个发布者。",
    "sliders.degrees": "角度制",
    "sliders.move": "拖动",
    "sliders.finest": "最细的一步",
    "sliders.value": "输入数值",
    "sliders.zero": "归零",
    "sliders.accept": "确定",
    "sliders.cancel": "取消",
    "help.car": (
        "从上往下看你的机器人，按它的 URDF 画出来。轮子按 /joint_states 和 /tf 转动：没有人发布，就没有东西转。"
        "在这幅图里小车不会走开；轮子转了车也不动，和 RViz 里一样。\n\n"
        "+ 和 - 放大缩小，方向键移动画面，0 看全图，b 换成只用 ASCII 字符画。"
    ),
    "help.joint_state_publisher": (
        "每个能动的关节一个滑块。你在这里设的角度，每秒十次发到 /joint_states；"
        "robot_state_publisher 再把它变成各个 link 的位置。\n\n"
        "↑ ↓ 选关节，← → 拖动，按住 Shift 一次十步，按住 Ctrl 最细，Home、End 到极限，z 回到零位。按数字键、Enter，"
        "或者点一下数值，就可以输入准确的值。r 是 Randomize（随机），c 是 Center（居中），d 在弧度和角度之间切换。"
        "也可以用鼠标拖。\n\n"
        "如果还有别的节点发布同样的关节，机器人就会抖动：两边都在下命令，谁最后说就听谁的。"
    ),
}

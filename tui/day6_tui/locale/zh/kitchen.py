"""The kitchen."""

TEXTS = {
    "action.kitchen": "厨房：把计算图看成厨师、传送带和菜",
    "help.action.kitchen": "把正在运行的计算图画成厨房，有消息经过时菜就移动；再选一次就关掉",
    "kitchen.title": "厨房",
    "kitchen.count": "厨师 {cooks} 位，传送带 {belts} 条",
    "kitchen.hidden": "，已隐藏 {count} 个",
    "kitchen.trouble": "有 {count} 条送不到",
    "kitchen.belts": "传送带",
    "kitchen.cooks": "厨师",
    "kitchen.explain": "解释",
    "kitchen.show_hidden": "显示隐藏的",
    "kitchen.hide": "重新隐藏",
    "kitchen.scroll": "滚动",
    "kitchen.leave": "取消选择",
    "kitchen.empty": "厨房里没有人：现在没有节点在运行。\n在终端里请来一位厨师，比如\nros2 run turtlesim turtlesim_node",
    "kitchen.space": "",
    "kitchen.nobody": "（没有人）",
    "kitchen.unseen": "隐藏的 {count} 个",
    "kitchen.note.type": "盘子不对",
    "kitchen.note.qos": "QoS 不合",
    "kitchen.note.unheard": "没人取",
    "kitchen.note.unfilled": "没人放",
    "kitchen.note.left": "{note}，剩 {count} 盘",
    "kitchen.more_cooks": "还有 {count} 位",
    "kitchen.more_belts": "还有 {count} 条",
    "kitchen.cook": "{name} 是一位厨师。",
    "kitchen.cook.gives": "往 {belts} 上放菜。",
    "kitchen.cook.takes": "从 {belts} 上取菜。",
    "kitchen.cook.idle": "没有站在画出来的任何一条传送带旁边。",
    "kitchen.cook.twins": "有 {count} 位厨师都叫这个名字，谁也分不清他们！",
    "kitchen.cook.ros": "ROS：节点 {name} 发布其中 {gives} 个话题，订阅 {takes} 个。",
    "kitchen.belt.moves": "传送带 {belt} 把 {shape} 从 {givers} 送到 {takers}。",
    "kitchen.belt.unheard": "{givers} 往传送带 {belt} 上放 {shape}，但没有人取：菜都堆在尽头。",
    "kitchen.belt.unfilled": "{takers} 在传送带 {belt} 旁边等 {shape}，但没有人往上放。",
    "kitchen.belt.type": "{giver} 往传送带 {belt} 上放的是 {shape}，而 {taker} 的窗口只进得去 {wanted}：一盘也拿不到。",
    "kitchen.belt.qos": "{giver} 往传送带 {belt} 上放 {shape}，但 {taker} 的取菜规矩和它对不上，一盘也拿不到。",
    "kitchen.belt.ros": "ROS：话题 {belt}，消息类型 {type}，发布者 {givers}，订阅者 {takers}。",
    "kitchen.belt.type.ros": "ROS：在 {belt} 上，{giver} 发布 {sent}，{taker} 订阅 {detail}；类型必须一样。",
    "kitchen.belt.qos.ros": "ROS：在 {belt} 上，{giver} 的 QoS 满足不了 {taker}：{detail}。",
    "kitchen.belt.rate": "实测每秒 {rate} 条。",
    "kitchen.belt.still": "现在没有消息经过。",
    "kitchen.belt.unknown": "在这里数不出有多少条。",
    "help.kitchen": (
        "正在运行的计算图，画成一间厨房。厨师是节点，传送带是话题，菜是消息。菜的样子就是消息类型：类型相同，形状、字母、颜色就相同。"
        "窗口形状不同的厨师拿不到菜，那条传送带会被标出来。\n\n"
        "形状：( ) 盘子，装命令（Twist）；{ } 碗，装文字（String）；[ ] 盒子，装数字（Int32、Float64）；"
        "< > 罩子，盖着位置（Pose、TFMessage）；# # 画框，装看到的东西（Image、Color）；\\ / 杯子，装量出来的东西"
        "（JointState、LaserScan）；= = 包裹，其他的都在这里。\n\n"
        "真的有消息经过，菜才会动。消息很多时只画出其中几盘；类型旁边的数字是实测的频率。?/s 表示：在这里数不出来。"
        "没人取的菜堆在传送带的尽头，旁边的数目从打开厨房的时候数起。\n\n"
        "■ 放菜，► 取菜，× 取不了；传送带从别的厨师的台子下面穿过去。点线表示空的传送带：没有人往上放。\n\n"
        "/rosout、/parameter_events 和隐藏的节点不画，按 h 可以显示。点一下厨师或传送带，下面会解释。"
        "厨房自己什么也不订阅，也不在画里。"
    ),
}

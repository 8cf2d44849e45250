"""中文文字。"""

TEXTS = {
    # actions
    "action.terminal": "终端",
    "action.next": "下一个",
    "action.previous": "上一个",
    "action.windows": "窗口",
    "action.enlarge": "放大",
    "action.pause": "暂停",
    "action.resume": "继续",
    "action.palette": "命令",
    "action.quit": "退出",
    "action.help": "帮助",
    "action.scene.turtle": "驾驶小海龟",
    "action.scene.car": "让小车的轮子转起来",
    "action.close": "关闭这个终端或窗口",
    "action.copy": "复制选中的文字",
    "action.paste": "粘贴",
    "action.clear": "清除终端的历史画面",
    "action.language": "English / 中文",
    "action.theme": "深色或浅色",
    "action.glyphs": "换一套绘图字符（half、braille、cell、ascii）",
    "action.grow": "窗口大一点",
    "action.shrink": "窗口小一点",
    "action.step": "时间走一步（暂停时）",
    "action.faster": "时间快一点",
    "action.slower": "时间慢一点",
    "action.normal": "时间恢复正常",
    "action.motion": "减少动画：开或关",
    "help.action.terminal": "再开一个终端，它有自己的 shell",
    "help.action.next": "把键盘交给下一个终端或窗口",
    "help.action.previous": "同上，往回",
    "help.action.windows": "列出所有打开的东西",
    "help.action.enlarge": "把当前窗格放大到整个屏幕，再按一次还原",
    "help.action.pause": "让仿真世界停住，再按一次继续",
    "help.action.palette": "按名字查找所有命令",
    "help.action.quit": "结束所有程序，关闭桌面",
    "help.action.help": "解释当前的窗格",
    "help.action.scene.turtle": "替你输入小海龟课的两条命令",
    "help.action.scene.car": "替你输入显示小车、转动轮子的命令",
    "help.action.close": "结束 shell，或结束打开窗口的程序",
    "help.action.copy": "复制用鼠标选中的文字",
    "help.action.paste": "输入刚才复制的文字",
    "help.action.clear": "忘掉已经滚上去的内容",
    "help.action.language": "切换桌面语言",
    "help.action.theme": "切换配色",
    "help.action.glyphs": "改变图像的画法",
    "help.action.grow": "给窗口更多地方",
    "help.action.shrink": "给终端更多地方",
    "help.action.step": "暂停时让世界走一个 turtlesim 节拍（16 毫秒）",
    "help.action.faster": "最快十倍",
    "help.action.slower": "最慢十分之一",
    "help.action.normal": "一秒就是一秒",
    "help.action.motion": "没有打字效果，也没有光点",
    # bars
    "bar.desk": "桌面",
    "bar.turtle": "海龟",
    "bar.car": "小车",
    "bar.nodes": "节点 {count}",
    "bar.topics": "话题 {count}",
    "bar.paused": "已暂停",
    "bar.language": "EN",
    "bar.help": "F1 帮助",
    "bar.starting": "正在启动……",
    "bar.playing": "正在替你输入…… 按 Esc 停下",
    "bar.external": "学生进程仍按正常速度运行",
    # terminal
    "terminal.hint": "方向键只在这个终端里有用：点一下这里，或按 {key}",
    "terminal.scrolled": "下面还有 {count} 行 · 按任意键回到底部",
    "terminal.copied": "已复制",
    "terminal.ended": "shell 已结束",
    "terminal.number": "终端 {number}",
    # welcome
    "welcome.title": "欢迎",
    "welcome.heading": "ROS 2，就在你的终端里",
    "welcome.question": "你想做什么？",
    "welcome.turtle": "驾驶小海龟",
    "welcome.turtle.more": "turtlesim 和键盘遥控",
    "welcome.car": "让小车的轮子转起来",
    "welcome.car.more": "URDF 机器人和 /joint_states",
    "welcome.empty": "空桌面",
    "welcome.empty.more": "只有一个终端",
    "welcome.keys": "↑ ↓ 选择   Enter 确定   也可以按数字",
    "welcome.truth": "命令会一个字一个字地替你输入，你都看得见，它们就是真正的命令。",
    # guide
    "guide.title": "桌面",
    "guide.heading": "现在没有窗口。窗口由命令打开：",
    "guide.try": "按 Enter 或点一下，就会输入到终端里，由你来运行",
    "guide.ask": "看看现在发生了什么：",
    "guide.scene": "或者看我做一遍：",
    # turtlesim
    "turtlesim.pose": "x {x:.2f}  y {y:.2f}  θ {theta:.2f}  v {v:.1f}",
    "turtlesim.none": "没有海龟",
    "turtlesim.more": "还有 {count} 只",
    "turtlesim.label": "名字",
    # car
    "car.lines": "线条",
    "car.waiting_for_description": "还没有人发布 /robot_description：robot_state_publisher 在运行吗？",
    "car.loading": "正在读机器人描述",
    "car.bad_description": "机器人描述有错：{text}",
    "car.no_wheels": "这个机器人没有轮子：没有绕水平轴转动的东西",
    "car.no_joint_states": "没有人发布 {topic}：轮子不会转",
    "car.wrong_type": "{topic} 的类型是 {type}，应该是 sensor_msgs/msg/JointState",
    "car.unknown_joint": "URDF 里没有关节 {joint}",
    "car.unknown_joint_near": "URDF 里没有关节 {joint}，是不是想写 {nearest}？",
    "car.no_transform": "没有从 {link} 到 {frame} 的坐标变换",
    "car.no_transform_more": "还有 {count} 个 link 没有到 {frame} 的坐标变换",
    "car.many_publishers": "{topic} 上有 {count} 个发布者：{nodes}",
    "car.slow": "{topic} 每秒只来 {rate} 次：眼睛需要大约 20 次",
    "car.silent": "{topic} 已经 {seconds} 秒没有消息",
    # rqt_graph
    "rqt.hidden": "藏起了 {count} 个：",
    "rqt.hides": "{option} 藏起 {names}",
    "rqt.separator": "；",
    "rqt.nothing_hidden": "没有藏起任何东西",
    "rqt.empty": "现在没有节点在发布或订阅。",
    "rqt.type": "类型",
    "rqt.hide": "隐藏",
    "rqt.refresh": "刷新",
    # topics
    "topics.columns.topic": "话题",
    "topics.columns.rate": "频率",
    "topics.columns.bandwidth": "带宽",
    "topics.none": "还没有话题。先启动一个节点吧。",
    "topics.type": "类型",
    "topics.publishers": "发布者",
    "topics.subscriptions": "订阅者",
    "topics.last": "最新消息",
    "topics.quiet": "没有在听：按 Enter 开始听",
    "topics.waiting": "正在听，还没有消息",
    "topics.listen": "听",
    "topics.stop": "不听",
    # menus
    "menu.palette": "命令",
    "menu.windows": "窗口和终端",
    "menu.filter": "输入文字来查找",
    "menu.none": "没有这个名字",
    "menu.keys": "↑ ↓ 选择   Enter 确定   Esc 返回",
    "menu.keys.close": "↑ ↓ 选择   Enter 确定   Del 关闭   Esc 返回",
    "menu.terminal": "终端",
    "menu.window": "窗口",
    # help
    "help.title": "帮助",
    "help.keys": "↑ ↓ 滚动   Esc 返回",
    "help.everywhere": "到处都能用的按键",
    "help.desk": (
        "这是一台装了 ROS 2 的小 Ubuntu 电脑的桌面。桌面上有终端，你在里面输入命令；还有程序打开的窗口。\n\n"
        "这里发生的每一件事都来自一条命令。在这里学会的，到真正的 Ubuntu 上一样能用。"
    ),
    "help.terminal": (
        "这是终端：输入一条命令，按 Enter 运行。\n\n"
        "Tab 补全，↑ 找回以前的命令，Ctrl-R 搜索历史。Ctrl-C 结束正在运行的程序，在空行上按 Ctrl-D 结束 shell。"
        "Ctrl-Z 再输入 bg 让程序到后台去；命令末尾写 & 也一样。\n\n"
        "Shift+PageUp 或鼠标滚轮可以往回看。用鼠标拖选就会复制；Shift+Insert 或鼠标中键粘贴。"
    ),
    "help.turtlesim": (
        "turtlesim 的世界，边长 11.09 米。节点 /turtlesim 在 /turtle1/cmd_vel 上听速度命令，"
        "在 /turtle1/pose 上说出海龟的位置。\n\n"
        "想驾驶它，在一个终端里运行 ros2 run turtlesim turtle_teleop_key，并且让键盘留在那里：方向键只在运行它的终端里有用。\n\n"
        "在 turtlesim_node 的终端里按 Ctrl-C，这个窗口就会关闭。"
    ),
    "help.car": (
        "从上往下看你的机器人，按它的 URDF 画出来。轮子按 /joint_states 和 /tf 转动：没有人发布，就没有东西转。"
        "在这幅图里小车不会走开；轮子转了车也不动，和 RViz 里一样。"
    ),
    "help.rqt_graph": (
        "谁在和谁说话。椭圆是节点，箭头是话题。有消息经过时，一个光点会沿着箭头跑。最下面一行说明过滤器藏起了什么。"
    ),
    "help.topics": (
        "所有的话题：类型、几个发布者、几个订阅者。按 Enter 开始听选中的话题，测量它的频率和带宽，下面显示最新的一条消息。"
        "听就是订阅，所以订阅者会多一个。"
    ),
    "help.welcome": "用方向键和 Enter 选择，也可以按数字或点鼠标。前两项会像老师一样，把命令一条一条地输入到终端里。",
    # errors
    "error.home": "主目录 {path} 不能用：{reason}",
    "error.window": "这个窗口画不出来：{reason}",
    "error.desk": "仿真电脑启动不了：{reason}",
    "error.small": "太小了",
    "error.continue": "按 Esc 关闭这条消息",
    "error.title": "出错了",
}

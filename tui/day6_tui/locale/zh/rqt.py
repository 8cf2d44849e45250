"""rqt and its plugins, and the fields of messages in some of them."""

TEXTS = {
    # topics
    "topics.columns.topic": "话题",
    "topics.columns.type": "类型",
    "topics.columns.bandwidth": "带宽",
    "topics.columns.hz": "Hz",
    "topics.columns.value": "值",
    "topics.none": "还没有话题。先启动一个节点吧。",
    "topics.no_match": "没有符合的话题。按 Esc 显示全部。",
    "topics.publishers": "发布者",
    "topics.subscriptions": "订阅者",
    "topics.history": "最近的频率",
    "topics.quiet": "没有在听",
    "topics.waiting": "还没有消息",
    "topics.listen": "听",
    "topics.stop": "不听",
    "topics.open": "展开",
    "topics.sort": "排序",
    "topics.reverse": "反过来排",
    "topics.filter": "过滤",
    "topics.view": "看全部",
    "topics.filter_note": "写话题名或类型的一部分；什么都不写就显示全部。",
    "topics.filtered": "共 {count} 个，过滤：{text}",
    "topics.unfilter": "显示全部",
    # fields of messages
    "fields.request": "请求：话题",
    "fields.response": "响应：字段",
    "fields.type": "类型",
    "fields.expression": "表达式",
    "fields.value": "值",
    "fields.edit": "修改",
    "fields.take": "确定",
    "fields.on": "并改下一个",
    "fields.leave": "保留原值",
    "fields.next": "输入时跳到下一个字段",
    "fields.default": "默认值",
    "fields.in_force": "生效的是：{text}",
    "fields.elements": "列表加、减一项",
    # service_caller
    "service.call": "调用",
    "service.cancel": "取消",
    "service.refresh": "刷新",
    "service.choose": "服务",
    "service.choose_title": "服务",
    "service.none": "没有服务",
    "service.count": "{count} 个服务",
    "service.waiting_for_any": "还没有服务。启动一个节点吧。",
    "service.waiting": "已调用，正在等回答。",
    "service.waiting.long": "{seconds} 秒了还没有人回答。按 x 不再等。",
    "service.cancelled": "已取消，不再等回答。那个节点可能还在做。",
    "service.gone": "提供这个服务的节点不在了，不会有回答。",
    # publisher
    "publisher.columns.topic": "话题",
    "publisher.columns.type": "类型",
    "publisher.columns.rate": "频率",
    "publisher.columns.expression": "表达式",
    "publisher.columns.both": "频率、表达式",
    "publisher.add": "添加",
    "publisher.once": "发布一次",
    "publisher.remove": "删除",
    "publisher.clear": "清空",
    "publisher.tick": "发布",
    "publisher.new": "添加新话题",
    "publisher.none": "还没有发布者。按 a 添加：先选话题，再勾选方框。",
    "publisher.choose_topic": "发布到哪个话题",
    "publisher.new_topic": "另一个话题……",
    "publisher.new_topic.note": "话题的名字；接下来选它的类型。",
    "publisher.choose_type": "话题的类型",
    # type browsers
    "types.columns.tree": "树",
    "types.columns.type": "类型",
    "types.columns.path": "路径",
    "types.package": "包",
    "types.no_package": "没有包",
    "types.add": "添加类型",
    "types.text": "看定义",
    "types.remove": "删除",
    "types.choose.msg": "消息",
    "types.choose.srv": "服务",
    "types.choose.action": "动作",
    "types.none.msg": "按 p 选包，按 a 选它的一个消息类型。",
    "types.none.srv": "按 p 选包，按 a 选它的一个服务类型。",
    "types.none.action": "按 p 选包，按 a 选它的一个动作类型。",
    # action_browser
    "actions.live": "动作",
    "actions.none": "没有动作服务器在运行。",
    "actions.ends": "服务器 {servers}，客户端 {clients}",
    "actions.server": "服务器",
    "actions.client": "客户端",
    "actions.goal": "要发送的目标",
    "actions.id": "目标 {id}",
    "actions.own": "从这里发送",
    "actions.feedback": "反馈",
    "actions.result": "结果",
    "actions.watch": "观察",
    "actions.send": "发送目标",
    "actions.cancel": "取消目标",
    "actions.state.sent": "已发送，服务器还没有接受。",
    "actions.state.rejected": "目标被拒绝了。",
    "actions.state.no_server": "现在没有服务器提供这个动作。",
    # rqt
    "rqt.open": "打开",
    "rqt.close": "关闭",
    "rqt.is_open": "已打开：{name}",
    "rqt.perspective": "窗口组合 {name}",
    "rqt.perspectives": "窗口组合",
    "rqt.create": "新建窗口组合",
    "rqt.create.note": "保存当前打开的窗口",
    "rqt.import": "打开文件",
    "rqt.export": "写入文件",
    "rqt.wrong_name": "不能用这个名字。",
    "rqt.name_taken": "已经有同名的窗口组合。",
    "rqt.about.rqt_action": "动作的类型、目标和结果",
    "rqt.about.rqt_reconfigure": "修改运行中节点的参数",
    "rqt.about.rqt_graph": "谁在和谁通信",
    "rqt.about.rqt_bag": "录制、查看和播放 bag",
    "rqt.about.rqt_console": "所有节点的日志消息",
    "rqt.about.rqt_logger_level": "节点记录多少日志",
    "rqt.about.rqt_shell": "输入一行命令",
    "rqt.about.rqt_py_console": "输入一行 Python",
    "rqt.about.rqt_robot_steering": "用两个滑块开机器人",
    "rqt.about.rqt_service_caller": "调用服务",
    "rqt.about.rqt_srv": "服务的类型和字段",
    "rqt.about.rqt_publisher": "发布自己的消息",
    "rqt.about.rqt_msg": "消息的类型和字段",
    "rqt.about.rqt_topic": "话题、频率和消息",
    "rqt.about.rqt_image_view": "摄像头的图像",
    "rqt.about.rqt_plot": "数值随时间的变化",
    "rqt.about.rqt_tf_tree": "坐标系之间的关系",
    # rqt_tf_tree
    "tf_tree.columns.frame": "坐标系",
    "tf_tree.columns.age": "距今 s",
    "tf_tree.columns.rate": "频率 Hz",
    "tf_tree.columns.buffer": "缓冲 s",
    "tf_tree.columns.broadcaster": "发送者",
    "tf_tree.none": "还没有收到坐标变换（No tf data received）",
    "tf_tree.static": "静态",
    "tf_tree.again": "（成圈）",
    "tf_tree.root": "{name} 是根：没有人发送通向它的变换。",
    "tf_tree.old": "{count} 个没更新",
    "tf_tree.recorded": "记录时间：{time}",
    "tf_tree.refresh": "刷新",
    "tf_tree.clear": "清空缓冲",
    "tf_tree.auto": "自动刷新",
    "tf_tree.sideways": "左右移动",
    "tf_tree.save": "另存为",
    "tf_tree.saved": "已保存：{name}",
    "tf_tree.save_note": "后缀决定格式：.pdf、.svg、.png 是图，.dot 给 Graphviz 用。",
    # rqt_reconfigure
    "reconfigure.none": "还没有节点带参数。先启动一个节点。",
    "reconfigure.no_match": "没有符合的节点。按 Esc 显示全部。",
    "reconfigure.choose": "在左边选一个节点，按 Enter，它的参数就显示在这里。",
    "reconfigure.reading": "正在读取参数……",
    "reconfigure.unread": "没有读完；按 r 再读一次",
    "reconfigure.waiting": "{seconds} 秒没有回应：{reason}。按 Esc 不再等。",
    "reconfigure.gone": "这个节点已经不在了：下面是它最后的参数。",
    "reconfigure.not_there": "没有这个节点。",
    "reconfigure.no_parameters": "没有参数",
    "reconfigure.read_only": "只读",
    "reconfigure.sent": "已经发出，还没有回应",
    "reconfigure.nodes": "节点 {count} 个",
    "reconfigure.filtered": "只显示：{text}",
    "reconfigure.open": "打开",
    "reconfigure.close": "关闭",
    "reconfigure.read": "重新读取",
    "reconfigure.switch": "开/关",
    "reconfigure.move": "拖动",
    "reconfigure.far": "一次十步",
    "reconfigure.ends": "最小、最大",
    "reconfigure.value": "输入数值",
    "reconfigure.side": "换一边",
    "reconfigure.filter": "筛选",
    "reconfigure.cancel": "不再等；显示全部",
    "reconfigure.files": "保存、读入",
    "reconfigure.filter_nodes": "节点名里有",
    "reconfigure.filter_parameters": "参数名里有",
    "reconfigure.unfitting": "这不是 {type} 类型的值。",
    "reconfigure.save": "把参数保存到文件",
    "reconfigure.load": "从文件读入参数",
    "reconfigure.saved": "已保存：{file}",
    # rqt_logger_level
    "loggers.nodes": "节点",
    "loggers.loggers": "日志器",
    "loggers.levels": "级别",
    "loggers.choose": "按 Enter 选一个节点。灰色的节点不让别人读取或设置级别。",
    "loggers.gone": "{node} 已经不在了。",
    "loggers.not_served": (
        "{node} 不让别人读取或设置它的级别：创建它时没有写 enable_logger_service=True"
        "（rclcpp：NodeOptions().enable_logger_service(true)）。"
    ),
    "loggers.waiting": "{seconds} 秒没有回应：这个节点可能没有在 spin。按 Esc 不再等。",
    "loggers.not_set": "这个日志器没有自己的级别：用上一级的级别，没有另外指定就是 INFO。",
    "loggers.show": "选定",
    "loggers.to_levels": "去选级别",
    "loggers.set": "设定",
    "loggers.column": "换一列",
    "loggers.add": "添加日志器",
    "loggers.name": "日志器的名字",
    "loggers.cancel": "不再等",
    # rqt_shell
    "shell.run": "运行",
    "shell.history": "以前的命令",
    "shell.stop": "停止",
    "shell.running": "正在运行……",
    "shell.no_desktop": "这里的 shell 运行的是桌面（day6-tui）里的命令，现在没有桌面：请在你自己的终端里输入命令。",
    # rqt_py_console
    "py_console.no_desktop": "这个控制台在桌面（day6-tui）里运行 Python，现在没有桌面：请在你自己的终端里输入 python3。",
    "py_console.ended": "Python 已经结束，状态是 {status}。按 Enter 重新开始。",
    "py_console.begin": "新的 Python",
    "py_console.indent": "缩进",
    "py_console.end": "结束 Python",
    # rqt_robot_steering
    "steering.topic": "话题",
    "steering.topic_title": "速度发到哪个话题",
    "steering.no_topic": "（没有话题）",
    "steering.space": "空格",
    "steering.stop": "停",
    "steering.linear": "线速度",
    "steering.angular": "角速度",
    "steering.minimum": "最小",
    "steering.maximum": "最大",
    "steering.limits": "范围",
    "steering.next": "下一个",
    "steering.change": "每次 0.1",
    "steering.far": "一次十步",
    "steering.zero": "线速度、角速度归零",
    "steering.bad_limit": "{low} 到 {high} 之间的数。",
    "steering.nothing": "没有话题，就什么也不发布。",
    "steering.unheard": "没有人订阅 {topic}。",
    "steering.heard": "订阅者：{count}",
    "steering.other_type": "{topic} 的类型是 {types}，不是 {type}。",
    "steering.other_stamp": "{topic} 的类型是 {types}，不是 {type}：按 m 更换。",
    # rqt_plot
    "plot.none": "还没有曲线：按 a 选一个字段，或按 e 输入，例如 /turtle1/pose/x。",
    "plot.waiting": "等待这个话题出现",
    "plot.quiet": "还没有数据",
    "plot.paused": "已暂停",
    "plot.seconds": "{count} 秒",
    "plot.add": "添加",
    "plot.type": "输入字段",
    "plot.type.note": "话题加字段，例如 /turtle1/pose/x 或 /joint_states/position[0]；/turtle1/pose/x:y 表示两条。",
    "plot.choose": "选一个字段来画",
    "plot.remove": "去掉",
    "plot.pause": "暂停",
    "plot.resume": "继续",
    "plot.span": "时间",
    "plot.fine": "更细、更粗",
    "plot.curve": "选一条曲线",
    "plot.clear": "清空",
    # the pages of the manual
    "help.topics": (
        "所有的话题和它们的类型。按 Enter，或者点一下方框，就开始听这个话题：会显示带宽、频率和最新的一条消息。"
        "听就是订阅，所以订阅者会多一个。\n\n"
        "按右方向键，或者点一下小箭头，把话题展开：可以看到消息的每个字段，还有谁在发布、谁在订阅。左方向键收起。"
        "s 换一列排序，S 反过来排，点列名也行。/ 按话题名或类型的一部分过滤，Esc 显示全部。\n\n"
        "值太长、一行放不下，就按 v 看全部；还没有消息时，v 显示这个类型的定义。在那里按 c 复制。"
    ),
    "help.rqt_tf_tree": (
        "坐标系的树：每个坐标系都在它的上级下面。“距今”是最新的变换到现在有多久，“频率”是多久来一次，“缓冲”是存了多少秒。"
        "静态的坐标系只在 /tf_static 上发一次，一直有效。不再有人发的坐标系会变成警告的颜色，并且写着已经多久没更新了。\n\n"
        "有几个根，就说明树断开了：它们之间没有变换。名字出现第二次的坐标系绕成了圈。\n\n"
        "↑ ↓ 选一个坐标系，下面会写得更详细；← → 左右移动名字，滚轮和 Shift 加滚轮也行。"
        "树每秒看一次；a 关掉自动，再按 r 才重新看，和真的那个按钮一样。c 忘掉静态以外的所有变换。"
        "w 存成图：.pdf、.svg、.png 或 .dot。"
    ),
    "help.service_caller": (
        "手动调用服务，和 ros2 service call 一样。s 选服务；下面的树是请求的各个字段和默认值。按 Enter，或者点一下值，"
        "就能修改；Enter 确定，Tab 接着改下一个字段，Esc 保留原来的，Del 恢复默认值。然后按 c 或者点“调用”发出请求，"
        "响应显示在下面。\n\n"
        "表达式是 Python 的一部分：1.5、2*pi、sin(0.3)、[1, 2]、'文字'；文字也可以不加引号。不适合字段的表达式会被标出来，"
        "这个字段就用默认值发出去，和真的 rqt 一样。在列表的那一行按 + 和 - 增加一项、去掉最后一项。\n\n"
        "没有人回答时，窗口会告诉你等了多久，按 x 不再等。节点怎么看这次调用，要看它自己的终端：比如已经有同名的海龟时，"
        "turtlesim 会返回一个空的名字。"
    ),
    "help.publisher": (
        "手动发布消息，和 ros2 topic pub 一样。按 a 添加发布者：选一个已有的话题，或者输入新名字再选类型。"
        "按空格，或者点一下方框，就按这一行的频率开始发布（单位 Hz；在这一行按 Enter 修改，0 表示只手动发布）。"
        "o 发布一条，d 删除这个发布者，C 全部删除。\n\n"
        "在字段上按 Enter，或者点一下它的值，就能输入表达式，和服务调用器里一样。每条消息都会重新计算："
        "i 是消息的序号，所以 sin(i/10) 会来回摆动。now() 是现在的时间，用在时间戳上；random() 和 uniform(0, 1) 每次都不同。"
        "文字可以不加引号。有错的会被标出来，改好以前还是用原来的表达式，和真的 rqt 一样；"
        "只在某条消息里算不出来的，那一条用默认值。\n\n"
        "数组的每一项各占一行，也可以填表达式；在数组自己的那一行按 + 和 - 增加一项、去掉最后一项，"
        "也可以一次写完，例如 [0.5, i, 2*i]。"
    ),
    "help.type_browser": (
        "这里有哪些消息类型或服务类型，和 ros2 interface show 一样。按 p 选包，按 a 把它的一个类型加进来，显示成字段的树。"
        "按 Enter 或 v 看这一行的类型是怎么定义的，再按 c 复制；d 删除这棵树。"
    ),
    "help.action_browser": (
        "下面是动作的类型，和真的 rqt 一样：按 p 选包，按 a 添加它的一个类型，按 Enter 看它的定义。\n\n"
        "上面是正在运行的动作，真的 rqt 没有这一部分。按 Enter 或右方向键展开：可以看到服务器和客户端、"
        "要填写的目标（在字段上按 Enter），还有所有目标的状态、反馈和结果。g 发送目标，x 取消。"
        "展开的时候这个窗口在听，所以它也算一个客户端。"
    ),
    "help.rqt_reconfigure": (
        "正在运行的节点的参数，相当于带窗口的 ros2 param。左边是节点，按命名空间排列：按 Enter 或者点一下就打开，可以打开几个。"
        "右边是它们的参数。Tab 换一边。\n\n"
        "节点给了范围的数字是滑块：左右方向键走一步，加 Shift 走十步，Home 和 End 到两端；用鼠标拖，松手时才发出，"
        "和真的 rqt 一样。按数字或 Enter 输入准确的值。其他的值直接输入，数组写成 [1, 2, 3]。true 和 false 用 Enter 切换。\n\n"
        "改参数只是一个请求：节点会回答，也可以拒绝。拒绝时会显示它的理由，并恢复原来的值。别人改的值（比如用 ros2 param set）"
        "会自己显示出来。\n\n"
        "/ 筛选节点或参数，r 重新读取，x 关闭节点。w 把参数存成 YAML，o 读入这样的文件。不 spin 的节点不会回答：这里会数秒，"
        "按 Esc 就不再等。"
    ),
    "help.rqt_logger_level": (
        "节点从哪个级别开始输出日志。先选节点，再选它的日志器，再选级别：DEBUG 输出最多，FATAL 最少。用鼠标点也一样。"
        "改了以后一直有效，直到节点结束；启动时用 --log-level 也是这个作用。\n\n"
        "只有创建时写了 enable_logger_service=True 的节点才能问，例如 `ros2 run demo_nodes_py use_logger_service`；"
        "其他的节点是灰色。节点不会告诉别人它有哪些日志器：按 a 输入名字添加，比如 rcl。\n\n"
        "真的 ROS 2 里这个窗口还只是草稿，用的是别的服务。这里用的是 ROS 2 自己的服务 get_logger_levels 和 set_logger_levels。"
    ),
    "help.rqt_shell": (
        "一个简单的 shell，给会自己结束、不用输入的命令，例如 ros2 topic list：就是 rqt 的 SimpleShell，"
        "真的 rqt 现在也只剩这一种。命令输出的内容显示在上面。不会结束的命令用 ^C 停止。\n\n"
        "↑ ↓ 找回以前的命令，PageUp 往回看输出。每一行都有自己的 shell，所以 cd 只在这一行里有效。其他的事用终端做：F2。"
    ),
    "help.rqt_py_console": (
        "一行一行地运行 Python，和终端里的 python3 一样。按 Enter 就运行；以冒号结尾的行后面还有代码块，空行表示代码块结束。"
        "出错时显示的就是 Python 自己的报错，input() 也在这里提问。\n\n"
        "这里创建的节点是真的：import rclpy，rclpy.init()，node = rclpy.create_node('mine')，然后 ros2 node list 里就有 /mine。"
        "Python 在自己的进程里运行：停不下来的用 ^C 打断，exit() 或 ^D 结束它，再按 Enter 重新开始。关掉窗口，它也就结束了。\n\n"
        "真的 rqt 是在自己里面运行这些代码：一个死循环会让所有窗口停住，exit() 会关掉这个窗口。"
    ),
    "help.rqt_robot_steering": (
        "给听速度的机器人发指令：把 geometry_msgs/Twist 发到 /cmd_vel，按 t 可以换话题，比如 /turtle1/cmd_vel。"
        "勾上 stamped 就发 TwistStamped，较新的机器人用的就是它。\n\n"
        "w 加速，s 减速，a 左转，d 右转；按住 Shift 一次十步。x 让线速度归零，z 让角速度归零，空格两个都归零。"
        "方向键也一样，滑块还可以用鼠标拖。Tab 选滑块的两端，Enter 输入数值。\n\n"
        "速度每秒发布十次，零只发布一次，这样别人也能开。关窗口之前先停下来：和真的 rqt 一样，关窗口时它什么也不发，"
        "没人管的机器人会一直开下去。"
    ),
    "help.rqt": (
        "rqt 把 ROS 工具的窗口集中在一起。用方向键选一个，按 Enter 打开；已经打开的会再开一个。每个窗口是一个窗格，"
        "但它们都属于同一个程序、同一个节点。x 关闭光标所在的窗口，关掉本窗口就关闭全部。\n\n"
        "打开着的窗口连同设置叫一个窗口组合（perspective），rqt 下次启动时恢复最后一个。按 p 可以切换、新建、"
        "读入或写出文件，真正的 rqt 也能读这种文件。每个窗口也是一条命令：ros2 run rqt_plot rqt_plot。"
        "这样打开的窗口会拿到键盘；末尾写 &，键盘就留在终端里。"
    ),
    "help.rqt_plot": (
        "把消息里的数字画成随时间变化的曲线。一条曲线就是一个话题的一个字段，图例里是它的最新值。纵轴会自动适应能看到的数值。\n\n"
        "字段写得像路径：/turtle1/pose/x；列表里的一项写成 /joint_states/position[0]。听就是订阅，所以订阅者会多一个。"
    ),
}

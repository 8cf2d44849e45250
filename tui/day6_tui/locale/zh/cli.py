"""The command line, and a desktop that outlives its terminal."""

TEXTS = {
    # 比终端活得更久的桌面
    "detached.asked": "已暂离：用 {command} 回来",
    "detached.taken": "已暂离，因为另一个终端接管了桌面：用 {command} 回来",
    "detached.none": "没有用 {command} 启动的桌面在运行",
    "detached.runs": "桌面已经在运行：用 {command} 进入",
    "detached.started": "桌面在运行：用 {command} 进入",
    "detached.lost": "桌面的守护进程结束了，桌面也随之结束；输入过的内容和布局都保存着",
    "detached.inside": "这里就是那个桌面的终端",
    "detached.no_terminal": "attach 需要一个终端",
    "detached.windows": "--detach 和 attach 需要伪终端，Windows 上没有",
    # 命令行
    "cli.description": "没有装 ROS 2 也能用 ROS 2。后面不写命令，就打开桌面。",
    "cli.usage": "用法：",
    "cli.options": "选项",
    "cli.help": "显示这份帮助",
    "cli.scene": "从哪个场景开始（默认：欢迎页面上的选项）",
    "cli.robot": "用你自己的 URDF 文件代替自带的小车",
    "cli.distro": "用哪个 ROS 2 发行版（默认：ROS_DISTRO，否则上次选的，再否则 jazzy）",
    "cli.lang": "界面的语言（默认：和系统一样）",
    "cli.glyphs": "用什么画图（默认：看终端；能显示真像素就用 pixels）",
    "cli.theme": "用哪种配色（默认：上次选的）",
    "cli.fps": "每秒最多画几帧（默认：30）",
    "cli.reduced_motion": "不要闪烁和动画",
    "cli.home": "终端里的 ~ 是哪个文件夹",
    "cli.detach": "终端关了桌面也继续运行；day6-tui attach 再回来",
    "cli.attach": "回到用 day6-tui --detach 启动的桌面，从这台电脑的任何终端都行。",
    "cli.attach.home": "那个桌面里的 ~ 是哪个文件夹（启动时写了 --home 才需要）",
    "cli.attach.lang": "attach 说话用的语言（默认：和系统一样）",
    "cli.class": "网络上的一个班：每个桌面有自己的节点和话题，老师能看到所有人的。",
    "cli.class.group": "班级",
    "cli.class.teacher": "这是老师的桌面；在端口 {port} 等学生（换端口用 --listen）；学生之间互相看不到",
    "cli.class.room": "和 --teacher 一起用：所有人共用一个图，一起玩",
    "cli.class.join": "加入这位老师的班：HOST 或 HOST:PORT，例如 192.168.1.5；不写端口就是 {port}",
    "cli.class.name": "你在班里的名字：字母、数字和单个 _，字母开头，例如 wang_xiaoming",
    "cli.class.one": "请选 --teacher，或者 --join HOST --name NAME",
    "cli.class.no_name": "--join 还需要 --name NAME",
    "cli.class.name.letters": "“{name}”不能当名字：字母 a-z 开头，后面是字母、数字和 _，例如 wang_xiaoming",
    "cli.class.name.double": "“{name}”不能当名字：不能有连着的两个 _，和 ROS 的名字一样",
    "cli.class.name.long": "“{name}”不能当名字：最多 {most} 个字符",
    "cli.class.name.teacher": "“{name}”不能当名字：这是老师的名字",
    "cli.class.with_teacher": "{option} 要和 --teacher 一起用",
    "cli.class.with_join": "{option} 要和 --join 一起用",
    "cli.class.connect": "上课时用 --join HOST，不用 --connect",
    "cli.class.endpoint": "“{text}”不是主机名或地址",
    "cli.class.port": "“{text}”：{port} 不是端口，端口是 1 到 65535",
    "cli.listen": "让别的电脑加入，例如 tcp/0.0.0.0:7447；不写 --secret 的话，能连上这个端口的人都可以读取和发命令",
    "cli.connect": "加入另一台电脑，例如 tcp/192.168.1.5:7447",
    "cli.secret": (
        "--listen 和 --connect 的电脑共有的口令：最好是一个只有你能读的文件（chmod 600）；直接写一个词，"
        "这台电脑上的其他用户在进程列表里看得到"
    ),
    "cli.version": "显示版本号",
    "cli.commands": """\
命令：
  shell                       真正的终端，里面的 ros2、colcon、rviz2、python3 … 都是这里的
  attach [--home DIR]         回到用 --detach 启动的桌面
  serve [--class FILE.csv]    全班用浏览器：每个学生一个桌面
  class --teacher             老师的桌面，同一网络的学生可以加入
  class --join HOST --name NAME
                              学生的桌面，加入这个班
  wheelhouse DIR              不联网安装所需的一切，放进一个文件夹（U 盘）
  lessons VERB                课程文件：list、new、check、preview、play、help（怎么写课程）
  demo DAY                    自动演示一天的课程，给全班看
  exec [-c COMMANDS] [FILE]   不开桌面，直接运行模拟终端的命令
  python FILE [ARG ...]       把一个 Python 文件原样当作 ROS 程序运行
  ros2 ...                    ros2 命令，看到的是这台电脑上的节点和话题
  colcon ...                  编译工作空间
  rviz2                       机器人的三维画面；窗口占用这个终端
  rqt, rqt_graph, rqt_console, rqt_plot, rqt_topic
                              rqt 的各个窗口
  check_urdf FILE             检查机器人描述文件
  urdf_to_graphviz FILE       把机器人描述画成图
  xacro FILE [NAME:=VALUE]    把 xacro 文件展开成 URDF
  cast FILE.cast [--svg FILE] 播放屏幕的录像，或者把画面写成 SVG
  why [TEXT]                  解释一句报错；A 2>&1 | day6-tui why 解释 A 说的话
  export [PKG ...] [-o FILE]  把工作空间的包打成 zip，拿到真正的 ROS 2 上编译
  submit [-o FILE.zip]        把程序和回答打成一个文件，交给老师
  grade FILE ...              用隐藏的情景重新运行作业来评分（--csv、--html）
  report [--csv|--html FILE]  这台电脑上所有学生的学习进度
  env [--vscode|--pycharm]    打印让普通终端也能用的变量，或者设置好 IDE""",
    "cli.more": "想知道更多：day6-tui 命令 --help",
    "cli.no_command": "没有叫 {name} 的命令；day6-tui --help 列出所有命令",
    "cli.no_terminal": "桌面需要一个终端；day6-tui exec 不用终端也能运行命令",
    "cli.textual": "装的是 Textual {version}，而这个 day6-tui 需要 {tested}：pip install 'textual=={tested}.*'",
}

"""The words of what rules and lookers find, English and Chinese; they fill in names in braces. The rest is in `cards`."""

from __future__ import annotations

# A rule's key -> English, Chinese.
TEXTS: dict[str, tuple[str, str]] = {
    "home": (
        "there is no {wrong} here: your home folder is ~. Write {right}, or $HOME{rest}",
        "这里没有 {wrong}：你的主目录写成 ~。可以写 {right}，或者 $HOME{rest}",
    ),
    "home.python": (
        "there is no {wrong} here: your home folder is ~. In Python, write os.path.expanduser('{right}')",
        "这里没有 {wrong}：你的主目录写成 ~。在 Python 里写 os.path.expanduser('{right}')",
    ),
    "home.short": (
        "Python doesn't know what {wrong} is; only the shell does. Write os.path.expanduser('~{rest}')",
        "Python 不认识 {wrong}，只有终端认识它。要写 os.path.expanduser('~{rest}')",
    ),
    "program.example": (
        "{wrong} is the home folder in the example, and there is none here (yours is ~): write your own path",
        "{wrong} 是例子里的主目录，这里没有（你的主目录是 ~）：要换成你自己的路径",
    ),
    "program.elsewhere": (
        "{name} is not in {folder}, where the command was typed, but here: {place}",
        "{name} 不在输入命令的文件夹 {folder} 里，它在 {place}",
    ),
    "home.launch": (
        (
            "there is no {wrong} here: your home folder is ~. In a launch file, write os.path.expanduser('{right}'), or for a "
            "file that setup.py installs: os.path.join(get_package_share_directory('PACKAGE'), 'FOLDER', 'FILE')"
        ),
        (
            "这里没有 {wrong}：你的主目录写成 ~。在 launch 文件里写 os.path.expanduser('{right}')；如果文件由 setup.py 安装，"
            "就写 os.path.join(get_package_share_directory('包名'), '文件夹', '文件名')"
        ),
    ),
    "not_sourced": (
        "{name} is built, but this terminal doesn't know it yet. Run: source {setup}",
        "{name} 已经编译好了，但这个终端还不知道它。先运行：source {setup}",
    ),
    "not_built": (
        "{name} is in {folder}, but it hasn't been built yet. Run: cd {workspace}; colcon build; source install/setup.bash",
        "{name} 在 {folder} 里，但还没有编译。先运行：cd {workspace}; colcon build; source install/setup.bash",
    ),
    "build_failed": (
        "{name} is in {folder}, but its last build failed. See why: cd {workspace}; colcon build --packages-select {name}",
        "{name} 在 {folder} 里，但上一次编译失败了。看看为什么：cd {workspace}; colcon build --packages-select {name}",
    ),
    "refused": (
        "{name} is in {folder}, but colcon leaves it out: its package.xml has a mistake. See why: cd {workspace}; colcon build",
        "{name} 在 {folder} 里，可是 colcon 跳过了它：它的 package.xml 写得不对。看看为什么：cd {workspace}; colcon build",
    ),
    "manifest.xml": (
        "{file} has a mistake in line {line} ({what}), so colcon leaves its package out",
        "{file} 第 {line} 行写得不对（{what}），所以 colcon 跳过了这个包",
    ),
    "manifest.root": (
        "in {file} everything has to be inside <package>, not <{what}>, so colcon leaves its package out",
        "{file} 的内容要写在 <package> 里，不是 <{what}>，所以 colcon 跳过了这个包",
    ),
    "manifest.lacks": (
        "<{what}> is missing in {file}, so colcon leaves its package out",
        "{file} 里少了 <{what}>，所以 colcon 跳过了这个包",
    ),
    "command.near": (
        "there is no command {name}; did you mean {near}?",
        "没有叫 {name} 的命令，是不是想写 {near}？",
    ),
    "folder.src": (
        (
            "this is the folder src: build in {workspace}, or you get a second build and install here. "
            "To remove these: rm -r build install log"
        ),
        "这里是 src 文件夹：要在 {workspace} 里编译，不然这里会多出一套 build 和 install。删掉这里的：rm -r build install log",
    ),
    "folder.nothing": (
        "there is no package below this folder. Your workspace is ~/ros2_ws: cd ~/ros2_ws, then build",
        "这个文件夹下面没有功能包。你的工作空间是 ~/ros2_ws：先 cd ~/ros2_ws，再编译",
    ),
    "command.meant": ("did you mean {near}?", "是不是想写 {near}？"),
    "command.case": (
        "commands are lowercase: {near}",
        "命令要用小写字母写：{near}",
    ),
    "command.prompt": (
        "{name} is the prompt: it shows that the terminal is waiting. Don't type it, only what comes after it",
        "{name} 是提示符，表示终端在等你输入，不用打出来：只输入它后面的内容",
    ),
    "command.blank": (
        "there is no command {name}; a space is missing after {command}: {right}",
        "没有叫 {name} 的命令：{command} 后面少了一个空格，应该写 {right}",
    ),
    "command.blank_here": (
        "a space is missing after {command}: {right}",
        "{command} 后面少了一个空格，应该写 {right}",
    ),
    "command.answer": (
        "answer the question in the lesson's window, not here: press F5, then {name}",
        "回答问题要在课程窗口里：先按 F5，再按 {name}",
    ),
    "quote.open": (
        "> means that the closing {quote} is still missing: what you type becomes part of that text. Ctrl-C starts again",
        "> 表示引号 {quote} 还没有关上，输入的都算那段文字。按 Ctrl-C 重来",
    ),
    "chinese.typed": (
        "the command has a Chinese '{wrong}' but needs the English '{right}': switch the input method to English",
        "命令里有中文的「{wrong}」，要用英文的「{right}」：把输入法切换成英文再输入",
    ),
    "chinese.end": (
        "the command ends with a Chinese '{wrong}' that doesn't belong there: {right}",
        "命令最后多了一个中文的「{wrong}」，它不是命令的一部分：{right}",
    ),
    "chinese.blank": (
        "the command has a wide, Chinese space: switch the input method to English and type it again",
        "命令里有一个全角的（中文的）空格：把输入法切换成英文再输入",
    ),
    "choice.near": ("there is no {name} here; did you mean {near}?", "这里没有 {name}，是不是想写 {near}？"),
    "ros_args.option": (
        "{word} has no {option} before it: each one needs its own {option}",
        "{word} 前面少了 {option}：每一个前面都要有自己的 {option}",
    ),
    "ros_args.colon": (
        "put := between name and value, not just =: {right}",
        "名字和值中间要写 :=，不能只写 =：{right}",
    ),
    "value.blank": (
        "a space is missing after {name}: the colon needs one after it",
        "{name}: 后面少了一个空格：冒号后面一定要有空格",
    ),
    "value.name": (
        "the name of the field is missing: {right}",
        "少了字段的名字：{right}",
    ),
    "value.inside": (
        "{name} isn't a separate field: it is inside {holders}. So write {right}",
        "{name} 不在最外面一层，它在 {holders} 里面，所以要写成 {right}",
    ),
    "value.near": ("there is no field {name}; did you mean {near}?", "没有字段 {name}，是不是想写 {near}？"),
    "value.deeper": (
        "{name} has its own fields, in brackets: {right}",
        "{name} 里面还有自己的字段，要写在括号里：{right}",
    ),
    "value.integer": (
        "{name} takes whole numbers from {low} to {high}",
        "{name} 只能是 {low} 到 {high} 的整数",
    ),
    "value.decimal": ("{name} takes a number, like 1.0", "{name} 要写一个数，比如 1.0"),
    "value.bool": ("{name} takes true or false", "{name} 只能写 true 或者 false"),
    "value.string": ("{name} takes a text, like 'hello'", "{name} 要写文字，比如 'hello'"),
    "value.fields": ("{type} has these fields: {fields}", "{type} 有这些字段：{fields}"),
    "value.unquoted": (
        "the contents have spaces, so they need quotation marks around them",
        "内容里有空格，要在整个内容外面加上引号",
    ),
    "needed.name": ("its name is missing; {lists} lists them", "少了名字，{lists} 列出现在有哪些"),
    "needed.type": (
        "{name} has the type {type}: it comes after the name, then the contents. Use your own values",
        "{name} 的类型是 {type}：写在名字后面，再后面是内容。把里面的值换成你自己的",
    ),
    "needed.type_alone": (
        "{name} has the type {type}: it comes after the name",
        "{name} 的类型是 {type}：写在名字后面",
    ),
    "needed.node": (
        "the node is missing: it comes before {name}. The nodes are: {nodes}",
        "少的其实是节点：它要写在 {name} 前面。现在有这些节点：{nodes}",
    ),
    "needed.no_equals": (
        "put a space between name and value, not =: {name} {value}",
        "名字和值中间写空格，不写 =：{name} {value}",
    ),
    "run.package": (
        "{name} is a program, but its package is missing: {package} comes first",
        "{name} 是程序，前面少了它的包：{package}",
    ),
    "run.program": (
        "{name} is a package; which of its programs should run? Add the program's name after it",
        "{name} 是包，后面还要写运行它里面的哪个程序",
    ),
    "run.turned": (
        "{name} is a program and {package} its package: the package comes first",
        "{name} 是程序，{package} 才是包：先写包，再写程序",
    ),
    "type.slashes": (
        "a type has / in it, not dots: {near}",
        "类型里写 /，不写点：{near}",
    ),
    "type.parts": (
        "the type has three parts here: {near}",
        "这里的类型要写成三段：{near}",
    ),
    "type.whole": (
        "the package comes before {name}: {near}",
        "{name} 前面还要写它的包：{near}",
    ),
    "type.several": (
        "several types are called {name}; write the one you want: {types}",
        "有几个类型都叫 {name}，写出要的那一个：{types}",
    ),
    "module.near": (
        "there is no module {name}; did you mean {near}?",
        "没有叫 {name} 的模块，是不是想写 {near}？",
    ),
    "module.moved": (
        "in {distro} the interfaces of turtlesim are in {now}: write {now} instead of {name}, in package.xml too",
        "在 {distro} 里，turtlesim 的接口在 {now} 里：把 {name} 写成 {now}，package.xml 里也一样",
    ),
    "foreign.nav2": (
        (
            "{name} is a part of Navigation2, which plans a robot's way and drives it; neither day6-tui nor pip "
            "has it. To drive through a room with a lidar yourself: ros2 run day6_world world"
        ),
        (
            "{name} 是 Navigation2 的一部分，给机器人规划路线并开过去；day6-tui 里没有，用 pip 也装不上。"
            "自己写节点在有激光雷达的房间里开：ros2 run day6_world world"
        ),
    ),
    "foreign.simulator": (
        (
            "{name} belongs to a simulator (Gazebo, Webots), which neither day6-tui nor pip has. There is a "
            "small world with walls and a lidar: ros2 run day6_world world"
        ),
        (
            "{name} 是仿真器（Gazebo、Webots）的，day6-tui 里没有，用 pip 也装不上。"
            "这里有一个带墙和激光雷达的小世界：ros2 run day6_world world"
        ),
    ),
    "foreign.moveit": (
        (
            "{name} is a part of MoveIt, which plans the movements of arms; neither day6-tui nor pip has it. On "
            "a real robot: sudo apt install {apt}"
        ),
        (
            "{name} 是 MoveIt 的一部分，给机械臂规划动作；day6-tui 里没有，用 pip 也装不上。真机上运行：sudo apt "
            "install {apt}"
        ),
    ),
    "foreign.slam": (
        (
            "{name} draws maps of what a lidar sees; neither day6-tui nor pip has it. A world with a lidar is "
            "here: ros2 run day6_world world"
        ),
        (
            "{name} 用激光雷达的数据画地图；day6-tui 里没有，用 pip 也装不上。这里有带激光雷达的小世界：ros2 run "
            "day6_world world"
        ),
    ),
    "foreign.localization": (
        (
            "{name} merges sensors into one position; neither day6-tui nor pip has it. The world here knows "
            "where its car is (/odom and /tf): ros2 run day6_world world"
        ),
        (
            "{name} 把几个传感器合成一个位置；day6-tui 里没有，用 pip 也装不上。这里的小世界知道车在哪里（/odom "
            "和 /tf）：ros2 run day6_world world"
        ),
    ),
    "foreign.control": (
        (
            "{name} belongs to ros2_control, which moves the joints of real and simulated robots; neither "
            "day6-tui nor pip has it. Its messages are here (control_msgs)"
        ),
        (
            "{name} 是 ros2_control 的，用来驱动真的和仿真的机器人关节；day6-tui 里没有，用 pip 也装不上。"
            "它的消息 control_msgs 这里有"
        ),
    ),
    "foreign.lidar": (
        (
            "{name} is the driver of a lidar; neither day6-tui nor pip has it. A lidar that needs no device: "
            "ros2 run day6_world world"
        ),
        "{name} 是激光雷达的驱动；day6-tui 里没有，用 pip 也装不上。不用设备的激光雷达：ros2 run day6_world world",
    ),
    "foreign.camera": (
        (
            "{name} is for cameras; neither day6-tui nor pip has it. Images without a camera: ros2 run "
            "image_tools cam2image --ros-args -p burger_mode:=true"
        ),
        (
            "{name} 是给摄像头用的；day6-tui 里没有，用 pip 也装不上。不用摄像头的图像：ros2 run image_tools "
            "cam2image --ros-args -p burger_mode:=true"
        ),
    ),
    "foreign.joystick": (
        (
            "{name} reads a gamepad; neither day6-tui nor pip has it. With the keyboard: ros2 run "
            "teleop_twist_keyboard teleop_twist_keyboard"
        ),
        (
            "{name} 读游戏手柄；day6-tui 里没有，用 pip 也装不上。用键盘：ros2 run teleop_twist_keyboard "
            "teleop_twist_keyboard"
        ),
    ),
    "foreign.turtlebot": (
        (
            "{name} belongs to the TurtleBot; neither day6-tui nor pip has it. A car to drive in its place: ros2 "
            "run day6_world world"
        ),
        "{name} 是 TurtleBot 的；day6-tui 里没有，用 pip 也装不上。可以开这里的小车：ros2 run day6_world world",
    ),
    "foreign.browser": (
        (
            "{name} connects ROS to web pages and apps; neither day6-tui nor pip has it. On a real robot: sudo "
            "apt install {apt}"
        ),
        "{name} 把 ROS 和网页、应用连起来；day6-tui 里没有，用 pip 也装不上。真机上运行：sudo apt install {apt}",
    ),
    "foreign.board": (
        "{name} connects ROS to a microcontroller or a flight controller; neither day6-tui nor pip has it",
        "{name} 把 ROS 和单片机或飞控连起来；day6-tui 里没有，用 pip 也装不上",
    ),
    "foreign.other": (
        (
            "{name} is a ROS package that day6-tui doesn't have, and neither does pip. On a real robot: sudo apt "
            "install {apt}"
        ),
        "{name} 是 ROS 的功能包，day6-tui 里没有，用 pip 也装不上。真机上运行：sudo apt install {apt}",
    ),
    "module.ros1": (
        "{name} belongs to ROS 1, and this is ROS 2: here it is {now}",
        "{name} 是 ROS 1 的，这里是 ROS 2：要用 {now}",
    ),
    "module.pip": (
        "the Python package for {name} is not installed. Run: pip3 install {package}",
        "还没有安装 {name} 用的 Python 包。可以运行：pip3 install {package}",
    ),
    "import.near": (
        "{module} has no {name}; did you mean {near}?",
        "{module} 里没有 {name}，是不是想写 {near}？",
    ),
    "name.import": (
        "{name} has to be imported first, at the top of the file: {line}",
        "{name} 要先导入，写在文件开头：{line}",
    ),
    "import.elsewhere": (
        "{name} is not in {module}; write {line}",
        "{name} 不在 {module} 里，要写 {line}",
    ),
    "name.math": (
        "{name} belongs to the module math: import math at the top of the file, then write math.{name}",
        "{name} 在模块 math 里：文件开头写 import math，用的时候写 math.{name}",
    ),
    "syntax.elif": (
        "line {line}: Python has elif instead of else if",
        "第 {line} 行：Python 里 else if 要写成 elif",
    ),
    "syntax.for": (
        "line {line}: write a counting loop as for i in range(TIMES):",
        "第 {line} 行：数次数的循环要写成 for i in range(次数):",
    ),
    "syntax.and": ("line {line}: Python has and instead of &&", "第 {line} 行：Python 里 && 要写成 and"),
    "syntax.or": ("line {line}: Python has or instead of ||", "第 {line} 行：Python 里 || 要写成 or"),
    "syntax.not": ("line {line}: Python has not instead of !", "第 {line} 行：Python 里 ! 要写成 not"),
    "syntax.then": (
        "line {line}: Python has no then; the line ends with a colon : after the condition",
        "第 {line} 行：Python 里没有 then，条件后面直接写冒号 :",
    ),
    "syntax.plus": (
        "line {line}: Python has no ++ and no --; write {found} += 1 or {found} -= 1",
        "第 {line} 行：Python 里没有 ++ 和 --，要写 {found} += 1 或者 {found} -= 1",
    ),
    "syntax.brace": (
        "line {line}: Python has no braces here; end the line with a colon : and indent what belongs to it by 4 spaces",
        "第 {line} 行：Python 这里不用花括号；行末写冒号 : ，下面的行缩进 4 个空格",
    ),
    "syntax.type": (
        "line {line}: Python has no {found} before a name; write NAME = VALUE",
        "第 {line} 行：Python 里名字前面不写 {found}，直接写 名字 = 值",
    ),
    "syntax.def": (
        "line {line}: a function starts with def in Python, not with {found}: def NAME():",
        "第 {line} 行：Python 的函数用 def 开头，不写 {found}：def 名字():",
    ),
    "syntax.quote": (
        "line {line} has a Chinese quotation mark {found}: a text starts and ends with the same English one, ' or \"",
        "第 {line} 行有中文的引号{found}：文字的开头和结尾要用一样的英文引号，' 或者 \"",
    ),
    "syntax.comment": (
        "line {line}: a comment starts with # in Python, not with //",
        "第 {line} 行：Python 的注释用 # 开头，不用 //",
    ),
    "syntax.keyword": (
        "line {line}: {found} is a word of Python and cannot be a name; choose another one",
        "第 {line} 行：{found} 是 Python 自己的词，不能当名字，换一个",
    ),
    "syntax.text": (
        "a text needs quotation marks in line {line}: '{found}'",
        "第 {line} 行的文字要加引号：'{found}'",
    ),
    "name.near": (
        "nothing is called {name} here; did you mean {near}?",
        "这里没有叫 {name} 的东西，是不是想写 {near}？",
    ),
    "field": (
        "a {type} has no field {name}{near}. Its fields are {fields}",
        "{type} 没有字段 {name}{near}。它的字段有：{fields}",
    ),
    "field.near": ("; did you mean {near}?", "，是不是想写 {near}？"),
    "no_super": (
        "the first line of __init__ has to be super().__init__('NAME'): only then is a {kind} a node",
        "__init__ 里要先写 super().__init__('节点名')，类 {kind} 才是一个节点",
    ),
    "command.variable": (
        "put no spaces around = when you set a variable: {right}",
        "给变量赋值的时候，= 两边没有空格：{right}",
    ),
    "shell.lacks": (
        "{word} is a bash command that this terminal doesn't have",
        "{word} 是 bash 的命令，这个终端没有",
    ),
    "self.lacks": ("self is missing in line {line}: write {right}", "第 {line} 行少了 self：要写 {right}"),
    "main.never_called": (
        "the program did nothing: main in line {line} is never called. End it with: if __name__ == '__main__': main()",
        "程序什么也没有做：第 {line} 行的 main 没有人调用。最后要写 if __name__ == '__main__': main()",
    ),
    "main.other_name": (
        "the program did nothing: line {line} must be if __name__ == '__main__': (two underscores on each side)",
        "程序什么也没有做：第 {line} 行要写 if __name__ == '__main__':（每边两条下划线）",
    ),
    "method.outside": (
        "def {name} in line {line} has lost its indentation: it and what follows belong inside the class {kind}",
        "第 {line} 行的 def {name} 少了缩进：它和后面的方法要在类 {kind} 里面",
    ),
    "local.outside": (
        "line {line} changes the {name} outside the function: the function has to start with global {name}",
        "第 {line} 行要改函数外面的 {name}：函数开头要写 global {name}",
    ),
    "local.later": (
        "{name} has no value yet in line {line}: line {later} gives it one, and has to come first",
        "第 {line} 行用到 {name} 的时候它还没有值：给它值的第 {later} 行要放到前面",
    ),
    "self.later": (
        "self.{name} has no value yet in line {line}: line {later} gives it one, and has to come first",
        "第 {line} 行用到 self.{name} 的时候它还没有值：给它值的第 {later} 行要放到前面",
    ),
    "class.no_brackets": (
        "() is missing after {name} in line {line}: write {right}",
        "第 {line} 行的 {name} 后面少了 ()：要写 {right}",
    ),
    "parameter.near": (
        "the parameter {name} was never declared, but {near} was",
        "没有声明过参数 {name}，声明的是 {near}",
    ),
    "keyword.near": (
        "{name} in line {line} is misspelled: write {near}",
        "第 {line} 行的 {name} 拼错了：要写 {near}",
    ),
    "module.own_python": (
        "your own file {file} has the name of Python's module {name}, so Python finds it first: rename your file",
        "你自己的文件 {file} 和 Python 的模块 {name} 同名，Python 用了你的那个：给自己的文件换个名字",
    ),
    "module.own_file": (
        "your own file {file} has the name of the module {name}, so Python finds it first: rename your file",
        "你自己的文件 {file} 和模块 {name} 同名，Python 用了你的那个：给自己的文件换个名字",
    ),
    "callback.called": (
        "line {line} calls the function at once: pass the function itself, without (): {right}",
        "第 {line} 行马上调用了函数：要把函数本身交出去，后面不写 ()：{right}",
    ),
    "callback.quoted": (
        "line {line} passes a text: pass the function itself, without quotation marks: {right}",
        "第 {line} 行交出的是一段文字：要交出函数本身，不加引号：{right}",
    ),
    "callback.no_message": (
        "a subscription calls {name} with the message, but line {line} takes none: write {right}",
        "订阅会把消息交给 {name}，可是第 {line} 行没有接它：要写 {right}",
    ),
    "timer.arguments": (
        "a timer calls {name} without arguments: in line {line} write {right}",
        "定时器调用 {name} 的时候不给参数：第 {line} 行要写 {right}",
    ),
    "chinese": (
        "line {line} has a Chinese '{wrong}'. Code needs the English '{right}': switch the input method to English",
        "第 {line} 行用了中文的「{wrong}」，代码里要用英文的「{right}」：把输入法切换成英文再输入",
    ),
    "odd_blank": (
        "line {line} has an unusual space (often copied from a web page): replace it with a normal one",
        "第 {line} 行有一个不是普通空格的空白（多半是从网页复制来的）：把它换成英文空格",
    ),
    # what lookers find
    "said": ("{text}", "{text}"),
    "ros_not_sourced": (
        "ROS 2 is not sourced in this terminal: ROS_DISTRO is not set",
        "这个终端还没有 source ROS 2：变量 ROS_DISTRO 没有设置",
    ),
    "package.not_sourced": (
        "{name} is built, in {install}, but this terminal has not sourced it: it was opened before, or is a new one",
        "{name} 已经编译好了，在 {install} 里，可是这个终端还没有 source 它：它是编译之前打开的，或者是新开的",
    ),
    "package.not_built": (
        "{name} is in {folder}, but it hasn't been built yet",
        "{name} 在 {folder} 里，可是还没有编译",
    ),
    "package.build_failed": (
        "{name} is in {folder}, but its last build failed: what colcon build prints says why",
        "{name} 在 {folder} 里，可是上一次编译失败了：colcon build 的输出说明了原因",
    ),
    "package.refused": (
        "{name} is in {folder}, but its package.xml has a mistake, so colcon leaves it out",
        "{name} 在 {folder} 里，可是它的 package.xml 写得不对，所以 colcon 跳过了它",
    ),
    "package.now_known": (
        "{name} is known now, but wasn't when the command ran: run it again",
        "现在已经认得 {name} 了，运行那条命令的时候还不认得：再运行一次",
    ),
    "package.near": (
        "no package is called {name}, but there is {near}",
        "没有叫 {name} 的包，不过有一个叫 {near}",
    ),
    "setup.comma": (
        "a comma is missing at the end of line {line} of {setup}: each entry of console_scripts but the last needs one",
        "{setup} 第 {line} 行末尾少了一个逗号：console_scripts 里每一项后面都要有逗号",
    ),
    "setup.form": (
        "in {setup} the entry {entry} is wrong: write 'name = package.file:main' in entry_points",
        "{setup} 里 {entry} 那一项写得不对：entry_points 里要写 '名字 = 包名.文件名:main'",
    ),
    "executable.near": (
        "the package has no program {name}, but it has {near}",
        "这个包里没有叫 {name} 的程序，不过有 {near}",
    ),
    "executable.has": (
        "{package} has these programs: {names}",
        "{package} 里有这些程序：{names}",
    ),
    "executable.not_built": (
        "setup.py of {package} names {name}, but it isn't installed: build the package, then source it",
        "{package} 的 setup.py 里写了 {name}，可是还没有安装：编译这个包，再 source",
    ),
    "executable.no_entry": (
        "{name}.py is there, but {setup} doesn't name it. Add to the list console_scripts: {line} Then build again",
        "{name}.py 在，可是 {setup} 里没有写它。在 console_scripts 的方括号里加一行：{line} 然后重新编译",
    ),
    "executable.others": (
        "setup.py of {package} names only these programs: {names}",
        "{package} 的 setup.py 里只写了这些程序：{names}",
    ),
    "executable.none": (
        "{setup} names no programs: console_scripts is empty",
        "{setup} 里一个程序都没有写：console_scripts 是空的",
    ),
    "launch.not_rebuilt": (
        "{name} is in the sources and in setup.py, but not installed yet: build again",
        "{name} 在源码里，setup.py 也写了，只是还没有安装：重新编译一次",
    ),
    "launch.data_files": (
        (
            "{name} lies in the folder {place} of the sources, but data_files in {file} does not name it, so colcon does not "
            "install it. Add: ('share/' + package_name + '/{place}', glob('{place}/*')), with from glob import "
            "glob; then build again"
        ),
        (
            "{name} 在源码的 {place} 文件夹里，可是 {file} 的 data_files 没有写它，colcon 就不会安装它。"
            "加上 ('share/' + package_name + '/{place}', glob('{place}/*'))，开头写 from glob import glob，再重新编译"
        ),
    ),
    "launch.install": (
        (
            "{name} lies in the folder {place} of the sources, but {file} does not install it. "
            "Add: install(DIRECTORY {place} DESTINATION share/${{PROJECT_NAME}}), then build again"
        ),
        (
            "{name} 在源码的 {place} 文件夹里，可是 {file} 没有安装它。"
            "加上 install(DIRECTORY {place} DESTINATION share/${{PROJECT_NAME}})，再重新编译"
        ),
    ),
    "launch.near": ("there is no {name}, but there is {near}", "没有 {name}，不过有 {near}"),
    "launch.others": ("{package} has these launch files: {names}", "{package} 里有这些 launch 文件：{names}"),
    "path.no_folder": (
        "the folder {folder} does not exist; {above} does",
        "没有 {folder} 这个文件夹，它的上一级 {above} 是有的",
    ),
    "bag.topics": (
        "since Lyrical, the topics to record come after --topics",
        "从 Lyrical 起，要录的话题写在 --topics 后面",
    ),
    "echo.on_change": (
        "echo has no such option; with --csv each message is one line, and uniq leaves out those that repeat the one before",
        "echo 没有这样的选项；用 --csv 每条消息占一行，uniq 会去掉和上一行相同的",
    ),
    "path.near": ("there is no {name}, but there is {near}", "没有 {name}，不过有 {near}"),
    "path.elsewhere": ("{name} is not in this folder, but here: {place}", "{name} 不在这个文件夹里，它在 {place}"),
    "command.python": (
        "{name} is a Python file in this folder, not a command",
        "{name} 是这个文件夹里的 Python 文件，不是命令",
    ),
    "command.here": (
        "{name} is a file in this folder; the shell looks for commands elsewhere, so write ./ before it",
        "{name} 是这个文件夹里的文件；shell 只在别处找命令，所以前面要写 ./",
    ),
    "is_folder": ("{name} is a folder", "{name} 是一个文件夹"),
    "not_executable": (
        "the file {name} is there, but it isn't marked as a program",
        "文件 {name} 在，只是没有可以执行的标记",
    ),
    "prefix.deleted": (
        "{folder} was deleted after this terminal sourced it. Build again, or open a new terminal",
        "{folder} 在这个终端 source 过之后被删掉了。重新编译，或者开一个新终端",
    ),
    "prefix.gone": ("there is no folder {folder}", "没有 {folder} 这个文件夹"),
    "folder.package": (
        "this is a package's folder: build in the workspace {workspace}",
        "这里是一个功能包的文件夹：要在工作空间 {workspace} 里编译",
    ),
    "type.near": ("there is no type {name}, but there is {near}", "没有 {name} 这个类型，不过有 {near}"),
    "graph.empty": (
        "this terminal sees no running nodes (ROS_DOMAIN_ID is {domain})",
        "这个终端能看到的节点一个也没有（ROS_DOMAIN_ID 是 {domain}）",
    ),
    "graph.other_domain": (
        "ROS_DOMAIN_ID is {domain} in this terminal, where no node is running; but domain {other} has {nodes}",
        "这个终端的 ROS_DOMAIN_ID 是 {domain}，那里一个节点也没有；域 {other} 里有 {nodes}",
    ),
    "graph.now_there": ("{name} is there now: run the command again", "现在已经有 {name} 了：再运行一次"),
    "graph.near": ("there is no {name}, but there is {near}", "没有 {name}，不过有 {near}"),
    "graph.none": ("there is no {name}, or anything else of its kind", "没有 {name}，这一类的一个也没有"),
    "graph.twins": (
        "{count} nodes are called {name}: the same program was started twice, or two have the same name",
        "有 {count} 个节点都叫 {name}：同一个程序启动了两次，或者两个程序起了一样的名字",
    ),
    "topic.no_publisher": (
        "{name} exists because somebody listens to it, but nobody publishes on it",
        "{name} 只有人在听，还没有人发布",
    ),
    "topic.types": (
        "{name} has the types {types} (from {nodes}); only one of them can be right",
        "{name} 上有这几种类型：{types}（来自 {nodes}），只能有一种是对的",
    ),
    "service.type": (
        "{name} has the type {right}, not {wanted}",
        "{name} 的类型是 {right}，不是 {wanted}",
    ),
    "qos.reliability": (
        "on {name}, {publisher} sends best effort and {subscriber} demands reliable: these two never match",
        "在 {name} 上，{publisher} 用 best effort 发送，{subscriber} 却要求 reliable：这两个配不上",
    ),
    "tf.nobody": (
        "nobody publishes /tf or /tf_static, so there are no frames. robot_state_publisher isn't running",
        "没有人发布 /tf 和 /tf_static，所以一个坐标系也没有。robot_state_publisher 没有运行",
    ),
    "tf.only_description": (
        "{nodes} publishes the robot description, but nobody publishes /tf or /tf_static",
        "{nodes} 发布了机器人描述，可是没有人发布 /tf 和 /tf_static",
    ),
    "tf.no_joints": (
        "{publisher} is running, but nobody publishes /joint_states: it doesn't know where the moving parts are",
        "{publisher} 在运行，可是没有人发布 /joint_states：它不知道会动的部件在哪里",
    ),
    "description.nobody": (
        "nobody publishes /robot_description: robot_state_publisher isn't running",
        "没有人发布 /robot_description：robot_state_publisher 没有运行",
    ),
    "description.silent": (
        "{nodes} is running, but publishes no /robot_description",
        "{nodes} 在运行，可是没有发布 /robot_description",
    ),
    "clock.nobody": (
        "use_sim_time is on, but nobody publishes /clock: time stands still for this node",
        "use_sim_time 打开了，可是没有人发布 /clock：对这个节点来说时间停住了",
    ),
    # around a card
    "card.below": ("{first}", "意思：{first}（怎么办：输入 why）"),
    "card.below_with_next": ("{here}. Type: {next}", "意思：{here}。可以输入：{next}"),
    "card.means": ("What it means", "是什么意思"),
    "card.here": ("Why here", "为什么会这样"),
    "card.unknown": (
        "I could not find the cause here; check in this order:",
        "我在这里没有找到原因，请按顺序检查：",
    ),
    "card.checks": ("What to check", "检查什么"),
    "card.next": ("Type next", "接着输入"),
    "card.robot": ("On a real robot", "真机上"),
    "card.exam": (
        "There are no cards in an exam. You can use the lesson's hints (F5, then h), but they are counted",
        "考试里没有卡片。课程窗口里的提示（先按 F5，再按 h）可以看，会记下来",
    ),
    "card.none": (
        "There is no card for this. {explain} lists the cards",
        "这句话没有卡片。输入 {explain} 看有哪些卡片",
    ),
    "card.nothing": (
        "There is no card for anything this terminal has printed lately",
        "这个终端最近的输出里没有需要解释的话",
    ),
    "card.topics": (
        "Cards, by topic. {explain} TOPIC lists one, {explain} 'TEXT' explains a message:",
        "卡片，按主题。{explain} 主题 列出一类，{explain} '一句话' 解释那句话：",
    ),
}

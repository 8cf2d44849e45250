"""The words of the hints, English and Chinese; names in braces are filled in by the rules, groups of a pattern by its numbers."""

from __future__ import annotations

# A rule's key -> English, Chinese.
TEXTS: dict[str, tuple[str, str]] = {
    "home": (
        "{wrong} does not exist: your home folder is {home}. Write {right}, or $HOME{rest}",
        "没有 {wrong}：你的主目录是 {home}。可以写 {right}，或者 $HOME{rest}",
    ),
    "home.python": (
        "{wrong} does not exist: your home folder is {home}. In Python write os.path.expanduser('{right}')",
        "没有 {wrong}：你的主目录是 {home}。在 Python 里写 os.path.expanduser('{right}')",
    ),
    "home.launch": (
        (
            "{wrong} does not exist: your home folder is {home}. In a launch file write os.path.expanduser('{right}'), or for a "
            "file that setup.py installs: os.path.join(get_package_share_directory('PACKAGE'), 'FOLDER', 'FILE')"
        ),
        (
            "没有 {wrong}：你的主目录是 {home}。在 launch 文件里写 os.path.expanduser('{right}')；如果文件由 setup.py 安装，"
            "就写 os.path.join(get_package_share_directory('包名'), '文件夹', '文件名')"
        ),
    ),
    "not_sourced": (
        "{name} is built, but this terminal does not know it yet. Run: source {setup}",
        "{name} 已经编译好了，但这个终端还不知道它。先运行：source {setup}",
    ),
    "not_built": (
        "{name} is in {folder}, but it has not been built yet. Run: cd {workspace}; colcon build; source install/setup.bash",
        "{name} 在 {folder} 里，但还没有编译。先运行：cd {workspace}; colcon build; source install/setup.bash",
    ),
    "command.near": (
        "there is no command {name}; did you mean {near}?",
        "没有叫 {name} 的命令，是不是想写 {near}？",
    ),
    "folder.src": (
        "this is the folder src: build in {workspace}, or a second build and install will lie about here. Remove those of here",
        "这里是 src 文件夹：要在 {workspace} 里编译，不然这里会多出一套 build 和 install。把这里的删掉",
    ),
    "folder.nothing": (
        "there is no package below this folder. Your workspace is ~/ros2_ws: cd ~/ros2_ws, then build",
        "这个文件夹下面没有功能包。你的工作空间是 ~/ros2_ws：先 cd ~/ros2_ws，再编译",
    ),
    "module.near": (
        "there is no module {name}; did you mean {near}?",
        "没有叫 {name} 的模块，是不是想写 {near}？",
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
    "chinese": (
        "line {line} has a Chinese '{wrong}'. Code needs the English '{right}': switch the input method to English",
        "第 {line} 行用了中文的「{wrong}」，代码里要用英文的「{right}」：把输入法切换成英文再输入",
    ),
    "odd_blank": (
        "line {line} has a blank that is no ordinary one (often copied from a web page): replace it with a normal space",
        "第 {line} 行有一个不是普通空格的空白（多半是从网页复制来的）：把它换成英文空格",
    ),
}

# Pattern of "Kind: message" -> English, Chinese; {0}, {1} … are the groups of the pattern, {line} the line.
PATTERNS: tuple[tuple[str, str, str], ...] = (
    (
        r"SyntaxError: expected ':'",
        "line {line} needs a colon : at its end, as after if, for, while, def and class",
        "第 {line} 行末尾少了冒号 : ，if、for、while、def、class 后面都要有",
    ),
    (
        r"SyntaxError: '(.)' was never closed",
        "the {0} in line {line} is never closed: its partner is missing",
        "第 {line} 行的 {0} 没有关上：少了和它配对的另一半",
    ),
    (
        r"SyntaxError: unmatched '(.)'",
        "line {line} has a {0} too many, or its partner is missing",
        "第 {line} 行多了一个 {0}，或者少了和它配对的另一半",
    ),
    (
        r"SyntaxError: closing parenthesis '(.)' does not match opening parenthesis '(.)'",
        "in line {line} a {1} is closed by {0}: brackets close in pairs",
        "第 {line} 行用 {0} 去关 {1}：括号要成对",
    ),
    (
        r"SyntaxError: unterminated (?:triple-quoted )?(?:f-)?string literal",
        "a text in line {line} has no closing quotation mark",
        "第 {line} 行的字符串少了结尾的引号",
    ),
    (
        r"SyntaxError: Missing parentheses in call to 'print'",
        "print needs parentheses: print(…)",
        "print 后面要有括号：print(…)",
    ),
    (
        r"SyntaxError: .*Maybe you meant '==' ",
        "= in line {line} gives a name a value; to compare two values write ==",
        "第 {line} 行：= 是赋值，比较两个值要写 ==",
    ),
    (
        r"SyntaxError: invalid syntax. Perhaps you forgot a comma",
        "is a comma missing in line {line}, between two values?",
        "第 {line} 行的两个值之间是不是少了逗号？",
    ),
    (
        r"SyntaxError: '(return|yield|await)' outside function",
        "{0} in line {line} is not inside a function: does the line need blanks before it?",
        "第 {line} 行的 {0} 不在函数里面：这一行前面是不是少了空格？",
    ),
    (
        r"IndentationError: expected an indented block after (?:'(\w+)' statement|(\w+) definition) on line (\d+)",
        "line {line} belongs to line {2}: begin it 4 blanks deeper than that one",
        "第 {line} 行属于第 {2} 行：要比它多缩进 4 个空格",
    ),
    (
        r"IndentationError: unexpected indent",
        "line {line} begins deeper than the line before it: take the blanks away until both begin alike",
        "第 {line} 行比上一行缩进得多：去掉多余的空格，让两行对齐",
    ),
    (
        r"IndentationError: unindent does not match",
        "line {line} begins between two depths: it has to begin exactly as deep as an earlier line",
        "第 {line} 行的缩进和前面哪一行都对不上：要和同一层的行对齐",
    ),
    (
        r"TabError: ",
        "line {line} mixes tabs and blanks. Use 4 blanks for each step everywhere",
        "第 {line} 行混用了 Tab 和空格。请每一层都用 4 个空格",
    ),
    (
        r"TypeError: (\w+)\.(\w+)\(\) takes 0 positional arguments but 1 was given",
        "{1} belongs to the class {0}, so it needs self: def {1}(self):",
        "{1} 是类 {0} 的方法，要写上 self：def {1}(self):",
    ),
    (
        r"TypeError: (?:Node\.)?create_(publisher|subscription)\(\) missing .*'qos_profile'",
        "create_{0} also needs the length of its queue as the last argument, e.g. 10",
        "create_{0} 最后还要写队列长度，比如 10",
    ),
    (
        r"TypeError: Expected <class '(\w+)\.(msg|srv)\.\w+\.(\w+)'>, got <class '(str|int|float|bool)'>",
        "only a whole message can be sent: msg = {2}(), then fill in its fields, then publish(msg)",
        "只能发布完整的消息：先写 msg = {2}()，再填它的字段，最后 publish(msg)",
    ),
    (
        r"AssertionError: The '(\w+)' field must be of type 'float'",
        "{0} is a decimal number: write 1.0 instead of 1, or float(…)",
        "{0} 是小数：要写 1.0，不能写 1，也可以用 float(…)",
    ),
    (
        r"AssertionError: The '(\w+)' field must be of type '(int|str|bool)'",
        "{0} has to be of type {1}: {1}(…) makes one",
        "{0} 的类型必须是 {1}：可以用 {1}(…) 转换",
    ),
    (
        r'TypeError: can only concatenate str \(not "(int|float)"\) to str',
        "a number is not a text: write str(…) around it, or an f-string f'… {{x}}'",
        "数字不能直接和文字相加：写 str(…)，或者用 f-string：f'… {{x}}'",
    ),
    (
        r"NotInitializedException: ",
        "rclpy.init() has to come before the first node",
        "要先调用 rclpy.init()，再创建节点",
    ),
    (
        r"ParameterNotDeclaredException: .*: (\S+)$",
        "the node has to declare its parameter first: self.declare_parameter('{0}', VALUE)",
        "节点要先声明参数：self.declare_parameter('{0}', 初始值)",
    ),
    (
        r"RuntimeError: .*callback should be either be callable",
        "hand over the function itself, without (): self.callback and not self.callback()",
        "要把函数本身交出去，后面不写 ()：写 self.callback，不是 self.callback()",
    ),
    (
        r"RCLError: failed to shutdown: rcl_shutdown already called",
        "this is harmless: Ctrl-C has shut rclpy down already. rclpy.try_shutdown() does not complain",
        "这个没关系：Ctrl-C 已经关掉了 rclpy。改用 rclpy.try_shutdown() 就不会报错",
    ),
    (
        r"AttributeError: module '(rclpy)' has no attribute '(node|qos|executors|action|duration|time|parameter)'",
        "import the part itself: import {0}.{1}",
        "要导入这个子模块：import {0}.{1}",
    ),
    (
        r"AttributeError: module '([\w.]+)' has no attribute '(\w+)'. Did you mean: '(\w+)'",
        "{0} has no {1}; did you mean {2}?",
        "{0} 里没有 {1}，是不是想写 {2}？",
    ),
    (
        r"AttributeError: module '(\w+\.\w+)' has no attribute '(main)'",
        "entry_points in setup.py names {0}:main, but that file has no function main",
        "setup.py 的 entry_points 写的是 {0}:main，可是那个文件里没有 main 函数",
    ),
    (
        r"AttributeError: '(\w+)' object has no attribute '(?!_)(\w+)'. Did you mean: '(\w+)'",
        "a {0} has no {1}; did you mean {2}?",
        "{0} 没有 {1}，是不是想写 {2}？",
    ),
    (
        r"KeyError: (.+)$",
        "the dictionary has no key {0}; print(….keys()) shows which it has",
        "字典里没有 {0} 这个键；用 print(….keys()) 看看有哪些",
    ),
    # setup.py and CMakeLists.txt, as colcon shows them
    (
        r"error: package directory '([^']+)' does not exist",
        "setup.py expects the folder {0} beside it: it must have the name of the package",
        "setup.py 旁边要有文件夹 {0}：它的名字要和包名一样",
    ),
    (
        r"error: can't copy '([^']+)': doesn't exist",
        "data_files in setup.py names {0}, but there is no such file",
        "setup.py 的 data_files 里写了 {0}，可是没有这个文件",
    ),
    (
        r"error in (\S+) setup command: .*(?:[Ee]ntry ?[Pp]oint|entry_points)",
        "an entry of entry_points in setup.py is not written as 'name = package.file:main'",
        "setup.py 的 entry_points 里有一行没写成 '名字 = 包名.文件名:main'",
    ),
)

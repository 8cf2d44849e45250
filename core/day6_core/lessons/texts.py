"""What checks and actions say, in English and Chinese."""

from __future__ import annotations

from typing import Any

from day6_core.language import said
from day6_core.lessons.grading.texts import GRADING
from day6_core.lessons.office_texts import OFFICE


class Say:
    """A text of the table with its values; a value may be another one, or several."""

    __slots__ = ("key", "values")

    def __init__(self, key: str, **values: Any) -> None:
        self.key = key
        self.values = values

    def text(self, language: str) -> str:
        """In 'zh' or 'en'. Where a value is empty, the text may have another form, `<key>.none`."""
        key = self.key
        if f"{key}.none" in TEXTS and any(value in ((), []) for value in self.values.values()):
            key = f"{key}.none"
        return said(TEXTS[key], language).format(
            **{name: _written(value, language) for name, value in self.values.items()}
        )

    def __eq__(self, other: object) -> bool:
        return isinstance(other, Say) and (self.key, self.values) == (other.key, other.values)

    def __hash__(self) -> int:
        return hash((self.key, tuple(map(str, self.values.items()))))

    def __repr__(self) -> str:
        return f"<{self.key}: {self.text('en')}>"


def _written(value: Any, language: str) -> Any:
    if isinstance(value, Say):
        return value.text(language)
    if isinstance(value, (tuple, list)):
        texts = [str(_written(each, language)) for each in value]
        if texts:
            sentences = any(isinstance(each, Say) for each in value)
            joints = ("；", "; ") if sentences else ("、", ", ")
            return joints[language != "zh"].join(texts)
        return "（没有）" if language == "zh" else "(none)"
    return value


TEXTS: dict[str, tuple[str, str]] = {
    "check.failed": (
        "the check '{name}' itself failed ({reason}), so the result is unknown. You can skip this step",
        "检查“{name}”自己出错了（{reason}），所以无法判断。这一步可以先跳过",
    ),
    "check.not": ("not: {inner}", "不能是：{inner}"),
    "check.any": ("one of: {inner}", "下面做到一条就行：{inner}"),
    "check.waiting": ("not known yet", "还不知道"),
    # The graph
    "node": ("the node {name} is running", "节点 {name} 在运行"),
    "node.count": ("{count} nodes {name} are running", "有 {count} 个 {name} 节点在运行"),
    "node.saw": ("There is no node {name}; there are: {nodes}.", "没有节点 {name}，现在有：{nodes}。"),
    "node.saw.none": ("There is no node {name}, or any other node.", "没有节点 {name}，现在一个节点也没有。"),
    "node.saw_count": ("There are {found} of them.", "现在有 {found} 个。"),
    "no_node": ("the node {name} has stopped", "节点 {name} 不再运行"),
    "no_node.saw": ("The node {name} is still running.", "节点 {name} 还在运行。"),
    "topic": ("the topic {name} exists", "要有话题 {name}"),
    "topic.type": ("the topic {name} has the type {type}", "话题 {name} 的类型是 {type}"),
    "topic.ends": (
        "the topic {name} has at least {publishers} publishers and {subscribers} subscribers",
        "话题 {name} 至少有 {publishers} 个发布者和 {subscribers} 个订阅者",
    ),
    "topic.saw": ("There is no topic {name}; there are: {topics}.", "没有话题 {name}，现在有：{topics}。"),
    "topic.saw.none": ("There is no topic {name}, or any other topic.", "没有话题 {name}，现在一个话题也没有。"),
    "topic.saw_type": ("Its type is {types}.", "现在的类型是 {types}。"),
    "topic.saw_ends": (
        "There are {publishers} publishers and {subscribers} subscribers.",
        "现在有 {publishers} 个发布者、{subscribers} 个订阅者。",
    ),
    "no_topic": ("there is no topic {name}", "不再有话题 {name}"),
    "no_topic.saw": ("{nodes} still use it.", "{nodes} 还在用它。"),
    "service": ("a server offers the service {name}", "要有节点提供服务 {name}"),
    "service.saw": ("Nobody offers {name}.", "现在没有节点提供 {name}。"),
    "action": ("a server offers the action {name}", "要有节点提供动作 {name}"),
    "publishers": ("exactly {count} nodes publish {topic}", "正好有 {count} 个节点在发布 {topic}"),
    "publishers.saw": ("{found} publish: {nodes}.", "现在有 {found} 个在发布：{nodes}。"),
    "publishers.saw.none": ("Nobody publishes it.", "现在没有节点在发布。"),
    "parameter": ("the parameter {name} of {node} is {value}", "{node} 的参数 {name} 是 {value}"),
    "parameter.saw": ("It is {found}.", "现在是 {found}。"),
    "parameter.no_node": ("There is no node {node}.", "没有节点 {node}。"),
    "parameter.silent": ("{node} doesn't answer.", "{node} 没有回答。"),
    "transform": ("the transform from {to} to {frame} is known", "知道 {to} 到 {frame} 的坐标变换"),
    "transform.saw": ("It isn't known; frames: {frames}.", "还不知道；现有的坐标系：{frames}。"),
    "transform.saw.none": ("It isn't known; there are no frames.", "还不知道；现在一个坐标系也没有。"),
    # Messages
    "message": ("a message on {topic}", "话题 {topic} 上有一条消息"),
    "message.count": ("{count} messages on {topic}", "话题 {topic} 上有 {count} 条消息"),
    "message.field": ("a message on {topic} with {field} {how}", "话题 {topic} 上有一条消息，其中 {field} {how}"),
    "message.field_count": (
        "{count} messages on {topic} with {field} {how}",
        "话题 {topic} 上有 {count} 条消息，其中 {field} {how}",
    ),
    "message.equals": ("= {value}", "等于 {value}"),
    "message.above": ("above {value}", "大于 {value}"),
    "message.below": ("below {value}", "小于 {value}"),
    "message.matches": ("like {value}", "含有 {value}"),
    "message.saw": (
        "{found} so far; the last one had {field} = {value}.",
        "到现在 {found} 条；最后一条的 {field} = {value}。",
    ),
    "message.by": ("{inner}, sent by {nodes}", "{inner}，由 {nodes} 发出"),
    "message.saw_others": (
        "Such a message came, but from {sender}.",
        "来过这样的消息，不过是 {sender} 发的。",
    ),
    "message.saw_none": ("No message on {topic} yet.", "{topic} 上还没有消息。"),
    "message.saw_count": ("{found} so far.", "到现在 {found} 条。"),
    "message.no_field": ("Its messages have no field {field}.", "它的消息里没有字段 {field}。"),
    "rate": ("{topic} has at least {least} messages per second", "{topic} 每秒至少 {least} 条消息"),
    "rate.most": (
        "{topic} has {least} to {most} messages per second",
        "{topic} 每秒有 {least} 到 {most} 条消息",
    ),
    "rate.saw": ("Measured: {rate} per second.", "量到的是每秒 {rate} 条。"),
    "rate.saw_none": ("Nothing arrives.", "没有消息到达。"),
    "turned": ("the joint {joint} has turned by {least} rad", "关节 {joint} 一共转过 {least} 弧度"),
    "turned.saw": ("It has turned by {found} rad.", "到现在转了 {found} 弧度。"),
    "turned.saw_names": ("/joint_states names: {names}.", "/joint_states 里的名字是：{names}。"),
    "turned.saw_names.none": ("/joint_states names no joint.", "/joint_states 里一个名字也没有。"),
    "moved": ("the position on {topic} has moved by {least} m", "{topic} 报告的位置一共移动 {least} 米"),
    "moved.saw": ("It has moved by {found} m.", "到现在移动了 {found} 米。"),
    # Terminals
    "ran": ("a command like `{line}` was run", "运行 `{line}` 这样的命令"),
    "ran.with": ("a command with `{line}` in it was run", "运行带 `{line}` 的命令"),
    "ran.status": ("{inner} without an error", "{inner}，不出错"),
    "ran.status_is": ("{inner} and ended with status {status}", "{inner}，退出状态是 {status}"),
    "ran.prints": ("{inner} and printed {prints}", "{inner}，打印出 {prints}"),
    "ran.part": ("{inner}, and only a part of its list was shown", "{inner}，只显示其中一部分"),
    "ran.new": ("{inner}, in a new terminal", "在新开的终端里{inner}"),
    "ran.saw_nothing_new": ("No command has been run in a new terminal yet.", "新开的终端里还没有运行过命令。"),
    "ran.saw_last": ("The last command was `{line}`", "最后一条命令是 `{line}`"),
    "ran.saw_nothing": ("No command has been run yet.", "还没有运行过命令。"),
    "ran.saw_status": (
        "It ended with status {status}; 0 means success.",
        "它结束时的退出状态是 {status}；0 才表示顺利。",
    ),
    "ran.saw_prints": ("It didn't print that.", "它打印的内容里没有这个。"),
    "ran.saw_running": ("It is still running.", "它还在运行。"),
    "running": ("`{line}` is running in a terminal", "要有一个终端正在运行 `{line}`"),
    "running.saw": ("Running now: {lines}.", "现在正在运行：{lines}。"),
    "running.saw.none": ("Nothing is running.", "现在什么也没有运行。"),
    "visited": ("a terminal has been in {path}", "终端去过 {path}"),
    "visited.back": ("a terminal has been in {path} and came back to {back}", "终端去过 {path}，又回到 {back}"),
    "terminals": ("{count} terminals are open", "要打开 {count} 个终端"),
    "terminals.saw": ("There are {found}.", "现在有 {found} 个。"),
    "window": ("the window {kind} is open", "要打开窗口“{kind}”"),
    "window.inspector": ("Inspector (F6)", "检查（F6）"),
    "window.kitchen": ("Kitchen", "厨房"),
    "window.saw": ("Open windows: {kinds}.", "开着的窗口：{kinds}。"),
    "window.saw.none": ("No window is open.", "现在一个窗口也没有开。"),
    "environment": ("a terminal has {name} like {value}", "要有一个终端，它的 {name} 是 {value} 这样的"),
    "environment.saw": ("{name} is: {values}.", "{name} 现在是：{values}。"),
    "sourced": ("a terminal knows the package {name} (sourced)", "要有一个终端认识功能包 {name}（source 过）"),
    "sourced.saw": ("No terminal has it on its path.", "现在没有一个终端认识它。"),
    "environment.saw.none": ("No terminal has {name}.", "现在没有一个终端有 {name}。"),
    # Files
    "file": ("the file {path} exists", "要有文件 {path}"),
    "file.has": ("{path} contains: {pattern}", "{path} 里要有：{pattern}"),
    "file.lacks": ("{path} doesn't contain: {pattern}", "{path} 里不能有：{pattern}"),
    "file.saw_none": ("There is no {path}.", "现在还没有 {path}。"),
    "file.saw_not": ("It isn't in there.", "里面还没有。"),
    "file.saw_still": ("It is still in there.", "里面还有。"),
    "missing": ("{inner} (not yet)", "{inner}（现在还没有）"),
    "file.unread": ("{path} cannot be read: {reason}.", "{path} 读不了：{reason}。"),
    "folder": ("the folder {path} exists", "要有文件夹 {path}"),
    "no_file": ("{path} doesn't exist", "不再有 {path}"),
    "no_file.saw": ("{path} is still there.", "{path} 还在。"),
    "package": ("the package {name} is in {folder}", "{folder} 里要有功能包 {name}"),
    "package.type": ("its build type is {type}", "它的构建类型是 {type}"),
    "package.depends": ("its package.xml depends on {names}", "它的 package.xml 依赖 {names}"),
    "package.saw": ("There are: {names}.", "现在有：{names}。"),
    "package.saw.none": ("There are none.", "现在一个也没有。"),
    "package.saw_deeper": ("It is in {path}, one level too deep.", "它在 {path}，多嵌套了一层。"),
    "package.saw_twice": (
        "It exists more than once: {paths}. Move the old ones out of src, for example with mv.",
        "同名的功能包不止一个：{paths}。把旧的从 src 里移出去，比如用 mv。",
    ),
    "package.saw_type": ("It is {type}.", "现在是 {type}。"),
    "package.saw_missing": ("Missing: {names}.", "还缺：{names}。"),
    "package.bad": ("Its package.xml cannot be read: {reason}.", "它的 package.xml 读不了：{reason}。"),
    "entry_point": (
        "setup.py of {package} names the executable {name}",
        "{package} 的 setup.py 里要写可执行文件 {name}",
    ),
    "entry_point.to": (
        "setup.py of {package} has '{name} = {to}'",
        "{package} 的 setup.py 里要有“{name} = {to}”",
    ),
    "entry_point.saw": ("It names: {names}.", "里面写的是：{names}。"),
    "entry_point.saw.none": ("It names none yet.", "里面还一个也没写。"),
    "built": ("the package {name} has been built since its last change", "功能包 {name} 改完以后要编译过"),
    "built.saw_never": ("It hasn't been built.", "还没有编译过。"),
    "built.saw_failed": ("Its last build failed.", "上一次编译没有成功。"),
    "built.saw_old": ("{path} was changed after the build.", "编译之后又改过 {path}。"),
    # The robot
    "urdf": ("{path} is a robot that check_urdf accepts", "{path} 要能通过 check_urdf"),
    "urdf.saw": ("{reason}", "{reason}"),
    "urdf.name": ("the robot in {path} is called {name}", "{path} 里的机器人要叫 {name}"),
    "urdf.links": ("{path} has the links {names}", "{path} 里要有 link：{names}"),
    "urdf.joints": ("{path} has the joints {names}", "{path} 里要有 joint：{names}"),
    "urdf.has": ("It has: {names}.", "现在有：{names}。"),
    "urdf.has.none": ("It has none.", "现在一个也没有。"),
    "urdf.joint": ("the joint {joint} has {what} {value}", "关节 {joint} 的 {what} 是 {value}"),
    "urdf.joint_saw": ("It is {found}.", "现在是 {found}。"),
    "description": ("a robot is published on /robot_description", "/robot_description 上要有机器人"),
    "description.joints": (
        "the robot on /robot_description has the joints {names}",
        "/robot_description 上的机器人要有关节 {names}",
    ),
    "description.saw_none": ("Nothing has been published there.", "那里还什么也没有。"),
    "rviz": ("RViz is open", "要打开 RViz"),
    "rviz.frame": ("RViz's Fixed Frame is {frame}", "RViz 的 Fixed Frame 要是 {frame}"),
    "rviz.display": ("RViz shows {display}", "RViz 里要显示 {display}"),
    "rviz.status": ("RViz's {display} has the status {status}", "RViz 里 {display} 的状态要是 {status}"),
    "rviz.saw_frame": ("It is {frame}.", "现在是 {frame}。"),
    "rviz.saw_displays": ("Its displays: {displays}.", "现在显示的有：{displays}。"),
    "rviz.saw_displays.none": ("It shows nothing.", "现在什么也没有显示。"),
    "rviz.saw_status": ("It is {status}: {reason}.", "现在是 {status}：{reason}。"),
    "rviz.saw_none": ("RViz isn't open.", "RViz 还没有打开。"),
    # Drawing
    "trail": ("{turtle} has drawn a {shape}", "{turtle} 要画出{shape}"),
    "trail.driven": (
        "{turtle} has drawn a {shape} by driving, without teleports",
        "{turtle} 要靠行驶画出{shape}，不能用 teleport 挪动",
    ),
    "shape.pentagram": ("pentagram", "五角星"),
    "shape.square": ("square", "正方形"),
    "shape.triangle": ("triangle", "等边三角形"),
    "shape.circle": ("circle", "圆"),
    "shape.closed": ("closed figure", "闭合的图形"),
    "trail.saw_none": ("TurtleSim isn't open.", "海龟的窗口还没有打开。"),
    "trail.saw_little": ("There is no straight line yet.", "还没有画出直线。"),
    "trail.saw_legs": (
        "The last straight lines: {lengths} m long, turned by {turns} degrees in between.",
        "最后几条直线长 {lengths} 米，中间转了 {turns} 度。",
    ),
    "trail.saw_jumps": (
        "Within the drawing it was put elsewhere by a teleport service {count} times.",
        "画的时候，它被 teleport 服务挪动了 {count} 次。",
    ),
    "trail.where": (
        "corner {corner}: asked ({x}, {y}) ± {slack} m, seen ({seen_x}, {seen_y}) after {seconds} s",
        "第 {corner} 个角：应在 ({x}, {y}) ± {slack} 米，实际在 ({seen_x}, {seen_y})，第 {seconds} 秒",
    ),
    "trail.where_none": (
        "corner {corner}: asked ({x}, {y}) ± {slack} m, the drawing ends before it",
        "第 {corner} 个角：应在 ({x}, {y}) ± {slack} 米，还没画到",
    ),
    "trail.saw_open": ("The ends are {gap} m apart.", "起点和终点还差 {gap} 米。"),
    "trail.saw_round": ("It isn't round.", "还不圆。"),
    # Answers and programs of a lesson
    "answer": ("the right answer is chosen", "选对答案"),
    "answer.saw": ("You chose {letter}.", "你选的是 {letter}。"),
    "python": ("{name} finds nothing wrong", "{name} 检查过，没有问题"),
    "python.wanted": ("{en}", "{zh}"),
    "python.running": ("Checking …", "正在检查……"),
    "python.silent": ("It ended and printed nothing.", "它结束了，什么也没有打印。"),
    "python.saw": ("{en}", "{zh}"),
    "python.late": ("It didn't answer within {seconds} s.", "它在 {seconds} 秒里没有回答。"),
    "python.missing": ("There is no file {name} beside the lesson.", "课程旁边没有文件 {name}。"),
    **GRADING,
    **OFFICE,
}

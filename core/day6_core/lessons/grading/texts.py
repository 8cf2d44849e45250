"""What `day6-tui grade` says of a submission, in English and Chinese."""

from __future__ import annotations

GRADING: dict[str, tuple[str, str]] = {
    # Checks of hidden scenarios
    "talks": ("the node {node} publishes {topic}", "节点 {node} 发布 {topic}"),
    "talks.saw": ("It is published by: {nodes}.", "现在发布它的是：{nodes}。"),
    "talks.saw.none": ("Nobody publishes it.", "现在没有节点发布它。"),
    "listens": ("the node {node} subscribes to {topic}", "节点 {node} 订阅 {topic}"),
    "listens.saw": ("The subscribers are: {nodes}.", "现在订阅它的是：{nodes}。"),
    "listens.saw.none": ("Nobody subscribes to it.", "现在没有节点订阅它。"),
    "changes": (
        "messages on {topic} with at least {count} different values of {field}",
        "{topic} 上的消息，{field} 至少有 {count} 个不同的值",
    ),
    "changes.saw": (
        "{messages} messages had only these different values: {values}.",
        "收到 {messages} 条消息，不同的只有：{values}。",
    ),
    "points": (
        "{to} has turned by {angle} rad relative to {frame}, as /joint_states says",
        "{to} 相对 {frame} 转了 {angle} 弧度，跟 /joint_states 说的一样",
    ),
    "points.saw": ("It has turned by {found} rad.", "现在转了 {found} 弧度。"),
    # Submissions that cannot be read
    "grade.zip.large": ("the file is larger than {megabytes} MB", "文件超过 {megabytes} MB"),
    "grade.zip.unread": ("the file cannot be read: {reason}", "文件读不了：{reason}"),
    "grade.zip.broken": ("not an intact zip file: {reason}", "这不是完好的 zip 文件：{reason}"),
    "grade.zip.many": (
        "it contains {count} files; at most {most} are accepted",
        "里面有 {count} 个文件，最多 {most} 个",
    ),
    "grade.zip.bomb": ("unpacked, it is larger than {megabytes} MB", "解开以后超过 {megabytes} MB"),
    "grade.zip.file_large": ("{name} is larger than {megabytes} MB", "{name} 超过 {megabytes} MB"),
    "grade.zip.link": ("{name} is a link or a device, not a file", "{name} 是链接或设备，不是普通文件"),
    "grade.zip.locked": ("{name} is locked with a password", "{name} 加了密码"),
    "grade.zip.path": (
        "the name {name} leads out of the submission or isn't a file name",
        "名字 {name} 指到了外面，或者不像文件名",
    ),
    "grade.zip.place": ("{name} isn't a place for a pupil's file", "{name} 不是放作业文件的地方"),
    "grade.zip.twice": ("{name} is in it twice", "{name} 在里面有两份"),
    "grade.zip.no_manifest": (
        "it was not made by day6-tui submit: there is no {name}",
        "它不是用 day6-tui submit 打包的：里面没有 {name}",
    ),
    "grade.zip.manifest": ("its description cannot be read: {reason}", "它的说明读不了：{reason}"),
    "grade.zip.newer": ("a newer day6-tui made it (version {version})", "它是更新的 day6-tui 打包的（版本 {version}）"),
    # How it went
    "grade.no_file": ("a file like {patterns} is in the submission", "作业里有像 {patterns} 这样的文件"),
    "grade.no_file_saw": ("There is none.", "没有。"),
    "grade.needs": ("'{name}' has passed", "“{name}”要先通过"),
    "grade.needs_saw": ("It hasn't, so this was not run.", "它没有通过，所以这一项没有运行。"),
    "grade.build": ("the package {name} builds", "功能包 {name} 编译成功"),
    "grade.build_none": ("The submission has no package of this name.", "作业里没有这个名字的功能包。"),
    "grade.build_failed": ("colcon says: {text}", "colcon 说：{text}"),
    "grade.build_late": ("It wasn't finished after {seconds} s.", "{seconds} 秒还没有编译完。"),
    "grade.listener": ("somebody listens to {topic} as {type}", "有节点按 {type} 订阅 {topic}"),
    "grade.listener_saw": ("Nobody does.", "没有。"),
    "grade.service": ("somebody offers the service {name}", "有节点提供服务 {name}"),
    "grade.service_saw": ("There was no answer.", "没有回答。"),
    "grade.action": ("the scenario can be played", "能把这个情景演完"),
    "grade.action_saw": ("{reason}.", "{reason}。"),
    "grade.problem": ("{asked}. {seen}", "{asked}。{seen}"),
    "grade.busy": ("the machine keeps up with the scenario", "机器来得及运行这个情景"),
    "grade.busy_saw": (
        "Too busy twice: everything stood still for up to {seconds} s. Nothing is known of the program; grade again later.",
        "两次都太忙：最长有 {seconds} 秒什么都没有动。程序对不对还不知道，请过一会儿再评。",
    ),
    "grade.both": ("{first} {second}", "{first}{second}"),
    "grade.printed": ("(its last lines: {text})", "（它最后打印的是：{text}）"),
    "grade.answers": ("the questions are answered: {names}", "回答了这些问题：{names}"),
    "grade.answers_saw": (
        "Right: {right} of {all}; not right: {names}.",
        "答对 {right} 题，共 {all} 题；没答对的：{names}。",
    ),
    "grade.answers_title": ("answers to the questions", "问题的回答"),
    # What ended it
    "grade.ended.time": (
        "everything ends within {seconds} s",
        "全部加起来不超过 {seconds} 秒",
    ),
    "grade.ended.time_saw": ("It was ended then.", "到时间就被停掉了。"),
    "grade.ended.processes": ("fewer than {most} processes run", "同时运行的进程少于 {most} 个"),
    "grade.ended.processes_saw": ("There were more and more; all were ended.", "进程越来越多，全部停掉了。"),
    "grade.ended.memory": ("less than {megabytes} MB of memory is used", "占用的内存少于 {megabytes} MB"),
    "grade.ended.memory_saw": ("It used more and was ended.", "它占得更多，被停掉了。"),
    "grade.ended.killed": ("the program leaves the grader alone", "程序不去动评分的进程"),
    "grade.ended.killed_saw": (
        "The grader's process for this submission was ended from inside.",
        "评这份作业的进程被里面的程序停掉了。",
    ),
    "grade.ended.problem": ("the grader itself works", "评分程序自己没有出错"),
    "grade.ended.problem_saw": (
        "It failed, so the result is unknown: {reason}",
        "它出错了，所以这一项无法判断：{reason}",
    ),
}
"""By key: English, Chinese."""

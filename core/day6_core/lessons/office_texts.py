"""What `day6-tui submit`, `report` and `grade` say beside their results, in English and Chinese."""

from __future__ import annotations

OFFICE: dict[str, tuple[str, str]] = {
    # submit
    "submit.done": ("{file}: {contents}", "{file}：{contents}"),
    "submit.answers": ("{count} answers", "{count} 个回答"),
    "submit.left_out": ("left out: {what}", "没有放进去：{what}"),
    "submit.next": ("Give this file to your teacher.", "把这个文件交给老师就好。"),
    "submit.exists": (
        "'{file}' exists and isn't a submission, so it was left unchanged; choose another file with -o",
        "“{file}”已经在那里了，而且不是作业文件，不去动它；请用 -o 换一个文件名",
    ),
    "submit.nothing": (
        "there is nothing to hand in: no package in {source}, no program in {home}, no answers",
        "没有东西可交：{source} 里没有功能包，{home} 里没有程序，也没有回答过问题",
    ),
    "submit.large": (
        "it would be {size} MB, and the limit is {most} MB: move large files out of the packages",
        "会有 {size} MB，最多收 {most} MB：请把大文件移出功能包",
    ),
    "submit.who": (
        "there are several pupils; choose one with --pupil: {names}",
        "这台电脑上有好几位学生，请用 --pupil 说明是谁：{names}",
    ),
    "submit.unknown": (
        "there is no pupil '{name}' here; there are: {names}",
        "这里没有叫“{name}”的学生；有：{names}",
    ),
    "submit.progress": ("the progress of {name} cannot be read: {reason}", "读不了 {name} 的学习进度：{reason}"),
    "submit.strange": ("{path} isn't an ordinary file", "{path} 不是普通文件"),
    "submit.name": ("{path} has a name that no submission may have", "{path} 的文件名不能放进作业"),
    "submit.file_large": ("{path} is larger than {most} MB", "{path} 超过 {most} MB"),
    "submit.many": ("{path}: only {most} loose files are packed", "{path}：最多放 {most} 个零散文件"),
    "name.empty": ("the name is empty", "名字是空的"),
    "name.long": ("the name is too long", "名字太长"),
    "name.control": ("the name has a character that cannot be displayed", "名字里有显示不出来的字符"),
    # Files that are written
    "office.exists": ("{file} already exists; --force overwrites it", "{file} 已经在那里了；加上 --force 就会覆盖它"),
    "office.written": ("{file} written", "写好了 {file}"),
    "office.failed": ("{file}: {reason}", "{file}：{reason}"),
    # report
    "report.title": ("Pupils' progress", "学生的学习进度"),
    "report.none": (
        "no pupil has done a lesson on this machine yet ({folder})",
        "这台电脑上还没有学生上过课（{folder}）",
    ),
    "report.pupil": ("pupil", "学生"),
    "report.lesson": ("lesson", "课程"),
    "report.solved": ("solved", "完成"),
    "report.passed_over": ("skipped", "跳过"),
    "report.hints": ("hints", "提示"),
    "report.refused": ("wrong", "答错"),
    "report.minutes": ("minutes", "分钟"),
    "report.last": ("last solved", "最近完成"),
    "report.never": ("never", "还没有"),
    "report.drills": ("drills", "排错练习"),
    "report.not_there": ("{name} (not among the current lessons)", "{name}（现在没有这一课）"),
    "report.made": ("Made {when} from {folder}.", "{when} 根据 {folder} 生成。"),
    "report.honest": (
        "Anybody can edit progress files: to grade, use day6-tui grade on the submissions.",
        "进度文件谁都可以改：要评分，请用 day6-tui grade 检查作业。",
    ),
    "report.broken": ("{file} cannot be used and was left out: {reason}", "{file} 用不了，没有算进去：{reason}"),
    "report.of_steps": ("{name} (of {steps})", "{name}（共 {steps} 步）"),
    "report.others": ("other lessons", "其他课程"),
    "report.unread": ("not read", "没读的文件"),
    "report.unread.large": ("too large", "文件太大"),
    "report.unread.many": ("too many files, or too deep", "文件太多，或者目录太深"),
    "report.unread.strange": ("not a file, but a link, a pipe or a folder", "不是普通文件，而是链接、管道或文件夹"),
    "report.class_none": (
        "{folder} is not the folder of a class: day6-tui serve --data {folder} has kept nothing there",
        "{folder} 不是班级文件夹：day6-tui serve --data {folder} 没有在那里保存过东西",
    ),
    "report.class_here": (
        "{folder} is the folder of a class, not a home folder: day6-tui report --data {folder}",
        "{folder} 是班级文件夹，不是主目录：请用 day6-tui report --data {folder}",
    ),
    "report.closed": (
        "the homes belong to other users (serve --isolation users): run this as the user who runs the server, root",
        "这些主目录属于别的用户（serve --isolation users）：请用运行服务器的用户（root）来运行",
    ),
    "report.windows": (
        "the folder of a class can only be read on Linux and macOS, where day6-tui serve runs",
        "班级文件夹只能在 Linux 和 macOS 上读取，day6-tui serve 也在那里运行",
    ),
    # grade
    "grade.not_collected": ("{name}: {reason}", "{name}：{reason}"),
    "grade.never_came": ("has never come", "从来没来过"),
    "grade.title": ("Submissions in hidden scenarios", "作业在隐藏情景下的表现"),
    "grade.file": ("file", "文件"),
    "grade.calls_itself": ("calls itself", "自称"),
    "grade.scenario": ("scenario", "情景"),
    "grade.mark": ("mark", "评定"),
    "grade.mark.right": ("right", "正确"),
    "grade.mark.wrong": ("wrong", "不对"),
    "grade.mark.late": ("ran out of time", "时间不够"),
    "grade.mark.unplayed": ("not played", "没有运行"),
    "grade.points": ("{points} of {most}", "{points}/{most}"),
    "grade.points_open": ("{points}; not played: {count}", "{points}，没有运行：{count}"),
    "grade.points_head": ("points", "得分"),
    "grade.remark": ("remark", "老师的话"),
    "grade.refused": ("refused", "没有收"),
    "grade.asked": ("asked", "要求"),
    "grade.seen": ("seen", "看到"),
    "grade.where": ("where they differ", "差在哪里"),
    "grade.held": ("held from", "从何时起成立"),
    "grade.line": ("{file}  {pupil}  {points}", "{file}  {pupil}  得分 {points}"),
    "grade.line_scenario": ("{name}: {title}  [{mark}, {points}]", "{name}：{title}  [{mark}，{points}]"),
    "grade.line_asked": ("asked: {text}", "要求：{text}"),
    "grade.line_seen": ("seen:  {text}", "看到：{text}"),
    "grade.line_where": ("where: {text}", "差在：{text}"),
    "grade.line_remark": ("Remark: {text}", "老师的话：{text}"),
    "grade.again": (
        "the machine was too busy for {count} submissions: these are played once more, one at a time",
        "评 {count} 份作业时这台机器太忙：现在一份一份再评一次",
    ),
    "grade.remarks_unread": (
        "'{file}' cannot be read as a table of marks. There may be words of yours in it, so it was left unchanged",
        "“{file}”不像评分表，读不了；里面可能有你写的话，所以没有动它",
    ),
    "grade.line_refused": ("{file}  refused: {reason}", "{file}  没有收：{reason}"),
    "grade.total": (
        "{count} submissions in {seconds} s, {jobs} at a time (--seed {seed} repeats exactly this run)",
        "{count} 份作业，用了 {seconds} 秒，同时评 {jobs} 份（--seed {seed} 可以再评一次同样的）",
    ),
    "grade.nothing": ("no such submission: {names}", "没有作业：{names}"),
    "grade.no_lesson": (
        "there are no scenarios for '{name}', only for: {names}",
        "没有“{name}”的隐藏情景；有：{names}",
    ),
    "grade.no_scenarios": ("there is no scenario in {folder}", "{folder} 里没有情景文件"),
    "grade.windows": (
        "submissions cannot be graded on Windows, which cannot limit their programs; use Linux or WSL",
        "Windows 上不能评作业：那里没有办法限制作业里的程序；请用 Linux 或 WSL",
    ),
    "grade.weak": (
        "warning: this system gives users no namespaces: programs in submissions can read, change and end anything of yours",
        "注意：这个系统不让用户建立命名空间，作业里的程序能读、能改、能停掉属于你的东西；请在没有重要文件的账号下评分",
    ),
    "grade.root": (
        "warning: as others cannot go into {folder}, programs of submissions ran as root and could read all: use /opt/day6-tui",
        "注意：别的用户进不了 {folder}，作业里的程序是以 root 身份运行的，什么都能读：请把 day6-tui 装到 /opt/day6-tui",
    ),
    "grade.stopped": ("stopped", "停止了"),
}
"""By key: English, Chinese."""

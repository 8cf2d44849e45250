"""卸载。"""

TEXTS = {
    "uninstall.files_alone": "--files 要和 --data 一起用",
    "uninstall.ours": "day6-tui 写的；day6-tui uninstall --data 会删除：",
    "uninstall.user": "你的文件；会保留，除非再加上 --files：",
    "uninstall.ros": "和真正的 ROS 共用；总是保留：",
    "uninstall.kept": "你的文件都保留着：",
    "uninstall.nothing": "没有",
    "uninstall.named": (
        "你自己指定的文件夹不在其中：--home、serve --data 和 wheelhouse 的文件夹，录像，bag，\n"
        "以及项目里的 .vscode、.idea 和 .env。"
    ),
    "uninstall.runs": "什么都没有删除，因为 day6-tui 正在运行：{what}。请先结束它",
    "uninstall.inside": "这是桌面里的终端，~ 是另一个文件夹：请在真正的终端里输入",
    "uninstall.comma": "、",
    "uninstall.runs.program": "域 {domain} 里的进程 {pid}",
    "uninstall.runs.desktop": "一个已分离的桌面（day6-tui attach，再按 ^Q）",
    "uninstall.runs.server": "班级服务器（day6-tui serve）",
    "uninstall.nobody": "没有可以询问的终端：加上 --yes 就不询问，直接删除",
    "uninstall.data.these": "将要删除：",
    "uninstall.data.ask": "删除以上 {size}？[y/N]",
    "uninstall.data.none": "没有需要删除的 day6-tui 数据。",
    "uninstall.data.done": "已删除：{size}。",
    "uninstall.files.these": "你的文件，删除后无法恢复：",
    "uninstall.files.ask": "也要删除你的文件（{size}）吗？[y/N]",
    "uninstall.files.none": "没有你的文件。",
    "uninstall.files.done": "已删除你的文件：{size}。",
    "uninstall.left": "什么都没有删除。",
    "uninstall.foreign": "没有动它，不是 day6-tui 写的：{path}",
    "uninstall.package": "删除安装包：",
    "uninstall.checkout": "它在你自己的文件夹里运行，这个文件夹会保留：{folder}",
}

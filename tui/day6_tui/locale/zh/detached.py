"""A desktop that outlives its terminal."""

TEXTS = {
    "detached.asked": "已暂离：用 {command} 回来",
    "detached.taken": "已暂离，因为另一个终端接管了桌面：用 {command} 回来",
    "detached.none": "没有用 {command} 启动的桌面在运行",
    "detached.runs": "桌面已经在运行：用 {command} 进入",
    "detached.started": "桌面在运行：用 {command} 进入",
    "detached.lost": "桌面的守护进程结束了，桌面也随之结束；输入过的内容和布局都保存着",
    "detached.inside": "这里就是那个桌面的终端",
    "detached.no_terminal": "attach 需要一个终端",
    "detached.windows": "--detach 和 attach 需要伪终端，Windows 上没有",
}

"""Panes, their places, and the session that is opened again."""

TEXTS = {
    "help.panes": "Alt+←↑↓→\t到那一边的窗格\nAlt+1 … 9\t到这个编号的窗格\nShift+Alt+←\t以及 ↑ ↓ →：移动边界\n"
    "鼠标\t拖边界改大小，拖标题挪窗格，双击标题放大",
    "help.option": (
        "Option\t就是别的键盘上的 Alt：去别的窗格、拆分窗格，但要先让终端把它发出来（“终端”：设置、描述文件、键盘、"
        "将 Option 键用作 Meta 键）。F4 和 F7 也做得到"
    ),
    "drop.told": "{name}：松开鼠标，放到{where}",
    "drop.left": "{name} 的左边",
    "drop.right": "{name} 的右边",
    "drop.above": "{name} 的上面",
    "drop.below": "{name} 的下面",
    "drop.tab": "{name} 的位置，叠成标签页",
    "layout.name": "给这个布局起个名字",
    "layout.no_name": "得有个名字",
    "layout.saved": "布局已保存：{name}",
    "layout.own": "自己保存的",
    "layout.foreign": "不是版本 {version} 的布局文件",
    "layout.unreadable": "{file}：{reason}",
    "session.title": "接着上次继续",
    "session.ask": "上次离开的时候，这些程序正在运行。要重新启动吗？\n\n{what}",
    "session.back": "不启动",
    "session.start": "重新启动",
    "session.restored": "以上是 {when} 的内容",
    "session.not_kept": "布局和终端没能保存：{reason}",
    "session.foreign": "不是这个版本保存的，文件原样留着",
}

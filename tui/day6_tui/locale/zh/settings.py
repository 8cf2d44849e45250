"""Settings."""

TEXTS = {
    "theme.title": "配色",
    "theme.dark": "深色",
    "theme.light": "浅色",
    "theme.contrast": "高对比度",
    "theme.colourblind": "色盲也能分清",
    "settings.fault": "{path} 读不出来，先原样留着：{reason}",
    "settings.not_kept": "这次的选择没能保存，只在退出前有效：{reason}",
    "distro.title": "ROS 2 发行版",
    "distro.next_start": "下次打开 day6-tui 时就是 {name}（day6-tui --distro {name}）",
}

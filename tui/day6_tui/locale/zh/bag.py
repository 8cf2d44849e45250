"""rqt_bag."""

TEXTS = {
    "bag.none": "没有打开的 bag：按 o 打开一个。",
    "bag.cut": "'{name}' 不完整：能读到的部分都显示在这里。",
    "bag.cancelled": "已取消：'{name}' 只显示已经读到的部分。",
    "bag.empty": "'{name}' 里没有消息。",
    "bag.messages": "{count} 条消息",
    "bag.open": "打开",
    "bag.open.title": "打开 bag",
    "bag.open.note": "bag 的文件夹，或其中的文件（.mcap、.db3）。",
    "bag.play": "播放",
    "bag.pause": "暂停",
    "bag.publish": "发布",
    "bag.unpublish": "停止发布",
    "bag.publish_all": "全部发布、全不发布",
    "bag.speed": "快些、慢些",
    "bag.step": "上一条、下一条消息",
    "bag.choose": "选择话题",
    "bag.pan": "移动视野",
    "bag.scrub": "移动播放头",
    "bag.zoom": "放大、缩小",
    "bag.fit": "看全部",
    "bag.ends": "到开头、到结尾",
    "bag.region": "从这里选起、选到这里",
    "bag.no_region": "取消选择",
    "bag.open.other": "其他……",
    "bag.view": "消息",
    "bag.no_message": "播放头之前没有消息",
    "bag.panel": "到消息的字段、返回",
    "bag.timeline": "回到时间线",
    "bag.open_field": "展开、收起",
    "bag.plot": "画曲线",
    "bag.thumbnails": "图像缩略图",
    "bag.record": "录制",
    "bag.record.title": "新 rosbag 的名字",
    "bag.record.topics": "选择要录制的话题",
    "bag.recording": "录制中：{count} 条消息，{size}；按 r 停止",
    "bag.recording_paused": "录制已暂停：{count} 条消息，{size}；按空格继续",
    "bag.stop_recording": "停止录制",
    "bag.hold_recording": "暂停、继续",
    "bag.save": "导出选中的一段",
    "bag.save.title": "保存选中的一段……",
    "bag.save.topics": "导出哪些话题？",
    "bag.name.note": "一个新文件夹：不会覆盖任何东西。",
    "bag.name.none": "需要一个名字。",
    "bag.all": "全部",
    "bag.tick": "勾选",
    "bag.go_on": "继续",
    "bag.cancel": "取消",
    "bag.menu": "菜单",
    "bag.menu.publish": "发布",
    "bag.menu.unpublish": "停止发布",
    "bag.menu.publish_all": "全部发布",
    "bag.menu.publish_none": "全不发布",
    "bag.menu.view": "查看消息",
    "bag.menu.thumbnails": "缩略图",
    "bag.menu.reset": "重置时间线",
    "bag.menu.save": "保存 bag",
    "bag.menu.open": "打开 bag",
    "bag.menu.record": "录制 bag",
    "help.rqt_bag": (
        "时间线上的 bag：每个话题一行，消息越多，柱越高。红色的竖线是播放头。\n\n"
        "勾选一个话题（Enter），它的消息就会发布，服务质量与录制时相同：播放头移到哪里，就发布那里最新的一条；"
        "播放时发布每一条。所以 Plot 和 RViz 跟着播放头走。（真正的 rqt_bag 只在播放时发布。）"
        "坐标系要往回走，RViz 得按 bag 的时钟走：rqt_bag 加 --clock，RViz 设 use_sim_time。\n\n"
        "在时间线上点击或拖动来移动播放头，在标尺上拖动来选择一段，滚轮缩放，按中键或 Shift 拖动来移动视野。"
        "播放在选中的一段里循环，没有选择时在全部里循环。打开 bag 只读索引：很大的也马上打开。\n\n"
        "v 在下面显示选中话题在播放头处的消息或图像；Tab 到它的字段，那里按 g 输入画这个字段的命令。"
        "w 把选中的一段导出成新的 bag，r 录制新的 bag，打开的会关闭。\n\n"
        "按键和真正的 rqt_bag 一样，只有上、下键不同：这里用来选择话题，那里和 Page Up、Page Down 一样是缩放。"
        "rqt 的窗口组合会记住打开的 bag、勾选的话题、选中的一段和视野。"
    ),
}

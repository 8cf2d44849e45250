"""rqt_graph."""

TEXTS = {
    "rqt.hidden": "已隐藏 {count} 个：{reasons}",
    "rqt.hides": "{option} 隐藏了 {names}",
    "rqt.hides_some": "{option} {count} 个",
    "rqt.separator": "；",
    "rqt.nothing_hidden": "没有隐藏任何东西",
    "rqt.empty": "现在没有节点在发布或订阅。",
    "rqt.shown_by": "按 {keys} 显示隐藏的 {count} 个",
    "rqt.type": "类型",
    "rqt.hide": "隐藏",
    "rqt.refresh": "刷新",
    "rqt.choose": "选择",
    "rqt.pan": "移动",
    "rqt.zoom": "缩放",
    "rqt.fit": "适应窗口",
    "rqt.filter": "过滤节点、话题",
    "rqt.namespaces": "命名空间",
    "rqt.group": "合并",
    "rqt.view": "高亮",
    "rqt.files": "保存、打开",
    "rqt.auto": "自动刷新",
    "rqt.node_filter": "节点过滤",
    "rqt.topic_filter": "话题过滤",
    "rqt.filter_note": "写名字或正则表达式，用逗号隔开；前面加 - 表示排除，/ 表示全部。例如：-/rqt.*",
    "rqt.save": "把图保存为",
    "rqt.save_note": ".dot 给 Graphviz 用，.pdf、.svg 或 .png 是图片",
    "rqt.load": "打开 DOT 文件",
    "rqt.load_note": "会代替现在的图显示出来，按 r 刷新后恢复。",
    "rqt.loaded": "来自文件 {name}；按 r 回到现在的图",
    "rqt.node": "{name}：{arriving} 个箭头进来，{leaving} 个出去",
    "rqt.topic": "{name}：{arriving} 个发布者，{leaving} 个订阅者",
    "help.rqt_graph": (
        "谁在和谁说话。圆角框是节点（真正的 rqt_graph 画的是椭圆），箭头和方框是话题。"
        "有消息经过时，一个光点会沿着箭头跑。最下面一行说明过滤器隐藏了什么。\n\n"
        "拖动或方向键：移动。滚轮、+ 和 -：缩放，从完整的名字一直到全景。v（Fit）让整张图回到窗口里，直到你再次移动它。"
        "边上的箭头和数字表示：那个方向的外面还有几个框。点一下框，或者按 j、k，可以选中它，最下面一行会介绍它。\n\n"
        "窗口小得画不下图，就一个箭头写成一行：左边是发布的节点，中间是话题，右边是订阅的节点。放不下选项的时候，"
        "最下面一行说按哪个键能把隐藏的显示出来。"
    ),
}

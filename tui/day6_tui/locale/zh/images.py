"""rqt_image_view and showimage."""

TEXTS = {
    "images.none": "还没有发布图像（sensor_msgs/msg/Image）的话题。先启动一个相机。",
    "images.choose": "按 t 选一个话题。",
    "images.no_topic": "没有人发布 {topic}。",
    "images.waiting": "正在等 {topic} 上的图像。",
    "images.topic": "话题",
    "images.fit": "适应窗口",
    "images.zoom_1": "1:1",
    "images.rotate": "旋转",
    "images.rotate_back": "向左旋转",
    "images.save": "保存",
    "images.save_title": "把图像保存为",
    "images.dynamic": "动态范围",
    "images.range": "最大距离",
    "images.range_note": "距离图像里，多少米显示成白色。",
    "images.bad_range": "0.01 到 100 之间的数。",
    "images.mouse": "发布点击位置",
    "help.rqt_image_view": (
        "显示一个话题上的图像。按 t，或者点一下话题的名字，选择有图像的话题。不管来多少图像，每秒只显示最新的几张。\n\n"
        "按 1 显示图像的每个像素，这时用方向键移动看到的部分；再按 1 把整张图放进窗口。r 旋转，R 向左旋转。"
        "下面一行是大小、编码和鼠标所在的像素。w 保存整张图（png、jpg、bmp、tiff）。\n\n"
        "距离图像（16UC1、32FC1）是灰色的：黑色是 0，白色是最大距离，按 x 修改。按 d 就用图里最小和最大的距离。"
        "按 m 把点击的位置发布到 <话题>_mouse_left。"
    ),
    "help.showimage": (
        "话题 image 上最新的图像，放进窗口里；不管来多少，每秒只显示最新的几张。下面一行是大小、编码和鼠标所在的像素。"
        "`ros2 run image_tools cam2image --ros-args -p burger_mode:=true` 没有摄像头也能发布图像。\n\n"
        "真的 ROS 2 里这是 OpenCV 的窗口，和图像一样大。关掉窗口，程序就结束；在那里，下一张图像来了窗口会再出现。"
    ),
}

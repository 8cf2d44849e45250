"""rqt_image_view and showimage."""

TEXTS = {
    "images.none": "No topic has images (sensor_msgs/msg/Image) yet. Start a camera.",
    "images.choose": "t chooses a topic.",
    "images.no_topic": "Nobody publishes {topic}.",
    "images.waiting": "Waiting for an image on {topic}.",
    "images.topic": "topic",
    "images.fit": "fit",
    "images.zoom_1": "1:1",
    "images.rotate": "rotate",
    "images.rotate_back": "rotate to the left",
    "images.save": "save",
    "images.save_title": "Save as image",
    "images.dynamic": "dynamic range",
    "images.range": "maximum range",
    "images.range_note": "The distance in metres that is drawn white in a depth image.",
    "images.bad_range": "A number from 0.01 to 100.",
    "images.mouse": "publish clicks",
    "help.rqt_image_view": (
        "The images of a topic. t, or a click on its name, chooses a topic with images. However many arrive, the newest is "
        "shown a few times a second.\n\n"
        "1 shows the image pixel for pixel, and the arrows move the visible part; 1 again fits the whole image into the "
        "window. r rotates it to the right, R to the left. The line below gives its size and encoding, and the pixel under "
        "the mouse. w saves the whole image (png, jpg, bmp, tiff).\n\n"
        "Depth images (16UC1, 32FC1) are grey: black is 0, white the maximum range, which x changes. d uses the smallest "
        "and largest distance in the image. m publishes the point you click on <topic>_mouse_left."
    ),
    "help.showimage": (
        "The newest image on the topic image, fitted into the window, a few times a second, however many arrive. The line "
        "below gives its size and encoding, and the pixel under the mouse. `ros2 run image_tools cam2image --ros-args -p "
        "burger_mode:=true` publishes images without a camera.\n\n"
        "In real ROS 2 this is an OpenCV window, as large as the image. Here, closing it ends the program; there, the "
        "window comes back with the next image."
    ),
}

"""rqt_image_view and showimage."""

TEXTS = {
    "images.none": "There is no topic with images (sensor_msgs/msg/Image) yet. Start a camera.",
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
    "images.range": "greatest range",
    "images.range_note": "Metres that are white in an image of distances.",
    "images.bad_range": "A number from 0.01 to 100.",
    "images.mouse": "publish clicks",
    "help.rqt_image_view": (
        "The images of a topic. t, or a click on its name, chooses one of the topics with images. The newest image is shown, a "
        "few times a second, however many come.\n\n"
        "1 shows every pixel of the image, arrows then move the part that is seen; 1 again fits all of it into the window. r "
        "rotates, R to the left. The line below tells size and encoding, and which pixel the mouse is on. w saves the whole "
        "image (png, jpg, bmp, tiff).\n\n"
        "Images of distances (16UC1, 32FC1) are grey: black is 0, white the greatest range, which x changes. d takes the least "
        "and the greatest distance there are. m publishes where you click, on <topic>_mouse_left."
    ),
    "help.showimage": (
        "The newest image of the topic image, fitted into the window, a few times a second, however many come. The line below "
        "tells size and encoding, and which pixel the mouse is on. `ros2 run image_tools cam2image --ros-args -p "
        "burger_mode:=true` publishes images without a camera.\n\n"
        "In real ROS 2 this is a window of OpenCV, as large as the image. Closing it ends the program; there it would come back "
        "with the next image."
    ),
}

"""The executables and components of image_tools, without OpenCV: no camera and no window."""

"""Paints a scene (day6_core/ros/programs/rviz2/model/scene) into pixels and pixels into cells of a terminal. Needs numpy.

Solids are found by casting rays at their exact shapes, meshes by filling triangles, lines and points by sampling, all into one
depth buffer. Nothing here knows of widgets.
"""

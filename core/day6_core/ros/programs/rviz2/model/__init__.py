"""RViz without a screen: displays, properties, statuses, views, .rviz files, and the scene they make.

`manager.RViz` is the whole of it. A user interface draws `RViz.scene` from `RViz.view.camera()` and the lines below
`RViz.root`. numpy is used only where a mesh or a laser scan asks for it.
"""

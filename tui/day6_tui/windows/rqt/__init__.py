"""rqt and the windows of its plugins that need one module or two."""

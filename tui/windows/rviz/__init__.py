"""Parts of the RViz window: the panel of displays, the 3-D view, what is said about both, and the dialogs."""

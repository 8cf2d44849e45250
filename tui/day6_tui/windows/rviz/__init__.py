"""Parts of the RViz window: the Displays panel, the 3-D view, the status bar, and the dialogs."""

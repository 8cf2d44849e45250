"""What the desktop does beside showing panes, one module for each."""

"""What opens over the panes, all in one frame (`modal`)."""

"""The editor behind nano, gedit, vim and code: the file on the disk, checks of a text, the model of the window."""

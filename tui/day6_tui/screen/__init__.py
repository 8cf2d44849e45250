"""The real terminal: Textual's driver, what it reads and writes, how an application on it survives and ends."""

"""rqt_console: the log of all nodes.

`model` keeps the messages, `filters` choose among them, `files` are messages on disk, `kept` is what a perspective keeps,
`rqt_console` is the program.
"""

"""What the desktops of a class tell their teacher, and what a teacher asks of them.

`note` is what a pupil's desktop says of itself, `order` what the teacher asks it to do, `roster` the class as the teacher has
heard of it. Bytes are carried by others: the keepers of kept desktops (`day6_tui/detached`), or the link. Whatever comes from the
other side is checked and cleaned here, once: a note is a pupil's word, not a fact.
"""

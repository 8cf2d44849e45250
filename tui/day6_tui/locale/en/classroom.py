"""A class: what a pupil sees, and the window of the teacher."""

TEXTS = {
    # a class: what a pupil sees
    "action.hand": "Raise your hand, or lower it",
    "action.sayings": "What the teacher said",
    "action.take_back": "Let the teacher type no longer",
    "help.action.hand": "the teacher of the class sees it",
    "help.action.sayings": "every message of the teacher to you",
    "help.action.take_back": "only you type, from now on",
    "class.hand.raised": "Your hand is up: the teacher sees it",
    "class.hand.alone": "Your hand is up; no teacher is connected now",
    "class.hand.lowered": "Your hand is down",
    "class.taken_back": "The teacher can no longer type",
    "class.hand.seen": "Your teacher has seen your hand",
    "class.ended": "Your teacher has ended this desktop. Your files are kept.",
    "class.sayings": "The teacher said",
    "class.log.time": "time",
    "class.log.name": "name",
    "class.log.what": "what",
    "class.log.text": "text",
    "class.log.came": "came",
    "class.log.left": "left",
    "class.log.lesson": "opened a lesson",
    "class.log.step": "next step",
    "class.log.error": "error",
    "class.log.mended": "error mended",
    "class.log.hand": "hand up",
    "class.log.lowered": "hand down",
    "class.sayings.none": "Nothing yet.",
    # The teacher's window of a class on a network
    "action.class": "The class: who is where, their screens, orders",
    "help.action.class": "the teacher's view of the pupils who have joined",
    "teacher.title": "Class",
    "teacher.here": "{here} of {all} here",
    "teacher.hand": "1 hand up",
    "teacher.hands": "{count} hands up",
    "teacher.bar.hand": "1 hand",
    "teacher.bar.hands": "{count} hands",
    "teacher.raised": "{name} has raised a hand",
    "teacher.frozen": "the class is frozen",
    "teacher.stuck": "{count} stuck",
    "teacher.typing": "you type for {name}",
    "teacher.awaited": "asked whether you may type: it begins with the yes",
    "teacher.over.taken_back": "{name} has taken it back: Ctrl-] or Esc",
    "teacher.over.gone": "{name} is gone: Ctrl-] or Esc",
    "teacher.key.large": "screen",
    "teacher.key.back": "table",
    "teacher.key.say": "say",
    "teacher.key.open": "open",
    "teacher.key.freeze": "freeze",
    "teacher.key.thaw": "let go on",
    "teacher.key.type": "type",
    "teacher.key.end_typing": "end typing",
    "teacher.key.acknowledge": "go on",
    "teacher.key.next": "next, previous",
    "teacher.key.preview": "preview",
    "teacher.key.invite": "how to join",
    "teacher.key.scroll": "scroll",
    "teacher.key.page": "a page up, down",
    "teacher.key.ends": "first, last",
    "teacher.key.forget": "remove the row of who is gone",
    "teacher.key.compare": "compare",
    "teacher.key.all": "say to all, open for all",
    "teacher.key.lower": "lower the hand",
    "teacher.key.csv": "report and log for a spreadsheet",
    "teacher.key.end": "end the desktop of the pupil",
    "teacher.empty": "Nobody has joined yet. On a pupil's machine in the same network:",
    "teacher.join": "To join: {command}",
    "teacher.opening": "The way in is being opened; nobody can join yet.",
    "teacher.port_in_use": "Nobody can join: another program, perhaps another class, listens on port {port}. "
    "End it, or start with --listen tcp/0.0.0.0:PORT and another port.",
    "teacher.shut": "Nobody can join: {reason}",
    "teacher.turned.taken": "{name} is taken: another machine asks for this name",
    "teacher.turned.full": "{name} cannot join: the class is full",
    "teacher.turned.domain": "{name} cannot join: another ROS_DOMAIN_ID there",
    "teacher.invite": "How to join",
    "teacher.invite.text": "On a pupil's machine in the same network, each with a name of their own:\n",
    "teacher.invite.keys": "Enter copies  Esc closes",
    "teacher.head.name": "Name",
    "teacher.head.lesson": "Lesson",
    "teacher.head.state": "Now",
    "teacher.head.frozen": "Now: the class is frozen",
    "teacher.above": "↑ {count} more",
    "teacher.below": "↓ {count} more",
    "teacher.state.gone": "away",
    "teacher.state.silent": "has not said anything yet",
    "teacher.state.hand_now": "hand up",
    "teacher.state.hand.short": "hand {minutes} min",
    "teacher.state.asked": "asked whether you may type",
    "teacher.state.may_type": "you may type: t",
    "teacher.state.idle.short": "idle {minutes} min",
    "teacher.state.hand": "hand up for {minutes} min",
    "teacher.state.frozen": "frozen",
    "teacher.state.idle": "no key for {minutes} min",
    "teacher.hints": "hints: {count}",
    "teacher.no_screen": "waiting for the screen",
    "teacher.missed": "not reached: {names}",
    "teacher.sent": "sent to {name}",
    "teacher.sent.all": "sent to {count}",
    "teacher.away": "{name} (away)",
    "teacher.alone": "nobody else is here",
    "teacher.no_room": "no room for a preview: F8 enlarges the window",
    "teacher.not_gone": "{name} is here: only who is gone can be removed",
    "teacher.say": "Say to {name}",
    "teacher.say.all": "Say to all",
    "teacher.say.nothing": "there is nothing to say",
    "teacher.open": "Open",
    "teacher.open.lesson": "lesson",
    "teacher.open.scene": "scene",
    "teacher.end": "End the desktop of {name}?",
    "teacher.end.text": "Programs there end; files stay.",
    "teacher.end.yes": "end it",
    "teacher.csv": "Write the report, and the log beside it, into",
    "teacher.csv.name": "name",
    "teacher.csv.lesson": "lesson",
    "teacher.csv.step": "step reached",
    "teacher.csv.steps": "steps",
    "teacher.csv.exists": "{file} is there already",
    "teacher.csv.written": "written: {files}",
    "help.classroom": (
        "The class that has joined this desktop over the network: who is at which step of which lesson, whose hand is up, whose "
        "last command failed and with which card, who has not touched a key for a while. Raised hands come first, then those "
        "with an error that stands for a minute, and last who has gone. The lower edge has the command by which others join; i "
        "shows it to be copied.\n\n"
        "Nobody is watched before you ask for it. Enter shows the screen of the chosen pupil, n and p the next and the previous "
        "one, c another one beside it; v shows the chosen one below the table. The pupil sees that you watch.\n\n"
        "t asks the pupil whether you may type. With the yes it begins by itself if you are still looking at that screen; else t "
        "again. From then on the keys go to the pupil's terminal until Ctrl-]. Only F1 to F9, Alt with digits and arrows, and "
        "Ctrl-Q stay your desktop's, as in every terminal. If the pupil takes it back, or is gone, keys do nothing until "
        "Ctrl-] or Esc.\n\n"
        "s says a sentence and o opens a lesson, a drill or a scene there; S and O do so for all. f freezes all screens, also of "
        "those who come later, until f again, at most ten minutes. x ends the desktop of the pupil, not yours. d removes the "
        "row of somebody who is gone.\n\n"
        "e writes how far everybody came, and beside it the log of the lesson; it overwrites nothing.\n\n"
        "In your terminals each pupil's graph is below the pupil's name: ros2 topic echo /anna/turtle1/pose."
    ),
    "help.classroom_pupil": (
        "A class: your teacher's desktop, or the teacher's page, knows of yours. The top line says so, and what the teacher "
        "does there.\n\n"
        "Raise your hand: click “raise hand” in the top line, or F7 and hand. Click again to lower it. The teacher can lower it "
        "too, and then has seen it.\n\n"
        "The teacher sees which lesson and step you are in, the names of your nodes, the card of your last error, and since "
        "when you have not touched a key. The teacher may say something (F7: what the teacher said), and open a lesson or a "
        "scene; what runs goes on.\n\n"
        "Your screen is seen only while the top line says “teacher watching”. Nothing changes for you.\n\n"
        "“Eyes to the front”: the teacher has frozen the screens of all. Your programs go on, nothing is lost, and it goes away "
        "by itself, after ten minutes at the latest.\n\n"
        "The teacher can type in your terminal only if you say yes. You can take that back at any time: click “teacher may "
        "type” in the top line, or F7 and teacher. What is typed goes to the terminal that has your keyboard.\n\n"
        "The teacher can end your desktop; your files stay.\n\n"
        "To join a class on a network: day6-tui class --join HOST --name NAME, in which the teacher's window tells HOST. "
        "Pupils see nothing of each other, unless it is a room (--room): then all are in one graph, and a scene runs below "
        "your name."
    ),
    "class.says": "Your teacher",
    "class.opened": "Your teacher opened this lesson",
    "class.bar.unread": "new from the teacher: {count}",
    "class.bar.unread.short": "teacher: {count}",
    "class.bar.raise": "raise hand",
    "class.bar.raise.short": "hand",
    "class.bar.hand": "hand up",
    "class.bar.hand.short": "hand up",
    "class.bar.types": "teacher may type: click to end",
    "class.bar.types.short": "teacher types: end",
    "class.bar.watched": "teacher watching",
    "class.bar.watched.short": "watched",
    "class.bar.seen": "somebody watches",
    "class.bar.seen.short": "watched",
    "class.frozen.title": "Eyes to the front",
    "class.frozen.text": "Your teacher has stopped the keyboards for a moment.\nYour programs go on, and nothing is lost.",
    "class.frozen.keys": "it goes away by itself",
    "class.consent.title": "May your teacher type?",
    "class.consent.text": "Your teacher asks to type in your terminal.\n"
    "You can take it back at any time: click the words in the top line, or F7.",
    "class.consent.yes": "Yes",
    "class.consent.no": "No",
    "class.refused.busy": "a question is open on that screen",
    "class.refused.type": "the pupil has not agreed",
    "class.refused.no": "the pupil said no",
    "class.refused.taken_back": "the pupil has taken it back",
    "class.refused.full": "something is open on that desk",
    "class.refused.place": "the keyboard is in no terminal there",
    "class.refused.unknown": "it is not there",
}

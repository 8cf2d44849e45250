"""A class: what a pupil sees, and the window of the teacher."""

TEXTS = {
    # a class: what a pupil sees
    "action.hand": "Raise your hand, or lower it",
    "action.sayings": "Messages from the teacher",
    "action.take_back": "Stop the teacher typing",
    "help.action.hand": "the class's teacher sees it",
    "help.action.sayings": "everything the teacher has said to you",
    "help.action.take_back": "from now on, only you can type",
    "class.hand.raised": "Your hand is up: the teacher can see it",
    "class.hand.alone": "Your hand is up; no teacher is connected right now",
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
    "class.log.mended": "error fixed",
    "class.log.hand": "hand up",
    "class.log.lowered": "hand down",
    "class.sayings.none": "Nothing yet.",
    # The teacher's window of a class on a network
    "action.class": "Class: who is where, their screens, commands",
    "help.action.class": "the teacher's view of the pupils who have joined",
    "teacher.title": "Class",
    "teacher.here": "{here} of {all} here",
    "teacher.hand": "1 hand up",
    "teacher.hands": "{count} hands up",
    "teacher.bar.hand": "1 hand",
    "teacher.bar.hands": "{count} hands",
    "teacher.raised": "{name} raised a hand",
    "teacher.frozen": "the class is frozen",
    "teacher.stuck": "{count} stuck",
    "teacher.typing": "you type for {name}",
    "teacher.awaited": "waiting for permission to type; it starts when the pupil says yes",
    "teacher.over.taken_back": "{name} has withdrawn permission: Ctrl-] or Esc",
    "teacher.over.gone": "{name} has left: Ctrl-] or Esc",
    "teacher.key.large": "screen",
    "teacher.key.back": "table",
    "teacher.key.say": "say",
    "teacher.key.open": "open",
    "teacher.key.freeze": "freeze",
    "teacher.key.thaw": "unfreeze",
    "teacher.key.type": "type",
    "teacher.key.end_typing": "stop typing",
    "teacher.key.acknowledge": "OK",
    "teacher.key.next": "next, previous",
    "teacher.key.preview": "preview",
    "teacher.key.invite": "how to join",
    "teacher.key.scroll": "scroll",
    "teacher.key.page": "page up, down",
    "teacher.key.ends": "first, last",
    "teacher.key.forget": "remove a pupil who has left",
    "teacher.key.compare": "compare",
    "teacher.key.all": "say to all, open for all",
    "teacher.key.lower": "lower the hand",
    "teacher.key.csv": "export the report and the log as CSV",
    "teacher.key.end": "end this desktop",
    "teacher.empty": "Nobody has joined yet. On a pupil's computer in the same network:",
    "teacher.join": "To join: {command}",
    "teacher.opening": "Getting ready; nobody can join yet.",
    "teacher.port_in_use": (
        "Nobody can join: another program, perhaps another class, is using port {port}. End it, or start with --listen "
        "tcp/0.0.0.0:PORT and another port."
    ),
    "teacher.shut": "Nobody can join: {reason}",
    "teacher.turned.taken": "{name} is taken: another computer is asking for this name",
    "teacher.turned.alike": "{name} looks like another name in the class: not let in",
    "teacher.turned.full": "{name} cannot join: the class is full",
    "teacher.turned.domain": "{name} cannot join: its ROS_DOMAIN_ID differs",
    "teacher.invite": "How to join",
    "teacher.invite.text": "On a pupil's computer in the same network, each with a name of their own:\n",
    "teacher.invite.keys": "Enter copies  Esc closes",
    "teacher.head.name": "Name",
    "teacher.head.lesson": "Lesson",
    "teacher.head.state": "Now",
    "teacher.head.frozen": "Now: the class is frozen",
    "teacher.above": "↑ {count} more",
    "teacher.below": "↓ {count} more",
    "teacher.state.gone": "away",
    "teacher.state.silent": "no news yet",
    "teacher.state.hand_now": "hand up",
    "teacher.state.hand.short": "hand {minutes} min",
    "teacher.state.asked": "asked for permission to type",
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
    "teacher.not_gone": "{name} is still here: only pupils who have left can be removed",
    "teacher.say": "Say to {name}",
    "teacher.say.all": "Say to all",
    "teacher.say.nothing": "there is nothing to send",
    "teacher.open": "Open",
    "teacher.open.lesson": "lesson",
    "teacher.open.scene": "scene",
    "teacher.end": "End the desktop of {name}?",
    "teacher.end.text": "Its programs end; the files stay.",
    "teacher.end.yes": "end it",
    "teacher.csv": "Save the report, and the log beside it, as",
    "teacher.csv.name": "name",
    "teacher.csv.lesson": "lesson",
    "teacher.csv.step": "step reached",
    "teacher.csv.steps": "steps",
    "teacher.csv.exists": "{file} already exists",
    "teacher.csv.written": "written: {files}",
    "help.classroom": (
        "The class that has joined this desktop over the network: which step of which lesson everyone is at, whose hand is "
        "up, whose last command failed and with which card, and who hasn't touched a key for a while. Raised hands come "
        "first, then errors more than a minute old, and pupils who have left come last. The bottom line shows the command "
        "for joining; i shows it for copying.\n\n"
        "Nobody is watched until you ask for it. Enter shows the chosen pupil's screen, n and p the next and the previous "
        "one, c another one beside it; v shows the chosen one below the table. Pupils can see that you are watching.\n\n"
        "t asks the pupil whether you may type. If the answer is yes and you are still looking at that screen, typing "
        "starts at once; otherwise press t again. From then on your keys go to the pupil's terminal until Ctrl-]. Only F1 "
        "to F9, Alt with digits and arrows, and Ctrl-Q stay with your desktop, as in every terminal. If the pupil "
        "withdraws permission or leaves, your keys do nothing until Ctrl-] or Esc.\n\n"
        "s sends a message, and o opens a lesson, a drill or a scene on that desktop; S and O do so for everyone. f "
        "freezes all screens, including those of pupils who join later, until you press f again, for ten minutes at most. "
        "x ends the pupil's desktop, not yours. d removes the row of a pupil who has left.\n\n"
        "e saves how far everyone got, and the log of the lesson beside it; nothing is overwritten.\n\n"
        "In your terminals, each pupil's graph appears under the pupil's name: ros2 topic echo /anna/turtle1/pose."
    ),
    "help.classroom_pupil": (
        "In a class, your teacher's desktop, or the teacher's web page, is connected to yours. The top line says so, and "
        "shows what the teacher is doing there.\n\n"
        "Raise your hand: click “raise hand” in the top line, or press F7 and type hand. Click again to lower it. The "
        "teacher can lower it too; that means it has been seen.\n\n"
        "The teacher sees which lesson and step you are in, the names of your nodes, the card of your last error, and how "
        "long you haven't touched a key. The teacher can send you a message (F7: Messages from the teacher), and open a "
        "lesson or a scene; your programs keep running.\n\n"
        "Your screen can be seen only while the top line says “teacher watching”. Nothing changes for you.\n\n"
        "“Eyes to the front”: the teacher has frozen all screens. Your programs keep running, nothing is lost, and it ends "
        "after ten minutes at the latest.\n\n"
        "The teacher can type in your terminal only if you say yes. You can stop that at any time: click “teacher may "
        "type” in the top line, or press F7 and type teacher. What the teacher types goes to the terminal that has the "
        "keyboard.\n\n"
        "The teacher can end your desktop; your files stay.\n\n"
        "To join a class on a network: day6-tui class --join HOST --name NAME; the teacher's window shows HOST. Pupils see "
        "nothing of each other, unless the class is a room (--room): then everyone shares one graph, and a scene runs "
        "under your name."
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
    "class.frozen.text": (
        "Your teacher has locked the keyboards for a moment.\nYour programs keep running, and nothing is lost."
    ),
    "class.frozen.keys": "this goes away on its own",
    "class.consent.title": "May your teacher type?",
    "class.consent.text": (
        "Your teacher would like to type in your terminal.\nYou can stop this at any time: click the words in the top "
        "line, or F7."
    ),
    "class.consent.yes": "Yes",
    "class.consent.no": "No",
    "class.refused.busy": "a question is open on that screen",
    "class.refused.type": "the pupil has not agreed",
    "class.refused.no": "the pupil said no",
    "class.refused.taken_back": "the pupil has withdrawn permission",
    "class.refused.full": "something is already open on that desktop",
    "class.refused.place": "the keyboard is not in a terminal there",
    "class.refused.unknown": "no such thing",
}

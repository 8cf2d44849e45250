"""A class: what a pupil sees, and the window of the teacher."""

TEXTS = {
    # a class: what a pupil sees
    "action.hand": "Raise your hand, or lower it",
    "action.answer": "Answer your teacher, or open what was handed out",
    "action.sayings": "Messages from the teacher",
    "action.take_back": "Stop the teacher typing",
    "action.stop_showing": "Stop showing my screen",
    "help.action.hand": "the class's teacher sees it",
    "help.action.answer": "what waits stands in the top line; otherwise the key belongs to the terminal",
    "help.action.sayings": "everything the teacher has said to you",
    "help.action.take_back": "from now on, only you can type",
    "help.action.stop_showing": "from now on, the class no longer sees your screen",
    "class.hand.raised": "Your hand is up: the teacher can see it",
    "class.hand.alone": "Your hand is up; no teacher is connected right now",
    "class.hand.lowered": "Your hand is down",
    "class.taken_back": "The teacher can no longer type",
    "class.not_shown": "The class no longer sees your screen",
    "class.hand.seen": "Your teacher has seen your hand",
    "class.ended": "Your teacher has ended this desktop. Your files are kept.",
    "class.sayings": "The teacher said",
    "class.log.time": "time",
    "class.log.name": "pupil",
    "class.log.by": "who",
    "class.log.what": "what",
    "class.log.text": "text",
    "class.log.all": "all",
    "class.log.by.pupil": "pupil",
    "class.log.by.teacher": "teacher",
    "class.log.by.server": "server",
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
    "teacher.hidden": "pupils' screens are hidden as long as the class sees yours",
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
    "teacher.ask": "Ask {name}; the answer is yes, no, done or a few words",
    "teacher.ask.all": "Ask all; the answer is yes, no, done or a few words",
    "teacher.link": "A link for {name}",
    "teacher.link.all": "A link for all",
    "teacher.link.none": "a link begins with http:// or https://",
    "teacher.reply.none": "no answer yet",
    "teacher.reply.words": "“{text}”",
    "teacher.reply.silent": "not yet {count}",
    "teacher.state.step": "{minutes} min on this step",
    "teacher.state.step.short": "step {minutes} min",
    "teacher.key.ask": "ask for an answer, ask all",
    "teacher.key.settle": "wait for answers no longer",
    "teacher.key.link": "hand over a link, to all",
    "teacher.key.file": "hand over a file, to all",
    "teacher.file": "A file for {name}",
    "teacher.file.all": "A file for all",
    "teacher.file.note": "a file in your home, or its whole path; at most {most}",
    "teacher.file.large": "too large: at most {most}",
    "teacher.file.handed": "{file}: {count} of {all} have it",
    "teacher.file.failed": "{name} ({reason})",
    "teacher.file.silent": "no answer",
    "teacher.open": "Open",
    "teacher.open.lesson": "lesson",
    "teacher.open.scene": "scene",
    "teacher.end": "End the desktop of {name}?",
    "teacher.end.text": "Its programs end; the files stay.",
    "teacher.end.yes": "end it",
    "teacher.no_log": "the log of the class cannot be written: {reason}",
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
        "s sends a message, and o opens a lesson, a drill or a scene on that desktop; S and O do so for everyone. "
        "a asks something that is answered with yes, no, done or a few words, and A asks everyone: the answers are in the "
        "table, the counts below it, and w ends the question. l hands over a link, L to everyone; "
        "g a file from your home, G to everyone: it is put into the pupils' folder handed and replaces nothing there, and the "
        "bottom line says who has it. f "
        "freezes all screens, including those of pupils who join later, until you press f again, for ten minutes at most. "
        "x ends the pupil's desktop, not yours. d removes the row of a pupil who has left.\n\n"
        "m shows your screen to the class, live, and r the chosen pupil's, if the pupil says yes; the same key ends it, and so "
        "does a click on the words in the bottom line. Pupils go on working beside it. M and R cover their desktops with it, "
        "until they make it smaller with F8. Whoever is shown does not see it. Pupils' screens are hidden from your window as "
        "long as the class sees yours.\n\n"
        "e saves how far everyone got, and the log of the lesson beside it; nothing is overwritten.\n\n"
        "In your terminals, each pupil's graph appears under the pupil's name: ros2 topic echo /anna/turtle1/pose."
    ),
    "help.shown": (
        "A screen that your teacher shows to the class, live: the teacher's own or a pupil's. You can only look, and your own "
        "work goes on beside it. When the screen is larger than this window, you see the part in which its owner works; the "
        "arrow keys and the mouse wheel scroll, and Home follows the work again.\n\n"
        "If it covers everything, F8 makes it smaller and gives you your terminal back. Close it if you don't need it: a click "
        "in the top line, or F7 “See the screen that is shown”, opens it again. It closes when your teacher ends it.\n\n"
        "Your own screen is shown only if you say yes, and you can stop that at any time: click the words in the top line."
    ),
    "help.classroom_pupil": (
        "In a class, your teacher's desktop, or the teacher's web page, is connected to yours. The top line says so, and "
        "shows what the teacher is doing there.\n\n"
        "Raise your hand: click “raise hand” in the top line, or press F7 and type hand. Click again to lower it. The "
        "teacher can lower it too; that means it has been seen.\n\n"
        "The teacher sees which lesson and step you are in, the names of your nodes, the card of your last error, and how "
        "long you haven't touched a key. The teacher can send you a message (F7: Messages from the teacher), and open a "
        "lesson or a scene; your programs keep running.\n\n"
        "If the top line says that the teacher asks, press F10 or click there: y, n and d answer yes, no and done, w takes a "
        "few words. F10 also opens what the teacher has handed out: a file in an editor, a link in the browser. When nothing "
        "waits, F10 belongs to the terminal.\n\n"
        "Your screen can be seen only while the top line says “teacher watching”, or, if you have said yes, “your class sees "
        "this screen”. Nothing changes for you.\n\n"
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
    "class.says.read": "Read it? Click here, or press {key}: {action}",
    "class.later": "later",
    "class.asks": "Your teacher asks",
    "class.asks.how": "{key} answers.",
    "class.bar.asks": "teacher asks: {key} answers",
    "class.bar.asks.short": "{key}: answer",
    "class.handed.how": "{key} opens it.",
    "class.bar.handed": "from the teacher: {key} opens it",
    "class.bar.handed.short": "{key}: open",
    "class.handed.link": "Your teacher handed you a link: {what}",
    "class.handed.file": "Your teacher handed you {what}",
    "class.handed.open": "Open",
    "class.handed.copied": "The link is copied: paste it into a browser",
    "class.handed.gone": "{file} is no longer there",
    "class.handed.no_text": "{file} is not a text; it is in your home",
    "class.reply.yes": "Yes",
    "class.reply.no": "No",
    "class.reply.done": "Done",
    "class.reply.words": "In words",
    "class.reply.note": "at most {most} characters; Enter sends it",
    "class.reply.nothing": "there is nothing to send",
    "class.reply.long": "too long: at most {most} characters",
    "class.reply.late": "Your teacher no longer waits for this answer",
    "class.replied": "Your answer: {answer}",
    "class.sayings.open": "o opens what was handed out last",
    "class.opened": "Your teacher opened this lesson",
    "class.bar.unread": "new from the teacher: {count}",
    "class.bar.unread.short": "teacher: {count}",
    "class.bar.raise": "raise hand",
    "class.bar.raise.short": "hand",
    "class.bar.hand": "hand up",
    "class.bar.hand.short": "hand up",
    "class.bar.types": "teacher may type: click to end",
    "class.bar.types.short": "teacher types: end",
    "class.bar.shown": "your class sees this screen: click to end",
    "class.bar.shown.short": "class sees this: end",
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
    "class.consent_show.title": "May everyone see your screen?",
    "class.consent_show.text": (
        "Your teacher would like to show your screen to the class, live.\nYou can stop this at any time: click the words "
        "in the top line, or F7."
    ),
    "class.consent.yes": "Yes",
    "class.consent.no": "No",
    "class.show.gone": "{name}'s screen cannot be shown: the desktop does not run",
    "class.show.no": "{name} doesn't want the screen to be shown",
    "class.show.busy": "{name} was not asked: a question is open on that screen",
    "class.show.silent": "{name} did not answer whether the screen may be shown",
    "class.show.over": "{name}'s screen is no longer shown",
    "class.show.not_mine": "your screen is not shown: your desktop is not open",
    "class.show.mine_over": "your screen is no longer shown",
    "action.see_shown": "See the screen that is shown to the class",
    "help.action.see_shown": "opens its window again, after you have closed it",
    "class.bar.see": "a screen is shown: click to see it",
    "class.bar.see.short": "shown: see it",
    "shown.own": "The teacher's screen",
    "shown.of": "{name}'s screen",
    "shown.live": "live",
    "shown.waiting": "waiting for the picture",
    "shown.over": "The screen is no longer shown",
    "shown.none": "No screen is shown right now",
    "shown.key.scroll": "scroll",
    "shown.key.follow": "follow the work",
    "teacher.key.show_mine": "show my screen to all, large",
    "teacher.key.show": "show the pupil's screen to all, large",
    "teacher.shown": "the class sees {name}'s screen: click to end",
    "teacher.shown.full": "the class sees {name}'s screen, large: click to end",
    "teacher.shown.own": "the class sees your screen: click to end",
    "teacher.to_show": "{name} is asked for the screen: click to stop",
    "teacher.to_show.full": "{name} is asked for the screen: click to stop",
    "teacher.to_show.own": "your screen is about to be shown",
    "teacher.state.shown": "shown to the class",
    "teacher.state.asked_show": "asked to show the screen",
    "class.refused.busy": "a question is open on that screen",
    "class.refused.type": "the pupil has not agreed",
    "class.refused.no": "the pupil said no",
    "class.refused.taken_back": "the pupil has withdrawn permission",
    "class.refused.full": "something is already open on that desktop",
    "class.refused.place": "a question stands open there, or this key is the pupil's alone",
    "class.refused.unknown": "no such thing",
}

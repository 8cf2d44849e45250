"""A class in browser tabs, and what keeps its pupils apart."""

TEXTS = {
    # keeping pupils apart (day6_core/isolation): what a mode is, and why one is not to be had
    "isolation.is.users": (
        "each pupil is a Unix user: no pupil can read, change or end anything of another's; the names of processes and of "
        "files in /tmp are visible, and ports on this machine are shared"
    ),
    "isolation.is.bubblewrap": (
        "each pupil is in a sandbox (bubblewrap): nothing of other pupils can be seen, read or ended; programs have no "
        "network unless you allow it"
    ),
    "isolation.is.landlock": (
        "each pupil can open only their own files and end only their own programs (Landlock), but can connect to the "
        "sockets of another pupil's desktop and type into it: this does not keep pupils apart"
    ),
    "isolation.is.none": "all pupils are the same user: each can read, change and end everything of every other pupil, "
    "and everything else that belongs to this user",
    "isolation.no.linux": "only exists on Linux",
    "isolation.no.root": "needs a server started as root",
    "isolation.no.as_root": "only for a server that isn't root",
    "isolation.no.bwrap": "needs bubblewrap (Debian, Ubuntu: apt install bubblewrap)",
    "isolation.no.landlock": "this Linux has no Landlock (needs 5.13 or later, with Landlock enabled)",
    "isolation.no.fails": "was tried and doesn't start: {reason}",
    "isolation.no.open": "was tried and doesn't keep pupils apart here; these got through: {names}",
    "isolation.no.closed": (
        "other users cannot enter {folder}: put day6-tui, its Python and the homes where everyone can (for example python3 "
        "-m venv /opt/day6-tui)"
    ),
    "isolation.no.owner": (
        "{folder} contains another user's files; if they belong to the pupil: chown -R {uid}:{uid} {folder}"
    ),
    "isolation.no.inside": "{folder} is inside a folder that every pupil can read: choose another place for it",
    "isolation.no.taken": "{folder} belongs to user {uid}, a number used by another server on this machine",
    "isolation.no.uids": "all user numbers from {first} to {last} are in use",
    # a class in browser tabs: `day6-tui serve`
    "serve.windows": "serve needs Unix sockets and pseudo-terminals: Linux or macOS (on Windows: inside WSL)",
    "serve.no_mode": "--isolation {name}: {reason}",
    "serve.not_mode": "not --isolation {name}: {reason}",
    "serve.as_before": "--isolation {name}, as before in this folder",
    "serve.other_mode": "{name}: the last server's desktop was ended: it was isolated by --isolation {mode}",
    "serve.at": "open {address} in a browser",
    "serve.apart": "how pupils are kept apart: {what}",
    "serve.back": "To the start page",
    "serve.start.what": "ROS 2 in a browser tab: turtlesim, RViz, rqt_graph and terminals, on your own desktop.",
    "serve.app.desk": "day6: ROS 2 in a browser",
    "serve.app.class": "day6: the class",
    "serve.start.word": "Class word",
    "serve.start.name": "Your name",
    "serve.start.enter": "Open my desktop",
    "serve.start.go_on": "Continue as {name}",
    "serve.start.leave": "Sign {name} out",
    "serve.start.beside": "Somebody else wants to come in here, too",
    "serve.start.by_link": "Use the link or the QR code your teacher gave you.",
    "serve.start.apart": "How pupils are kept apart here:",
    "serve.start.none": (
        "You all share one account here: everyone can open, change and end what belongs to others. Please leave it alone, "
        "and keep no secrets here."
    ),
    "serve.wrong.word": "That is not the class word.",
    "serve.wrong.often": "Too many wrong attempts. Wait a minute.",
    "serve.wrong.name": "Somebody has just come in as {name}. Choose another name.",
    "serve.wrong.link": "This link is not valid (any more). Ask your teacher for a new one.",
    "serve.wrong.stranger": "This page needs a link from your teacher.",
    "serve.wrong.host": "Open the address your teacher gave you.",
    "serve.wrong.address": "There is no page at this address.",
    "serve.name.empty": "Type a name.",
    "serve.name.long": "This name is too long: 32 characters at most.",
    "serve.name.letters": "A name may have letters and digits, and also spaces, dots and dashes.",
    "serve.no_packages": "serve needs more packages: pip install aiohttp segno",
    "serve.not_apart": (
        "--host {host}: pupils are not kept apart here (--isolation {name}), so each could read and change everything this "
        "user owns; if you trust them: --trust-pupils"
    ),
    "serve.in_use": "{folder}: in use by another server",
    "serve.bad_tokens": "{file} was not written by this program: move it away, and all links are made again",
    "serve.again": "{number} desktops of the last server are still running",
    "serve.link": "{name}: {link}",
    "serve.teacher": "the teacher: {link}",
    "serve.kept": "{number} desktops keep running; the next server with this folder finds them",
    "serve.ending": "ending {number} desktops; the files stay in {folder}",
    "serve.left": "{name}: not all programs of the last desktop could be ended",
    "serve.idle": "{name}: ended after {minutes} minutes without a key; the files stay",
    "serve.refused": "{name}: no desktop: {reason}",
    "serve.full": "{name}: no desktop: {most} are running, and --most allows no more",
    "serve.full.kept": (
        "{name}: no desktop: {running} are running, and the other places are kept for the class list (--most {most})"
    ),
    "serve.no_record": "{file}: cannot be written ({reason})",
    "serve.bad_record": "{file} was not written by this program; the last desktops are found by the pupils' names",
    "serve.groups.unread": "{file} cannot be read or is no file of groups; there are no groups now",
    "serve.groups.unkept": "groups are lost at the end of the server: {file} cannot be written ({reason})",
    "serve.groups.nobody": "a group needs somebody of the class",
    "serve.groups.many": "no more than {most} groups",
    "serve.failed.hand": "handing out a file",
    "serve.failed.desk": "restarting a desktop",
    "serve.failed.machine": "measuring what the desktops take",
    "serve.desk.none": "no desktop is running",
    "serve.desk.no_home": "there is no home folder yet",
    "serve.desk.busy": "this is being done already",
    "serve.desk.progress": "the progress file cannot be read; it was left as it is",
    "serve.room": "Room for {room} desktops: {why}",
    "serve.room.small": "room for {room} desktops on this machine, {wanted} are on the list: {why}",
    "serve.room.small.most": "room for {room} desktops on this machine, --most allows {wanted}: {why}",
    "serve.room.most": "--most allows no more than {most}",
    "serve.room.cores": "it has {cores} cores",
    "serve.room.memory": (
        "{free} MB of memory are free; a desktop takes {desktop} MB, measured here, and {programs} MB are kept for each "
        "pupil's programs"
    ),
    "serve.room.memory.unmeasured": (
        "{free} MB of memory are free; a desktop takes {desktop} MB, not measured here yet, and {programs} MB are kept for "
        "each pupil's programs"
    ),
    "serve.short.memory": "memory: {left} MB left",
    "serve.short.disk": "disk: {left} MB left",
    "serve.short.who": " (most of it is taken by {name}: {taken} MB)",
    "serve.disk.over": "{name}: {used} MB in the home folder, more than {most} MB",
    "serve.disk.ended": "{name}: ended, {used} MB in the home folder with {most} MB allowed; the files stay",
    "serve.class.large": "{file} is too large for a list of names",
    "serve.class.encoding": "{file}: not UTF-8 or GBK",
    "serve.class.line": "not a line of a table",
    "serve.class.twice": "this name appears twice",
    "serve.class.bad": "{file}, line {line} “{text}”: {reason}",
    "serve.class.nameless": "no name",
    "serve.class.empty": "{file}: no names",
    "serve.wrong.disk": "The server's disk is full. Tell your teacher.",
    "serve.wrong.mixed": "A name is written in one alphabet: this one mixes letters that look alike, such as Latin and Cyrillic.",
    "serve.wrong.alike": "{name} looks like {like}, who is in the class. Choose another name.",
    "serve.alike": "{address}: the name {name} was refused because it looks like {like}",
    "serve.word.seen": (
        "--word: every user of this machine can read the word in the list of processes; better: --word FILE (chmod 600), "
        "or --word - for standard input"
    ),
    "serve.lobby.asks": "{name} from {address} is waiting to be let in on the class page (or start with a larger --unasked)",
    "serve.beside.what": "{name} is at work in this browser.",
    "serve.beside.both": "Come in as {name}, too: each keeps a tab",
    "serve.beside.instead": "Sign {other} out and come in as {name}",
    "serve.beside.back": "Go on as {other}; {name} does not come in",
    "serve.beside.note": (
        "Whoever uses this browser can open the desktops of everyone who is signed in here. "
        "Signing out ends nothing: desktops and files stay."
    ),
    "serve.lobby.lost": "The server does not answer. This page keeps trying.",
    "serve.lobby.wait": "{name}, please wait: your teacher will let you in. This page goes on by itself.",
    "serve.lobby.claim": (
        "There is a {name} in this class. If that's you, your teacher will let you in to your own desktop, and this page goes on "
        "by itself. If not, choose another name."
    ),
    "serve.lobby.leave": "Choose another name",
    "serve.lobby.full": "Too many people are waiting to be let in. Tell your teacher.",
    "serve.lobby.away": "Your teacher did not let {name} in. If this is a mistake, tell your teacher, or use another name.",
    "serve.kept.unread": "{file} cannot be read or was not written by this program; what the last server kept in it is forgotten",
    "serve.kept.unkept": "{file} cannot be written ({reason}): if the server is killed, the next one does not know what is in it",
    "serve.no_log": (
        "the log of the lesson cannot be written ({file}: {reason}); the class goes on, and what happens is kept in memory "
        "until it can"
    ),
    "serve.failed": "{what} failed and goes on ({reason}); please report this",
    "serve.failed.look": "looking for idle desktops and full home folders",
    "serve.failed.end": "ending a desktop",
    "serve.failed.start": "starting a desktop",
    "serve.failed.page": "the class page",
    "serve.links.what": (
        "Print this page and cut it up: each pupil gets one link. Anyone with the link has the desktop."
    ),
    "serve.links.none": "Nobody is on the list yet.",
    "serve.links.back": "Back to the class",
    "serve.links.local": (
        "These links only work on this machine, not on other devices. For other devices, end the server and start it with "
        "--host 0.0.0.0."
    ),
    "serve.links.unknown": (
        "The link you gave out before still works. It cannot be shown again; a new link makes it invalid."
    ),
    "serve.links.by_word": "Not on the list: pupils who chose their name with the class word need no link.",
    "serve.links.not_kept": "The new links work until the server ends: they could not be saved ({reason}).",
    "serve.links.watching": "To watch only:",
    "serve.links.new": "New link…",
    "serve.links.new.sure": (
        "All older links of {name} stop working, on paper and in every browser. {name} will need the new one."
    ),
    "serve.links.new.yes": "Make a new link",
    "serve.links.watch": "Watch link…",
    "serve.links.watch.sure": (
        "Anyone with this link sees the desktop of {name} but cannot type; {name} can see that somebody is watching. An "
        "older watch link stops working."
    ),
    "serve.links.watch.yes": "Make a watch link",
    "serve.links.all": "New links for all…",
    "serve.links.all.sure": (
        "All {count} pupils on the list get new links, to be printed here. All older ones stop working, on paper and in "
        "every browser."
    ),
    "serve.links.all.yes": "Make new links for all",
    "serve.disk.say": (
        "Your home folder holds {used} MB, and {most} MB are allowed. Delete what you don't need, or your desktop will be "
        "ended."
    ),
}

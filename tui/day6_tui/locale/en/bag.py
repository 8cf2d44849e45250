"""rqt_bag."""

TEXTS = {
    "bag.none": "No bag is open: o opens one.",
    "bag.cut": "'{name}' is incomplete: everything up to the break is shown.",
    "bag.cancelled": "Cancelled: '{name}' is shown as far as it was read.",
    "bag.empty": "'{name}' has no messages.",
    "bag.messages": "{count} messages",
    "bag.open": "open",
    "bag.open.title": "Open a bag",
    "bag.open.note": "The bag's folder, or one of its files (.mcap, .db3).",
    "bag.play": "play",
    "bag.pause": "pause",
    "bag.publish": "publish",
    "bag.unpublish": "stop publishing",
    "bag.publish_all": "publish all, none",
    "bag.speed": "faster, slower",
    "bag.step": "previous, next message",
    "bag.choose": "choose a topic",
    "bag.pan": "move the view",
    "bag.scrub": "move the playhead",
    "bag.zoom": "zoom in, out",
    "bag.fit": "see everything",
    "bag.ends": "to the beginning, the end",
    "bag.region": "select from here, to here",
    "bag.no_region": "select nothing",
    "bag.open.other": "another …",
    "bag.view": "message",
    "bag.no_message": "no message before the playhead",
    "bag.panel": "to the fields of the message, and back",
    "bag.timeline": "back to the timeline",
    "bag.open_field": "open, close",
    "bag.plot": "plot",
    "bag.thumbnails": "thumbnails of images",
    "bag.record": "record",
    "bag.record.title": "Select name for new rosbag",
    "bag.record.topics": "Select the topics you want to record",
    "bag.recording": "recording: {count} messages, {size}; r stops",
    "bag.recording_paused": "recording paused: {count} messages, {size}; Space resumes",
    "bag.stop_recording": "stop recording",
    "bag.hold_recording": "pause, resume",
    "bag.save": "export the selected region",
    "bag.save.title": "Save selected region...",
    "bag.save.topics": "Which topics should be exported?",
    "bag.name.note": "A new folder: nothing is overwritten.",
    "bag.name.none": "It needs a name.",
    "bag.all": "All",
    "bag.tick": "tick",
    "bag.go_on": "continue",
    "bag.cancel": "cancel",
    "bag.menu": "menu",
    "bag.menu.publish": "Publish",
    "bag.menu.unpublish": "Stop publishing",
    "bag.menu.publish_all": "Publish All",
    "bag.menu.publish_none": "Publish None",
    "bag.menu.view": "View the message",
    "bag.menu.thumbnails": "Thumbnails",
    "bag.menu.reset": "Reset Timeline",
    "bag.menu.save": "Save Bag",
    "bag.menu.open": "Load Bag",
    "bag.menu.record": "Record Bag",
    "help.rqt_bag": (
        "A bag on a timeline: one line per topic, with taller bars where there are more messages. The red line is the "
        "playhead.\n\n"
        "Tick a topic (Enter) and its messages are published with their recorded quality of service: the newest message "
        "wherever you move the playhead, and every message while the bag plays. So Plot and RViz follow the playhead. (The "
        "real rqt_bag publishes only while it plays.) For frames to go back in time, RViz must follow the bag's clock: "
        "rqt_bag --clock, and use_sim_time for RViz.\n\n"
        "Click or drag in the timeline to move the playhead, drag in the ruler to select a region, turn the wheel to zoom, "
        "and drag with the middle button or Shift to move the view. Playback loops over the selected region, or over the "
        "whole bag. Only a bag's index is read at first, so large bags open at once.\n\n"
        "v shows the chosen topic's message or image at the playhead; Tab goes to its fields, where g types the command "
        "that plots one. w exports the selected region to a new bag, r records a new bag in place of the open one.\n\n"
        "The keys are those of the real rqt_bag, except for Up and Down: here they choose a topic, there they zoom like "
        "Page Up and Page Down. An rqt perspective remembers the open bags, the ticked topics, the region and the view."
    ),
}

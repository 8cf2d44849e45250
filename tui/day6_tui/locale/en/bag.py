"""rqt_bag."""

TEXTS = {
    "bag.none": "No bag is open: o opens one.",
    "bag.cut": "'{name}' is not complete: it is shown as far as it goes.",
    "bag.cancelled": "Cancelled: '{name}' is shown as far as it was read.",
    "bag.empty": "'{name}' has no messages.",
    "bag.messages": "{count} messages",
    "bag.open": "open",
    "bag.open.title": "Open a bag",
    "bag.open.note": "The bag's folder, or a file of it (.mcap, .db3).",
    "bag.play": "play",
    "bag.pause": "pause",
    "bag.publish": "publish",
    "bag.unpublish": "no longer publish",
    "bag.publish_all": "publish all, none",
    "bag.speed": "faster, slower",
    "bag.step": "previous, next message",
    "bag.choose": "choose a topic",
    "bag.pan": "move what is seen",
    "bag.scrub": "move the playhead",
    "bag.zoom": "zoom in, out",
    "bag.fit": "see everything",
    "bag.ends": "to the beginning, the end",
    "bag.region": "select from here, until here",
    "bag.no_region": "select nothing",
    "bag.open.other": "another one …",
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
    "bag.recording_paused": "recording paused: {count} messages, {size}; Space goes on",
    "bag.stop_recording": "stop recording",
    "bag.hold_recording": "pause, go on",
    "bag.save": "export the selected region",
    "bag.save.title": "Save selected region...",
    "bag.save.topics": "Which topics are exported?",
    "bag.name.note": "A new folder: nothing is overwritten.",
    "bag.name.none": "It needs a name.",
    "bag.all": "All",
    "bag.tick": "tick",
    "bag.go_on": "go on",
    "bag.cancel": "cancel",
    "bag.menu": "menu",
    "bag.menu.publish": "Publish",
    "bag.menu.unpublish": "No longer publish",
    "bag.menu.publish_all": "Publish All",
    "bag.menu.publish_none": "Publish None",
    "bag.menu.view": "View the message",
    "bag.menu.thumbnails": "Thumbnails",
    "bag.menu.reset": "Reset Timeline",
    "bag.menu.save": "Save Bag",
    "bag.menu.open": "Load Bag",
    "bag.menu.record": "Record Bag",
    "help.rqt_bag": (
        "A bag on a timeline: a line for each topic, with higher bars where there are more messages. The red line is the "
        "playhead.\n\nTick a topic (Enter) and its messages are published, with the recorded quality of service: its newest "
        "message wherever the playhead is moved to, and every message while it plays. So Plot and RViz follow the playhead. "
        "(The real rqt_bag publishes only while it plays.) Frames go back in time only in an RViz that goes by the bag's clock: "
        "rqt_bag --clock, and use_sim_time for RViz.\n\nClick or drag in the timeline to move the playhead, drag in the "
        "ruler to select a region, turn the wheel to zoom, drag with the middle button or Shift to move what is seen. Playing "
        "goes around in the selected region, or in everything. Of a bag only its index is read: large ones open at once.\n\n"
        "v shows the message or image of the chosen topic at the playhead; Tab goes to its fields, where g types the command "
        "that plots one. w exports the selected region to a new bag, r records a new one in place of what is open.\n\n"
        "Keys are the real one's, but for Up and Down: they choose a topic here, there they zoom as Page Up and Page Down do. "
        "A perspective of rqt keeps the open bags, the ticked topics, the region and what is seen."
    ),
}

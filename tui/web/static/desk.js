// Connects and shows the raw output; the page with a terminal takes its place.
const screen = document.getElementById("screen");
const address = new URL("ws?cols=80&rows=24&w=0&h=0", location.href);
address.protocol = address.protocol.replace("http", "ws");
const socket = new WebSocket(address);
const decoder = new TextDecoder();
let shown = 0;
socket.binaryType = "arraybuffer";
socket.onmessage = (message) => {
  if (typeof message.data === "string") {
    screen.append(message.data + "\n");
    return;
  }
  shown += message.data.byteLength;
  screen.append(decoder.decode(message.data, { stream: true }));
  socket.send(JSON.stringify({ t: "ack", bytes: shown }));
};
document.onkeydown = (event) => {
  if (event.key.length === 1) socket.send(new TextEncoder().encode(event.key));
};

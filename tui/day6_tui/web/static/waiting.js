/** Somebody waits to be let in: asks whether the teacher has decided, and says so when nobody answers. */

import { asked } from "./connection.js";

const ASK_MS = 3000;
const PENDING = 204;

async function ask() {
  const answer = await asked(location.href);
  document.getElementById("lost").hidden = answer !== null;
  if (answer !== null && answer.status !== PENDING) location.reload(); // which may hang, too
  setTimeout(ask, ASK_MS);
}

setTimeout(ask, ASK_MS);

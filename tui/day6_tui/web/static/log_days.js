/** The log of the lesson of earlier days: choosing one saves it. */

import { line } from "./rows.js";

const FILE = "class/log.csv"; // without a day, today's

/** Fill the choice with the days of which there is a log; with today alone there is nothing to choose. */
export function offerDays(select, days, texts) {
  const known = (Array.isArray(days) ? days : []).map((day) => line(day));
  select.hidden = known.length < 2;
  select.replaceChildren(new Option(texts.say("class.log.days"), ""), ...known.map((day) => new Option(day, day)));
  select.onchange = () => {
    const link = document.createElement("a");
    link.href = `${FILE}?day=${encodeURIComponent(select.value)}`;
    link.download = "";
    select.value = "";
    link.click();
  };
}

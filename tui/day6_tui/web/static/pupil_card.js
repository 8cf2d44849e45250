/** One pupil in the grid: what he does, and his screen in small. */

import { Mirror } from "./mirror.js";

const IDLE_SECONDS = 120; // less is reading

/** A copy of a template's element, with its texts. */
export function fromTemplate(id, texts) {
  const element = document.getElementById(id).content.firstElementChild.cloneNode(true);
  texts.write(element);
  return element;
}

/** Write a text, if it is another: what has the role of a status is read out at each write. */
export function put(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

export class PupilCard {
  /**
   * `open()` is for looking at the screen, `peek(on)` as long as the mouse or the focus is on it, `lower()` for taking the hand
   * down, `remove()` for taking the pupil out of the class, `choose(on, toHere)` for whom the tools are meant.
   */
  constructor(texts, { open, peek, lower, remove, choose }) {
    this.element = fromTemplate("pupil", texts);
    this._texts = texts;
    this._mirror = null;
    this._find = (name) => this.element.querySelector(`.${name}`);
    this._find("open").addEventListener("click", open);
    this.screen.addEventListener("click", open);
    for (const [what, on] of [["pointerenter", true], ["pointerleave", false]]) {
      this.screen.addEventListener(what, (event) => event.pointerType === "mouse" && peek(on));
    }
    for (const [what, on] of [["focus", true], ["blur", false]]) {
      this._find("open").addEventListener(what, (event) => peek(on && event.target.matches(":focus-visible")));
    }
    this._find("hand").addEventListener("click", lower);
    this._find("remove").addEventListener("click", remove);
    this._find("choose").addEventListener("click", (event) => choose(event.target.checked, event.shiftKey));
  }

  /** The small one. */
  get screen() {
    return this._find("small-screen");
  }

  /**
   * Show a row (`rows.js`); with `screens` its screen, too, and with `zooms` what of it can be read; and whether it is chosen.
   * Of who is not there it says only that, and the lesson where it ended.
   */
  show(row, { screens, zooms, isChosen }) {
    const { _find: find, _texts: texts } = this;
    this.element.dataset.state = row.state;
    this.element.classList.toggle("hand-up", row.hand);
    put(find("name"), row.shownName);
    find("choose").checked = isChosen;
    find("choose").setAttribute("aria-label", texts.say("pupil.choose", { name: row.shownName }));
    put(find("state"), texts.say(`state.${row.state}`));
    for (const badge of ["hand", "watched", "seen", "frozen"]) find(badge).hidden = !row[badge];
    find("hand").title = texts.say("pupil.lower", { name: row.shownName });
    find("lesson").hidden = !row.runs && !row.lesson;
    this._showLesson(row.lesson);
    find("trouble").hidden = !row.trouble;
    if (row.trouble) put(find("trouble"), [row.trouble.title, row.trouble.line].filter(Boolean).join(" — "));
    find("nodes").hidden = !row.runs;
    put(find("nodes"), row.nodes.length ? texts.say("pupil.nodes", { nodes: row.nodes.join(" ") }) : texts.say("pupil.no_nodes"));
    find("reply").hidden = !row.reply;
    put(find("reply"), row.reply);
    find("idle").hidden = row.idle < IDLE_SECONDS;
    put(find("idle"), texts.say("pupil.idle", { minutes: Math.floor(row.idle / 60) }));
    find("address").hidden = !row.address;
    put(find("address"), texts.say("pupil.address", { address: row.address }));
    find("remove").hidden = row.runs || row.isListed;
    find("open").hidden = !row.runs;
    find("open").setAttribute("aria-label", `${texts.say("pupil.open")}: ${row.shownName}`);
    this._showScreen(screens ? row.screen : null, zooms);
  }

  _showLesson(lesson) {
    const { _find: find, _texts: texts } = this;
    const bar = this.element.querySelector("progress");
    put(find("title"), lesson ? lesson.title : texts.say("pupil.no_lesson"));
    put(find("step"), lesson ? texts.say(lesson.solved ? "pupil.solved" : "pupil.step", lesson) : "");
    find("hints").hidden = !lesson?.hints;
    if (lesson) put(find("hints"), texts.say("pupil.hints", lesson));
    bar.hidden = !lesson;
    if (lesson) bar.value = lesson.all ? Math.min(1, lesson.step / lesson.all) : 0;
  }

  _showScreen(screen, zooms) {
    const place = this.screen;
    place.hidden = !screen;
    if (!screen) {
      this._mirror?.close();
      this._mirror = null;
      return;
    }
    this._mirror ??= new Mirror(place);
    this._mirror.show(screen, { zooms });
  }

  close() {
    this._mirror?.close();
    this.element.remove();
  }
}

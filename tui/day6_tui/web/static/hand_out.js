/** The form by which an assignment is handed out. */

import { line } from "./rows.js";

const MOST_FILES = 200;
const LARGEST = 10 << 20;

export class HandOut {
  /** `give(order)` hands it out; `chosen()` are the names of the chosen pupils or null; `lessons()` are [{name, title, drill}]. */
  constructor(form, texts, { give, chosen, lessons }) {
    this._form = form;
    this._texts = texts;
    this._give = give;
    this._chosen = chosen;
    this._lessons = lessons;
    this._find = (name) => form.querySelector(`.${name}`);
    form.addEventListener("submit", (event) => {
      event.preventDefault();
      this._submit();
    });
    this._find("cancel").addEventListener("click", () => this.close());
    this._find("kind").addEventListener("change", () => this._fill());
  }

  open() {
    const chosen = this._chosen();
    this._form.reset();
    this._form.hidden = false;
    this._say("");
    this._names = chosen;
    const to = this._find("to");
    to.replaceChildren(new Option(this._texts.say("assign.to.all"), "*"));
    if (chosen) to.append(new Option(this._texts.say("assign.to.chosen", { count: chosen.length }), "chosen", true, true));
    this._fill();
    this._find("kind").focus();
  }

  close() {
    this._form.hidden = true;
  }

  get _kind() {
    return this._find("kind").value;
  }

  _fill() {
    const kind = this._kind;
    const { language } = this._texts;
    const found = this._lessons().filter((each) => (each.drill === true) === (kind === "drill"));
    this._find("what").replaceChildren(...found.map(({ name, title }) => new Option(line(title?.[language] ?? title?.en ?? name), String(name))));
    this._find("for-what").hidden = kind !== "lesson" && kind !== "drill";
    this._find("for-folder").hidden = kind !== "folder";
  }

  _say(text) {
    this._find("sending").textContent = text;
  }

  async _submit() {
    const due = this._find("due").value;
    const order = {
      kind: this._kind,
      names: this._kind === "lesson" || this._kind === "drill" ? [this._find("what").value] : [],
      to: this._find("to").value === "*" ? "*" : this._names,
      due: due ? new Date(due).getTime() / 1000 : 0,
      title: this._find("title").value,
    };
    if (order.kind === "folder") {
      order.upload = await this._upload([...this._find("folder").files]);
      if (!order.upload) return;
    }
    this._give(order);
  }

  /** Send the files of the chosen folder; returns the key by which the server knows them, "" if that failed. */
  async _upload(files) {
    const texts = this._texts;
    const path = (file) => file.webkitRelativePath || file.name;
    const shown = files.filter((file) => !path(file).split("/").some((part) => part.startsWith(".")));
    if (!shown.length) return this._wrong("empty");
    if (shown.length > MOST_FILES || shown.reduce((sum, file) => sum + file.size, 0) > LARGEST) return this._wrong("large");
    let key = "0";
    for (const [done, file] of shown.entries()) {
      this._say(texts.say("assign.sending", { done, all: shown.length }));
      try {
        const about = new URLSearchParams({ upload: key, path: path(file) });
        const answer = await fetch(`class/assignments/upload?${about}`, { method: "PUT", body: file });
        const told = await answer.json();
        if (!answer.ok) return this._wrong(told.wrong === "large" ? "large" : "busy");
        key = told.upload;
      } catch {
        return this._wrong("network");
      }
    }
    this._say("");
    return key;
  }

  _wrong(why) {
    this._say(this._texts.say(`assign.wrong.${why}`));
    return "";
  }
}

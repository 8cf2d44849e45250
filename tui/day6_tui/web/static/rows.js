/**
 * What the server tells about pupils, made safe to show. All of it comes from the pupils' machines and programs: every value is
 * checked for its kind and clipped here, and goes onto the page as text only.
 */

const LONGEST_TEXT = 120;
const LONGEST_NAME = 60;
const MOST_NODES = 40;
const LONGEST_SCREEN = 200_000;
const MOST_COLUMNS = 500;
const MOST_ROWS = 200;

/** One line of readable text; "" for anything else. */
export function line(value, longest = LONGEST_TEXT) {
  if (typeof value !== "string") return "";
  const clean = value.replace(/[\p{Cc}\p{Cf}\p{Zl}\p{Zp}]/gu, " ").trim();
  const characters = [...clean];
  return characters.length > longest ? characters.slice(0, longest - 1).join("") + "…" : clean;
}

/** Names one after the other, as the language does it. */
export function names(several, texts) {
  return several.map((name) => line(String(name), LONGEST_NAME)).join(texts.say("names.between"));
}

function whole(value) {
  return Number.isFinite(value) ? Math.max(0, Math.trunc(value)) : 0;
}

/** A text that comes in several languages. */
function titled(value, language) {
  return typeof value === "string" ? line(value) : line(value?.[language]) || line(value?.en) || line(value?.zh);
}

function lessonOf(value, language) {
  if (!value || typeof value !== "object") return null;
  const title = titled(value.title, language) || line(value.name);
  return { title, step: whole(value.step), all: whole(value.all), solved: value.solved === true, hints: whole(value.hints) };
}

function troubleOf(value, language) {
  if (!value || typeof value !== "object") return null;
  return { title: titled(value.title, language), line: line(value.line, 200) };
}

/** Colours stay, everything else that could act on a terminal goes. */
export function harmlessScreen(text) {
  return text.replace(/\x1b(?!\[[0-9;:]*m)/g, "").replace(/[\x00-\x09\x0b-\x1a\x1c-\x1f\x7f-\x9f]/g, "");
}

function screenOf(value) {
  if (!value || typeof value.ansi !== "string" || value.ansi.length > LONGEST_SCREEN) return null;
  const cols = Math.min(MOST_COLUMNS, whole(value.columns));
  const rows = Math.min(MOST_ROWS, whole(value.rows));
  return cols && rows ? { cols, rows, ansi: harmlessScreen(value.ansi) } : null;
}

/** Why the teacher is asked about a newcomer. */
const WHYS = new Set(["all", "many", "removed", "files"]);

/** In the order in which they come on the page: with and without a tab, who found no room, who has left, who never came. */
const STATES = ["here", "away", "full", "gone", "absent"];

/** Whether the desktop runs: only then there is something to see, and somebody to take orders. */
export function runs(state) {
  return state === "here" || state === "away";
}

/** What a desktop says of itself now; the last word of one that has ended is not true any more. */
function nowOf(row) {
  const nodes = Array.isArray(row.nodes) ? row.nodes : [];
  return {
    nodes: nodes.slice(0, MOST_NODES).map((node) => line(node, 80)).filter(Boolean),
    hand: row.hand === true,
    idle: whole(row.idle),
    watched: row.watched === true,
    seen: row.seen === true,
    frozen: row.frozen === true,
    asked: row.asked === true,
    mayType: row.may_type === true,
    refused: line(row.refused),
    screen: screenOf(row.screen),
  };
}

/** A row as the page shows it. `name` stays as it is: orders go to it. */
export function shownRow(row, language) {
  const state = STATES.includes(row.state) ? row.state : "gone";
  return {
    name: String(row.name),
    shownName: line(String(row.name), LONGEST_NAME),
    state,
    runs: runs(state),
    address: line(row.address, LONGEST_NAME),
    isListed: row.listed === true,
    lesson: lessonOf(row.lesson, language),
    trouble: troubleOf(row.trouble, language),
    ...nowOf(runs(state) ? row : {}),
  };
}

/** Who waits to be let in, made safe to show, by where they come from: {address, newcomers}; a crowd from one place comes last. */
export function places(waiting) {
  const found = new Map();
  for (const { id, name, address, source, why } of Array.isArray(waiting) ? waiting : []) {
    const place = String(source);
    if (!found.has(place)) found.set(place, { address: line(address, LONGEST_NAME), newcomers: [] });
    found.get(place).newcomers.push({ id: whole(id), name: line(name, LONGEST_NAME), why: WHYS.has(why) ? why : "all" });
  }
  return [...found.values()].sort((a, b) => a.newcomers.length - b.newcomers.length);
}

/** Raised hands first, who is not there last; otherwise as the server has them. */
export function ordered(rows) {
  const rank = (row) => (row.runs ? Number(!row.hand) : STATES.indexOf(row.state));
  return [...rows].sort((a, b) => rank(a) - rank(b));
}

/** One cell of a CSV file; a spreadsheet must not take it for a formula. */
function csvCell(value) {
  const text = String(value);
  const plain = /^[=+\-@\t\r]/.test(text) ? `'${text}` : text;
  return `"${plain.replaceAll('"', '""')}"`;
}

/** What is in each column of the report; `report.column.<name>` stands above it. */
const COLUMNS = {
  name: (row) => row.shownName,
  state: (row, texts) => texts.say(`state.${row.state}`),
  lesson: (row) => row.lesson?.title ?? "",
  step: (row) => row.lesson?.step ?? "",
  steps: (row) => row.lesson?.all ?? "",
  solved: (row) => (row.lesson ? Number(row.lesson.solved) : ""),
  hints: (row) => row.lesson?.hints ?? "",
  trouble: (row) => row.trouble?.title ?? "",
  line: (row) => row.trouble?.line ?? "",
  idle: (row) => (row.runs ? row.idle : ""),
  hand: (row) => (row.hand ? 1 : 0),
  nodes: (row) => row.nodes.join(" "),
  address: (row) => row.address,
};

/** The class as a CSV file that Excel opens, too. */
export function report(rows, texts) {
  const head = Object.keys(COLUMNS).map((column) => texts.say(`report.column.${column}`));
  const lines = rows.map((row) => Object.values(COLUMNS).map((cell) => cell(row, texts)));
  return "\ufeff" + [head, ...lines].map((cells) => cells.map(csvCell).join(",") + "\r\n").join("");
}

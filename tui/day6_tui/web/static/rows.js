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

function lessonOf(value, language, lessons) {
  if (!value || typeof value !== "object") return null;
  const title = titled(value.title, language) || line(value.name);
  const rank = lessons.indexOf(value.name); // in the order in which lessons come
  return { title, rank, step: whole(value.step), all: whole(value.all), solved: value.solved === true, hints: whole(value.hints) };
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
  return cols && rows ? { cols, rows, ansi: harmlessScreen(value.ansi), work: workOf(value.work) } : null;
}

/** What the pupil works in, in cells; the server has judged it. */
function workOf(value) {
  if (!Array.isArray(value)) return null;
  const [x, y, cols, rows, line] = value.map(whole);
  return cols && rows ? { x, y, cols, rows, line } : null;
}

/** Why the teacher is asked about a newcomer. */
const WHYS = new Set(["all", "many", "removed", "files", "listed", "known"]);
const CLAIMS = new Set(["listed", "known"]);

/** The text that says why; of who says to be a pupil that there is, what the teacher can judge that by. */
function whyOf({ why, was, here }) {
  if (!CLAIMS.has(why)) return WHYS.has(why) ? why : "all";
  return here === true ? "here" : line(was) ? "was" : why;
}

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
    raised: whole(row.raised),
    onStep: whole(row.on_step),
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
export function shownRow(row, language, lessons = []) {
  const state = STATES.includes(row.state) ? row.state : "gone";
  return {
    name: String(row.name),
    shownName: line(String(row.name), LONGEST_NAME),
    state,
    runs: runs(state),
    address: line(row.address, LONGEST_NAME),
    isListed: row.listed === true,
    place: whole(row.place),
    lesson: lessonOf(row.lesson, language, lessons),
    trouble: troubleOf(row.trouble, language),
    ...nowOf(runs(state) ? row : {}),
  };
}

/** Who waits to be let in, made safe to show, by where they come from: {address, newcomers}; a crowd from one place comes last. */
export function places(waiting) {
  const found = new Map();
  for (const newcomer of Array.isArray(waiting) ? waiting : []) {
    const { id, name, address, was } = newcomer;
    const place = String(newcomer.source);
    if (!found.has(place)) found.set(place, { address: line(address, LONGEST_NAME), newcomers: [] });
    const shown = { id: whole(id), name: line(name, LONGEST_NAME), why: whyOf(newcomer), was: line(was, LONGEST_NAME) };
    found.get(place).newcomers.push({ ...shown, isClaim: CLAIMS.has(newcomer.why) });
  }
  return [...found.values()].sort((a, b) => a.newcomers.length - b.newcomers.length);
}

/** How far a pupil is, as numbers to compare: who has no lesson open is furthest behind. */
function farness(row) {
  return row.lesson ? [1 + row.lesson.rank, row.lesson.step, Number(row.lesson.solved)] : [0, 0, 0];
}

/** The orders of those who are there; what they leave open is as the server has it: who waits longest first. */
export const ORDERS = {
  need: (a, b) => Number(b.hand) - Number(a.hand),
  list: (a, b) => a.place - b.place,
  step: (a, b) => {
    const [one, two] = [farness(a), farness(b)];
    return one[0] - two[0] || one[1] - two[1] || one[2] - two[2];
  },
};

/** In one of ORDERS; who is not there last. */
export function ordered(rows, order = "need") {
  const rank = (row) => (row.runs ? 0 : STATES.indexOf(row.state));
  const inList = order === "list" ? ORDERS.list : () => 0;
  return [...rows].sort((a, b) => rank(a) - rank(b) || (a.runs ? ORDERS[order](a, b) : inList(a, b)));
}

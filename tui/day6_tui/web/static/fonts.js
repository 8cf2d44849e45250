/** Monospaced Latin first, then Chinese of the system; box and block characters are drawn, or come from the first of them. */
const LATIN = quoted([
  "Cascadia Mono", "JetBrains Mono", "DejaVu Sans Mono", "Menlo", "Consolas", "Noto Sans Mono", "Liberation Mono", "Roboto Mono",
]);
const CHINESE = [
  "Noto Sans Mono CJK SC", "Noto Sans CJK SC", "PingFang SC", "Microsoft YaHei", "WenQuanYi Zen Hei Mono", "WenQuanYi Zen Hei",
];
/** As some systems name the same faces. */
const FACES = ["NotoSansMonoCJKsc-Regular", "NotoSansCJKsc-Regular", "Noto Sans CJK SC Regular", "PingFangSC-Regular"];
const WIDE = "U+2E80-2FDF, U+3000-4DBF, U+4E00-9FFF, U+F900-FAFF, U+FE30-FE4F, U+FF00-FF60, U+FFE0-FFE6, U+20000-3FFFF";
const LOAD_MS = 1000;

function quoted(names) {
  return names.map((name) => `"${name}"`).join(", ");
}

const FILLING = "day6 Chinese";
const style = document.head.appendChild(document.createElement("style"));

/**
 * Make the system's Chinese letters so wide that one fills two cells: `cells` is how wide these are beside a letter's height. Their
 * square is narrower than two Latin letters (20 to 24 pixels), so they would stand wide apart. Where the system has none of the
 * faces the family is empty, and the next one is taken.
 */
export async function fillCells(cells) {
  const sources = [...CHINESE, ...FACES].map((name) => `local("${name}")`).join(", ");
  style.textContent = `@font-face { font-family: "${FILLING}"; src: ${sources}; unicode-range: ${WIDE};
    size-adjust: ${100 * cells}%; }`;
  const late = new Promise((resolve) => setTimeout(resolve, LOAD_MS));
  await Promise.race([document.fonts.load(`16px "${FILLING}"`, "海").catch(() => null), late]);
}

function measured(letters) {
  const context = document.createElement("canvas").getContext("2d");
  context.font = `100px ${LATIN}, monospace`;
  return context.measureText(letters).width / 100;
}

await fillCells(measured("WW")); // before there is a terminal: it remembers how wide letters are
export const FONTS = [LATIN, quoted([FILLING, ...CHINESE]), "monospace"].join(", ");

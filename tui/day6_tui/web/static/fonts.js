/** Monospaced Latin first, then Chinese of the system; box and block characters are drawn, or come from the first of them. */
export const FONTS = [
  "Cascadia Mono", "JetBrains Mono", "DejaVu Sans Mono", "Menlo", "Consolas", "Noto Sans Mono", "Liberation Mono", "Roboto Mono",
  "Noto Sans Mono CJK SC", "Noto Sans CJK SC", "PingFang SC", "Microsoft YaHei", "WenQuanYi Zen Hei Mono", "WenQuanYi Zen Hei",
].map((name) => `"${name}"`).join(", ") + ", monospace";

/** What the pages say, in Chinese and English. Text of ROS and of the desktop is never in here. */

const ZH = {
  "strip.connecting": "正在连接…",
  "strip.lost": "连接断开，正在重新连接…（第 {count} 次）",
  "strip.offline": "这台电脑没有网络，等网络恢复后自动连接…",
  "strip.taken": "你的桌面已在另一个标签页或另一台设备上打开。",
  "strip.left": "你离开了桌面；桌面和里面的程序继续运行。",
  "strip.left_by_pupil": "这个学生离开了桌面；桌面继续运行。",
  "strip.ended": "桌面已结束，文件都还在。",
  "strip.idle": "太久没有操作，桌面已结束，文件都还在。",
  "strip.disk": "你的文件太多，桌面已结束；文件都还在。请告诉老师。",
  "strip.full": "服务器已满，请告诉老师。过一会儿会自动再试。",
  "strip.server": "服务器正在停止。它一恢复就会自动连接…",
  "strip.restart": "老师正在重新启动你的桌面…",
  "strip.refused": "服务器没有让你进来：链接已失效，或者桌面现在打不开。请告诉老师。",
  "strip.removed": "老师把你移出了班级。文件都还在。",
  "starting.open": "桌面正在打开…",
  "starting.now": "你的桌面正在启动…",
  "starting.queued": "你的桌面马上启动…前面还有 {before} 个。",
  "starting.watched": "这个桌面正在启动…",
  "button.again": "现在再试",
  "button.take": "在这里打开",
  "button.start": "重新打开",
  "bar.label": "页面工具",
  "bar.watching": "只看，不能操作",
  "bar.latency": "{ms} 毫秒",
  "bar.latency.title": "按键到达服务器再返回所需的时间（中位数）",
  "bar.smaller": "字小一点",
  "bar.larger": "字大一点",
  "bar.keys": "显示或隐藏按键行（Ctrl、Esc、F1–F12…）",
  "bar.keyboard": "显示或隐藏屏幕键盘",
  "bar.copy": "复制选中的文字",
  "bar.paste": "粘贴",
  "bar.full": "全屏（这时 Ctrl+W、Ctrl+T、Ctrl+N 也归桌面）",
  "bar.help": "这个页面怎么用",
  "bar.mine": "老师的桌面",
  "shown.teacher": "老师的屏幕",
  "shown.pupil": "{name} 的屏幕",
  "shown.over": "展示结束了。",
  "shown.beside": "放在旁边",
  "shown.corner": "放在角上；再按一下换一个角",
  "shown.full": "放到最大",
  "shown.close": "关闭这个屏幕（老师展示时可以再打开）",
  "screen.label": "day6 桌面（终端）。用读屏软件：按 Ctrl+Shift+K，再打开“这个页面怎么用”，勾选“朗读新出现的文字”",
  "speak": "朗读新出现的文字（给读屏软件用）",
  "speak.log": "终端里新出现的文字",
  "speak.more": "前面还有 {count} 行",
  "keys.label": "按键行",
  "keys.choose": "选择按键…",
  "keys.choose.title": "按键行里有哪些键",
  "keys.chosen": "按键行（点一个键，再移动或去掉它）",
  "keys.others": "别的键（点一下就加进来）",
  "keys.earlier": "往前", "keys.later": "往后", "keys.remove": "去掉", "keys.reset": "恢复原样", "keys.done": "完成",
  "keys.left": "左", "keys.right": "右", "keys.up": "上", "keys.down": "下",
  "paste.title": "把文字粘贴到下面，再按“发送”。",
  "paste.send": "发送",
  "paste.close": "取消",
  "link.open": "老师发来的链接，点一下打开：",
  "copied": "已复制",
  "copy_needs_click": "这个浏览器要点一下才能复制：请按复制按钮。",
  "nothing_selected": "还没有可复制的文字。用鼠标在文字上拖动，松开就复制好了。",
  "nothing_selected.touch": "还没有可复制的文字。手指先按住文字不动，再拖动，松开就复制好了。",
  "help.title": "这个页面怎么用",
  "help.close": "关闭",
  "help.lines": [
    "直接打字就行，不用先点一下。F1 到 F10 和大多数 Ctrl 键都会送到桌面。",
    "Ctrl+W、Ctrl+T、Ctrl+N（有的浏览器还有 Ctrl+Q）由浏览器占用：请用按键行（⌨ 按钮）上的 ^W ^T ^N ^Q，或者先全屏。F11、F12 仍归浏览器。",
    "复制：用鼠标在文字上拖动，松开就复制好了，只在一个窗格里选。要跨窗格选（边框也会选进去），按住 Shift（Mac 上是 Option）再拖动，然后按 Ctrl+Shift+C。粘贴：Ctrl+V 或 Ctrl+Shift+V。",
    "字的大小：A− 和 A+，或浏览器的 Ctrl +/−。",
    "关掉标签页、合上电脑都没关系：桌面继续运行，再打开同一个链接就回来。",
    "触摸屏：用一根或两根手指上下拖动来滚动，两根手指张开、捏合改变字的大小；按住一个词就选中并复制它，按住不动再拖动就选更多。",
    "⌨ 旁边的按钮打开键盘；按键行上的 Ctrl 按一下，只对下一个键有效。按键行里有哪些键、怎么排，用它末尾的“选择按键…”改。",
    "不用鼠标：Ctrl+Shift+K 跳到这一行按钮，Esc 回到桌面。",
  ],
};

const EN = {
  "strip.connecting": "Connecting…",
  "strip.lost": "Connection lost, reconnecting… (attempt {count})",
  "strip.offline": "This computer is offline. It will reconnect as soon as the network is back…",
  "strip.taken": "Your desktop is open in another tab or on another device.",
  "strip.left": "You have left your desktop. It keeps running, and so do its programs.",
  "strip.left_by_pupil": "This pupil has left the desktop. It keeps running.",
  "strip.ended": "The desktop has ended. Your files are kept.",
  "strip.idle": "Nothing happened for a long time, so the desktop has ended. Your files are kept.",
  "strip.disk": "Your files take up too much space, so the desktop has ended; the files are all still there. Please tell your teacher.",
  "strip.full": "The server is full. Please tell your teacher. This page keeps trying.",
  "strip.server": "The server is stopping. This page will reconnect when it is back…",
  "strip.restart": "Your teacher is restarting your desktop…",
  "strip.refused": "The server refused: your link is no longer valid, or the desktop cannot be opened right now. Please tell your teacher.",
  "strip.removed": "Your teacher has removed you from the class. Your files are kept.",
  "starting.open": "The desktop is opening…",
  "starting.now": "Your desktop is starting…",
  "starting.queued": "Your desktop will start soon… {before} before you.",
  "starting.watched": "This desktop is starting…",
  "button.again": "Try now",
  "button.take": "Use it here",
  "button.start": "Open again",
  "bar.label": "Page tools",
  "bar.watching": "view only",
  "bar.latency": "{ms} ms",
  "bar.latency.title": "Time for a key to reach the server and come back (median)",
  "bar.smaller": "Smaller text",
  "bar.larger": "Larger text",
  "bar.keys": "Show or hide the key row (Ctrl, Esc, F1–F12 …)",
  "bar.keyboard": "Show or hide the on-screen keyboard",
  "bar.copy": "Copy the selected text",
  "bar.paste": "Paste",
  "bar.full": "Full screen (then Ctrl+W, Ctrl+T and Ctrl+N reach the desktop, too)",
  "bar.help": "How to use this page",
  "bar.mine": "the teacher's desktop",
  "shown.teacher": "The teacher's screen",
  "shown.pupil": "{name}'s screen",
  "shown.over": "The screen is no longer shown.",
  "shown.beside": "Side by side",
  "shown.corner": "In a corner; press again for the next corner",
  "shown.full": "As large as possible",
  "shown.close": "Close this screen (you can open it again while it is shown)",
  "screen.label": "day6 desktop (terminal). With a screen reader: press Ctrl+Shift+K, open “How to use this page” and turn on “Read new lines aloud”",
  "speak": "Read new lines aloud (for screen readers)",
  "speak.log": "New lines in the terminal",
  "speak.more": "{count} more lines before",
  "keys.label": "Key row",
  "keys.choose": "Choose keys…",
  "keys.choose.title": "Keys in the key row",
  "keys.chosen": "Key row (tap a key, then move or remove it)",
  "keys.others": "Other keys (tap to add)",
  "keys.earlier": "Earlier", "keys.later": "Later", "keys.remove": "Remove", "keys.reset": "As it was at first", "keys.done": "Done",
  "keys.left": "Left", "keys.right": "Right", "keys.up": "Up", "keys.down": "Down",
  "paste.title": "Paste your text below, then press Send.",
  "paste.send": "Send",
  "paste.close": "Cancel",
  "link.open": "A link from your teacher; click to open it:",
  "copied": "Copied",
  "copy_needs_click": "This browser only copies after a click: press the copy button.",
  "nothing_selected": "Nothing to copy yet. Drag over the text with the mouse and let go to copy it.",
  "nothing_selected.touch": "Nothing to copy yet. Rest a finger on the text, drag, and let go to copy it.",
  "help.title": "How to use this page",
  "help.close": "Close",
  "help.lines": [
    "Just type; no click needed. F1 to F10 and most Ctrl keys reach the desktop.",
    "Ctrl+W, Ctrl+T, Ctrl+N (and Ctrl+Q in some browsers) belong to the browser: use ^W ^T ^N ^Q on the key row (the ⌨ button), or go full screen first. F11 and F12 stay with the browser.",
    "Copy: drag over the text with the mouse and let go. This works within one pane: to select across panes, hold Shift (Option on a Mac) and drag, then press Ctrl+Shift+C. Paste: Ctrl+V or Ctrl+Shift+V.",
    "Text size: A− and A+, or the browser's Ctrl +/−.",
    "Close the tab or the laptop whenever you like: the desktop keeps running, and the same link brings it back.",
    "Touch: drag with one or two fingers to scroll, pinch to change the text size; hold a word to select and copy it, or hold, then drag, to select more.",
    "The button beside ⌨ opens the keyboard; Ctrl on the key row applies only to the next key. “Choose keys…” at the end of the key row changes which keys it has and their order.",
    "Without a mouse: Ctrl+Shift+K goes to this row of buttons, Esc back to the desktop.",
  ],
};

/** "zh" or "en" for a language as browsers and servers name it. */
export function language(name) {
  return String(name || "").toLowerCase().startsWith("zh") ? "zh" : "en";
}

/** The texts of one language: `say(key, {name: value})`; `more` is a further table for each language. */
export class Texts {
  constructor(name, more = { zh: {}, en: {} }) {
    this.language = language(name);
    this._table = { ...(this.language === "zh" ? ZH : EN), ...more[this.language] };
  }

  say(key, values = {}) {
    return this._table[key].replace(/\{(\w+)\}/g, (_, name) => String(values[name]));
  }

  lines(key) {
    return this._table[key];
  }

  /** Write everything below `root` that names its text in data-text (its content) or data-label (for screen readers). */
  write(root) {
    if (root === document) document.documentElement.lang = this.language === "zh" ? "zh-CN" : "en";
    for (const element of root.querySelectorAll("[data-text]")) element.textContent = this.say(element.dataset.text);
    for (const element of root.querySelectorAll("[data-label]")) {
      const label = this.say(element.dataset.label);
      element.setAttribute("aria-label", label);
      if (element.matches("button, [data-hover]")) element.title = label;
      if (element.matches("input")) element.placeholder = label;
    }
  }
}

/** Every key of both tables, for the test that compares them. */
export const KEYS = { zh: Object.keys(ZH), en: Object.keys(EN) };

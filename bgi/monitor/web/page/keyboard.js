// A keyboard on the page: for phones, and for keys that the browser keeps for itself.

const WAIT = 500, AGAIN = 33; // milliseconds until a key repeats, and from then on

const NAMED = {
  Esc: ["Escape", "Escape"],
  "⌫": ["Backspace", "Backspace"],
  Tab: ["Tab", "Tab"],
  Enter: ["Enter", "Enter"],
  Space: ["Space", " "],
  Ins: ["Insert", "Insert"],
  Del: ["Delete", "Delete"],
  Home: ["Home", "Home"],
  End: ["End", "End"],
  PgUp: ["PageUp", "PageUp"],
  PgDn: ["PageDown", "PageDown"],
  "←": ["ArrowLeft", "ArrowLeft"],
  "↑": ["ArrowUp", "ArrowUp"],
  "↓": ["ArrowDown", "ArrowDown"],
  "→": ["ArrowRight", "ArrowRight"],
};
const CHANGING = { Shift: ["ShiftLeft", 1], Ctrl: ["ControlLeft", 2], Alt: ["AltLeft", 4] };
// A character, the one with Shift, and where it lies.
const SIGNS = {
  "`": ["~", "Backquote"], "-": ["_", "Minus"], "=": ["+", "Equal"], "[": ["{", "BracketLeft"],
  "]": ["}", "BracketRight"], ";": [":", "Semicolon"], "'": ['"', "Quote"], "\\": ["|", "Backslash"],
  ",": ["<", "Comma"], ".": [">", "Period"], "/": ["?", "Slash"],
};
const OVER_DIGITS = ")!@#$%^&*(";
const ROWS = [
  "Esc F1 F2 F3 F4 F5 F6 F7 F8 F9 F10 F11 F12",
  "` 1 2 3 4 5 6 7 8 9 0 - = ⌫",
  "Tab q w e r t y u i o p [ ] \\",
  "Ins a s d f g h j k l ; ' Enter",
  "Shift z x c v b n m , . / ↑ Del",
  "Ctrl Alt Home End Space PgUp PgDn ← ↓ →",
];

export class Keyboard {
  #mods = 0;
  #signs = []; // the buttons of characters

  constructor(place, keys) {
    this.place = place;
    this.keys = keys;
    for (const row of ROWS) {
      const line = document.createElement("div");
      line.append(...row.split(" ").map((name) => this.#button(name)));
      place.append(line);
    }
  }

  #button(name) {
    const button = document.createElement("button");
    button.textContent = name;
    button.tabIndex = -1;
    button.className = { Space: "space", Enter: "wide", Shift: "wide", Tab: "wide" }[name] ?? "";
    if (name.length === 4) button.className = "long";
    const sign = signOf(name);
    if (sign) this.#signs.push([button, sign]);
    let repeating = 0;
    button.onpointerdown = (event) => {
      event.preventDefault();
      if (name in CHANGING) return this.#toggle(name, button);
      button.setPointerCapture(event.pointerId);
      const [code, key] = sign ? [sign[2], sign[this.#mods & 1]] : NAMED[name] ?? [name, name];
      const press = (again) => this.keys.press(this.#mods, code, key, again);
      press(false);
      const repeat = () => {
        press(true);
        repeating = setTimeout(repeat, AGAIN);
      };
      repeating = setTimeout(repeat, WAIT);
      button.onpointerup = button.onpointercancel = () => {
        clearTimeout(repeating);
        button.onpointerup = button.onpointercancel = null;
        this.keys.release(this.#mods, code);
        this.#letGo();
      };
    };
    return button;
  }

  // Shift and its like stay down until another key was pressed.
  #toggle(name, button) {
    const [code, flag] = CHANGING[name];
    this.#mods ^= flag;
    if (this.#mods & flag) this.keys.press(this.#mods, code, name === "Ctrl" ? "Control" : name);
    else this.keys.release(this.#mods, code);
    button.classList.toggle("on", Boolean(this.#mods & flag));
    this.#label();
  }

  #letGo() {
    for (const [name, [, flag]] of Object.entries(CHANGING)) {
      if (!(this.#mods & flag)) continue;
      const button = [...this.place.querySelectorAll("button")].find((b) => b.textContent === name);
      this.#toggle(name, button);
    }
  }

  #label() {
    for (const [button, sign] of this.#signs) button.textContent = sign[this.#mods & 1];
  }
}

// A character, the one with Shift, and where it lies on the keyboard; undefined for other keys.
function signOf(name) {
  if (name in SIGNS) return [name, ...SIGNS[name]];
  if (/^[a-z]$/.test(name)) return [name, name.toUpperCase(), `Key${name.toUpperCase()}`];
  if (/^[0-9]$/.test(name)) return [name, OVER_DIGITS[name], `Digit${name}`];
  return undefined;
}

// Keys: all go to the program, but for those that are for the window itself.

const [SHIFT, CTRL, ALT, ALTGR, NUM, CAPS] = [1, 2, 4, 8, 16, 32]; // web/browserkeys.py
const CHANGING = { Shift: SHIFT, Control: CTRL, Alt: ALT };

export class Keys {
  // `hot` are functions by the names of keys: "F11", "Alt-Enter", "Control-F5".
  constructor(line, hot) {
    this.line = line;
    this.hot = hot;
    this.active = false; // whether this page types
    addEventListener("keydown", (event) => this.#down(event));
    addEventListener("keyup", (event) => this.#up(event));
    addEventListener("blur", () => line.say("blur"));
  }

  #down(event) {
    // Windows and Command keys speak to the desktop.
    if (!this.active || event.metaKey || event.isComposing) return;
    event.preventDefault();
    this.press(modifiers(event), event.code, event.key, event.repeat);
  }

  #up(event) {
    if (this.active) this.release(modifiers(event), event.code);
  }

  press(mods, code, key, repeat = false) {
    const held = Object.keys(CHANGING).filter((name) => mods & CHANGING[name]);
    const action = this.hot[[...held, key].join("-")];
    if (action) {
      if (!repeat) action();
    } else if (code && sayable(key)) {
      this.line.say("down", mods, code, key);
    }
  }

  release(mods, code) {
    if (code) this.line.say("up", mods, code);
  }
}

function modifiers(event) {
  const locked = (name, flag) => (event.getModifierState(name) ? flag : 0);
  return (
    (event.shiftKey ? SHIFT : 0) | (event.ctrlKey ? CTRL : 0) | (event.altKey ? ALT : 0) |
    locked("AltGraph", ALTGR) | locked("NumLock", NUM) | locked("CapsLock", CAPS)
  );
}

// One character, or a name.
function sayable(key) {
  return [...key].length === 1 || /^[A-Z][A-Za-z0-9]{1,24}$/.test(key);
}

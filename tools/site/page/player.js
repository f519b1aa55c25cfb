// A screen with its buttons and what the program prints: the gallery's, or one under a piece of code.

import { isolate } from "./isolate.js";
import { Machine } from "./machine.js";
import { png } from "./png.js";
import { Windows } from "./windows.js";

// Where a program's line is named: Python's way, and that of a compiler for C.
const WHERE = /program.*?", line (\d+)|File ".*\/programs\/[^"]*", line (\d+)|^[\w-]+\.\w+:(\d+):\d+: /gm;
const LINES_KEPT = 1000;
const SHORT = 500; // milliseconds that a program runs which asks for no keys

const LAYOUT = `
  <div class="bar">
    <button data-action="run">Run</button>
    <button data-action="stop" disabled>Stop</button>
    <button data-action="keys" title="A keyboard on the page">Keys</button>
    <button data-action="full" title="The whole screen, and back: F11">Full screen</button>
    <button data-action="save" title="Save the picture: F12">Picture</button>
    <button data-action="lens" title="Pixels enlarged: Ctrl-F6; around the mouse or the last one set: Ctrl-F8">Lens</button>
    <button data-action="board" title="Palette, pages, viewport: Ctrl-F7">Board</button>
    <span class="title"></span>
  </div>
  <div class="screens" tabindex="0" aria-label="The screen of the program"></div>
  <div class="loading" hidden><progress max="1" value="0"></progress> <span>Loading Python …</span></div>
  <div class="keyboard" hidden></div>
  <pre class="printed" hidden></pre>
  <form class="answer" hidden><input aria-label="What the program asks for" autocomplete="off"><button>Enter</button></form>
`;

export class Player {
  machine = null; // from the first Run on
  #text = "";
  #shared;
  #keysDue = 0;

  // `program()` is asked for {name, program} at Run; `wrong(line)` is told where an error is.
  constructor(place, site, program, wrong = () => {}) {
    place.classList.add("player");
    place.innerHTML = LAYOUT;
    this.place = place;
    this.program = program;
    this.wrong = wrong;
    this.site = site;
    this.#shared = isolate(); // at once: the page may be loaded once more for it
    this.actions = {
      run: () => this.run(),
      stop: () => this.machine?.stop(),
      keys: () => this.#toggle(".keyboard"),
      full: () => this.#fullScreen(),
      save: () => this.#save(),
      lens: () => this.windows.enlarge(),
      board: () => this.windows.toggleBoard(),
    };
    for (const [action, act] of Object.entries(this.actions)) this.#button(action).onclick = act;
    const hot = {
      F11: this.actions.full,
      F12: this.actions.save,
      "Control-F6": this.actions.lens,
      "Control-F7": this.actions.board,
      "Control-F8": () => this.windows.follow(),
    };
    const say = (line) => this.machine?.say(line);
    this.windows = new Windows(this.#find(".screens"), this.#find(".keyboard"), say, hot, (title) => {
      this.#find(".title").textContent = title;
    });
    this.#find(".answer").onsubmit = (event) => this.#answer(event);
    this.#listenWhileLookedAt();
  }

  #reactions() {
    return {
      progress: (part) => this.#load(part),
      picture: (number, bytes) => this.windows.picture(number, bytes),
      tell: (number, word, rest) => this.windows.tell(number, word, rest),
      text: (text) => this.#print(text),
      ask: () => this.#ask(),
      started: () => this.#begin(),
      ended: (status) => this.#end(status),
    };
  }

  // Begin to load Python, for a Run that will come.
  async load() {
    const shared = await this.#shared;
    this.machine ??= new Machine(this.#reactions(), { ...this.site, shared });
    await this.machine.load();
    this.#find(".loading").hidden = true;
    this.place.dataset.loaded = "yes";
  }

  async run() {
    if (this.machine?.running) this.machine.stop();
    while (this.machine?.running) await new Promise((resolve) => setTimeout(resolve, 20));
    this.#clear();
    this.#button("stop").disabled = false;
    this.place.classList.add("running");
    this.windows.begin();
    this.#find(".screens").focus({ preventScroll: true });
    await this.load();
    const { name, program } = this.program();
    await this.machine.run(name, program);
  }

  #begin() {
    this.#keysDue = setTimeout(() => this.#offerKeys(), SHORT);
    this.windows.keys.active = document.activeElement === this.#find(".screens");
  }

  #end(status) {
    clearTimeout(this.#keysDue);
    this.windows.keys.active = false;
    this.#button("stop").disabled = true;
    this.place.classList.remove("running");
    this.place.dataset.ended = status;
    this.windows.sound.play(0);
    this.#find(".answer").hidden = true;
    const places = status === 0 ? [] : [...this.#text.matchAll(WHERE)];
    const last = places.at(-1);
    this.wrong(last ? Number(last.slice(1).find(Boolean)) : 0);
  }

  // A phone has no other keyboard.
  #offerKeys() {
    if (matchMedia("(pointer: coarse)").matches) this.#find(".keyboard").hidden = false;
  }

  #load(part) {
    this.#find(".loading").hidden = false;
    this.#find("progress").value = part;
  }

  // What the program prints

  #clear() {
    delete this.place.dataset.ended;
    this.#text = "";
    this.#print("");
    this.wrong(0);
  }

  #print(text) {
    this.#text = (this.#text + text).split("\n").slice(-LINES_KEPT).join("\n");
    const printed = this.#find(".printed");
    printed.hidden = !this.#text;
    printed.textContent = this.#text;
    printed.scrollTop = printed.scrollHeight;
  }

  #ask() {
    this.#find(".answer").hidden = false;
    this.#find(".answer input").focus();
  }

  #answer(event) {
    event.preventDefault();
    const input = this.#find(".answer input");
    this.machine.say(`line ${input.value}`);
    this.#print(`${input.value}\n`);
    input.value = "";
    this.#find(".answer").hidden = true;
    this.#find(".screens").focus();
  }

  // Keys are the program's while its screen is in focus.
  #listenWhileLookedAt() {
    const screens = this.#find(".screens");
    screens.addEventListener("focus", () => (this.windows.keys.active = Boolean(this.machine?.running)));
    screens.addEventListener("blur", () => {
      this.windows.keys.active = false;
      this.machine?.say("0 blur");
    });
    screens.addEventListener("pointerdown", () => screens.focus());
    this.#find(".keyboard").addEventListener("pointerdown", (event) => event.preventDefault());
  }

  // Buttons

  #toggle(selector) {
    const element = this.#find(selector);
    element.hidden = !element.hidden;
  }

  async #fullScreen() {
    if (document.fullscreenElement) return document.exitFullscreen();
    await this.#find(".screens").requestFullscreen();
    await navigator.keyboard?.lock?.().catch(() => {}); // then Ctrl-W and its like are the program's
  }

  async #save() {
    if (!this.windows.first?.screen.width) return;
    const link = document.createElement("a");
    link.href = URL.createObjectURL(await png(this.windows.first.screen));
    link.download = "picture.png";
    link.click();
    URL.revokeObjectURL(link.href);
  }

  #find(selector) {
    return this.place.querySelector(selector);
  }

  #button(action) {
    return this.#find(`[data-action=${action}]`);
  }
}

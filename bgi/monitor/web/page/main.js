// The page: what each part of it is, and what it says to its user.

import { Board } from "./board.js";
import { Keyboard } from "./keyboard.js";
import { Keys } from "./keys.js";
import { Lens } from "./lens.js";
import { Line } from "./line.js";
import { Mouse } from "./mouse.js";
import { Pointer } from "./pointer.js";
import { Saving } from "./saving.js";
import { Screen } from "./screen.js";
import { Sound } from "./sound.js";

const $ = (id) => document.getElementById(id);
const button = (action) => document.querySelector(`[data-action=${action}]`);

const screen = new Screen($("screen"), $("room"), painted);
const pointer = new Pointer($("pointer"), screen);
const lens = new Lens(screen);
const saving = new Saving(screen, (recording) => {
  button("gif").classList.toggle("on", recording);
  button("gif").textContent = recording ? "Save recording" : "Record";
});
const sound = new Sound(() => {
  button("sound").textContent = sound.on ? "Sound on" : "Sound off";
});
let typing = false;

const WORDS = {
  title: (text) => (document.title = $("title").textContent = text),
  sound: (hertz) => sound.play(Number(hertz)),
  pointer: (state) => pointer.use(state),
  shape: (numbers) => pointer.shape(numbers),
  move: (numbers) => pointer.move(numbers.split(" ").map(Number)),
  limits: (numbers) => pointer.limit(numbers),
  lens: (how) => lens.use(...how.split(" ")),
  typing: (answer) => type(answer === "yes"),
};

const line = new Line((word, rest) => WORDS[word]?.(rest), receive, tell);
const board = new Board(screen, (...words) => line.say(...words));

const ACTIONS = {
  keys: () => {
    $("keyboard").hidden = !$("keyboard").hidden;
    button("keys").classList.toggle("on", !$("keyboard").hidden);
  },
  full: fullScreen,
  png: () => saving.picture(),
  gif: () => saving.record(),
  lens: () => lens.enlarge(),
  board: () => board.toggle(),
  sound: () => sound.toggle(),
  close: () => line.say("close"),
};

const keys = new Keys(line, {
  F11: ACTIONS.full,
  "Alt-Enter": ACTIONS.full,
  F12: ACTIONS.png,
  "Control-F5": ACTIONS.gif,
  "Control-F6": ACTIONS.lens,
  "Control-F7": ACTIONS.board,
  "Control-F8": () => lens.follow(),
});
new Keyboard($("keyboard"), keys);
new Mouse(line, screen, pointer);

for (const [action, act] of Object.entries(ACTIONS)) {
  button(action).tabIndex = -1; // Tab is for the program
  button(action).addEventListener("pointerdown", (event) => event.preventDefault());
  button(action).addEventListener("click", act);
}
if (matchMedia("(pointer: coarse)").matches) ACTIONS.keys();

function receive(bytes) {
  if (!board.receive(bytes)) screen.receive(bytes);
}

function painted(first, end) {
  saving.painted(first, end);
  pointer.draw();
  lens.draw();
  line.say("shown");
}

async function fullScreen() {
  if (document.fullscreenElement) return document.exitFullscreen();
  try {
    await document.documentElement.requestFullscreen();
    await navigator.keyboard?.lock?.(); // then Ctrl-W and its like are the program's, too
  } catch {
    // a frame that may not
  }
}

// What the user should know

function type(mine) {
  typing = keys.active = mine;
  if (mine) notice();
  else notice("Somebody else types.", "Type here", () => line.say("type"));
}

function tell(state, why) {
  $("room").classList.toggle("ended", state !== "open");
  keys.active = state === "open" && typing;
  if (state === "open") board.ask();
  else sound.play(0);
  const again = ["Try again", () => location.reload()];
  ({
    open: () => notice(),
    lost: () => notice("No line to the program; trying again …"),
    ended: () => notice("The program has ended.", "Save the picture", ACTIONS.png),
    full: () => notice("Too many are looking already.", ...again),
    refused: () => notice(`Not let in: ${why}. Open the address that the program printed.`),
  })[state]();
}

function notice(text = "", label = "", act = null) {
  const box = $("notice");
  const [words, answer] = box.children;
  box.hidden = !text;
  words.textContent = text;
  answer.textContent = label;
  answer.hidden = !act;
  answer.onclick = act;
}

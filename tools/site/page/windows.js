// The program's windows on the page, each a screen with its pointer; one keyboard for all.

import { Board } from "./board.js";
import { Keyboard } from "./keyboard.js";
import { Keys } from "./keys.js";
import { Lens } from "./lens.js";
import { Mouse } from "./mouse.js";
import { Pointer } from "./pointer.js";
import { Screen } from "./screen.js";
import { Sound } from "./sound.js";

export class Windows {
  #windows = [];

  // `say(line)` tells the program something; `place` is where windows go, `titled(text)` is called
  // with the name of the first one.
  constructor(place, keyboard, say, hot, titled) {
    this.place = place;
    this.say = say;
    this.titled = titled;
    this.sound = new Sound(() => {});
    const line = { say: (...words) => say(["0", ...words].join(" ")) };
    this.keys = new Keys(line, hot);
    new Keyboard(keyboard, this.keys);
  }

  // A program begins: what the last one has left is gone.
  begin() {
    for (const { room } of this.#windows) room.hidden = true;
  }

  get first() {
    return this.#windows[0];
  }

  // Pictures

  picture(number, bytes) {
    const { board, screen } = this.#window(number);
    if (!board.receive(bytes)) screen.receive(bytes);
  }

  tell(number, word, rest) {
    const { board, lens, pointer, room } = this.#window(number);
    const numbers = rest.split(" ").map(Number);
    ({
      open: () => {
        room.hidden = false;
        board.ask();
      },
      title: () => (number ? (room.title = rest) : this.titled(rest)),
      sound: () => this.sound.play(Number(rest)),
      pointer: () => pointer.use(rest),
      shape: () => pointer.shape(rest),
      move: () => pointer.move(numbers),
      limits: () => pointer.limit(rest),
      lens: () => lens.use(...rest.split(" ")),
      close: () => this.#close(number),
    })[word]?.();
  }

  // What lies over all of them

  enlarge() {
    for (const { lens } of this.#windows) lens.enlarge();
  }

  follow() {
    for (const { lens } of this.#windows) lens.follow();
  }

  toggleBoard() {
    for (const { board } of this.#windows) board.toggle();
  }

  // The last picture stays, if it is the only window's.
  #close(number) {
    const { pointer, room } = this.#window(number);
    pointer.use("system");
    pointer.limit("");
    this.sound.play(0);
    if (number) room.hidden = true;
  }

  #window(number) {
    this.#windows[number] ??= this.#made(number);
    return this.#windows[number];
  }

  #made(number) {
    const room = document.createElement("div");
    room.className = "room";
    const [canvas, over] = ["screen", "pointer"].map((name) => {
      const made = document.createElement("canvas");
      made.className = name;
      return made;
    });
    room.append(canvas, over);
    this.place.append(room);
    const line = { say: (...words) => this.say([number, ...words].join(" ")) };
    const screen = new Screen(canvas, room, () => {
      pointer.draw();
      lens.draw();
      line.say("shown");
    });
    const pointer = new Pointer(over, screen);
    const [lens, board] = [new Lens(screen), new Board(screen, line.say)];
    new Mouse(line, screen, pointer);
    return { board, lens, room, screen, pointer };
  }
}

// The mouse driver's pointer, on a canvas of its own over the screen: so it damages no picture.

const SIZE = 16;
const BLACK = 0xff000000, WHITE = 0xffffffff;

export class Pointer {
  #place = [0, 0];
  #hot = [0, 0];
  #masks = [];
  #limits = [];
  #on = false;

  constructor(canvas, screen) {
    this.canvas = canvas;
    this.screen = screen;
    this.context = canvas.getContext("2d");
    this.picture = this.context.createImageData(SIZE, SIZE);
  }

  // "shown", "hidden", or "system": the pointer of the system is seen.
  use(state) {
    this.#on = state === "shown";
    this.screen.room.classList.toggle("arrow", state !== "system");
    this.#clear();
    this.draw();
  }

  // The hot spot and the rows of two masks: of what is there, AND the first, XOR the second.
  shape(numbers) {
    const [x, y, ...masks] = numbers.split(" ").map(Number);
    this.#hot = [x, y];
    this.#masks = masks;
    this.draw();
  }

  limit(numbers) {
    this.#limits = numbers ? numbers.split(" ").map(Number) : [];
  }

  // Go there, or as near as the program allows; returns where that is.
  move([x, y]) {
    const [left, top, right, bottom] = this.#limits;
    this.#place = this.#limits.length
      ? [Math.min(Math.max(x, left), right), Math.min(Math.max(y, top), bottom)]
      : [x, y];
    this.draw();
    return this.#place;
  }

  #clear() {
    this.context.clearRect(0, 0, this.canvas.width, this.canvas.height);
  }

  // Draw it anew: it has moved, or what lies under it has changed.
  draw() {
    if (!this.#on || !this.#masks.length) return;
    const { width, height, shown } = this.screen;
    if (this.canvas.width !== width) this.canvas.width = width;
    if (this.canvas.height !== height) this.canvas.height = height;
    this.#clear();
    const [left, top] = [this.#place[0] - this.#hot[0], this.#place[1] - this.#hot[1]];
    const colors = new Uint32Array(this.picture.data.buffer);
    for (let row = 0; row < SIZE; row++) {
      for (let column = 0; column < SIZE; column++) {
        const bit = 1 << (SIZE - 1 - column);
        const [kept, turned] = [this.#masks[row] & bit, this.#masks[SIZE + row] & bit];
        const there = shown[(top + row) * width + left + column] ?? 0;
        const color = kept ? (turned ? there ^ 0xffffff : 0) : turned ? WHITE : BLACK;
        colors[row * SIZE + column] = color;
      }
    }
    this.context.putImageData(this.picture, left, top);
  }
}

// The magnifier over the screen; in the window bgi/monitor/lens.py draws the same.

const TIMES = [8, 16, 32]; // how many times the key enlarges, one after the other
const SIZE = [336, 240]; // of the enlarged part, about
const PART = 0.6; // of the picture that it may cover: on a phone
const LEAST = 4; // times that leave room for a grid
const MARGIN = 8;
const GRID = "rgb(64 64 64)";
const FRAMES = ["white", "black"]; // around the pixel in the middle: one of them is seen on any colour
const INDICES = 1 << 24; // a number that is smaller is an index
const NAMES = [
  "BLACK", "BLUE", "GREEN", "CYAN", "RED", "MAGENTA", "BROWN", "LIGHTGRAY", "DARKGRAY",
  "LIGHTBLUE", "LIGHTGREEN", "LIGHTCYAN", "LIGHTRED", "LIGHTMAGENTA", "YELLOW", "WHITE",
];

export class Lens {
  #times = 0;
  #follows = "mouse"; // or the "pixels" that are set last
  #mouse = [0, 0];

  constructor(screen) {
    this.screen = screen;
    this.canvas = document.createElement("canvas");
    this.context = this.canvas.getContext("2d");
    this.words = document.createElement("figcaption");
    this.place = document.createElement("figure");
    this.place.className = "lens";
    this.place.hidden = true;
    this.place.append(this.canvas, this.words);
    const { room } = screen;
    room.append(this.place);
    new ResizeObserver(() => this.draw()).observe(screen.canvas);
    for (const kind of ["pointerdown", "pointermove"]) {
      room.addEventListener(kind, (event) => this.#look(event));
    }
  }

  // The key for it: larger, and at last gone.
  enlarge() {
    this.use(TIMES.find((times) => times > this.#times) ?? 0, this.#follows);
  }

  // The other key: from the mouse to the pixel that was set last, and back.
  follow() {
    this.use(this.#times || TIMES[0], this.#follows === "mouse" ? "pixels" : "mouse");
  }

  use(times, follows) {
    this.#times = Number(times);
    this.#follows = follows;
    this.draw();
  }

  #look({ clientX, clientY }) {
    if (!this.screen.width) return;
    this.#mouse = this.screen.at(clientX, clientY);
    this.draw();
  }

  // Draw it anew: the picture has changed, or another part of it is looked at.
  draw() {
    const { screen } = this;
    this.place.hidden = !this.#times || !screen.width;
    if (this.place.hidden) return;
    const [x, y] = (this.#follows === "mouse" ? this.#mouse : screen.last).map((at, axis) =>
      Math.min(at, [screen.width, screen.height][axis] - 1),
    );
    this.#enlarge(x, y);
    this.words.textContent = `x ${x}  y ${y}  color ${nameOf(screen.pixels[y * screen.width + x])}`;
    this.#put(2 * x >= screen.width, 2 * y >= screen.height);
  }

  // What is around x, y: each pixel becomes `wide` times `high` in the shape that it has.
  #enlarge(x, y) {
    const { canvas, context, screen } = this;
    const shown = screen.canvas;
    const wide = this.#times;
    const tall = (shown.offsetHeight * screen.width) / (shown.offsetWidth * screen.height);
    const high = Math.max(Math.round(wide * tall), 1);
    const room = [shown.offsetWidth, shown.offsetHeight].map((length, axis) => Math.min(SIZE[axis], PART * length));
    const across = Math.floor(Math.floor(room[0] / wide) / 2);
    const down = Math.max(Math.floor(Math.floor(room[1] / high) / 2), 1);
    const [columns, rows] = [2 * across + 1, 2 * down + 1];
    [canvas.width, canvas.height] = [columns * wide, rows * high];
    context.fillStyle = GRID;
    context.fillRect(0, 0, canvas.width, canvas.height);
    context.imageSmoothingEnabled = false;
    context.drawImage(shown, x - across, y - down, columns, rows, 0, 0, canvas.width, canvas.height);
    if (wide >= LEAST) {
      for (let row = 0; row < rows; row++) context.fillRect(0, row * high, canvas.width, 1);
      for (let column = 0; column < columns; column++) context.fillRect(column * wide, 0, 1, canvas.height);
    }
    FRAMES.forEach((color, inset) => {
      context.strokeStyle = color;
      const at = inset + 0.5;
      context.strokeRect(across * wide + at, down * high + at, wide - 2 * inset, high - 2 * inset);
    });
  }

  // Into the corner of the picture that is farthest away.
  #put(left, top) {
    const { place } = this;
    const { offsetLeft, offsetTop, offsetWidth, offsetHeight } = this.screen.canvas;
    const across = left ? offsetLeft + MARGIN : offsetLeft + offsetWidth - MARGIN - place.offsetWidth;
    const down = top ? offsetTop + MARGIN : offsetTop + offsetHeight - MARGIN - place.offsetHeight;
    Object.assign(place.style, { left: `${across}px`, top: `${down}px` });
  }
}

// A colour by its number, and its name if it has one.
function nameOf(number) {
  if (number >= INDICES) return `RGB ${number & 255} ${(number >> 8) & 255} ${(number >> 16) & 255}`;
  return number < NAMES.length ? `${number} ${NAMES[number]}` : String(number);
}

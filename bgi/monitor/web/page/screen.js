// The screen: the card's pixels as the program's process sends them, and their colours.

import { inside } from "./fit.js";

const COLORS = 1, ROWS = 2;
const HEADER = 12; // bytes of a message of rows, before its pixels
const INDICES = 16; // a pixel of four bytes that is smaller is an index
const OPAQUE = 0xff000000;

export class Screen {
  width = 0;
  height = 0;
  square = false;
  palette = new Uint8Array(768);
  pixels = new Uint8Array(0); // or Uint32Array
  shown = new Uint32Array(0); // what each pixel looks like
  last = [0, 0]; // the last place, row by row, that the last message has changed
  #colors = new Uint32Array(256).fill(OPAQUE);
  #picture = null;
  #first = 0; // the rows that wait to be painted
  #end = 0;

  // onPaint(first, end) is called when rows are on the screen.
  constructor(canvas, room, onPaint) {
    this.canvas = canvas;
    this.room = room;
    this.onPaint = onPaint;
    this.context = canvas.getContext("2d", { alpha: false });
    new ResizeObserver(() => this.arrange()).observe(room);
  }

  // A message of bytes: see bgi/monitor/web/updates.py.
  receive(buffer) {
    const view = new DataView(buffer);
    if (view.getUint8(0) === COLORS) {
      this.#take(new Uint8Array(buffer, 1));
    } else if (view.getUint8(0) === ROWS) {
      this.#fill(view, buffer);
      requestAnimationFrame(() => this.#paint());
    }
  }

  #take(palette) {
    this.palette = palette;
    for (let i = 0; i < 256; i++) {
      this.#colors[i] = OPAQUE | (palette[3 * i + 2] << 16) | (palette[3 * i + 1] << 8) | palette[3 * i];
    }
    this.#touch(0, this.height);
  }

  #fill(view, buffer) {
    const [size, square] = [view.getUint8(1), view.getUint8(10) === 1];
    const [width, height, first, rows] = [2, 4, 6, 8].map((at) => view.getUint16(at, true));
    if (
      width !== this.width || height !== this.height || square !== this.square ||
      size !== this.pixels.BYTES_PER_ELEMENT || !this.#picture
    ) {
      this.#enter(width, height, size, square);
    }
    const [from, news] = [first * width * size, new Uint8Array(buffer, HEADER)];
    const part = new Uint8Array(this.pixels.buffer, from, news.length);
    this.#note(from, part, news);
    part.set(news);
    this.#touch(first, first + rows);
  }

  // The last row of a message has changed, as a rule: so this is soon found.
  #note(from, before, after) {
    let at = after.length - 1;
    while (at >= 0 && before[at] === after[at]) at--;
    if (at < 0) return;
    const pixel = Math.floor((from + at) / this.pixels.BYTES_PER_ELEMENT);
    this.last = [pixel % this.width, Math.floor(pixel / this.width)];
  }

  // Another mode.
  #enter(width, height, size, square) {
    Object.assign(this, { width, height, square });
    this.pixels = new (size === 1 ? Uint8Array : Uint32Array)(width * height);
    this.canvas.width = width;
    this.canvas.height = height;
    this.#picture = this.context.createImageData(width, height);
    this.shown = new Uint32Array(this.#picture.data.buffer);
    this.#first = this.#end = 0;
    this.arrange();
  }

  #touch(first, end) {
    if (first === end) return;
    const clean = this.#first === this.#end;
    this.#first = clean ? first : Math.min(first, this.#first);
    this.#end = clean ? end : Math.max(end, this.#end);
  }

  #paint() {
    const [first, end, colors, pixels, shown] = [this.#first, this.#end, this.#colors, this.pixels, this.shown];
    const [from, to] = [first * this.width, end * this.width];
    if (pixels.BYTES_PER_ELEMENT === 1) {
      for (let i = from; i < to; i++) shown[i] = colors[pixels[i]];
    } else {
      for (let i = from; i < to; i++) shown[i] = pixels[i] < INDICES ? colors[pixels[i]] : OPAQUE | pixels[i];
    }
    if (first < end) this.context.putImageData(this.#picture, 0, 0, 0, first, this.width, end - first);
    this.#first = this.#end = 0;
    this.onPaint(first, end);
  }

  // Put the picture into the middle of its room, in whole pixels of the display.
  arrange() {
    if (!this.width) return;
    const fine = devicePixelRatio;
    const [wide, high] = [this.room.clientWidth * fine, this.room.clientHeight * fine].map(Math.floor);
    const { width, height } = inside(this, wide, high, fine > 1);
    const style = {
      left: `${Math.max(Math.floor((wide - width) / 2), 0) / fine}px`,
      top: `${Math.max(Math.floor((high - height) / 2), 0) / fine}px`,
      width: `${width / fine}px`,
      height: `${height / fine}px`,
      // Pixels for which there is room stay crisp; else they blend, so that none is lost.
      imageRendering: width >= this.width && height >= this.height ? "pixelated" : "auto",
    };
    for (const canvas of this.room.querySelectorAll(":scope > canvas")) Object.assign(canvas.style, style);
  }

  // The pixel at a place of the window, or the nearest.
  at(clientX, clientY) {
    const box = this.canvas.getBoundingClientRect();
    const place = (part, length) => Math.min(Math.max(Math.floor(part * length), 0), length - 1);
    return [
      place((clientX - box.left) / box.width, this.width),
      place((clientY - box.top) / box.height, this.height),
    ];
  }
}

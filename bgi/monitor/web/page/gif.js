// A GIF that moves: pictures as they come, each only the rows that differ from the last one.

const TICK = 10; // milliseconds: the GIF's unit of time
const SHORTEST = 2; // ticks: browsers show a picture that is meant to be shorter far too long
const LONGEST = 65535; // ticks
const LAST = 50; // ticks at least for the last picture, before it all begins again
const MOST = 64 << 20; // bytes: then a recording ends by itself

export class Gif {
  #parts = [];
  #bytes = 0;
  #size;
  #image = null; // the last picture, which lasts until the next one comes
  #since = 0;
  #first = 0; // rows that have changed since
  #end = 0;

  // The first picture is what `screen` shows now.
  constructor(screen, now) {
    this.screen = screen;
    this.#size = [screen.width, screen.height];
    this.#touch(0, screen.height);
    this.#take(now);
  }

  get full() {
    return this.#bytes > MOST;
  }

  // Rows have changed on the screen. A mode of another size is left out.
  add(now, first, end) {
    if (this.screen.width !== this.#size[0] || this.screen.height !== this.#size[1]) return;
    this.#touch(first, end);
    if (now - this.#since >= SHORTEST * TICK) this.#take(now);
  }

  #touch(first, end) {
    const clean = this.#first === this.#end;
    this.#first = clean ? first : Math.min(first, this.#first);
    this.#end = clean ? end : Math.max(end, this.#end);
  }

  #take(now) {
    if (this.#first === this.#end) return;
    this.#keep(now);
    this.#image = image(this.screen, this.#first, this.#end);
    this.#since = now;
    this.#first = this.#end = 0;
  }

  #keep(now, least = SHORTEST) {
    if (!this.#image) return;
    const ticks = Math.min(Math.max(Math.round((now - this.#since) / TICK), least), LONGEST);
    // Graphic control extension: leave the picture in place, and how long it lasts.
    const control = [0x21, 0xf9, 4, 1 << 2, ticks & 255, ticks >> 8, 0, 0];
    this.#parts.push(new Uint8Array(control), ...this.#image);
    this.#bytes += this.#image.reduce((sum, part) => sum + part.length, control.length);
  }

  // The file.
  finish(now) {
    this.#take(now);
    this.#keep(now, LAST);
    const [width, height] = this.#size;
    const head = [
      ...ascii("GIF89a"), ...short(width), ...short(height), 0x70, 0, 0, // colours come with pictures
      0x21, 0xff, 11, ...ascii("NETSCAPE2.0"), 3, 1, 0, 0, 0, // for ever
    ];
    return new Blob([new Uint8Array(head), ...this.#parts, new Uint8Array([0x3b])], { type: "image/gif" });
  }
}

const ascii = (text) => [...text].map((letter) => letter.charCodeAt(0));
const short = (number) => [number & 255, number >> 8];

// Some rows of the screen as an image with colours of its own.
function image(screen, first, end) {
  const { width, pixels, palette, shown } = screen;
  const [from, to] = [first * width, end * width];
  const [indices, colors] = pixels.BYTES_PER_ELEMENT === 1
    ? [pixels.subarray(from, to), palette]
    : quantized(shown.subarray(from, to));
  const place = [0x2c, 0, 0, ...short(first), ...short(width), ...short(end - first), 0x80 | 7];
  return [new Uint8Array(place), Uint8Array.from(colors), compressed(indices)];
}

// Colours as indices: all of them, if they are 256 at most, else the nearest of 8 x 8 x 4.
function quantized(shown) {
  const found = new Map();
  for (const color of shown) {
    if (!found.has(color)) found.set(color, found.size);
    if (found.size > 256) break;
  }
  const few = found.size <= 256;
  const colors = new Uint8Array(768);
  const put = (index, r, g, b) => colors.set([r, g, b], 3 * index);
  if (few) found.forEach((index, color) => put(index, color & 255, (color >> 8) & 255, (color >> 16) & 255));
  else for (let i = 0; i < 256; i++) put(i, (i >> 5) * 255 / 7, ((i >> 2) & 7) * 255 / 7, (i & 3) * 85);
  const coarse = (color) =>
    (Math.round((color & 255) * 7 / 255) << 5) |
    (Math.round(((color >> 8) & 255) * 7 / 255) << 2) |
    Math.round(((color >> 16) & 255) / 85);
  return [Uint8Array.from(shown, few ? (color) => found.get(color) : coarse), colors];
}

// LZW as GIF has it: codes of 9 to 12 bits, in blocks of 255 bytes.
function compressed(indices) {
  const CLEAR = 256, END = 257, FULL = 4096;
  const out = new Bits();
  let codes = new Map(), next = END + 1, bits = 9;
  out.put(CLEAR, bits);
  let prefix = indices[0];
  for (let i = 1; i < indices.length; i++) {
    const string = (prefix << 8) | indices[i];
    const code = codes.get(string);
    if (code !== undefined) {
      prefix = code;
      continue;
    }
    out.put(prefix, bits);
    if (next === FULL) {
      out.put(CLEAR, bits);
      [codes, next, bits] = [new Map(), END + 1, 9];
    } else {
      if (next === 1 << bits) bits++;
      codes.set(string, next++);
    }
    prefix = indices[i];
  }
  out.put(prefix, bits);
  if (next === 1 << bits && bits < 12) bits++;
  out.put(END, bits);
  return blocks(out.bytes());
}

// Numbers of so many bits, the lowest first.
class Bits {
  #bytes = [];
  #held = 0;
  #count = 0;

  put(number, bits) {
    this.#held |= number << this.#count;
    this.#count += bits;
    for (; this.#count >= 8; this.#count -= 8, this.#held >>>= 8) this.#bytes.push(this.#held & 255);
  }

  bytes() {
    if (this.#count) this.#bytes.push(this.#held & 255);
    return this.#bytes;
  }
}

function blocks(bytes) {
  const out = new Uint8Array(2 + bytes.length + Math.ceil(bytes.length / 255));
  let at = 0;
  out[at++] = 8; // bits of an index
  for (let i = 0; i < bytes.length; i += 255) {
    const part = bytes.slice(i, i + 255);
    out[at++] = part.length;
    out.set(part, at);
    at += part.length;
  }
  return out; // and a block of nothing
}

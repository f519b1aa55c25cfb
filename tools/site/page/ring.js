// Lines of text from the page to the worker, through memory that both share.

const CHANGES = 0, WRITTEN = 1, READ = 2; // numbers at the beginning; the last two grow for ever
const HEAD = 16, SIZE = 1 << 16; // bytes

export class Ring {
  static memory() {
    return new SharedArrayBuffer(HEAD + SIZE);
  }

  constructor(memory) {
    this.numbers = new Int32Array(memory, 0, HEAD / 4);
    this.bytes = new Uint8Array(memory, HEAD, SIZE);
  }

  // The page: add a line; it is lost if the program has not listened for very long.
  put(line) {
    const text = new TextEncoder().encode(`${line}\n`);
    const [written, read] = [WRITTEN, READ].map((number) => Atomics.load(this.numbers, number));
    if (written - read + text.length <= SIZE) {
      text.forEach((byte, place) => (this.bytes[(written + place) % SIZE] = byte));
      Atomics.store(this.numbers, WRITTEN, written + text.length);
    }
    this.wake();
  }

  wake() {
    Atomics.add(this.numbers, CHANGES, 1);
    Atomics.notify(this.numbers, CHANGES);
  }

  // The worker: take all lines.
  take() {
    const [written, read] = [WRITTEN, READ].map((number) => Atomics.load(this.numbers, number));
    if (written === read) return "";
    const text = Uint8Array.from({ length: written - read }, (_, place) => this.bytes[(read + place) % SIZE]);
    Atomics.store(this.numbers, READ, written);
    return new TextDecoder().decode(text);
  }

  // The worker: wait for a line.
  wait(milliseconds) {
    const seen = Atomics.load(this.numbers, CHANGES);
    if (Atomics.load(this.numbers, WRITTEN) === Atomics.load(this.numbers, READ)) {
      Atomics.wait(this.numbers, CHANGES, seen, milliseconds);
    }
  }
}

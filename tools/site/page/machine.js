// The page's side of Python: starts its worker, gives it programs, hears what they say.

import { Ring } from "./ring.js";

const [STOP, LOOK] = [2, 10]; // the signals SIGINT and SIGUSR1
const PATIENCE = 2000; // milliseconds that a program has to end after Stop
const DEEP = /call stack/; // what JavaScript says of it

export class Machine {
  running = false;
  #ready = null;
  #worker = null;
  #ring = null;
  #signals = null;
  #stopping = 0;

  // `on` has a function for each message of the worker's: progress, open, picture, tell, text, ask,
  // started, ended.
  constructor(on, { shared, parts, bytes }) {
    this.on = on;
    this.shared = shared;
    this.parts = parts;
    this.bytes = bytes;
  }

  // Load Python, if that was not done.
  load() {
    this.#ready ??= new Promise((resolve) => this.#start(resolve));
    return this.#ready;
  }

  #start(resolve) {
    if (!this.shared && !("Suspending" in WebAssembly)) {
      this.on.text("This browser can neither share memory nor suspend WebAssembly: try a newer one.\n");
      return;
    }
    let loaded = 0;
    const memory = this.shared ? Ring.memory() : null;
    this.#ring = memory && new Ring(memory);
    this.#signals = this.shared ? new Uint8Array(new SharedArrayBuffer(1)) : null;
    this.#worker = new Worker(new URL("./worker.js", import.meta.url), { type: "module" });
    this.#worker.onerror = (event) => this.#fail(event.message || "Python could not be loaded.");
    this.#worker.onmessage = ({ data }) => {
      if (data.loaded) this.on.progress((loaded += data.loaded) / this.bytes);
      else if (data.ready) resolve();
      else this.#hear(data);
    };
    this.#worker.postMessage({ start: { memory, signals: this.#signals?.buffer, parts: this.parts } });
  }

  #hear(data) {
    if (data.bytes) this.on.picture(data.window, data.bytes);
    else if (data.word) this.on.tell(data.window, data.word, data.rest);
    else if (data.text !== undefined) this.on.text(data.text);
    else if (data.ask) this.on.ask();
    else if (data.started) this.on.started();
    else if ("ended" in data) this.#end(data.ended);
    else if (data.failed) this.#fail(data.failed);
  }

  // Python itself has failed, not the program; it is loaded again for the next one.
  #fail(why) {
    const deep = "Out of stack, and Python with it: does something call itself without an end?";
    this.#drop(DEEP.test(why) ? deep : why, 1);
  }

  #drop(why, status) {
    this.#worker.terminate();
    this.#ready = null;
    this.on.text(`${why}\n`);
    this.#end(status);
  }

  #end(status) {
    clearTimeout(this.#stopping);
    this.running = false;
    this.on.ended(status);
  }

  async run(name, program) {
    await this.load();
    this.running = true;
    this.#worker.postMessage({ run: { name, program } });
    this.#ask();
  }

  // Once for each picture of the display: have the program interrupted to show what it has drawn.
  #ask() {
    if (!this.running) return;
    if (this.#signals) Atomics.compareExchange(this.#signals, 0, 0, LOOK);
    requestAnimationFrame(() => this.#ask());
  }

  say(line) {
    if (!this.running) return;
    if (this.#ring) this.#ring.put(line);
    else this.#worker.postMessage({ say: line });
  }

  stop() {
    if (!this.running) return;
    if (this.#signals) {
      Atomics.store(this.#signals, 0, STOP);
      this.#ring.wake();
    } else {
      this.#worker.postMessage({ stop: true });
    }
    clearTimeout(this.#stopping);
    // If it does not listen, inside of a long calculation, say, Python begins anew.
    this.#stopping = setTimeout(() => this.#drop("Stopped, and Python with it.", 130), PATIENCE);
  }

}

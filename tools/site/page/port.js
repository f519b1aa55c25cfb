// What Python's monitor (bgi/monitor/tab.py) reaches the page by: the module bgi_port.

import { Ring } from "./ring.js";

class Port {
  send = (window, bytes) => {
    const view = bytes.getBuffer("u8");
    const copy = view.data.slice();
    view.release();
    bytes.destroy?.();
    postMessage({ window, bytes: copy.buffer }, [copy.buffer]);
  };

  tell = (window, word, rest) => postMessage({ window, word, rest });

  // A program begins: what was said to the last one is not for it.
  begin() {
    this.news();
  }

  // Whether the program is to end: there it finds out by itself, by a signal.
  stopped = () => false;
}

// Where memory is shared: the worker sleeps until the page wakes it.
export class SharedPort extends Port {
  shared = true;
  #pending = ""; // lines that came while one was waited for

  constructor(python, memory) {
    super();
    this.python = python;
    this.ring = new Ring(memory);
  }

  wait = (milliseconds) => {
    this.ring.wait(milliseconds);
    this.python.checkInterrupt();
  };

  news = () => {
    const lines = this.#pending + this.ring.take();
    this.#pending = "";
    return lines;
  };

  // A line that somebody types for input().
  ask = () => {
    postMessage({ ask: true });
    for (;;) {
      const lines = this.ring.take().split(/(?<=\n)/);
      const answer = lines.findIndex((line) => line.startsWith("line "));
      this.#pending += lines.filter((_, number) => number !== answer).join("");
      if (answer >= 0) return lines[answer].slice(5, -1);
      this.wait(1000);
    }
  };
}

// Where it is not: Python is suspended (WebAssembly's JavaScript Promise Integration) while the
// worker hears the page's messages.
export class SuspendedPort extends Port {
  shared = false;
  #lines = "";
  #stopped = false;
  #wake = () => {};
  #channel = new MessageChannel();

  put(line) {
    this.#lines += `${line}\n`;
    this.#wake();
  }

  // A timer of no time takes 4 milliseconds, a message does not.
  wait = (milliseconds) =>
    new Promise((resolve) => {
      this.#wake = resolve;
      if (milliseconds > 0) return setTimeout(resolve, milliseconds);
      this.#channel.port1.onmessage = resolve;
      this.#channel.port2.postMessage(0);
    });

  news = () => {
    const lines = this.#lines;
    this.#lines = "";
    return lines;
  };

  // A signal would meet Python's own code that resumes the program.
  stop() {
    this.#stopped = true;
    this.#wake();
  }

  begin() {
    super.begin();
    this.#stopped = false;
  }

  stopped = () => this.#stopped;

  ask = () => undefined; // input() meets the end of what is typed
}

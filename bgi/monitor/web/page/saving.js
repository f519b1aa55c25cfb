// Pictures and recordings, saved where the browser saves what it downloads.

import { Gif } from "./gif.js";
import { png } from "./png.js";

export class Saving {
  #recording = null;
  #numbers = { png: 0, gif: 0 };

  // onChange(recording) is called when a recording begins or ends.
  constructor(screen, onChange) {
    this.screen = screen;
    this.onChange = onChange;
  }

  async picture() {
    if (this.screen.width) this.#save(await png(this.screen), "png");
  }

  // Begin to record, or end and save.
  record() {
    if (this.#recording) {
      this.#save(this.#recording.finish(performance.now()), "gif");
      this.#recording = null;
    } else if (this.screen.width) {
      this.#recording = new Gif(this.screen, performance.now());
    }
    this.onChange(this.#recording !== null);
  }

  // Rows have been painted.
  painted(first, end) {
    this.#recording?.add(performance.now(), first, end);
    if (this.#recording?.full) this.record();
  }

  #save(blob, suffix) {
    const number = String(++this.#numbers[suffix]).padStart(3, "0");
    const link = document.createElement("a");
    link.href = URL.createObjectURL(blob);
    link.download = `bgi-${number}.${suffix}`;
    link.click();
    setTimeout(() => URL.revokeObjectURL(link.href), 60000);
  }
}

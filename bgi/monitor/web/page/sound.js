// The PC's speaker: a square wave, as bgi/monitor/speaker.py plays it.

const CLOCK = 1193180; // the timer chip's counts a second
const LOUDNESS = 0.12; // such a speaker was not loud
const HIGHEST = 20000;

export class Sound {
  #context = null;
  #wave = null;
  #volume = null;
  #hertz = 0;
  muted = false;

  // onChange() is called when `on` may have changed.
  constructor(onChange) {
    this.onChange = onChange;
    // A browser lets a page be heard only when its user has done something there.
    for (const kind of ["keydown", "pointerup"]) {
      addEventListener(kind, () => this.#hertz && this.#wake(), true);
    }
  }

  // Whether a tone would be heard.
  get on() {
    return !this.muted && this.#context?.state === "running";
  }

  toggle() {
    this.muted = this.on;
    this.#wake();
  }

  play(hertz) {
    const counts = hertz > 0 ? Math.floor(CLOCK / hertz) : 0;
    this.#hertz = counts ? CLOCK / counts : 0;
    if (this.#hertz) this.#wake();
    else this.#set();
  }

  #wake() {
    if (!this.#context) {
      this.#context = new AudioContext();
      this.#context.onstatechange = () => this.onChange();
      this.#volume = new GainNode(this.#context, { gain: 0 });
      this.#wave = new OscillatorNode(this.#context, { type: "square" });
      this.#wave.connect(this.#volume).connect(this.#context.destination);
      this.#wave.start();
    }
    if (this.#context.state !== "running") this.#context.resume().catch(() => {});
    this.#set();
    this.onChange();
  }

  #set() {
    if (!this.#context) return;
    const heard = this.#hertz > 0 && this.#hertz <= HIGHEST && !this.muted;
    const now = this.#context.currentTime;
    if (heard) this.#wave.frequency.setValueAtTime(this.#hertz, now);
    this.#volume.gain.setValueAtTime(heard ? LOUDNESS : 0, now);
  }
}

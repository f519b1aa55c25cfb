// The mouse, or a finger, over the screen.

const MOVED = 1;
const BUTTONS = [0, 1, 2]; // left, right, middle: as `event.buttons` has them and the program, too
const CLICK = [100, 3, 1]; // of a wheel, in pixels, lines, pages

export class Mouse {
  #held = 0;
  #moved = false;
  #place = [0, 0];
  #turned = 0;

  constructor(line, screen, pointer) {
    this.line = line;
    this.screen = screen;
    this.pointer = pointer;
    const { room } = screen;
    const hear = (event) => this.#hear(event);
    for (const kind of ["pointerdown", "pointermove", "pointerup", "pointercancel"]) {
      room.addEventListener(kind, hear);
    }
    room.addEventListener("contextmenu", (event) => event.preventDefault());
    room.addEventListener("wheel", (event) => this.#roll(event), { passive: false });
  }

  #hear(event) {
    if (!this.screen.width || !event.isPrimary || event.target.tagName === "BUTTON") return;
    if (event.type === "pointerdown") this.screen.room.setPointerCapture(event.pointerId);
    const place = this.pointer.move(this.screen.at(event.clientX, event.clientY));
    const moved = place[0] !== this.#place[0] || place[1] !== this.#place[1];
    this.#place = place;
    const now = event.type === "pointercancel" ? 0 : event.buttons & 7;
    const changed = BUTTONS.filter((button) => (now ^ this.#held) & (1 << button));
    for (const button of changed) {
      this.#held ^= 1 << button;
      this.#say((this.#held & (1 << button) ? 2 : 4) << (2 * button));
    }
    if (changed.length || !moved) return;
    // Once for many events.
    if (!this.#moved) requestAnimationFrame(() => this.#moved && this.#say(MOVED));
    this.#moved = true;
  }

  #say(event) {
    this.#moved = false;
    this.line.say("mouse", event, ...this.#place, this.#held);
  }

  #roll(event) {
    event.preventDefault();
    this.#turned += event.deltaY / CLICK[event.deltaMode];
    const clicks = Math.max(-20, Math.min(20, Math.trunc(this.#turned)));
    this.#turned -= clicks;
    if (clicks) this.line.say("wheel", clicks);
  }
}

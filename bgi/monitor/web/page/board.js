// The board over the screen: palette, pages, viewport. The program's process draws it:
// bgi/monitor/board.py.

const BOARD = 3, HEADER = 6; // a message's first byte, and where its pixels begin

export class Board {
  #on = false;
  #drawn = false;

  // `say(word, number)` tells the program whether the board is wanted.
  constructor(screen, say) {
    this.say = say;
    this.place = document.createElement("figure");
    this.place.className = "board";
    this.place.hidden = true;
    this.canvas = document.createElement("canvas");
    this.place.append(this.canvas);
    screen.room.append(this.place);
  }

  toggle() {
    this.#on = !this.#on;
    this.ask();
    this.#show();
  }

  // Tell a program that may not know.
  ask() {
    this.say("board", Number(this.#on));
  }

  // Take a message, if it is of the board: see bgi/monitor/web/updates.py.
  receive(buffer) {
    const view = new DataView(buffer);
    if (view.getUint8(0) !== BOARD) return false;
    const [width, height] = [2, 4].map((at) => view.getUint16(at, true));
    const [{ canvas }, colors] = [this, new Uint8Array(buffer, HEADER)];
    [canvas.width, canvas.height] = [width, height];
    const picture = canvas.getContext("2d").createImageData(width, height);
    for (let from = 0, to = 0; from < colors.length; from += 3, to += 4) {
      picture.data.set([colors[from], colors[from + 1], colors[from + 2], 255], to);
    }
    canvas.getContext("2d").putImageData(picture, 0, 0);
    this.#drawn = true;
    this.#show();
    return true;
  }

  #show() {
    this.place.hidden = !this.#on || !this.#drawn;
  }
}

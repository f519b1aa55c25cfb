// The line to the program: a WebSocket, opened again whenever it is lost.

const RETRY = 1000, NEXT = 200; // milliseconds
const GONE = 1000, ENDED = 4000, LEFT = 4001, FULL = 4002, REFUSED = 1008;

// What the page that was opened by the program's address has behind its #. It is taken out of the
// address bar at once, and kept for this tab alone: so it survives that the page is loaded anew.
function takeToken() {
  const key = `bgi ${location.pathname}`;
  const given = location.hash.slice(1);
  try {
    if (given) sessionStorage.setItem(key, given);
    history.replaceState(null, "", location.pathname + location.search);
    return given || sessionStorage.getItem(key) || "";
  } catch {
    return given; // a browser that keeps nothing
  }
}

export class Line {
  #socket = null;
  #token = takeToken();
  #ended = false;

  // onWord(word, rest) and onBytes(buffer) are what comes, onState(state, why) how the line is:
  // "open", "lost", "ended", "full", "refused".
  constructor(onWord, onBytes, onState) {
    this.onWord = onWord;
    this.onBytes = onBytes;
    this.onState = onState;
    addEventListener("hashchange", () => location.reload()); // another address was typed
    addEventListener("pagehide", () => this.leave());
    addEventListener("pageshow", (event) => event.persisted && location.reload());
    this.#open();
  }

  say(...words) {
    if (this.#socket?.readyState === WebSocket.OPEN) this.#socket.send(words.join(" "));
  }

  // A page in a frame, as of a notebook, comes and goes: that closes no program.
  leave() {
    this.#socket?.close(window.top === window ? LEFT : GONE);
  }

  async #open() {
    const query = `?token=${encodeURIComponent(this.#token)}`;
    let door = null;
    try {
      door = await fetch(`door${query}`, { cache: "no-store" });
    } catch {
      // nobody listens there
    }
    if (door?.status === 403 && !this.#ended) return this.onState("refused", await door.text());
    if (!door?.ok) {
      this.onState(this.#ended ? "ended" : "lost");
      setTimeout(() => this.#open(), RETRY);
      return;
    }
    const address = new URL(`line${query}`, location.href);
    address.protocol = address.protocol.replace("http", "ws");
    const socket = (this.#socket = new WebSocket(address));
    socket.binaryType = "arraybuffer";
    socket.onopen = () => {
      this.#ended = false;
      this.onState("open");
    };
    socket.onmessage = ({ data }) => this.#hear(data);
    socket.onclose = ({ code, reason }) => this.#close(code, reason);
  }

  #hear(data) {
    if (typeof data !== "string") return this.onBytes(data);
    const end = data.indexOf(" ");
    this.onWord(data.slice(0, end), data.slice(end + 1));
  }

  #close(code, reason) {
    if (code === FULL) return this.onState("full");
    if (code === REFUSED) return this.onState("refused", reason);
    this.#ended = code === ENDED;
    if (!this.#ended) this.onState("lost");
    // Where a screen was closed the program may open another.
    setTimeout(() => this.#open(), this.#ended ? NEXT : RETRY);
  }
}

// A program to read and to change: text with the numbers of its lines.

const TAB = "    ";

export class Editor {
  // The elements are made inside of `place`; run() is called at Ctrl-Enter.
  constructor(place, run) {
    this.numbers = document.createElement("pre");
    this.numbers.ariaHidden = "true";
    this.text = document.createElement("textarea");
    Object.assign(this.text, { spellcheck: false, autocapitalize: "off", wrap: "off", ariaLabel: "The program" });
    place.classList.add("editor");
    place.append(this.numbers, this.text);
    this.text.oninput = () => this.#count();
    this.text.onscroll = () => (this.numbers.scrollTop = this.text.scrollTop);
    this.text.onkeydown = (event) => this.#key(event, run);
  }

  get program() {
    return this.text.value;
  }

  set program(program) {
    this.text.value = program;
    this.text.scrollTop = 0;
    this.#count();
  }

  // Show that something is wrong in a line; 0: nowhere.
  mark(line) {
    for (const number of this.numbers.children) number.classList.remove("wrong");
    const number = this.numbers.children[line - 1];
    if (!number) return;
    number.classList.add("wrong");
    this.text.scrollTop = number.offsetTop - this.text.clientHeight / 2;
  }

  #count() {
    const lines = this.program.split("\n").length;
    if (lines === this.numbers.children.length) return this.mark(0);
    this.numbers.replaceChildren(
      ...Array.from({ length: lines }, (_, line) => {
        const number = document.createElement("span");
        number.textContent = `${line + 1}\n`;
        return number;
      }),
    );
  }

  #key(event, run) {
    if (event.key === "Enter" && (event.ctrlKey || event.metaKey)) {
      event.preventDefault();
      run();
    } else if (event.key === "Tab" && !event.shiftKey) {
      event.preventDefault();
      document.execCommand("insertText", false, TAB); // so that it can be undone
    }
  }
}

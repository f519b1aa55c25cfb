// A page of the documentation: each program in it has a button that runs it, below it.

import { isolate } from "./isolate.js";
import { Player } from "./player.js";
import { packed } from "./share.js";
import { SITE } from "./contents.js";

const NAME = "program.py";
let player = null;
let chosen = null;

for (const block of document.querySelectorAll("pre.runs")) {
  const bar = document.createElement("div");
  bar.className = "bar";
  const [run, edit] = ["Run", "Change it"].map((label) => {
    const button = document.createElement("button");
    button.textContent = label;
    bar.append(button);
    return button;
  });
  run.onclick = () => play(block, bar);
  edit.onclick = async () => {
    location.href = new URL(`index.html${await packed(NAME, programOf(block))}`, import.meta.url).href;
  };
  block.after(bar);
}

// What the page says that it follows, and the block.
function programOf(block) {
  return block.dataset.before + block.textContent;
}

async function play(block, bar) {
  chosen = block;
  player ??= new Player(document.createElement("section"), SITE, () => ({ name: NAME, program: programOf(chosen) }));
  bar.after(player.place);
  await player.run();
}

await isolate(); // before a click: the page may be loaded once more for it
document.body.dataset.ready = "yes";

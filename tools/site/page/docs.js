// A page of the documentation: each program in it has a button that runs it, below it.

import { isolate } from "./isolate.js";
import { Player } from "./player.js";
import { packed } from "./share.js";
import { SITE } from "./contents.js";

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
    const link = await packed(block.dataset.name, programOf(block));
    location.href = new URL(`index.html${link}`, import.meta.url).href;
  };
  block.after(bar);
}

// What the page says that it follows, and the block.
function programOf(block) {
  return block.dataset.before + block.textContent;
}

// Show that something is wrong in a line of the program; 0: nowhere.
function mark(line) {
  for (const wrong of document.querySelectorAll("pre .wrong")) wrong.replaceWith(wrong.textContent);
  const lines = chosen.textContent.split("\n");
  const number = line - chosen.dataset.before.split("\n").length;
  if (!line || number < 0) return;
  const wrong = document.createElement("span");
  wrong.className = "wrong";
  wrong.textContent = lines[number];
  const [above, below] = [lines.slice(0, number), lines.slice(number + 1)].map((part) => part.join("\n"));
  chosen.replaceChildren(number ? `${above}\n` : "", wrong, `\n${below}`);
}

async function play(block, bar) {
  chosen = block;
  const asked = () => ({ name: chosen.dataset.name, program: programOf(chosen) });
  player ??= new Player(document.createElement("section"), SITE, asked, mark);
  bar.after(player.place);
  await player.run();
}

await isolate(); // before a click: the page may be loaded once more for it
document.body.dataset.ready = "yes";

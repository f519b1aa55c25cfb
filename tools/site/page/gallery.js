// The first page: a program in the editor, its screen, and all the demos to choose from.

import { Editor } from "./editor.js";
import { isolate } from "./isolate.js";
import { Player } from "./player.js";
import { packed, unpacked } from "./share.js";
import { SITE } from "./contents.js";

const FIRST = "tour";

const $ = (id) => document.getElementById(id);
let name = "program.py";

const editor = new Editor($("editor"), () => player.run());
const player = new Player($("player"), SITE, () => ({ name, program: editor.program }), (line) => editor.mark(line));

async function open() {
  const given = await unpacked(location.hash);
  if (given) return show(given.name, given.program);
  const chosen = [location.hash.slice(1), FIRST].find((demo) => document.querySelector(`[data-demo="${CSS.escape(demo)}"]`));
  const { file } = document.querySelector(`[data-demo="${chosen}"]`).dataset;
  show(file, await (await fetch(`programs/${file}`)).text());
}

function show(file, program) {
  name = file;
  $("name").textContent = file;
  editor.program = program;
}

// A demo of the gallery begins at once: that it was chosen is enough.
for (const card of document.querySelectorAll("[data-demo]")) {
  card.onclick = async (event) => {
    event.preventDefault();
    history.pushState(null, "", `#${card.dataset.demo}`);
    await open();
    scrollTo({ top: 0, behavior: "smooth" });
    player.run();
  };
}

$("share").onclick = async () => {
  const link = await packed(name, editor.program);
  history.replaceState(null, "", link);
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  $("share").textContent = "The link is in the address bar";
  setTimeout(() => ($("share").textContent = "Copy a link to it"), 3000);
};

addEventListener("popstate", open);
await Promise.all([open(), isolate()]);
document.body.dataset.ready = "yes";
player.load();

// The first page: a program in the editor, its screen, and all the demos to choose from.

import { Editor } from "./editor.js";
import { isolate } from "./isolate.js";
import { Player } from "./player.js";
import { packed, unpacked } from "./share.js";
import { SITE } from "./contents.js";

const FIRST = "tour";
const OF_C = /^\s*#\s*include\s*[<"]/m;

const $ = (id) => document.getElementById(id);
let name = "program.py";

const editor = new Editor($("editor"), () => player.run());
const player = new Player($("player"), SITE, chosen, (line) => editor.mark(line));

// What is to run: a program that was pasted may be in the other language than the one before.
function chosen() {
  const { program } = editor;
  const isC = OF_C.test(program);
  if (isC === name.endsWith(".py")) name = isC ? "PROGRAM.C" : "program.py";
  $("name").textContent = name;
  return { name, program };
}

function card(demo) {
  return document.querySelector(`[data-demo="${CSS.escape(demo)}"]`);
}

async function open() {
  const given = await unpacked(location.hash);
  if (given) return show(given.name, given.program);
  const demo = [location.hash.slice(1), FIRST].find(card);
  const { file } = card(demo).dataset;
  show(file, await (await fetch(`programs/${file}`)).text());
}

function show(file, program) {
  name = file;
  $("name").textContent = file;
  editor.program = program;
}

// A demo of the gallery begins at once: that it was chosen is enough.
for (const one of document.querySelectorAll("[data-demo]")) {
  one.onclick = async (event) => {
    event.preventDefault();
    history.pushState(null, "", `#${one.dataset.demo}`);
    await open();
    scrollTo({ top: 0, behavior: "smooth" });
    player.run();
  };
}

$("share").onclick = async () => {
  const sent = chosen();
  const link = await packed(sent.name, sent.program);
  history.replaceState(null, "", link);
  await navigator.clipboard?.writeText(location.href).catch(() => {});
  $("share").textContent = "The link is in the address bar";
  setTimeout(() => ($("share").textContent = "Copy a link to it"), 3000);
};

addEventListener("popstate", open);
await Promise.all([open(), isolate()]);
document.body.dataset.ready = "yes";
player.load();

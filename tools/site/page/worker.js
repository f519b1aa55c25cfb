// Python, in a worker of its own: it may work or wait as long as it likes, the page goes on.

import { loadPyodide } from "./python/pyodide.mjs";
import { bytes, watchFetches } from "./parts.js";
import { SharedPort, SuspendedPort } from "./port.js";

const HERE = new URL("./python/", import.meta.url).href;

let python, port, interrupt;

onmessage = async ({ data }) => {
  try {
    if (data.start) await start(data.start);
    else if (data.run) await run(data.run);
    else if (data.say) port.put(data.say);
    else if (data.stop) port.stop();
  } catch (error) {
    postMessage({ failed: String(error) });
  }
};

async function start({ memory, signals, parts }) {
  watchFetches((count) => postMessage({ loaded: count }));
  const wanted = parts.map((name) => bytes(HERE + name));
  python = await loadPyodide({ indexURL: HERE });
  for (const part of await Promise.all(wanted)) python.unpackArchive(part, "zip", { extractDir: "/packages" });
  port = memory ? new SharedPort(python, memory) : new SuspendedPort();
  interrupt = new Uint8Array(signals ?? 1);
  python.setInterruptBuffer(interrupt);
  python.setStdin({ stdin: port.ask });
  python.setStdout({ write });
  python.setStderr({ write });
  python.registerJsModule("bgi_port", port);
  python.runPython("import sys; sys.path[:0] = ['/packages', '/packages/demos', '/packages/demos/course']; import numpy, runner, bgi.__main__, bgi.monitor.tab");
  postMessage({ ready: true });
}

function write(bytes) {
  postMessage({ text: new TextDecoder().decode(bytes) });
  return bytes.length;
}

async function run({ name, program }) {
  interrupt[0] = 0;
  port.begin();
  const call = "runner.run(name, program)";
  const globals = python.toPy({ name, program, runner: python.globals.get("runner") });
  postMessage({ started: true });
  const status = port.shared
    ? python.runPython(call, { globals })
    : await python.runPythonAsync(call, { globals });
  globals.destroy();
  postMessage({ ended: status });
}

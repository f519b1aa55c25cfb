// Runs pytest in Pyodide, on node: node tests.mjs CORE REPOSITORY WHEEL... -- ARGUMENTS OF PYTEST

import { readFileSync } from "node:fs";
import { pathToFileURL } from "node:url";

const [core, repository, ...rest] = process.argv.slice(2);
const end = rest.indexOf("--");
const { loadPyodide } = await import(pathToFileURL(`${core}/pyodide.mjs`).href);
const python = await loadPyodide({
  indexURL: `${core}/`,
  env: { HOME: "/home/pyodide", HYPOTHESIS_STORAGE_DIRECTORY: "/tmp/hypothesis" },
});
for (const wheel of rest.slice(0, end)) {
  python.unpackArchive(new Uint8Array(readFileSync(wheel)), "zip", { extractDir: "/wheels" });
}
python.FS.mkdir("/repository");
python.mountNodeFS("/repository", repository);
python.globals.set("arguments", python.toPy(rest.slice(end + 1)));
process.exitCode = python.runPython(`
import os, sys
sys.path[:0] = ["/repository", "/wheels"]
sys.dont_write_bytecode = True
os.chdir("/repository")
import pytest
int(pytest.main([*arguments]))
`);

// A program in an address: packed, behind the #, so that no server ever sees it.

const NAME = /^[\w-]{1,40}\.\w{1,4}$/;

export async function packed(name, program) {
  const bytes = await through(new TextEncoder().encode(program), new CompressionStream("deflate-raw"));
  const text = btoa(Array.from(bytes, (byte) => String.fromCharCode(byte)).join(""));
  return `#${name}=${text.replaceAll("+", "-").replaceAll("/", "_").replaceAll("=", "")}`;
}

// The program of an address, {name, program}; undefined if it has none.
export async function unpacked(hash) {
  const [name, text] = hash.slice(1).split("=");
  if (!text || !NAME.test(name)) return undefined;
  try {
    const bytes = Uint8Array.from(atob(text.replaceAll("-", "+").replaceAll("_", "/")), (c) => c.charCodeAt(0));
    const program = await through(bytes, new DecompressionStream("deflate-raw"));
    return { name, program: new TextDecoder().decode(program) };
  } catch {
    return undefined; // a link that was cut
  }
}

async function through(bytes, stream) {
  return new Uint8Array(await new Response(new Blob([bytes]).stream().pipeThrough(stream)).arrayBuffer());
}

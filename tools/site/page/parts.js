// Files of Python's, fetched with a report of how far that is; the largest ones come packed.

const PACKED = /\.wasm$/; // by gzip, whatever the host does: `tools/site/build.py`

// Has fetch() of this worker unpack what is packed, and tells report(bytes) what arrives.
export function watchFetches(report) {
  const fetchAsIs = self.fetch.bind(self);
  self.fetch = async (address, options) => {
    const url = String(address.url ?? address);
    const packed = PACKED.test(url);
    const response = await fetchAsIs(packed ? `${url}.packed` : url, options);
    if (!response.ok) throw new Error(`${url}: ${response.status}`);
    const counted = response.body.pipeThrough(
      new TransformStream({
        transform(chunk, controller) {
          report(chunk.byteLength);
          controller.enqueue(chunk);
        },
      }),
    );
    const body = packed ? counted.pipeThrough(new DecompressionStream("gzip")) : counted;
    const kind = packed ? "application/wasm" : response.headers.get("Content-Type");
    return new Response(body, { headers: kind ? { "Content-Type": kind } : {} });
  };
}

export async function bytes(url) {
  return new Uint8Array(await (await fetch(url)).arrayBuffer());
}

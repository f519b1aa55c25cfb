// A PNG of the screen: every pixel of the page as one pixel, indices and palette as they are.

const SIGNATURE = [0x89, 0x50, 0x4e, 0x47, 0x0d, 0x0a, 0x1a, 0x0a];
const RGB = 2, INDEXED = 3;

const TABLE = Uint32Array.from({ length: 256 }, (_, byte) => {
  for (let bit = 0; bit < 8; bit++) byte = byte & 1 ? 0xedb88320 ^ (byte >>> 1) : byte >>> 1;
  return byte;
});

function crc32(bytes) {
  let crc = 0xffffffff;
  for (const byte of bytes) crc = TABLE[(crc ^ byte) & 0xff] ^ (crc >>> 8);
  return ~crc >>> 0;
}

function chunk(kind, data) {
  const bytes = new Uint8Array(12 + data.length);
  const view = new DataView(bytes.buffer);
  view.setUint32(0, data.length);
  bytes.set([...kind].map((letter) => letter.charCodeAt(0)), 4);
  bytes.set(data, 8);
  view.setUint32(8 + data.length, crc32(bytes.subarray(4, 8 + data.length)));
  return bytes;
}

async function deflated(bytes) {
  const stream = new Blob([bytes]).stream().pipeThrough(new CompressionStream("deflate"));
  return new Uint8Array(await new Response(stream).arrayBuffer());
}

// Each row with a 0 before it: no filter.
function scanlines(width, height, size, put) {
  const bytes = new Uint8Array(height * (1 + width * size));
  for (let y = 0; y < height; y++) put(bytes, y * (1 + width * size) + 1, y * width);
  return bytes;
}

export async function png({ width, height, pixels, palette, shown }) {
  const indexed = pixels.BYTES_PER_ELEMENT === 1;
  const head = new DataView(new ArrayBuffer(13));
  head.setUint32(0, width);
  head.setUint32(4, height);
  head.setUint8(8, 8);
  head.setUint8(9, indexed ? INDEXED : RGB);
  const rows = indexed
    ? scanlines(width, height, 1, (bytes, to, from) => bytes.set(pixels.subarray(from, from + width), to))
    : scanlines(width, height, 3, (bytes, to, from) => {
        for (let x = 0; x < width; x++) {
          const color = shown[from + x];
          bytes[to + 3 * x] = color & 255;
          bytes[to + 3 * x + 1] = (color >> 8) & 255;
          bytes[to + 3 * x + 2] = (color >> 16) & 255;
        }
      });
  const parts = [
    new Uint8Array(SIGNATURE),
    chunk("IHDR", new Uint8Array(head.buffer)),
    ...(indexed ? [chunk("PLTE", palette)] : []),
    chunk("IDAT", await deflated(rows)),
    chunk("IEND", new Uint8Array(0)),
  ];
  return new Blob(parts, { type: "image/png" });
}

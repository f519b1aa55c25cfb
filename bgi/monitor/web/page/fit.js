// The size of the picture in a room: bgi/monitor/picture.py's `inside`, in pixels of the display.

// Every mode of the PC filled a monitor of 4:3, whatever its number of pixels.
function rows({ width, height, square }, across) {
  return Math.floor((across * (square ? height : 3)) / (square ? width : 4));
}

// In whole steps across; shrunk where even one is too large. Where the display's pixels are too
// fine to be told apart (`fine`) whole steps are given up rather than a quarter of the room.
export function inside(shape, width, height, fine = false) {
  const least = Math.max(rows(shape, shape.width), 1);
  const part = Math.min(width / shape.width, height / least);
  const steps = Math.floor(part);
  const scale = steps && (!fine || steps > 0.75 * part) ? steps : fine ? part : Math.min(part, 1);
  const across = Math.max(Math.floor(shape.width * scale), 1);
  return { width: across, height: Math.max(rows(shape, across), 1) };
}

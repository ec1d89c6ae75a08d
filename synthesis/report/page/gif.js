"use strict";
// Moving pictures: GIF 89a, by its specification (CompuServe 1990).

// The colours of all frames, the 255 commonest, and which of them each of 32768 coarse colours is nearest to.
function paletteOf(frames) {
  const counts = new Uint32Array(32768);
  const coarse = (data, i) => (data[i] >> 3 << 10) | (data[i + 1] >> 3 << 5) | (data[i + 2] >> 3);
  for (const data of frames) for (let i = 0; i < data.length; i += 4) ++counts[coarse(data, i)];
  const seen = Array.from(counts.keys()).filter((c) => counts[c] > 0).sort((a, b) => counts[b] - counts[a]);
  const part = (c, shift) => Math.round((c >> shift & 31) * 255 / 31);
  const colours = seen.slice(0, 255).map((c) => [part(c, 10), part(c, 5), part(c, 0)]);
  const nearest = new Uint8Array(32768);
  seen.forEach((c, place) => {
    if (place < 255) { nearest[c] = place; return; }
    let least = Infinity;
    colours.forEach(([r, g, b], i) => {
      const distance = (r - part(c, 10)) ** 2 + (g - part(c, 5)) ** 2 + (b - part(c, 0)) ** 2;
      if (distance < least) [least, nearest[c]] = [distance, i];
    });
  });
  return { colours, indices: (data) => {
    const all = new Uint8Array(data.length / 4);
    for (let i = 0; i < all.length; ++i) all[i] = nearest[coarse(data, 4 * i)];
    return all;
  } };
}

// Bytes packed by the variant of LZW that GIF has, in blocks of 255.
function packed(indices) {
  const bytes = [], clear = 256, end = 257;
  let codes = new Map(), next = 258, size = 9, bits = 0, held = 0;
  const put = (code) => {
    held |= code << bits;
    bits += size;
    for (; bits >= 8; bits -= 8, held >>>= 8) bytes.push(held & 255);
  };
  put(clear);
  let prefix = indices[0];
  for (let i = 1; i < indices.length; ++i) {
    const key = prefix << 8 | indices[i], known = codes.get(key);
    if (known !== undefined) { prefix = known; continue; }
    put(prefix);
    if (next === 4096) {
      put(clear);
      [codes, next, size] = [new Map(), 258, 9];
    } else {
      if (next === 1 << size) ++size;
      codes.set(key, next++);
    }
    prefix = indices[i];
  }
  put(prefix);
  put(end);
  if (bits > 0) bytes.push(held & 255);
  const blocks = [8];
  for (let i = 0; i < bytes.length; i += 255) blocks.push(Math.min(255, bytes.length - i), ...bytes.slice(i, i + 255));
  return blocks.concat(0);
}

// A picture that moves for ever: frames of red, green, blue and opacity, each shown for so many hundredths of a second.
function gifOf(frames, width, height, delay) {
  const { colours, indices } = paletteOf(frames);
  const word = (n) => [n & 255, n >> 8];
  const table = colours.flat().concat(new Array(768 - 3 * colours.length).fill(0));
  const text = (letters) => Array.from(letters, (c) => c.charCodeAt(0));
  const parts = [[...text("GIF89a"), ...word(width), ...word(height), 0xf7, 0, 0, ...table,
    0x21, 0xff, 11, ...text("NETSCAPE2.0"), 3, 1, 0, 0, 0]];
  for (const data of frames)
    parts.push([0x21, 0xf9, 4, 0, ...word(delay), 0, 0, 0x2c, 0, 0, 0, 0, ...word(width), ...word(height), 0],
      packed(indices(data)));
  parts.push([0x3b]);
  return new Blob(parts.map((part) => Uint8Array.from(part)), { type: "image/gif" });
}

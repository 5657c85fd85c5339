// Takes a WebAssembly module apart into its sections, and takes tables and zeros out of its data.

/** @param {Uint8Array} bytes */
function reader(bytes, at = 0) {
  return {
    get at() {
      return at;
    },
    set at(to) {
      at = to;
    },
    byte: () => bytes[at++],
    leb() {
      let value = 0,
        shift = 1,
        byte;
      do {
        byte = bytes[at++];
        value += (byte & 127) * shift;
        shift *= 128;
      } while (byte & 128);
      return value;
    },
    sleb() {
      let value = 0,
        shift = 0,
        byte;
      do {
        byte = bytes[at++];
        value |= (byte & 127) << shift;
        shift += 7;
      } while (byte & 128);
      return shift < 32 && byte & 64 ? value | (~0 << shift) : value;
    },
  };
}

/** @param {number} value */
export function leb(value) {
  const out = [];
  do {
    out.push((value & 127) | (value > 127 ? 128 : 0));
    value = Math.floor(value / 128);
  } while (value);
  return out;
}

/** @param {number} value */
function sleb(value) {
  const out = [];
  for (;;) {
    const byte = value & 127;
    value >>= 7;
    if ((value === 0 && !(byte & 64)) || (value === -1 && byte & 64)) return [...out, byte];
    out.push(byte | 128);
  }
}

/** @param {Uint8Array} bytes @returns {{id: number, body: Uint8Array}[]} */
export function sections(bytes) {
  const read = reader(bytes, 8),
    found = [];
  while (read.at < bytes.length) {
    const id = read.byte(),
      length = read.leb();
    found.push({ id, body: bytes.subarray(read.at, read.at + length) });
    read.at += length;
  }
  return found;
}

/** @param {{id: number, body: Uint8Array | number[]}[]} parts */
export function module(parts) {
  const head = [0, 0x61, 0x73, 0x6d, 1, 0, 0, 0];
  return Uint8Array.from(parts.reduce((out, { id, body }) => out.concat([id], leb(body.length), [...body]), head));
}

/** @param {string} name @param {Iterable<number>} content */
export const custom = (name, content) => {
  const text = new TextEncoder().encode(name);
  return { id: 0, body: [...leb(text.length), ...text, ...content] };
};

/** @param {Uint8Array} body of the data section @returns {{address: number, bytes: Uint8Array}[]} */
export function segments(body) {
  const read = reader(body),
    found = [];
  for (let n = read.leb(); n > 0; n--) {
    if (read.leb() !== 0 || read.byte() !== 0x41) throw new Error('the module has a data segment that is not active in memory 0');
    const address = read.sleb();
    read.byte();
    const length = read.leb();
    found.push({ address, bytes: body.slice(read.at, read.at + length) });
    read.at += length;
  }
  return found;
}

/** Removes runs of zeros from the data, since memory is zero at the start. */
export function dataSection(found) {
  const pieces = [];
  for (const { address, bytes } of found) {
    let start = 0;
    for (let at = 0; at < bytes.length;) {
      let end = at;
      while (end < bytes.length && bytes[end] === 0) end++;
      if (end - at >= 8 || (end === bytes.length && end > at) || (at === 0 && end > 0)) {
        if (at > start) pieces.push({ address: address + start, bytes: bytes.subarray(start, at) });
        start = end;
      }
      at = Math.max(end, at + 1);
    }
    if (start < bytes.length) pieces.push({ address: address + start, bytes: bytes.subarray(start) });
  }
  const body = leb(pieces.length);
  for (const { address, bytes } of pieces)
    body.push(0, 0x41, ...sleb(address), 0x0b, ...leb(bytes.length), ...bytes);
  return { id: 11, body };
}

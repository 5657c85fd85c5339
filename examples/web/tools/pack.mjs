// Packs the measured tables. package/tables.js unpacks them and describes the format.
import { BLOCK, POWERS, predicted } from '../package/tables.js';

/**
 * @typedef {object} Table
 * @property {number} rule one of RULES
 * @property {number} before the number of zeros in front of each column
 * @property {number} behind the number of zeros behind each column
 * @property {number[][]} columns the values, or for a copy [[table, column, rows]]
 */

/** Returns how many decimals a number needs, 0..15. */
function decimals(value) {
  const [mantissa, exponent = '0'] = String(value).split('e');
  return Math.max(0, (mantissa.split('.')[1] ?? '').length - Number(exponent));
}

/** @param {number[]} values @param {number} order @param {(bit: number) => void} put */
function code(values, order, put) {
  const bits = (x, n) => {
    for (let i = n - 1; i >= 0; i--) put(Math.floor(x / 2 ** i) % 2);
  };
  for (let at = 0; at < values.length; at += BLOCK) {
    const block = values.slice(at, at + BLOCK);
    const digits = Math.max(...block.map(decimals)),
      scale = POWERS[digits];
    const codes = block.map((value, k) => {
      const miss = Math.round(value * scale) - predicted(values, at + k, order, scale);
      return miss >= 0 ? 2 * miss : -2 * miss - 1;
    });
    const cost = (k) => codes.reduce((sum, x) => sum + 1 + k + Math.floor(x / 2 ** k), 0);
    let best = 0;
    for (let k = 1; k < 32; k++) if (cost(k) < cost(best)) best = k;
    bits(digits, 4);
    bits(best, 5);
    for (const x of codes) {
      for (let q = Math.floor(x / 2 ** best); q > 0; q--) put(1);
      put(0);
      bits(x % 2 ** best, best);
    }
  }
}

/** @param {Table[]} tables @returns {Uint8Array} */
export function pack(tables) {
  const out = [tables.length];
  for (const { rule, before, behind, columns } of tables) {
    let best;
    for (let order = 0; order < 5; order++) {
      const bits = [];
      for (const column of columns) code(column, order, (bit) => bits.push(bit));
      if (!best || bits.length < best.bits.length) best = { order, bits };
    }
    const rows = columns[0].length;
    out.push(rule + 8 * best.order, columns.length, rows & 255, rows >> 8, before, behind);
    for (let i = 0; i < best.bits.length; i += 8) {
      let byte = 0;
      for (let j = 0; j < 8; j++) byte = byte * 2 + (best.bits[i + j] ?? 0);
      out.push(byte);
    }
  }
  return Uint8Array.from(out);
}

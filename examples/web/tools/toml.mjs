// Reads as much of TOML as the bundled scenes use: tables, arrays of tables, dotted keys, inline tables, and arrays on
// one line.

/** @param {string} text */
export function toml(text) {
  const root = {};
  let table = root;
  const reach = (from, keys) =>
    keys.reduce((at, key) => {
      at[key] ??= {};
      return Array.isArray(at[key]) ? at[key].at(-1) : at[key];
    }, from);
  for (const line of text.split('\n').map((line) => line.trim())) {
    if (line === '' || line.startsWith('#')) continue;
    const list = /^\[\[(.+)\]\]$/.exec(line),
      head = /^\[([^\[].*)\]$/.exec(line);
    if (list) {
      const keys = list[1].split('.'),
        last = keys.pop();
      table = {};
      (reach(root, keys)[last] ??= []).push(table);
    } else if (head) table = reach(root, head[1].split('.'));
    else assign(table, line);
  }
  return root;

  function assign(into, line) {
    const [, left, right] = /^([\w.]+)\s*=\s*(.*)$/.exec(line),
      keys = left.split('.'),
      last = keys.pop();
    reach(into, keys)[last] = value(right);
  }

  function value(text) {
    if (text.startsWith('{')) {
      const inline = {};
      for (const pair of text.slice(1, text.lastIndexOf('}')).split(',')) assign(inline, pair.trim());
      return inline;
    }
    return JSON.parse(text.replace(/\s*#[^"]*$/, ''));
  }
}

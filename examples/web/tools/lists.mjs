// Makes lists.js, the names that the crate lists, for the package and the page.

/** @param {Uint8Array} wasm the module `lists` @returns {{illuminants: string[], brief: string, observers: [string, string][]}} */
export function lists(wasm) {
  const { text, length, memory } = new WebAssembly.Instance(new WebAssembly.Module(wasm)).exports;
  const list = (number) => {
    const items = [];
    for (let size; (size = length(number, items.length)) > 0; )
      items.push(new TextDecoder().decode(new Uint8Array(memory.buffer, text(number, items.length), size)));
    return items;
  };
  const [illuminants, [brief], names, titles] = [0, 1, 2, 3].map(list);
  return { illuminants, brief, observers: names.map((name, k) => [name, titles[k]]) };
}

/** Returns the texts of lists.js and of its types. @param {ReturnType<typeof lists>} lists */
export const source = ({ brief, observers }) => ({
  'lists.js': `// Made by tools/lists.mjs from the lists of the crate.
/** The name and the title of each observer. */
export const OBSERVERS = ${JSON.stringify(observers)};
/** The names of the illuminants, for messages. */
export const ILLUMINANTS = ${JSON.stringify(brief)};
`,
  'lists.d.ts': `/** The names of the observers, which are sets of color-matching functions. */
export type Observer = ${observers.map(([name]) => JSON.stringify(name)).join(' | ')};
export const OBSERVERS: [Observer, string][];
export const ILLUMINANTS: string;
`,
});

// Runs the bit check of a module and prints the same lines as the firmware image `bits`: node run.mjs <module.wasm>
import { readFile } from 'node:fs/promises';

const { instance } = await WebAssembly.instantiate(await readFile(process.argv[2]), {
  env: {
    report(name, length, hash) {
      const text = new TextDecoder().decode(new Uint8Array(instance.exports.memory.buffer, name, length));
      console.log(text, (hash >>> 0).toString(16).padStart(8, '0'));
    },
  },
});
instance.exports.bits();

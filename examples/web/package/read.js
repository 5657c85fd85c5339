// Reads the package's own files, in a browser or in node.

/** @param {URL} url @returns {Promise<Uint8Array>} */
export async function read(url) {
  if (url.protocol === 'file:') {
    // The name is in a variable so that bundlers for browsers do not look for the module.
    const files = 'node:fs/promises';
    const { readFile } = await import(/* webpackIgnore: true */ /* @vite-ignore */ files);
    return readFile(url);
  }
  const response = await fetch(url);
  if (!response.ok) throw new Error(`${url.pathname}: ${response.status} ${response.statusText}`);
  return new Uint8Array(await response.arrayBuffer());
}

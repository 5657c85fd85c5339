import type { Source } from './nanospectra.js';
/** All spectra of a text: the first column is the wavelength in nm, every other column is a spectrum. Strict: an Error says where and what. */
export function parse(text: string, file?: string): Source[];

import type { Source } from './nanospectra.js';
/**
 * Reads all spectra of a table: the first column is the wavelength in nm, and every other column is a spectrum. A text
 * that is not plainly such a table is refused with an Error that names the line and the fault, in the words of the command
 * `nanospectra measure --strict`. `file` is used as the name of the file in messages. A heading that begins with `band-nm`
 * says that the values are averages over bands.
 */
export function parse(text: string, file?: string): Source[];
/** Returns a name as a cell of CSV, which no spreadsheet takes for a formula. */
export function cell(name: string): string;

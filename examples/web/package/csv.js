// Reads spectra from text. A text that is not plainly a table of numbers is refused with a message that names the line,
// in the words of the command `nanospectra measure --strict`.

import { plain, short } from './numbers.js';

const NUMBER = /^[+-]?(?:(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?|inf|infinity|nan)$/i;

/** @param {string} cell @returns {number | undefined} */
function numberIn(cell) {
  if (!NUMBER.test(cell)) return undefined;
  const plain = cell.toLowerCase();
  if (plain.includes('n')) return plain.includes('nan') ? NaN : plain.startsWith('-') ? -Infinity : Infinity;
  return Number(cell);
}

/** @param {string} cell @param {string} what */
function number(cell, what) {
  if (cell === '') throw new Error(`${what} is empty; fill it in (with 0 only if 0 was measured)`);
  const value = numberIn(cell);
  if (value !== undefined && Number.isFinite(value)) return value;
  if (value !== undefined) throw new Error(`${what} is ${short(cell)}, which is not a finite number; correct it`);
  if (numberIn(cell.replace(',', '.')) !== undefined) {
    throw new Error(`${what} is '${short(cell)}'; write the decimal point as '.'`);
  }
  throw new Error(`${what} is '${short(cell)}', which is not a number; correct it`);
}

const count = (cells) => (cells === 1 ? '1 cell' : `${cells} cells`);

/** Returns the mark between the cells of a row of numbers, or '' if blanks separate them. @param {string} row */
function separatorOf(row) {
  const bare = row
    .split('"')
    .filter((_, k) => k % 2 === 0)
    .join('');
  return [';', '\t', ','].find((mark) => bare.includes(mark)) ?? '';
}

/** @param {string} line @param {string} mark @returns {string[]} */
function cellsOf(line, mark) {
  if (line.includes('\r')) {
    throw new Error('there is a carriage return inside the line; save the file with LF or CRLF line ends');
  }
  if (line.includes('"')) return quoted(line, mark);
  return mark ? line.split(mark).map((cell) => cell.trim()) : line.trim().split(/\s+/);
}

/** Splits a line with quotes by the rules of CSV, except that quotes must close on the line where they open. */
function quoted(line, mark) {
  const parts = line.split('"'),
    last = parts.length - 1,
    delimiter = mark || ' ';
  if (last % 2) throw new Error('a quote is opened but not closed; close it on the same line');
  for (let k = 0; k <= last; k += 2) {
    const outside = mark ? parts[k].replace(/^ +| +$/g, '') : parts[k];
    const apart = (k === 0 || outside.startsWith(delimiter)) && (k === last || outside.endsWith(delimiter));
    // If nothing is between two quotes, they are one quote inside a quoted cell.
    if (outside !== '' && !apart) {
      throw new Error('there is text beside a quoted cell; put the quotes around the whole cell');
    }
    parts[k] = outside;
  }
  const cells = [''];
  let inside = false;
  const text = parts.join('"');
  for (let i = 0; i < text.length; i++) {
    if (text[i] === '"' && inside && text[i + 1] === '"') {
      cells[cells.length - 1] += '"';
      i++;
    } else if (text[i] === '"') inside = !inside;
    else if (text[i] === delimiter && !inside) cells.push('');
    else cells[cells.length - 1] += text[i];
  }
  return cells.map((cell) => cell.trim()).filter((cell) => mark || cell !== '');
}

/** Refuses a first line that has no wavelength and does not look like a heading either. */
function checkHeading(cells) {
  const first = cells[0] ?? '',
    lower = first.toLowerCase();
  const names = ['nm', 'wave', 'lambda', 'λ', 'wl'].some((word) => lower.includes(word));
  const follow = cells.length > 1 && cells.slice(1).every((cell) => numberIn(cell) !== undefined);
  if (/^[\d+\-.]/.test(first) || (follow && !names)) {
    throw new Error(
      `'${short(first)}' is not a wavelength; correct it, or begin the line with 'nm' if it is a heading`,
    );
  }
}

/**
 * @typedef {object} Source one spectrum of a file
 * @property {string} file
 * @property {string} name
 * @property {number[]} lines the line on which each sample stands, counted from 1
 * @property {boolean} [averages] whether the values are averages over bands, as the heading 'band-nm' says
 * @property {[number, number][]} samples at least two pairs of wavelength in nm and value, finite and increasing
 */

/**
 * Reads all spectra of a text: the first column is the wavelength in nm, and every other column is a spectrum.
 * @param {string} text @param {string} [file] its name, for messages and for spectra without a heading
 * @returns {Source[]}
 */
export function parse(text, file = 'pasted') {
  const at = (line, work) => {
    try {
      return work();
    } catch (error) {
      throw new Error(`${file}:${line}: ${error.message}`);
    }
  };
  const rows = text
    .replace(/^\uFEFF/, '')
    .split('\n')
    .map((line, k) => ({ line: line.replace(/\r$/, ''), number: k + 1 }))
    .filter(({ line }) => line.trim() !== '' && !line.trimStart().startsWith('#'));
  const first = rows.find(({ line }) => {
    const cell = line
      .trimStart()
      .replace(/^"+/, '')
      .split(/[,;\t "]/)[0];
    return numberIn(cell) !== undefined;
  });
  if (!first) {
    return at(rows[0]?.number ?? 1, () => {
      throw new Error('there is no row of numbers; give rows with a wavelength in nm and one or more values');
    });
  }
  const mark = separatorOf(first.line);
  let heading,
    names,
    values,
    lines = [],
    nms = [];
  for (const { line, number: row } of rows) {
    at(row, () => {
      const cells = cellsOf(line, mark);
      if (row < first.number) {
        if (heading) {
          throw new Error("this is neither a heading nor a row of numbers; begin the line with '#' to skip it");
        }
        checkHeading(cells);
        heading = { cells, row };
        return;
      }
      if (!names) {
        names = namesOf(cells, heading);
        values = names.map(() => []);
      }
      push(cells, row);
    });
  }
  if (lines.length === 1)
    at(lines[0], () => {
      throw new Error('one sample is not a spectrum; give two or more');
    });
  const stem = file.replace(/^.*\//, '').replace(/(.)\.[^.]*$/, '$1');
  return names.map((name, k) => ({
    file,
    name: name ?? (names.length > 1 ? `${stem}:${k + 1}` : stem),
    lines,
    ...(heading?.cells[0].toLowerCase() === 'band-nm' && { averages: true }),
    samples: nms.map((nm, j) => [nm, values[k][j]]),
  }));

  function push(cells, row) {
    if (cells.length > 1 && cells.at(-1) === '') {
      throw new Error('the row ends with an empty cell; fill it in, or remove the last separator');
    }
    if (cells.length !== names.length + 1) {
      throw new Error(
        `the row has ${count(cells.length)}, but the rows before it have ${names.length + 1}; complete it`,
      );
    }
    const nm = number(cells[0], 'the wavelength');
    checkWavelength(nm);
    cells.slice(1).forEach((cell, k) => {
      values[k].push(number(cell, names[k] === undefined ? `cell ${k + 2}` : `'${names[k]}'`));
    });
    nms.push(nm);
    lines.push(row);
  }

  function checkWavelength(nm) {
    if (nm <= 0) throw new Error(`${plain(nm)} is not a wavelength; give nanometers above 0`);
    if (nms.length === 0) return;
    const before = nms.at(-1);
    if (nm === before)
      throw new Error(`${plain(nm)} nm is in line ${lines.at(-1)} too; keep one of the two rows`);
    if (nm < before)
      throw new Error(`${plain(nm)} nm comes after ${plain(before)} nm; sort the rows by wavelength`);
    if (Math.fround(nm) === Math.fround(before)) {
      throw new Error(`${plain(nm)} nm is too near to ${plain(before)} nm to tell them apart; use wider steps`);
    }
  }
}

/** Returns the names of the columns, as the heading and the first row of numbers define them. */
function namesOf(row, heading) {
  if (row.length < 2) {
    throw new Error(
      'there is no value beside the wavelength; give rows with a wavelength in nm and one or more values',
    );
  }
  if (!heading) return row.slice(1).map(() => undefined);
  if (heading.cells.length !== row.length) {
    throw new Error(
      `the row has ${count(row.length)}, but the heading in line ${heading.row} has ${heading.cells.length}; ` +
        'make both agree, with quotes around names that contain a separator',
    );
  }
  return heading.cells.slice(1).map((cell) => (cell === '' ? undefined : cell));
}

/**
 * Returns a name as a cell of CSV. Spreadsheets take a text that begins so for a formula, even in quotes; with an
 * apostrophe in front it is a text.
 * @param {string} name
 */
export const cell = (name) => `"${/^[=+\-@\t\r]/.test(name) ? "'" : ''}${name.replaceAll('"', '""')}"`;

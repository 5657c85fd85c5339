// Tests the package in node: both builds give the same numbers as the program `nanospectra`, to the last bit.
import assert from 'node:assert/strict';
import { mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { before } from 'node:test';
import { load } from '../dist/nanospectra/nanospectra.js';
import { cell, parse } from '../dist/nanospectra/csv.js';
import { OBSERVERS } from '../dist/nanospectra/lists.js';
import { setEye } from '../page/color.js';
import { spectrum } from '../page/plots.js';
import { scenes } from '../tools/scenes.mjs';
import { toml } from '../tools/toml.mjs';
import * as host from './host.mjs';
import { RECIPES } from './recipes.mjs';

const BUILDS = [
  ['plain', false],
  ['simd128', true],
];
const bundled = new URL('../../cli/data/l41_white_led.csv', import.meta.url);
const golden = (name) =>
  readFileSync(new URL(`../../../tests/data/${name}.csv`, import.meta.url), 'utf8')
    .trim()
    .split('\n')
    .filter((line) => !line.startsWith('#'))
    .map((line) => line.split(','));

/** @type {Map<boolean, import('../package/nanospectra.d.ts').Modules>} */
const loaded = new Map();

before(async () => {
  host.build();
  for (const [, simd] of BUILDS) {
    const modules = {};
    for (const module of ['light', 'paint', 'scene', 'core', 'bands']) modules[module] = await load({ module, simd });
    for (const module of ['light', 'paint', 'scene']) await modules[module].loadLamps();
    loaded.set(simd, modules);
  }
});

/** Returns the CSV of lamps with the same wavelengths. */
function table(lamps) {
  const rows = lamps[0].samples.map(([nm], k) => [nm, ...lamps.map((lamp) => lamp.samples[k][1])].join(','));
  return [`nm,${lamps.map((lamp) => lamp.name).join(',')}`, ...rows].join('\n');
}

/** Returns every lamp, in files of lamps with the same wavelengths. */
function files() {
  const groups = new Map();
  for (const lamp of loaded.get(false).light.lamps.values()) {
    const key = lamp.samples.map(([nm]) => nm).join();
    groups.set(key, [...(groups.get(key) ?? []), lamp]);
  }
  return [...groups.values()].map(table);
}

/** The keys that only the package has. */
const OWN = ['tm30', 'scale', 'curve'];

/** Compares every key that the program prints, and their order. */
function same(reading, expected) {
  for (const key of Object.keys(expected))
    assert.deepEqual(reading[key], expected[key], `${expected.name}: ${key}`);
  assert.deepEqual(Object.keys(reading).filter((key) => !OWN.includes(key)), Object.keys(expected), expected.name);
}

/** Returns the message with which the program refuses an input. */
function refusal(args, text) {
  const { status, stderr } = host.run('measure', ['--strict', '--fail-fast', ...args, '-'], text);
  assert.equal(status, 2, text);
  return stderr.trim();
}

for (const [name, simd] of BUILDS) {
  const each = (text, options = {}) =>
    parse(text, 'stdin').map((source) => loaded.get(simd).light.spectrum(source, options));

  test(`${name}: every number about every CIE lamp is the command line's`, () => {
    let count = 0;
    for (const text of files()) {
      const expected = host.measured(['-'], text);
      each(text).forEach((reading, k) => same(reading, expected[k]));
      count += expected.length;
    }
    assert.ok(count >= 49, `${count} lamps`);
  });

  test(`${name}: so are they by other observers, by Sprague's rule and in absolute units`, () => {
    const text = readFileSync(bundled, 'utf8');
    const options = [
      ...OBSERVERS.map(([observer]) => ({ observer })),
      { interpolation: 'sprague' },
      { unit: 'absolute' },
    ];
    for (const option of options) {
      const [[key, value]] = Object.entries(option);
      same(each(text, option)[0], host.measured([`--${key}`, value, '-'], text)[0]);
    }
  });

  test(`${name}: wavelengths that f32 cannot hold are read as the command line reads them`, () => {
    const rows = Array.from({ length: 900 }, (_, k) => [
      350.0761 + k * 0.5371,
      Math.exp(-(((k - 380) / 60) ** 2)) + 0.01,
    ]);
    const text = rows.map((row) => row.join(',')).join('\n');
    same(each(text)[0], host.measured(['-'], text)[0]);
    const regular = rows
      .map(([, value], k) => [350.1 + 0.6 * k, value])
      .map((row) => row.join(','))
      .join('\n');
    same(
      each(regular, { interpolation: 'sprague' })[0],
      host.measured(['--interpolation', 'sprague', '-'], regular)[0],
    );
  });

  test(`${name}: samples at every spacing are brought to 1 nm by the command line's rule`, () => {
    const [rules, kinds] = [new Set(), [[{}, []], [{ unit: 'absolute' }, ['--unit', 'absolute']], [{ reflectance: true }, ['--reflectance']]]];
    for (const step of [0.05, 0.25, 0.3333, 0.99, 0.9991, 1, 2.5, 4.99, 4.9991, 5, 7.1, 10, 20, 20.01, 35]) {
      // The steps are equal, one is missing, or one sample is a little off its place.
      for (const how of ['equal', 'missing', 'off']) {
        const rows = Array.from({ length: Math.ceil(240 / step) }, (_, k) => {
          const nm = 351.3 + step * (k + (how === 'off' && k === 5 ? 0.002 : 0));
          return `${nm},${0.4 + 0.3 * Math.sin(nm / 9)},${Math.abs(nm - 546.07) < 0.2 + step / 2 ? 0.97 : 0.02}`;
        });
        if (how === 'missing') rows.splice(5, 1);
        const text = `nm,wave,line\n${rows.join('\n')}\n`;
        for (const [option, args] of kinds) {
          const expected = host.measured([...args, '-'], text);
          each(text, option).forEach((reading, k) => same(reading, expected[k]));
          rules.add(expected[0].interpolation);
        }
      }
    }
    assert.deepEqual([...rules], ['means', 'linear', 'sprague']);
    const few = '400,1\n420,2\n440,3\n460,2\n480,1\n';
    same(each(few)[0], host.measured(['-'], few)[0]);
    // Steps that are fine beside the visible do not count.
    const beside = `${Array.from({ length: 40 }, (_, k) => `${340 + 0.5 * k},${k}`).join('\n')}\n360,40\n400,9\n700,20\n`;
    const [linear] = host.measured(['-'], beside);
    assert.equal(linear.interpolation, 'linear');
    same(each(beside)[0], linear);
  });

  test(`${name}: so are surfaces under a lamp`, () => {
    const text =
      'nm,red,paper,percentish\n400,0.05,0.7,0\n500,0.06,0.85,0\n580,0.2,0.88,1.2\n620,0.7,0.9,0.4\n700,0.75,0.9,0\n';
    for (const light of ['D65', 'A', 'FL11', 'LED-B3']) {
      const expected = host.measured(['--reflectance', '--light', light, '-'], text);
      each(text, { reflectance: true, light }).forEach((reading, k) => same(reading, expected[k]));
      const smooth = 'nm,a\n400,0.1\n420,0.2\n440,0.3\n460,0.3\n480,0.5\n500,0.6\n';
      const [option, args] = [{ interpolation: 'sprague' }, ['--interpolation', 'sprague']];
      const [under] = host.measured(['--reflectance', '--light', light, ...args, '-'], smooth);
      same(each(smooth, { reflectance: true, light, ...option })[0], under);
    }
  });

  test(`${name}: dark, red and impossible lights get the command line's notes`, () => {
    const text =
      'nm,laser,coal,green,dip\n400,0,0,0,1\n500,0,0,0.001,-0.4\n550,0,0.0001,1,1\n600,0,0.01,0.001,1\n650,1,0.3,0,1\n651,0,0.31,0,0.2\n780,0,9,0,1\n';
    for (const [option, args] of [[{}, []], [{ unit: 'absolute' }, ['--unit', 'absolute']]]) {
      const expected = host.measured([...args, '-'], text);
      each(text, option).forEach((reading, k) => same(reading, expected[k]));
    }
    // No light is so pure, and none on the ground so strong.
    const noisy = 'nm,noisy\n440,-0.01\n460,-0.01\n480,-0.01\n500,0\n520,0\n540,1\n560,0\n700,0\n';
    assert.ok(host.measured(['-'], noisy)[0].notes.some((note) => note.startsWith('xy: ')), 'it is within the locus');
    same(each(noisy)[0], host.measured(['-'], noisy)[0]);
    // The power of all samples is below zero in one, and in the other two values have a mean but not a sum.
    for (const text of ['300,-9\n350,-9\n380,0\n550,1\n700,0\n', '359,0\n360,1.6e308\n360.4,1.6e308\n360.8,0\n']) {
      same(each(text, { unit: 'absolute' })[0], host.measured(['--unit', 'absolute', '-'], text)[0]);
    }
    const strong = 'nm,strong\n400,9\n800,9\n';
    const [bright] = host.measured(['--unit', 'absolute', '-'], strong);
    assert.ok(bright.notes.some((note) => note.includes('brighter than the sun')));
    same(each(strong, { unit: 'absolute' })[0], bright);
  });

  test(`${name}: scenes are those of the command line`, () => {
    const compare = (title, recipe, expected) => {
      const answer = loaded.get(simd).scene.scene(recipe).answer({ budget: 2 });
      for (const known of Object.keys(answer).filter((known) => known in expected && !['bill', 'notes'].includes(known))) {
        assert.deepEqual(answer[known], expected[known], `${title}: ${known}`);
      }
      answer.bill.forEach(({ without_hex, ...line }, k) =>
        assert.deepEqual(line, expected.bill[k], `${title}: ${line.name}`),
      );
    };
    for (const [key, recipe] of Object.entries(scenes()))
      compare(key, recipe, host.json('scene', ['--budget', '2', key])[0]);
    const folder = mkdtempSync(join(tmpdir(), 'nanospectra-scenes-'));
    for (const [k, text] of RECIPES.entries()) {
      const recipe = toml(text),
        file = join(folder, `${k}.toml`);
      writeFileSync(file, text);
      compare(recipe.title, recipe, host.json('scene', ['--budget', '2', file])[0]);
    }
    rmSync(folder, { recursive: true });
  });

  test(`${name}: switching every effect off one by one is what the bill says`, () => {
    const scene = loaded.get(simd).scene.scene(scenes().vest),
      { bill } = scene.answer();
    bill.forEach((line, k) => {
      const { shown, hex } = scene.answer({ off: [k] });
      assert.equal(shown.delta_e2000, line.without_delta_e2000);
      assert.equal(hex, line.without_hex);
    });
  });

  test(`${name}: paints are those of the command line`, () => {
    const colors = [
      [0.8, 0.2, 0.1],
      [0, 0, 1],
      [1, 1, 1],
      [0.5, 0.5, 0.5],
      [0.02, 0.3, 0.9],
      [1.2, 0.1, -0.1],
    ];
    for (const method of ['sigmoid', 'basis', 'smits']) {
      const expected = host.json(
        'paint',
        ['--method', method, '--light', 'A,FL11', '-'],
        colors.map((rgb) => rgb.join(',')).join('\n'),
      );
      colors.forEach((rgb, k) => {
        const answer = loaded.get(simd).paint.upsample(rgb, { method, lights: ['A', 'FL11'] });
        for (const key of ['status', 'spectrum', 'roundtrip_rgb', 'delta_e2000', 'lights']) {
          assert.deepEqual(answer[key], expected[k][key], `${method} ${rgb}: ${key}`);
        }
      });
    }
  });

  test(`${name}: the small module sees what the large one sees`, () => {
    const { core } = loaded.get(simd);
    for (const lamp of loaded.get(simd).light.lamps.values()) {
      const seen = core.spectrum(lamp),
        reading = loaded.get(simd).light.spectrum(lamp);
      for (const key of Object.keys(seen)) assert.deepEqual(seen[key], reading[key], `${lamp.name}: ${key}`);
    }
    const paper = loaded.get(simd).light.spectrum(
      [
        [400, 0.5],
        [700, 0.6],
      ],
      { reflectance: true, light: 'E' },
    );
    const white = loaded.get(simd).light.spectrum(
      [
        [400, 1],
        [700, 1],
      ],
      { reflectance: true, light: 'E' },
    );
    assert.deepEqual(core.lab(paper.XYZ, white.XYZ), paper.lab);
    // The small module has steps of 10 nm and the large one steps of 5 nm, so that the spectra differ a little.
    const [few, many] = [core.upsample([0.8, 0.2, 0.1]), loaded.get(simd).paint.upsample([0.8, 0.2, 0.1])];
    few.values.forEach((value, k) => assert.ok(Math.abs(value - many.spectrum[4 + 2 * k]) < 0.01));
    assert.throws(() => core.upsample([NaN, 0, 0]), /not finite/);
  });

  test(`${name}: a batch is what its lights are one by one`, () => {
    const spectra = loaded.get(simd).light,
      lamps = [...spectra.lamps.values()],
      batch = spectra.batch(lamps.length);
    const alone = lamps.map((lamp, k) => {
      const reading = spectra.spectrum(lamp);
      batch.lights.set(reading.curve, 471 * k);
      return reading;
    });
    batch.measure();
    alone.forEach((reading, k) => {
      const [x, y, z, ra, , ...r] = batch.results.slice(20 * k, 20 * k + 20);
      assert.ok(Math.abs((100 * x) / y - reading.XYZ[0]) < 1e-4 && Math.abs((100 * z) / y - reading.XYZ[2]) < 1e-4);
      if (reading.cri_ra === null) assert.ok(Number.isNaN(ra));
      else assert.deepEqual([ra, ...r], [reading.cri_ra, ...reading.cri_r].map(Math.fround));
    });
  });
}

test('goldens: XYZ, CCT, Duv, Ra, R1..R15, Rf and Rg of lamps, from definitions in f64', () => {
  const spectra = loaded.get(true).light,
    counts = {};
  const near = (a, b, most, what) => assert.ok(Math.abs(a - b) <= most, `${what}: ${a}, golden ${b}`);
  const rows = (name, pick) => {
    const [heading, ...rest] = golden(name);
    const found = rest
      .map((row) => Object.fromEntries(heading.map((key, k) => [key, row[k]])))
      .filter((row) => spectra.lamps.has(row.id) && pick(row));
    counts[name] = found.length;
    return found.map((row) => [row, (options) => spectra.spectrum(spectra.lamps.get(row.id), options)]);
  };
  for (const [row, by] of rows(
    '01_xyz_sources',
    (row) => row.observer === '1931_2' && row.method === 'linear_zero',
  )) {
    ['X', 'Y', 'Z'].forEach((key, k) => near(by({ interpolation: 'linear' }).XYZ[k], Number(row[key]), 4e-7 * Number(row[key]), row.id));
  }
  // The other expected values come from 5 nm tables that are read by Sprague's rule.
  for (const [row, by] of rows('02_cct_sources', () => true)) {
    const { cct_k, duv } = by({ interpolation: 'sprague' });
    near(1e6 / cct_k, 1e6 / Number(row.T_exact), 0.009, `${row.id}, mired`);
    near(duv, Number(row.Duv_exact), 2e-7, `${row.id}, Duv`);
  }
  for (const [row, by] of rows('03_cri', (row) => row.mode === '1nm')) {
    const { cri_ra, cri_r } = by({ interpolation: 'sprague' });
    near(cri_ra, Number(row.Ra), 3e-4, `${row.id}, Ra`);
    cri_r.forEach((r, k) => near(r, Number(row[`R${k + 1}`]), 1.3e-3, `${row.id}, R${k + 1}`));
  }
  for (const [row, by] of rows('03_tm30', (row) => row.mode === '1nm' && Number(row.min_hue_bin_edge_deg) > 0.01)) {
    const { tm30_rf, tm30_rg } = by({ interpolation: 'sprague' });
    near(tm30_rf, Number(row.Rf), 1.4e-4, `${row.id}, Rf`);
    near(tm30_rg, Number(row.Rg), 1.4e-4, `${row.id}, Rg`);
  }
  for (const [name, count] of Object.entries(counts)) assert.ok(count >= 20, `${name}: ${count} goldens`);
});

test('what is no spectrum is refused in the words of the command line', () => {
  const bad = [
    '',
    '# only\n',
    'dear reader\nthis is a letter\n',
    'nm,a\n',
    'nm,a\n500,1\n',
    '500\n510\n',
    'nm,a,b\n500,1,2\n505,1\n',
    '500 1\n505 1 2\n',
    'nm,a,\n500,1\n505,2\n',
    'wave length,a\nW,nm\n500,1\n505,2\n',
    '500,1\n505,\n',
    'nm,a,b\n500,1,2\n505,,3\n',
    '500,1,\n505,2,\n',
    '500\t1\t\n505\t2\t\n',
    '500,1\n505,abc\n',
    '500,1\n505,NaN\n',
    '500,1\n505,-inf\n',
    '500,1\n505,1e999\n',
    '500;1,5\n505;2,5\n',
    '500,1\n510,1\n505,2\n',
    '# a\n\n500,1\n505,2\n505,3\n',
    '500.000001,1\n500.000002,2\n501,1\n',
    '-500,1\n505,2\n',
    '0,1\n505,2\n',
    '5OO,1\n505,2\n510,3\n',
    'S00,1\n505,2\n510,3\n',
    '0.38,1\n0.78,2\n',
    '3800,1\n7800,2\n',
    '900,1\n1000,2\n',
    'nm,a,b\n400,1,0\n500,1,0\n',
    '400,-1\n500,-2\n',
    '300,1\n360,0\n',
    'nm,"a\n500,1\n505,2\n',
    'nm,lamp "a"\n500,1\n505,2\n',
    '500,1\r505,2\r',
    '500,1\n505,what-has-more-than-forty-letters-is-no-number\n',
    '4e-7,1\n7e-7,1\n',
    `nm,${'x'.repeat(41)}\n500,0\n505,0\n`,
    'nm,a\n440,-0.05\n480,-0.05\n500,0\n520,0\n540,1\n560,0\n700,0\n',
  ];
  for (const text of bad) {
    const said = refusal([], text);
    assert.throws(
      () => parse(text, 'stdin').forEach((source) => loaded.get(true).light.spectrum(source)),
      { message: said },
      text,
    );
  }
  const between = '500.2,1\n500.6,1\n';
  assert.throws(() => loaded.get(true).light.spectrum(parse(between, 'stdin')[0], { interpolation: 'linear' }), {
    message: refusal(['--interpolation', 'linear'], between),
  });
  const irregular = '400,1\n410,1\n420,1\n431,1\n440,1\n450,1\n460,1\n';
  for (const text of [irregular, '400,1\n500,1\n']) {
    const said = refusal(['--interpolation', 'sprague'], text);
    const [source] = parse(text, 'stdin');
    assert.throws(() => loaded.get(true).light.spectrum(source, { interpolation: 'sprague' }), { message: said });
  }
  for (const percent of ['400,50\n700,60\n', '400,0.5\n500,60\n', '400,1.1\n700,1.2\n']) {
    const [source] = parse(percent, 'stdin');
    assert.throws(() => loaded.get(true).light.spectrum(source, { reflectance: true }), {
      message: refusal(['--reflectance'], percent),
    });
  }
});

test('headings, separators, comments and quotes are read as the command line reads them', () => {
  const texts = [
    'nm;a;b\n400;1;2\n700;3;4\n',
    '# c\n\n400\t1\n700\t2\n',
    '  400   1  2\n700 3 4\n',
    '"nm","a, b","c ""d"""\n400,1,2\n700,3,4\r\n',
    '\uFEFFnm,a\n400,1e0\n700,.5\n',
    'lambda a b\n400 1. +2\n700 3 4\n',
  ];
  for (const text of texts) {
    const expected = host.measured(['-'], text);
    parse(text, 'stdin').forEach((source, k) => same(loaded.get(true).light.spectrum(source), expected[k]));
  }
});

test('averages over bands are read as the command line reads them', () => {
  const text = 'band-nm,a,b\n400,0.1,0.9\n420,0.3,0.2\n450,0.5,0.1\n600,0.2,0.7\n';
  for (const [options, args] of [[{}, []], [{ unit: 'absolute' }, ['--unit', 'absolute']], [{ reflectance: true }, ['--reflectance']]]) {
    const expected = host.measured([...args, '-'], text);
    parse(text, 'stdin').forEach((source, k) => same(loaded.get(true).light.spectrum(source, options), expected[k]));
  }
});

test('a painted spectrum gives its color back when it is measured', () => {
  const { light, paint } = loaded.get(true);
  const { spectrum, lights } = paint.upsample([0.8, 0.2, 0.1]);
  const table = ['band-nm,paint', ...spectrum.map((value, k) => `${380 + 5 * k},${value}`)].join('\n');
  const { XYZ } = light.spectrum(parse(table)[0], { reflectance: true });
  XYZ.forEach((value, k) => assert.ok(Math.abs(value / lights[0].XYZ[k] - 1) < 1e-5, `${XYZ} is not ${lights[0].XYZ}`));
});

test('numbers of every size are those of the command line', () => {
  for (const size of ['1e-310', '5e-324', '1e-45', '3.4e38', '1e39', '1e300', '-1e30']) {
    const text = `nm,a\n380,${size}\n780,${size}\n`;
    for (const [options, args] of [[{ unit: 'absolute' }, ['--unit', 'absolute']], [{ reflectance: true }, ['--reflectance']]]) {
      const done = host.run('measure', ['--json', '--strict', ...args, '-'], text);
      const measured = () => loaded.get(true).light.spectrum(parse(text, 'stdin')[0], options);
      if (done.status === 0) same(measured(), host.reports(done.stdout)[0]);
      else assert.throws(measured, /stdin:2: 'a'/);
    }
  }
});

test('a lamp that is no white is said to be none', () => {
  const { scene } = loaded.get(true);
  const answer = scene.scene({ lamp: { points: [[690, 0], [700, 1], [710, 0]] }, part: [{ filter: { flat: 0.5 } }] }).answer();
  // The eye of CIE 1931 has no Z there, and what the folded one has is rounding.
  if (answer.lab === null) assert.ok(answer.notes.some((note) => /^lab\b.* no white/.test(note)), answer.notes.join());
  else assert.ok(answer.lab.every(Number.isFinite));
  const text = JSON.stringify(answer);
  for (const [key] of text.matchAll(/"\w+":null/g)) {
    const name = key.slice(1, -6);
    const keys = answer.notes.flatMap((note) => note.split(': ')[0].split(', '));
    assert.ok(keys.some((key) => key.split('.').at(-1) === name), `${name} has no note`);
  }
});

test('plots of every size have finite places and numbers that differ', () => {
  setEye(new Float32Array(3 * 471).fill(1));
  for (const size of [5e-324, 1e-310, 1e-45, 1, 99999, 3.4e38, Number.MAX_VALUE, 0, -1e30, -Number.MAX_VALUE]) {
    const { inside } = spectrum([[380, size], [600, size / 2], [780, 0]], 'power');
    assert.doesNotMatch(inside, /NaN|Infinity|undefined/);
    const numbers = [...inside.matchAll(/text-anchor="end">([^<]*)<\/text>/g)].map(([, text]) => text);
    assert.ok(numbers.length < 30 && new Set(numbers).size === numbers.length, `${size}: ${numbers}`);
  }
  // The lines of an axis are at multiples of their step, also where a curve begins a little below zero.
  const { inside } = spectrum([[380, 19], [400, -0.01], [780, 0]], 'power');
  assert.deepEqual([...inside.matchAll(/text-anchor="end">(-?\d+)<\/text>/g)].map(([, text]) => text), ['0', '5', '10', '15', '20']);
});

test('a name in a table is no formula', () => {
  for (const start of ['=', '+', '-', '@', '\t', '\r']) assert.equal(cell(`${start}1+2`), `"'${start}1+2"`);
  assert.equal(cell('a "b", c'), '"a ""b"", c"');
});

test('samples that are no spectrum are an Error with the words of the crate', () => {
  const { light, paint, scene } = loaded.get(true);
  const cases = [
    [[], /fewer than 2 samples/],
    [[[500, 1]], /fewer than 2/],
    [
      [
        [400, 1],
        [500, NaN],
      ],
      /sample 1 is not a finite number/,
    ],
    [
      [
        [400, 1],
        [400, 2],
      ],
      /the wavelength of sample 1 is not above/,
    ],
    [
      [
        [400, 1],
        [NaN, 2],
      ],
      /sample 1 is not a finite/,
    ],
    [undefined, /fewer than 2 samples/],
  ];
  for (const [samples, words] of cases) assert.throws(() => light.spectrum(samples), words);
  assert.throws(() => paint.upsample([NaN, 0, 0]), /not finite/);
  assert.throws(
    () => scene.scene({ lamp: { cie: 'A' }, part: [{ filter: { flat: 1.5 } }] }),
    /flat = 1.5 is not a share of the light; give 0..1/,
  );
  assert.throws(
    () => scene.scene({ lamp: { cie: 'moon' }, part: [{ filter: { flat: 0.5 } }] }).answer(),
    /is no CIE illuminant/,
  );
  assert.throws(() => light.lab([1, NaN, 1], [95, 100, 108]), /not finite/);
  assert.throws(() => paint.upsample([0, 0, 0], { beyond: 'x' }), /beyond is x; use one of nearest, desaturate/);
  assert.throws(() => light.batch(513), /give a whole number up to 512/);
});

test('what an export would take for something else is refused before it is called', async () => {
  const { light, paint, core } = loaded.get(true);
  for (const rgb of [[0.8, 0.2], [0.8, 0.2, 0.1, 1], '#cc331a', null]) {
    assert.throws(() => paint.upsample(rgb), /rgb has \d numbers; give 3/);
    assert.throws(() => core.upsample(rgb), /rgb has \d numbers; give 3/);
  }
  assert.throws(() => light.lab([1, 2, 3, 4], [95, 100, 108]), /xyz has 4 numbers/);
  const samples = [
    [400, 1],
    [700, 1],
  ];
  assert.throws(() => light.spectrum(samples, { interpolation: 'cubic' }), /no interpolation cubic/);
  assert.throws(() => light.spectrum(samples, { unit: 'watts' }), /no unit watts/);
  assert.throws(() => light.spectrum('D65'), /sample 0 is not a finite number/);
  for (const kelvin of [NaN, 0, 499, undefined]) assert.throws(() => light.blackBody(kelvin), /is out of range/);
  for (const count of [1.5, null, -1]) assert.throws(() => light.batch(count), /give a whole number up to 512/);
  const alone = await load({ module: 'paint', tables: light.tables });
  alone.lamps = light.lamps;
  assert.deepEqual(alone.upsample([0.8, 0.2, 0.1]), paint.upsample([0.8, 0.2, 0.1]));
  alone.lamps = null;
  assert.throws(() => alone.upsample([0.8, 0.2, 0.1]), /there are no lamps yet/);
});

test('a scene that is refused leaves the others as they were', () => {
  const module = loaded.get(true).scene,
    vest = module.scene(scenes().vest),
    before = vest.answer();
  const [dye] = scenes().vest.part;
  assert.throws(() => module.scene({ lamp: { cie: 'A' }, part: [{ filter: { flat: 0.9 } }, dye, { filter: { flat: 9 } }] }));
  assert.deepEqual(vest.answer(), before);
  const part = (part) => () => module.scene({ lamp: { cie: 'A' }, part: [part] });
  assert.throws(part({ filter: { flat: 0.5, path: 2 } }), /unknown field `path`/);
  assert.throws(part({ mirror: { n: 1.5 } }), /missing field `angle_deg`/);
  assert.throws(part({ dye: {} }), /missing field `reflectance`/);
  assert.throws(part({ filter: null }), /is given in exactly one way|missing/);
  for (const off of [1, 32, -1, 0.5, NaN, '0']) assert.throws(() => vest.answer({ off: [off] }), /off: there is no part/);
});

test('bands of an instrument are seen as by the crate, in both builds', () => {
  const [plain, simd] = BUILDS.map(([, simd]) => loaded.get(simd).bands);
  const vest = loaded.get(true).scene.scene(scenes().vest).answer();
  [vest.lamp_spectrum, vest.leaving_spectrum].forEach((values, k) =>
    [plain, simd].forEach(({ spectra }) => spectra.set(values, 81 * k)),
  );
  for (const build of [plain, simd]) build.measure(2);
  assert.deepEqual(plain.xyz.slice(0, 6), simd.xyz.slice(0, 6));
  const [, white, , x, y, z] = simd.xyz;
  // The scene uses the same folded observer, scaled so that the lamp has Y = 100.
  [x, y, z].forEach((value, k) => assert.ok(Math.abs((100 * value) / white - vest.XYZ[k]) < 2e-5));
});

test("the page's folds are the crate's, for every number of bands, range and scheme", async () => {
  const { closely } = await import('../page/fold.js');
  const { exports: crate } = (
    await WebAssembly.instantiate(readFileSync(new URL('../dist/cost.wasm', import.meta.url)))
  ).instance;
  const spectra = loaded.get(true).light,
    under = closely(spectra);
  for (const lamp of ['A', 'FL11', 'LED-B3']) {
    spectra.named(lamp, 'lamp');
    new Float32Array(crate.memory.buffer, crate.curve(), 471).set(spectra.curve);
    crate.look_closely();
    const coarsely = under(spectra.curve.slice());
    for (const bands of [8, 12, 16, 20, 24, 31, 36, 40, 60, 81])
      for (const [k, range] of [
        [380, 730],
        [400, 700],
        [360, 830],
      ].entries())
        for (const scheme of [0, 1, 2, 3]) {
          crate.look_coarsely(bands, k, scheme);
          const truth = new Float32Array(crate.memory.buffer, crate.out(), 99);
          coarsely(bands, range, scheme).forEach((error, sample) =>
            assert.ok(
              Math.abs(error - truth[sample]) < 1e-3,
              `${lamp}, ${bands} bands, ${range}, scheme ${scheme}, sample ${sample}: ${error}, ${truth[sample]}`,
            ),
          );
        }
  }
});

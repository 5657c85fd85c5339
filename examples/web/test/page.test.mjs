// Tests the page in a headless Chromium: it shows the results of the program `nanospectra`, and has no errors.
import assert from 'node:assert/strict';
import { existsSync, mkdirSync, mkdtempSync, readFileSync, rmSync, writeFileSync } from 'node:fs';
import { tmpdir } from 'node:os';
import { join } from 'node:path';
import test, { after, before } from 'node:test';
import { fileURLToPath } from 'node:url';
import { brotliCompressSync } from 'node:zlib';
import { serve } from '../serve.mjs';
import { allowed } from './allowed.mjs';
import { chromium } from './browser.mjs';
import * as host from './host.mjs';

const folder = fileURLToPath(new URL('../dist/page', import.meta.url));
const pictures = fileURLToPath(new URL('../dist/pictures', import.meta.url));
const bundled = fileURLToPath(new URL('../../cli/data/l41_white_led.csv', import.meta.url));
/** The keys of all numbers that the page shows; what is behind a point is a key of each of several things. */
const KEYS =
  'irradiance_w_m2 lux cct_k duv cri_ra cri_r9 tm30_rf tm30_rg ler_lm_per_w XYZ xy uv1960 uv1976 lab delta_e2000_to_white hex ' +
  'dominant_wavelength_nm purity ppfd epar photons photon_shares r_fr peak_nm centroid_nm fwhm_nm melanopic_edi_ratio ' +
  'alpha_opic.der alpha_opic.edi_lx alpha_opic.irradiance_w_m2 interpolation';

let browser, page, server, root, scratch;

before(async () => {
  host.build();
  server = await serve(folder);
  root = `http://localhost:${server.address().port}/`;
  browser = await chromium();
  page = await browser.page();
  await page.size(1280, 900);
  scratch = mkdtempSync(join(tmpdir(), 'nanospectra-page-'));
  mkdirSync(pictures, { recursive: true });
});

after(async () => {
  await browser?.close();
  server?.close();
  if (scratch) rmSync(scratch, { recursive: true, force: true });
});

const shown = () =>
  page.value(
    "Object.fromEntries([...document.querySelectorAll('#numbers [data-key]')].map((b) => [b.dataset.key, b.textContent]))",
  );
/** Returns the text by which the page shows a number of the program, or undefined if there is none. */
function text(report, key) {
  const [first, second] = key.split('.'),
    value = report[first] ?? undefined;
  if (typeof value !== 'object' || Array.isArray(value)) return value && [value].flat().join(', ');
  const parts = Object.values(value).map((part) => (second ? part[second] : part));
  return parts.some((part) => part === undefined || part === null) ? undefined : parts.join(', ');
}

/** Checks that every number on the page is that of the program. */
async function same(expected) {
  const numbers = await shown();
  for (const key of KEYS.split(' ')) assert.equal(numbers[key], text(expected, key), key);
  const others = Object.keys(numbers).filter((key) => !KEYS.split(' ').includes(key));
  assert.deepEqual(others, []);
}

/** Drops a file on the page, as a reader drags one there. */
const drop = (name, content) =>
  page.value(`(() => {
  const data = new DataTransfer();
  data.items.add(new File([${JSON.stringify(content)}], ${JSON.stringify(name)}));
  for (const type of ['dragover', 'drop']) document.querySelector('#drop').dispatchEvent(new DragEvent(type, { bubbles: true, cancelable: true, dataTransfer: data }));
})()`);

/** @param {string} name @param {(t: import('node:test').TestContext) => Promise<void>} work */
const check = (name, work) =>
  test(name, async (t) => {
    page.errors.length = 0;
    await work(t);
    assert.deepEqual(page.errors, [], 'errors in the console');
  });

check('a file that is opened shows the numbers of nanospectra measure --json', async () => {
  await page.open(root);
  await page.choose('#file', [bundled]);
  await page.until("document.querySelector('#numbers [data-key=cct_k]')?.textContent.startsWith('4102.8')");
  const [expected] = host.measured([bundled]);
  await same(expected);
  assert.doesNotMatch(await page.value("document.querySelector('.notes').textContent"), /--/, 'an option of the command line');
  // The bars have the colors of the samples, of which R9 is a strong red, R11 a green and R12 a blue.
  const bars = await page.value("[...document.querySelectorAll('#plot-cri rect[fill^=rgb]')].map((bar) => bar.getAttribute('fill'))");
  const largest = (k) => ((rgb) => rgb.indexOf(Math.max(...rgb)))(bars[k - 1].match(/\d+/g).map(Number));
  assert.deepEqual([9, 11, 12].map(largest), [0, 1, 2], `${bars}`);
});

check('so does one that is dropped, with several spectra, by every setting', async () => {
  await page.open(root);
  const content = 'nm,first,second\n380,0.1,0.5\n450,1.25,0.6\n555,0.3,0.7\n620,0.9,0.8\n780,0.05,0.9\n';
  await drop('two.csv', content);
  await page.until("!document.querySelector('#column').parentElement.hidden");
  const [first, second] = host.measured(['-'], content);
  await same(first);
  await page.select('#column', '1');
  await same(second);
  await page.select('#observer', '1964');
  await same(host.measured(['--observer', '1964', '-'], content)[1]);
  await page.select('#observer', '1931');
  await page.select('#unit', 'absolute');
  const [, absolute] = host.measured(['--unit', 'absolute', '-'], content);
  await same(absolute);
  // What a reading of the unit has comes first, as in the report of the program.
  assert.deepEqual(Object.keys(await shown()).slice(0, 3), ['irradiance_w_m2', 'lux', 'cct_k']);
  const [power, light] = await page.value("[...document.querySelectorAll('#big div')].map((one) => one.innerText.replace(/\\s+/g, ' '))");
  assert.equal(power, `Irradiance ${Number(absolute.irradiance_w_m2.toPrecision(4))} W/m²`);
  assert.equal(light, `Illuminance ${Number(absolute.lux.toPrecision(4))} lx`);
  await page.select('#unit', 'relative');
  await page.select('#kind', 'surface');
  await page.select('#column', '1');
  await page.select('#under', 'FL11');
  const [, surface] = host.measured(['--reflectance', '--light', 'FL11', '-'],
    content.replace('1.25', '0.25'),
  );
  await same(surface);
});

check('what is wrong with a file is said in the words of the command line', async () => {
  await page.open(root);
  for (const content of ['nm,a\n500,1\n490,2\n', '500,1\n505,NaN\n', '', 'nm,a\n500,\n']) {
    const { stderr } = host.run('measure', ['--strict', '-'], content);
    await drop('stdin', content);
    await page.until(`document.querySelector('#failure').textContent === ${JSON.stringify(stderr.trim())}`);
  }
  await page.select('#lamp', 'A');
  await page.until("document.querySelector('#failure').textContent === ''");
});

check('a bundled lamp, a pasted text and a link give the same', async () => {
  await page.open(`${root}#lamp=FL11`);
  assert.match((await shown()).cct_k, /^3998\.5/);
  await page.select('#interpolation', 'linear');
  assert.match((await shown()).cct_k, /^4000\.7/);
  await page.open(root);
  await page.value(
    "document.querySelector('#paste').value = 'nm;a\\n400;1\\n700;2\\n'; document.querySelector('#measure').click()",
  );
  await page.until("document.querySelector('#failure').textContent === '' && location.hash.includes('data')");
  const pasted = await shown(),
    link = await page.value('location.href');
  await same(host.measured(['-'], 'nm;a\n400;1\n700;2\n')[0]);
  await page.open(link);
  assert.deepEqual(await shown(), pasted);
});

check('a file that cannot be measured leaves the page and its link as they were', async () => {
  await page.open(`${root}#lamp=FL11`);
  const before = await shown();
  await drop('dark.csv', '400,0\n700,0\n');
  await page.until("document.querySelector('#failure').textContent.includes('every value is zero')");
  assert.deepEqual(await shown(), before);
  assert.equal(await page.value("location.hash + document.querySelector('#lamp').value"), '#lamp=FL11FL11');
});

check('names with separators go through the link, and choosing a spectrum keeps the focus', async () => {
  await page.open(root);
  await drop('two.csv', 'nm,"a, b","c;d_e"\n400,1,2\n700,2,1\n');
  await page.until("!document.querySelector('#column').parentElement.hidden");
  await page.value("document.querySelector('#column').focus()");
  await page.select('#column', '1');
  assert.equal(await page.value('document.activeElement.id'), 'column');
  const second = await shown();
  await page.open(await page.value('location.href'));
  assert.deepEqual(await shown(), second);
});

check('a text is pasted wherever the focus is', async () => {
  await page.open(root);
  await page.value(`(() => {
    const data = new DataTransfer();
    data.setData('text', '400,1\\n700,2\\n');
    document.body.dispatchEvent(new ClipboardEvent('paste', { bubbles: true, clipboardData: data }));
  })()`);
  await page.until("location.hash.includes('data=')");
});

check('a link that says what cannot be is a page that works', async () => {
  const links = {
    'observer=moon': '#numbers tr',
    'kind=surface': '#numbers tr',
    'lamp=moon&column=-1&kind=surface&under=moon': '#numbers tr',
    'drawn=1,2,x': '#numbers tr',
    'constructor=1&__proto__=2': '#numbers tr',
    'tab=paint&paintlamp=moon&method=moon&rgb=zzz': '[data-delta]',
    'tab=scene&scene=constructor&off=abc&budget=abc&scenelamp=moon': '#bill tr',
    'tab=scene&off=99&budget=-5': '#bill tr',
    'tab=cost&costlamp=moon&range=length&scheme=x&bands=17': '#cost dd',
    'tab=cost&costlamp=constructor&range=constructor': '#cost dd',
  };
  for (const [link, shown] of Object.entries(links)) {
    await page.open(`${root}#${link}`);
    assert.ok(await page.value(`document.querySelector('${shown}')`).then((found) => found !== null), link);
    assert.deepEqual(
      await page.value("[...document.querySelectorAll('section:not([hidden]) select')].filter((s) => s.selectedIndex < 0 && s.offsetParent).map((s) => s.id)"),
      [],
      link,
    );
  }
  await page.open(`${root}#tab=scene&off=99`);
  assert.match(await page.value("document.querySelector('#verdict').textContent"), /^Following the light through all parts takes \d+ multiply-adds/);
  assert.equal((await fetch(`${root}%`)).status, 404);
});

check('who skips to the instrument keeps it', async () => {
  await page.open(`${root}#lamp=FL11`);
  await page.value("(window.same = true, document.querySelector('.skip').click())");
  await page.until("document.activeElement.id === 'main'");
  assert.equal(await page.value('location.hash + window.same'), '#lamp=FL11true');
});

check('a spectrum is drawn by pointer and by keyboard, and the link carries it', async () => {
  await page.open(root);
  await page.click('#draw');
  await page.until("document.querySelector('#plot-spectrum').getAttribute('role') === 'slider'");
  const before = await shown();
  await page.drag('#plot-spectrum', [
    [0.15, 0.8],
    [0.3, 0.3],
    [0.5, 0.75],
    [0.9, 0.4],
  ]);
  const drawn = await shown();
  assert.notEqual(drawn.cct_k ?? drawn.xy, before.cct_k ?? before.xy);
  await page.value("document.querySelector('#plot-spectrum').focus()");
  const said = () => page.value("document.querySelector('#plot-spectrum').getAttribute('aria-valuetext')");
  const first = await said();
  await page.press('ArrowLeft', 3);
  await page.press('ArrowUp', 5);
  assert.notEqual(await said(), first);
  const final = await shown();
  assert.notEqual(final.xy, drawn.xy);
  const values = (await page.value("new URLSearchParams(location.hash.slice(1)).get('drawn')")).split(',');
  const content = values.map((value, k) => `${380 + 10 * k},${value / 100}`).join('\n');
  await same(host.measured(['-'], content)[0]);
});

check('paint shows three methods, their round trips and lamps', async () => {
  await page.open(`${root}#tab=paint&rgb=%230000ff`);
  const rows = () =>
    page.value("[...document.querySelectorAll('[data-delta]')].map((cell) => Number(cell.textContent))");
  const [sigmoid, basis, smits] = await rows();
  assert.ok(sigmoid < 0.001 && basis < 0.001 && smits > 0.1, `${[sigmoid, basis, smits]}`);
  await page.value(
    "(() => { const c = document.querySelector('#color'); c.value = '#20a040'; c.dispatchEvent(new Event('input')); })()",
  );
  assert.match(await page.value('location.hash'), /20a040/);
  await page.value("document.querySelector('input[value=smits]').click()");
  assert.match(await page.value("document.querySelector('#paint-status').textContent"), /^smits: the spectrum comes near/);
});

check('switching an effect off costs what the bill of the command line says', async () => {
  await page.open(`${root}#tab=scene&scene=vest`);
  const [{ bill, XYZ }] = host.json('scene', ['vest']);
  assert.equal(
    await page.value(
      "document.querySelector('#scene table:last-of-type td')?.textContent && [...document.querySelectorAll('#scene th')].find((th) => th.textContent === 'X, Y, Z').nextSibling.textContent",
    ),
    XYZ.join(', '),
  );
  await page.click('#part-0');
  assert.match(
    await page.value("document.querySelector('#verdict').textContent"),
    new RegExp(`^Leaving this out costs ${bill[0].without_delta_e2000.toFixed(2)} CIEDE2000`),
  );
  assert.match(await page.value('location.hash'), /off=0/);
  for (const name of ['asphalt', 'paper', 'soap', 'window', 'wine']) {
    await page.select('#scene-name', name);
    const [expected] = host.json('scene', [name]);
    const cells = await page.value(
      "[...document.querySelectorAll('#bill tr')].map((row) => row.cells[1].textContent)",
    );
    assert.deepEqual(
      cells,
      expected.bill.map((line) => line.without_delta_e2000.toFixed(2)),
      name,
    );
  }
});

check('more bands cost less color and more instructions, and the fold costs least', async () => {
  await page.open(`${root}#tab=cost`);
  const mean = () => page.value("Number(document.querySelector('#cost dd').textContent)");
  const counted = () =>
    page.value("[...document.querySelectorAll('#cost tbody td')].map((cell) => Number(cell.textContent.replace(',', '')))");
  const bands = (k) =>
    page.value(
      `(() => { const s = document.querySelector('#bands'); s.value = ${k}; s.dispatchEvent(new Event('input')); })()`,
    );
  const record = readFileSync(new URL('../../../tests/data/instructions.txt', import.meta.url), 'utf8');
  const recorded = (what) =>
    Number(new RegExp(`^thumbv7em-none-eabihf release ${what} (\\d+) instructions$`, 'm').exec(record)[1]);
  const at16 = await mean();
  assert.ok(at16 > 0.01 && at16 < 0.1, `${at16}`);
  assert.ok((await counted()).includes(recorded('xyz-16')));
  await bands(9);
  assert.ok((await mean()) < 0.01);
  assert.ok((await counted()).includes(recorded('xyz-81')));
  await bands(2);
  assert.equal(await mean(), at16);
  await page.value("document.querySelectorAll('input[name=scheme]')[3].click()");
  assert.ok((await mean()) > 3 * at16);
  assert.ok((await counted()).includes(recorded('path-surface-16')));
  await page.select('#cost-lamp', 'hid');
  assert.ok((await mean()) > 10 * at16);
});

check('tabs and theme work by keyboard', async () => {
  await page.open(root);
  await page.value("document.querySelector('#tab-light').focus()");
  await page.press('ArrowRight', 2);
  await page.until("document.querySelector('#scene').hidden === false && document.querySelector('#bill tr')");
  assert.equal(await page.value('document.activeElement.id'), 'tab-scene');
  const theme = () => page.value('document.documentElement.dataset.theme');
  const was = await theme();
  await page.value("document.querySelector('#theme').click()");
  assert.notEqual(await theme(), was);
  // The theme belongs to the reader: it stays after a reload, and the link does not carry it.
  await page.open(`${root}?again`);
  assert.notEqual(await theme(), was);
  assert.doesNotMatch(await page.value('location.hash'), /theme/);
  await page.value("document.querySelector('#theme').click()");
  assert.equal(await theme(), was);
});

check('whatever can be used has a name, every plot a text, and no identifier is there twice', async () => {
  for (const tab of ['light', 'paint', 'scene', 'cost']) {
    await page.open(`${root}#tab=${tab}`);
    const faults = await page.value(`(() => {
      const faults = [];
      const named = (e) => e.getAttribute('aria-label') || e.getAttribute('aria-labelledby') || e.labels?.length || e.textContent.trim() || e.title;
      for (const e of document.querySelectorAll('main button, main select, main input:not([hidden]), main textarea')) if (!named(e)) faults.push(e.outerHTML.slice(0, 80));
      for (const svg of document.querySelectorAll('main section:not([hidden]) figure:not([hidden]) svg')) if ((svg.querySelector('desc')?.textContent ?? '').length < 10) faults.push(svg.id);
      const ids = [...document.querySelectorAll('[id]')].map((e) => e.id);
      return [...faults, ...ids.filter((id, k) => ids.indexOf(id) !== k)];
    })()`);
    assert.deepEqual(faults, [], tab);
  }
});

check('a screen reader finds a name for every control', async () => {
  const CONTROLS = ['button', 'combobox', 'textbox', 'slider', 'switch', 'radio', 'spinbutton', 'tab', 'image', 'link'];
  for (const tab of ['light', 'paint', 'scene', 'cost']) {
    await page.open(`${root}#tab=${tab}`);
    const { nodes } = await page.send('Accessibility.getFullAXTree');
    const controls = nodes.filter(({ ignored, role }) => !ignored && CONTROLS.includes(role?.value));
    assert.ok(controls.length > 10, tab);
    assert.deepEqual(controls.filter(({ name }) => !name?.value).map(({ role }) => role.value), [], tab);
  }
});

check('plots and data can be saved', async () => {
  await page.open(root);
  await page.send('Page.setDownloadBehavior', { behavior: 'allow', downloadPath: scratch });
  for (const label of [
    'Save Spectrum as SVG',
    'Save Chromaticity, CIE 1931 as PNG',
    'Save TM-30 color vectors as SVG',
  ]) {
    await page.value(`document.querySelector('[aria-label="${label}"]').click()`);
  }
  await page.value("document.querySelector('#spectrum-csv').click(); document.querySelector('#spectrum-json').click()");
  const wait = async (name) => {
    for (let k = 0; k < 100; k++) {
      try {
        const bytes = readFileSync(join(scratch, name));
        if (bytes.length) return bytes;
      } catch {
        /* not yet */
      }
      await new Promise((resolve) => {
        setTimeout(resolve, 50);
      });
    }
    throw new Error(`${name} was not saved`);
  };
  assert.match(String(await wait('spectrum.svg')), /^<svg .*<style>/);
  assert.match(String(await wait('tm30.svg')), /^<svg /);
  assert.equal((await wait('chromaticity-1931.png')).subarray(1, 4).toString(), 'PNG');
  const csv = String(await wait('spectrum.csv')),
    [expected] = host.measured(['-'], csv);
  assert.deepEqual(JSON.parse(await wait('spectrum.json')), { ...expected, file: 'LED-B3' });
  for (const tab of ['paint', 'scene', 'cost']) {
    await page.open(`${root}?save#tab=${tab}`);
    await page.value(`document.querySelector('#${tab}-csv').click(); document.querySelector('#${tab}-json').click()`);
    assert.ok(String(await wait(`${tab}.csv`)).trim().split('\n').length > 9, `${tab}.csv`);
    for (const line of String(await wait(`${tab}.json`)).trim().split('\n')) assert.ok(JSON.parse(line));
  }
});

check('to measure a spectrum a browser fetches less than 60 KB, compressed, and the bundled lamps', async (t) => {
  if (existsSync(join(folder, 'light.js'))) return t.skip('the page is not packed: npm ci brings what packs it');
  page.requests.length = 0;
  await page.open(`${root}?fresh`);
  const paths = [...new Set(page.requests)]
    .filter((url) => url.startsWith(root))
    .map((url) => new URL(url).pathname.replace(/^\/$/, '/index.html'));
  const size = (path) => brotliCompressSync(readFileSync(join(folder, path))).length;
  const total = paths.filter((path) => !path.endsWith('lamps.json')).reduce((sum, path) => sum + size(path), 0);
  assert.ok(paths.some((path) => path.includes('light.simd.wasm')), `${paths}`);
  assert.ok(!paths.some((path) => /paint|scene|cost/.test(path)), `${paths}`);
  allowed('first-tab.br', total);
});

check('without a network there is still all of the page', async () => {
  await page.open(root);
  await page.until("navigator.serviceWorker.controller && navigator.serviceWorker.controller.state === 'activated'");
  server.closeAllConnections();
  await new Promise((done) => server.close(done));
  try {
    for (const tab of ['light', 'paint', 'scene', 'cost']) {
      await page.open(`${root}?${tab}#tab=${tab}`);
      assert.ok(await page.value(`document.querySelectorAll('#${tab} .card').length > 2`), tab);
      assert.equal(await page.value("document.querySelector('.failure:not(:empty)')"), null, tab);
    }
  } finally {
    server = await serve(folder, Number(new URL(root).port));
  }
  // The requests that failed here were meant to fail.
  page.errors.length = 0;
});

check('nothing is asked of any other place, and it fits a phone', async () => {
  page.requests.length = 0;
  for (const [width, height, mobile] of [
    [390, 844, true],
    [1280, 900, false],
  ]) {
    await page.size(width, height, mobile);
    for (const tab of ['light', 'paint', 'scene', 'cost']) {
      await page.open(`${root}#tab=${tab}`);
      assert.ok(
        await page.value('document.documentElement.scrollWidth <= document.documentElement.clientWidth'),
        `${tab} is wider than ${width}`,
      );
      writeFileSync(join(pictures, `${tab}-${width}.png`), await page.screenshot(true));
    }
  }
  const elsewhere = page.requests.filter((url) => !url.startsWith(root) && !/^(data|blob|about):/.test(url));
  assert.deepEqual(elsewhere, []);
});

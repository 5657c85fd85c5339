// The frame of the page: the tabs, the theme, the link that carries the state, and the start of the four instruments.
import { setEye } from './color.js';
import { copy, h, say } from './dom.js';
import { begin, remember, spectra, state } from './session.js';

/** The instruments by the names of their tabs; each is fetched when its tab is opened. */
const instruments = {
  light: () => import('./light.js'),
  paint: () => import('./paint.js'),
  scene: () => import('./scene.js'),
  cost: () => import('./cost.js'),
};
const TABS = Object.keys(instruments);

const built = new Set();
async function show(chosen, focus = false) {
  for (const name of TABS) {
    const button = document.getElementById(`tab-${name}`),
      is = name === chosen;
    button.setAttribute('aria-selected', is);
    button.tabIndex = is ? 0 : -1;
    if (is && focus) button.focus();
    document.getElementById(name).hidden = !is;
  }
  document.title = `nanospectra: ${document.getElementById(`tab-${chosen}`).textContent}`;
  remember({ tab: chosen });
  if (built.has(chosen)) return;
  built.add(chosen);
  const section = document.getElementById(chosen);
  try {
    const { build } = await instruments[chosen]();
    section.replaceChildren();
    await build(section);
  } catch (error) {
    // The files may be available when the tab is opened again.
    built.delete(chosen);
    failed(section, error);
  }
}

/** Says on the page why an instrument is missing. @param {HTMLElement} where */
function failed(where, error) {
  where.prepend(h('p', { class: 'failure', role: 'alert' }, `The instrument could not be started: ${error.message}`));
  say('The instrument could not be started.');
  throw error;
}

for (const name of TABS) document.getElementById(`tab-${name}`).addEventListener('click', () => show(name));
document.querySelector('[role=tablist]').addEventListener('keydown', (event) => {
  const at = TABS.indexOf(state.tab),
    to = { ArrowRight: at + 1, ArrowLeft: at + 3, Home: 0, End: 3 }[event.key];
  if (to !== undefined) {
    event.preventDefault();
    show(TABS[to % 4], true);
  }
});

const theme = document.getElementById('theme'),
  dark = matchMedia('(prefers-color-scheme: dark)');
function applyTheme() {
  const chosen = localStorage.getItem('theme') ?? (dark.matches ? 'dark' : 'light');
  document.documentElement.dataset.theme = chosen;
  theme.setAttribute('aria-pressed', chosen === 'dark');
}
theme.addEventListener('click', () => {
  const next = document.documentElement.dataset.theme === 'dark' ? 'light' : 'dark';
  if (next === (dark.matches ? 'dark' : 'light')) localStorage.removeItem('theme');
  else localStorage.setItem('theme', next);
  applyTheme();
});
dark.addEventListener('change', applyTheme);
applyTheme();
// A link that is pasted into the address bar can change the state of every tab, so the page starts again.
addEventListener('hashchange', () => location.reload());
document.querySelector('.skip').addEventListener('click', (event) => {
  event.preventDefault();
  document.getElementById('main').focus();
});
// Without this, the browser would leave the page and open a file that is dropped beside the colorimeter.
for (const name of ['dragover', 'drop']) addEventListener(name, (event) => event.preventDefault());
document.getElementById('link').addEventListener('click', () => {
  const whole = state.lamp || state.data || state.drawn;
  copy(location.href, whole ? 'Link' : 'Link without the spectrum, which is too long for one,');
});

try {
  await begin();
  setEye(spectra.published.eye);
  document.getElementById('build').textContent = spectra.simd
    ? 'Vector instructions (simd128) are in use.'
    : 'Vector instructions (simd128) are not available.';
} catch (error) {
  failed(document.getElementById('main'), error);
}
await show(state.tab);
document.documentElement.dataset.ready = 'yes';
// The worker fetches what is left, so that the page works without a network.
navigator.serviceWorker?.register(`worker.js?${spectra?.simd ? 'simd' : ''}`).catch(() => {});

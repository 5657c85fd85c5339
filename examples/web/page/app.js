// The page: tabs, theme, the link that carries the state, and the four instruments.
import { setEye } from './color.js';
import { copy, h, say } from './dom.js';
import { begin, remember, spectra, state } from './session.js';

/** Each is fetched when its tab is opened. */
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
    // It may be there the next time.
    built.delete(chosen);
    failed(section, error);
  }
}

/** Says why a part of the page is not there. @param {HTMLElement} where */
function failed(where, error) {
  where.prepend(h('p', { class: 'failure', role: 'alert' }, `The instrument did not start: ${error.message}`));
  say('The instrument did not start');
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
// A link that is pasted into this page is another state of everything.
addEventListener('hashchange', () => location.reload());
document.querySelector('.skip').addEventListener('click', (event) => {
  event.preventDefault();
  document.getElementById('main').focus();
});
// A file beside the colorimeter is not one to leave the page for.
for (const name of ['dragover', 'drop']) addEventListener(name, (event) => event.preventDefault());
document.getElementById('link').addEventListener('click', () => {
  const whole = state.lamp || state.data || state.drawn;
  copy(location.href, whole ? 'Link' : 'Link without the spectrum, which is too long for one,');
});

try {
  await begin();
  setEye(spectra.published.eye);
  document.getElementById('build').textContent = spectra.simd
    ? 'Running with simd128.'
    : 'Running without simd128.';
} catch (error) {
  failed(document.getElementById('main'), error);
}
await show(state.tab);
document.documentElement.dataset.ready = 'yes';
// Then the rest, for when there is no network.
navigator.serviceWorker?.register(`worker.js?${spectra?.simd ? 'simd' : ''}`).catch(() => {});

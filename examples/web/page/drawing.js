// A spectrum that the reader draws by pointer or keyboard.

/** The wavelengths of a drawn spectrum, every 10 nm. */
export const DRAWN = Array.from({ length: 41 }, (_, k) => 380 + 10 * k);
const START = DRAWN.map((nm) => Math.round(100 * (0.35 + 0.6 * Math.exp(-(((nm - 560) / 70) ** 2)))) / 100);

/** The drawn values, which are 0..1, and the index at which the cursor stands. */
export const hand = { values: START.slice(), cursor: 18 };

/** Returns the drawing as a spectrum. */
export const drawnSource = () => ({
  file: 'drawn',
  name: 'drawn',
  lines: DRAWN.map((_, k) => k + 1),
  samples: DRAWN.map((nm, k) => [nm, hand.values[k]]),
});

/** Presents a plot to screen readers as a slider while one can draw on it. @param {SVGElement} svg @param {boolean} live */
export function asSlider(svg, live) {
  const { values, cursor } = hand;
  const attributes = {
    role: live ? 'slider' : 'img',
    tabindex: 0,
    'aria-valuemin': 0,
    'aria-valuemax': 100,
    'aria-valuenow': Math.round(100 * values[cursor]),
    'aria-valuetext': `${DRAWN[cursor]} nm, ${values[cursor].toFixed(2)}`,
  };
  for (const [key, value] of Object.entries(attributes)) {
    if (live || key === 'role') svg.setAttribute(key, value);
    else svg.removeAttribute(key);
  }
  svg.classList.toggle('drawing', live);
}

/**
 * Lets the reader draw by keyboard and by pointer, from the pointer's last place to its present one.
 * @param {SVGElement & {scale: {x: Function, y: Function}}} svg @param {() => boolean} isOn @param {() => void} redraw
 */
export function drawing(svg, isOn, redraw) {
  let last = null;
  const put = (event) => {
    const box = svg.getBoundingClientRect(),
      { x, y } = svg.scale;
    const left = ((event.clientX - box.left) / box.width) * svg.viewBox.baseVal.width,
      height = ((event.clientY - box.top) / box.height) * 300;
    const k = Math.min(Math.max(Math.round(((left - x(380)) / (x(780) - x(380))) * 40), 0), 40);
    const value = Math.min(Math.max((y(0) - height) / (y(0) - y(1)), 0), 1);
    const [from, to] = last
      ? [last, [k, value]].sort((a, b) => a[0] - b[0])
      : [
          [k, value],
          [k, value],
        ];
    for (let j = from[0]; j <= to[0]; j++) {
      const t = to[0] === from[0] ? 1 : (j - from[0]) / (to[0] - from[0]);
      set(j, from[0] === to[0] ? value : from[1] + t * (to[1] - from[1]));
    }
    last = [k, value];
    hand.cursor = k;
    redraw();
  };
  svg.addEventListener('pointerdown', (event) => {
    if (!isOn() || event.button !== 0 || !event.isPrimary) return;
    svg.setPointerCapture(event.pointerId);
    event.preventDefault();
    svg.focus();
    last = null;
    put(event);
  });
  svg.addEventListener('pointermove', (event) => {
    if (isOn() && last && event.buttons && event.isPrimary) put(event);
  });
  for (const end of ['pointerup', 'pointercancel'])
    svg.addEventListener(end, (event) => {
      if (event.isPrimary) last = null;
    });
  svg.addEventListener('keydown', (event) => {
    if (!isOn()) return;
    const by = event.shiftKey ? 0.1 : 0.02;
    const move = { ArrowLeft: -1, ArrowRight: 1, PageUp: 5, PageDown: -5 }[event.key],
      lift = { ArrowUp: by, ArrowDown: -by }[event.key];
    if (move) hand.cursor = Math.min(Math.max(hand.cursor + move, 0), 40);
    else if (lift) set(hand.cursor, hand.values[hand.cursor] + lift);
    else if (event.key === 'Home') hand.cursor = 0;
    else if (event.key === 'End') hand.cursor = 40;
    else return;
    event.preventDefault();
    redraw();
  });
}

const set = (k, value) => {
  hand.values[k] = Math.round(100 * Math.min(Math.max(value, 0), 1)) / 100;
};

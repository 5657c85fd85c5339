// Uses the package from TypeScript. The tests compile this file and never run it.
import { load, type Reading, type SceneAnswer, type Upsampled } from '../dist/nanospectra/nanospectra.js';
import { parse } from '../dist/nanospectra/csv.js';

const light = await load();
await light.loadLamps();
const [source] = parse('nm,lamp\n380,0.1\n780,0.2\n', 'lamp.csv');
const reading: Reading = light.spectrum(source!, { observer: '2015-10', unit: 'absolute' });
const kelvin: number | null = reading.cct_k;
const lux: number | null | undefined = reading.alpha_opic?.melanopic.edi_lx;
const blue: number | null | undefined = reading.photons?.blue;
const batch = light.batch(318);
batch.lights.set(reading.curve);
batch.measure();

const paint = await load({ module: 'paint', tables: light.tables });
paint.lamps = light.lamps;
const red: Upsampled = paint.upsample([0.8, 0.2, 0.1], { lights: ['A', light.blackBody(3000)] });

const scenes = await load({ module: 'scene', simd: false });
const answer: SceneAnswer = scenes
  .scene({ lamp: { blackbody_k: 2856 }, part: [{ filter: { flat: 0.5 } }] })
  .answer({ off: [0], budget: 1 });

const core = await load({ module: 'core' });
const hex: string | null = core.spectrum([[400, 1], [700, 1]]).hex;

// @ts-expect-error the module core has no scenes
core.scene({});
// @ts-expect-error there is no such observer
light.spectrum(source!, { observer: '1932' });
// @ts-expect-error there is no such module
await load({ module: 'full' });

export { answer, blue, hex, kelvin, lux, red };

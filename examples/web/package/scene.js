// The module `scene`, which follows light through filters, surfaces and other parts. The recipes and the messages are
// those of examples/cli/src/scene.
import { Instrument } from './instrument.js';
import { explained, hex, plain, single, singles } from './numbers.js';

const f = Math.fround;
const RADIANS = f(f(Math.PI) / 180);
const EYES = ['CIE 1931', 'CIE 1964'];
const FACTORS = { must: [], may: ['flat', 'points', 'absorbance_per_cm', 'path_cm'] };
/** The fields that describe each kind of part. */
const FIELDS = {
  filter: FACTORS,
  surface: FACTORS,
  dye: { must: ['reflectance', 'absorption', 'emission', 'quantum_yield'], may: ['transmitted'] },
  film: { must: ['n', 'thickness_nm'], may: ['angle_deg', 'n_before', 'n_behind', 'transmitted'] },
  mirror: { must: ['n', 'angle_deg'], may: ['k', 'axis_deg'] },
  polarizer: { must: ['axis_deg'], may: ['along', 'across'] },
  retarder: { must: ['path_difference_nm', 'axis_deg'], may: [] },
};
const KINDS = Object.keys(FIELDS);
const LAMP = { must: [], may: ['cie', 'blackbody_k', 'points', 'illuminance_lx'] };
const DYES = [
  'has a value that is negative or not finite',
  '',
  'the quantum yield is not in 0..=1',
  'the emission is zero everywhere',
  'leaves with more energy than it came with',
  'the dye emits more photons than it absorbs',
];

const within = (x, low, high) => x >= low && x <= high;

/** Refuses a recipe that lacks a field, or that has an unknown one, which is probably misspelled. */
function checkFields(written, { must, may }) {
  const lacking = must.find((field) => written?.[field] === undefined);
  if (lacking) throw new Error(`missing field \`${lacking}\``);
  const fields = [...must, ...may],
    unknown = Object.keys(written ?? {}).find((field) => !fields.includes(field));
  if (unknown) throw new Error(`unknown field \`${unknown}\`, expected one of ${fields.join(', ')}`);
}

/** The functions of the module `scene`. */
export class Scenes extends Instrument {
  /** Makes a scene of a lamp and the parts that its light meets. @param {import('./nanospectra.d.ts').SceneRecipe} recipe */
  scene(recipe) {
    return new Scene(this, recipe);
  }
}

/** A scene, which is in the module's memory until another one is built there. */
export class Scene {
  /** @param {Scenes} spectra @param {import('./nanospectra.d.ts').SceneRecipe} recipe */
  constructor(spectra, recipe) {
    this.spectra = spectra;
    this.recipe = recipe;
    this.eye = EYES.indexOf(recipe.eye ?? 'CIE 1931');
    if (this.eye < 0) throw new Error('there is no eye of this name; use "CIE 1931" or "CIE 1964"');
    if (!recipe.part?.length) throw new Error('this is a scene without a part');
    if (recipe.part.length > 16) throw new Error('the scene has more than 16 parts; combine several filters into one');
    this.build();
  }

  build() {
    const { spectra, recipe } = this;
    // If a part is refused, the memory holds no complete scene.
    spectra.currentScene = null;
    spectra.wasm.clear();
    this.parts = recipe.part.map((part) => {
      const kinds = KINDS.filter((kind) => part[kind] !== undefined);
      if (kinds.length !== 1) {
        throw new Error(`a part is of exactly one kind; give one of ${KINDS.join(', ')}`);
      }
      const [kind] = kinds,
        written = part[kind];
      checkFields(written, FIELDS[kind]);
      const effect = this[kind](written);
      return {
        name: part.name ?? kind,
        kind,
        effect,
        matt: kind === 'surface' || (kind === 'dye' && !written.transmitted),
      };
    });
    this.checkFilms();
    spectra.currentScene = this;
  }

  /** Refuses a film at an angle beside a part that depends on the direction of polarization. */
  checkFilms() {
    let films = 0,
      directed = 0;
    for (const [k, { kind, matt }] of [...this.parts.entries(), [-1, { kind: 'dye' }]]) {
      if (matt || kind === 'dye') {
        films = directed = 0;
        continue;
      }
      const oblique = kind === 'film' && (this.recipe.part[k].film.angle_deg ?? 0) > 0;
      films += oblique;
      directed += oblique || ['mirror', 'polarizer', 'retarder'].includes(kind);
      if (films && directed > 1) {
        throw new Error(
          'a film at an angle polarizes light, and this program does not follow that next to a mirror, polarizer, ' +
            'retarder or another such film; give angle_deg = 0, or put a surface between them',
        );
      }
    }
  }

  /** Throws if an export that adds a part has failed. @param {number} status its result */
  check(status, advice = '; give [[nm, value], ..] with increasing wavelengths') {
    if (status === 0) return;
    if (status >= 65536) {
      const [bin, to] = this.spectra.out,
        kind = status - 65536;
      const said = [
        `bin ${bin} ${DYES[0]}`,
        `light of bin ${bin} leaves at the shorter waves of bin ${to}`,
        DYES[2],
        DYES[3],
        `light of bin ${bin} ${DYES[4]}`,
        DYES[5],
      ][kind];
      throw new Error(`${said}; correct the dye's numbers`);
    }
    const index = status >> 3;
    throw new Error(
      [
        '',
        `fewer than ${index} samples`,
        `sample ${index} is not a finite number`,
        `the wavelength of sample ${index} is not above the one before it`,
        '',
        'not a spectrum',
        'an absorbance is negative or not finite',
        'more than 16 parts',
      ][status & 7] + advice,
    );
  }

  shares(points, at = 0) {
    const bad = points.find(([, value]) => !within(value, 0, 1));
    if (bad) throw new Error(`${plain(bad[1])} at ${plain(bad[0])} nm is not a share of the light; give 0..1, not percent`);
    return this.spectra.write(points, at);
  }

  factors(written, matt) {
    const { spectra } = this,
      { flat, points, absorbance_per_cm: absorbance, path_cm: cm } = written ?? {};
    if ([flat, points, absorbance].filter((given) => given !== undefined).length !== 1) {
      throw new Error('a filter or a surface is given in exactly one way; give one of flat, points, absorbance_per_cm');
    }
    if (absorbance) {
      if (cm === undefined) throw new Error('the absorbance needs the length of the path; give path_cm');
      if (!within(cm, 0, 1e5)) throw new Error(`path_cm = ${plain(cm)} is out of range; give 0..100000`);
      this.check(
        spectra.wasm.absorber(spectra.write(absorbance), f(f(0.01) * f(cm)), matt),
        '; give absorbances of 0 or more',
      );
      return matt ? 'reflection' : 'Beer-Lambert';
    }
    if (cm !== undefined) throw new Error('path_cm belongs to absorbance_per_cm, which is not given; leave it out');
    if (flat !== undefined && !within(flat, 0, 1)) throw new Error(`flat = ${plain(flat)} is not a share of the light; give 0..1`);
    this.check(
      spectra.wasm.factors(
        this.shares(
          points ?? [
            [380, flat],
            [780, flat],
          ],
        ),
        matt,
      ),
    );
    return matt ? 'reflection' : 'absorption';
  }

  filter(written) {
    return this.factors(written, 0);
  }

  surface(written) {
    return this.factors(written, 1);
  }

  dye({ reflectance, absorption, emission, quantum_yield: quantum }) {
    const { spectra } = this;
    const first = this.shares(reflectance),
      second = this.shares(absorption, first);
    const third = spectra.write(emission, first + second);
    this.check(spectra.wasm.dye(first, second, third, quantum));
    return 'fluorescence';
  }

  cos(deg = 0) {
    if (!within(deg, 0, 90)) throw new Error(`angle_deg = ${plain(deg)} is not an angle of incidence; give 0..90`);
    return f(Math.cos(f(f(deg) * RADIANS)));
  }

  turns(deg = 0) {
    if (!within(deg, -360, 360)) throw new Error(`axis_deg = ${plain(deg)} is out of range; give -360..360`);
    return f(f(deg) / 360);
  }

  film({ n, n_before: before = 1, n_behind: behind = 1, thickness_nm: nm, angle_deg: deg, transmitted = false }) {
    if (![before, n, behind].every((n) => within(n, 0.01, 100))) {
      throw new Error('an index of refraction is out of range; give 0.01..100');
    }
    if (!within(nm, 0, 1e9)) throw new Error(`thickness_nm = ${plain(nm)} is out of range; give 0..1000000000`);
    this.check(this.spectra.wasm.film(before, n, behind, nm, this.cos(deg), +transmitted));
    return 'interference';
  }

  mirror({ n, k = 0, angle_deg: angle, axis_deg: axis }) {
    if (!(within(n, 0.01, 100) && within(k, 0, 100))) {
      throw new Error('the index of refraction is out of range; give n = 0.01..100, k = 0..100');
    }
    this.check(this.spectra.wasm.mirror(n, k, this.cos(angle), this.turns(axis)));
    return 'polarization';
  }

  polarizer({ axis_deg: axis, along = 1, across = 0 }) {
    if (![along, across].every((share) => within(share, 0, 1)))
      throw new Error('along and across are shares of the light; give 0..1');
    this.check(this.spectra.wasm.polarizer(along, across, this.turns(axis)));
    return 'polarization';
  }

  retarder({ path_difference_nm: nm, axis_deg: axis }) {
    if (!within(nm, 0, 1e5)) throw new Error(`path_difference_nm = ${plain(nm)} is out of range; give 0..100000`);
    this.check(this.spectra.wasm.retarder(nm, this.turns(axis)));
    return 'polarization';
  }

  /** Reads the lamp into `curve`. @returns {string} its name */
  lamp() {
    const { spectra } = this,
      { cie, blackbody_k: kelvin, points } = this.recipe.lamp ?? {};
    checkFields(this.recipe.lamp, LAMP);
    if ([cie, kelvin, points].filter((given) => given !== undefined).length !== 1) {
      throw new Error('a lamp is given in exactly one way; give one of cie, blackbody_k, points');
    }
    if (cie !== undefined) return spectra.named(cie, 'lamp').name;
    if (kelvin !== undefined) {
      if (!within(kelvin, 500, 1e6))
        throw new Error(`blackbody_k = ${plain(kelvin)} is out of range; give 500 to 1000000 K`);
      spectra.wasm.black_body(kelvin);
      return `black body of ${plain(kelvin)} K`;
    }
    const dark = points.find(([, value]) => value < 0);
    if (dark) throw new Error(`${plain(dark[1])} at ${plain(dark[0])} nm is not a power; give 0 or more`);
    this.check(spectra.wasm.interpolate(spectra.write(points), 0), '; give increasing wavelengths in nm');
    return 'points';
  }

  /**
   * Computes the color, the spectra and the price of each part. `off` lists the numbers (from 0) of parts whose effects
   * are switched off. With a `budget`, effects are left out as long as the color changes by no more than that CIEDE2000.
   * @param {{off?: number[], budget?: number | null}} [options]
   */
  answer({ off = [], budget = null } = {}) {
    const { spectra, recipe } = this;
    if (spectra.currentScene !== this) this.build();
    const lamp = this.lamp(),
      level = recipe.lamp.illuminance_lx;
    if (level !== undefined && !within(level, 1e-6, 1e9)) {
      throw new Error(`illuminance_lx = ${plain(level)} is out of range; give 0.000001 to 1000000000 lux`);
    }
    if (budget !== null && !within(budget, 0, 1e6)) {
      throw new Error(`${plain(budget)} is not a color difference; give 0 or more (1 is just noticeable)`);
    }
    for (const k of off) {
      if (!(Number.isInteger(k) && k >= 0 && k < this.parts.length)) {
        throw new Error(`off: there is no part ${k}; give 0..${this.parts.length - 1}`);
      }
    }
    const mask = off.reduce((bits, k) => bits | (1 << k), 0);
    if (spectra.wasm.answer(this.eye, level ?? 0, mask, budget ?? -1)) {
      throw new Error('nothing is visible of this lamp; give it power in 360..830 nm');
    }
    const out = spectra.out.slice(),
      look = out.subarray(162, 178),
      line = (k) => out.subarray(196 + 6 * k, 202 + 6 * k);
    const matt =
      this.parts.findLast(({ kind }) => !['filter', 'polarizer', 'retarder'].includes(kind))?.matt ?? false;
    const [illuminance, irradiance, exitance, radiosity, luminance, radiance] = singles(out.subarray(182, 188));
    const left = out[195];
    const answer = {
      title: recipe.title,
      lamp,
      eye: EYES[this.eye],
      first_nm: 380,
      step_nm: 5,
      lamp_spectrum: singles(out.subarray(0, 81)),
      leaving_spectrum: singles(out.subarray(81, 162)),
      XYZ: singles(look.subarray(0, 3)),
      xy: Number.isNaN(look[3]) ? null : singles(look.subarray(3, 5)),
      lab: Number.isNaN(look[5]) ? null : singles(look.subarray(5, 8)),
      hex: hex(look.subarray(8, 11)),
      hex_is_clipped: look[11] === 1,
      lamp_hex: hex(look.subarray(12, 15)),
      luminous_factor_percent: single(look[1]),
      absolute:
        level === undefined
          ? null
          : {
              illuminance_lx: illuminance,
              irradiance_w_m2: irradiance,
              exitance_lm_m2: exitance,
              exitance_w_m2: radiosity,
              luminance_cd_m2: matt ? luminance : null,
              radiance_w_m2_sr: matt ? radiance : null,
            },
      bill: this.parts.map(({ name, kind, effect }, part) => ({
        part,
        name,
        kind,
        effect,
        multiply_adds: line(part)[0],
        bytes: line(part)[1],
        without_delta_e2000: single(line(part)[2]),
        without_hex: hex(line(part).subarray(3, 6)),
        left_out: budget !== null && ((left >> part) & 1) === 1,
      })),
      walked: { multiply_adds: out[178], bytes: out[179] },
      folded: { multiply_adds: out[180], bytes: out[181] },
      notes: [],
      shown: { off, delta_e2000: single(out[188]), multiply_adds: out[189] },
      budget:
        budget === null
          ? null
          : {
              delta_e2000: budget,
              left_out: this.parts.map((_, k) => k).filter((k) => (left >> k) & 1),
              cost_delta_e2000: single(out[190]),
              hex: hex(out.subarray(192, 195)),
              multiply_adds: out[191],
            },
    };
    const white = 'X, Y or Z of the lamp is not above zero, so the lamp is no white, to which colors can be adapted';
    const matter = 'the light leaves something that is not matt';
    return explained(answer, {
      xy: 'black has no chromaticity',
      lab: white,
      'bill.without_delta_e2000': white,
      'shown.delta_e2000': white,
      absolute: 'the lamp has no illuminance_lx',
      'absolute.luminance_cd_m2': matter,
      'absolute.radiance_w_m2_sr': matter,
      budget: 'no budget is given',
    });
  }
}

import type { Observer } from './lists.d.ts';

/** One spectrum of a file, as `parse` of nanospectra/csv returns it. */
export interface Source {
  file: string;
  name: string;
  /** The line of the file on which each sample stands, counted from 1. */
  lines: number[];
  /** At least two pairs of a wavelength in nm and a value; all are finite, and the wavelengths increase. */
  samples: [number, number][];
  /** Whether the values are averages over bands around the wavelengths, whose edges lie half way between these. */
  averages?: boolean;
}

/**
 * A spectrum of 2 to 4096 samples: values at increasing wavelengths in nm, at any spacing. If visible samples are nearer
 * than 1 nm, there may be more of them.
 */
export type Samples =
  Source | Iterable<readonly [number, number]> | { nm: ArrayLike<number>; values: ArrayLike<number> };

export type Triple = [number, number, number];
export type Pair = [number, number];

export interface SpectrumOptions {
  /** The name that messages use for the spectrum; 'samples' by default. */
  name?: string;
  /** Says that the samples are reflectances (0..1) of a surface instead of the power of a light. */
  reflectance?: boolean;
  /** The light on the surface, as the name of a CIE illuminant or as a spectrum; D65 by default. */
  light?: string | Samples;
  observer?: Observer;
  /**
   * The rule that brings the samples to 1 nm; `auto` by default, which takes Sprague's for six or more samples at equal
   * steps of 5 to 20 nm, means of straight lines over each nanometer if visible samples are nearer than 1 nm, and else
   * straight lines. Averages over bands are constant within each band by every rule.
   */
  interpolation?: 'auto' | 'linear' | 'sprague';
  /** The unit of the samples; `absolute` means W/m2/nm, and only then is it known how strong the light is. */
  unit?: 'relative' | 'absolute';
}

/** Photons of 400..500, 500..600, 600..700 and 700..800 nm, where both ends have half weight. */
export interface PhotonBands {
  blue: number | null;
  green: number | null;
  red: number | null;
  far_red: number | null;
}

/** What a receptor of the eye gets of a light, by CIE S 026. */
export interface Receptor {
  /** The daylight efficacy ratio. */
  der: number | null;
  /** The alpha-opic irradiance and the equivalent daylight illuminance of a light in W/m2/nm. */
  irradiance_w_m2?: number | null;
  edi_lx?: number | null;
}

export interface HueBin {
  /** The fidelity of the samples in this bin, 0..100. */
  rf: number;
  /** The shift of chroma, as a fraction of the chroma under the reference; `hue_shift` likewise. */
  chroma_shift: number;
  hue_shift: number;
  /** How many of the 99 samples fall into this bin. */
  count: number;
}

export interface Fidelity {
  rf: number;
  rg: number;
  /** The 16 hue bins, counterclockwise from a' > 0; a bin that holds no sample is null. */
  bins: (HueBin | null)[];
  rf_ces: number[];
}

/**
 * Every number about a spectrum, with the keys of `nanospectra measure --json`, except those about files. A number that is not defined is null,
 * and one of the notes says why.
 */
export interface Reading {
  name: string;
  file: string;
  /** Y is 100 for a relative light and for white under a light; for an absolute light Y is in lx. */
  XYZ: Triple;
  xy: Pair | null;
  uv1960: Pair | null;
  uv1976: Pair | null;
  cct_k: number | null;
  duv: number | null;
  lux: number | null;
  ler_lm_per_w: number | null;
  lab: Triple | null;
  /** The encoded sRGB components, clipped to 0..1. */
  srgb: Triple | null;
  hex: string | null;
  /** The dominant wavelength; a complementary wavelength is negative. */
  dominant_wavelength_nm: number | null;
  purity: number | null;
  cri_ra: number | null;
  cri_r: number[] | null;
  tm30_rf: number | null;
  tm30_rg: number | null;
  melanopic_edi_ratio: number | null;
  /** The photons of 400..700 nm in umol/m2/s. */
  ppfd: number | null;
  notes: string[];
  /** CIEDE2000 of a surface to a perfect white. */
  delta_e2000_to_white: number | null;
  observer: string;
  /** The rule that was taken: `means` are those of straight lines over each nanometer, `averages` those over bands. */
  interpolation: 'linear' | 'sprague' | 'means' | 'averages';
  unit: 'relative' | 'W/m2/nm' | 'reflectance';
  cri_r9: number | null;
  /** Whether the light is near enough to its reference that CIE 13.3 applies. */
  cri_is_valid: boolean | null;
  tm30_edition: string;
  /** For a surface, the name of the light on it. */
  light?: string;
  /** For a light in W/m2/nm, the power of all its samples, visible or not. */
  irradiance_w_m2?: number | null;
  /** The photons of 400..750 nm in umol/m2/s. */
  epar: number | null;
  /** The photons of each band in umol/m2/s. */
  photons: PhotonBands | null;
  /** The photons of each band over those of 400..700 nm. */
  photon_shares: PhotonBands | null;
  /** Red over far-red photons: those of 655..665 and 725..735 nm. */
  r_fr: number | null;
  alpha_opic: Record<'s_cone' | 'm_cone' | 'l_cone' | 'rhodopic' | 'melanopic', Receptor> | null;
  /** The wavelength of the highest sample, the mean wavelength weighed by power, and the width at half the peak. */
  peak_nm: number | null;
  centroid_nm: number | null;
  fwhm_nm: number | null;
  tm30?: Fidelity | null;
  /** For a light, the number by which `curve` is multiplied to get the samples. */
  scale?: number;
  /** The spectrum at 360, 361 .. 830 nm. */
  curve: Float32Array;
}

export interface UpsampleOptions {
  method?: 'sigmoid' | 'basis' | 'smits';
  /** What to do with a color that no smooth spectrum has: find the nearest, or desaturate it until one has it. */
  beyond?: 'nearest' | 'desaturate';
  /**
   * The lights to show the color under, as names of CIE illuminants or as spectra. D65 is always the first, so call
   * `loadLamps` before.
   */
  lights?: (string | Samples)[];
}

export interface Upsampled {
  rgb: Triple;
  method: string;
  status: 'exact' | 'unreachable' | 'desaturated' | 'unphysical' | 'approximate';
  first_nm: 380;
  step_nm: 5;
  spectrum: number[];
  roundtrip_rgb: Triple;
  delta_e2000: number;
  /** For a desaturated color, the share that is kept of the way from gray to the wanted color. */
  kept: number | null;
  lights: { name: string; XYZ: Triple; lab: Triple; hex: string }[];
  /** What the values of the spectrum are, which are no points of a curve. */
  values_are: 'averages over bands';
  /** Why values are null. */
  notes: string[];
}

/** A transmittance or a reflectance; give one of `flat`, `points` and `absorbance_per_cm` (with `path_cm`). */
export interface Factors {
  flat?: number;
  points?: Pair[];
  absorbance_per_cm?: Pair[];
  path_cm?: number;
}

/** A part that light meets; give exactly one of the kinds, and a name if you like. */
export interface PartRecipe {
  name?: string;
  filter?: Factors;
  surface?: Factors;
  dye?: { reflectance: Pair[]; absorption: Pair[]; emission: Pair[]; quantum_yield: number; transmitted?: boolean };
  film?: {
    n: number;
    thickness_nm: number;
    angle_deg?: number;
    n_before?: number;
    n_behind?: number;
    transmitted?: boolean;
  };
  mirror?: { n: number; k?: number; angle_deg: number; axis_deg?: number };
  polarizer?: { axis_deg: number; along?: number; across?: number };
  retarder?: { path_difference_nm: number; axis_deg: number };
}

export interface SceneRecipe {
  title?: string;
  /** The lamp, as one of `cie`, `blackbody_k` and `points`, and the illuminance that it gives. */
  lamp: { cie?: string; blackbody_k?: number; points?: Pair[]; illuminance_lx?: number };
  eye?: 'CIE 1931' | 'CIE 1964';
  /** The 1 to 16 parts, in the order in which light meets them. */
  part: PartRecipe[];
}

export interface SceneAnswer {
  title?: string;
  lamp: string;
  eye: string;
  first_nm: 380;
  step_nm: 5;
  lamp_spectrum: number[];
  leaving_spectrum: number[];
  XYZ: Triple;
  xy: Pair | null;
  /** Null, with a note, if the lamp is no white. */
  lab: Triple | null;
  hex: string;
  hex_is_clipped: boolean;
  lamp_hex: string;
  luminous_factor_percent: number;
  absolute: null | {
    illuminance_lx: number;
    irradiance_w_m2: number;
    exitance_lm_m2: number;
    exitance_w_m2: number;
    luminance_cd_m2: number | null;
    radiance_w_m2_sr: number | null;
  };
  bill: {
    part: number;
    name: string;
    kind: string;
    effect: string;
    multiply_adds: number;
    bytes: number;
    without_delta_e2000: number | null;
    without_hex: string;
    left_out: boolean;
  }[];
  walked: { multiply_adds: number; bytes: number };
  folded: { multiply_adds: number; bytes: number };
  /** Why numbers are null, where it is not plain. */
  notes: string[];
  /** The difference to the whole scene that switching parts off makes, and the price of the parts that are on. */
  shown: { off: number[]; delta_e2000: number | null; multiply_adds: number };
  budget: null | {
    delta_e2000: number;
    left_out: number[];
    cost_delta_e2000: number;
    hex: string;
    multiply_adds: number;
  };
}

export interface Scene {
  parts: { name: string; kind: string; effect: string; matt: boolean }[];
  /**
   * Computes the color, the spectra and the price of each part. `off` lists the numbers (from 0) of parts whose effect
   * is switched off. With a `budget`, effects are left out as long as the color changes by no more than that CIEDE2000.
   */
  answer(options?: { off?: number[]; budget?: number | null }): SceneAnswer;
}

export interface Batch {
  /** The 471 numbers of each light, for 360..830 nm. All batches of a module share the same memory. */
  lights: Float32Array;
  /**
   * The 20 results of each light: X, Y, Z (sums over 1 nm that are not scaled to Y = 100), Ra, the distance to the
   * reference in u, v, and R1..R15. Ra and what follows are NaN for a light that has no color rendering index.
   */
  results: Float32Array;
  /** Computes `results` from `lights`. */
  measure(): void;
}

/** What all modules have that measure spectra at 360..830 nm. Invalid input is thrown as an Error. */
export interface Instrument {
  /** Whether this is the build that uses the vector instructions of WebAssembly. */
  readonly simd: boolean;
  /** The CIE's tables that the module measures with, of which the first has x, y, z of CIE 1931 at 360..830 nm. */
  readonly tables: Float32Array[];
  /** The illuminants by name, once they are loaded. A second module can be given those of the first. */
  lamps: Map<string, Source> | null;
  /** Fetches the illuminants of the CIE, which names in options and scenes refer to. */
  loadLamps(base?: string | URL): Promise<Map<string, Source>>;
}

/** The module that computes every number about a light or a surface. */
export interface Light extends Instrument {
  /**
   * The CIE's tables that it measures with: `eye` has the rows x, y, z of CIE 1931 at 360..830 nm, `samples` the 99 rows
   * of CIE 224 at 380..780 nm, and `testColors` the 15 test colors of CRI and a white at each step of 5 nm from 350 nm.
   */
  readonly published: { eye: Float32Array; testColors: Float32Array; samples: Float32Array };
  /** Computes every number about a light, or about a surface if `reflectance` is set. */
  spectrum(samples: Samples, options?: SpectrumOptions): Reading;
  /** Returns the spectrum of a black body of 500 to 1000000 K, scaled to 1 at 560 nm. */
  blackBody(kelvin: number): [number, number][];
  /** Returns L*, a*, b* relative to a white, or null if that is not a white. */
  lab(xyz: Triple, white: Triple): Triple | null;
  /** Returns the memory for up to 512 lights that are measured together. */
  batch(count: number): Batch;
}

/** The module that finds spectra for RGB colors. It needs lamps, since the colors are defined under D65. */
export interface Paint extends Instrument {
  /** Finds a reflectance that has this encoded sRGB color (0..1), and its color under other lights. */
  upsample(rgb: Triple, options?: UpsampleOptions): Upsampled;
}

/** The module that follows light through the parts of a scene. */
export interface Scenes extends Instrument {
  /** Makes a scene. The module's memory holds one scene at a time, and an older one is built again when it is used. */
  scene(recipe: SceneRecipe): Scene;
}

/** The smallest module for single spectra. */
export interface Core extends Instrument {
  /** Computes XYZ, chromaticities, CCT, Duv and the display color of a light. */
  spectrum(
    samples: Samples,
    options?: { name?: string },
  ): Pick<Reading, 'XYZ' | 'xy' | 'uv1960' | 'uv1976' | 'cct_k' | 'duv' | 'hex'>;
  /** Returns L*, a*, b* relative to a white, or null if that is not a white. */
  lab(xyz: Triple, white: Triple): Triple | null;
  /** Returns a reflectance that has this encoded sRGB color (0..1), or null if no smooth one has it. */
  upsample(rgb: Triple): { first_nm: number; step_nm: number; values: number[] } | null;
}

/** The module that turns many spectra of a 5 nm instrument into X, Y, Z at once. */
export interface Bands {
  /** Whether this is the build that uses the vector instructions of WebAssembly. */
  readonly simd: boolean;
  /** Up to 1024 spectra of 81 numbers each, at 380, 385 .. 780 nm, in the module's memory. */
  spectra: Float32Array;
  /** X, Y, Z of each spectrum, as sums with the CIE 1931 functions prepared for these bands. */
  xyz: Float32Array;
  /** Computes `xyz` of the first `count` spectra. */
  measure(count: number): void;
}

/** The modules by name. Each is a WebAssembly file of its own, which is fetched when it is loaded. */
export interface Modules {
  light: Light;
  paint: Paint;
  scene: Scenes;
  core: Core;
  bands: Bands;
}

/**
 * Loads a module, `light` by default. `base` says where the package's files are, as an absolute URL that ends with a
 * slash. `simd` chooses the build that uses vector instructions; by default it is taken wherever it can run. `tables` are
 * those of a module that is loaded already: the modules `paint` and `core` then fetch none.
 */
export function load<M extends keyof Modules = 'light'>(options?: {
  module?: M;
  base?: string | URL;
  simd?: boolean;
  tables?: Float32Array[];
}): Promise<Modules[M]>;

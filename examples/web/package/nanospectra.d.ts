import type { Observer } from './lists.d.ts';

/** A column of a file, as `parse` of nanospectra/csv gives it. */
export interface Source {
  file: string;
  name: string;
  /** The line of each sample, counted from 1. */
  lines: number[];
  /** Wavelength in nm and value: finite, increasing, at least two. */
  samples: [number, number][];
}

/** Wavelengths in nm, increasing, at any spacing, and values; 2 to 4096 samples. */
export type Samples =
  Source | Iterable<readonly [number, number]> | { nm: ArrayLike<number>; values: ArrayLike<number> };

export type Triple = [number, number, number];
export type Pair = [number, number];

export interface SpectrumOptions {
  /** What messages call it. */
  name?: string;
  /** The samples are reflectances (0..1) of a surface, not a light. */
  reflectance?: boolean;
  /** What lights the surface: a CIE illuminant's name or a spectrum; D65. */
  light?: string | Samples;
  observer?: Observer;
  interpolation?: 'linear' | 'sprague';
  /** `absolute` is W/m2/nm, and brings lux and PPFD. */
  unit?: 'relative' | 'absolute';
}

export interface HueBin {
  /** Local fidelity, 0..100. */
  rf: number;
  /** Fractions of the reference's chroma. */
  chroma_shift: number;
  hue_shift: number;
  /** How many of the 99 samples. */
  count: number;
}

export interface Fidelity {
  rf: number;
  rg: number;
  /** Counterclockwise from a' > 0; null for one that holds no sample. */
  bins: (HueBin | null)[];
  rf_ces: number[];
}

/** Every number about a spectrum, as `nanospectra measure --json` has them; null where one is not defined, and a note says why. */
export interface Reading {
  name: string;
  file: string;
  /** Y = 100 for a relative light and for white under a light, lx for an absolute light. */
  XYZ: Triple;
  xy: Pair | null;
  uv1960: Pair | null;
  uv1976: Pair | null;
  cct_k: number | null;
  duv: number | null;
  lux: number | null;
  ler_lm_per_w: number | null;
  lab: Triple | null;
  /** Encoded, clipped to 0..1. */
  srgb: Triple | null;
  hex: string | null;
  /** Negative for a complementary wavelength. */
  dominant_wavelength_nm: number | null;
  purity: number | null;
  cri_ra: number | null;
  cri_r: number[] | null;
  tm30_rf: number | null;
  tm30_rg: number | null;
  melanopic_edi_ratio: number | null;
  ppfd: number | null;
  notes: string[];
  delta_e2000: number | null;
  observer: string;
  interpolation: string;
  unit: string;
  light?: string;
  tm30?: Fidelity | null;
  /** The samples are the curve times this (lights). */
  scale?: number;
  /** At 360, 361 .. 830 nm. */
  curve: Float32Array;
}

export interface UpsampleOptions {
  method?: 'sigmoid' | 'basis' | 'smits';
  /** What to do with a color that no smooth spectrum has. */
  beyond?: 'nearest' | 'desaturate';
  /** Names of CIE illuminants or spectra to look under; D65 is always the first, so the module needs its lamps. */
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
  /** Of the way from gray to a color that was desaturated. */
  kept: number | null;
  lights: { name: string; XYZ: Triple; lab: Triple; hex: string }[];
}

/** A transmittance or a reflectance, by one of the first three. */
export interface Factors {
  flat?: number;
  points?: Pair[];
  absorbance_per_cm?: Pair[];
  path_cm?: number;
}

/** One of the kinds. */
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
  /** One of the first three, and how much of it. */
  lamp: { cie?: string; blackbody_k?: number; points?: Pair[]; illuminance_lx?: number };
  eye?: 'CIE 1931' | 'CIE 1964';
  /** In the order in which light meets them; 1 to 16. */
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
  lab: Triple;
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
  /** Of the parts that are on, against the whole scene. */
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
  /** `off` numbers parts, from 0, without their effects; within `budget`, a CIEDE2000, effects are left out. */
  answer(options?: { off?: number[]; budget?: number | null }): SceneAnswer;
}

export interface Batch {
  /** 471 numbers a light, 360..830 nm, in the module's memory: every batch of a module is the same memory. */
  lights: Float32Array;
  /** 20 numbers a light: X, Y, Z (sums over 1 nm, not scaled to Y = 100), Ra, distance to the reference in u, v, R1..R15; NaN where there is no rendering. */
  results: Float32Array;
  measure(): void;
}

/** What every module that measures spectra at 360..830 nm has. Whatever is wrong with what is given is thrown as an Error. */
export interface Instrument {
  readonly simd: boolean;
  lamps: Map<string, Source> | null;
  /** Brings the CIE's lamps: names in options and scenes need them. Another module may be given the same. */
  loadLamps(base?: string | URL): Promise<Map<string, Source>>;
}

/** Every number about a light or a surface. */
export interface Light extends Instrument {
  /** x, y, z of CIE 1931 at 360..830 nm and the 99 samples of CIE 224 at 380..780 nm, row after row; test colors. */
  readonly published: { eye: Float32Array; testColors: Float32Array; samples: Float32Array };
  spectrum(samples: Samples, options?: SpectrumOptions): Reading;
  /** A black body of 500 to 1000000 K, 1 at 560 nm. */
  blackBody(kelvin: number): [number, number][];
  /** L*, a*, b* relative to a white; null if that is none. */
  lab(xyz: Triple, white: Triple): Triple | null;
  /** Room for up to 512 lights. */
  batch(count: number): Batch;
}

/** RGB colors to spectra. D65, under which they are the colors that they are, is one of the lamps. */
export interface Paint extends Instrument {
  upsample(rgb: Triple, options?: UpsampleOptions): Upsampled;
}

/** Light through what it meets. */
export interface Scenes extends Instrument {
  /** One scene at a time is in the module's memory; another one is brought back when it is asked. */
  scene(recipe: SceneRecipe): Scene;
}

/** The small module. */
export interface Core extends Instrument {
  /** A light. */
  spectrum(
    samples: Samples,
    options?: { name?: string },
  ): Pick<Reading, 'XYZ' | 'xy' | 'uv1960' | 'uv1976' | 'cct_k' | 'duv' | 'hex'>;
  /** L*, a*, b* relative to a white; null if that is none. */
  lab(xyz: Triple, white: Triple): Triple | null;
  /** The reflectance of an encoded sRGB color (0..1); null if no smooth one has it. */
  upsample(rgb: Triple): { first_nm: number; step_nm: number; values: number[] } | null;
}

/** Many spectra of a 5 nm instrument. */
export interface Bands {
  readonly simd: boolean;
  /** 81 numbers a spectrum, 380..780 nm, in the module's memory; 1024 have room. */
  spectra: Float32Array;
  /** X, Y, Z of each: sums with the CIE 1931 functions folded to the bands. */
  xyz: Float32Array;
  measure(count: number): void;
}

/** Modules by name; each is a WebAssembly file of its own, and what is not loaded is not fetched. */
export interface Modules {
  light: Light;
  paint: Paint;
  scene: Scenes;
  core: Core;
  bands: Bands;
}

/** `base` is where the package's files are, an absolute URL that ends with a slash; `simd` whether to take the build for vectors; by default what runs here. */
export function load<M extends keyof Modules = 'light'>(options?: {
  module?: M;
  base?: string | URL;
  simd?: boolean;
}): Promise<Modules[M]>;

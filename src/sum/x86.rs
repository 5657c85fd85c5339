//! The sums in explicit vectors of x86-64: two of four lanes each, or one of eight where the build has AVX.
//!
//! The speed of code that the compiler makes from plain arrays changes with N, with its version and with the
//! code around it, by a factor of five. The code that it makes from these intrinsics does not change. Three
//! rows of 16 bands take 3 ns, and 13 ns with arrays of lanes; three rows of 81 bands take 12 ns, and 20 ns
//! with arrays.

#![expect(unsafe_code, reason = "intrinsics that the build has; loads from references")]

use core::arch::x86_64 as x86;

/// All rows against one spectrum, with up to four rows in a pass.
#[inline]
pub(crate) fn rows<const C: usize, const N: usize>(rows: &[[f32; N]; C], s: &[f32; N]) -> [f32; C] {
    if N <= 4 {
        return rows.each_ref().map(|row| few(row, s));
    }
    let mut sums = [0.0; C];
    let ((fours, rows), (four_sums, sums_left)) = (rows.as_chunks::<4>(), sums.as_chunks_mut());
    for (sums, rows) in four_sums.iter_mut().zip(fours) {
        *sums = pass(rows.each_ref(), s);
    }
    match (rows, sums_left) {
        ([x, y, z], [to_x, to_y, to_z]) => [*to_x, *to_y, *to_z, _] = pass([x, y, z], s),
        ([x, y], [to_x, to_y]) => [*to_x, *to_y, ..] = pass([x, y], s),
        ([x], [to_x]) => [*to_x, ..] = pass([x], s),
        _ => {}
    }
    sums
}

/// The sum of up to four products, as RGB has, without vectors, in the order of
/// [`reduce`](crate::sum::reduce).
#[inline(always)]
fn few<const N: usize>(row: &[f32; N], s: &[f32; N]) -> f32 {
    let at = |k: usize| row.get(k).zip(s.get(k)).map_or(0.0, |(weight, s)| 0.0 + weight * s);
    (at(0) + at(2)) + (at(1) + at(3))
}

/// Sums for every spectrum of a batch. With eight lanes the loads take longest, so three rows are read once
/// for three spectra. That takes 5.4 ns for each spectrum of 81 bands, and one by one 7.9 ns. (With four
/// lanes the instructions take longest, and nothing is gained.)
#[cfg(target_feature = "avx")]
#[inline]
pub(crate) fn each<T, const C: usize, const N: usize>(
    rows: &[[f32; N]; C],
    spectra: &[T],
    values: impl Fn(&T) -> &[f32; N],
    reports: &mut [[f32; C]],
) {
    let count = spectra.len().min(reports.len());
    let (mut spectra, mut reports) =
        (spectra.get(..count).unwrap_or(&[]), reports.get_mut(..count).unwrap_or(&mut []));
    if let [x, y, z] = rows.as_slice() {
        let ((threes, left), (to_threes, to_left)) = (spectra.as_chunks::<3>(), reports.as_chunks_mut::<3>());
        for ([a, b, c], to) in threes.iter().zip(to_threes) {
            let sums = three_by_three([x, y, z], [values(a), values(b), values(c)]);
            for (to, sums) in to.iter_mut().zip(&sums) {
                to.iter_mut().zip(sums).for_each(|(to, sum)| *to = *sum);
            }
        }
        (spectra, reports) = (left, to_left);
    }
    for (spectrum, report) in spectra.iter().zip(reports) {
        *report = self::rows(rows, values(spectrum));
    }
}

/// Three rows against three spectra; the result has a row for each spectrum.
#[cfg(target_feature = "avx")]
#[inline(always)]
fn three_by_three<const N: usize>([x, y, z]: [&[f32; N]; 3], [a, b, c]: [&[f32; N]; 3]) -> [[f32; 3]; 3] {
    // Nine variables stay in registers, where an array would not.
    let [mut xa, mut xb, mut xc] = [Eight::ZERO; 3];
    let [mut ya, mut yb, mut yc] = [Eight::ZERO; 3];
    let [mut za, mut zb, mut zc] = [Eight::ZERO; 3];
    let spectra = eights(a).zip(eights(b).zip(eights(c)));
    for ((x, (y, z)), (a, (b, c))) in eights(x).zip(eights(y).zip(eights(z))).zip(spectra) {
        (xa, xb, xc) = (xa.plus(x, a), xb.plus(x, b), xc.plus(x, c));
        (ya, yb, yc) = (ya.plus(y, a), yb.plus(y, b), yc.plus(y, c));
        (za, zb, zc) = (za.plus(z, a), zb.plus(z, b), zc.plus(z, c));
    }
    if !N.is_multiple_of(8) {
        let (x, y, z, a, b, c) = (rest(x), rest(y), rest(z), rest(a), rest(b), rest(c));
        (xa, xb, xc) = (xa.plus(x, a), xb.plus(x, b), xc.plus(x, c));
        (ya, yb, yc) = (ya.plus(y, a), yb.plus(y, b), yc.plus(y, c));
        (za, zb, zc) = (za.plus(z, a), zb.plus(z, b), zc.plus(z, c));
    }
    let [a0, a1, a2, b0, b1, b2, c0, c1] = eight_sums([xa, ya, za, xb, yb, zb, xc, yc]);
    let [c2, ..] = sums([zc; 4]);
    [[a0, a1, a2], [b0, b1, b2], [c0, c1, c2]]
}

/// Up to four rows against one spectrum.
#[inline(always)]
fn pass<const R: usize, const N: usize>(rows: [&[f32; N]; R], s: &[f32; N]) -> [f32; 4] {
    let mut lanes = [Eight::ZERO; 4];
    for (k, s) in eights(s).enumerate() {
        for (lanes, row) in lanes.iter_mut().zip(rows) {
            if let Some(row) = row.as_chunks().0.get(k) {
                *lanes = lanes.plus(Eight::of(row), s);
            }
        }
    }
    if !N.is_multiple_of(8) {
        let s = rest(s);
        for (lanes, row) in lanes.iter_mut().zip(rows) {
            *lanes = lanes.plus(rest(row), s);
        }
    }
    sums(lanes)
}

#[inline(always)]
fn eights<const N: usize>(values: &[f32; N]) -> impl Iterator<Item = Eight> {
    values.as_chunks().0.iter().map(Eight::of)
}

/// The values that remain after whole eights, followed by zeros: adding 0 * 0 does not change a sum.
#[inline(always)]
fn rest<const N: usize>(values: &[f32; N]) -> Eight {
    let (_, rest) = values.as_chunks::<8>();
    let at = |k: usize| rest.get(k).copied().unwrap_or(0.0);
    Eight::new([at(0), at(1), at(2), at(3), at(4), at(5), at(6), 0.0])
}

/// The sums of the lanes of four vectors, in the order of [`reduce`](crate::sum::reduce).
#[inline(always)]
fn sums(lanes: [Eight; 4]) -> [f32; 4] {
    let [a, b, c, d] = lanes.map(Eight::halves_added);
    // SAFETY: every build of this module has SSE2, and a vector of four f32 is laid out as four f32.
    unsafe {
        let ab = x86::_mm_add_ps(x86::_mm_movelh_ps(a, b), x86::_mm_movehl_ps(b, a));
        let cd = x86::_mm_add_ps(x86::_mm_movelh_ps(c, d), x86::_mm_movehl_ps(d, c));
        let (even, odd) =
            (x86::_mm_shuffle_ps::<0b10_00_10_00>(ab, cd), x86::_mm_shuffle_ps::<0b11_01_11_01>(ab, cd));
        core::mem::transmute::<x86::__m128, [f32; 4]>(x86::_mm_add_ps(even, odd))
    }
}

/// The sums of the lanes of eight vectors, as [`sums`] computes them.
#[cfg(target_feature = "avx")]
#[inline(always)]
fn eight_sums([a, b, c, d, e, f, g, h]: [Eight; 8]) -> [f32; 8] {
    // SAFETY: the build has AVX, and a vector of eight f32 is laid out as eight f32.
    unsafe {
        let halves_added = |one: Eight, two: Eight| {
            let halves = [
                x86::_mm256_permute2f128_ps::<0x20>(one.0, two.0),
                x86::_mm256_permute2f128_ps::<0x31>(one.0, two.0),
            ];
            x86::_mm256_add_ps(halves[0], halves[1])
        };
        let (ae, bf, cg, dh) =
            (halves_added(a, e), halves_added(b, f), halves_added(c, g), halves_added(d, h));
        let quarters_added = |one, two| {
            let quarters = [
                x86::_mm256_shuffle_ps::<0b01_00_01_00>(one, two),
                x86::_mm256_shuffle_ps::<0b11_10_11_10>(one, two),
            ];
            x86::_mm256_add_ps(quarters[0], quarters[1])
        };
        let (abef, cdgh) = (quarters_added(ae, bf), quarters_added(cg, dh));
        let even = x86::_mm256_shuffle_ps::<0b10_00_10_00>(abef, cdgh);
        let odd = x86::_mm256_shuffle_ps::<0b11_01_11_01>(abef, cdgh);
        core::mem::transmute::<x86::__m256, [f32; 8]>(x86::_mm256_add_ps(even, odd))
    }
}

/// Eight lanes in one vector.
#[cfg(target_feature = "avx")]
#[derive(Clone, Copy)]
struct Eight(x86::__m256);

// SAFETY of all: this is compiled only where the build has AVX, and a reference to eight f32 can be read.
#[cfg(target_feature = "avx")]
impl Eight {
    const ZERO: Self = Eight(unsafe { core::mem::zeroed() });

    #[inline(always)]
    fn of(values: &[f32; 8]) -> Self {
        Eight(unsafe { x86::_mm256_loadu_ps(values.as_ptr()) })
    }

    #[inline(always)]
    fn new([a, b, c, d, e, f, g, h]: [f32; 8]) -> Self {
        Eight(unsafe { x86::_mm256_setr_ps(a, b, c, d, e, f, g, h) })
    }

    #[inline(always)]
    fn plus(self, a: Self, b: Self) -> Self {
        Eight(unsafe { x86::_mm256_add_ps(self.0, x86::_mm256_mul_ps(a.0, b.0)) })
    }

    #[inline(always)]
    fn halves_added(self) -> x86::__m128 {
        unsafe {
            x86::_mm_add_ps(x86::_mm256_castps256_ps128(self.0), x86::_mm256_extractf128_ps::<1>(self.0))
        }
    }
}

/// Eight lanes in two vectors: the first four and the last four.
#[cfg(not(target_feature = "avx"))]
#[derive(Clone, Copy)]
struct Eight(x86::__m128, x86::__m128);

// SAFETY of all: every build of this module has SSE2, and a reference to eight f32 can be read, four from the
// first on and four from the fifth on.
#[cfg(not(target_feature = "avx"))]
impl Eight {
    const ZERO: Self = unsafe { core::mem::zeroed() };

    #[inline(always)]
    fn of(values: &[f32; 8]) -> Self {
        unsafe { Eight(x86::_mm_loadu_ps(values.as_ptr()), x86::_mm_loadu_ps(values.as_ptr().add(4))) }
    }

    #[inline(always)]
    fn new([a, b, c, d, e, f, g, h]: [f32; 8]) -> Self {
        unsafe { Eight(x86::_mm_setr_ps(a, b, c, d), x86::_mm_setr_ps(e, f, g, h)) }
    }

    #[inline(always)]
    fn plus(self, a: Self, b: Self) -> Self {
        unsafe {
            Eight(
                x86::_mm_add_ps(self.0, x86::_mm_mul_ps(a.0, b.0)),
                x86::_mm_add_ps(self.1, x86::_mm_mul_ps(a.1, b.1)),
            )
        }
    }

    #[inline(always)]
    fn halves_added(self) -> x86::__m128 {
        unsafe { x86::_mm_add_ps(self.0, self.1) }
    }
}

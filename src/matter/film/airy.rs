//! The interference of the beams between two faces, in f32 forms that neither cancel nor overflow.
//!
//! With tilted admittances y = n cos(theta) (s) or cos(theta) / n (p) of the three media and the phase phi of
//! one crossing, 1 - R = T = 4 y0 y2 / D and R = N / D, where N = (y0 - y2)^2 cos^2(phi) + (y0 y2 - y1^2)^2
//! sin^2(phi) / y1^2 and D = (y0 + y2)^2 cos^2(phi) + (y0 y2 + y1^2)^2 sin^2(phi) / y1^2. All terms are
//! positive, and the differences come from those of the indices.

use crate::math::{Double, Math, sqrt};
use crate::matter::PowerShares;

/// The three media as light of one direction and wavelength meets them: n cos(theta) in each.
pub(super) struct Tilted {
    n: [f32; 3],
    cos0: f32,
    /// (n0 sin(theta0))^2, the same in all media.
    across: f32,
    /// n cos(theta) in the first medium.
    first: f32,
    /// n cos(theta) in the film; its absolute value where it is imaginary.
    pub(super) film: Double,
    /// Whether the wave in the film fades instead of traveling (total reflection at the first face).
    pub(super) fades: bool,
    /// n cos(theta) in the last medium; `None` under total reflection, when no light travels there.
    last: Option<f32>,
}

impl Tilted {
    /// Takes three indices, each in 1e-3..=1e3, and the cosine in the first medium, 0..=1.
    pub(super) fn new(n: [f32; 3], cos0: f32) -> Self {
        let [n0, n1, n2] = n;
        let square = |x| Double::product(x, x);
        // n^2 - n0^2 + (n0 cos)^2 is exact where the indices are equal, and has 48 bits where they are far
        // apart.
        let slant = Double::product(n0, cos0);
        let squared = |n| square(n).minus(square(n0)).plus(slant.times(slant));
        let film2 = squared(n1);
        let fades = film2.high <= 0.0;
        let zero = Double::new(0.0);
        let film = if film2.high == 0.0 {
            zero
        } else if fades {
            zero.minus(film2).sqrt()
        } else {
            film2.sqrt()
        };
        let first = n0 * cos0;
        let last2 = squared(n2).high;
        // In the medium it came from, light travels at any angle.
        let last = if n2 == n0 {
            Some(first)
        } else if last2 <= 0.0 {
            None
        } else {
            Some(sqrt(last2))
        };
        Tilted { n, cos0, across: n0 * n0 * (1.0 - cos0) * (1.0 + cos0), first, film, fades, last }
    }

    /// The admittances of s and p; `None` under total reflection at the last medium.
    pub(super) fn faces(&self) -> Option<[Faces; 2]> {
        let ([n0, n1, n2], last) = (self.n, self.last?);
        let film = self.film.high;
        let (down, up) = ((n0 - n1) * (n0 + n1), (n2 - n1) * (n2 + n1));
        let over = (n0 - n2) * (n0 + n2);
        let s = Faces { first: self.first, film, last, down, up, over, per_index: 1.0 };
        let [m0, m1, m2] = [n0 * n0, n1 * n1, n2 * n2];
        // The squares of the sine and of the cosine in each medium. Near grazing incidence the latter cannot
        // be computed as 1 minus the former.
        let film2 = if self.fades { -film * film } else { film * film };
        let light = [self.across / m0, self.cos0 * self.cos0];
        let inside = [self.across / m1, film2 / m1];
        let behind = [self.across / m2, (last / n2) * (last / n2)];
        // 1 minus both squared sines, which is zero at Brewster's angle.
        let brewster = |[sine, cosine]: [f32; 2], [other_sine, other]: [f32; 2]| {
            if sine > other_sine { cosine - other_sine } else { other - sine }
        };
        let p = Faces {
            first: self.cos0 / n0,
            film: film / m1,
            last: last / m2,
            down: -down / (m0 * m1) * brewster(light, inside),
            up: -up / (m1 * m2) * brewster(behind, inside),
            over: -over / (m0 * m2) * brewster(light, behind),
            per_index: m1,
        };
        Some([s, p])
    }

    /// sin(phi) / (n cos), up to its sign, and cos^2(phi), with phi the phase of one crossing.
    pub(super) fn crossing<M: Math>(&self, turns: Double, nm: f32, thickness_nm: f32) -> [f32; 2] {
        const TAU: f32 = core::f32::consts::TAU;
        let film = self.film.high;
        // The limit of sin(phi) / (n cos) for grazing directions in the film.
        let straight = TAU * thickness_nm / nm;
        if film == 0.0 {
            [straight, 1.0]
        } else if self.fades {
            let grown = M::expm1(straight * film);
            let sinh = 0.5 * (grown + grown / (1.0 + grown));
            // The power that is left of the wave is below 1e-24, and the inverse soon exceeds f32.
            if grown > 1e12 { [f32::INFINITY, f32::INFINITY] } else { [sinh / film, 1.0 + sinh * sinh] }
        } else {
            let half = Double { high: 0.5 * turns.high, low: 0.5 * turns.low };
            let sine = M::sin_turns(half.fraction());
            [sine / film, 1.0 - sine * sine]
        }
    }
}

/// Tilted admittances of one polarization.
#[derive(Clone, Copy)]
pub(super) struct Faces {
    first: f32,
    film: f32,
    last: f32,
    /// y0^2 - y1^2, y2^2 - y1^2 and y0^2 - y2^2, without the cancellation.
    down: f32,
    up: f32,
    over: f32,
    /// n cos(theta) over y in the film.
    per_index: f32,
}

impl Faces {
    /// The shares at one wavelength; `crossing` is the result of [`Tilted::crossing`].
    pub(super) fn coherent(&self, fades: bool, [ratio, cos2]: [f32; 2]) -> PowerShares {
        let &Faces { first, film, last, down, up, over, per_index } = self;
        let sum = first + last;
        if sum == 0.0 {
            // At grazing incidence with the same medium on both sides the film is a mirror, or is not there.
            return if down == 0.0 || ratio == 0.0 { PowerShares::NOTHING } else { PowerShares::MIRROR };
        }
        let ratio = ratio * per_index;
        if ratio > 1e12 {
            return PowerShares::MIRROR;
        }
        let square = |x: f32| x * x;
        let film2 = if fades { -film * film } else { film * film };
        let back = square(over / sum) * cos2 + square((first * up + last * down) / sum * ratio);
        let all = square(sum) * cos2 + square((first * last + film2) * ratio);
        PowerShares { reflected: back / all, transmitted: 4.0 * first * last / all, absorbed: 0.0 }.held()
    }

    /// The shares when beams of many phases are added, so that no interference is left.
    pub(super) fn incoherent(&self) -> PowerShares {
        let &Faces { first, film, last, down, up, .. } = self;
        let sum = first + last;
        if sum == 0.0 {
            return if down == 0.0 { PowerShares::NOTHING } else { PowerShares::MIRROR };
        }
        let all = sum * (first * last + film * film);
        let (there, behind) = (down / (first + film), up / (last + film));
        PowerShares {
            reflected: (first * behind * behind + last * there * there) / all,
            transmitted: 4.0 * first * film * last / all,
            absorbed: 0.0,
        }
        .held()
    }

    /// -r01 r12, the factor by which one round trip weakens a beam, -1..=1; and 1 minus its absolute value.
    pub(super) fn round_trip(&self) -> [f32; 2] {
        let &Faces { first, film, last, down, up, .. } = self;
        let faces = (first + film) * (last + film);
        let q = (down / faces) * (up / faces);
        let rest = 2.0 * film * (first + last) / faces;
        [q, if q < 0.0 { 1.0 + q } else { rest }]
    }

    /// The mean over the wavelengths between two edges that are many fringes apart.
    pub(super) fn averaged<M: Math>(&self, edges: &[Edge; 2], width_nm: f32) -> PowerShares {
        use core::f32::consts::PI;
        let [q, _] = self.round_trip();
        let up_to = |edge: &Edge| {
            let [g, h] = edge.integrals::<M>(q);
            g / (2.0 * PI * edge.slope) + h / (2.0 * PI * PI * edge.nm * edge.slope * edge.slope)
        };
        let [low, high] = edges;
        // T over its mean is 1 + 2 sum(q^m cos(m delta)); this is the mean of the part beyond 1.
        let fringes = (up_to(low) - up_to(high)) / width_nm;
        let mean = self.incoherent();
        PowerShares {
            reflected: mean.reflected - mean.transmitted * fringes,
            transmitted: mean.transmitted + mean.transmitted * fringes,
            absorbed: 0.0,
        }
        .held()
    }
}

/// One end of a range of wavelengths.
pub(super) struct Edge {
    pub(super) nm: f32,
    /// The phase of a round trip.
    pub(super) turns: Double,
    /// The turns by which the phase grows when the wavelength falls by one nanometer.
    pub(super) slope: f32,
}

impl Edge {
    /// The fringes integrated over the phase once, 2 sum(q^m sin(m delta) / m), and twice, -2 sum(q^m cos(m
    /// delta) / m^2). The first in closed form; the second, which is only a correction, to eight terms.
    fn integrals<M: Math>(&self, q: f32) -> [f32; 2] {
        let half = Double { high: 0.5 * self.turns.high, low: 0.5 * self.turns.low }.fraction();
        let (sine, cosine) = (M::sin_turns(half), M::cos_turns(half));
        let (sin, cos) = (2.0 * sine * cosine, 1.0 - 2.0 * sine * sine);
        let first = 2.0 * M::atan2(q * sin, 1.0 - q * cos);
        let (mut power, mut before, mut now, mut second) = (q, 1.0, cos, 0.0);
        for m in 1..=8u8 {
            let m = f32::from(m);
            second -= 2.0 * power * now / (m * m);
            (before, now) = (now, 2.0 * cos * now - before);
            power *= q;
        }
        [first, second]
    }
}

//! That the documented bounds of what is made of readings hold at the worst that a search finds.

use model::cct::{planckian, uv_at};
use model::noise::Noise;
use model::planck::C2_CIE;
use model::search::{Range::*, units, worst};
use model::sensor::{self, wide};
use nanospectra::color::Xyz;
use nanospectra::light;
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::sensor::fixed::{FixedCct, FixedXyz};
use nanospectra::sensor::{
    BasicCounts, DeadTime, Exposure, FirstPixel, Fit, Nonlinearity, PixelWavelengths, XyzCovariance,
    amplitude_at, chip::as7341,
};
use std::f64::consts::{PI, TAU};

const STEPS: usize = 2000;

/// Units in the last place of `b` between two numbers.
fn ulps(a: f32, b: f32) -> f64 {
    f64::from((a - b).abs()) / f64::from(b.abs().next_up() - b.abs())
}

#[test]
fn counters_and_bends_are_undone_as_exactly_as_promised() {
    worst(1, STEPS, [Sizes(1e-12, 1e3), Sizes(1e-6, 1e30)], |[dead, arriving]| {
        let [d, a] = [dead, arriving].map(f64::from);
        units(DeadTime::new(dead).counted(arriving), a / (1.0 + d * a))
    })
    .is_what_is_promised("what is counted, in units", 3.0);
    for (what, most_busy, bound) in [("a sixth", 1.0 / 6.0, 2.0), ("half", 0.5, 4.0)] {
        worst(2, STEPS, [Sizes(1e-12, 1e3), Sizes(1e-6, most_busy)], |[dead, busy]| {
            let (counter, arriving) = (DeadTime::new(dead), busy / (1.0 - busy) / dead);
            counter.arrived(counter.counted(arriving)).map_or(f64::NAN, |back| ulps(back, arriving))
        })
        .is_what_is_promised(&format!("there and back while {what} is dead, in ulps"), bound);
    }
    // Over what full scale reads at most, and over the slope where it is below 1.
    worst(3, STEPS, [Even(-0.6, 12.0), Even(-7.0, 2.0), Even(0.0, 1.0)], |[c2, c3, signal]| {
        let Some(bend) = Nonlinearity::new([c2, c3]) else { return -1.0 };
        let [a, b, x] = [c2, c3, signal].map(f64::from);
        let slope = (1.0 + 2.0 * a * x + 3.0 * b * x * x).min(1.0);
        let full = f64::from(f32::EPSILON) * (1.0 + a.abs() + b.abs());
        bend.signal(bend.read(signal))
            .map_or(f64::NAN, |back| f64::from((back - signal).abs()) * slope / full)
    })
    .is_what_is_promised("bends there and back, in units of their sizes", 1.0);
}

#[test]
fn flicker_is_as_exact_as_promised() {
    let ranges = [Even(3.0, 100.0), Sizes(1.0, 300.0), Even(0.0, 1.0), Even(1.0, 10.0), Even(0.0, 0.5)];
    worst(1, 500, ranges, |[per_period, periods, phase, mean, octave]| {
        let per_period = per_period as usize;
        let count = per_period * (periods as usize).min(1000 / per_period);
        let wave = |k: usize| {
            let turn = TAU * (k as f64 / per_period as f64 + f64::from(phase));
            // With four readings a period and fewer the octave falls on its own or another frequency.
            let octave = if per_period > 4 { f64::from(octave) * (2.0 * turn).cos() } else { 0.0 };
            (f64::from(mean) + turn.sin() + octave) as f32
        };
        let readings: Vec<f32> = (0..count).map(wave).collect();
        amplitude_at(&readings, 1000.0, 1000.0 / per_period as f32)
            .map_or(f64::NAN, |found| (f64::from(found) - 1.0).abs())
    })
    .is_what_is_promised("amplitude of one frequency", 7e-5);
    worst(2, STEPS, [Sizes(1e-3, 1e5), Sizes(1e-2, 1e6)], |[ms, hz]| {
        let exposure = Exposure::new(1.0, ms, 65_535);
        let half = PI * f64::from(hz) * f64::from(exposure.time_ms()) * 1e-3;
        (f64::from(exposure.residual_modulation(hz)) - (half.sin() / half).abs()).abs()
    })
    .is_what_is_promised("residual modulation", 3e-7);
}

/// The uncertainty that noise of X, Y or Z alone makes, in units of what all three do together. The slopes
/// are the inverse of those of u and v along the locus and across it.
#[test]
fn uncertainties_are_as_exact_as_promised() {
    let off = |[mired, duv]: [f32; 2]| {
        let (mired, duv) = (f64::from(mired), f64::from(duv));
        let [u, v] = uv_at(1e6 / mired, duv);
        let size = 600.0 / v;
        let xyz =
            Xyz::from([u * size / 4.0, 100.0, (size - u * size / 4.0 - 1500.0) / 3.0].map(|x| x as f32));
        let (a, b) = (1e-3 * mired, 1e-5);
        let slope = |at: [f64; 2], before: [f64; 2], step: f64| {
            [0, 1].map(|k: usize| (at[k] - before[k]) / (2.0 * step))
        };
        let along = slope(uv_at(1e6 / (mired + a), duv), uv_at(1e6 / (mired - a), duv), a);
        let across = slope(uv_at(1e6 / mired, duv + b), uv_at(1e6 / mired, duv - b), b);
        let area = along[0] * across[1] - along[1] * across[0];
        let by_uv = [[across[1] / area, -across[0] / area], [-along[1] / area, along[0] / area]];
        let exact = by_uv.map(|[by_u, by_v]| {
            let toward = by_u * u + by_v * v;
            [4.0 * by_u - toward, 6.0 * by_v - 15.0 * toward, -3.0 * toward].map(|x| (x / size).abs())
        });
        let all = exact.map(|of| of.iter().map(|x| x * x).sum::<f64>().sqrt());
        let mut most = [0.0f64; 2];
        let causes = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        for (cause, [xx, yy, zz]) in causes.into_iter().enumerate() {
            let covariance = XyzCovariance { xx, yy, zz, ..XyzCovariance::default() };
            // At the end of the range rounding may decide that there is no temperature.
            let Some(found) = covariance.cct(xyz) else { continue };
            for (k, found) in [found.mired, found.duv].into_iter().enumerate() {
                most[k] = most[k].max((f64::from(found) - exact[k][cause]).abs() / all[k]);
            }
        }
        most
    };
    let ranges = [Sizes(1.0, 1000.0), Even(-0.05, 0.05)];
    worst(1, 60, ranges, |at| off(at)[0]).is_what_is_promised("uncertainty of CCT", 1.6e-2);
    worst(2, 60, [Even(1.0, 1000.0), ranges[1]], |at| off(at)[1])
        .is_what_is_promised("uncertainty of Duv", 4e-3);
}

#[test]
fn integers_find_temperatures_as_exactly_as_promised() {
    let off = |[mired, duv, size]: [f32; 3]| {
        let ([u, v], [du, dv]) = planckian(1e6 / f64::from(mired), C2_CIE);
        let beside = f64::from(duv) / du.hypot(dv);
        let [u, v] = [u + beside * dv, v - beside * du];
        let xyz = [1.5 * u / v, 1.0, (4.0 - u - 10.0 * v) / (2.0 * v)];
        let scale = f64::from(size) / xyz.iter().copied().fold(0.0, f64::max);
        match FixedXyz::new(xyz.map(|x| (x * scale).round() as i32), 0).cct() {
            Some(FixedCct::Near { mired_e3, duv_e6, .. }) => [
                (f64::from(mired_e3) / 1e3 - f64::from(mired)).abs(),
                (f64::from(duv_e6) / 1e6 - f64::from(duv)).abs(),
            ],
            _ => [-1.0; 2],
        }
    };
    let ranges = [Sizes(1.0, 1000.0), Even(-0.05, 0.05), Sizes(1_100_000.0, 2.1e9)];
    worst(1, 400, ranges, |at| off(at)[0]).is_what_is_promised("CCT in integers, mired", 0.11);
    worst(2, 400, ranges, |at| off(at)[1]).is_what_is_promised("Duv in integers", 2.5e-5);
}

#[test]
fn pixels_lie_as_exactly_as_promised() {
    // A C12880MA, and chips of other slopes and bends.
    let sheet = [3.102_449e2, 2.683_674, 1.121_367e-3, 6.962_632e-6, 8.478_353e-9, 5.208_724e-12f32];
    let [_, slope, bends @ ..] = sheet.map(|c| (c, Even(-2.0 * c, 2.0 * c)));
    let [c2, c3, c4, c5] = bends.map(|(_, range)| range);
    let ranges = [Even(200.0, 500.0), Even(0.5 * slope.0, 1.5 * slope.0), c2, c3, c4, c5];
    worst(1, 1000, ranges, |coefficients| {
        let Ok(unit) = PixelWavelengths::<288>::new(coefficients, FirstPixel::One) else { return -1.0 };
        if unit.nm(287) > 1100.0 {
            return -1.0;
        }
        let off = |found: f32, place: f64| {
            let terms = coefficients.iter().zip(0..).map(|(c, k)| f64::from(*c) * place.powi(k));
            (f64::from(found) - terms.sum::<f64>()).abs()
        };
        let centers = (0..288).map(|pixel| off(unit.nm(pixel), pixel as f64 + 1.0));
        let edges = (0..=288).map(|pixel| off(unit.edge_nm(pixel), pixel as f64 + 0.5));
        centers.chain(edges).fold(0.0, f64::max)
    })
    .is_what_is_promised("wavelengths of pixels, nm", 2.5e-4);
}

/// Sets of lamps are exchanged lamp by lamp while the matrix becomes worse.
#[test]
fn fits_are_as_exact_as_promised() {
    let all: Vec<_> = light::NAMES.iter().filter_map(|name| light::named(name)).collect();
    let error = |lamps: &[usize]| {
        let (mut fit, mut patches) = (Fit::<8, 3>::new(), [const { Vec::new() }; 2]);
        let mut weights = Vec::new();
        for lamp in lamps {
            for sample in &CES {
                let seen = all[*lamp] * sample.fine();
                let (counts, xyz) = (as7341::NOMINAL.sees(&seen), CIE_1931.sees(&seen));
                fit.add(&BasicCounts::new(counts), xyz, 1.0 / xyz[1]);
                patches[0].push(wide(&[counts]).remove(0));
                patches[1].push(wide(&[xyz]).remove(0));
                weights.push(f64::from(1.0 / xyz[1]));
            }
        }
        let found = fit.solve().expect("different colors");
        let rows = found.rows().iter().zip(sensor::fit(&patches[0], &patches[1], &weights));
        rows.map(|(row, exact)| {
            let size = exact.iter().fold(0.0f64, |size, v| size.max(v.abs()));
            row.iter().zip(&exact).map(|(got, v)| (f64::from(*got) - v).abs() / size).fold(0.0, f64::max)
        })
        .fold(0.0, f64::max)
    };
    let (mut noise, mut most) = (Noise(1), 0.0f64);
    for count in [1, 1, 1, 2, 3, 5] {
        let mut lamp = || noise.bits() as usize % all.len();
        let mut lamps: Vec<usize> = (0..count).map(|_| lamp()).collect();
        let mut here = error(&lamps);
        for step in 0..20 {
            let before = std::mem::replace(&mut lamps[step % count], lamp());
            match error(&lamps) {
                now if now >= here => here = now,
                _ => lamps[step % count] = before,
            }
        }
        println!("{here:.2e} under {:?}", lamps.iter().map(|lamp| light::NAMES[*lamp]).collect::<Vec<_>>());
        most = most.max(here);
    }
    assert!((5e-5..=1e-4).contains(&most), "{most:.2e} of the largest coefficient in a row");
}

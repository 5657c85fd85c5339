//! Sums of every rest, number of rows and length of batch, in the order that is promised: eight lanes and
//! their tree.

use nanospectra::{Bins, Light, Observer, Power};

fn in_the_promised_order(row: &[f32], values: &[f32]) -> f32 {
    let mut s = [0.0f32; 8];
    for (k, (weight, value)) in row.iter().zip(values).enumerate() {
        s[k % 8] += weight * value;
    }
    ((s[0] + s[4]) + (s[2] + s[6])) + ((s[1] + s[5]) + (s[3] + s[7]))
}

/// Sizes from 1e-40 to 1e3, of both signs, zeros among them.
fn noise<const N: usize>(seed: &mut u32) -> [f32; N] {
    [(); N].map(|()| {
        *seed = seed.wrapping_mul(1_664_525).wrapping_add(1_013_904_223);
        let share = (*seed >> 8) as f32 / (1 << 23) as f32 - 1.0;
        match *seed >> 28 {
            0 => share * 1e-40,
            1 => share * 0.0,
            power => share * 10f32.powi(power as i32 - 12),
        }
    })
}

fn sums_of<const C: usize, const N: usize>() {
    let mut seed = (C * 1000 + N) as u32;
    let rows = [(); C].map(|()| noise::<N>(&mut seed));
    let eye: Observer<C, N, Power, Bins<300, 900>> = Observer::from_weights(rows);
    let spectra = [(); 8].map(|()| Light::<N, Bins<300, 900>>::from_bins(noise(&mut seed)));
    let mut reports = [[0.0; C]; 8];
    // In batches of every length, since what a pass holds may not divide it.
    for count in 0..=8 {
        reports.fill([f32::NAN; C]);
        eye.sees_each(&spectra[..count], &mut reports);
        for (spectrum, report) in spectra.iter().zip(&reports).take(count) {
            let promised = rows.map(|row| in_the_promised_order(&row, spectrum.values()).to_bits());
            assert_eq!(report.map(f32::to_bits), promised, "batch of {count}, {C} rows of {N}");
            assert_eq!(eye.sees(spectrum).map(f32::to_bits), promised, "{C} rows of {N}");
        }
        assert!(reports[count..].iter().flatten().all(|report| report.is_nan()));
    }
}

pub fn main() {
    macro_rules! every {
        ($($n:literal)*) => { $(
            sums_of::<1, $n>();
            sums_of::<2, $n>();
            sums_of::<3, $n>();
            sums_of::<4, $n>();
            sums_of::<7, $n>();
            sums_of::<8, $n>();
        )* };
    }
    every!(1 7 8 9 17);
    // (Miri interprets, at a thousandth of the speed; it meets every load above.)
    #[cfg(not(miri))]
    every!(2 3 15 16 24 31 60 81 95 401 471);
}

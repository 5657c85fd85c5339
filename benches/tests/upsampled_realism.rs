//! How near a spectrum made from RGB comes to the real one. Each of the CES99 samples within sRGB is turned
//! into its RGB under D65 and back into a spectrum, and both spectra are compared under other lamps.

use nanospectra::color::{EncodedRgb, Rgb, Srgb};
use nanospectra::light::{A, D65, FL2, FL11, LED_B3};
use nanospectra::matter::CES;
use nanospectra::observer::CIE_1931;
use nanospectra::upsample::{Basis, Sigmoid, Smits, Viewing};
use nanospectra::{Curve, Factor, Nodes, Observer, Reflectance};
use rgb2spec::optimize::{gamut::Gamut, optimize};

type Grid = Nodes<380, 780>;
type Eye = Observer<3, 81, Factor, Grid>;

/// Sums over the samples of the root mean square of the difference over 400..=700 nm, of CIEDE2000 under each
/// lamp, and of the mean size of second differences.
#[derive(Debug, Default)]
struct Realism {
    rms: f64,
    delta_e: [f64; 4],
    roughness: f64,
    count: f64,
}

impl Realism {
    fn add(&mut self, real: &Reflectance<81, Grid>, made: &Reflectance<81, Grid>, lamps: &[Eye; 4]) {
        let visible = 4..65;
        let squares = visible.clone().map(|k| f64::from(real.values()[k] - made.values()[k]).powi(2));
        self.rms += (squares.sum::<f64>() / 61.0).sqrt();
        for (sum, lamp) in self.delta_e.iter_mut().zip(lamps) {
            *sum += f64::from(lamp.delta_e(real, made));
        }
        let bends = visible
            .map(|k| f64::from(made.values()[k - 1] - 2.0 * made.values()[k] + made.values()[k + 1]).abs());
        self.roughness += bends.sum::<f64>() / 61.0;
        self.count += 1.0;
    }

    /// Prints the means, and returns the root mean square and CIEDE2000 under each lamp.
    fn means(self, method: &str) -> (f64, [f64; 4]) {
        let n = self.count;
        let (rms, delta_e) = (self.rms / n, self.delta_e.map(|sum| sum / n));
        let [a, fl2, fl11, led] = delta_e;
        println!(
            "{method}: RMS {rms:.4}, A {a:.2}, FL2 {fl2:.2}, FL11 {fl11:.2}, LED-B3 {led:.2}, bends {:.5} ({n} samples)",
            self.roughness / n
        );
        (rms, delta_e)
    }
}

#[test]
fn of_the_exact_methods_the_sigmoid_is_nearest_to_measured_samples() {
    let viewing: Viewing<81, Grid> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
    let lamps: [Eye; 4] = [A.fine(), FL2.fine(), FL11.fine(), LED_B3.fine()]
        .map(|light| CIE_1931.under(&light).fold(Curve::Step));
    let (sigmoid, basis, smits) = (Sigmoid::<81, Grid>::new(&viewing), Basis::new(&viewing), Smits::new());
    let peer = peer();
    let mut all = [(); 4].map(|()| Realism::default());
    for sample in &CES {
        let real: Reflectance<81, Grid> = sample.resample();
        let rgb = viewing.rgb(&real);
        if rgb.in_gamut() {
            let made = [
                sigmoid.reflectance(rgb).spectrum.on_grid(),
                basis.reflectance(rgb),
                smits.reflectance(rgb),
                peer(rgb),
            ];
            for (realism, made) in all.iter_mut().zip(&made) {
                realism.add(&real, made, &lamps);
            }
        }
    }
    let [sigmoid, basis, smits, peer] = all;
    assert_eq!(sigmoid.count, 90.0, "samples within sRGB");
    let (sigmoid, basis, _) = (sigmoid.means("sigmoid"), basis.means("basis"), smits.means("Smits"));
    peer.means("rgb2spec");
    assert!(sigmoid.0 < 0.08, "{}", sigmoid.0);
    for (sigmoid, basis) in sigmoid.1.iter().zip(basis.1) {
        assert!(*sigmoid < 2.4 && *sigmoid < basis, "{sigmoid} {basis}");
    }
}

/// The crate `rgb2spec`, read at the centers of the bins. Its table has 16^3 cells, or 64^3 if the
/// environment says `NANOSPECTRA_CELLS=64`, which takes minutes to make.
fn peer() -> impl Fn(Rgb<Srgb>) -> Reflectance<81, Grid> {
    let cells =
        std::env::var("NANOSPECTRA_CELLS").map_or(16, |n| n.parse().expect("NANOSPECTRA_CELLS: a number"));
    let table = optimize(Gamut::SRGB, cells).expect("a table");
    move |rgb| {
        let coefficients = table.fetch(rgb.to_array());
        Reflectance::at_centers(|nm| rgb2spec::eval_precise(coefficients, nm))
    }
}

#[test]
fn a_table_of_coefficients_is_off_and_by_how_much() {
    let viewing: Viewing<81, Grid> = Viewing::new(&CIE_1931.under(&D65.fine()).fold(Curve::Step));
    let peer = peer();
    let (mut wrong, mut sum, mut worst, mut count) = (0u32, 0.0, 0.0f32, 0u32);
    for r in (0..=255).step_by(15) {
        for g in (0..=255).step_by(15) {
            for b in (0..=255).step_by(15) {
                let code = [r, g, b];
                let rgb = EncodedRgb::<Srgb>::from_u8(code).decode();
                let spectrum = peer(rgb);
                let off = viewing.delta_e(rgb, &spectrum);
                wrong += u32::from(viewing.rgb(&spectrum).encode().to_u8() != code);
                (sum, worst, count) = (sum + f64::from(off), worst.max(off), count + 1);
            }
        }
    }
    let mean = sum / f64::from(count);
    println!("rgb2spec: {wrong} wrong codes of {count}, mean {mean:.3}, max {worst:.2} CIEDE2000");
    assert!(worst > 0.01 && wrong > count / 100, "{worst} {wrong}: README says worse of it");
}

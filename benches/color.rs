//! Times what follows from XYZ: color temperature, CIELAB, color differences, color rendering. An id reads
//! `color/operation/N/backend`, where N is the number of bands. The bench `peers` compares with other crates.
//!
//! Every result is compared with the f64 model of the tests before it is timed.

use criterion::{BenchmarkId, Criterion};
use model::cri::{Method, Mode};
use model::{cct, delta_e, lab, transfer};
use nanospectra::color::transfer::{SrgbTransfer, Transfer};
use nanospectra::color::{Lab, Uv1960, Xy, Xyz, ciede2000, cri, dominant_wavelength, tm30};
use nanospectra::observer::CIE_1931;
use nanospectra::{Fine, Power, light};
use std::hint::black_box;

fn near(what: &str, found: f32, truth: f64, tolerance: f64) {
    assert!((f64::from(found) - truth).abs() <= tolerance, "{what}: {found} for {truth}");
}

fn bench<R>(c: &mut Criterion, op: &str, n: usize, f: impl FnMut() -> R) {
    c.benchmark_group(format!("color/{op}")).bench_function(BenchmarkId::new(n.to_string(), "portable"), {
        let mut f = f;
        move |b| b.iter(&mut f)
    });
}

/// What is computed from one color. Of these only the dominant wavelength needs the 1 nm tables.
fn point(c: &mut Criterion, lamp: &Fine<Power>) {
    let xyz = Xyz::from(CIE_1931.sees(lamp)).with_y(100.0).expect("visible");
    let (uv, xy) = (xyz.uv1960().expect("visible"), xyz.xy().expect("visible"));
    let truth = cct::cct([f64::from(uv.u), f64::from(uv.v)]).cct_k;
    near("mired", 1e6 / uv.cct().near().expect("white").0, 1e6 / truth, 1e-2);
    bench(c, "cct", 1, || Uv1960::cct(black_box(uv)));

    let (paint, white) = ([19.01, 20.0, 21.78], [95.047, 100.0, 108.883]);
    let truth = lab::lab(paint.map(f64::from), white.map(f64::from))[0];
    let (paint, white) = (Xyz::from(paint), Xyz::from(white));
    near("L*", paint.lab(white).expect("white").l, truth, 1e-4);
    bench(c, "lab", 1, || black_box(paint).lab(black_box(white)));

    let pair = [[50.0, 2.6772, -79.7751], [50.0, 0.0, -82.7485f32]];
    let truth = delta_e::de2000(pair[0].map(f64::from), pair[1].map(f64::from));
    let [one, two] = pair.map(|[l, a, b]| Lab::new(l, a, b));
    near("CIEDE2000", ciede2000(one, two), truth, 2e-6);
    bench(c, "ciede2000", 1, || ciede2000(black_box(one), black_box(two)));

    near("sRGB", SrgbTransfer::encode(0.5), transfer::srgb_encode(0.5), 1e-6);
    bench(c, "srgb-encode", 1, || SrgbTransfer::encode(black_box(0.5)));

    let white = Xy::new(1.0 / 3.0, 1.0 / 3.0);
    let dominant = || dominant_wavelength(black_box(xy), white, &CIE_1931);
    near("dominant wavelength", dominant().expect("not white").nm, 576.6, 1.0);
    bench(c, "dominant-wavelength", 471, dominant);
}

/// The color rendering of a lamp by CIE 13.3 and by TM-30.
fn rendering(c: &mut Criterion, lamp: &Fine<Power>) {
    let truth = Method::new(Mode::OneNm).of_values(&lamp.values().map(f64::from));
    near("Ra", cri(lamp).expect("white").ra, truth.ra, 1e-3);
    bench(c, "cri", 471, || cri(black_box(lamp)));
    near("Rf", tm30(lamp).expect("white").rf, 70.1, 0.3);
    bench(c, "tm30", 401, || tm30(black_box(lamp)));
}

fn main() {
    let mut c = Criterion::default().configure_from_args();
    let lamp = light::FL2_1NM.fine();
    point(&mut c, &lamp);
    rendering(&mut c, &lamp);
    c.final_summary();
}

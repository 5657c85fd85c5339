//! Thin films and stacks against the goldens, the textbook's matrix in f64, and means over bins taken point
//! by point.
#![cfg(feature = "libm")]

use model::allowed::{Singles, check};
use model::csv::golden;
use model::film::{self, C};
use nanospectra::color::Xyz;
use nanospectra::light::D65;
use nanospectra::matter::{Layer, Medium, PowerShares, Stack, ThinFilm, stack_bins};
use nanospectra::observer::CIE_1931;
use nanospectra::{Bins, Factor, Fine, Nodes, Reflectance, Spectrum};

/// `2.38+0.21i`, in the golden's way of writing.
fn medium(text: &str) -> Medium {
    let (n, k) = text.split_once('+').unwrap_or_else(|| panic!("{text}: no index"));
    let number = |t: &str| t.trim_end_matches('i').parse().unwrap_or_else(|_| panic!("{text}: no index"));
    Medium { n: number(n), k: number(k) }
}

/// Up to eight layers; what is missing has no thickness.
fn stack(indices: &str, thicknesses: &str, incident: f32, substrate: &str) -> Stack<8> {
    let mut layers = [Layer { medium: Medium { n: 1.5, k: 0.1 }, thickness_nm: 0.0 }; 8];
    let given = indices.split(';').zip(thicknesses.split(';'));
    assert!(given.clone().count() <= layers.len());
    for (layer, (index, d)) in layers.iter_mut().zip(given) {
        *layer = Layer { medium: medium(index), thickness_nm: d.parse().expect("a thickness") };
    }
    Stack { incident, layers, substrate: medium(substrate) }
}

/// The f64 model of these very f32.
fn exact<const L: usize>(stack: &Stack<L>, nm: f32, cos: f32) -> [[f64; 2]; 2] {
    let index = |m: Medium| C(m.n.into(), m.k.into());
    let layers: Vec<_> = stack.layers.iter().map(|l| (index(l.medium), l.thickness_nm.into())).collect();
    film::stack(stack.incident.into(), &layers, index(stack.substrate), nm.into(), cos.into())
}

fn cosine(degrees: f64) -> f32 {
    degrees.to_radians().cos() as f32
}

#[test]
fn stacks_agree_with_the_golden() {
    let (mut check, mut of_model) = (check("stacks of layers, golden 10"), check("stacks of layers"));
    let mut rows = 0;
    for row in golden("10_thin_film").rows() {
        let [n0, nm, degrees] = row.numbers(["n0", "lambda_nm", "theta_deg"]);
        let stack = stack(row.text("layers_n"), row.text("layers_d_nm"), n0 as f32, row.text("substrate_n"));
        let [s, p] = stack.at(nm as f32, cosine(degrees));
        let of = |shares: PowerShares| [shares.reflected, shares.transmitted, shares.absorbed].map(f64::from);
        check.cells(row, ["Rs", "Ts", "As"], of(s));
        check.cells(row, ["Rp", "Tp", "Ap"], of(p));
        for (shares, [r, t]) in [s, p].into_iter().zip(exact(&stack, nm as f32, cosine(degrees))) {
            of_model.add(&row.place(), shares.reflected, r);
            of_model.add(&row.place(), shares.transmitted, t);
            of_model.add(&row.place(), shares.absorbed, 1.0 - r - t);
        }
        rows += 1;
    }
    check.tight(6 * rows);
    of_model.tight(6 * rows);
    assert!(rows > 100, "{rows}");
}

/// XYZ under D65 at 1 nm, the golden's way: points at the nodes.
fn xyz(reflectance: &Fine<Factor>) -> [f32; 3] {
    let d65 = D65.fine();
    CIE_1931.under(&d65).with_white_y(100.0).sees(reflectance)
}

#[test]
fn the_colors_of_films_agree_with_the_golden() {
    let mut check = check("colors of films, golden 10");
    let mut rows = 0;
    for row in golden("10_thin_film_color").rows() {
        let [d, degrees] = row.numbers(["d_nm", "theta_deg"]);
        let (indices, substrate) = match row.text("stack") {
            "soap" => ([1.0, 1.33, 1.0], None),
            "SiO2_on_Si_const" => ([1.0, 1.46, 3.9], Some(Medium { n: 3.9, k: 0.02 })),
            "TiO2_on_glass_const" => ([1.0, 2.4, 1.52], None),
            "MgF2_on_glass" => ([1.0, 1.38, 1.52], None),
            other => panic!("no stack called {other}"),
        };
        let [n0, n1, n2] = indices;
        let (film, cos) = (ThinFilm::new(indices, d as f32), cosine(degrees));
        let layer = Layer { medium: Medium { n: n1, k: 0.0 }, thickness_nm: d as f32 };
        let stack =
            Stack { incident: n0, layers: [layer], substrate: substrate.unwrap_or(Medium { n: n2, k: 0.0 }) };
        let as_stack = Fine::at_centers(|nm| PowerShares::mean(stack.at(nm, cos)).reflected);
        check.cells(row, ["X", "Y", "Z"], xyz(&as_stack).map(f64::from));
        rows += 1;
        if substrate.is_none() {
            let as_film = Fine::at_centers(|nm| PowerShares::mean(film.at(nm, cos)).reflected);
            check.cells(row, ["X", "Y", "Z"], xyz(&as_film).map(f64::from));
            rows += 1;
        }
    }
    check.tight(3 * rows);
    assert!(rows > 150, "{rows}");
}

#[test]
fn a_quarter_wave_of_magnesium_fluoride_leaves_1_26_per_cent() {
    let [s, p] = ThinFilm::new([1.0, 1.38, 1.52], 550.0 / (4.0 * 1.38)).at(550.0, 1.0);
    assert!((s.reflected - 0.012_60).abs() < 5e-6 && (s.reflected - p.reflected).abs() < 1e-8, "{s:?} {p:?}");
    // Far from every fringe the plate reflects 2 R0 / (1 + R0): here by an index that is easy to check.
    let [s, _] = ThinFilm::new([1.0, 1.5, 1.0], f32::INFINITY).at(550.0, 1.0);
    assert!((s.reflected - 0.08 / 1.04).abs() < 1e-7, "{s:?}");
}

/// Means over bins against the points, all shares of both polarizations; returns how many were compared.
fn means<const N: usize, G: nanospectra::Grid>(
    check: &mut model::check::Check,
    indices: [f32; 3],
    d: f32,
    cos: f32,
) -> usize {
    let film = ThinFilm::new(indices, d);
    let reflected = film.reflectances::<N, G>(cos);
    let transmitted = film.transmittances::<N, G>(cos);
    for k in 0..N {
        let [low, high] = [k, k + 1].map(|k| f64::from(Spectrum::<Factor, N, G>::edge_nm(k)));
        let fringes = 2.0 * f64::from(indices[1] * d) * (1.0 / low - 1.0 / high);
        let points = 400 + (fringes * 400.0) as usize;
        let exact =
            film::mean(low, high, points, |nm| film::airy(indices.map(f64::from), d.into(), nm, cos.into()));
        for c in 0..2 {
            let place = format!("{indices:?}, {d} nm, cos {cos}, {low}..{high} nm");
            check.add(&place, reflected[c].values()[k], exact[c]);
            check.add(&place, transmitted[c].values()[k], 1.0 - exact[c]);
        }
    }
    4 * N
}

/// Films from a nanometer to a tenth of a millimeter, in wide and in narrow bins.
fn all_means(name: &'static str, indices: [f32; 3], cosines: [f32; 2]) {
    let mut check = check(name);
    let mut compared = 0;
    for cos in cosines {
        for d in [1.0, 30.0, 200.0, 700.0, 2500.0, 5e3, 9e3, 2e4, 1e5] {
            compared += means::<31, Bins<380, 730>>(&mut check, indices, d, cos);
            compared += means::<16, Bins<380, 730>>(&mut check, indices, d, cos);
            compared += means::<9, Nodes<500, 508>>(&mut check, indices, d, cos);
        }
    }
    check.tight(compared);
}

#[test]
fn bins_of_soap_hold_the_mean_over_the_bin() {
    all_means("means of soap", [1.0, 1.33, 1.0], [1.0, 0.6]);
}

#[test]
fn bins_of_a_coated_lens_hold_the_mean_over_the_bin() {
    all_means("means of a coated lens", [1.0, 1.38, 1.52], [1.0, 0.6]);
}

#[test]
fn bins_of_titania_hold_the_mean_over_the_bin() {
    all_means("means of titania on glass", [1.0, 2.4, 1.52], [1.0, 0.4]);
}

#[test]
fn bins_of_soap_at_grazing_angles_hold_the_mean_over_the_bin() {
    all_means("means of soap, grazing", [1.0, 1.33, 1.0], [0.17, 0.08]);
}

#[test]
fn bins_of_a_resonator_hold_the_mean_over_the_bin() {
    all_means("means of a Fabry-Perot gap", [4.0, 1.0, 4.0], [1.0, 0.99]);
}

#[test]
fn a_film_that_disperses_has_the_fringes_of_its_group_index() {
    // Water by a Cauchy formula, 40 um: ten fringes in a bin of 11 nm.
    let index = |nm: f64| 1.324 + 3046.0 / (nm * nm);
    let film = ThinFilm::new(|nm: f32| [1.0, 1.324 + 3046.0 / (nm * nm), 1.0], 4e4);
    let mut check = check("means of a dispersing film");
    let got: Reflectance<31> = film.reflectance(0.8);
    for k in 0..31 {
        let [low, high] = [k, k + 1].map(|k| f64::from(Reflectance::<31>::edge_nm(k)));
        let [s, p] =
            film::mean(low, high, 20_000, |nm| film::airy([1.0, index(nm), 1.0], 4e4, nm, f64::from(0.8f32)));
        check.add(&format!("{low}..{high}"), got.values()[k], 0.5 * (s + p));
    }
    check.tight(31);
}

#[test]
fn stacks_are_averaged_over_bins_too() {
    // A mirror of five pairs of quarter waves at 550 nm, and a film of gold's kind on glass.
    let (high, low) = (Medium { n: 2.4, k: 0.0 }, Medium { n: 1.38, k: 0.0 });
    let quarter = |medium: Medium| Layer { medium, thickness_nm: 137.5 / medium.n };
    let pair = [quarter(high), quarter(low)];
    let layers: [Layer; 10] = std::array::from_fn(|k| pair[k % 2]);
    let mirror = Stack { incident: 1.0, layers, substrate: Medium { n: 1.52, k: 0.0 } };
    let mut check = check("means of a mirror of ten layers");
    let got = stack_bins::<10, 31, Bins<380, 730>>(|_| mirror, 0.9, 2, |shares| shares.reflected);
    for k in 0..31 {
        let [low, high] = [k, k + 1].map(|k| f64::from(Reflectance::<31>::edge_nm(k)));
        let [s, p] = film::mean(low, high, 200, |nm| exact(&mirror, nm as f32, 0.9).map(|[r, _]| r));
        check.add(&format!("s, {low} nm"), got[0].values()[k], s);
        check.add(&format!("p, {low} nm"), got[1].values()[k], p);
    }
    check.tight(62);
    // (n0 - n2 (H/L)^10) / (n0 + ..): the textbook's peak.
    let peak = PowerShares::mean(mirror.at(550.0, 1.0)).reflected;
    let y = 1.52 * (2.4f64 / 1.38).powi(10);
    assert!((f64::from(peak) - ((1.0 - y) / (1.0 + y)).powi(2)).abs() < 2e-6, "{peak}");
}

#[test]
fn one_clear_layer_is_the_same_by_both_roads() {
    let mut check = check("a film as a stack");
    for (step, cos) in [1.0f32, 0.9, 0.5, 0.2, 0.05, 0.0].into_iter().enumerate() {
        for indices in
            [[1.0, 1.33, 1.0], [1.52, 1.0, 1.52], [1.52, 1.38, 1.0], [1.0, 1.0, 1.5], [1.7, 1.2, 1.5]]
        {
            for d in [0.0, 10.0, 333.0, 1500.0] {
                let nm = 400.0 + 37.0 * step as f32;
                let [n0, n1, n2] = indices;
                let layer = Layer { medium: Medium { n: n1, k: 0.0 }, thickness_nm: d };
                let stack = Stack { incident: n0, layers: [layer], substrate: Medium { n: n2, k: 0.0 } };
                let film = ThinFilm::new(indices, d).at(nm, cos);
                for (one, other) in film.into_iter().zip(stack.at(nm, cos)) {
                    let place = format!("{indices:?}, {d} nm, cos {cos}");
                    check.add(&place, one.reflected, other.reflected.into());
                    check.add(&place, one.transmitted, other.transmitted.into());
                }
            }
        }
    }
    check.tight_over_all();
}

#[test]
fn thick_metal_lets_nothing_through_and_nothing_overflows() {
    for d in [10.0, 1e3, 1e5, 1e9, 1e12] {
        let layer = Layer { medium: Medium { n: 0.2, k: 3.4 }, thickness_nm: d };
        let stack = Stack { incident: 1.0, layers: [layer; 3], substrate: Medium { n: 1.5, k: 0.0 } };
        for shares in stack.at(550.0, 0.7) {
            assert!(shares.reflected > 0.5 && shares.reflected < 1.0, "{d} nm: {shares:?}");
            assert!(shares.transmitted >= 0.0 && shares.transmitted < 0.5, "{d} nm: {shares:?}");
            assert!(d < 1e3 || shares.transmitted < 1e-20, "{d} nm: {shares:?}");
        }
    }
}

#[test]
fn total_reflection_is_total_and_a_thin_gap_frustrates_it() {
    // Glass, air gap, glass, at 60 degrees.
    let gap = |d: f32| ThinFilm::new([1.5, 1.0, 1.5], d).at(550.0, 0.5);
    for [s, p] in [gap(1e5), gap(1e9), gap(3e38), gap(f32::INFINITY)] {
        assert_eq!([s.reflected, s.transmitted, p.reflected, p.transmitted], [1.0, 0.0, 1.0, 0.0]);
    }
    let [s, p] = gap(100.0);
    let layers = [(C(1.0, 0.0), 100.0)];
    let exact = film::stack(1.5, &layers, C(1.5, 0.0), 550.0, 0.5);
    for (shares, [r, t]) in [s, p].into_iter().zip(exact) {
        assert!((f64::from(shares.reflected) - r).abs() < 4e-7, "{shares:?} {r}");
        assert!((f64::from(shares.transmitted) - t).abs() < 4e-7, "{shares:?} {t}");
        assert!(shares.transmitted > 0.1);
    }
    // Behind the film air, beyond the critical angle of glass to air: all comes back, whatever the film.
    for film in [[1.5, 1.38, 1.0], [1.5, 2.0, 1.0]] {
        let of = ThinFilm::new(film, 123.0).at(550.0, 0.5);
        assert_eq!(of.map(|shares| shares.reflected), [1.0, 1.0]);
    }
}

#[test]
fn what_is_no_film_is_nan_and_the_edges_of_what_is_are_defined() {
    let nan =
        |shares: [PowerShares; 2]| shares.iter().all(|s| s.reflected.is_nan() && s.transmitted.is_nan());
    let soap = [1.0, 1.33, 1.0];
    assert!(
        nan(ThinFilm::new(soap, -1.0).at(550.0, 1.0)) && nan(ThinFilm::new(soap, f32::NAN).at(550.0, 1.0))
    );
    assert!(
        nan(ThinFilm::new([1.0, 0.0, 1.0], 9.0).at(550.0, 1.0))
            && nan(ThinFilm::new(soap, 9.0).at(550.0, f32::NAN))
    );
    let bins: Reflectance<16> = ThinFilm::new([1.0, f32::NAN, 1.0], 100.0).reflectance(1.0);
    assert!(bins.values().iter().all(|r| r.is_nan()));
    // Nothing is there: no film, or a film of the same index, also along the surface.
    for cos in [1.0, 0.3, 0.0, -1.0] {
        for film in [ThinFilm::new([1.0, 1.33, 1.0], 0.0), ThinFilm::new([1.0, 1.0, 1.0], 300.0)] {
            let of = film.at(550.0, cos);
            assert_eq!(of.map(|s| s.reflected), [0.0, 0.0], "cos {cos}");
            assert!(of.iter().all(|s| (s.transmitted - 1.0).abs() < 3e-7), "cos {cos}: {of:?}");
        }
    }
    // Along the surface of a film everything is reflected; a cosine of 1.0000001 is 1.
    for d in [1e-3, 100.0, 1e6] {
        assert_eq!(ThinFilm::new(soap, d).at(550.0, 0.0).map(|s| s.reflected), [1.0, 1.0]);
    }
    assert_eq!(ThinFilm::new(soap, 90.0).at(550.0, 1.000_000_1), ThinFilm::new(soap, 90.0).at(550.0, 1.0));
    // A plate of an unknown thickness, and a grid of averages of it, agree.
    let plate = Reflectance::<16>::from_bins([2.0 * 0.04 / 1.04; 16]);
    let far: Reflectance<16> = ThinFilm::new([1.0, 1.5, 1.0], 3e38).reflectance(1.0);
    assert!(far.values().iter().zip(plate.values()).all(|(a, b)| (a - b).abs() < 1e-7));
}

#[test]
fn newtons_colors_come_in_their_order() {
    // Soap, seen straight: black, white, yellow of the first order, then blue before green of the second.
    let color = |d: f32| {
        let film: Fine<Factor> = ThinFilm::new([1.0, 1.33, 1.0], d).reflectance(1.0);
        Xyz::from(xyz(&film)).lab(Xyz::new(95.04, 100.0, 108.88)).expect("a white")
    };
    assert!(color(5.0).l < 2.0, "black");
    let (yellow, blue, green) = (color(165.0), color(235.0), color(290.0));
    assert!(yellow.b > 20.0 && blue.b < -25.0 && green.a < -10.0, "{yellow:?} {blue:?} {green:?}");
}

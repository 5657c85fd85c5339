//! How colors look, how they are encoded for cinema and high dynamic range, and how alike lights are.

use super::colors::{LAMPS, WHITE, lattice};
use super::hash::{Hash, Random};
use nanospectra::Fine;
use nanospectra::color::transfer::{Bt709, Hlg, Pq};
use nanospectra::color::{
    Aces2065, AppearanceModel, Bt2020, Cam16, CamUcs, Ciecam02, DciP3, Ictcp, IctcpTransfer, ProPhoto, Rgb,
    RgbSpace, Surround, Uv1960, ViewingConditions, Xyz, ssi,
};
use nanospectra::math::{Fast, Portable};

pub fn run(report: &mut impl FnMut(&str, u32)) {
    report("cam16", Hash::of(appearance::<Cam16>));
    report("ciecam02", Hash::of(appearance::<Ciecam02>));
    report("high-dynamic-range", Hash::of(high_dynamic_range));
    report("wide-spaces", Hash::of(wide_spaces));
    report("planckian", Hash::of(planckian));
    report("similarity", Hash::of(similarity));
}

fn color(hash: &mut Hash, xyz: Option<Xyz>) {
    match xyz {
        Some(xyz) => hash.all(&xyz.to_array()),
        None => hash.word(0),
    }
}

/// The attributes of a lattice of colors in three scenes, their places in the uniform space, and back from
/// both; some of them have no appearance.
fn appearance<A: AppearanceModel>(hash: &mut Hash) {
    let white = WHITE.xyz(100.0).unwrap_or_default();
    let scenes = [
        ViewingConditions::<A>::new(white, 318.31, 20.0, Surround::Average),
        ViewingConditions::new(white, 4.0, 15.0, Surround::Dim),
        ViewingConditions::discounting(white, 50.0, 20.0, Surround::Dark),
    ];
    for (scene, seen) in scenes.into_iter().flatten().enumerate() {
        for xyz in lattice().skip(scene).step_by(3) {
            if let Some(looks) = seen.appearance(xyz) {
                hash.all(&[looks.j, looks.c, looks.h_deg, looks.q, looks.m, looks.s]);
                color(hash, seen.xyz(looks));
            }
            for place in [seen.ucs(xyz), seen.ucs_with::<Fast>(xyz)] {
                match place {
                    Some(place) => hash.all(&[place.j, place.a, place.b]),
                    None => hash.word(0),
                }
            }
        }
        for k in 0..128 {
            let [j, a, b] = [k / 32, k / 8 % 4, k % 8].map(|step| step as f32);
            let place = CamUcs::new(35.0 * j - 1.0, 20.0 * a - 30.0, 10.0 * b - 35.0);
            color(hash, seen.xyz_of_ucs(place));
            hash.one(place.distance(CamUcs::new(50.0, 1.0, -2.0)));
        }
    }
}

/// ICtCp by both transfer functions, and Jzazbz, from starlight to a display of 10 000 cd/m2.
fn high_dynamic_range(hash: &mut Hash) {
    for xyz in lattice() {
        let scene = Rgb::<Bt2020>::from_xyz(xyz);
        for shown in [scene, scene * 0.01] {
            signal::<Pq>(hash, shown);
            hash.one(Ictcp::from_rgb(shown).delta_e_itp(Ictcp::new(0.5, 0.01, -0.02)));
        }
        signal::<Hlg>(hash, scene);
        for candelas in [1e-3, 1.0, 80.0] {
            let place = xyz.scaled(candelas).jzazbz();
            hash.all(&[place.jz, place.az, place.bz]);
            color(hash, place.xyz());
        }
    }
}

fn signal<T: IctcpTransfer>(hash: &mut Hash, rgb: Rgb<Bt2020>) {
    let code = Ictcp::<T>::from_rgb(rgb);
    hash.all(&[code.i, code.ct, code.cp]);
    hash.all(&code.rgb().map_or([0.0; 3], Rgb::to_array));
}

/// The spaces of cinema, photography and archives, and the camera of television.
fn wide_spaces(hash: &mut Hash) {
    for xyz in lattice() {
        coded::<DciP3>(hash, xyz);
        coded::<ProPhoto>(hash, xyz);
        coded::<Aces2065>(hash, xyz);
        let television = Rgb::<Bt2020>::from_xyz(xyz).encode_with::<Bt709, Portable>();
        hash.all(&television.to_array());
        hash.all(&television.decode_with::<Portable>().to_array());
    }
}

fn coded<S: RgbSpace>(hash: &mut Hash, xyz: Xyz) {
    let code = Rgb::<S>::from_xyz(xyz).encode();
    hash.all(&code.to_array());
    hash.all(&code.decode().xyz().to_array());
}

/// Whites on the locus, beside it and beyond both of its ends.
fn planckian(hash: &mut Hash) {
    let mut kelvin = 900.0;
    while kelvin < 1.2e6 {
        hash.maybe(Uv1960::planckian(kelvin).map(|uv| [uv.u, uv.v]));
        for duv in [-0.06, -0.05, -0.003, 0.0032, 0.02, 0.05] {
            hash.maybe(Uv1960::of_cct(kelvin, duv).map(|uv| [uv.u, uv.v]));
        }
        kelvin *= 1.0625;
    }
}

/// Each lamp beside each other one, and beside a random light and the dark.
fn similarity(hash: &mut Hash) {
    let mut random = Random(0x5eed_0551);
    for light in &LAMPS {
        let others = [Fine::from_bins(random.bins()), Fine::flat(0.0)];
        for other in LAMPS.iter().chain(&others) {
            hash.maybe(ssi(light, other).map(|index| [index, 0.0]));
        }
    }
}

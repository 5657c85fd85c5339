//! Correlated color temperature by methods of others: McCamy's cubic, Robertson's isotherms and Ohno's table.

use nanospectra::math::sqrt;

/// Returns the temperature in K for x and y by McCamy's approximation, which was made for lights near the
/// locus between 2856 and 6504 K. It gives no Duv.
///
/// # Reference
/// C. S. McCamy, "Correlated color temperature as an explicit function of chromaticity coordinates", Color
/// Research and Application 17 (1992).
#[must_use]
pub fn mccamy([x, y]: [f32; 2]) -> f32 {
    let n = (x - 0.3320) / (y - 0.1858);
    ((-449.0 * n + 3525.0) * n - 6823.3) * n + 5520.33
}

/// Robertson's isotherms: reciprocal megakelvin, u and v (CIE 1960) of the locus, slope of the isotherm.
///
/// # Reference
/// A. R. Robertson, "Computation of correlated color temperature and distribution temperature", J. Opt. Soc.
/// Am. 58 (1968); the table as in G. Wyszecki, W. S. Stiles, "Color Science", 2nd edition, table 1(3.11),
/// with u of 325 mired corrected from 0.24702.
pub static ISOTHERMS: [[f32; 4]; 31] = [
    [0.0, 0.18006, 0.26352, -0.24341],
    [10.0, 0.18066, 0.26589, -0.25479],
    [20.0, 0.18133, 0.26846, -0.26876],
    [30.0, 0.18208, 0.27119, -0.28539],
    [40.0, 0.18293, 0.27407, -0.30470],
    [50.0, 0.18388, 0.27709, -0.32675],
    [60.0, 0.18494, 0.28021, -0.35156],
    [70.0, 0.18611, 0.28342, -0.37915],
    [80.0, 0.18740, 0.28668, -0.40955],
    [90.0, 0.18880, 0.28997, -0.44278],
    [100.0, 0.19032, 0.29326, -0.47888],
    [125.0, 0.19462, 0.30141, -0.58204],
    [150.0, 0.19962, 0.30921, -0.70471],
    [175.0, 0.20525, 0.31647, -0.84901],
    [200.0, 0.21142, 0.32312, -1.0182],
    [225.0, 0.21807, 0.32909, -1.2168],
    [250.0, 0.22511, 0.33439, -1.4512],
    [275.0, 0.23247, 0.33904, -1.7298],
    [300.0, 0.24010, 0.34308, -2.0637],
    [325.0, 0.24792, 0.34655, -2.4681],
    [350.0, 0.25591, 0.34951, -2.9641],
    [375.0, 0.26400, 0.35200, -3.5814],
    [400.0, 0.27218, 0.35407, -4.3633],
    [425.0, 0.28039, 0.35577, -5.3762],
    [450.0, 0.28863, 0.35714, -6.7262],
    [475.0, 0.29685, 0.35823, -8.5955],
    [500.0, 0.30505, 0.35907, -11.324],
    [525.0, 0.31320, 0.35968, -15.628],
    [550.0, 0.32129, 0.36011, -23.325],
    [575.0, 0.32931, 0.36038, -40.770],
    [600.0, 0.33724, 0.36051, -116.45],
];

/// Returns K and Duv by Robertson's method, from 1667 K up, and `None` for redder lights and for NaN.
///
/// The point lies between two isotherms. By its distances from the two, the temperature, the point of the
/// locus and the direction in which Duv grows are interpolated.
#[must_use]
pub fn robertson([u, v]: [f32; 2]) -> Option<[f32; 2]> {
    let mut before: Option<(&[f32; 4], f32)> = None;
    for line in &ISOTHERMS {
        let [_, on_u, on_v, slope] = line;
        // The distance times the length of (1, slope), which is only needed for two of the isotherms.
        let here = (v - on_v) - slope * (u - on_u);
        match before {
            Some((last, there)) if there * here <= 0.0 => {
                return Some(between([u, v], [last, line], [there, here]));
            }
            _ => before = Some((line, here)),
        }
    }
    None
}

/// Returns K and Duv between two isotherms, given the distances from both times the length of (1, slope).
fn between([u, v]: [f32; 2], [a, b]: [&[f32; 4]; 2], [from_a, from_b]: [f32; 2]) -> [f32; 2] {
    let ([mired_a, u_a, v_a, slope_a], [mired_b, u_b, v_b, slope_b]) = (a, b);
    let inverse = |slope: &f32| 1.0 / sqrt(1.0 + slope * slope);
    let (length_a, length_b) = (inverse(slope_a), inverse(slope_b));
    let (from_a, from_b) = (from_a * length_a, from_b * length_b);
    let part = from_a / (from_a - from_b);
    let at = |a: f32, b: f32| a + part * (b - a);
    let (du, dv) = (u - at(*u_a, *u_b), v - at(*v_a, *v_b));
    // Green lies up and to the left of the locus.
    let (left, up) = (at(length_a, length_b), at(-slope_a * length_a, -slope_b * length_b));
    [1e6 / at(*mired_a, *mired_b), (dv * up - du * left) / sqrt(left * left + up * up)]
}

/// Ohno's table: K, u and v (CIE 1960) of black bodies in steps of 1 %, one step beyond 1000 and 100 000 K.
///
/// Made from the CIE 1931 functions by `NANOSPECTRA_BLESS=1 cargo test -p nanospectra-hard`.
pub static LOCUS: [[f32; 3]; 466] = include!("locus_1_percent.txt");

/// Returns K and Duv by Ohno's method on his table in steps of 1 %, and `None` beyond the ends of the table.
/// It uses the triangle of the nearest point and its two neighbors, and from |Duv| = 0.002 on a parabola
/// through their distances.
///
/// The whole table is searched. Differences of squares are computed as products, since f32 would lose them in
/// the form in which he writes them.
///
/// # Reference
/// Y. Ohno, "Practical use and calculation of CCT and Duv", Leukos 10 (2014).
#[must_use]
pub fn ohno([u, v]: [f32; 2]) -> Option<[f32; 2]> {
    let square = |[_, on_u, on_v]: &[f32; 3]| (u - on_u) * (u - on_u) + (v - on_v) * (v - on_v);
    let (mut nearest, mut least) = (0, f32::INFINITY);
    for (k, entry) in LOCUS.iter().enumerate() {
        let here = square(entry);
        if here < least {
            (nearest, least) = (k, here);
        }
    }
    let three = LOCUS.get(nearest.checked_sub(1)?..)?;
    let [cold @ [t0, u0, v0], middle @ [t1, u1, v1], hot @ [t2, u2, v2]] = three.first_chunk::<3>()?;
    // The triangle: how far the point stands along its base, from the cold end.
    let (along_u, along_v) = (u2 - u0, v2 - v0);
    let base = along_u * along_u + along_v * along_v;
    let part = ((u - u0) * along_u + (v - v0) * along_v) / base;
    let (du, dv) = (u - (u0 + part * along_u), v - (v0 + part * along_v));
    let duv = sqrt(du * du + dv * dv);
    let sign = if dv < 0.0 { -1.0 } else { 1.0 };
    if duv < 0.002 {
        // His correction for the curvature of the locus between steps of 1 %.
        return Some([(t0 + part * (t2 - t0)) * 0.99991, sign * duv]);
    }
    let [d0, d1, d2] = [cold, middle, hot].map(|entry| sqrt(square(entry)));
    // The squared distance of one of two points less that of the other.
    let less = |[ua, va]: [f32; 2], [ub, vb]: [f32; 2]| {
        (ub - ua) * ((u - ua) + (u - ub)) + (vb - va) * ((v - va) + (v - vb))
    };
    let first = less([*u0, *v0], [*u1, *v1]) / ((d0 + d1) * (t0 - t1));
    let second = less([*u1, *v1], [*u2, *v2]) / ((d1 + d2) * (t1 - t2));
    let a = (second - first) / (t2 - t0);
    // From the nearest of the three points, whose slope is the mean of the two chords, each weighted by the
    // length of the other.
    let slope = first + a * (t1 - t0);
    let step = -slope / (2.0 * a);
    Some([t1 + step, sign * (d1 + step * (slope + a * step))])
}

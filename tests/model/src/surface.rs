//! Rough surfaces as the papers define them, integrated by brute force in f64.

use std::f64::consts::{PI, TAU};

pub type Vector = [f64; 3];

pub fn dot(a: Vector, b: Vector) -> f64 {
    a.iter().zip(&b).map(|(a, b)| a * b).sum()
}

/// In the plane of x.
pub fn tilted(cos_theta: f64) -> Vector {
    [(1.0 - cos_theta * cos_theta).sqrt(), 0.0, cos_theta]
}

/// Distribution of normals after Trowbridge and Reitz, by the tangent (Walter 2007, equation 33).
pub fn ggx_d(alpha: f64, wm: Vector) -> f64 {
    let tan2 = (wm[0] * wm[0] + wm[1] * wm[1]) / (wm[2] * wm[2]);
    alpha * alpha / (PI * wm[2].powi(4) * (alpha * alpha + tan2).powi(2))
}

/// Smith's Lambda.
fn lambda(alpha: f64, w: Vector) -> f64 {
    let tan2 = (w[0] * w[0] + w[1] * w[1]) / (w[2] * w[2]);
    0.5 * ((1.0 + alpha * alpha * tan2).sqrt() - 1.0)
}

/// Height-correlated masking and shadowing (Heitz 2014, equation 99).
pub fn g2(alpha: f64, wo: Vector, wi: Vector) -> f64 {
    1.0 / (1.0 + lambda(alpha, wo) + lambda(alpha, wi))
}

/// Density of the normals seen from a direction (Heitz 2014, equation 16).
pub fn ggx_visible_d(alpha: f64, w: Vector, wm: Vector) -> f64 {
    ggx_d(alpha, wm) * dot(w, wm) / (w[2] * (1.0 + lambda(alpha, w)))
}

/// The BRDF of perfect reflectors.
pub fn ggx_f(alpha: f64, wo: Vector, wi: Vector) -> f64 {
    let sum = [0, 1, 2].map(|k| wo[k] + wi[k]);
    let size = dot(sum, sum).sqrt();
    let wm = sum.map(|part| part / size);
    ggx_d(alpha, wm) * g2(alpha, wo, wi) / (4.0 * wo[2] * wi[2])
}

/// Hemispherical-directional reflectance of perfect reflectors: midpoints over all normals, as D distributes
/// them.
pub fn ggx_rho(alpha: f64, cos_theta: f64, steps: usize) -> f64 {
    let wo = tilted(cos_theta);
    let n = steps as f64;
    // Half the azimuths: the other half mirrors it.
    let azimuths: Vec<_> = (0..steps).map(|k| (PI * (k as f64 + 0.5) / n).sin_cos()).collect();
    let mut sum = 0.0;
    for j in 0..steps {
        // The share of D that is steeper is v^2: even in v, for at grazing angles steep facets matter most.
        let v = (j as f64 + 0.5) / n;
        let tan2 = alpha * alpha * (1.0 - v * v) / (v * v);
        let cosine = 1.0 / (1.0 + tan2).sqrt();
        let sine = tan2.sqrt() * cosine;
        for (along_y, along_x) in &azimuths {
            let wm = [sine * along_x, sine * along_y, cosine];
            let towards = dot(wo, wm);
            let wi = [0, 1, 2].map(|k| 2.0 * towards * wm[k] - wo[k]);
            if towards > 0.0 && wi[2] > 0.0 {
                sum += 2.0 * v * g2(alpha, wo, wi) * towards / (wo[2] * cosine);
            }
        }
    }
    sum / (n * n)
}

/// Rough matt surfaces after Portsmouth, Kutz and Hill (2025).
pub fn eon_f(albedo: f64, roughness: f64, wo: Vector, wi: Vector) -> f64 {
    let flat = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * roughness);
    let s = dot(wo, wi) - wo[2] * wi[2];
    let shape = if s > 0.0 { s / wo[2].max(wi[2]) } else { s };
    let once = albedo / PI * flat * (1.0 + roughness * shape);
    let mean = flat * (1.0 + (2.0 / 3.0 - 28.0 / (15.0 * PI)) * roughness);
    let multiple = albedo * albedo * mean / (1.0 - albedo * (1.0 - mean));
    let lost = |w: Vector| 1.0 - eon_e(roughness, w[2]);
    if roughness == 0.0 {
        return once;
    }
    once + multiple / PI * lost(wo) * lost(wi) / (1.0 - mean)
}

/// The directional albedo of one reflection.
fn eon_e(roughness: f64, cosine: f64) -> f64 {
    let flat = 1.0 / (1.0 + (0.5 - 2.0 / (3.0 * PI)) * roughness);
    let sine = (1.0 - cosine * cosine).sqrt();
    let g =
        sine * (cosine.acos() - sine * cosine) + 2.0 / 3.0 * (sine / cosine * (1.0 - sine.powi(3)) - sine);
    flat + roughness * flat / PI * g
}

/// The integral of f times the cosine over the hemisphere, by midpoints in the cosine and the azimuth.
pub fn rho(wo: Vector, steps: usize, f: impl Fn(Vector, Vector) -> f64) -> f64 {
    let n = steps as f64;
    let mut sum = 0.0;
    for j in 0..steps {
        let mu = (j as f64 + 0.5) / n;
        let sine = (1.0 - mu * mu).sqrt();
        for k in 0..steps {
            let phi = TAU * (k as f64 + 0.5) / n;
            sum += f(wo, [sine * phi.cos(), sine * phi.sin(), mu]) * mu;
        }
    }
    sum * TAU / (n * n)
}

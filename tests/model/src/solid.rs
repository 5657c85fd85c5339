//! The solid of object colors: what an observer can see of surfaces that reflect at most all light.

type Color = [f64; 3];

/// The colors of all spectra within 0..=1 on some bands.
pub struct Solid {
    /// The directions of all faces, and how far the solid reaches in each.
    faces: Vec<(Color, f64)>,
}

impl Solid {
    /// Of the colors that the bands have, each by itself.
    ///
    /// The solid is the sum of a segment for each band, from 0 to its color. Each of its faces is spanned by
    /// two of them, so its membership needs no linear programme.
    pub fn new(bands: &[Color]) -> Self {
        let mut faces = Vec::new();
        for (k, a) in bands.iter().enumerate() {
            for b in &bands[..k] {
                let across =
                    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]];
                let length = dot(across, across).sqrt();
                if length > 1e-12 {
                    for side in [1.0 / length, -1.0 / length] {
                        let normal = across.map(|n| side * n);
                        faces.push((normal, bands.iter().map(|w| dot(normal, *w).max(0.0)).sum()));
                    }
                }
            }
        }
        Solid { faces }
    }

    /// Whether a spectrum within 0..=1 has the color.
    pub fn contains(&self, color: Color) -> bool {
        self.faces.iter().all(|(normal, reach)| dot(*normal, color) <= reach + 1e-9)
    }
}

fn dot(a: Color, b: Color) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

//! Reads a product of powers of units, such as `uW cm-2 nm-1`, `W/m2/nm` or `W/(m² sr nm)`.

/// The parts of a unit that matter for spectra, each with its exponent and all with one factor to the SI, where
/// spectral densities are per nm.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub struct Product {
    /// What the powers of ten multiply to.
    pub factor: f64,
    pub watt: i32,
    pub mole: i32,
    pub photon: i32,
    pub second: i32,
    /// Meters of an area, so -2 for a density on a surface.
    pub meter: i32,
    pub steradian: i32,
    /// Nanometers of wavelength.
    pub nanometer: i32,
    /// Terahertz of frequency.
    pub terahertz: i32,
    /// Wavenumbers, in cm-1.
    pub wavenumber: i32,
    /// Electronvolts of the energy of a photon.
    pub electronvolt: i32,
}

/// Reads a product from a text that is in plain letters and lower case, or returns `None` if a part of it is
/// unknown.
pub fn parse(text: &str) -> Option<Product> {
    let mut product = Product { factor: 1.0, ..Product::default() };
    let mut sign = 1;
    let mut rest = text.trim();
    let mut any = false;
    while let Some(first) = rest.chars().next() {
        if first == '/' {
            sign = -1;
            rest = &rest[1..];
        } else if first.is_alphabetic() {
            let end = rest.find(|c: char| !c.is_alphabetic()).unwrap_or(rest.len());
            let (name, after) = rest.split_at(end);
            rest = after;
            if name == "per" {
                sign = -1;
                continue;
            }
            let (exponent, after) = exponent(after)?;
            rest = after;
            if name == "cm" && exponent == -1 && sign == -1 {
                product.wavenumber -= 1;
                continue;
            }
            let power = if exponent < 0 { exponent } else { sign * exponent };
            product.multiply(name, power)?;
            any = true;
        } else if matches!(first, ' ' | '(' | ')' | '[' | ']' | '.' | '-') {
            rest = &rest[1..];
        } else {
            return None;
        }
    }
    any.then_some(product)
}

/// Returns the exponent at the beginning of a text, 1 if there is none, and the rest.
fn exponent(text: &str) -> Option<(i32, &str)> {
    let digits = |text: &str| text.find(|c: char| !c.is_ascii_digit()).unwrap_or(text.len());
    let (negative, after) = match text.strip_prefix('-') {
        Some(after) if digits(after) > 0 => (true, after),
        _ => (false, text),
    };
    let end = digits(after);
    if end == 0 {
        return Some((1, text));
    }
    let exponent: i32 = after[..end].parse().ok().filter(|exponent| *exponent < 10)?;
    Some((if negative { -exponent } else { exponent }, &after[end..]))
}

impl Product {
    /// Multiplies by a power of a unit.
    fn multiply(&mut self, name: &str, power: i32) -> Option<()> {
        // Energy is power for a time.
        let joules = match name {
            "j" | "joule" | "joules" => Some(1.0),
            "mj" => Some(1e-3),
            "uj" => Some(1e-6),
            "erg" | "ergs" => Some(1e-7),
            _ => None,
        };
        if let Some(joules) = joules {
            self.watt += power;
            self.second += power;
            self.factor *= f64::powi(joules, power);
            return Some(());
        }
        let (scale, count): (f64, &mut i32) = match name {
            "w" | "watt" | "watts" => (1.0, &mut self.watt),
            "kw" => (1e3, &mut self.watt),
            "mw" | "milliwatt" | "milliwatts" => (1e-3, &mut self.watt),
            "uw" | "microwatt" | "microwatts" | "uwatt" | "uwatts" => (1e-6, &mut self.watt),
            "nw" | "nanowatt" | "nanowatts" => (1e-9, &mut self.watt),
            "pw" => (1e-12, &mut self.watt),
            "mwatt" | "mwatts" => (1e-3, &mut self.watt),
            "mol" | "mole" | "moles" | "einstein" | "einsteins" => (1.0, &mut self.mole),
            "mmol" => (1e-3, &mut self.mole),
            "umol" | "umole" | "umoles" | "umols" | "micromol" | "micromole" | "micromoles" => {
                (1e-6, &mut self.mole)
            }
            "nmol" => (1e-9, &mut self.mole),
            "photon" | "photons" | "quanta" => (1.0, &mut self.photon),
            "s" | "sec" | "second" | "seconds" => (1.0, &mut self.second),
            "sr" | "steradian" => (1.0, &mut self.steradian),
            "nm" | "nanometer" | "nanometre" => (1.0, &mut self.nanometer),
            "um" | "micron" | "micrometer" | "micrometre" if power == -1 => (1e3, &mut self.nanometer),
            "angstrom" if power == -1 => (0.1, &mut self.nanometer),
            "thz" => (1.0, &mut self.terahertz),
            "ev" => (1.0, &mut self.electronvolt),
            "hz" if power == -1 => (1e-12, &mut self.terahertz),
            "m" | "meter" | "metre" if power % 2 == 0 => (1.0, &mut self.meter),
            "sqm" => {
                self.meter += 2 * power;
                return Some(());
            }
            // W/m3 is W/m2 per meter of wavelength.
            "m" if power == -3 => {
                self.factor *= 1e-9;
                self.nanometer -= 1;
                self.meter -= 2;
                return Some(());
            }
            "m" if power == -1 => {
                self.factor *= 1e-9;
                self.nanometer -= 1;
                return Some(());
            }
            "cm" if power % 2 == 0 => (1e-2, &mut self.meter),
            "mm" if power % 2 == 0 => (1e-3, &mut self.meter),
            _ => return None,
        };
        *count += power;
        self.factor *= scale.powi(power);
        Some(())
    }
}

//! Simulates a log of an AS7341 with exactly nominal responsivities under exactly the CIE's lamps.
//!
//! It uses whole numbers, sums and square roots only, so that the log is the same on every machine, byte for
//! byte.

use crate::output::number::{fixed, shortest};
use nanospectra::radiometry::illuminance;
use nanospectra::sensor::{AutoExposure, Exposure, Noise, chip::as7341, gaussian_responsivities};
use nanospectra::{Fine, Nodes, Observer, Power, light};
use std::fmt::Write;

/// The noise that the chip adds.
pub const NOISE: Noise = Noise { electrons_per_count: 180.0, read_counts: 1.2 };
/// The basic counts for each W/m2 at the peak of a channel.
pub const COUNTS_PER_W: f64 = 30.0;
pub const SEED: u64 = 0x0a57_3410_5eed;
/// The frequency and the duty of the light that is switched on and off.
pub const PWM_HZ: f64 = 100.0;
pub const PWM_DUTY: f64 = 0.4;
/// The settings (ATIME, ASTEP) of the readings of that light, and their number.
const PWM_TIME: (u8, u16) = (0, 359);
const PWM_READINGS: usize = 40;
const PWM_GAIN: f32 = 8.0;

/// The lamps, by label, name of the CIE and illuminance in lux.
pub const LAMPS: [(&str, &str, f32); 6] = [
    ("A", "A", 200.0),
    ("D65", "D65", 500.0),
    ("FL2", "FL2", 300.0),
    ("FL11", "FL11", 400.0),
    ("LED-B3", "LED-B3", 350.0),
    ("HP1", "HP1", 150.0),
];

/// Returns a lamp, in W/m2/nm, that gives an illuminance.
pub fn lamp(name: &str, lux: f32) -> Fine<Power> {
    let light = light::named(name).unwrap_or(Fine::flat(0.0));
    at(lux, &light)
}

/// Returns a light emitting diode at 525 nm, 30 nm wide, that gives an illuminance.
pub fn green_led(lux: f32) -> Fine<Power> {
    let [shape] = *gaussian_responsivities::<1, 471, Nodes<360, 830>>([(525.0, 30.0)]).weights();
    at(lux, &Fine::from_bins(shape))
}

fn at(lux: f32, light: &Fine<Power>) -> Fine<Power> {
    let now = illuminance(light);
    Fine::from_bins(light.values().map(|power| if now > 0.0 { power * (lux / now) } else { 0.0 }))
}

/// Returns the basic counts of a light, without noise.
pub fn basic(light: &Fine<Power>) -> [f64; 8] {
    let chip: &Observer<8, 471, Power, Nodes<360, 830>> = &as7341::NOMINAL;
    chip.sees(light).map(|power| COUNTS_PER_W * f64::from(power))
}

/// Returns the log, with a header that says how it was made.
pub fn log() -> String {
    let mut log = Log { text: header(), dice: Dice(SEED), seconds: 0.0 };
    for (label, name, lux) in LAMPS {
        log.settle(label, &basic(&lamp(name, lux)));
    }
    log.settle("dark", &[0.0; 8]);
    log.settle("green LED", &basic(&green_led(300.0)));
    // A reading that is saturated, because its gain was chosen without advice.
    log.row("D65 at a gain too high", &basic(&lamp("D65", 20_000.0)), 512.0, 29, 599);
    log.pulses(&basic(&lamp("LED-B3", 1500.0)));
    log.text
}

fn header() -> String {
    let Noise { electrons_per_count, read_counts } = NOISE;
    format!(
        "# Simulated readings of known lamps, made by nanospectra sensor --simulate (examples/cli/src/sensor/simulate.rs), not measured.\n\
         # Chip: the AS7341 of nanospectra::sensor::chip::as7341, with {COUNTS_PER_W} basic counts for each W/m2 at a channel's peak.\n\
         # Light: CIE illuminants of 200 (A), 500 (D65), 300 (FL2), 400 (FL11), 350 (LED-B3) and 150 lx (HP1); a green LED at\n\
         #   525 nm, 30 nm wide, of 300 lx; D65 of 20000 lx at gain 512. In the reading 'dark' there is no light.\n\
         # Exposure: by AutoExposure on as7341::LADDER, from its middle; each row is the reading after which it stays.\n\
         # Noise: --electrons-per-count {electrons_per_count} --read-counts {read_counts}, by sums of 12 uniform numbers, rounded; seed {SEED:#x}.\n\
         # PWM: LED-B3 of 1500 lx when it is on, {PWM_HZ} Hz, duty {PWM_DUTY}, read every 1.0008 ms without a pause (999.2 Hz),\n\
         #   in all channels at once, which the chip's six converters cannot do.\n\
         # license: CC BY-SA 4.0 (made from CIE data tables)\n\
         time,label,gain,atime,astep,f1,f2,f3,f4,f5,f6,f7,f8\n"
    )
}

struct Log {
    text: String,
    dice: Dice,
    seconds: f64,
}

impl Log {
    /// Writes one row, with the first reading after which the exposure stays.
    fn settle(&mut self, label: &str, basic: &[f64; 8]) {
        let Ok(auto) = AutoExposure::new(&as7341::LADDER) else { return };
        let mut place = auto.middle();
        loop {
            let exposure = auto.exposure(place);
            let counts = self.counts(basic, &exposure);
            self.seconds += 1.0;
            let advice = auto.advise(place, &counts);
            if advice.next == place {
                let (_, atime, astep) = as7341::LADDER_SETTINGS[place];
                return self.write(label, &exposure, atime, astep, &counts);
            }
            place = advice.next;
        }
    }

    fn row(&mut self, label: &str, basic: &[f64; 8], gain: f32, atime: u8, astep: u16) {
        let exposure = as7341::exposure(gain, atime, astep);
        let counts = self.counts(basic, &exposure);
        self.seconds += 1.0;
        self.write(label, &exposure, atime, astep, &counts);
    }

    /// Writes readings, one directly after the other, of a light that is on at the start of each period.
    fn pulses(&mut self, on: &[f64; 8]) {
        let (atime, astep) = PWM_TIME;
        let exposure = as7341::exposure(PWM_GAIN, atime, astep);
        let step = f64::from(exposure.time_ms()) / 1000.0 * PWM_HZ;
        // How long the light was on before a moment; both are counted in periods.
        let lit = |periods: f64| periods.floor() * PWM_DUTY + periods.fract().min(PWM_DUTY);
        self.seconds += 1.0;
        let start = self.seconds;
        for k in 0..PWM_READINGS {
            // The first reading begins 0.3 periods after a pulse does.
            let from = 0.3 + k as f64 * step;
            let share = (lit(from + step) - lit(from)) / step;
            let counts = self.counts(&on.map(|value| value * share), &exposure);
            self.seconds = start + k as f64 * f64::from(exposure.time_ms()) / 1000.0;
            self.write("PWM", &exposure, atime, astep, &counts);
        }
    }

    fn counts(&mut self, basic: &[f64; 8], exposure: &Exposure) -> [u16; 8] {
        let sensitivity = f64::from(exposure.gain()) * f64::from(exposure.time_ms());
        basic.map(|value| {
            let count = value * sensitivity;
            let shot = count * f64::from(exposure.gain()) / f64::from(NOISE.electrons_per_count);
            let read = f64::from(NOISE.read_counts).powi(2);
            let noisy = count + (shot + read).sqrt() * self.dice.normal();
            noisy.round().clamp(0.0, exposure.full_scale().into()) as u16
        })
    }

    fn write(&mut self, label: &str, exposure: &Exposure, atime: u8, astep: u16, counts: &[u16; 8]) {
        let (seconds, gain) = (fixed(self.seconds, 7), shortest(exposure.gain()));
        let cells = counts.map(|count| count.to_string()).join(",");
        // Writing to a String cannot fail.
        let _ = writeln!(self.text, "{seconds},{label},{gain},{atime},{astep},{cells}");
    }
}

/// Random numbers that are the same in every run.
struct Dice(u64);

impl Dice {
    fn even(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 53) as f64
    }

    /// Returns a number with a mean of 0 and a variance of 1, which never exceeds 6.
    fn normal(&mut self) -> f64 {
        (0..12).map(|_| self.even()).sum::<f64>() - 6.0
    }
}

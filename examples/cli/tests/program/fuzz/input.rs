//! Generates command lines with the files that they name.

use crate::fuzz::dice::{Dice, Mood};
use crate::fuzz::measure::measure;
use nanospectra::sensor::chip::{self, SettingValues};

/// All values of `--space`.
pub const SPACES: [&str; 8] = ["srgb", "p3", "dci-p3", "bt2020", "adobe", "prophoto", "acescg", "aces2065"];

/// A run of the program: its arguments, what it reads from stdin, and the files in its folder.
#[derive(Default)]
pub struct Run {
    pub arguments: Vec<String>,
    pub stdin: String,
    pub files: Vec<(String, String)>,
}

/// Names of lights, some of which there are not.
pub const LIGHTS: [&str; 9] = ["D65", "A", "FL11", "LED-B3", "FL3.1", "E", "HP1", "d50", "none"];

/// Writes a run of one command.
pub type Author = fn(&mut Dice, &mut Run);

/// The commands of the program.
pub const COMMANDS: [(&str, Author); 5] =
    [("measure", measure), ("sensor", sensor), ("flicker", flicker), ("paint", paint), ("scene", scene)];

/// Returns the run of a command that this seed makes.
pub fn run_of(seed: u64, (command, author): (&str, Author)) -> Run {
    let mut run = Run::default();
    run.give(&[command]);
    author(&mut Dice::new(seed), &mut run);
    run
}

impl Run {
    pub fn give(&mut self, words: &[&str]) {
        self.arguments.extend(words.iter().map(|word| (*word).to_owned()));
    }

    pub fn file(&mut self, name: &str, text: String) {
        self.files.push((name.to_owned(), text));
    }

    /// Gives options that every command with pictures has.
    pub fn report(&mut self, dice: &mut Dice) {
        if dice.once_in(2) {
            self.give(&["--json"]);
        }
        if dice.once_in(3) {
            self.give(&["--svg", "pictures"]);
            if dice.once_in(4) {
                self.give(&["--force"]);
            }
        }
    }
}

/// Returns wavelengths as text: steps of one size or of any, and rarely what is no wavelength.
pub fn wavelengths(dice: &mut Dice) -> Vec<String> {
    let mut nm = dice.between(200.0, 520.0).round();
    let step = [0.1, 1.0, 5.0, 10.0, 33.3, 100.0][dice.below(6)];
    let is_even = !dice.once_in(3);
    let count = if step < 5.0 { 20 + dice.below(300) } else { 2 + dice.below(90) };
    let mut all = Vec::new();
    for _ in 0..count {
        all.push(format!("{nm:.4}"));
        nm += if is_even { step } else { dice.between(0.01, 2.0 * step) };
    }
    if dice.once_in(20) {
        let k = dice.below(all.len());
        all[k] = dice.number(Mood::Wild);
    }
    all
}

/// Returns a table of spectra.
pub fn table(dice: &mut Dice, columns: usize) -> String {
    let mark = dice.of(&[",", ",", ";", "\t", " "]);
    let mood = dice.mood();
    let mut text = String::new();
    if !dice.once_in(4) {
        let names: String = (0..columns).map(|k| format!("{mark}s{k}")).collect();
        text += &format!("{}{names}\n", dice.of(&["nm", "band-nm"]));
    }
    // A row may be the same everywhere, or a line at one wavelength.
    let only = dice.once_in(6).then(|| dice.below(20));
    for (row, nm) in wavelengths(dice).into_iter().enumerate() {
        text += &nm;
        for _ in 0..columns {
            let value = if only.is_some_and(|only| only != row) { "0".into() } else { dice.number(mood) };
            text += &format!("{mark}{value}");
        }
        text.push('\n');
    }
    text
}

fn paint(dice: &mut Dice, run: &mut Run) {
    let mood = dice.mood();
    for _ in 0..1 + dice.below(3) {
        let color = match dice.below(6) {
            0 => format!("#{:06x}", dice.below(1 << 24)),
            _ => {
                let parts: Vec<String> = (0..3)
                    .map(|_| {
                        let sign = if dice.once_in(8) { "-" } else { "" };
                        format!("{sign}{}", dice.number(mood))
                    })
                    .collect();
                parts.join(",")
            }
        };
        if dice.once_in(5) {
            run.stdin += &format!("{color}\n");
        } else {
            run.give(&[&format!("--rgb={color}")]);
        }
    }
    if !run.stdin.is_empty() {
        run.give(&["-"]);
    }
    if dice.once_in(2) {
        run.give(&["--space", dice.of(&SPACES)]);
    }
    if dice.once_in(2) {
        run.give(&["--linear"]);
    }
    if dice.once_in(2) {
        run.give(&["--method", dice.of(&["sigmoid", "basis", "smits"])]);
    } else if dice.once_in(2) {
        run.give(&["--beyond", dice.of(&["nearest", "desaturate"])]);
    }
    if dice.once_in(3) {
        run.give(&["--light", dice.of(&LIGHTS)]);
    }
    if dice.once_in(3) {
        let grids =
            ["nodes:31,400,700", "nodes:36,380,730", "bins:16,380,730", "bins:60,400,700", "bins:36,380,730"];
        run.give(&["--grid", dice.of(&grids)]);
    }
    if dice.once_in(8) {
        run.give(&["--csv"]);
    }
    run.report(dice);
}

/// Returns a table of points for a scene.
fn points(dice: &mut Dice, mood: Mood) -> String {
    // Lamps may be as narrow as a part of a band.
    let mut nm = dice.between(300.0, 750.0);
    let step = [0.5, 4.0, 20.0, 100.0][dice.below(4)];
    let mut rows = Vec::new();
    if dice.once_in(2) {
        rows.push(format!("[{:.3}, 0]", nm - 0.1));
    }
    for _ in 0..2 + dice.below(6) {
        rows.push(format!("[{nm:.3}, {}]", toml(dice.number(mood))));
        nm += dice.between(0.1, step);
    }
    if dice.once_in(2) {
        rows.push(format!("[{nm:.3}, 0]"));
    }
    format!("[{}]", rows.join(", "))
}

/// Returns a number as TOML writes it, where that is possible.
fn toml(number: String) -> String {
    if number.contains(['.', 'e', 'n']) || number.trim().is_empty() { number } else { format!("{number}.0") }
}

fn scene(dice: &mut Dice, run: &mut Run) {
    if dice.once_in(12) {
        run.give(&[dice.of(&["paper", "vest", "wine", "soap", "window", "asphalt", "--list", "none"])]);
        run.report(dice);
        return;
    }
    let mood = dice.mood();
    let share = if dice.once_in(4) { mood } else { Mood::Scaled(0) };
    let mut text = String::from("title = \"t\"\n");
    if dice.once_in(2) {
        let grids =
            ["bins:16,380,730", "bins:31,380,730", "bins:60,380,730", "nodes:36,380,730", "nodes:81,380,780"];
        text += &format!("grid = \"{}\"\n", dice.of(&grids));
    }
    if dice.once_in(4) {
        text += &format!("eye = \"{}\"\n", dice.of(&["CIE 1931", "CIE 1964"]));
    }
    if dice.once_in(3) {
        text += &format!("sensor = \"{}\"\n", chip::ALL[dice.below(chip::ALL.len())].name);
    }
    text += "[lamp]\n";
    text += &match dice.below(4) {
        0 => format!("cie = \"{}\"\n", dice.of(&LIGHTS)),
        1 => format!("blackbody_k = {}\n", toml(dice.number_in(mood, 500.0, 20_000.0))),
        2 => {
            run.file("lamp.csv", table(dice, 1));
            "csv = \"lamp.csv\"\n".into()
        }
        _ => format!("points = {}\n", points(dice, mood)),
    };
    if dice.once_in(2) {
        text += &format!("illuminance_lx = {}\n", toml(dice.number_in(mood, 1e-6, 1e6)));
    }
    for _ in 0..1 + dice.below(4) {
        text += "[[part]]\n";
        text += &part(dice, share);
    }
    run.file("scene.toml", text);
    run.give(&["scene.toml"]);
    if dice.once_in(3) {
        run.give(&["--budget", &dice.number_in(mood, 0.0, 5.0)]);
    }
    run.report(dice);
}

fn part(dice: &mut Dice, mood: Mood) -> String {
    let mut number = |from: f64, to: f64| toml(dice.number_in(mood, from, to));
    let angle = number(0.0, 89.0);
    let [n, k, axis] = [number(1.0, 3.0), number(0.0, 5.0), number(-180.0, 180.0)];
    let [nm, retarded] = [number(0.0, 2000.0), number(0.0, 5000.0)];
    let [a, b, cm, quantum_yield] = [number(0.0, 1.0), number(0.0, 1.0), number(0.0, 10.0), number(0.0, 1.0)];
    match dice.below(9) {
        0 => format!("filter.flat = {a}\n"),
        1 => format!("surface.points = {}\n", points(dice, mood)),
        2 => format!("filter = {{ absorbance_per_cm = {}, path_cm = {cm} }}\n", points(dice, mood)),
        3 => format!("surface.ces = {}\n", dice.below(101)),
        4 => {
            let [absorption, emission] = [points(dice, mood), points(dice, mood)];
            let transmitted = dice.of(&["true", "false"]);
            format!(
                "dye = {{ reflectance = [[380, {a}], [780, {b}]], absorption = {absorption}, emission = {emission}, \
                 quantum_yield = {quantum_yield}, transmitted = {transmitted} }}\n"
            )
        }
        5 => format!("film = {{ n = {n}, thickness_nm = {nm}, angle_deg = {angle}, n_behind = {n} }}\n"),
        6 => format!("mirror = {{ n = {n}, k = {k}, angle_deg = {angle}, axis_deg = {axis} }}\n"),
        7 => format!("polarizer = {{ axis_deg = {axis}, along = {a}, across = {b} }}\n"),
        _ => format!("retarder = {{ path_difference_nm = {retarded}, axis_deg = {axis} }}\n"),
    }
}

fn flicker(dice: &mut Dice, run: &mut Run) {
    let mood = dice.mood();
    run.give(&["waveform", "--rate-hz", &dice.number_in(mood, 100.0, 60_000.0)]);
    if dice.once_in(2) {
        run.give(&["--flicker-hz", &dice.number_in(mood, 0.1, 3000.0)]);
    }
    if dice.once_in(2) {
        run.give(&["--json"]);
    }
    // A few readings again and again, sometimes for longer than 30 s.
    let rows: String =
        (0..1 + dice.below(30)).map(|_| format!("{}\n", dice.number_in(mood, 0.0, 4096.0))).collect();
    let heading = dice.of(&["", "light\n"]);
    let times = if dice.once_in(10) { 40_000 / rows.lines().count() } else { 1 + dice.below(20) };
    run.file("waveform", format!("{heading}{}", rows.repeat(times)));
}

/// The columns and settings of a log: names, and the values that a setting may have.
fn settings(chip: Option<&'static chip::Chip>, dice: &mut Dice, mood: Mood) -> Vec<String> {
    let Some(chip) = chip else {
        let [gain, time] = [dice.number_in(mood, 0.1, 100.0), dice.number_in(mood, 0.1, 1000.0)];
        return vec![gain, time, dice.of(&["65535", "1024", "2147483647", "1"]).to_owned()];
    };
    let value = |dice: &mut Dice, values: &SettingValues| match values {
        SettingValues::OneOf(values) => values[dice.below(values.len())].to_string(),
        SettingValues::UpTo(most) => dice.below(*most as usize + 1).to_string(),
    };
    chip.settings.iter().map(|setting| value(dice, &setting.values)).collect()
}

fn sensor(dice: &mut Dice, run: &mut Run) {
    let mood = dice.mood();
    if dice.once_in(10) {
        run.report_sensor(dice, mood);
        return;
    }
    let chip = if dice.once_in(2) { None } else { Some(chip::ALL[dice.below(chip::ALL.len())]) };
    let channels: Vec<String> = match chip {
        Some(chip) => chip.channels.iter().map(|name| (*name).to_owned()).collect(),
        None => (0..1 + dice.below(4)).map(|k| format!("c{k}")).collect(),
    };
    run.give(&["--sensor", &chip.map_or("custom".into(), |chip| chip.name.to_lowercase())]);
    let names: Vec<&str> = match chip {
        Some(chip) => chip.settings.iter().map(|setting| setting.name).collect(),
        None => vec!["gain", "time_ms", "full_scale"],
    };
    let has_dark = dice.once_in(4);
    let mut heading = vec!["time", "label"];
    heading.extend(&names);
    heading.extend(channels.iter().map(String::as_str));
    let dark: Vec<String> = channels.iter().map(|name| format!("dark_{name}")).collect();
    if has_dark {
        heading.extend(dark.iter().map(String::as_str));
    }
    let mut log = heading.join(",") + "\n";
    let (step, start) = (dice.number_in(mood, 0.0, 0.01).parse().unwrap_or(0.001), dice.between(0.0, 10.0));
    let fixed = dice.once_in(2).then(|| settings(chip, dice, mood));
    let wild = dice.once_in(3);
    for row in 0..1 + dice.below(12) {
        let time: f64 = start * f64::from(u8::from(!dice.once_in(30))) + step * row as f64;
        let set = fixed.clone().unwrap_or_else(|| settings(chip, dice, mood));
        // A time is echoed as it stands, whatever it is.
        let time = if time.is_finite() { format!("{time:e}") } else { "later".into() };
        let mut cells = vec![time, dice.of(&["a", "a", "b"]).to_owned()];
        cells.extend(set);
        for _ in 0..channels.len() * (1 + usize::from(has_dark)) {
            let count = if wild { dice.number(mood) } else { dice.below(5000).to_string() };
            cells.push(count);
        }
        log += &(cells.join(",") + "\n");
    }
    if dice.once_in(3) {
        run.stdin = log;
        run.give(&["-"]);
    } else {
        run.file("log.csv", log);
        run.give(&["log.csv"]);
    }
    let columns = channels.join(",");
    if dice.once_in(2) {
        let mut text = format!("nm,{columns}\n");
        for nm in (380..=780).step_by(20 + dice.below(80)) {
            let cells: String = channels.iter().map(|_| format!(",{}", dice.number(mood))).collect();
            text += &format!("{nm}{cells}\n");
        }
        run.file("curves.csv", text);
        run.give(&["--responsivity", "curves.csv"]);
    }
    if dice.once_in(3) {
        let cells =
            |dice: &mut Dice| channels.iter().map(|_| format!("{},", dice.number(mood))).collect::<String>();
        let text = if dice.once_in(2) {
            let rows: String = ["X", "Y", "Z"].map(|row| format!("{}{row}\n", cells(dice))).concat();
            format!("{columns},row\n{rows}")
        } else {
            let mut text = format!("{columns},X,Y,Z\n");
            for _ in 0..2 + dice.below(12) {
                let xyz = [dice.number(mood), dice.number(mood), dice.number(mood)].join(",");
                text += &format!("{}{xyz}\n", cells(dice));
            }
            text
        };
        run.file("calibration.csv", text);
        run.give(&["--calibration", "calibration.csv"]);
    }
    if dice.once_in(4) {
        run.give(&["--unit", dice.of(&["absolute", "relative"])]);
    }
    run.report_sensor(dice, mood);
}

impl Run {
    fn report_sensor(&mut self, dice: &mut Dice, mood: Mood) {
        for option in ["--electrons-per-count", "--read-counts", "--floor", "--flicker-hz"] {
            if dice.once_in(4) {
                self.give(&[option, &dice.number_in(mood, 0.0, 200.0)]);
            }
        }
        if dice.once_in(2) {
            self.give(&["--json"]);
        }
    }
}

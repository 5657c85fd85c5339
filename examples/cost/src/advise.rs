//! Chooses a grid, a scheme and a number of bands for given lamps and limits from what is on record, and
//! gives the lines of Rust that use them.

use crate::args::Limits;
use crate::counts::Core;
use crate::record::{CLASSES, Choice};
use crate::text::figure;
use nanospectra_cli::failure::{Failure, short};

/// Words that stand for several classes of lamps.
const TOGETHER: [(&str, &[&str]); 3] = [
    ("fl", &["halophosphate", "triphosphor"]),
    ("rooms", &["smooth", "halophosphate", "triphosphor", "led", "hid"]),
    ("all", &CLASSES),
];

/// Returns the best choice within the limits, as text for a terminal.
pub fn advice(choices: &[Choice], limits: &Limits) -> Result<String, Failure> {
    let classes = classes(&limits.lamps)?;
    let error =
        |choice: &Choice| classes.iter().filter_map(|k| choice.mean.get(*k)).copied().fold(0.0, f64::max);
    let core = if limits.core == "m0" { Core::M0 } else { Core::M4F };
    let instructions = |choice: &Choice| choice.instructions(core).unwrap_or(f64::INFINITY);
    if (limits.most_instructions, limits.most_bytes, limits.most_error) == (None, None, None) {
        return Err(Failure::of(
            "--advise",
            "no limit to choose by; give --most-instructions, --most-bytes or --most-error",
        ));
    }
    let fits: Vec<&Choice> = choices.iter().filter(|choice| fits(choice, limits)).collect();
    // The limits are applied one after another, so that the message can name the one that nothing meets, and
    // the choice that comes nearest to it.
    let cheap = within(&fits, "--most-instructions", limits.most_instructions, "instructions", instructions)?;
    let small =
        within(&cheap, "--most-bytes", limits.most_bytes, "bytes of constants", |choice| choice.constants)?;
    let near = within(&small, "--most-error", limits.most_error, "CIEDE2000 in the mean", error)?;
    let by = |choice: &&&Choice| match limits.most_error {
        Some(_) => [instructions(choice), error(choice), choice.constants],
        None => [error(choice), instructions(choice), choice.constants],
    };
    let best = near.iter().min_by(|a, b| by(a).partial_cmp(&by(b)).unwrap_or(std::cmp::Ordering::Equal));
    let best = best.ok_or_else(|| Failure::of("--advise", "nothing is on record; run with --bless"))?;
    Ok(answer(best, &classes))
}

/// Finds the classes that the words name, as indices of [`CLASSES`].
fn classes(words: &[String]) -> Result<Vec<usize>, Failure> {
    let mut found = Vec::new();
    for word in words {
        let names = TOGETHER.iter().find(|(name, _)| name == word).map(|(_, classes)| *classes);
        let one = [word.as_str()];
        for name in names.unwrap_or(&one) {
            let Some(k) = CLASSES.iter().position(|class| class == name) else {
                let all: Vec<&str> = CLASSES.into_iter().chain(TOGETHER.map(|(name, _)| name)).collect();
                return Err(Failure::of(
                    "--lamps",
                    format_args!("{} is no class of lamps; there are {}", short(word), all.join(", ")),
                ));
            };
            if !found.contains(&k) {
                found.push(k);
            }
        }
    }
    Ok(found)
}

/// Whether the crate offers this choice, and it is of the kind that was asked for.
fn fits(choice: &Choice, limits: &Limits) -> bool {
    // Points, and averages without the tails, are on record for comparison only.
    let is_folded = choice.scheme.starts_with("folded");
    let is_offered =
        is_folded || ["averages+tails", "observer parabola", "sRGB product"].contains(&&*choice.scheme);
    let never_negative = ["folded step", "averages+tails"].contains(&&*choice.scheme);
    is_offered && (!limits.light_changes || !is_folded) && (!limits.never_negative || never_negative)
}

/// Returns the choices whose value is at most `most`. If there are none, the error names the nearest one.
fn within<'a>(
    choices: &[&'a Choice],
    option: &str,
    most: Option<f64>,
    unit: &str,
    value: impl Fn(&Choice) -> f64,
) -> Result<Vec<&'a Choice>, Failure> {
    let most = most.unwrap_or(f64::INFINITY);
    let within: Vec<&Choice> = choices.iter().copied().filter(|choice| value(choice) <= most).collect();
    let nearest = choices.iter().min_by(|a, b| value(a).total_cmp(&value(b)));
    match nearest {
        Some(nearest) if within.is_empty() => Err(Failure::of(
            option,
            format_args!(
                "nothing is within {most}; the nearest has {} {unit}: {}",
                exact(value(nearest)),
                nearest.name()
            ),
        )),
        _ => Ok(within),
    }
}

/// A number with all the digits that are needed to give it as a limit.
fn exact(value: f64) -> String {
    value.to_string()
}

/// Describes a choice: its costs, its errors and the lines to write.
fn answer(choice: &Choice, classes: &[usize]) -> String {
    let count = |core| choice.instructions(core).map_or_else(|| "?".to_owned(), |count| count.to_string());
    let mut out = format!(
        "{}\n\n  {} instructions on a Cortex-M4F, {} on a Cortex-M0; {} bytes of constants and {} of each \
         surface\n",
        choice.name(),
        count(Core::M4F),
        count(Core::M0),
        choice.constants,
        choice.surface
    );
    for k in classes {
        out += &format!(
            "  {:<13}  CIEDE2000 {} in the mean, {} at most in 95 % of all, {} at worst\n",
            CLASSES[*k],
            figure(choice.mean[*k]),
            figure(choice.p95[*k]),
            figure(choice.max[*k])
        );
    }
    if !["folded step", "averages+tails"].contains(&&*choice.scheme) {
        out +=
            "  Weights may be negative: under a narrow filter X, Y or Z can be below 0 (--never-negative).\n";
    }
    out + "\n" + &lines(choice)
}

/// The lines of Rust that use a choice.
fn lines(choice: &Choice) -> String {
    let n = choice.bands;
    let grid = format!("Bins<{}>", choice.range.replace("..", ", "));
    let lamp = "CIE_1931.under(&FL11.fine())";
    let folded = |curve| {
        format!(
            "// Your lamp for FL11; worked out by the compiler.\n\
             static EYE: Observer<3, {n}, Factor, {grid}> =\n    \
             {lamp}.fold(Curve::{curve}).with_white_y(100.0);\n\
             \n\
             fn xyz(surface: &Reflectance<{n}, {grid}>) -> [f32; 3] {{\n    EYE.sees(surface)\n}}\n"
        )
    };
    let unfolded = |curve| {
        format!(
            "static EYE: Observer<3, {n}, Power, {grid}> = CIE_1931.fold(Curve::{curve});\n\
             \n\
             fn xyz(light: &Light<{n}, {grid}>, surface: &Reflectance<{n}, {grid}>) -> [f32; 3] {{\n    \
             EYE.sees(light.onto(surface))\n}}\n"
        )
    };
    match choice.scheme.as_str() {
        "folded step" => folded("Step"),
        "folded parabola" => folded("Parabola"),
        "folded spline" => folded("Spline"),
        "observer parabola" => unfolded("Parabola"),
        "averages+tails" => unfolded("Step"),
        _ => "static EYE: Observer<3, 3, Power, RgbBands<Srgb>> = Observer::standard();\n\
              \n\
              fn xyz(light: Rgb<Srgb>, surface: Rgb<Srgb>) -> [f32; 3] {\n    \
              let (light, surface) = \
              (Light::<3, RgbBands<Srgb>>::from_rgb(light), Reflectance::from_rgb(surface));\n    \
              EYE.sees(light.onto(&surface))\n}\n"
            .to_owned(),
    }
}

//! The command line.

use crate::failure::Failure;
use std::path::PathBuf;

const HELP: &str = "\
Scenes:
  A scene is a TOML file: a lamp, the parts that its light meets, in that order, and perhaps a
  sensor. --list names those that come with the program, --print NAME prints one, with comments
  that say what may stand where: save it, change it, give its name. Names of CSV files in it count
  from the folder that it is in.

What is printed:
  The color is that of what leaves the last part: XYZ (Y = 100 for the bare lamp), xy, Lab and the
  sRGB code with the lamp as white (CAT16 to D65), \"clipped\" if no such display has that color.
  White is a perfect white surface under the bare lamp. With illuminance_lx in [lamp] numbers are
  absolute, over the wavelengths of the grid: illuminance and irradiance in front of the first part,
  exitance behind the last, and luminance and radiance if that is matt (Lambert): a surface or a dye
  (unless it is transmitted), with or without filters, polarizers and retarders behind it.
  A sensor's channels are the irradiance weighted by their responsivity, 1 at its peak.
  A dye scatters: light behind it is unpolarized. A film met at an angle is for unpolarized light, and
  refused where mirrors, polarizers or retarders would show the difference.
  The bill has a line for each part: the effect, multiply-adds for walking light through it, bytes
  of its numbers, and by how much the color would change (CIEDE2000) without it. Without means: a
  dye does not glow; mirror, polarizer and retarder treat light as unpolarized; a film is a plate
  without interference; any other part is gone.
  --budget leaves out fluorescence and polarization where the eye would not miss them; the
  difference that is named is that of all that is left out together.

JSON keys:
  scene, title, lamp, eye, grid, wavelengths_nm, lamp_spectrum, leaving_spectrum (lamp's unit,
  W/m2/nm with a level), XYZ, xy (null of black), lab, hex, hex_is_clipped, lamp_hex,
  luminous_factor_percent; absolute: illuminance_lx, irradiance_w_m2, exitance_lm_m2, exitance_w_m2,
  luminance_cd_m2, radiance_w_m2_sr (null without a level; the last two also behind what is not
  matt); sensor: name, channels_nm, channels (weighted irradiance: W/m2 with a level, else the lamp's
  unit times nm), of_lamp (the same over that of the bare lamp, null where that is dark), null without
  one; bill: part, name, kind, effect, multiply_adds, bytes, without_delta_e2000, left_out; walked and
  folded: multiply_adds, bytes (both with the lamp and the three channels of the eye); budget:
  delta_e2000 (allowed), left_out (numbers of parts, from 0), cost_delta_e2000, hex, multiply_adds;
  null without --budget.";

/// Light through a scene: its color, its watts and lumens, and what each effect in it costs.
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub struct Args {
    /// A scene that comes with the program, or a file that ends in .toml; without it --list
    #[arg(value_name = "NAME | FILE.toml")]
    pub scene: Option<String>,

    /// Leave out effects as long as the color changes by no more than this, CIEDE2000
    #[arg(long, value_name = "DE", allow_negative_numbers = true)]
    pub budget: Option<f32>,

    /// Print one JSON object, numbers unrounded
    #[arg(long)]
    pub json: bool,

    /// Also draw it: into FILE.svg, or into a directory (made if missing) as NAME.svg; nothing is overwritten
    #[arg(long, value_name = "DIR | FILE.svg")]
    pub svg: Option<PathBuf>,

    /// Name the scenes that come with the program
    #[arg(long, conflicts_with_all = ["scene", "budget", "json", "svg"])]
    pub list: bool,

    /// Print the TOML of one of them
    #[arg(long, value_name = "NAME", conflicts_with_all = ["scene", "budget", "json", "svg", "list"])]
    pub print: Option<String>,
}

impl Args {
    /// What the command line alone shows to be wrong.
    pub fn check(&self) -> Result<(), Failure> {
        if let Some(budget) = self.budget
            && !(0.0..=1e6).contains(&budget)
        {
            let what = format!("{budget} is no color difference; give 0 or more, 1 is just noticed");
            return Err(Failure::of("--budget", what));
        }
        if self.scene.is_none() && (self.budget.is_some() || self.json || self.svg.is_some()) {
            return Err(Failure::of("scene", "no scene to answer; give a name of --list or a file"));
        }
        Ok(())
    }
}

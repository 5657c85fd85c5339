//! The options of the command `scene`.

use crate::failure::Failure;
use std::path::PathBuf;

const HELP: &str = "\
Scenes:
  A scene is a TOML file with a lamp, the parts that its light meets, in that order, and perhaps a
  sensor. --list names the scenes that come with the program. --print NAME prints one of them, with
  comments that say what a scene can contain. To make a scene of your own, save that text to a file,
  change it, and give the file's name. CSV files that a scene names are looked for in its folder.

Report:
  The color is that of the light behind the last part, with the lamp as white: XYZ (Y = 100 for the
  bare lamp), xy, Lab and an sRGB code, adapted to D65 by CAT16. The code is followed by \"clipped\"
  if the color is outside sRGB. White is a perfect white surface under the bare lamp.
  The light of a lamp is a smooth curve with the averages of the bands. If the lamp is so narrow that
  X, Y or Z of this curve is not above zero, the light is constant within each band. If X, Y or Z is
  still not above zero, as with deep red light, the lamp is no white: there is no Lab, and the color
  is not adapted.
  With illuminance_lx in [lamp], the report also has absolute numbers, over the wavelengths of the
  grid: the illuminance and irradiance in front of the first part and the exitance behind the last.
  Behind a matt (Lambertian) part there are luminance and radiance too. Surfaces are matt, and so are
  dyes that are not transmitted. A filter, polarizer or retarder behind a matt part changes nothing
  about this.
  The values of a sensor's channels are irradiances weighted by their responsivity, which is 1 at the
  peak of each channel.
  Light behind a dye is scattered and thus unpolarized. A film that light meets at an angle is
  computed for unpolarized light. It is refused where a mirror, polarizer, retarder or another such
  film would make the polarization matter.
  The bill has a line for each part: its effect, the multiply-adds that light through it takes, the
  bytes of its numbers, and the color difference (CIEDE2000) that the scene would have without it.
  Without it means that a dye does not emit, that a mirror, polarizer or retarder treats light as
  unpolarized, and that a film is a plate without interference. Any other part is removed.
  --budget leaves out fluorescence and polarization where the color changes by no more than that.
  The color difference it reports is that of everything left out together.

JSON keys:
  scene, title, lamp, eye, grid, wavelengths_nm; lamp_spectrum and leaving_spectrum (averages over
  the bands, in the unit of the lamp, or in W/m2/nm with illuminance_lx); XYZ, xy (null if black),
  lab (null if the lamp is no white), hex, hex_is_clipped, lamp_hex, luminous_factor_percent.
  absolute: illuminance_lx, irradiance_w_m2, exitance_lm_m2, exitance_w_m2, luminance_cd_m2 and
  radiance_w_m2_sr. It is null without illuminance_lx; the last two are null behind what is not
  matt.
  sensor: name, channels_nm, channels (weighted irradiances, in W/m2 with illuminance_lx and else in
  the unit of the lamp times nm) and of_lamp (the same, divided by the values for the bare lamp; null
  where those are 0). It is null without a sensor.
  bill: part, name, kind, effect, multiply_adds, bytes, without_delta_e2000 and left_out, for each
  part.
  walked and folded: multiply_adds and bytes, with the lamp and the three channels of the eye; walked
  takes light through one part after the other, folded through one matrix for all of them.
  budget: delta_e2000 (which was allowed), left_out (the numbers of parts, from 0), cost_delta_e2000,
  hex and multiply_adds. It is null without --budget.
  notes: why values are null, and what is unusual about the numbers.";

/// Follow light through a scene, to its color, its power and the cost of each effect
#[derive(Debug, clap::Args)]
#[command(after_help = HELP)]
pub struct Args {
    /// A scene that comes with the program, or a file that ends in .toml; without one, --list is meant
    #[arg(value_name = "NAME | FILE.toml")]
    pub scene: Option<String>,

    /// Leave out effects as long as the color changes by no more than DE (CIEDE2000)
    #[arg(long, value_name = "DE", allow_negative_numbers = true)]
    pub budget: Option<f32>,

    /// Print one JSON object with unrounded numbers
    #[arg(long)]
    pub json: bool,

    /// Also draw the scene into FILE.svg, or into the directory DIR as NAME.svg. The directory is made if it
    /// is missing. A run that fails leaves no file behind, and no file is overwritten without --force
    #[arg(long, value_name = "DIR | FILE.svg")]
    pub svg: Option<PathBuf>,

    /// Replace a picture that exists already. A link, and a file that is read, are never replaced
    #[arg(long, requires = "svg")]
    pub force: bool,

    /// List the scenes that come with the program
    #[arg(long, conflicts_with_all = ["scene", "budget", "json", "svg"])]
    pub list: bool,

    /// Print the TOML of a scene that comes with the program
    #[arg(long, value_name = "NAME", conflicts_with_all = ["scene", "budget", "json", "svg", "list"])]
    pub print: Option<String>,
}

impl Args {
    /// Refuses what is wrong by the command line alone.
    pub fn check(&self) -> Result<(), Failure> {
        if let Some(budget) = self.budget
            && !(0.0..=1e6).contains(&budget)
        {
            let what = format!("{budget} is not a color difference; give 0 or more (1 is just noticeable)");
            return Err(Failure::of("--budget", what));
        }
        if self.scene.is_none() && (self.budget.is_some() || self.json || self.svg.is_some()) {
            return Err(Failure::of("scene", "no scene is given; give a name of --list or a file"));
        }
        Ok(())
    }
}

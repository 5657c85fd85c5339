//! How the bundled scenes of `nanospectra scene` change on fewer bands.

use super::scenes::{LAMPS, SCENES, under};
use crate::cells::{COUNTED, RANGE, beaten, counted, range};
use crate::report::{Cell, Column, Table};
use model::delta_e::de2000;
use nanospectra::{Bins, Grid, Nodes};
use nanospectra_cli::scene::answer::{Answer, answer_on};

pub fn table() -> Table {
    let mut columns = vec![Column::key("scene", "scene"), Column::key("bands", "bands")];
    columns.extend(RANGE);
    columns.extend([
        Column::figure("beaten_by", "beaten by"),
        Column::figure("walked_multiply_adds", "walked: multiply-adds"),
        Column::figure("folded_multiply_adds", "folded"),
    ]);
    columns.extend(COUNTED);
    Table {
        id: "effects-bands",
        title: "Bundled scenes on fewer bands".into(),
        about: format!(
            "CIEDE2000 between a scene in bins of 380..730 nm and the same scene on the 471 nanometers of \
             the CIE, each with its own white, over {}. Few bands cost accuracy where the effect is not a \
             product band by band (a dye), or where it varies within a band (a film). What the brightener in \
             the paper absorbs below 380 nm is lost at any number of bands from there. Beaten by: how many \
             smaller numbers of bands have a smaller mean. Instructions are those of the folded scene.",
            LAMPS.join(", ")
        ),
        columns,
        rows: SCENES.into_iter().flat_map(of).collect(),
    }
}

/// Returns what is seen of a scene under each lamp.
fn answers<const N: usize, G: Grid>(scene: &str) -> Vec<Answer> {
    let answer = |lamp: &&str| answer_on::<N, G>(&under(scene, lamp).ok()?, "", None).ok();
    LAMPS.iter().filter_map(answer).collect()
}

fn of(scene: &str) -> Vec<Vec<Cell>> {
    let exact = answers::<471, Nodes<360, 830>>(scene);
    let coarse = [
        (8, answers::<8, Bins<380, 730>>(scene)),
        (16, answers::<16, Bins<380, 730>>(scene)),
        (31, answers::<31, Bins<380, 730>>(scene)),
        (60, answers::<60, Bins<380, 730>>(scene)),
        (81, answers::<81, Bins<380, 730>>(scene)),
    ];
    // Every lamp of the study is a white.
    let lab =
        |answer: &Answer| answer.look.lab.map_or([f64::NAN; 3], |lab| [lab.l, lab.a, lab.b].map(f64::from));
    let differences = coarse.each_ref().map(|(_, answers)| -> Vec<f64> {
        answers.iter().zip(&exact).map(|(one, other)| de2000(lab(other), lab(one))).collect()
    });
    let choices: Vec<(f64, f64)> = differences
        .iter()
        .zip(&coarse)
        .map(|(sizes, (bands, _))| (sizes.iter().sum(), f64::from(*bands)))
        .collect();
    let looks = coarse.iter().zip(&differences).zip(beaten(&choices));
    let rows = looks.map(|(((bands, answers), differences), beaten)| {
        let mut row = vec![Cell::key(scene), Cell::key(bands)];
        row.extend(range(differences));
        row.push(beaten);
        let price = |of: fn(&Answer) -> usize| {
            Cell::count(answers.first().and_then(|answer| u32::try_from(of(answer)).ok()))
        };
        row.push(price(|answer| answer.walked.multiply_adds));
        row.push(price(|answer| answer.folded.multiply_adds));
        row.extend(counted(&format!("xyz-{bands}")));
        row
    });
    rows.collect()
}

//! How much the choice of an observer changes a color, as a measure of how small an error should be.

use crate::cells::{DIFFERENCES, summary};
use crate::nanometers::{Lit, for_y_100, world};
use crate::report::{Cell, Column, Table};
use crate::xyz::lamps::CLASSES;
use model::delta_e::de2000;
use model::tables::Observer;

const OTHERS: [(&str, Observer); 3] = [
    ("CIE 1964, 10 degrees", Observer::Cie1964),
    ("CIE 2015, 2 degrees", Observer::Cie2015Deg2),
    ("CIE 2015, 10 degrees", Observer::Cie2015Deg10),
];

pub fn tables(_: usize) -> Vec<Table> {
    let mut columns = vec![Column::key("observer", "observer"), Column::key("lamps", "lamps")];
    columns.extend(DIFFERENCES);
    vec![Table {
        id: "observers",
        title: "Other observers beside CIE 1931".into(),
        about: "CIEDE2000 between the 99 samples as CIE 1931 and as another observer sees them, each with \
                the lamp as its white, by 1 nm sums. The differences between people are of this size, so \
                nobody sees an error that is far smaller."
            .into(),
        columns,
        rows: rows(),
    }]
}

fn rows() -> Vec<Vec<Cell>> {
    let (world, usual) = (world(), Observer::Cie1931.on_cie_grid());
    let mut all = Vec::new();
    for (name, observer) in OTHERS {
        let other = observer.on_cie_grid();
        for class in CLASSES {
            let lights = world.lights.iter().filter(|light| light.class == class);
            let differences = lights.flat_map(|light| {
                let [one, two] =
                    [&usual, &other].map(|cmf| Lit::new(cmf, &light.power, for_y_100(cmf, &light.power)));
                world.ces.iter().map(move |sample| de2000(one.lab(sample), two.lab(sample)))
            });
            let mut row = vec![Cell::key(name), Cell::key(class.name())];
            // A light without any blue has no Lab.
            row.extend(summary(differences.filter(|size| size.is_finite()).collect()));
            all.push(row);
        }
    }
    all
}

//! The list of all studies, in the order of the report.

use crate::report::Table;
use crate::{cct, effects, math, observers, sums, tables, upsample, xyz};

/// A study: its name, and the function that measures it.
pub struct Study {
    /// The name that `--only` takes.
    pub name: &'static str,
    /// Measures the tables of the study. The argument is the number of runs of which each time is the median.
    pub run: fn(usize) -> Vec<Table>,
}

pub const STUDIES: &[Study] = &[
    Study { name: "xyz", run: xyz::tables },
    Study { name: "math", run: math::tables },
    Study { name: "tables", run: tables::tables },
    Study { name: "cct", run: cct::tables },
    Study { name: "upsample", run: upsample::tables },
    Study { name: "observers", run: observers::tables },
    Study { name: "effects", run: effects::tables },
    Study { name: "sums", run: sums::tables },
];

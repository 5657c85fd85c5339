//! Every study, in the order of the report.

use crate::report::Table;
use crate::{cct, effects, maths, observers, sums, tables, upsample, xyz};

/// A question, and what answers it.
pub struct Study {
    /// As `--only` calls it.
    pub name: &'static str,
    pub run: fn(&Effort) -> Vec<Table>,
}

/// How long to look at the clock.
pub struct Effort {
    /// Runs of which a time is the median.
    pub runs: usize,
}

pub const STUDIES: &[Study] = &[
    Study { name: "xyz", run: xyz::tables },
    Study { name: "maths", run: maths::tables },
    Study { name: "tables", run: tables::tables },
    Study { name: "cct", run: cct::tables },
    Study { name: "upsample", run: upsample::tables },
    Study { name: "observers", run: observers::tables },
    Study { name: "effects", run: effects::tables },
    Study { name: "sums", run: sums::tables },
];

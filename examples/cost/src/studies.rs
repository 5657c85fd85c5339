//! Every study, in the order of the report.

use crate::report::Table;
use crate::{cct, effects, math, observers, sums, tables, upsample, xyz};

/// A question, and what answers it.
pub struct Study {
    /// As `--only` calls it.
    pub name: &'static str,
    /// Every time is the median of so many runs.
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

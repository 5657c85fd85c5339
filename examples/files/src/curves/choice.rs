//! Finds the columns that a user names.

use crate::grid::{Column, Grid, quoted};
use crate::options::Choice;
use crate::refusal::{Refusal, Setting};

/// Returns for each grid which of its columns are chosen; none is if nothing is.
pub fn of(grids: &[Grid], choices: &[Choice]) -> Result<Vec<Vec<usize>>, Refusal> {
    let mut chosen = vec![Vec::new(); grids.len()];
    for choice in choices {
        let mut any = false;
        for (grid, chosen) in grids.iter().zip(&mut chosen) {
            if let Choice::Name(name) = choice
                && grid.columns.iter().filter(|column| is_it(column, choice)).count() > 1
            {
                let what = format!("several columns are named {}; give a number", quoted(name));
                return Err(Refusal::of(what).settled_by(Setting::Column));
            }
            if let Some(place) = in_grid(grid, choice) {
                any = true;
                chosen.push(place);
            }
        }
        if !any {
            return Err(unknown(&grids.iter().collect::<Vec<_>>(), choice));
        }
    }
    Ok(chosen)
}

/// Returns the place of a chosen column among those of a grid.
pub fn in_grid(grid: &Grid, choice: &Choice) -> Option<usize> {
    grid.columns.iter().position(|column| is_it(column, choice))
}

fn is_it(column: &Column, choice: &Choice) -> bool {
    match choice {
        Choice::Number(number) => column.place == *number,
        Choice::Name(name) => column.name.as_deref().is_some_and(|known| known.trim() == name.trim()),
    }
}

/// How many names a message has at most.
const MOST_NAMES: usize = 12;

/// Returns the refusal of a choice that no column meets.
pub fn unknown(grids: &[&Grid], choice: &Choice) -> Refusal {
    let columns = || grids.iter().flat_map(|grid| &grid.columns);
    let what = match choice {
        Choice::Number(number) => {
            let last = columns().map(|column| column.place).max().unwrap_or(0);
            format!("there is no column {number}; the last one is {last}")
        }
        Choice::Name(name) => {
            let mut names: Vec<String> =
                columns().filter(|column| column.name.is_some()).map(Column::title).collect();
            let more = names.len().saturating_sub(MOST_NAMES);
            names.truncate(MOST_NAMES);
            let known = match (names.is_empty(), more) {
                (true, _) => "none has a name, so give a number".into(),
                (_, 0) => format!("there are {}", names.join(", ")),
                _ => format!("there are {} and {more} more", names.join(", ")),
            };
            format!("no column is named {}; {known}", quoted(name))
        }
    };
    Refusal::of(what).settled_by(Setting::Column)
}

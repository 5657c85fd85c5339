//! What is written about the crate, and what tests/data/claims.txt says holds it.

use std::fs;
use std::io::{self, Write};
use std::path::Path;
use std::sync::LazyLock;

pub mod entries;
pub mod held;
pub mod numbers;
pub mod renew;
pub mod sections;

use entries::PATH;
use held::Records;
use sections::{ROOT, Texts};

/// What is written and what is on record.
pub struct Claims {
    pub texts: Texts,
    pub table: String,
    pub records: Records,
}

/// As they are today; with NANOSPECTRA_BLESS after every number that moved has been written anew.
pub static TODAY: LazyLock<Claims> = LazyLock::new(|| {
    let mut claims =
        Claims { texts: sections::texts(), table: held::read(PATH), records: Records::of_today() };
    if std::env::var_os("NANOSPECTRA_BLESS").is_some() {
        let before = claims.texts.clone();
        let changes = renew::renew(&mut claims.texts, &mut claims.table, &claims.records);
        let changed = claims.texts.iter().filter(|(file, text)| before[*file] != **text);
        for (file, text) in changed.chain((!changes.is_empty()).then_some((&PATH.to_string(), &claims.table)))
        {
            fs::write(Path::new(ROOT).join(file), text).unwrap_or_else(|error| panic!("{file}: {error}"));
        }
        for change in changes {
            // What is printed by a test that passes is not shown.
            writeln!(io::stderr(), "{change}").expect("a line on stderr");
        }
    }
    claims
});

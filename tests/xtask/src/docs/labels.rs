//! The pages as docs.rs builds them, where items that need a feature say so.

use crate::shell::{Outcome, Shell, root};
use std::fs;

/// A function that needs the feature `libm`, and one that does not.
const PAGES: [(&str, bool); 2] = [("light/fn.blackbody.html", true), ("light/fn.blackbody_with.html", false)];

const LABEL: &str = "Available on <strong>crate feature <code>libm</code></strong> only.";

/// Builds the pages as docs.rs does, without a warning, and looks for the label of the feature `libm`.
pub fn check(shell: &Shell) -> Outcome {
    // (The labels are unstable; docs.rs has a nightly compiler. For the folder see `check` in mod.rs.)
    let shell = shell.again().with("RUSTC_BOOTSTRAP", "1").with("CARGO_TARGET_DIR", "target/docs");
    let shell = shell.with("RUSTDOCFLAGS", "--cfg docsrs -D warnings");
    shell.run("cargo doc --quiet --no-deps --all-features -p nanospectra")?;
    for (page, needs_libm) in PAGES {
        let path = root().join("target/docs/doc/nanospectra").join(page);
        let html = fs::read_to_string(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        if html.contains(LABEL) != needs_libm {
            let verb = if needs_libm { "lacks" } else { "has" };
            return Err(format!("{page} {verb} the label of the feature libm, as docs.rs builds it"));
        }
    }
    Ok(())
}

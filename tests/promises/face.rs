//! README.md is short, and what it shows is part of the package, since crates.io shows it too.

use crate::claims::held::read;
use crate::pages::links;

/// What the package holds, as `include` of Cargo.toml has it.
const PACKAGED: [&str; 3] = ["src/", "tables/", "LICENSE-"];

#[test]
fn the_readme_is_read_in_two_minutes() {
    let readme = read("README.md");
    assert!(readme.len() <= 9_000 && readme.lines().count() <= 130, "{} bytes", readme.len());
    for (k, line) in readme.lines().enumerate() {
        assert!(line.chars().count() <= 120, "README.md:{}: {} characters", k + 1, line.chars().count());
    }
}

#[test]
fn what_the_readme_shows_is_in_the_package() {
    let readme = read("README.md");
    let local: Vec<String> =
        links(&readme).into_iter().filter(|target| !target.starts_with("https://")).collect();
    for target in &local {
        assert!(PACKAGED.iter().any(|folder| target.starts_with(folder)), "{target} is not in the package");
        assert!(!read(target).is_empty());
    }
    assert!(!local.is_empty(), "no picture");
}

//! What the pages of the repository name is there: what their links lead to, files, and what cargo is asked
//! to run.

use std::fs;
use std::path::Path;

use crate::claims::TODAY;
use crate::claims::held::read;
use crate::claims::sections::ROOT;

/// The pages beside the guides.
const PAGES: [&str; 10] = [
    "README.md",
    "CHANGELOG.md",
    ".github/CONTRIBUTING.md",
    "benches/README.md",
    "examples/cli/README.md",
    "examples/files/README.md",
    "examples/web/README.md",
    "examples/web/package/README.md",
    "tables/SOURCES.md",
    "tests/hard/hard_cases.md",
];

const GUIDES: &str = "src/guide";

/// Where the documentation is shown.
const SHOWN: &str = "https://docs.rs/nanospectra/latest/nanospectra/";

/// What programs make when they are run.
const MADE: [&str; 2] = ["benches/peers.json", "examples/web/dist/"];

fn is_there(path: &str) -> bool {
    Path::new(ROOT).join(path).exists()
}

/// What is wrong with the names on a page.
fn faults(page: &str, text: &str) -> Vec<String> {
    let links = links(text).into_iter().filter(|link| !leads_somewhere(page, text, link));
    let files = files(text).filter(|file| !is_there(file));
    let runs = runs(text).filter(|(option, name)| !can_run(option, name));
    let faults = links.map(|link| format!("{page}: the link {link} leads nowhere"));
    let faults = faults.chain(files.map(|file| format!("{page}: there is no {file}")));
    faults.chain(runs.map(|(option, name)| format!("{page}: there is nothing for {option} {name}"))).collect()
}

/// The targets of links and pictures, in each of the ways to write them.
pub fn links(text: &str) -> Vec<String> {
    let after = |start, end| text.split(start).skip(1).filter_map(move |rest: &str| rest.split(end).next());
    let inline = after("](", ')').chain(after("src=\"", '"')).map(str::to_string);
    let bare = after("<http", '>').map(|rest| format!("http{rest}"));
    let defined = text.lines().filter_map(|line| line.strip_prefix('[')?.split_once("]: "));
    inline.chain(bare).chain(defined.map(|(_, target)| target.to_string())).collect()
}

fn leads_somewhere(page: &str, text: &str, link: &str) -> bool {
    let (target, anchor) = link.split_once('#').unwrap_or((link, ""));
    if let Some(shown) = target.strip_prefix(SHOWN) {
        return is_shown(shown.trim_end_matches("index.html").trim_end_matches('/'));
    }
    if target.contains("://") {
        return !target.starts_with("https://docs.rs/nanospectra/");
    }
    if target.is_empty() {
        return anchors(text).any(|known| known == anchor);
    }
    // (In a guide rustdoc finds what is named.)
    let folder = Path::new(page).parent().unwrap_or(Path::new(""));
    page.starts_with(GUIDES) || is_there(&folder.join(target).to_string_lossy())
}

/// Is there such a guide, or such a type? (Types that need a feature are named in this way, since rustdoc
/// finds them only with that feature.)
fn is_shown(page: &str) -> bool {
    let declares = |declaration: &str| {
        let begins = |line: &str| line.trim_start().starts_with(declaration);
        TODAY.texts.iter().any(|(file, text)| file.starts_with("src/") && text.lines().any(begins))
    };
    match (page.strip_prefix("guide"), page.split_once("struct.")) {
        (Some(""), _) => true,
        (Some(name), _) => {
            name.strip_prefix('/').is_some_and(|name| declares(&format!("pub mod {name} {{}}")))
        }
        (_, Some((_, name))) => declares(&format!("pub struct {}", name.trim_end_matches(".html"))),
        _ => false,
    }
}

/// The names of a page's headings, as links have them.
fn anchors(text: &str) -> impl Iterator<Item = String> {
    let headings = text.lines().filter(|line| line.starts_with('#'));
    headings.map(|line| {
        let kept = line.trim_start_matches('#').trim().to_lowercase().replace(' ', "-");
        kept.chars().filter(|c| c.is_alphanumeric() || ['-', '_'].contains(c)).collect()
    })
}

/// Paths from the root of the repository, but for those in which a word in capitals stands for a name.
fn files(text: &str) -> impl Iterator<Item = &str> {
    let folders = ["src/", "tests/", "tables/", "benches/", "examples/"];
    let words = text.split(|c: char| !c.is_ascii_alphanumeric() && !"_./*-".contains(c));
    let stands_for_a_name = |path: &&str| {
        path.split(['/', '_', '.']).any(|word| ["NAME", "FOLDER"].contains(&word)) || path.contains('*')
    };
    words
        .map(|word| word.trim_end_matches(['.', '-']))
        .filter(move |word| folders.iter().any(|folder| word.starts_with(folder)))
        .filter(move |word| !stands_for_a_name(word) && !MADE.iter().any(|made| word.starts_with(made)))
}

/// Options of cargo that name something, each with that name.
fn runs(text: &str) -> impl Iterator<Item = (&str, &str)> {
    let words = text.lines().flat_map(|line| {
        let words: Vec<&str> = line.split(' ').collect();
        (1..words.len()).map(move |k| (words[k - 1], words[k])).collect::<Vec<_>>()
    });
    words
        .map(|(option, name)| {
            (option.trim_start_matches('`'), name.trim_end_matches(|c: char| !c.is_alphanumeric()))
        })
        .filter(|(option, _)| ["-p", "--example", "--bench", "--test", "--bin"].contains(option))
        .filter(|(_, name)| !["", "STATION"].contains(name))
}

fn can_run(option: &str, name: &str) -> bool {
    let places: &[&str] = match option {
        "-p" if name == "nanospectra" => return true,
        "-p" => &["", "examples/", "tests/"],
        "--example" => &["examples/", "examples/files/examples/"],
        "--bench" => &["benches/"],
        "--test" => &["tests/", "benches/tests/", "examples/web/tests/"],
        _ => &["examples/firmware/src/bin/"],
    };
    let name = name.strip_prefix("nanospectra-").unwrap_or(name);
    places.iter().any(|folder| {
        let place = format!("{folder}{name}");
        let ends: &[&str] = if option == "-p" { &["/Cargo.toml"] } else { &[".rs", "/main.rs"] };
        ends.iter().any(|end| is_there(&format!("{place}{end}")))
    })
}

#[test]
fn what_the_pages_name_is_there() {
    let guides = fs::read_dir(Path::new(ROOT).join(GUIDES)).expect("the guides");
    let guides = guides.map(|entry| entry.expect("an entry").file_name().to_string_lossy().into_owned());
    let guides = guides.filter(|name| name.ends_with(".md")).map(|name| format!("{GUIDES}/{name}"));
    let pages = PAGES.map(str::to_string).into_iter().chain(guides);
    let faults: Vec<String> = pages.flat_map(|page| faults(&page, &read(&page))).collect();
    assert!(faults.is_empty(), "{faults:#?}");
}

/// A test that cannot fail proves nothing.
#[test]
fn what_is_not_there_is_found() {
    let good = format!(
        "# The end\n[a](#the-end) [b](tables/SOURCES.md#x) <{SHOWN}guide> [c]({SHOWN}guide/bands)\n\
        [d](https://docs.rs/x) [e]({SHOWN}struct.Samples.html)\n\
        `examples/*.rs`, src/math/NAME.rs, `cargo bench -p nanospectra-benches --bench peers -- --test`\n\
        `cargo run --example lamp_color`, src/lib.rs.\n"
    );
    assert_eq!(faults("README.md", &good), [""; 0]);
    for bad in [
        "[a](#end)",
        "![a](guide/chain.svg)",
        "<img src=\"page.png\">",
        "[a]: page.png",
        "[a](https://docs.rs/nanospectra/latest/nanospectra/guide/band)",
        "<https://docs.rs/nanospectra/latest/nanospectra/guides>",
        "[a](https://docs.rs/nanospectra/latest/nanospectra/struct.Sample1.html)",
        "`examples/web/server.mjs`",
        "cargo run --example lamp",
        "cargo run -p nanospectra-costs",
        "`cargo bench --bench peer`",
    ] {
        assert_eq!(faults("README.md", &format!("{good}\n{bad}\n")).len(), 1, "{bad}");
    }
}

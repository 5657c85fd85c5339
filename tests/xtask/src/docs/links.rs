//! The links of the pages. Rustdoc finds items that are not there, but neither headings nor pages that are
//! written as addresses.

use crate::shell::{Outcome, Shell, root};
use std::collections::{BTreeMap, HashSet};
use std::fs;
use std::path::{Component, Path, PathBuf};

/// The anchor of a hidden item, to which rustdoc itself links.
const HIDDEN: [&str; 1] = ["associatedconstant.KIND"];

/// Fails if a link on a page that `labels::check` has built leads to no page, or to no place on it.
pub fn check(shell: &Shell) -> Outcome {
    let mut pages = BTreeMap::new();
    read_pages(&root().join("target/docs/doc/nanospectra"), Path::new(""), &mut pages)?;
    let faults = faults(&pages);
    faults.iter().for_each(|fault| shell.say(fault));
    if faults.is_empty() { Ok(()) } else { Err(format!("{} links lead nowhere", faults.len())) }
}

/// Reads all pages below a folder, but those that show the source.
fn read_pages(folder: &Path, below: &Path, pages: &mut BTreeMap<PathBuf, String>) -> Outcome {
    let unread = |error: std::io::Error| format!("{}: {error}", folder.display());
    for entry in fs::read_dir(folder).map_err(unread)? {
        let entry = entry.map_err(unread)?;
        let (path, name) = (entry.path(), below.join(entry.file_name()));
        if path.is_dir() {
            read_pages(&path, &name, pages)?;
        } else if path.extension().is_some_and(|extension| extension == "html") {
            pages.insert(name, fs::read_to_string(&path).map_err(unread)?);
        }
    }
    Ok(())
}

/// The links to these pages that lead nowhere, each once for a page.
fn faults(pages: &BTreeMap<PathBuf, String>) -> Vec<String> {
    let values = |text, name| str::split(text, name).skip(1).filter_map(|rest: &str| rest.split('"').next());
    let anchors: BTreeMap<&Path, HashSet<&str>> =
        pages.iter().map(|(page, text)| (page.as_path(), values(text, " id=\"").collect())).collect();
    let mut faults = Vec::new();
    for (page, text) in pages {
        let links: HashSet<&str> = values(text, " href=\"").filter(|link| !link.contains(':')).collect();
        for link in links {
            let (target, anchor) = link.split_once('#').unwrap_or((link, ""));
            let target = if target.is_empty() { Some(page.clone()) } else { joined(page, target) };
            // (What is above is of other crates, or shows the source.)
            let Some(target) = target.filter(|target| target.extension().is_some_and(|end| end == "html"))
            else {
                continue;
            };
            let found = anchors
                .get(target.as_path())
                .is_some_and(|known| anchor.is_empty() || known.contains(anchor) || HIDDEN.contains(&anchor));
            if !found {
                faults.push(format!("{}: the link {link} leads nowhere", page.display()));
            }
        }
    }
    faults
}

/// Where a link on a page leads, if that is not above the pages.
fn joined(page: &Path, link: &str) -> Option<PathBuf> {
    let mut path = page.parent()?.to_path_buf();
    for part in Path::new(link).components() {
        let is_below = match part {
            Component::ParentDir => path.pop(),
            Component::Normal(name) => {
                path.push(name);
                true
            }
            _ => true,
        };
        if !is_below {
            return None;
        }
    }
    Some(path)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn links_that_lead_nowhere_are_found() {
        let page = |name: &str, text: &str| (PathBuf::from(name), text.to_owned());
        let lamp = "<h2 id=\"example\"> <a href=\"#example\"> <a href=\"../index.html\"> <a href=\"https://a.b/c#d\">";
        let good = "<a href=\"light/lamp.html#example\"> <a href=\"../libm/index.html#a\"> <a href=\"#\">";
        let pages = |index: &str| {
            faults(&BTreeMap::from([
                page("light/lamp.html", lamp),
                page("index.html", &(good.to_owned() + index)),
            ]))
        };
        assert_eq!(pages(""), [""; 0]);
        for bad in ["#example", "light/lamp.html#examples", "lamp.html", "light/../lamp.html#example"] {
            let fault = format!("index.html: the link {bad} leads nowhere");
            assert_eq!(pages(&format!("<a href=\"{bad}\">")), [fault]);
        }
    }
}

//! The images for boards that prove by linking that no function can panic, and whether they call all of them.

use crate::docs;
use crate::shell::{Outcome, Shell, root};
use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::Path;
use syn::punctuated::Punctuated;
use syn::{Expr, Item, Stmt, Token, Type};

/// The folder of the images. The functions in `CONSTANTS` compute in f64, and their documentation says so.
const IMAGES: &str = "examples/firmware/src/bin/no_panic";
const CONSTANTS: &str = "constants.rs";

/// The functions that are in no image, and why. ` as Trait::method` stands for the method of every type.
const IN_NO_IMAGE: [(&str, &str); 10] = [
    (" as Debug::fmt", "it writes by core::fmt, which can panic"),
    (" as Display::fmt", "it writes by core::fmt, which can panic"),
    (" as Format::format", "it writes to the log of defmt, which the program supplies"),
    (" as Clone::clone", "it copies field by field"),
    (" as PartialEq::eq", "it compares field by field"),
    ("Spectrum as Index::index", "it is documented to panic beyond the end, as arrays do"),
    ("Spectrum as IndexMut::index_mut", "it is documented to panic beyond the end, as arrays do"),
    ("sensor::responsivities", "it is documented to panic, which stops the build where the table is wrong"),
    ("matter::Phosphor as IntoPart", "it is there for the message that a phosphor does not fold"),
    ("math::Std as Math", "it needs std, which no board has"),
];

/// The operators that `operators!` calls.
const OPERATORS: [&str; 10] = [
    "Add::add",
    "Sub::sub",
    "Mul::mul",
    "Div::div",
    "Neg::neg",
    "AddAssign::add_assign",
    "SubAssign::sub_assign",
    "MulAssign::mul_assign",
    "DivAssign::div_assign",
    "Sum::sum",
];

/// Fails if a public function is in no image without a reason, and if an image has one that is not public.
pub fn check(shell: &Shell) -> Outcome {
    let public = docs::functions(shell)?;
    let (mut called, mut constants) = (BTreeSet::new(), BTreeSet::new());
    for file in files(&root().join(IMAGES))? {
        let text = fs::read_to_string(&file).map_err(|error| format!("{}: {error}", file.display()))?;
        let names = names(&text).map_err(|error| format!("{}: {error}", file.display()))?;
        if file.ends_with(CONSTANTS) {
            constants.extend(names.iter().cloned());
        }
        called.extend(names);
    }
    let faults = faults(&public, &called, &constants, &IN_NO_IMAGE);
    faults.iter().for_each(|fault| shell.say(fault));
    shell.say(&format!("{} public functions, {} names in images", public.len(), called.len()));
    if faults.is_empty() { Ok(()) } else { Err(format!("{} faults in the lists of {IMAGES}", faults.len())) }
}

fn files(folder: &Path) -> Outcome<Vec<std::path::PathBuf>> {
    let unread = |error: std::io::Error| format!("{}: {error}", folder.display());
    let mut found = Vec::new();
    for entry in fs::read_dir(folder).map_err(unread)? {
        let path = entry.map_err(unread)?.path();
        if path.is_dir() {
            found.extend(files(&path)?);
        } else if path.extension().is_some_and(|extension| extension == "rs") {
            found.push(path);
        }
    }
    Ok(found)
}

fn faults(
    public: &BTreeMap<String, String>,
    called: &BTreeSet<String>,
    constants: &BTreeSet<String>,
    in_no_image: &[(&str, &str)],
) -> Vec<String> {
    // A method that a trait provides is called for some type.
    let provided = |name: &str| {
        let method = name.rsplitn(3, "::").take(2).collect::<Vec<_>>();
        let [function, of] = method[..] else { return false };
        called.iter().any(|call| call.ends_with(&format!(" as {of}::{function}")))
    };
    // So is one that a trait has for all types of a kind.
    let of_a_kind = |name: &str| name.split_once(" as ").map(|(_, method)| format!("_ as {method}"));
    let kinds: BTreeSet<String> = called.iter().filter_map(|name| of_a_kind(name)).collect();
    let is_excused = |name: &str, excuse: &str| match excuse.strip_prefix(' ') {
        Some(_) => name.ends_with(excuse),
        None => {
            name.starts_with(excuse) && !name[excuse.len()..].starts_with(|next: char| next.is_alphanumeric())
        }
    };
    let mut faults = Vec::new();
    for name in public.keys() {
        let excused = in_no_image.iter().any(|(excuse, _)| is_excused(name, excuse));
        if !excused && !called.contains(name) && !kinds.contains(name) && !provided(name) {
            faults.push(format!("`{name}` is in no image; add a line to {IMAGES}/of"));
        }
    }
    let of_a_trait = |name: &str| name.split_once(" as ").map(|(_, method)| format!("::{method}"));
    for name in called {
        let is_provided = of_a_trait(name).is_some_and(|end| public.keys().any(|name| name.ends_with(&end)));
        let is_of_a_kind = of_a_kind(name).is_some_and(|name| public.contains_key(&name));
        if !public.contains_key(name) && !is_provided && !is_of_a_kind {
            faults.push(format!("`{name}` is in an image, but is no public function by this path"));
        }
        for (excuse, why) in in_no_image.iter().filter(|(excuse, _)| is_excused(name, excuse)) {
            faults.push(format!("`{name}` is in an image, although for `{excuse}` {why}"));
        }
    }
    for name in constants.iter().filter(|name| !name.contains(" as ")) {
        if public.get(name).is_some_and(|docs| !docs.contains("f64")) {
            faults
                .push(format!("`{name}` computes in f64 at run time, which its documentation does not say"));
        }
    }
    for (excuse, _) in in_no_image {
        if !public.keys().any(|name| is_excused(name, excuse)) {
            faults.push(format!("`{excuse}` is no public function any more, so it needs no reason"));
        }
    }
    faults
}

/// The names of the functions in the lists of a file: those in `calls!` and `walks!`, and the operators of
/// the types in `operators!`.
fn names(text: &str) -> syn::Result<BTreeSet<String>> {
    let mut names = BTreeSet::new();
    let functions = syn::parse_file(text)?.items.into_iter().filter_map(|item| match item {
        Item::Fn(function) => Some(function.block.stmts),
        _ => None,
    });
    for statement in functions.flatten() {
        let Stmt::Macro(list) = statement else { continue };
        if list.mac.path.is_ident("calls") || list.mac.path.is_ident("walks") {
            let entries = list.mac.parse_body_with(Punctuated::<Expr, Token![,]>::parse_terminated)?;
            names.extend(entries.iter().filter_map(function_name));
        } else if list.mac.path.is_ident("operators") {
            let types = list.mac.parse_body_with(Punctuated::<Type, Token![,]>::parse_terminated)?;
            let operators =
                types.iter().flat_map(|of| OPERATORS.map(|name| format!("{} as {name}", type_name(of))));
            names.extend(operators);
        }
    }
    Ok(names)
}

/// The name of a function by its path, which may be the left side of `as`.
fn function_name(entry: &Expr) -> Option<String> {
    match entry {
        Expr::Cast(cast) => function_name(&cast.expr),
        Expr::Path(function) => {
            let path = joined(&function.path);
            let Some(of) = &function.qself else { return Some(path) };
            let method = path.rsplitn(3, "::").take(2).collect::<Vec<_>>();
            let [function, of_trait] = method[..] else { return None };
            Some(format!("{} as {of_trait}::{function}", type_name(&of.ty)))
        }
        _ => None,
    }
}

fn type_name(of: &Type) -> String {
    match of {
        Type::Path(path) if path.qself.is_none() => joined(&path.path),
        Type::Reference(reference) => type_name(&reference.elem),
        _ => "_".to_owned(),
    }
}

/// A path without parameters.
fn joined(path: &syn::Path) -> String {
    path.segments.iter().map(|segment| segment.ident.to_string()).collect::<Vec<_>>().join("::")
}

#[cfg(test)]
mod tests {
    use super::*;

    const LISTS: &str = "
        fn all() {
            calls![
                color::Xyz::cct,
                Spectrum::<Power, 31>::averaged as fn(fn(f32) -> f32) -> _,
                <&'static matter::Dye<31> as path::Surface<Lit>>::reflect,
                <[f32; 3] as matter::FilmIndices>::at,
            ];
            walks![path::Scene::<31, 8>::parts];
            operators![color::Rgb<color::Srgb>];
        }
    ";

    #[test]
    fn names_have_no_parameters() {
        let names = names(LISTS).unwrap();
        for name in [
            "color::Xyz::cct",
            "Spectrum::averaged",
            "matter::Dye as Surface::reflect",
            "_ as FilmIndices::at",
            "path::Scene::parts",
            "color::Rgb as Sum::sum",
        ] {
            assert!(names.contains(name), "{name}: {names:#?}");
        }
        assert_eq!(names.len(), 5 + OPERATORS.len());
    }

    #[test]
    fn what_is_missing_or_unknown_is_found() {
        let set = |names: &[&str]| names.iter().map(|name| (*name).to_owned()).collect::<BTreeSet<_>>();
        let docs = |name: &str| if name == "color::gray" { "It computes in f64." } else { "" };
        let public = |names: &[&str]| -> BTreeMap<String, String> {
            names.iter().map(|name| ((*name).to_owned(), docs(name).to_owned())).collect()
        };
        let all =
            public(&["color::gray", "color::Xyz::cct", "color::Xyz as Debug::fmt", "matter::Glass::index"]);
        let excuses = [(" as Debug::fmt", "it writes")];
        let called = set(&["color::gray", "color::Xyz::cct", "matter::Cauchy as Glass::index"]);
        let constants = set(&["color::gray"]);
        assert_eq!(faults(&all, &called, &constants, &excuses), [""; 0]);
        let found =
            |public: &_, called: &_, constants: &_, excuses: &_| faults(public, called, constants, excuses);
        let few = set(&["color::gray"]);
        assert_eq!(found(&all, &few, &constants, &excuses).len(), 2);
        let unknown =
            set(&["color::gray", "color::Xyz::cct", "matter::Cauchy as Glass::index", "color::old"]);
        assert!(found(&all, &unknown, &constants, &excuses)[0].contains("is no public function"));
        let silent = set(&["color::Xyz::cct"]);
        assert!(found(&all, &called, &silent, &excuses)[0].contains("f64"));
        let idle = [(" as Debug::fmt", "it writes"), ("color::new", "it is")];
        assert!(found(&all, &called, &constants, &idle)[0].contains("needs no reason"));
    }
}

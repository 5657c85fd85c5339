//! The public functions of a crate that can run: also the methods of its traits, for each type that has them.

use rustdoc_types::{Attribute, Crate, Id, Impl, Item, ItemEnum, Type, Visibility};
use std::collections::{BTreeMap, HashMap};

/// The functions by their names, with their documentation. A name is the path without parameters, as
/// `color::Xyz::cct`; for a method of a trait with its type, as `matter::OrenNayar as Brdf::f`. What is not a
/// public type or a primitive one is called `_`. Methods that a trait provides are named once, by the trait.
pub fn functions(library: &Crate) -> BTreeMap<String, String> {
    let mut walk = Walk { library, paths: HashMap::new() };
    walk.visit(library.root, "", None);
    walk.functions()
}

struct Walk<'a> {
    library: &'a Crate,
    /// The paths of all public items, each by its first.
    paths: HashMap<Id, String>,
}

impl Walk<'_> {
    /// Finds the paths of an item in this parent and of what is inside of it. `name` is its name there, if
    /// that is not its own.
    fn visit(&mut self, id: Id, parent: &str, name: Option<&str>) {
        let library = self.library;
        let Some(item) = library.index.get(&id) else { return };
        if let ItemEnum::Use(reexport) = &item.inner {
            let Some(target) = reexport.id else { return };
            match library.index.get(&target).map(|item| &item.inner) {
                Some(ItemEnum::Module(module)) if reexport.is_glob => {
                    module.items.iter().for_each(|id| self.visit(*id, parent, None));
                }
                _ => self.visit(target, parent, Some(&reexport.name)),
            }
            return;
        }
        if !matches!(item.visibility, Visibility::Public) || self.paths.contains_key(&id) {
            return;
        }
        let name = name.or(item.name.as_deref()).unwrap_or_default();
        // The crate's name says nothing in the path of each of its items.
        let path = match parent {
            _ if id == library.root => String::new(),
            "" => name.to_owned(),
            _ => format!("{parent}::{name}"),
        };
        self.paths.insert(id, path.clone());
        if let ItemEnum::Module(module) = &item.inner {
            module.items.iter().for_each(|id| self.visit(*id, &path, None));
        }
    }

    fn functions(&self) -> BTreeMap<String, String> {
        let mut found = BTreeMap::new();
        for (id, path) in &self.paths {
            let item = &self.library.index[id];
            match &item.inner {
                ItemEnum::Function(_) => drop(found.insert(path.clone(), docs(item))),
                ItemEnum::Struct(it) => self.blocks(&it.impls, path, &mut found),
                ItemEnum::Enum(it) => self.blocks(&it.impls, path, &mut found),
                ItemEnum::Union(it) => self.blocks(&it.impls, path, &mut found),
                ItemEnum::Trait(it) => {
                    let provided = |function: &rustdoc_types::Function| function.has_body;
                    self.add(&it.items, provided, path, &mut found);
                    self.blocks(&it.implementations, path, &mut found);
                }
                _ => {}
            }
        }
        found
    }

    /// Adds the functions of `impl` blocks that a type or a trait of this path has.
    fn blocks(&self, blocks: &[Id], path: &str, found: &mut BTreeMap<String, String>) {
        for item in blocks.iter().filter_map(|id| self.library.index.get(id)) {
            let ItemEnum::Impl(block) = &item.inner else { continue };
            // What `derive` writes is not looked at, nor what the standard library writes for all types.
            let is_own = !block.is_synthetic && block.blanket_impl.is_none();
            if is_own && !item.attrs.contains(&Attribute::AutomaticallyDerived) {
                self.add(&block.items, |_| true, &self.named(block, path), found);
            }
        }
    }

    /// Adds those of these items that are functions.
    fn add(
        &self,
        items: &[Id],
        wanted: impl Fn(&rustdoc_types::Function) -> bool,
        path: &str,
        found: &mut BTreeMap<String, String>,
    ) {
        for item in items.iter().filter_map(|id| self.library.index.get(id)) {
            let ItemEnum::Function(function) = &item.inner else { continue };
            if matches!(item.visibility, Visibility::Public | Visibility::Default) && wanted(function) {
                let name = item.name.as_deref().unwrap_or_default();
                found.insert(format!("{path}::{name}"), docs(item));
            }
        }
    }

    /// The name of what a block belongs to: the type, and the trait if there is one.
    fn named(&self, block: &Impl, path: &str) -> String {
        let Some(of) = &block.trait_ else { return path.to_owned() };
        let last = of.path.rsplit("::").next().unwrap_or_default();
        format!("{} as {last}", self.type_name(&block.for_))
    }

    fn type_name<'b>(&'b self, of: &'b Type) -> &'b str {
        match of {
            Type::ResolvedPath(path) => self.paths.get(&path.id).map_or("_", |path| path),
            Type::Primitive(name) => name,
            Type::BorrowedRef { type_, .. } => self.type_name(type_),
            _ => "_",
        }
    }
}

fn docs(item: &Item) -> String {
    item.docs.clone().unwrap_or_default()
}

//! The public items of a crate.

use rustdoc_types::{Crate, Id, ItemEnum, StructKind, VariantKind, Visibility};
use std::collections::{HashMap, HashSet};

/// A public item and what is written about it.
pub struct Item<'a> {
    /// The file and the line where it is defined.
    pub place: String,
    /// Its path in the crate, or the crate's name.
    pub path: String,
    pub name: &'a str,
    pub is_module: bool,
    pub docs: &'a str,
    /// The links in the documentation that lead to items.
    pub links: &'a HashMap<String, Id>,
    /// The item whose page shows this one: the type of a method, or the item itself.
    pub page: Id,
    /// Whether it is an item of a trait, which the pages of all types with that trait show too.
    pub is_of_trait: bool,
}

/// All the items that users of a crate see, each once, also if there are several paths to it.
pub fn items(library: &Crate) -> Vec<Item<'_>> {
    let mut walk = Walk { library, seen: HashSet::new(), items: Vec::new() };
    walk.visit(library.root, "", None);
    walk.items
}

struct Walk<'a> {
    library: &'a Crate,
    seen: HashSet<Id>,
    items: Vec<Item<'a>>,
}

impl<'a> Walk<'a> {
    /// Adds an item of this parent and what is inside of it. `page` is the type or the trait that it belongs
    /// to, if it has no page of its own.
    fn visit(&mut self, id: Id, parent: &str, page: Option<Id>) {
        // (What is not in the index is of another crate.)
        let Some(item) = self.library.index.get(&id) else { return };
        match &item.inner {
            ItemEnum::Use(reexport) => {
                let Some(target) = reexport.id else { return };
                match self.library.index.get(&target).map(|item| &item.inner) {
                    Some(ItemEnum::Module(module)) if reexport.is_glob => {
                        self.visit_all(&module.items, parent, None);
                    }
                    _ => self.visit(target, parent, None),
                }
                return;
            }
            ItemEnum::Impl(block) => {
                // Items of a trait are documented there.
                if block.trait_.is_none() {
                    self.visit_all(&block.items, parent, page);
                }
                return;
            }
            _ => {}
        }
        let is_public = matches!(item.visibility, Visibility::Public | Visibility::Default);
        if !is_public || !self.seen.insert(id) {
            return;
        }
        let name = item.name.as_deref().unwrap_or_default();
        let path = match parent {
            "" => name.to_owned(),
            _ => format!("{parent}::{name}"),
        };
        self.items.push(Item {
            place: self.place(id),
            path: path.clone(),
            name,
            is_module: matches!(item.inner, ItemEnum::Module(_)),
            docs: item.docs.as_deref().unwrap_or_default(),
            links: &item.links,
            page: page.unwrap_or(id),
            is_of_trait: page
                .is_some_and(|page| matches!(self.library.index[&page].inner, ItemEnum::Trait(_))),
        });
        // The crate's name says nothing in the path of each of its items.
        let path = if id == self.library.root { "" } else { path.as_str() };
        let page = Some(page.unwrap_or(id));
        match &item.inner {
            ItemEnum::Module(module) => self.visit_all(&module.items, path, None),
            ItemEnum::Struct(it) => {
                if let StructKind::Plain { fields, .. } = &it.kind {
                    self.visit_all(fields, path, page);
                }
                self.visit_all(&it.impls, path, page);
            }
            ItemEnum::Union(it) => {
                self.visit_all(&it.fields, path, page);
                self.visit_all(&it.impls, path, page);
            }
            ItemEnum::Enum(it) => {
                self.visit_all(&it.variants, path, page);
                self.visit_all(&it.impls, path, page);
            }
            ItemEnum::Variant(it) => {
                if let VariantKind::Struct { fields, .. } = &it.kind {
                    self.visit_all(fields, path, page);
                }
            }
            ItemEnum::Trait(it) => self.visit_all(&it.items, path, page),
            _ => {}
        }
    }

    fn visit_all(&mut self, ids: &[Id], parent: &str, page: Option<Id>) {
        ids.iter().for_each(|id| self.visit(*id, parent, page));
    }

    fn place(&self, id: Id) -> String {
        let Some(span) = &self.library.index[&id].span else { return "?".to_owned() };
        let file = span.filename.to_string_lossy();
        match file.split_once("/out/") {
            Some((_, file)) => format!("{file}:{} (written by tables/build.rs)", span.begin.0),
            None => format!("{file}:{}", span.begin.0),
        }
    }
}

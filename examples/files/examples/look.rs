fn main() {
    for path in std::env::args().skip(1) {
        let bytes = std::fs::read(&path).unwrap();
        println!("== {}", path.rsplit('/').next().unwrap());
        match nanospectra_files::read(&bytes, &Default::default()) {
            Ok(r) => {
                for c in r.curves.iter().take(4) {
                    println!(
                        "  {:?} {}..{} n={} v0={}: {}",
                        c.name,
                        c.wavelengths[0],
                        c.wavelengths.last().unwrap(),
                        c.values.len(),
                        c.values[0],
                        c.origin()
                    );
                }
                println!("  curves {} facts {}", r.curves.len(), r.facts.len());
                for n in r.notes {
                    println!("  {:?}: {}", n.kind, n.what);
                }
            }
            Err(e) => println!("  REFUSED {e} [{:?}]", e.setting),
        }
    }
}

//! Small packages written, built and looked at by tests: what a user's program may do and what it becomes.

use std::path::{Path, PathBuf};
use std::process::{Command, Output};

/// A package in cargo's own folder for the files of tests; it shares its build with no other.
pub struct Package {
    pub folder: PathBuf,
}

impl Package {
    /// A package with this manifest, emptied of what an earlier run left.
    pub fn new(name: &str, manifest: &str) -> Package {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join(name);
        for of_the_last_run in ["src", "tables"] {
            let _ = std::fs::remove_dir_all(folder.join(of_the_last_run));
        }
        let package = Package { folder };
        package.write("Cargo.toml", manifest);
        package
    }

    /// A package of binaries that depends on the crate as a user's does.
    pub fn using_the_crate(name: &str, programs: &[(&str, &str)]) -> Package {
        let manifest = format!(
            "[package]\nname = \"{name}\"\nversion = \"0.0.0\"\nedition = \"2024\"\n\n\
             [dependencies]\nnanospectra = {{ path = {:?}, default-features = false }}\n\n\
             [workspace]\n",
            env!("CARGO_MANIFEST_DIR")
        );
        let package = Package::new(name, &manifest);
        for (program, source) in programs {
            package.write(&format!("src/bin/{program}.rs"), source);
        }
        package
    }

    pub fn write(&self, path: &str, text: &str) {
        let path = self.folder.join(path);
        std::fs::create_dir_all(path.parent().expect("a file in a folder")).expect("a folder for the test");
        std::fs::write(&path, text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
    }

    /// Runs cargo there, without the settings that the outer cargo gives to tests.
    pub fn cargo(&self, arguments: &[&str]) -> Output {
        let cargo = std::env::var("CARGO").unwrap_or_else(|_| "cargo".to_string());
        Command::new(cargo)
            .args(arguments)
            .arg("--offline")
            .current_dir(&self.folder)
            .env("CARGO_TARGET_DIR", self.folder.join("target"))
            .env_remove("RUSTFLAGS")
            .env_remove("CARGO_ENCODED_RUSTFLAGS")
            .env_remove("RUSTC_WRAPPER")
            .output()
            .expect("cargo runs")
    }
}

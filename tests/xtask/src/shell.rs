//! Runs commands in a folder, with an environment, and with their output to the terminal or a log.

use crate::toolchain;
use std::env;
use std::ffi::OsString;
use std::fs::File;
use std::io::Write;
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};

/// The result of a task, or the reason why it failed.
pub type Outcome<T = ()> = Result<T, String>;

/// Returns the root of the repository.
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("../..")
        .canonicalize()
        .expect("this package is in tests/xtask")
}

/// Starts commands at the root of the repository with the compiler that the records belong to.
#[derive(Default)]
pub struct Shell {
    folder: &'static str,
    variables: Vec<(&'static str, OsString)>,
    log: Option<File>,
}

impl Shell {
    pub fn new() -> Self {
        // Random tests draw the same cases every time, so that a failure is due to the change. Another seed
        // tries others.
        let seed = env::var_os("PROPTEST_RNG_SEED").unwrap_or_else(|| "1".into());
        let shell = Self::default().with("RUSTUP_TOOLCHAIN", toolchain::OF_RECORDS);
        // Every installation is printed, so rustup must not install anything by itself.
        shell.with("RUSTUP_AUTO_INSTALL", "0").with("PROPTEST_RNG_SEED", seed)
    }

    /// Writes what commands print to this file instead of the terminal.
    pub fn logging(mut self, log: File) -> Self {
        self.log = Some(log);
        self
    }

    /// Sets an environment variable for the commands.
    pub fn with(mut self, name: &'static str, value: impl Into<OsString>) -> Self {
        self.variables.push((name, value.into()));
        self
    }

    /// Runs the commands in a folder below the root.
    pub fn at(self, folder: &'static str) -> Self {
        Shell { folder, ..self }
    }

    /// Makes a copy, whose settings can be changed.
    pub fn again(&self) -> Self {
        Shell { folder: self.folder, variables: self.variables.clone(), log: self.log() }
    }

    fn log(&self) -> Option<File> {
        self.log.as_ref().map(|log| log.try_clone().expect("the log is open"))
    }

    /// Prints a line where the output of commands goes.
    pub fn say(&self, line: &str) {
        match self.log() {
            Some(mut log) => writeln!(log, "{line}").expect("the log takes it"),
            None => println!("{line}"),
        }
    }

    /// Prints a command with the environment variables that not all commands have.
    fn announce(&self, line: &str) {
        let shared = Self::new();
        let own =
            self.variables.iter().filter(|(name, _)| shared.variables.iter().all(|(other, _)| other != name));
        let variables: String =
            own.map(|(name, value)| format!("{name}={:?} ", value.to_string_lossy())).collect();
        self.say(&format!("$ {variables}{line}"));
    }

    /// Runs a program with arguments, separated by spaces.
    pub fn run(&self, line: &str) -> Outcome {
        self.announce(line);
        self.finish(self.command(line.split_whitespace()), line)
    }

    /// Runs a line of bash.
    pub fn bash(&self, line: &str) -> Outcome {
        self.announce(line);
        self.finish(self.command(["bash", "-c", line]), line)
    }

    /// Runs the tests that a filter selects, and fails if it selects none.
    pub fn filtered(&self, line: &str) -> Outcome {
        self.announce(line);
        let text = self.output(line)?;
        self.say(&text);
        let ran =
            text.lines().any(|line| line.starts_with("test result: ok.") && !line.contains(" 0 passed"));
        if ran { Ok(()) } else { Err(format!("`{line}` ran no test; correct the filter")) }
    }

    /// Runs a program and returns what it prints to standard output.
    pub fn output(&self, line: &str) -> Outcome<String> {
        let output = self.command(line.split_whitespace()).stderr(Stdio::inherit()).output();
        let output = output.map_err(|error| format!("`{line}` does not start: {error}"))?;
        let text = String::from_utf8_lossy(&output.stdout).into_owned();
        if output.status.success() { Ok(text) } else { Err(format!("`{line}` failed:\n{text}")) }
    }

    /// Returns whether a program succeeds, without its output.
    pub fn succeeds(&self, line: &str) -> bool {
        let mut command = self.command(line.split_whitespace());
        command.stdout(Stdio::null()).stderr(Stdio::null()).status().is_ok_and(|status| status.success())
    }

    /// Returns a program with arguments, which has not been started.
    pub fn command<'a>(&self, words: impl IntoIterator<Item = &'a str>) -> Command {
        let mut words = words.into_iter();
        let mut command = Command::new(words.next().expect("a program"));
        command.args(words).current_dir(root().join(self.folder)).stdin(Stdio::null());
        command.envs(self.variables.iter().map(|(name, value)| (name, value)));
        command
    }

    fn finish(&self, mut command: Command, line: &str) -> Outcome {
        if let (Some(out), Some(err)) = (self.log(), self.log()) {
            command.stdout(out).stderr(err);
        }
        match command.status() {
            Ok(status) if status.success() => Ok(()),
            Ok(status) => Err(format!("`{line}` failed ({status})")),
            Err(error) => Err(format!("`{line}` does not start: {error}")),
        }
    }
}

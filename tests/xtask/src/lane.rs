//! Runs steps one after the other, optionally a second lane of them at the same time, and reports at the end.

use crate::shell::{Outcome, Shell, root};
use std::fs::{self, File};
use std::time::{Duration, Instant};

/// Steps that run one after the other. If one fails, the others still run.
pub struct Lane {
    only: Option<String>,
    start: Instant,
    beside: bool,
    shell: Shell,
    took: Vec<(String, Duration)>,
    failed: Vec<String>,
    skipped: Vec<String>,
}

impl Lane {
    /// Makes a lane that prints to the terminal and runs all steps, or those whose names contain a text.
    pub fn new(only: Option<String>) -> Self {
        let (took, failed, skipped) = Default::default();
        Lane { only, start: Instant::now(), beside: false, shell: Shell::new(), took, failed, skipped }
    }

    /// Sets an environment variable for every step.
    pub fn with(mut self, name: &'static str, value: &str) -> Self {
        self.shell = self.shell.with(name, value);
        self
    }

    /// Runs a step, unless `only` excludes it.
    pub fn step(&mut self, name: &str, task: impl FnOnce(&Shell) -> Outcome) {
        if self.only.as_ref().is_some_and(|only| !name.contains(only.as_str())) {
            return;
        }
        self.say(&format!("\n== {name} (after {} s)", self.start.elapsed().as_secs()));
        let begin = Instant::now();
        let outcome = task(&self.shell);
        let took = begin.elapsed();
        self.took.push((name.to_owned(), took));
        match outcome {
            Ok(()) => self.say(&format!("== done in {} s: {name}", took.as_secs())),
            Err(why) => {
                self.say(&format!("== FAILED after {} s: {name}: {why}", took.as_secs()));
                self.failed.push(format!("{name}: {why}"));
            }
        }
    }

    /// Runs a step of one command.
    pub fn run(&mut self, name: &str, line: &str) {
        self.step(name, |shell| shell.run(line));
    }

    /// Notes a check that cannot be made here, and why.
    pub fn skip(&mut self, what: impl Into<String>) {
        self.skipped.push(what.into());
    }

    /// Runs another lane at the same time as this one, since most steps leave a core idle now and then. The
    /// other lane writes to a file in `target`, which is printed when both have finished.
    pub fn beside(&mut self, other: impl FnOnce(&mut Lane) + Send, this: impl FnOnce(&mut Lane)) -> Outcome {
        fs::create_dir_all(root().join("target")).map_err(|error| format!("target: {error}"))?;
        let path = root().join("target/xtask-beside.log");
        let file = File::create(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let mut beside = Lane {
            start: self.start,
            shell: self.shell.again().logging(file),
            beside: true,
            ..Lane::new(self.only.clone())
        };
        std::thread::scope(|scope| {
            scope.spawn(|| other(&mut beside));
            this(self);
        });
        let log = fs::read(&path).map_err(|error| format!("{}: {error}", path.display()))?;
        let log = String::from_utf8_lossy(&log);
        println!("\n== output of the steps that ran at the same time\n{log}");
        // The scripts for devices and for the web report themselves what they skipped.
        let said = log.lines().filter_map(|line| line.strip_prefix("SKIPPED "));
        self.skipped.extend(said.map(|what| what.trim().to_owned()));
        self.took.append(&mut beside.took);
        self.failed.append(&mut beside.failed);
        self.skipped.append(&mut beside.skipped);
        Ok(())
    }

    /// Prints how long the steps took, what was skipped and what failed.
    pub fn report(mut self) -> Outcome {
        if self.took.is_empty() {
            return Err("no step has this text in its name; give another one to --only".to_owned());
        }
        println!("\n== the time that each step took, the longest first");
        self.took.sort_by_key(|(_, took)| std::cmp::Reverse(*took));
        for (name, took) in &self.took {
            println!("{:6} s  {name}", took.as_secs());
        }
        for what in &self.skipped {
            println!("SKIPPED  {what}");
        }
        for what in &self.failed {
            println!("FAILED   {what}");
        }
        let seconds = self.start.elapsed().as_secs();
        if !self.failed.is_empty() {
            return Err(format!("{} of {} steps failed, in {seconds} s", self.failed.len(), self.took.len()));
        }
        match self.skipped.len() {
            0 => println!("\n== all passed, in {seconds} s"),
            count => println!("\n== passed, in {seconds} s, but {count} checks were skipped"),
        }
        Ok(())
    }

    /// Prints a line about a step to the terminal, and to the log of this lane if it has one.
    fn say(&self, line: &str) {
        if self.beside {
            println!("{}", line.trim_start().replace("==", "== second lane:"));
        }
        self.shell.say(line);
    }
}

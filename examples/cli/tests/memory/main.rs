//! The memory of the program follows what it must keep: each command at two sizes, by counted allocations.
//!
//! This harness is the program, too. It runs itself with a command line of the program, under an allocator
//! that counts, and reads how many bytes were in use at most.

mod counting;
mod inputs;

use counting::Counting;
use std::env;
use std::path::{Path, PathBuf};
use std::process::{Command, ExitCode, Stdio};

#[global_allocator]
static ALLOCATOR: Counting = Counting;

/// If this variable is set, the harness is the program, and it writes its counts to the file of this name.
const AS_PROGRAM: &str = "NANOSPECTRA_COUNTS_TO";

/// A row of the growth table.
struct Case {
    name: &'static str,
    /// The arguments before the file.
    arguments: &'static [&'static str],
    /// Makes the input for a size.
    input: fn(usize) -> String,
    /// Two sizes, of which the second is four times the first.
    sizes: [usize; 2],
    /// How many bytes more may be in use for each one of the size.
    bytes_each: f64,
    /// How many allocations more may be made for each one of the size.
    allocations_each: f64,
}

/// What is kept: a reading of a run keeps its brightness, and one of a waveform itself, in a vector that
/// doubles; a column that is not used keeps its name for the note; an exposure keeps its dark counts; a
/// spectrum keeps its reading, which has a curve of 471 numbers; and a color keeps its numbers and its place.
/// Of anything else, one is in memory at a time.
const CASES: [Case; 14] = [
    Case {
        name: "sensor, a row of one run",
        arguments: &["sensor"],
        input: inputs::one_run,
        sizes: [1000, 4000],
        bytes_each: 8.0,
        allocations_each: 330.0,
    },
    Case {
        name: "sensor --json, a row of one run",
        arguments: &["sensor", "--json"],
        input: inputs::one_run,
        sizes: [1000, 4000],
        bytes_each: 8.0,
        allocations_each: 730.0,
    },
    Case {
        name: "sensor, a row without time",
        arguments: &["sensor"],
        input: inputs::readings,
        sizes: [1000, 4000],
        bytes_each: 0.0,
        allocations_each: 300.0,
    },
    Case {
        name: "sensor, a row of a run of two",
        arguments: &["sensor"],
        input: inputs::short_runs,
        sizes: [1000, 4000],
        bytes_each: 0.0,
        allocations_each: 360.0,
    },
    Case {
        name: "sensor --json, a row beside 500 columns that are not used",
        arguments: &["sensor", "--json"],
        input: inputs::wide_readings,
        sizes: [100, 400],
        bytes_each: 0.0,
        allocations_each: 760.0,
    },
    Case {
        name: "sensor, a column that is not used",
        arguments: &["sensor"],
        input: inputs::columns_of_a_log,
        sizes: [5000, 20000],
        bytes_each: 180.0,
        allocations_each: 3.0,
    },
    Case {
        name: "sensor --dark, a row with an exposure of its own",
        arguments: &["sensor", "--sensor", "custom", "--calibration", "CALIBRATION", "--dark"],
        input: inputs::dark_readings,
        sizes: [1000, 4000],
        bytes_each: 220.0,
        allocations_each: 25.0,
    },
    Case {
        name: "flicker, a reading",
        arguments: &["flicker", "--rate-hz", "1000"],
        input: inputs::waveform,
        sizes: [32_000, 128_000],
        bytes_each: 8.0,
        allocations_each: 0.0,
    },
    // A file is held whole, and its numbers are 8 bytes each.
    Case {
        name: "measure, a row of 15 bytes",
        arguments: &["measure"],
        input: inputs::rows,
        sizes: [30_000, 120_000],
        bytes_each: 85.0,
        allocations_each: 0.0,
    },
    Case {
        name: "measure, a spectrum in a row",
        arguments: &["measure"],
        input: inputs::transposed,
        sizes: [50, 200],
        bytes_each: 5200.0,
        allocations_each: 1900.0,
    },
    Case {
        name: "measure, a column",
        arguments: &["measure"],
        input: inputs::columns,
        sizes: [50, 200],
        bytes_each: 5100.0,
        allocations_each: 1800.0,
    },
    Case {
        name: "measure --svg, a column of the same name",
        arguments: &["measure", "--json", "--reflectance", "--svg", "PICTURES"],
        input: inputs::columns_of_one_name,
        sizes: [50, 200],
        bytes_each: 6000.0,
        allocations_each: 77000.0,
    },
    Case {
        name: "paint, a color",
        arguments: &["paint"],
        input: inputs::colors,
        sizes: [400, 1600],
        bytes_each: 170.0,
        allocations_each: 840.0,
    },
    Case {
        name: "paint --json, a color",
        arguments: &["paint", "--json"],
        input: inputs::colors,
        sizes: [400, 1600],
        bytes_each: 170.0,
        allocations_each: 510.0,
    },
];

fn main() -> ExitCode {
    if let Some(counts) = env::var_os(AS_PROGRAM) {
        let code = nanospectra_cli::main();
        std::fs::write(counts, counting::said()).expect("the counts are written");
        return code;
    }
    let filters: Vec<String> = env::args().skip(1).filter(|word| !word.starts_with('-')).collect();
    let is_wanted = |case: &&Case| filters.is_empty() || filters.iter().any(|word| case.name.contains(word));
    let failed = CASES.iter().filter(is_wanted).filter(|case| !case.holds()).count();
    if failed == 0 { ExitCode::SUCCESS } else { ExitCode::FAILURE }
}

impl Case {
    fn holds(&self) -> bool {
        let [few, many] = self.sizes.map(|size| self.run(size));
        let more = (self.sizes[1] - self.sizes[0]) as f64;
        let [bytes, allocations] = [0, 1].map(|k| (many[k] as f64 - few[k] as f64) / more);
        println!(
            "{:60} {bytes:9.1} bytes each, {allocations:8.1} allocations each, {} in all",
            self.name, many[0]
        );
        // One byte is for numbers that become longer. Less than half is a limit that says too little.
        // A larger input may need a few allocations less, as buffers grow by other steps.
        let fits = |found: f64, limit: f64| found <= limit.max(1.0) && found.max(0.0) >= limit / 2.0;
        let holds = fits(bytes, self.bytes_each) && fits(allocations, self.allocations_each);
        if !holds {
            println!(
                "    the limits are {} bytes and {} allocations",
                self.bytes_each, self.allocations_each
            );
        }
        holds
    }

    /// Returns the largest number of bytes in use and the number of allocations.
    fn run(&self, size: usize) -> [usize; 2] {
        let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("memory");
        let pictures = folder.join("pictures");
        let _ = std::fs::remove_dir_all(&pictures);
        std::fs::create_dir_all(&folder).expect("a scratch directory");
        let file = |name: &str, text: &str| -> PathBuf {
            let path = folder.join(name);
            std::fs::write(&path, text).expect("a scratch file");
            path
        };
        let input = file("input.csv", &(self.input)(size));
        let calibration = file("calibration.csv", inputs::CALIBRATION);
        let counts = folder.join("counts");
        let mut command = Command::new(env::current_exe().expect("this file"));
        for argument in self.arguments {
            match *argument {
                "CALIBRATION" => command.arg(&calibration),
                "PICTURES" => command.arg(&pictures),
                word => command.arg(word),
            };
        }
        let paints = self.arguments[0] == "paint";
        let read = std::fs::File::open(&input).expect("it was written");
        command.arg(if paints { Path::new("-") } else { &input });
        if self.arguments.contains(&"--dark") {
            command.arg(file("log.csv", inputs::DARK_LOG));
        }
        let status = command.env(AS_PROGRAM, &counts).stdin(read).stdout(Stdio::null()).status();
        assert!(status.expect("it runs").success(), "{}", self.name);
        let counts = std::fs::read_to_string(counts).expect("the counts");
        let numbers: Vec<usize> =
            counts.split_whitespace().map(|word| word.parse().expect("a number")).collect();
        numbers.try_into().expect("two numbers")
    }
}

use std::process::ExitCode;

fn main() -> ExitCode {
    nanospectra_cli::main()
}

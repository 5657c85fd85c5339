//! How the program ends when nobody takes what it writes: exit code 0, 1 or 2.
#![cfg(target_os = "linux")]

use crate::run::Program;
use std::process::Stdio;

/// Each command with arguments that it answers, and the program without a command.
const ANSWERED: [(Program, &[&str]); 7] = [
    (Program("", module_path!()), &[]),
    (Program("measure", module_path!()), &["--json"]),
    (Program("sensor", module_path!()), &[]),
    (Program("sensor", module_path!()), &["--simulate"]),
    (Program("paint", module_path!()), &["0,0,0"]),
    (Program("scene", module_path!()), &["vest"]),
    (Program("scene", module_path!()), &["--list"]),
];

fn helps() -> impl Iterator<Item = (Program, &'static [&'static str])> {
    let options: [&[&str]; 4] = [&["--help"], &["-h"], &["--version"], &["-V"]];
    let commands = ["", "measure", "sensor", "flicker", "paint", "scene"];
    commands.into_iter().flat_map(move |name| options.map(|option| (Program(name, module_path!()), option)))
}

#[test]
fn what_a_full_disk_does_not_take_is_exit_code_1() {
    for (command, arguments) in ANSWERED.into_iter().chain(helps()) {
        let failed = command.run_in_shell("", "> /dev/full", arguments);
        let said = (failed.code, failed.err.lines().count());
        assert_eq!(said, (Some(1), 1), "{} {arguments:?}: {}", command.0, failed.err);
        assert!(failed.err.starts_with("stdout: the output cannot be written"), "{}", failed.err);
        let silent = command.run_in_shell("", "> /dev/full 2> /dev/full", arguments);
        assert_eq!(silent.code, Some(1), "{} {arguments:?}", command.0);
    }
}

#[test]
fn what_nobody_reads_is_no_error() {
    for (command, arguments) in ANSWERED.into_iter().chain(helps()) {
        let mut child = command.start(arguments, Stdio::piped());
        drop((child.stdout.take(), child.stdin.take()));
        let output = child.wait_with_output().expect("it ends");
        assert_eq!((output.status.code(), output.stderr), (Some(0), vec![]), "{} {arguments:?}", command.0);
        for closed in [">&-", "<&- >&- 2>&-", "> /dev/null 2> /dev/full"] {
            assert_eq!(command.run_in_shell("", closed, arguments).code, Some(0), "{} {closed}", command.0);
        }
    }
}

#[test]
fn a_refusal_that_cannot_be_said_is_a_refusal_still() {
    for command in ["", "measure", "sensor", "flicker", "paint", "scene"] {
        for arguments in [&["--no-such-option"][..], &["no such word\u{1b}"]] {
            let command = Program(command, module_path!());
            for streams in ["2> /dev/full", "2>&-", ">&- 2>&-", "> /dev/full 2> /dev/full", "<&-"] {
                let ended = command.run_in_shell("", streams, arguments);
                assert_eq!(ended.code, Some(2), "{} {arguments:?} {streams}", command.0);
            }
            let mut child = command.start(arguments, Stdio::null());
            drop((child.stderr.take(), child.stdin.take()));
            assert_eq!(child.wait().expect("it ends").code(), Some(2), "{} {arguments:?}", command.0);
        }
    }
}

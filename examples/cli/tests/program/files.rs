//! The files that the commands write: whole or not there, and never in the place of another.

use crate::run::{Outcome, Program, assert_refused, files};
use std::fs;
use std::path::Path;
use std::process::Stdio;

const MEASURE: Program = Program("measure", module_path!());
const PAINT: Program = Program("paint", module_path!());
const SCENE: Program = Program("scene", module_path!());

/// Each command that draws, with what it draws and the name of that file in the directory of --svg.
const DRAWING: [(Program, &[&str], &str); 3] = [
    (MEASURE, &[], "CIE_L41_white_LED.svg"),
    (PAINT, &["1,1,1"], "1-ffffff.svg"),
    (SCENE, &["vest"], "vest.svg"),
];

const TABLE: &str = "nm,v\n400,1\n700,1\n";

fn text(path: &Path) -> &str {
    path.to_str().expect("UTF-8")
}

/// Draws into a directory, with these options besides.
fn draw(command: &Program, arguments: &[&str], directory: &Path, options: &[&str]) -> Outcome {
    command.run(&[arguments, &["--svg", text(directory)], options].concat())
}

fn assert_is_picture(path: &Path) {
    let picture = fs::read_to_string(path).expect("a picture");
    assert!(picture.starts_with("<svg") && picture.trim_end().ends_with("</svg>"), "{}", path.display());
}

#[test]
fn a_file_is_only_replaced_by_force() {
    let directory = MEASURE.scratch("force");
    for (command, arguments, name) in DRAWING {
        let file = directory.join(name);
        fs::write(&file, "mine").expect("written");
        let refused = draw(&command, arguments, &directory, &[]);
        assert_refused(&refused, &format!("--svg {}: ", file.display()), "exists already");
        assert!(refused.err.contains("--force"), "{}", refused.err);
        assert_eq!(
            (files(&directory), fs::read_to_string(&file).expect("it is there")),
            (vec![name.into()], "mine".into())
        );

        assert_eq!(draw(&command, arguments, &directory, &["--force"]).code, Some(0), "{name}");
        assert_is_picture(&file);
        // It replaces nothing that is not there, too.
        fs::remove_file(&file).expect("it is there");
        assert_eq!(draw(&command, arguments, &directory, &["--force"]).code, Some(0), "{name}");
        assert_eq!(files(&directory), [name]);
        fs::remove_file(&file).expect("it is there");
        command.refuses(&[arguments, &["--force"]].concat(), &format!("{}: ", command.0), "--svg");
    }
}

#[cfg(unix)]
#[test]
fn a_link_is_never_written_through_nor_replaced() {
    let directory = MEASURE.scratch("links");
    let target = MEASURE.file("target.txt", "mine");
    for (command, arguments, name) in DRAWING {
        let link = directory.join(name);
        for target in [target.as_str(), "not-there", text(&directory)] {
            std::os::unix::fs::symlink(target, &link).expect("a link");
            for options in [&[][..], &["--force"]] {
                let refused = draw(&command, arguments, &directory, options);
                assert_refused(
                    &refused,
                    &format!("--svg {}: ", link.display()),
                    "a link, a directory or a device",
                );
                assert_eq!(fs::read_link(&link).expect("a link still"), Path::new(target));
                assert_eq!(files(&directory), [name]);
            }
            fs::remove_file(&link).expect("it is there");
        }
        fs::create_dir(&link).expect("a directory");
        let refused = draw(&command, arguments, &directory, &["--force"]);
        assert_refused(&refused, &format!("--svg {}: ", link.display()), "a link, a directory or a device");
        fs::remove_dir(&link).expect("it is there");
    }
    assert_eq!(fs::read_to_string(target).expect("it is there"), "mine");
}

#[test]
fn what_a_run_reads_is_not_replaced() {
    let directory = MEASURE.scratch("inputs");
    let (input, other) = (directory.join("v.svg"), MEASURE.file("other.csv", TABLE));
    fs::write(&input, TABLE).expect("written");
    let (input, other) = (text(&input), other.as_str());
    let linked = directory.join("another name");
    fs::hard_link(input, &linked).expect("the same file");
    let svg = ["--svg", text(&directory)];
    let refuse = |outcome: &Outcome, file: &str| {
        assert_refused(outcome, &format!("--svg {file}: "), "reads or writes the file itself");
        assert_eq!(fs::read_to_string(file).expect("it is there"), TABLE);
    };
    for force in [&[][..], &["--force"]] {
        let runs: [&[&str]; 4] = [
            &[input],
            &[text(&linked)],
            &[other, "--compare", input],
            &[other, "--reflectance", "--light", input],
        ];
        for arguments in runs {
            refuse(&MEASURE.run(&[arguments, &svg, force].concat()), input);
        }
        let parts = [
            ("csv = \"v.svg\"", "filter.flat = 1"),
            ("cie = \"A\"", "filter.csv = \"v.svg\""),
            ("cie = \"A\"", "surface.csv = \"v.svg\""),
        ];
        for (lamp, part) in parts {
            let scene = directory.join("v.toml");
            let toml = format!("title = \"test\"\n[lamp]\n{lamp}\n[[part]]\n{part}\n");
            fs::write(&scene, toml).expect("written");
            refuse(&SCENE.run(&[&[text(&scene)], &svg[..], force].concat()), input);
        }
    }
    assert_eq!(files(&directory), ["another name", "v.svg", "v.toml"]);
}

#[cfg(target_os = "linux")]
#[test]
fn what_is_standard_input_or_output_is_not_replaced() {
    let directory = MEASURE.scratch("streams");
    let file = directory.join("v.svg");
    fs::write(&file, TABLE).expect("written");
    let arguments = ["-", "--svg", text(&directory), "--force"];
    let place = format!("--svg {}: ", file.display());
    let refused = MEASURE.run_in_shell("", &format!("< '{}'", file.display()), &arguments);
    assert_refused(&refused, &place, "reads or writes the file itself");
    assert_eq!(fs::read_to_string(&file).expect("it is there"), TABLE);

    let other = MEASURE.file("streams.csv", TABLE);
    let refused = MEASURE.run_in_shell("", &format!("< '{other}' > '{}'", file.display()), &arguments);
    assert_refused(&refused, &place, "reads or writes the file itself");
}

/// A limit on the size of files stands for a disk that is full in the middle of a picture.
#[cfg(target_os = "linux")]
#[test]
fn a_picture_that_does_not_fit_leaves_nothing_behind() {
    let directory = MEASURE.scratch("room");
    for (command, arguments, name) in DRAWING {
        for pictures in [directory.join("made/here"), directory.clone()] {
            let arguments = [arguments, &["--svg", text(&pictures)]].concat();
            let refused = command.run_in_shell("trap '' XFSZ; ulimit -f 2", "", &arguments);
            let file = pictures.join(name);
            assert_refused(&refused, &format!("--svg {}: ", file.display()), "cannot be written");
            assert_eq!(files(&directory), [""; 0]);
            // With room the same command succeeds.
            assert_eq!(command.run(&arguments).code, Some(0));
            assert_is_picture(&file);
            fs::remove_dir_all(&directory)
                .and_then(|()| fs::create_dir(&directory))
                .expect("an empty directory");
        }
    }
}

#[cfg(target_os = "linux")]
#[test]
fn a_report_that_cannot_be_printed_leaves_the_files_as_they_were() {
    use std::os::unix::fs::FileTypeExt;
    let directory = MEASURE.scratch("full");
    for (command, arguments, name) in DRAWING {
        for pictures in [directory.join("made/here"), directory.clone()] {
            let failed =
                command.run_in_shell("", "> /dev/full", &[arguments, &["--svg", text(&pictures)]].concat());
            assert_eq!((failed.code, files(&directory)), (Some(1), vec![]), "{}", failed.err);
        }
        fs::write(directory.join(name), "mine").expect("written");
        let forced = [arguments, &["--force", "--svg", text(&directory)]].concat();
        assert_eq!(command.run_in_shell("", "> /dev/full", &forced).code, Some(1));
        assert_eq!(fs::read_to_string(directory.join(name)).expect("it is there"), "mine");
        assert_eq!(files(&directory), [name]);
        fs::remove_file(directory.join(name)).expect("it is there");
    }
    // The program may run as root, to whom nothing is forbidden.
    for device in ["/dev/null", "/dev/full"] {
        let found = fs::symlink_metadata(device).expect("it is there");
        assert!(found.file_type().is_char_device(), "{device}");
    }
}

#[test]
fn of_several_pictures_all_are_drawn_or_none() {
    let directory = MEASURE.scratch("several");
    fs::write(directory.join("b.svg"), "mine").expect("written");
    let input = "nm,a,b,c\n400,1,1,1\n700,1,1,1\n";
    let refused = MEASURE.run_with(input, &["-", "--svg", text(&directory)]);
    assert_refused(&refused, &format!("--svg {}", directory.display()), "exists already");
    assert_eq!(files(&directory), ["b.svg"]);
    MEASURE.says_to(input, &["-", "--svg", text(&directory), "--force"]);
    assert_eq!(files(&directory), ["a.svg", "b.svg", "c.svg"]);
}

#[cfg(unix)]
#[test]
fn others_may_read_a_picture_as_any_new_file() {
    use std::os::unix::fs::PermissionsExt;
    let directory = MEASURE.scratch("mode");
    for (command, arguments, name) in DRAWING {
        let arguments = [arguments, &["--svg", text(&directory)]].concat();
        assert_eq!(command.run_in_shell("umask 027", "", &arguments).code, Some(0));
        let found = fs::metadata(directory.join(name)).expect("it is there");
        assert_eq!(found.permissions().mode() & 0o777, 0o640);
    }
}

#[cfg(unix)]
#[test]
fn a_picture_is_drawn_beside_the_user() {
    let directory = SCENE.scratch("here");
    let setup = format!("cd '{}'", directory.display());
    assert_eq!(SCENE.run_in_shell(&setup, "", &["vest", "--svg", "mine.svg"]).code, Some(0));
    assert_eq!(MEASURE.run_in_shell(&setup, "", &["--svg", "."]).code, Some(0));
    assert_eq!(files(&directory), ["CIE_L41_white_LED.svg", "mine.svg"]);
}

/// The report fills the pipe that nobody reads yet, when the pictures are written but not in their places.
#[test]
fn what_another_program_makes_meanwhile_is_kept() {
    const COLUMNS: usize = 100;
    let names: Vec<String> = (0..COLUMNS).map(|k| format!("s{k}")).collect();
    let ones = ",1".repeat(COLUMNS);
    let table = format!("nm,{}\n400{ones}\n700{ones}\n", names.join(","));
    let table = MEASURE.file("meanwhile.csv", &table);
    for force in [&[][..], &["--force"]] {
        let directory = MEASURE.scratch("meanwhile");
        let other = directory.join("s50.svg");
        let arguments = [&[&table, "--svg", text(&directory)], force].concat();
        let mut child = MEASURE.start(&arguments, Stdio::piped());
        while files(&directory).len() < COLUMNS {
            assert!(child.try_wait().expect("it runs").is_none(), "it waits for its reader");
            std::thread::sleep(std::time::Duration::from_millis(10));
        }
        fs::write(&other, "mine").expect("written");
        let output = child.wait_with_output().expect("it ends");
        if force.is_empty() {
            let message = String::from_utf8(output.stderr).expect("UTF-8");
            assert_eq!(output.status.code(), Some(2));
            assert!(message.starts_with(&format!("--svg {}: ", other.display())), "{message}");
            assert_eq!(files(&directory), ["s50.svg"]);
            assert_eq!(fs::read_to_string(&other).expect("it is there"), "mine");
        } else {
            assert_eq!(output.status.code(), Some(0));
            assert_eq!(files(&directory).len(), COLUMNS);
            assert_is_picture(&other);
        }
    }
}

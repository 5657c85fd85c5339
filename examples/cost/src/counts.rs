//! The instructions and bytes that are on record, as `tests/devices.sh` counted them in QEMU.

/// The record, with one count on each line: "target profile what number unit".
const RECORD: &str = include_str!("../../../tests/data/instructions.txt");

/// The cores on which instructions are counted.
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Core {
    M4F,
    M0,
}

/// How a program is built: opt-level 3 or "s".
#[derive(Clone, Copy, PartialEq, Eq)]
pub enum Profile {
    Release,
    Small,
}

impl Core {
    fn target(self) -> &'static str {
        match self {
            Core::M4F => "thumbv7em-none-eabihf",
            Core::M0 => "thumbv6m-none-eabi",
        }
    }
}

/// Returns the instructions of `what` at opt-level 3, or `None` if they are not on record.
pub fn instructions(core: Core, what: &str) -> Option<u32> {
    instructions_as(core, Profile::Release, what)
}

/// Returns the instructions of `what` as built by `profile`.
pub fn instructions_as(core: Core, profile: Profile, what: &str) -> Option<u32> {
    recorded(core.target(), profile, what, "instructions")
}

/// Returns one number of the record.
pub fn recorded(target: &str, profile: Profile, what: &str, unit: &str) -> Option<u32> {
    let profile = match profile {
        Profile::Release => "release",
        Profile::Small => "small",
    };
    RECORD.lines().find_map(|line| {
        let mut words = line.split_whitespace();
        let here = [target, profile, what].into_iter().all(|word| words.next() == Some(word));
        let number = words.next()?.parse().ok()?;
        (here && words.next() == Some(unit)).then_some(number)
    })
}

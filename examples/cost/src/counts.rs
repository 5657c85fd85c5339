//! Instructions and bytes, as `tests/devices.sh` counted them in QEMU and keeps them on record.

/// "target profile what number unit", one a line.
const RECORD: &str = include_str!("../../../tests/data/instructions.txt");

/// Where instructions are counted.
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

/// Instructions of `what` at opt-level 3; `None` if nobody counted that there.
pub fn instructions(core: Core, what: &str) -> Option<u32> {
    instructions_as(core, Profile::Release, what)
}

/// The same as built by `profile`.
pub fn instructions_as(core: Core, profile: Profile, what: &str) -> Option<u32> {
    recorded(core.target(), profile, what, "instructions")
}

/// One number of the record.
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

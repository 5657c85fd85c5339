//! A simulated AS7341 on an I2C bus, for drivers. It has registers that can be written and read, photodiodes
//! that the multiplexer's 20 bytes connect to converters, and measurements that end at once.

use embedded_hal::delay::DelayNs;
use embedded_hal::i2c::{ErrorKind, ErrorType, I2c, NoAcknowledgeSource, Operation, SevenBitAddress};

const ADDRESS: SevenBitAddress = 0x39;
const ENABLE: usize = 0x80;
const SPECTRAL: u8 = 1 << 1;
const MULTIPLEXER: u8 = 1 << 4;
const ID: usize = 0x92;
const DATA: usize = 0x95;
const STATUS2: usize = 0xa3;
const VALID: u8 = 1 << 6;

/// For F1 to F8, Clear and NIR, the register and the position of the bits in it that choose the converter of
/// the diode (1 to 6, or 0 for none). Each diode has a second half elsewhere, which is always connected
/// alike.
const CONNECTIONS: [(usize, u8); 10] = [
    (0x01, 0),
    (0x05, 0),
    (0x00, 4),
    (0x05, 4),
    (0x06, 4),
    (0x04, 0),
    (0x07, 0),
    (0x03, 4),
    (0x08, 4),
    (0x13, 0),
];

/// The chip, with the counts of its ten photodiodes in the exposure of the recording.
pub struct As7341Registers {
    registers: [u8; 256],
    next: u8,
    diodes: [u16; 10],
}

impl As7341Registers {
    pub fn counting(diodes: [u16; 10]) -> Self {
        let mut registers = [0; 256];
        registers[ID] = 0x24;
        As7341Registers { registers, next: 0, diodes }
    }

    /// Returns the value of a register.
    pub fn register(&self, address: u8) -> u8 {
        self.registers[usize::from(address)]
    }

    fn write(&mut self, value: u8) {
        let address = usize::from(self.next);
        self.registers[address] = value;
        if address == ENABLE {
            // Setting up the multiplexer takes no time here.
            self.registers[ENABLE] &= !MULTIPLEXER;
            self.registers[STATUS2] = if value & SPECTRAL == 0 { 0 } else { VALID };
            if value & SPECTRAL != 0 {
                self.measure();
            }
        }
        self.next = self.next.wrapping_add(1);
    }

    fn measure(&mut self) {
        for ((register, shift), count) in CONNECTIONS.into_iter().zip(self.diodes) {
            let converter = usize::from(self.registers[register] >> shift & 0x0f);
            if (1..=6).contains(&converter) {
                let [low, high] = count.to_le_bytes();
                self.registers[DATA + 2 * converter - 2] = low;
                self.registers[DATA + 2 * converter - 1] = high;
            }
        }
    }

    fn read(&mut self) -> u8 {
        let value = self.registers[usize::from(self.next)];
        self.next = self.next.wrapping_add(1);
        value
    }
}

impl ErrorType for As7341Registers {
    type Error = ErrorKind;
}

impl I2c for As7341Registers {
    /// Writes and reads registers. The first byte that is written is an address; further bytes are written
    /// from there on, and reading starts there.
    fn transaction(
        &mut self,
        address: SevenBitAddress,
        operations: &mut [Operation<'_>],
    ) -> Result<(), ErrorKind> {
        if address != ADDRESS {
            return Err(ErrorKind::NoAcknowledge(NoAcknowledgeSource::Address));
        }
        for operation in operations {
            match operation {
                Operation::Write(bytes) => {
                    if let [address, values @ ..] = *bytes {
                        self.next = *address;
                        values.iter().for_each(|value| self.write(*value));
                    }
                }
                Operation::Read(buffer) => buffer.iter_mut().for_each(|byte| *byte = self.read()),
            }
        }
        Ok(())
    }
}

/// A delay that returns at once.
pub struct NoDelay;

impl DelayNs for NoDelay {
    fn delay_ns(&mut self, _ns: u32) {}
}

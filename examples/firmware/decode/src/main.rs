//! Reads the defmt frames of an image from the standard input and prints them as text. The words are not in
//! the frames but in the image itself: `nanospectra-decode <elf>`. `run.sh` calls it.

use defmt_decoder::{DecodeError, Table};
use std::error::Error;
use std::io::{Read, stdin};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let elf = env::args_os().nth(1).ok_or("usage: nanospectra-decode <elf>")?;
    let table = Table::parse(&fs::read(elf)?)?.ok_or("this image does not log by defmt")?;
    let mut decoder = table.new_stream_decoder();
    let mut chunk = [0; 1024];
    loop {
        let length = stdin().read(&mut chunk)?;
        if length == 0 {
            return Ok(());
        }
        decoder.received(&chunk[..length]);
        loop {
            match decoder.decode() {
                Ok(frame) => println!("{}", frame.display(false)),
                Err(DecodeError::UnexpectedEof) => break,
                Err(DecodeError::Malformed) => return Err("not a frame of this image".into()),
            }
        }
    }
}

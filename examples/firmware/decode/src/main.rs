//! Reads the defmt frames of an image from the standard input and prints them as text. The texts are not in
//! the frames but in the image itself, so it is called as `nanospectra-decode <elf>`. `run.sh` does so.

use defmt_decoder::{DecodeError, Table};
use std::error::Error;
use std::io::{Read, stdin};
use std::{env, fs};

fn main() -> Result<(), Box<dyn Error>> {
    let usage =
        "usage: nanospectra-decode <elf>; prints the defmt log that comes from standard input as text";
    let elf = env::args_os().nth(1).ok_or(usage)?;
    let table = Table::parse(&fs::read(elf)?)?.ok_or("this image has no log by defmt; name one that has")?;
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
                Err(DecodeError::Malformed) => {
                    return Err("the input is not a log of this image; name the image that sent it".into());
                }
            }
        }
    }
}

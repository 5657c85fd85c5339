//! The study of what accuracy costs: its command line, what it has on record, and its pictures.

mod cli;
mod pictures;
mod study;

//! The study of what accuracy costs: its command line, and what it has on record.

mod cli;
mod study;

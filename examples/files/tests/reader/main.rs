//! The reader from outside: what it makes of files as they are written, and of files that are damaged.

mod damage;
mod kinds;
mod layouts;
mod refusals;

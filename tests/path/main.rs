//! Light on its way, by typed paths and by scenes put together at run time.

mod alias;
mod chain;
mod fuzz;
mod own;
mod scene;

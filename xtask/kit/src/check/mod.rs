//! `check`: a program of somebody else's, asked over a pipe; its answers are judged as those of a function that is called.

mod command;
mod driver;
mod json;
mod line;
mod listen;
mod peer;
mod process;

pub(crate) use command::{Arguments, run};

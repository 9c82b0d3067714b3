//! Tests of the commands, in one program.

mod audit;
mod book;
mod check;
mod check_abi;
mod check_elements;
mod check_ports;
mod cli;
mod common;
mod derivatives;
mod export;
mod families;
mod golden;
mod golden_readers;
mod installed;
mod new;
mod port;
mod ports;
mod prose;
mod scene;
mod schema;
mod shells;
mod tidy;
mod user_mpc;
mod vuel;

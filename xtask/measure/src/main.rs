//! Reads a request from standard input and writes what happens to standard output, an event a line.

use measure::{Request, measure};
use std::error::Error;
use std::io::{Write, stdin, stdout};

fn main() -> Result<(), Box<dyn Error>> {
    let request: Request = serde_json::from_reader(stdin().lock())?;
    let mut out = stdout().lock();
    measure(&request, |event| {
        serde_json::to_writer(&mut out, &event)?;
        out.write_all(b"\n")?;
        Ok(out.flush()?)
    })
}

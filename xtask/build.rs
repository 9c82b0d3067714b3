//! Compiles in what the sources of the formulas are, so that an installed program knows whether it may judge a folder.

#[path = "kit/src/sources.rs"]
mod sources;

fn main() {
    println!("cargo::rerun-if-changed=../src");
    println!("cargo::rustc-env=SOURCES={}", sources::sources("..".as_ref()));
}

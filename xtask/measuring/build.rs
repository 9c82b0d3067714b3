//! Passes the compiler and its flags to the program, so that a report can say how it was built.

use std::process::Command;

fn main() {
    let version = || {
        let output = Command::new(std::env::var_os("RUSTC")?).arg("--version").output().ok()?;
        Some(String::from_utf8_lossy(&output.stdout).trim().to_owned())
    };
    let variable = |name: &str| std::env::var(name).unwrap_or_default();
    let flags = variable("CARGO_ENCODED_RUSTFLAGS").replace('\u{1f}', " ");
    println!("cargo::rustc-env=BUILT_BY={}", version().unwrap_or_default());
    println!("cargo::rustc-env=BUILT_FOR={}", variable("TARGET"));
    println!("cargo::rustc-env=BUILT_IN={}, opt-level {}", variable("PROFILE"), variable("OPT_LEVEL"));
    println!("cargo::rustc-env=BUILT_WITH={flags}");
    println!("cargo::rerun-if-changed=build.rs");
}

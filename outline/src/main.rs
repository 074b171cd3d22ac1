//! The command: a drawing in, a `static` and a picture out.

#![cfg(not(target_os = "none"))]

mod command;

fn main() -> std::process::ExitCode {
    command::run()
}

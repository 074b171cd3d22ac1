use std::error::Error;
pub fn write() -> Result<(), Box<dyn Error>> { Ok(()) }

//! A picture as a number.

use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::pixelcolor::raw::ToBytes;
use embedded_lathe::Scene;

const WIDTH: u32 = 128;
const HEIGHT: u32 = 64;

/// The [`hash`] of a scene's picture: of its pixels row by row, each as two bytes, high byte first.
pub fn of(scene: &Scene) -> u64 {
    let picture = scene.picture(WIDTH, HEIGHT);
    let mut row = [Rgb565::new(0, 0, 0); WIDTH as usize];
    hash(
        (0..HEIGHT)
            .flat_map(|y| {
                picture.row(y, &mut row);
                row.map(|color| color.to_be_bytes())
            })
            .flatten(),
    )
}

/// The 64-bit FNV-1a hash of bytes.
pub fn hash(bytes: impl Iterator<Item = u8>) -> u64 {
    bytes.fold(0xcbf2_9ce4_8422_2325, |hash, byte| (hash ^ u64::from(byte)).wrapping_mul(0x0100_0000_01b3))
}

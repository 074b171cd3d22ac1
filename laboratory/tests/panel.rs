//! The emulated board's panel shows what the host draws in the same arithmetic, pixel for pixel: floats here,
//! integers in `integers/tests/panel.rs`.
//!
//! ```text
//! cargo test --test panel -- --ignored --skip write       needs qemu-system-arm and the two targets
//! cargo test --test panel -- --ignored write              docs/panel.png and docs/outlines/vase-panel.png, as the
//!                                                         Cortex-M3's panel shows them
//! ```

#[path = "../../examples/oled/card.rs"]
mod card;
#[path = "../../examples/dial/show.rs"]
mod dial;
#[allow(dead_code)]
#[path = "../../examples/outlines/show.rs"]
mod drawing;
#[allow(dead_code)]
#[path = "../../examples/scenes/mod.rs"]
mod scenes;
#[allow(dead_code)]
#[path = "../../examples/oled/show.rs"]
mod show;

use embedded_graphics::{pixelcolor::Gray4, prelude::*, primitives::Rectangle};
use embedded_graphics_simulator::{OutputSettingsBuilder, SimulatorDisplay};
use laboratory::firmware;
use std::{
    convert::Infallible,
    env, fs,
    io::{BufRead, BufReader, Write},
    path::Path,
    process::{Command, Stdio},
};

/// Frames compared, of each scene.
const FRAMES: [u32; 3] = [0, 1, 7];

type Pixels = [[u8; 128]; 64];

/// The plainest display there can be.
struct Canvas(Pixels);

impl OriginDimensions for Canvas {
    fn size(&self) -> Size {
        Size::new(128, 64)
    }
}

impl DrawTarget for Canvas {
    type Color = Gray4;
    type Error = Infallible;

    fn draw_iter<I: IntoIterator<Item = Pixel<Gray4>>>(&mut self, pixels: I) -> Result<(), Infallible> {
        for Pixel(at, color) in pixels {
            if self.bounding_box().contains(at) {
                self.0[at.y as usize][at.x as usize] = color.luma();
            }
        }
        Ok(())
    }
}

/// The scenes of the examples, each with the example's name.
fn scenes() -> impl Iterator<Item = (&'static str, &'static str)> {
    let oled = show::NAMES.map(|name| ("oled", str::from_utf8(name).unwrap()));
    oled.into_iter().chain([("dial", "turn"), ("outlines", "drawing")])
}

/// What the host draws, up to frame `last` as the firmware does.
fn drawn(scene: &str, last: u32) -> Pixels {
    let mut canvas = Canvas([[0; 128]; 64]);
    let mut screen = dial::Screen::new();
    for n in 0..=last {
        let is_drawn = match scene {
            "turn" => screen.draw(n, &mut canvas),
            "drawing" => drawing::draw(scene.as_bytes(), n, &mut canvas),
            _ => show::draw(scene.as_bytes(), n, &mut canvas),
        };
        is_drawn.expect("the scene is there");
    }
    canvas.0
}

/// What the board's panel shows: the firmware says when it has drawn, then QEMU's monitor saves the picture.
fn shown(target: &str, elf: &Path, example: &str, scene: &str, last: u32) -> Pixels {
    let directory = Path::new(env!("CARGO_TARGET_TMPDIR"));
    let picture = format!("{scene}-{last}-{target}.ppm");
    let cpu = if target == firmware::M3 { "cortex-m3" } else { "cortex-m4" };
    let mut qemu = Command::new("qemu-system-arm")
        .current_dir(directory)
        .args([
            "-machine",
            "lm3s6965evb",
            "-cpu",
            cpu,
            "-display",
            "none",
            "-serial",
            "none",
            "-monitor",
            "stdio",
        ])
        .arg("-semihosting-config")
        .arg(format!("enable=on,target=native,arg={example},arg={scene},arg={last}"))
        .arg("-kernel")
        .arg(elf)
        .stdin(Stdio::piped())
        .stdout(Stdio::piped())
        .spawn()
        .expect("qemu-system-arm starts");

    let mut lines = BufReader::new(qemu.stdout.take().unwrap()).lines().map_while(Result::ok);
    assert!(lines.any(|line| line.ends_with("drawn")), "the firmware draws {scene} {last}");
    write!(qemu.stdin.take().unwrap(), "screendump {picture}\nquit\n").unwrap();
    lines.for_each(drop);
    assert!(qemu.wait().unwrap().success());
    read(&directory.join(picture))
}

/// A binary PPM of the panel, where each pixel is four by four and each gray times 17.
fn read(ppm: &Path) -> Pixels {
    let bytes = fs::read(ppm).unwrap();
    let rgb = bytes.strip_prefix(b"P6\n512 256\n255\n").expect("a picture of the panel's size");
    let at = |x: usize, y: usize| &rgb[3 * (y * 512 + x)..][..3];
    for y in 0..256 {
        for x in 0..512 {
            assert_eq!(at(x, y), [at(x & !3, y & !3)[0]; 3], "gray, and the same all over its pixel");
        }
    }
    std::array::from_fn(|y| std::array::from_fn(|x| at(4 * x, 4 * y)[0] / 17))
}

/// The first pixel that differs.
fn difference(a: &Pixels, b: &Pixels) -> Option<(usize, usize)> {
    (0..64 * 128).map(|i| (i % 128, i / 128)).find(|&(x, y)| a[y][x] != b[y][x])
}

fn compare(target: &str) {
    for (example, scene) in scenes() {
        let elf = &firmware::build(target, example, firmware::SMALL, &[]);
        let mut earlier: Option<Pixels> = None;
        for n in FRAMES {
            let ours = drawn(scene, n);
            let theirs = shown(target, elf, example, scene, n);
            if let Some((x, y)) = difference(&ours, &theirs) {
                panic!(
                    "{scene} {n} on {target}: pixel ({x}, {y}) is {}, drawn as {}",
                    theirs[y][x], ours[y][x]
                );
            }
            assert!(earlier.is_none_or(|e| difference(&e, &ours).is_some()), "{scene} turns");
            earlier = Some(ours);
        }
    }
}

#[test]
#[cfg(embedded_lathe_arithmetic = "integers")]
#[ignore = "needs qemu-system-arm and a target"]
fn cortex_m3_draws_as_the_host() {
    compare(firmware::M3);
}

#[test]
#[cfg(not(embedded_lathe_arithmetic = "integers"))]
#[ignore = "needs qemu-system-arm and a target"]
fn cortex_m4f_draws_as_the_host() {
    compare(firmware::M4F);
}

#[test]
fn one_differing_pixel_is_found() {
    let ours = drawn("vase", 1);
    let mut theirs = ours;
    theirs[63][127] ^= 1;
    assert_eq!(difference(&ours, &ours), None);
    assert_eq!(difference(&ours, &theirs), Some((127, 63)));
}

/// Of a turning knob a frame draws the number and a rectangle of the pointer's size; the panel shows what it shows if
/// all of the knob's picture is drawn.
#[test]
fn a_turning_dial_draws_little() {
    let mut canvas = Canvas([[0; 128]; 64]);
    let mut screen = dial::Screen::new();
    for n in 0..2 * dial::STEPS {
        let before = canvas.0;
        screen.draw(n, &mut canvas).unwrap();
        let mut whole = Canvas(canvas.0);
        let mut anew = dial::Screen::new();
        anew.draw(0, &mut whole).unwrap();
        // The first frame of another screen, which draws all of the picture, and then the second one's rectangle.
        anew.draw(n, &mut whole).unwrap();
        let differ =
            (0..64 * 128).filter(|i| canvas.0[i / 128][i % 128] != whole.0[i / 128][i % 128]).count();
        assert!(differ <= 2, "{differ} pixels differ in frame {n}");
        if n > 0 {
            let area = screen.changed;
            assert!(area.size.width * area.size.height < 68 * 64 / 6, "{area:?}");
            for (x, y) in (0..64).flat_map(|y| (0..128).map(move |x| (x, y))) {
                let is_changed = before[y][x] != canvas.0[y][x];
                let is_within = area.contains(Point::new(x as i32, y as i32)) || x < 60;
                assert!(is_within || !is_changed, "frame {n}: {x}, {y}");
            }
        }
    }
}

/// Three frames of each scene, each pixel four by four.
#[test]
#[ignore = "writes docs/panel.png"]
fn write() {
    let mut sheet = SimulatorDisplay::<Gray4>::new(Size::new(3 * 132 - 4, 3 * 68 - 4));
    sheet.clear(Gray4::WHITE).unwrap();
    let is_shown = |scene: &str| scene != "card" && scene != "drawing";
    for (row, (example, scene)) in scenes().filter(|(_, scene)| is_shown(scene)).enumerate() {
        let elf = firmware::build(firmware::M3, example, firmware::SMALL, &[]);
        for (column, n) in [1, 10, 17].into_iter().enumerate() {
            let pixels = shown(firmware::M3, &elf, example, scene, n);
            let at = Rectangle::new(Point::new(132 * column as i32, 68 * row as i32), Size::new(128, 64));
            sheet.fill_contiguous(&at, pixels.into_iter().flatten().map(Gray4::new)).unwrap();
        }
    }
    save(&sheet, "panel.png");
}

/// A frame of the drawn vase.
#[test]
#[ignore = "writes docs/outlines/vase-panel.png"]
fn write_drawing() {
    let elf = firmware::build(firmware::M3, "outlines", firmware::SMALL, &[]);
    let pixels = shown(firmware::M3, &elf, "outlines", "drawing", 1);
    let mut panel = SimulatorDisplay::<Gray4>::new(Size::new(128, 64));
    panel.fill_contiguous(&panel.bounding_box(), pixels.into_iter().flatten().map(Gray4::new)).unwrap();
    save(&panel, "outlines/vase-panel.png");
}

/// A picture in `docs`, each pixel four by four.
fn save(display: &SimulatorDisplay<Gray4>, name: &str) {
    let scaled = OutputSettingsBuilder::new().scale(4).build();
    let file = Path::new(firmware::ROOT).join("docs").join(name);
    fs::create_dir_all(file.parent().unwrap()).unwrap();
    display.to_grayscale_output_image(&scaled).save_png(file).unwrap();
}

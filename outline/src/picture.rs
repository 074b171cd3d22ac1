//! A picture of a body: rendered by the crate, the drawn outline over it, and its knots.

use crate::{Body, Outline, Point, Profiles};
use embedded_graphics::{
    pixelcolor::Rgb888,
    prelude::{RgbColor, WebColors},
};
use embedded_lathe::{Background, Camera, Light, Rgb, Scene, Solid};
use tiny_skia::{Color, FillRule, Paint, PathBuilder, Pixmap, Stroke, Transform};

/// The most segments that one profile of a picture may have.
const SEGMENTS: usize = 256;

/// What keeps a picture from being made.
#[derive(Debug, thiserror::Error)]
#[non_exhaustive]
pub enum PictureError {
    /// The crate refuses the profile.
    #[error("no picture of it: {0}")]
    Profile(#[from] embedded_lathe::ProfileError),
    /// The crate refuses the view.
    #[error("no picture of it: {0}")]
    Scene(#[from] embedded_lathe::SceneError),
    /// The picture has no pixels, or too many.
    #[error("no picture of {0} pixels")]
    Size(u32),
    /// It could not be encoded.
    #[error("{0}")]
    Encoding(String),
}

/// A PNG of `size` × `size` pixels, seen from the side, so that the drawn outline is the silhouette.
///
/// # Errors
///
/// [`PictureError`].
pub fn png(body: &Body, outline: &Outline, size: u32) -> Result<Vec<u8>, PictureError> {
    let view = View::of(outline, size);
    let mut pixmap = rendered(body, &view, size)?;
    let right = |p: Point| view.pixel(p, 1.0);
    // The drawing on both sides, the mirrored one fainter.
    for (side, alpha) in [(-1.0, 90), (1.0, 255)] {
        let mut lines = PathBuilder::new();
        for piece in outline.pieces() {
            let count = 64;
            for i in 0..=count {
                let (x, y) = view.pixel(piece.at(f64::from(i) / f64::from(count)), side);
                if i == 0 { lines.move_to(x, y) } else { lines.line_to(x, y) }
            }
        }
        if let Some(path) = lines.finish() {
            let stroke = Stroke { width: 1.5, ..Stroke::default() };
            pixmap.stroke_path(&path, &paint(30, 220, 255, alpha), &stroke, Transform::identity(), None);
        }
    }
    for sheet in &body.sheets {
        for segment in sheet.segments() {
            for (z, f) in [(segment.z[0], segment.b[0]), (segment.z[1], segment.b[3])] {
                let (x, y) = right(Point { r: f.max(0.0).sqrt(), z });
                if let Some(dot) = PathBuilder::from_circle(x, y, 3.0) {
                    pixmap.fill_path(
                        &dot,
                        &paint(255, 230, 0, 255),
                        FillRule::Winding,
                        Transform::identity(),
                        None,
                    );
                }
            }
        }
    }
    pixmap.encode_png().map_err(|error| PictureError::Encoding(error.to_string()))
}

fn paint(r: u8, g: u8, b: u8, alpha: u8) -> Paint<'static> {
    let mut paint = Paint { anti_alias: true, ..Paint::default() };
    paint.set_color(Color::from_rgba8(r, g, b, alpha));
    paint
}

/// Where in the picture a point of the outline is.
struct View {
    middle: f64,
    /// Half the picture's width, in the drawing's unit.
    half: f64,
    size: f64,
}

impl View {
    fn of(outline: &Outline, size: u32) -> Self {
        let [low, high] = outline.bounds();
        let widest = high.r.abs().max(low.r.abs());
        let half = 1.1 * widest.max(0.5 * (high.z - low.z));
        Self { middle: 0.5 * (low.z + high.z), half, size: f64::from(size) }
    }

    fn pixel(&self, p: Point, side: f64) -> (f32, f32) {
        let scale = 0.5 * self.size / self.half;
        let (x, y) = (0.5 * self.size + side * scale * p.r, 0.5 * self.size - scale * (p.z - self.middle));
        (x as f32, y as f32)
    }
}

fn rendered(body: &Body, view: &View, size: u32) -> Result<Pixmap, PictureError> {
    let profiles = Profiles::of(body);
    let lathes = profiles.turned::<SEGMENTS>()?;
    let sheets = profiles.sheets(&lathes);
    let solids = [Solid::body(&sheets, Rgb::new(0.85, 0.45, 0.3))?];
    let (middle, half) = (view.middle as f32, view.half as f32);
    let eye = [0.0, -4.0 * half, middle];
    let camera = Camera::orthographic(eye, [0.0, 0.0, middle], [0.0, 0.0, 1.0], half)?;
    let background = Background::Plain(Rgb::new(0.1, 0.14, 0.22));
    let scene = Scene::new(&solids, camera, Light::new([-0.5, -0.7, 0.5], 0.15)?).with_background(background);
    let picture = scene.picture(size, size);
    let mut pixmap = Pixmap::new(size, size).ok_or(PictureError::Size(size))?;
    let mut row = vec![Rgb888::CSS_BLACK; size as usize];
    for (y, line) in (0..size).zip(pixmap.data_mut().chunks_exact_mut(4 * size as usize)) {
        picture.row(y, &mut row);
        for (pixel, color) in line.chunks_exact_mut(4).zip(&row) {
            pixel.copy_from_slice(&[color.r(), color.g(), color.b(), 255]);
        }
    }
    Ok(pixmap)
}

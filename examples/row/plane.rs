//! The plane of a row's rays, and what the crate answers in it.
//!
//! The camera is upright and looks along y: the plane holds the x axis's direction and the eye. A point of it is
//! its distance from the eye as seen from the side, and its x.

use crate::scenes::{VASE, VASE_SCENE};
use embedded_graphics::pixelcolor::Rgb888;
use embedded_lathe::Ray;

pub type Point = [f32; 2];

/// The picture is as many pixels wide and high: few, so that each can be seen.
pub const PIXELS: u32 = 60;

/// Through the vase's shoulder.
pub const ROW: u32 = 29;

/// Rays that find the silhouettes, a pixel; odd, so that a row of them lies in the plane.
const FINE: u32 = 201;

fn flat([x, y, z]: [f32; 3]) -> Point {
    let [_, eye_y, eye_z] = VASE_SCENE.camera.eye();
    [(y - eye_y).hypot(z - eye_z), x]
}

/// Of pixels, each cut into `cuts` by `cuts`, the i-th in the row's middle.
fn ray(i: u32, cuts: u32) -> Ray {
    VASE_SCENE.camera.ray(i, ROW * cuts + cuts / 2, PIXELS * cuts, PIXELS * cuts)
}

fn root(ray: &Ray) -> Option<Point> {
    VASE.nearest(ray, 0.0).map(|hit| flat(ray.at(hit.t)))
}

/// The nearest crossing that pixel i sees.
pub fn seen(i: u32) -> Option<Point> {
    root(&ray(i, 1))
}

/// A point of the i-th ray.
pub fn along(i: u32, t: f32) -> Point {
    flat(ray(i, 1).at(t))
}

/// Where the first and the last ray that meet anything do.
pub fn silhouettes() -> [Point; 2] {
    let find = |mut all: Box<dyn Iterator<Item = u32>>| all.find_map(|i| root(&ray(i, FINE)));
    let all = || 0..PIXELS * FINE;
    [find(Box::new(all())), find(Box::new(all().rev()))].map(|point| point.expect("the row meets the vase"))
}

/// The section: where rays from its middle leave it.
pub fn outline() -> Vec<Point> {
    let centre = ray(PIXELS * FINE / 2, FINE);
    let hits = VASE.hits::<17>(&centre, 0.0);
    let [front, back] = [hits.first(), hits.last()].map(|hit| centre.at(hit.expect("it is met").t));
    let middle = std::array::from_fn(|i| 0.5 * (front[i] + back[i]));
    let [_, y, z] = std::array::from_fn(|i| back[i] - front[i]);
    let leave = |step: u16| {
        let (sin, cos) = f32::from(step).to_radians().sin_cos();
        let length = f32::hypot(y, z);
        let direction = [sin, y / length * cos, z / length * cos];
        root(&Ray::new(middle, direction).ok()?)
    };
    (0..360).filter_map(leave).collect()
}

/// The row as it is drawn.
pub fn colors() -> [Rgb888; PIXELS as usize] {
    let mut row = [Rgb888::default(); PIXELS as usize];
    VASE_SCENE.picture(PIXELS, PIXELS).row(ROW, &mut row);
    row
}

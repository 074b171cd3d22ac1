#![no_std]
#![deny(unsafe_code)]

pub mod math;
pub mod solve;

mod camera;
mod color;
mod cubic;
mod draw;
mod hit;
mod lathe;
mod light;
mod pose;
mod profile;
mod ray;
mod rows;
mod scene;
mod scene_error;
mod solid;
mod surface;
mod valid;
mod vector;

pub use camera::Camera;
pub use color::{Background, Paint, Rgb};
pub use cubic::Cubic;
pub use draw::Drawable;
pub use hit::{Hit, Part};
pub use lathe::{Lathe, Segment};
pub use light::Light;
pub use pose::{Pose, Rotation};
pub use profile::{End, Profile, ProfileError};
pub use ray::{Ray, RayError};
pub use rows::Picture;
pub use scene::Scene;
pub use scene_error::SceneError;
pub use solid::Solid;
pub use surface::Surface;
pub use vector::{F32x3, Vector};

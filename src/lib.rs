//! Ray-traces smoothly lit solids of revolution with cubic Bézier profiles onto small displays: `no_std`, no
//! allocation, f32.
//!
//! A vase, a bottle, a bulb, a knob or a chess piece is an outline turned about an axis. Here the outline is
//! cubic in *squared radius* and linear in height,
//!
//! ```text
//! k·x² + y² = f(u) = Σ bⱼ·Bⱼ³(u),    z = z₀ + h·u,    0 ≤ u ≤ 1,    0 ≤ k ≤ 1
//! ```
//!
//! so that a ray meets a segment at the roots of a *cubic*; with a general cubic Bézier outline it is a
//! sextic. The idea is that of Kang Zhuzhen and Lu Lina, *The algorithm of finding intersection point for ray
//! tracing to ternary Bezier curve rotating surface* (Journal of Xi'an Jiaotong University, 1995). This crate
//! computes the coefficients of that cubic in f32 without losing precision, and solves it.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Gray4};
//! use embedded_lathe::*;
//!
//! static VASE: Lathe<[Segment; 2]> = Lathe::turn(
//!     valid!(Profile::from_squared_radii(
//!         &[0.0, 0.6, 1.0],                         // heights
//!         &[0.04, 0.16, 0.2, 0.14, 0.1, 0.0, 0.07], // squared radii, Bézier
//!     ))
//!     .base(End::Capped),
//! );
//! static SCENE: Scene = Scene::new(
//!     &[Solid::new(&VASE, Rgb::new(0.85, 0.45, 0.3))],
//!     valid!(Camera::perspective([0.0, -2.2, 0.9], [0.0, 0.0, 0.5], [0.0, 0.0, 1.0], 0.3)),
//!     valid!(Light::new([-0.5, -0.7, 0.5], 0.15)),
//! );
//!
//! let mut display = MockDisplay::<Gray4>::new(); // or any DrawTarget
//! SCENE.draw(&mut display)?;
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! # The pipe
//!
//! Each stage is a file, with a folder of the same name if it has submodules, and uses only stages to its
//! left.
//!
//! ```text
//! message → valid → math → vector → arithmetic → cubic → bernstein → solve → profile → ray → hit → lathe
//!      → surface → color → scene_error → light → camera → pose → sheet → shell → solid → extent → shade
//!      → scene → pick → occlusion → framing → picture → draw
//! ```
//!
//! | stage | from | to |
//! |---|---|---|
//! | [`Profile`] | numbers | a checked outline, or a [`ProfileError`] that names the number at fault |
//! | [`Lathe`] | a profile | segments with bounds, in flash; [`Ray`] → [`Hit`], one by one or along a row |
//! | [`Cubic`], [`Bernstein`], [`solve`] | a cubic, an interval | the first root, or all of them |
//! | [`Surface`] | a hit | its point and normal, for what is seen |
//! | [`Solid`], [`Sheet`], [`Pose`], [`Light`], [`Camera`], [`Background`] | | what a [`Scene`] is made of |
//! | [`Camera::project`], [`Camera::framing`] | a point, solids | the pixel that shows it, a camera that sees them |
//! | [`Pick`] | a ray, a pixel | the solid that is hit first |
//! | [`Picture`] | a scene, a size | rows of pixels, one at a time; the rectangle that solids cover |
//! | [`Picture::at`], [`Overlay`], [`Scene::draw`], [`PictureImage`] | a picture, a scene | a `DrawTarget` of embedded-graphics |
//!
//! # How it is called
//!
//! All names are in the crate's root. So `use embedded_lathe::*` serves as a prelude; it does not conflict
//! with that of embedded-graphics. Vectors are arrays, `[x, y, z]`, as arguments and as results. Constructors
//! that check their numbers return a `Result`; with [`valid!`] an error is reported by the compiler. Methods
//! that change a value return the new value. Types that may get more fields or variants in later versions
//! (errors, [`Scene`], [`Hit`], [`Surface`], [`Part`], [`End`], [`Background`]) are `#[non_exhaustive]`.
//!
//! # Letters
//!
//! Each letter has one meaning in the whole crate:
//!
//! | letter | what it is |
//! |---|---|
//! | x, y, z | coordinates; z is the height, measured along the axis |
//! | r, k | the radius; the squash, a factor on x² |
//! | u | the profile's parameter in its segment, 0 at the lower knot, 1 at the upper |
//! | f, F | the squared radius as a function of u; as a function of z |
//! | b; f0 to f3 | a segment's Bernstein ordinates; the same cubic's coefficients in powers of u |
//! | c0 to c3 | the coefficients of any cubic, constant term first |
//! | g | f − (k·x² + y²): positive inside the solid, negative outside |
//! | t, s | the distance along a ray, in lengths of its direction, from its origin; the same from a point near the solid |
//! | q | dx² + dy² of a ray's direction, in the frame |
//! | κ | du/ds along a ray |
//! | A | dg/ds at a root |
//! | M, D | a point and the direction of a row's ray, in the frame: the ray is M + s·D |
//! | i, j | the column and the row of a pixel; in code without pixels, indices |
//!
//! # Glossary
//!
//! These words have a meaning of this crate's own. A file sets such a word in italics where it first needs
//! it:
//!
//! | word | what it means |
//! |---|---|
//! | *lathe* | a solid of revolution made ready to meet rays: a profile's segments with their bounds |
//! | *body* | a solid bounded by several sheets |
//! | *sheet* | one of the lathes that bound a body, with the material inside or outside of it |
//! | *shell* | a body of an outer sheet and hollows within it that close the material off: from outside a pixel sees at most one of its sheets from the side without material |
//! | *segment* | the part of a profile between two knots, where the squared radius is one cubic |
//! | *frame* | a lathe's own coordinates: origin half way up the axis; all lengths scaled by one power of two, so that the largest squared radius is in [1, 4); then x scaled by √k, so that every lathe is round |
//! | *slab* | the space between the planes of a segment's two knots |
//! | *chord* | the part of a ray in a segment's slab |
//! | *unit* | 2⁻²⁴·(size + distance), in which the promises below are stated |
//! | *fast path* | the conservative answer for one ray, by bounds of the whole profile: miss, hit, or undecided |
//! | *traversal* | the complete answer for one ray, chord by chord |
//! | *undecided band* | values of g so near to zero, or heights so near to an end, that rounding may decide: neither the fast path nor the row decides such a pixel |
//! | *sweep* | the traversal of a row of rays together, pixel after pixel from the middle outwards |
//! | *span* | neighbouring pixels of a row that are computed in the same way: tracked, flat (a cap or a ring), empty or single |
//! | *tracked root* | the crossing of one pixel's ray carried on to the next by Newton's method |
//! | *certificate* | why a tracked root is its ray's nearest, and for how many pixels |
//! | *probe* | an upper bound of g along one ray, and the number of neighbours for which it proves a miss |
//! | *step* | two squared radii at one knot: between the segment that ends there and the one that begins lies a flat ring. One iteration of Newton's method is always called a Newton step |
//! | *slope jump* | by how much dF/dz rises at a knot |
//! | *single ray* | a ray cast for one pixel where the row is undecided |
//! | *arithmetic* | the numbers in which the pixels of a row are computed: floats, or integers where the machine has no FPU |
//! | *shade* | one value of a display's color channel; `Paint::shade` makes a pixel of three such numbers |
//!
//! # What is promised
//!
//! A unit is ε·(size + distance), where ε = 2⁻²⁴. The size is the larger of the solid's height and its
//! largest diameter; if the solid is stretched along x, that is its diameter along y. The distance is that of
//! the ray's origin from the middle of the axis.
//!
//! - A ray that clears every silhouette, every rim and, at its start, the surface by 4 units hits or misses
//!   as in exact arithmetic, and a hit is on the same part of the surface. A ray clears them if no
//!   displacement of the surface by less than 4 units changes the list of the ray's crossings.
//! - A ray that is nearer to a silhouette may hit there or miss; it never hits far from the surface.
//! - The point of a hit lies within 4 units of the surface. This unit is larger: the distance of the hit from
//!   the ray's origin is added to size and distance. Where the surface is plane within those 4 units of the
//!   hit, the distance along the ray is off by at most 4 units divided by the cosine of incidence.
//! - [`Lathe::spawn`] makes a ray that starts beside a hit, on the side of the surface to which the ray
//!   leaves. Its origin clears the surface by those 4 units.
//! - A waist of zero radius is as exact as the rest if a knot lies there. Where f touches zero inside a
//!   segment, f is off by up to 8ε of the segment's largest squared radius, and so the radius by up to √(8ε)
//!   of the largest radius.
//! - [`Picture::covered_by`] holds every pixel of a picture whose ray hits the solid.
//! - No result is NaN, no call panics, and no ray slips through between two segments.
//!
//! The tests check these promises for every solver of [`solve`] with every backend of [`math`], which
//! supplies square roots and a few other functions.
//!
//! The same source gives the same bits on every machine, because the crate uses only additions,
//! multiplications, divisions and correctly rounded square roots, in a fixed order. For the pixels of a
//! picture that holds in each *arithmetic*: floats where the machine has a floating-point unit, integers
//! where it has none (Cortex-M0, M0+, M3; rv32imc). Both show the same solid in every pixel; the colors
//! differ by one shade of a channel in at most one pixel of 10 000. `RUSTFLAGS='--cfg
//! embedded_lathe_arithmetic="integers"'` or `"floats"` chooses one for any target.
//!
//! # Features
//!
//! | feature | what it adds |
//! |---|---|
//! | `std` | `math::Std`, the standard library's functions as a third backend; without effect on bare-metal targets |
//! | `defmt` | `defmt::Format` on every public type |

#![no_std]
#![deny(unsafe_code)]

pub mod math;
pub mod solve;

mod arithmetic;
mod bernstein;
mod camera;
mod color;
mod cubic;
mod draw;
mod extent;
mod framing;
mod hit;
mod lathe;
mod light;
mod message;
mod occlusion;
mod pick;
mod picture;
mod pose;
mod profile;
mod ray;
mod scene;
mod scene_error;
mod shade;
mod sheet;
mod shell;
mod solid;
mod surface;
mod valid;
mod vector;

pub use bernstein::Bernstein;
pub use camera::Camera;
pub use color::{Background, Paint, Rgb, Shades};
pub use cubic::Cubic;
pub use draw::{Overlay, PictureImage, Placed, Redraw};
pub use hit::{Hit, Part};
pub use lathe::{Lathe, Segment};
pub use light::Light;
pub use pick::Pick;
pub use picture::Picture;
pub use pose::{Pose, Rotation};
pub use profile::{End, Profile, ProfileError};
pub use ray::{Ray, RayError};
pub use scene::Scene;
pub use scene_error::SceneError;
pub use sheet::Sheet;
pub use solid::Solid;
pub use surface::Surface;

/// The vectors of [`Cubic::roots`] and [`Lathe::hits`] are this crate's `Vec`.
pub use heapless;

use crate::message::Piece::{Count, Number, Text, Vector};
use crate::message::{Message, impl_error};

/// Why numbers do not make a part of a scene, and which numbers they are.
///
/// ```
/// use embedded_lathe::{Light, SceneError};
///
/// let error = Light::new([-1.0, -1.0, 1.0], 1.5).unwrap_err();
/// assert_eq!(error, SceneError::Ambient { ambient: 1.5 });
/// assert_eq!(error.to_string(), "the ambient share must be from 0 to 1, and is 1.5");
/// ```
#[derive(Clone, Copy, Debug)]
#[cfg_attr(feature = "defmt", derive(defmt::Format))]
#[non_exhaustive]
pub enum SceneError {
    /// A coordinate of a position is infinite or NaN.
    Position {
        /// The position given.
        position: [f32; 3],
    },
    /// A rotation's axis is zero, or a component of it infinite or NaN.
    RotationAxis {
        /// The axis given.
        axis: [f32; 3],
    },
    /// A rotation's angle is outside −10 000 to 10 000 radians, or NaN.
    RotationAngle {
        /// The angle given, in radians.
        angle: f32,
    },
    /// A rotation's quaternion is zero, or a number of it infinite or NaN.
    RotationQuaternion {
        /// The real part given.
        w: f32,
        /// The imaginary parts given.
        v: [f32; 3],
    },
    /// A matrix is not nearly that of a rotation: two of its rows are not nearly perpendicular, or a row is
    /// not nearly as long as 1.
    RotationRows {
        /// One of the two rows, from 0.
        row: usize,
        /// The other, or the same if its length is wrong.
        other: usize,
        /// The scalar product of the two: it should be 0, or 1 for a row with itself.
        product: f32,
    },
    /// A matrix mirrors what it turns.
    RotationMirrors {
        /// Its determinant, which should be 1.
        determinant: f32,
    },
    /// A pose's rotation was made from an angle outside −10 000 to 10 000 radians, or from NaN: its matrix
    /// contains NaN.
    Rotation {
        /// The first row of the matrix that contains NaN, from 0.
        row: usize,
        /// The elements of that row.
        elements: [f32; 3],
    },
    /// A solid's scale is not between 10⁻³⁰ and 10³⁰.
    Scale {
        /// The scale given.
        scale: f32,
    },
    /// A camera has no direction of view: `eye` and `look_at` are the same point, or a coordinate of one of
    /// them is infinite or NaN.
    ViewDirection {
        /// The eye given.
        eye: [f32; 3],
        /// The point given to look at.
        look_at: [f32; 3],
    },
    /// A camera's up direction is zero or parallel to its view, or a component of it is infinite or NaN.
    UpDirection {
        /// The direction given.
        up: [f32; 3],
    },
    /// A camera's half-width is outside the limits of that kind of camera, or NaN.
    HalfWidth {
        /// The half-width given.
        half_width: f32,
        /// The least that such a camera may have.
        least: f32,
        /// The most that such a camera may have.
        most: f32,
    },
    /// A camera is to frame no solids, or a picture without pixels.
    NothingToFrame {
        /// How many solids there are.
        solids: usize,
        /// The width of the picture in pixels.
        width: u32,
        /// Its height in pixels.
        height: u32,
    },
    /// A camera is to frame a solid that is endless: a sheet, whose squash is zero.
    Endless {
        /// The index of the solid.
        solid: usize,
    },
    /// A light's direction is zero, or a component of it infinite or NaN.
    LightDirection {
        /// The direction given.
        towards: [f32; 3],
    },
    /// A body has no sheets.
    NoSheets,
    /// A sheet of a body is prepared about another height than the first sheet: see
    /// [`Lathe::turn_beside`](crate::Lathe::turn_beside).
    SheetMiddle {
        /// Which sheet, from 0.
        sheet: usize,
        /// The height that it is prepared about.
        middle: f32,
        /// That of the first sheet.
        first: f32,
    },
    /// A sheet of a body has another squash than the first sheet.
    SheetSquash {
        /// Which sheet, from 0.
        sheet: usize,
        /// Its squash.
        squash: f32,
        /// That of the first sheet.
        first: f32,
    },
    /// An ambient share is outside 0 to 1, or NaN.
    Ambient {
        /// The share given.
        ambient: f32,
    },
}

impl SceneError {
    /// The error in words.
    const fn message(self) -> Message {
        match self {
            Self::Position { position } => {
                Message::of([Text("the position must be finite, and is "), Vector(position)])
            }
            Self::RotationAxis { axis } => {
                Message::of([Text("the rotation's axis must be finite and not zero, and is "), Vector(axis)])
            }
            Self::RotationAngle { angle } => Message::of([
                Text("the rotation's angle must be from -10000 to 10000, and is "),
                Number(angle),
            ]),
            Self::RotationQuaternion { w, v } => Message::of([
                Text("the rotation's quaternion must be finite and not zero, and is "),
                Number(w),
                Text(" + "),
                Vector(v),
            ]),
            Self::RotationRows { row, other, product } => Message::of([
                Text("the rotation's rows "),
                Count(row),
                Text(" and "),
                Count(other),
                Text(" must have a product within 0.1 of that of unit vectors at right angles, and have "),
                Number(product),
            ]),
            Self::RotationMirrors { determinant } => Message::of([
                Text("the rotation's matrix must not mirror, and has the determinant "),
                Number(determinant),
            ]),
            Self::Rotation { row, elements } => Message::of([
                Text(
                    "the rotation must be by angles from -10000 to 10000, which make its matrix finite; row ",
                ),
                Count(row),
                Text(" is "),
                Vector(elements),
            ]),
            Self::Scale { scale } => {
                Message::of([Text("the scale must be from 1e-30 to 1e30, and is "), Number(scale)])
            }
            Self::ViewDirection { eye, look_at } => Message::of([
                Text("the camera must look from one finite point at another, not from "),
                Vector(eye),
                Text(" at "),
                Vector(look_at),
            ]),
            Self::UpDirection { up } => Message::of([
                Text("the camera's up direction must be finite, and neither zero nor along the view; it is "),
                Vector(up),
            ]),
            Self::HalfWidth { half_width, least, most } => Message::of([
                Text("the half-width of this kind of camera must be from "),
                Number(least),
                Text(" to "),
                Number(most),
                Text(", and is "),
                Number(half_width),
            ]),
            Self::NothingToFrame { solids, width, height } => Message::of([
                Text("a camera must frame one solid or more in one pixel or more, not "),
                Count(solids),
                Text(" in "),
                Count(width as usize),
                Text("×"),
                Count(height as usize),
            ]),
            Self::Endless { solid } => Message::of([
                Text("a camera cannot frame an endless solid, and solid "),
                Count(solid),
                Text(" is one"),
            ]),
            Self::LightDirection { towards } => Message::of([
                Text("the light's direction must be finite and not zero, and is "),
                Vector(towards),
            ]),
            Self::NoSheets => Message::of([Text("a body must have at least one sheet, and has none")]),
            Self::SheetMiddle { sheet, middle, first } => Message::of([
                Text("sheet "),
                Count(sheet),
                Text(" must be turned beside the first, about the height "),
                Number(first),
                Text(", and is turned about "),
                Number(middle),
            ]),
            Self::SheetSquash { sheet, squash, first } => Message::of([
                Text("sheet "),
                Count(sheet),
                Text(" must have the first one's squash, "),
                Number(first),
                Text(", and has "),
                Number(squash),
            ]),
            Self::Ambient { ambient } => {
                Message::of([Text("the ambient share must be from 0 to 1, and is "), Number(ambient)])
            }
        }
    }
}

impl_error!(SceneError);

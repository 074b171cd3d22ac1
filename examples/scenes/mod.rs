//! The reference scenes: every figure of speed and every reference picture names one of these. All of them
//! are constants, in flash.

pub mod dial;
pub mod fine;
pub mod lambert;
pub mod orbit;
pub mod shapes;

use core::f32::consts::PI;
use embedded_lathe::{
    Background, Camera, End, Lathe, Light, Pose, Profile, Rgb, Rotation, Scene, SceneError, Segment, Solid,
    valid,
};

/// A bottle's points of height and radius, bottom to top: its base, from the axis out to the wall, a belly, a long neck, its mouth.
pub const BOTTLE_POINTS: [(f32, f32); 9] = [
    (0.0, 0.0),
    (0.0, 0.24),
    (0.06, 0.30),
    (0.24, 0.35),
    (0.42, 0.30),
    (0.58, 0.18),
    (0.74, 0.11),
    (0.92, 0.10),
    (1.0, 0.14),
];

/// A bottle, smooth through its points, open at the top.
pub static BOTTLE: Lathe<[Segment; 7]> = Lathe::turn(valid!(Profile::through(&BOTTLE_POINTS)));

/// The bottle, as README begins.
pub static BOTTLE_SCENE: Scene = Scene::new(
    &[Solid::new(&BOTTLE, Rgb::new(0.25, 0.55, 0.5)).shiny(40)],
    valid!(vase_camera([0.0, 0.0, 1.0])),
    DAYLIGHT,
)
.with_background(PLAIN);

/// The vase's joins, bottom to top.
pub const VASE_KNOTS: [f32; 5] = [0.0, 0.25, 0.6, 0.85, 1.0];

/// The vase's squared radii.
pub const VASE_ORDINATES: [f32; 13] = [
    0.04, 0.16, 0.2, //
    0.2, 0.2, 0.12, //
    0.05, 0.0, 0.01, //
    0.03, 0.042, 0.06, 0.07,
];

/// A vase, open at the top.
pub static VASE: Lathe<[Segment; 4]> =
    Lathe::turn(valid!(Profile::from_squared_radii(&VASE_KNOTS, &VASE_ORDINATES)).base(End::Capped));

/// A chess pawn: a foot, a collar and a head, cylinders, cones and a sphere, each exact.
pub static PAWN: Lathe<[Segment; 4]> = Lathe::turn(
    valid!(Profile::from_squared_radii(
        &[0.0, 0.12, 0.55, 0.62, 0.94],
        &[
            0.0484,
            0.0484,
            0.0484, // cylinder, r = 0.22
            0.0484,
            0.024_933_334,
            0.0108, // cone, r from 0.22 to 0.08 …
            0.0064,
            0.0164,
            0.0256, // … a collar …
            0.0256,
            0.059_733_33,
            0.059_733_33,
            0.0,
        ],
    ))
    .base(End::Capped),
);

/// A ball.
pub static BALL: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::sphere(0.2)));

/// Daylight from the upper left.
pub const DAYLIGHT: Light = valid!(Light::new([-0.5, -0.7, 0.5], 0.15));

/// Unglazed clay.
pub const CLAY: Rgb = Rgb::new(0.85, 0.45, 0.3);

/// A calm blue, lighter towards the bottom.
pub const SKY: Background =
    Background::Gradient { top: Rgb::new(0.10, 0.14, 0.22), bottom: Rgb::new(0.30, 0.36, 0.46) };

const PLAIN: Background = Background::Plain(Rgb::new(0.10, 0.14, 0.22));

const fn vase_camera(up: [f32; 3]) -> Result<Camera, SceneError> {
    Camera::perspective([0.0, -2.2, 0.9], [0.0, 0.0, 0.5], up, 0.3)
}

/// The vase, upright.
pub static VASE_SCENE: Scene =
    Scene::new(&[Solid::new(&VASE, CLAY)], valid!(vase_camera([0.0, 0.0, 1.0])), DAYLIGHT)
        .with_background(PLAIN);

/// The vase turned 30° about the x axis, the camera rolled 20°.
pub static TILTED_SCENE: Scene = Scene::new(
    &[Solid::new(&VASE, CLAY).posed(valid!(Pose::new([0.0; 3], Rotation::about_x(PI / 6.0), 1.0)))],
    valid!(vase_camera([0.342_020_14, 0.0, 0.939_692_6])),
    DAYLIGHT,
)
.with_background(PLAIN);

/// Into a bowl from above: the inside of its wall.
pub static BOWL_SCENE: Scene = Scene::new(
    &[Solid::new(&BOWL, Rgb::new(0.3, 0.6, 0.7)).shiny(30)],
    valid!(Camera::perspective([0.0, -1.6, 2.0], [0.0, 0.0, 0.3], [0.0, 0.0, 1.0], 0.35)),
    DAYLIGHT,
)
.with_background(SKY);

/// An open bowl with a foot and a lip.
pub static BOWL: Lathe<[Segment; 2]> = Lathe::turn(
    valid!(Profile::from_squared_radii(&[0.0, 0.08, 0.5], &[0.05, 0.05, 0.03, 0.03, 0.3, 0.25, 0.36]))
        .base(End::Capped),
);

/// A knob with a rounded edge and a flat top.
pub static KNOB: Lathe<[Segment; 2]> = Lathe::turn(
    valid!(Profile::from_squared_radii(&[0.0, 0.3, 0.38], &[0.25, 0.25, 0.25, 0.25, 0.25, 0.24, 0.2]))
        .base(End::Capped)
        .top(End::Capped),
);

/// The knob from above.
pub static KNOB_SCENE: Scene = Scene::new(
    &[Solid::new(&KNOB, Rgb::gray(0.75)).shiny(20)],
    valid!(Camera::perspective([0.0, -1.8, 1.6], [0.0, 0.0, 0.15], [0.0, 0.0, 1.0], 0.3)),
    DAYLIGHT,
)
.with_background(SKY);

/// The vase, a ball and a pawn.
pub static STILL_LIFE: Scene = Scene::new(
    &[
        Solid::new(&VASE, CLAY),
        Solid::new(&BALL, Rgb::new(0.8, 0.75, 0.3))
            .posed(valid!(Pose::new([-0.62, -0.25, 0.2], Rotation::IDENTITY, 1.0)))
            .shiny(40),
        Solid::new(&PAWN, Rgb::new(0.45, 0.6, 0.45))
            .posed(valid!(Pose::new([0.6, -0.3, 0.0], Rotation::IDENTITY, 0.7)))
            .shiny(15),
    ],
    valid!(Camera::perspective([0.0, -2.6, 1.2], [0.0, 0.0, 0.4], [0.0, 0.0, 1.0], 0.42)),
    DAYLIGHT,
)
.with_background(SKY);

const CORNER_BALL: Solid = Solid::new(&BALL, Rgb::new(0.8, 0.75, 0.3)).posed(valid!(Pose::new(
    [-0.53, 0.0, 0.92],
    Rotation::IDENTITY,
    0.35
)));

/// A ball in a corner of the vase's picture, without the vase.
pub static BALL_SCENE: Scene = VASE_SCENE.with_solids(&[CORNER_BALL]);

/// The vase, and that ball in a corner.
pub static VASE_AND_BALL: Scene = VASE_SCENE.with_solids(&[Solid::new(&VASE, CLAY), CORNER_BALL]);

/// A ball in the bowl: no plane parts them.
pub static BALL_IN_BOWL: Scene = BOWL_SCENE.with_solids(&[
    Solid::new(&BOWL, Rgb::new(0.3, 0.6, 0.7)).shiny(30),
    Solid::new(&BALL, Rgb::new(0.8, 0.75, 0.3)).posed(valid!(Pose::new(
        [0.1, 0.1, 0.3],
        Rotation::IDENTITY,
        1.0
    ))),
]);

/// A round board.
pub static BOARD: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cylinder(1.2, 0.06)));

const fn pawn_at(x: f32, y: f32, color: Rgb) -> Result<Solid<'static>, SceneError> {
    match Pose::new([x, y, 0.06], Rotation::IDENTITY, 0.7) {
        Ok(pose) => Ok(Solid::new(&PAWN, color).posed(pose)),
        Err(error) => Err(error),
    }
}

/// Six pawns on the board.
pub static PAWNS: Scene = Scene::new(
    &[
        Solid::new(&BOARD, Rgb::new(0.35, 0.22, 0.15)),
        valid!(pawn_at(-0.6, -0.4, Rgb::gray(0.85))),
        valid!(pawn_at(0.0, -0.6, Rgb::gray(0.85))),
        valid!(pawn_at(0.6, -0.4, Rgb::gray(0.85))),
        valid!(pawn_at(-0.6, 0.4, Rgb::gray(0.3))),
        valid!(pawn_at(0.0, 0.6, Rgb::gray(0.3))),
        valid!(pawn_at(0.6, 0.4, Rgb::gray(0.3))),
    ],
    valid!(Camera::perspective([0.0, -2.8, 1.9], [0.0, 0.0, 0.1], [0.0, 0.0, 1.0], 0.42)),
    DAYLIGHT,
)
.with_background(SKY);

/// All of them, and what their pictures in `docs` are called.
pub static NAMED: [(&str, &Scene); 7] = [
    ("bottle", &BOTTLE_SCENE),
    ("vase", &VASE_SCENE),
    ("tilted-vase", &TILTED_SCENE),
    ("bowl", &BOWL_SCENE),
    ("knob", &KNOB_SCENE),
    ("still-life", &STILL_LIFE),
    ("pawns", &PAWNS),
];

//! Shapes that real outlines have: shoulders, walls with thickness, solids that no plane parts.

use super::{BALL, BOWL, BOWL_SCENE, DAYLIGHT, KNOB_SCENE, SKY};
use embedded_lathe::{
    Camera, End, Lathe, Pose, Profile, ProfileError, Rgb, Rotation, Scene, SceneError, Segment, Sheet, Solid,
    valid,
};

const fn stepped(riser: f32) -> Result<Profile<4>, ProfileError> {
    let knots = [0.0, 0.2, 0.2 + riser, 0.34, 0.38];
    let ordinates = [
        0.25, 0.25, 0.25, //
        0.25, 0.21, 0.17, //
        0.13, 0.13, 0.13, //
        0.13, 0.13, 0.12, 0.1,
    ];
    Profile::from_squared_radii(&knots, &ordinates)
}

static RISER_2: Lathe<[Segment; 4]> = Lathe::turn(valid!(stepped(1e-2)).closed());
static RISER_3: Lathe<[Segment; 4]> = Lathe::turn(valid!(stepped(1e-3)).closed());
static RISER_4: Lathe<[Segment; 4]> = Lathe::turn(valid!(stepped(1e-4)).closed());
static RISER_6: Lathe<[Segment; 4]> = Lathe::turn(valid!(stepped(1e-6)).closed());

/// The same knob with an exact step for its shoulder.
static STEP: Lathe<[Segment; 3]> = Lathe::turn(
    valid!(Profile::from_squared_radii(
        &[0.0, 0.2, 0.2, 0.34, 0.38],
        &[
            0.25, 0.25, 0.25, 0.25, // up to the shoulder, where the step …
            0.13, 0.13, 0.13, // … leads inwards
            0.13, 0.13, 0.12, 0.1,
        ],
    ))
    .closed(),
);

const fn knob(lathe: &'static Lathe) -> Solid<'static> {
    Solid::new(lathe, Rgb::gray(0.75))
}

/// A knob with a shoulder, by a riser of 10⁻², 10⁻³, 10⁻⁴ and 10⁻⁶.
pub static RISERS: [Scene; 4] = [
    KNOB_SCENE.with_solids(&[knob(&RISER_2)]),
    KNOB_SCENE.with_solids(&[knob(&RISER_3)]),
    KNOB_SCENE.with_solids(&[knob(&RISER_4)]),
    KNOB_SCENE.with_solids(&[knob(&RISER_6)]),
];

/// The knob with an exact step.
pub static STEPPED: Scene = KNOB_SCENE.with_solids(&[knob(&STEP)]);

/// The inside of a bowl's wall, 0.03 to 0.05 thick.
static INNER: Lathe<[Segment; 2]> = Lathe::turn(
    valid!(Profile::from_squared_radii(&[0.03, 0.11, 0.5], &[0.0, 0.01, 0.01, 0.012, 0.25, 0.21, 0.31]))
        .base(End::Open),
);

const OUTER_WALL: Solid = Solid::new(&BOWL, Rgb::new(0.3, 0.6, 0.7)).shiny(30);
const INNER_WALL: Solid = Solid::new(&INNER, Rgb::new(0.85, 0.8, 0.7));

/// The outer wall of a bowl, the inner one, and both.
pub static BOWLS: [Scene; 3] = [
    BOWL_SCENE.with_solids(&[OUTER_WALL]),
    BOWL_SCENE.with_solids(&[INNER_WALL]),
    BOWL_SCENE.with_solids(&[OUTER_WALL, INNER_WALL]),
];

/// The outer wall up to a rim, a flat ring, which ends where the inner wall does; and that inner wall.
static BOWL_LATHES: [Lathe<[Segment; 2]>; 2] = {
    let outer = match Profile::from_squared_radii(
        &[0.0, 0.08, 0.5, 0.5],
        &[0.05, 0.05, 0.03, 0.03, 0.3, 0.25, 0.36, 0.31],
    ) {
        Ok(profile) => profile.base(End::Capped),
        Err(_) => panic!("the outer wall"),
    };
    let inner =
        match Profile::from_squared_radii(&[0.03, 0.11, 0.5], &[0.0, 0.01, 0.01, 0.012, 0.25, 0.21, 0.31]) {
            Ok(profile) => Lathe::turn_beside(profile, &outer),
            Err(_) => panic!("the inner wall"),
        };
    [Lathe::turn(outer), inner]
};

static BOWL_SHEETS: [Sheet; 2] =
    [Sheet::outer(&BOWL_LATHES[0]), Sheet::inner(&BOWL_LATHES[1]).colored(Rgb::new(0.85, 0.8, 0.7))];

const fn of_bowl(solid: Solid<'static>) -> Solid<'static> {
    solid.colored(Rgb::new(0.3, 0.6, 0.7)).shiny(30)
}

/// A bowl of two sheets that meet in its rim.
pub static BOWL_OF_SHEETS: Scene =
    BOWL_SCENE.with_solids(&[of_bowl(valid!(Solid::body(&BOWL_SHEETS, Rgb::WHITE)))]);

/// Each of its sheets alone.
pub static SHEETS_OF_BOWL: [Scene; 2] = [
    BOWL_SCENE.with_solids(&[of_bowl(Solid::new(&BOWL_LATHES[0], Rgb::WHITE))]),
    BOWL_SCENE.with_solids(&[of_bowl(Solid::new(&BOWL_LATHES[1], Rgb::WHITE))]),
];

/// The ball that lies in the bowl, alone.
pub static BOWLS_BALL: Scene = BOWL_SCENE.with_solids(&[Solid::new(&BALL, Rgb::new(0.8, 0.75, 0.3))
    .posed(valid!(Pose::new([0.1, 0.1, 0.3], Rotation::IDENTITY, 1.0)))]);

const PAWN_BODY: Profile<2> = valid!(Profile::from_squared_radii(
    &[0.0, 0.0, 0.1, 0.1, 0.5],
    &[
        0.0225, // the felt's edge, and a ring around it …
        0.0484, 0.0484, 0.0484, 0.0484, // … the foot, and its shoulder …
        0.0361, 0.0209, 0.0105, 0.0049, // … and a cone up to the collar
    ],
));

/// A pawn with an undercut collar, a bore in its head and a recess in its foot: body, the collar's underside
/// and wall, head, bore, recess.
static PAWN_LATHES: [Lathe<[Segment; 2]>; 6] = {
    const fn beside(knots: &[f32], ordinates: &[f32], base: End, top: End) -> Lathe<[Segment; 2]> {
        match Profile::from_squared_radii(knots, ordinates) {
            Ok(profile) => Lathe::turn_beside(profile.base(base).top(top), &PAWN_BODY),
            Err(_) => panic!("a sheet of the pawn"),
        }
    }
    const OPEN: End = End::Open;
    let collar = match Profile::from_squared_radii(
        &[0.46, 0.46, 0.56, 0.56],
        &[0.0225, 0.0324, 0.0361, 0.0361, 0.0289, 0.0081],
    ) {
        Ok(profile) => Lathe::turn_beside(profile, &PAWN_BODY),
        Err(_) => panic!("the collar"),
    };
    [
        Lathe::turn(PAWN_BODY),
        beside(&[0.46, 0.5], &[0.0225, 0.0145, 0.00863, 0.0049], OPEN, OPEN),
        collar,
        beside(&[0.56, 0.88], &[0.0081, 0.04, 0.045, 0.0016], OPEN, OPEN),
        beside(&[0.8, 0.88], &[0.0016; 4], End::Capped, OPEN),
        beside(&[0.0, 0.05], &[0.0225, 0.0225, 0.02, 0.0169], OPEN, End::Capped),
    ]
};

static PAWN_SHEETS: [Sheet; 6] = [
    Sheet::outer(&PAWN_LATHES[0]),
    Sheet::inner(&PAWN_LATHES[1]),
    Sheet::outer(&PAWN_LATHES[2]),
    Sheet::outer(&PAWN_LATHES[3]),
    Sheet::inner(&PAWN_LATHES[4]),
    Sheet::inner(&PAWN_LATHES[5]),
];

const BOARD_VIEW: Camera =
    valid!(Camera::perspective([0.0, -1.6, 1.1], [0.0, 0.0, 0.42], [0.0, 0.0, 1.0], 0.32));

const fn of_pawn(solids: &'static [Solid<'static>]) -> Scene<'static> {
    Scene::new(solids, BOARD_VIEW, DAYLIGHT).with_background(SKY)
}

const fn pawn_of(sheets: &'static [Sheet<'static>]) -> Result<Solid<'static>, SceneError> {
    Solid::body(sheets, Rgb::new(0.45, 0.6, 0.45))
}

/// The pawn of six sheets.
pub static PAWN_OF_SHEETS: Scene = of_pawn(&[valid!(pawn_of(&PAWN_SHEETS))]);

const fn sheet_of_pawn(sheet: usize) -> Solid<'static> {
    Solid::new(&PAWN_LATHES[sheet], Rgb::new(0.45, 0.6, 0.45))
}

/// Each of its sheets alone.
pub static SHEETS_OF_PAWN: [Scene; 6] = [
    of_pawn(&[sheet_of_pawn(0)]),
    of_pawn(&[sheet_of_pawn(1)]),
    of_pawn(&[sheet_of_pawn(2)]),
    of_pawn(&[sheet_of_pawn(3)]),
    of_pawn(&[sheet_of_pawn(4)]),
    of_pawn(&[sheet_of_pawn(5)]),
];

const RIPPLES: usize = 12;

const fn ripples() -> Result<Profile<RIPPLES>, ProfileError> {
    let mut knots = [0.0; RIPPLES + 1];
    let mut ordinates = [0.0; 3 * RIPPLES + 1];
    let mut i = 0;
    while i <= RIPPLES {
        knots[i] = i as f32 / RIPPLES as f32;
        let square = if i % 2 == 0 { 0.09 } else { 0.13 };
        ordinates[3 * i] = square;
        if i > 0 {
            ordinates[3 * i - 1] = square;
        }
        if i < RIPPLES {
            ordinates[3 * i + 1] = square;
        }
        i += 1;
    }
    Profile::from_squared_radii(&knots, &ordinates)
}

static RIPPLED: Lathe<[Segment; RIPPLES]> = Lathe::turn(valid!(ripples()).closed());

const fn through(axis: [f32; 3], angle: f32, color: Rgb) -> Result<Solid<'static>, SceneError> {
    let rotation = match Rotation::about(axis, angle) {
        Ok(rotation) => rotation,
        Err(error) => return Err(error),
    };
    // About the solid's middle.
    let up = rotation.apply([0.0, 0.0, -0.5]);
    match Pose::new(up, rotation, 1.0) {
        Ok(pose) => Ok(Solid::new(&RIPPLED, color).posed(pose)),
        Err(error) => Err(error),
    }
}

static THROUGH: [Solid; 6] = [
    valid!(through([1.0, 0.0, 0.0], 0.0, Rgb::new(0.8, 0.3, 0.3))),
    valid!(through([1.0, 0.0, 0.0], 1.0, Rgb::new(0.3, 0.8, 0.3))),
    valid!(through([0.0, 1.0, 0.0], 1.2, Rgb::new(0.3, 0.3, 0.8))),
    valid!(through([1.0, 1.0, 0.0], 1.4, Rgb::new(0.8, 0.8, 0.3))),
    valid!(through([1.0, -1.0, 0.0], 0.7, Rgb::new(0.3, 0.8, 0.8))),
    valid!(through([1.0, 0.3, 0.5], 2.0, Rgb::new(0.8, 0.3, 0.8))),
];

const AROUND: Camera = valid!(Camera::perspective([0.3, -2.2, 0.7], [0.0; 3], [0.0, 0.0, 1.0], 0.3));
const WITHIN: Camera = valid!(Camera::perspective([0.05, -0.1, 0.02], [0.4, 0.6, 0.1], [0.0, 0.0, 1.0], 0.8));

const fn crossing(solids: &'static [Solid<'static>], camera: Camera) -> Scene<'static> {
    Scene::new(solids, camera, DAYLIGHT).with_background(SKY)
}

/// One, two, three and six solids of twelve segments through one another, the eye outside; one and six, the eye inside.
pub static CROSSINGS: [Scene; 6] = [
    crossing(THROUGH.split_at(1).0, AROUND),
    crossing(THROUGH.split_at(2).0, AROUND),
    crossing(THROUGH.split_at(3).0, AROUND),
    crossing(&THROUGH, AROUND),
    crossing(THROUGH.split_at(1).0, WITHIN),
    crossing(&THROUGH, WITHIN),
];

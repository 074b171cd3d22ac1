//! Where scenes live in firmware: patterns for what is made at run time, for interrupts and for tasks. Each is compiled and run here;
//! on a board `critical-section`'s implementation is the chip's, and `block_on` is the executor.

use critical_section::Mutex;
use embassy_sync::blocking_mutex::raw::CriticalSectionRawMutex;
use embassy_sync::signal::Signal;
use embedded_graphics::mock_display::MockDisplay;
use embedded_graphics::pixelcolor::Rgb565;
use embedded_graphics::prelude::*;
use embedded_lathe::{
    Camera, Lathe, Light, Picture, Pose, Profile, ProfileError, Redraw, Rgb, Rotation, Scene, SceneError,
    Segment, Solid, valid,
};
use static_cell::StaticCell;
use std::cell::{Cell, RefCell};
use std::pin::pin;
use std::task::{Context, Poll, Waker};

// What does not change is a `static`, in flash.
static KNOB: Lathe<[Segment; 1]> = Lathe::turn(valid!(Profile::cylinder(0.5, 0.4)));
static POINTER: Lathe<[Segment; 1]> =
    Lathe::turn(valid!(Profile::cylinder(0.05, 0.04)?.squash(0.1)?.closed()));
static VIEW: Scene = Scene::new(
    &[],
    valid!(Camera::perspective([0.0, -1.8, 1.6], [0.0, 0.0, 0.15], [0.0, 0.0, 1.0], 0.35)),
    valid!(Light::new([-0.5, -0.7, 0.5], 0.15)),
);

fn dial(angle: f32) -> Result<[Solid<'static>; 2], SceneError> {
    let knob = Pose::new([0.0; 3], Rotation::about_z(angle), 1.0)?;
    let on_top = Pose::new([0.25, 0.0, 0.4], Rotation::IDENTITY, 1.0)?;
    let pointer = Solid::new(&POINTER, Rgb::new(0.9, 0.2, 0.1)).posed(on_top.then(knob)?);
    Ok([Solid::new(&KNOB, Rgb::gray(0.7)).posed(knob), pointer])
}

fn display() -> MockDisplay<Rgb565> {
    let mut display = MockDisplay::new();
    display.set_allow_overdraw(true);
    display
}

/// The display shows the dial at an angle.
fn assert_shows(display: &MockDisplay<Rgb565>, angle: f32) {
    let mut truth = MockDisplay::new();
    VIEW.with_solids(&dial(angle).unwrap()).draw(&mut truth).unwrap();
    let pixels = display.bounding_box().points();
    let differ = pixels.filter(|&at| display.get_pixel(at) != truth.get_pixel(at)).count();
    // A rectangle begins elsewhere than a row does: where rounding decides, a pixel may differ by a step.
    assert!(differ <= 2, "{differ} pixels differ at {angle}");
}

/// `StaticCell`: solids are made at run time, and from then on they are `'static`, and so are the scene and its picture. They can be
/// kept in any struct, and passed to any task.
#[test]
fn a_scene_made_at_run_time_is_static() {
    static SOLIDS: StaticCell<[Solid<'static>; 2]> = StaticCell::new();
    static PICTURE: StaticCell<Picture<'static>> = StaticCell::new();

    let solids: &'static [Solid<'static>; 2] = SOLIDS.init(dial(0.3).unwrap());
    let picture: &'static Picture<'static> = PICTURE.init(VIEW.with_solids(solids).picture(64, 64));
    let mut display = display();
    picture.at(Point::zero()).draw(&mut display).unwrap();
    assert_shows(&display, 0.3);
}

/// A mutex: an interrupt changes the solids, and the main loop draws a copy, so that the interrupt need not wait for a frame.
#[test]
fn an_interrupt_changes_the_solids() {
    static SOLIDS: Mutex<RefCell<Option<[Solid<'static>; 2]>>> = Mutex::new(RefCell::new(None));

    fn encoder_interrupt(angle: f32) {
        let solids = dial(angle).ok();
        critical_section::with(|token| SOLIDS.borrow_ref_mut(token).clone_from(&solids));
    }

    let mut display = display();
    for angle in [0.1, 0.7] {
        encoder_interrupt(angle);
        let solids = critical_section::with(|token| *SOLIDS.borrow_ref(token)).unwrap();
        VIEW.with_solids(&solids).draw(&mut display).unwrap();
        assert_shows(&display, angle);
    }
}

/// As RTIC divides them: what tasks share is behind locks, and what one task owns is its own. The scene is put together in the task,
/// from the solids that it copies out of the lock.
mod rtic_like {
    use super::*;

    #[derive(Default)]
    pub struct Shared {
        pub angle: Cell<f32>,
    }

    pub struct Local {
        pub display: MockDisplay<Rgb565>,
        pub row: [Rgb565; 64],
        pub scene: Scene<'static>,
        pub redraw: Redraw,
    }

    pub fn init() -> (Shared, Local) {
        let display = display();
        let redraw = Redraw::new(display.bounding_box());
        let local = Local { display, row: [Rgb565::BLACK; 64], scene: VIEW, redraw };
        (Shared::default(), local)
    }

    pub fn turn(shared: &Shared, by: f32) {
        shared.angle.set(shared.angle.get() + by);
    }

    pub fn draw(shared: &Shared, local: &mut Local) -> Result<(), SceneError> {
        let solids = dial(shared.angle.get())?;
        let picture = local.scene.with_solids(&solids).picture(64, 64);
        let changed = local.redraw.next(picture.covered_by(&solids[1]));
        let Ok(()) =
            picture.at(Point::zero()).only(&changed).draw_by_rows(&mut local.display, &mut local.row);
        Ok(())
    }
}

#[test]
fn a_task_owns_its_scene() {
    let (shared, mut local) = rtic_like::init();
    for step in 0..4 {
        rtic_like::draw(&shared, &mut local).unwrap();
        assert_shows(&local.display, 0.2 * step as f32);
        rtic_like::turn(&shared, 0.2);
    }
}

/// As Embassy's tasks are: one awaits the encoder's angle and draws. Its future holds the scene and is `'static`.
#[test]
fn a_task_awaits_what_it_draws() {
    static ANGLE: Signal<CriticalSectionRawMutex, f32> = Signal::new();
    static DISPLAY: StaticCell<MockDisplay<Rgb565>> = StaticCell::new();

    async fn display_task(display: &'static mut MockDisplay<Rgb565>, scene: Scene<'static>) {
        let mut redraw = Redraw::new(display.bounding_box());
        for _ in 0..3 {
            let angle = ANGLE.wait().await;
            let Ok(solids) = dial(angle) else { continue };
            let picture = scene.with_solids(&solids).picture(64, 64);
            let changed = redraw.next(picture.covered_by(&solids[1]));
            let Ok(()) = picture.at(Point::zero()).only(&changed).draw(display);
            assert_shows(display, angle);
        }
    }

    fn spawn(_: &(impl Future<Output = ()> + Send + 'static)) {}

    let task = display_task(DISPLAY.init(display()), VIEW);
    spawn(&task);
    let mut task = pin!(task);
    let mut poll = || task.as_mut().poll(&mut Context::from_waker(Waker::noop()));
    for angle in [0.0, 0.5, 1.0] {
        assert_eq!(poll(), Poll::Pending);
        ANGLE.signal(angle);
    }
    assert_eq!(poll(), Poll::Ready(()));
}

/// An outline that arrives at run time, over a wire say: it is read into as much room as the longest may need, and kept in no more
/// than it takes. Without an allocator there is one cell for each of a few sizes.
#[test]
fn a_lathe_of_run_time_takes_the_room_that_it_needs() {
    static SMALL: StaticCell<Lathe<[Segment; 4]>> = StaticCell::new();
    static LARGE: StaticCell<Lathe<[Segment; 16]>> = StaticCell::new();

    fn keep(profile: Profile<16>) -> Result<&'static Lathe, ProfileError> {
        Ok(if profile.segments() <= 4 {
            SMALL.init(Lathe::turn(profile.resized()?))
        } else {
            LARGE.init(Lathe::turn(profile))
        })
    }

    // With an allocator, exactly.
    fn boxed(profile: Profile<16>) -> Result<Box<Lathe>, ProfileError> {
        Ok(match profile.segments() {
            1 => Box::new(Lathe::<[Segment; 1]>::turn(profile.resized()?)),
            2 => Box::new(Lathe::<[Segment; 2]>::turn(profile.resized()?)),
            3 => Box::new(Lathe::<[Segment; 3]>::turn(profile.resized()?)),
            _ => Box::new(Lathe::turn(profile)),
        })
    }

    let points =
        |n: usize| (0..=n).map(move |i| (0.1 * i as f32, 0.2 + 0.05 * (i % 2) as f32)).collect::<Vec<_>>();
    for n in [3, 12] {
        let profile = Profile::<16>::through(&points(n)).unwrap();
        let (kept, boxed) = (keep(profile).unwrap(), boxed(profile).unwrap());
        assert_eq!((kept.segments(), boxed.segments()), (n, n));
        let room = if n == 3 { size_of::<Lathe<[Segment; 4]>>() } else { size_of::<Lathe<[Segment; 16]>>() };
        assert_eq!(size_of_val(kept), room);
        let least = size_of::<Lathe<[Segment; 1]>>() + 2 * size_of::<Segment>();
        assert!(n != 3 || size_of_val(&*boxed) == least);
        // What it is does not depend on its room.
        let whole = Lathe::turn(profile);
        let draw = |lathe: &Lathe| {
            let solids = [Solid::new(lathe, Rgb::WHITE)];
            let mut row = [Rgb565::BLACK; 40];
            let picture = VIEW.with_solids(&solids).picture(40, 40);
            (0..40)
                .flat_map(|y| {
                    picture.row(y, &mut row);
                    row
                })
                .collect::<Vec<_>>()
        };
        assert!(draw(kept) == draw(&whole) && draw(&boxed) == draw(&whole));
    }
}

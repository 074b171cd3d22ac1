//! The kinds of rays that go wrong, each in its own way.

use super::Cast;
use super::place::{Place, Vector, along, cross, unit};

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Family {
    /// From all around at all of the box.
    Random,
    /// A pixel of a camera at eye level or above, direction as long as the perspective makes it.
    Camera,
    /// `|c|/|D|` from 1e-8 to 1e-1, each power of ten alike.
    NearHorizontal,
    /// c = 0; a third at knots, a third one float beside them.
    Horizontal,
    /// a = b = 0, up and down; some on the axis.
    Vertical,
    /// Along ±x or ±y exactly, also at knots.
    AxisParallel,
    /// Past the silhouette by 1e-7 to 1e-2 of the size, on either side.
    Grazing,
    /// Past the edge at an end or a join by 1e-7 to 1e-1 of the size.
    Rims,
    /// From within.
    Inside,
    /// From 10 to 30 000 sizes away.
    Far,
    /// Through x = y = 0, to the last bit.
    ThroughAxis,
    /// From a point of the surface rounded to f32; t_min from 1e-4 to 1e-2 of the size.
    FromSurface,
    /// Directions of length 1e-3 to 1e3.
    Unnormalised,
}

impl Family {
    pub const ALL: [Family; 13] = [
        Family::Random,
        Family::Camera,
        Family::NearHorizontal,
        Family::Horizontal,
        Family::Vertical,
        Family::AxisParallel,
        Family::Grazing,
        Family::Rims,
        Family::Inside,
        Family::Far,
        Family::ThroughAxis,
        Family::FromSurface,
        Family::Unnormalised,
    ];

    pub(super) fn cast(self, place: &mut Place) -> Cast {
        match self {
            Family::Random => random(place),
            Family::Camera => camera(place),
            Family::NearHorizontal => near_horizontal(place),
            Family::Horizontal => horizontal(place),
            Family::Vertical => vertical(place),
            Family::AxisParallel => axis_parallel(place),
            Family::Grazing => grazing(place),
            Family::Rims => rims(place),
            Family::Inside => inside(place),
            Family::Far => far(place),
            Family::ThroughAxis => through_axis(place),
            Family::FromSurface => from_surface(place),
            Family::Unnormalised => unnormalised(place),
        }
    }
}

fn round(v: Vector) -> [f32; 3] {
    v.map(|c| c as f32)
}

fn cast(origin: Vector, direction: Vector) -> Cast {
    Cast { origin: round(origin), direction: round(direction), t_min: 0.0 }
}

/// A ray towards a point that begins `sizes` times the size of the place before it.
fn towards(place: &Place, point: Vector, direction: Vector, sizes: f64) -> Cast {
    cast(along(point, -sizes * place.size, direction), direction)
}

fn random(place: &mut Place) -> Cast {
    let (target, direction, sizes) = (place.target(), place.direction(), place.between(0.5, 4.0));
    towards(place, target, direction, sizes)
}

fn camera(place: &mut Place) -> Cast {
    let above = if place.pick(2) == 0 { 0.0 } else { place.between(0.3, 1.2) };
    let out = place.level_direction().map(|c| c * above.cos());
    let forward = [-out[0], -out[1], -above.sin()];
    let right = unit(cross(forward, [0.0, 0.0, 1.0]));
    let up = cross(right, forward);
    let sizes = place.between(1.5, 5.0);
    let eye = along([0.0, 0.0, place.shape.middle()], -sizes * place.size, forward);
    let half = 0.7 / sizes;
    let direction = along(forward, place.between(-half, half), right);
    cast(eye, along(direction, place.between(-half, half), up))
}

fn near_horizontal(place: &mut Place) -> Cast {
    let c = place.sign() * place.magnitude(1e-8, 1e-1);
    let [a, b, _] = place.level_direction().map(|l| l * (1.0 - c * c).sqrt());
    let (target, sizes) = (place.target(), place.between(0.7, 4.0));
    towards(place, target, [a, b, c], sizes)
}

/// A height at which something may change: a knot, the float above or below one, or any.
fn level(place: &mut Place) -> f32 {
    let knot = place.knot();
    let knot = place.shape.knots[knot] as f32;
    match place.pick(3) {
        0 => knot,
        1 if place.pick(2) == 0 => knot.next_up(),
        1 => knot.next_down(),
        _ => place.height() as f32,
    }
}

fn horizontal(place: &mut Place) -> Cast {
    let (target, direction, sizes) = (place.target(), place.level_direction(), place.between(0.7, 4.0));
    let mut cast = towards(place, target, direction, sizes);
    cast.origin[2] = level(place);
    cast
}

fn vertical(place: &mut Place) -> Cast {
    let direction = [0.0, 0.0, place.sign()];
    let (mut target, sizes) = (place.target(), place.between(1.5, 4.0));
    if place.pick(8) == 0 {
        target = [0.0, 0.0, target[2]];
    }
    towards(place, target, direction, sizes)
}

fn axis_parallel(place: &mut Place) -> Cast {
    let (target, sizes) = (place.target(), place.between(1.5, 4.0));
    let mut direction = [0.0; 3];
    direction[place.pick(2)] = place.sign();
    let mut cast = towards(place, target, direction, sizes);
    cast.origin[2] = level(place);
    cast
}

fn grazing(place: &mut Place) -> Cast {
    let (point, normal) = place.on_wall();
    let any = place.direction();
    let direction = unit(cross(normal, any));
    let off = place.sign() * place.magnitude(1e-7, 1e-2) * place.size;
    let sizes = place.between(0.7, 4.0);
    towards(place, along(point, off, normal), direction, sizes)
}

fn rims(place: &mut Place) -> Cast {
    // Most at the ends, some at inner joins.
    let last = place.shape.segments();
    let knot = [0, last, place.knot()][place.pick(3)];
    let edge = place.on_rim(knot);
    let off = place.magnitude(1e-7, 1e-1) * place.size;
    let point = along(edge, off, place.direction());
    let (direction, sizes) = (place.direction(), place.between(0.7, 4.0));
    towards(place, point, direction, sizes)
}

fn inside(place: &mut Place) -> Cast {
    let z = place.between(place.shape.base(), place.shape.top());
    let scale = place.between(0.0, 1.0).sqrt();
    cast(place.on_ring(z, scale), place.direction())
}

fn far(place: &mut Place) -> Cast {
    let (target, direction, sizes) = (place.target(), place.direction(), place.magnitude(10.0, 30_000.0));
    towards(place, target, direction, sizes)
}

fn through_axis(place: &mut Place) -> Cast {
    let direction = match place.pick(4) {
        0 => place.level_direction(),
        _ => place.direction(),
    };
    let mut cast = cast([0.0; 3], direction);
    // A power of two, so that the origin is an exact multiple of the direction in x and y.
    let back = (place.size.log2().ceil() + place.pick(3) as f64).exp2() as f32;
    cast.origin = cast.direction.map(|c| -back * c);
    cast.origin[2] += place.height() as f32;
    cast
}

fn from_surface(place: &mut Place) -> Cast {
    let (point, direction) = (place.on_surface(), place.direction());
    let t_min = place.magnitude(1e-4, 1e-2) * place.size;
    Cast { t_min: t_min as f32, ..cast(point, direction) }
}

fn unnormalised(place: &mut Place) -> Cast {
    let (target, direction, sizes) = (place.target(), place.direction(), place.between(0.5, 4.0));
    let length = place.magnitude(1e-3, 1e3);
    cast(along(target, -sizes * place.size, direction), direction.map(|c| c * length))
}

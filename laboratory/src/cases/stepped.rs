//! Solids with steps and with rings at their ends.

use super::Outline;

fn stepped(name: &'static str, knots: &[f32], ordinates: &[f32]) -> Outline {
    Outline {
        name,
        knots: knots.to_vec(),
        ordinates: ordinates.to_vec(),
        k: 1.0,
        base_closed: false,
        top_closed: false,
    }
}

fn closed(outline: Outline) -> Outline {
    Outline { base_closed: true, top_closed: true, ..outline }
}

/// Every kind of step, of ring and of end.
pub fn stepped_outlines() -> Vec<Outline> {
    let lifted = |outline: Outline, name, by: f32| Outline {
        name,
        knots: outline.knots.iter().map(|knot| knot + by).collect(),
        ..outline
    };
    vec![
        knob(),
        Outline { name: "elliptic knob", k: 0.3, ..knob() },
        Outline { name: "knob without end", k: 0.0, ..knob() },
        lifted(knob(), "lifted knob", 100.0),
        mushroom(),
        washer(),
        hole(),
        pole(),
        spool(),
        disc_on_a_point(),
        two_at_once(),
        flange(),
        punt(),
        glass(),
        screw(),
        torus(),
    ]
}

/// A flat shoulder that faces up.
fn knob() -> Outline {
    closed(stepped("knob", &[0.0, 0.2, 0.2, 0.38], &[0.25, 0.26, 0.26, 0.25, 0.09, 0.1, 0.09, 0.06]))
}

/// A step up, whose ring faces down, and a rounded pole.
fn mushroom() -> Outline {
    let ordinates = [0.04, 0.03, 0.02, 0.03, 0.36, 0.36, 0.3, 0.0];
    Outline { base_closed: true, ..stepped("mushroom", &[0.0, 0.5, 0.5, 0.9], &ordinates) }
}

/// The outer wall of a washer: a ring at either end, the middle open.
fn washer() -> Outline {
    stepped("washer", &[0.0, 0.0, 0.1, 0.1], &[0.09, 0.25, 0.25, 0.25, 0.25, 0.09])
}

/// The wall of its hole, with the same rings.
fn hole() -> Outline {
    stepped("hole", &[0.0, 0.0, 0.1, 0.1], &[0.25, 0.09, 0.09, 0.09, 0.09, 0.25])
}

/// A step where a cone comes to its point, and one at the pole of the base.
fn pole() -> Outline {
    let ordinates = [0.1, 0.0, 0.1, 0.2, 0.2, 0.1, 0.0, 0.0, 0.3, 0.3, 0.2, 0.1];
    stepped("poles", &[0.0, 0.0, 0.4, 0.9, 0.9, 1.2], &ordinates)
}

/// Down and up again, and again.
fn spool() -> Outline {
    let ordinates = [
        0.3, 0.3, 0.3, 0.3, 0.1, 0.05, 0.05, 0.1, 0.4, 0.4, 0.4, 0.4, 0.2, 0.3, 0.1, 0.2, 0.3, 0.3, 0.3, 0.3,
    ];
    closed(stepped("spool", &[0.0, 0.2, 0.2, 0.6, 0.6, 0.7, 0.7, 1.0, 1.0, 1.1], &ordinates))
}

/// A step as wide as the solid.
fn disc_on_a_point() -> Outline {
    let ordinates = [0.25, 0.25, 0.25, 0.25, 0.0, 0.1, 0.2, 0.25, 0.0, 0.0, 0.0, 0.25];
    closed(stepped("discs on points", &[0.0, 0.2, 0.2, 0.8, 0.8, 1.2], &ordinates))
}

/// Two steps, the one 10⁻⁵ above the other.
fn two_at_once() -> Outline {
    let ordinates = [0.3, 0.3, 0.3, 0.3, 0.2, 0.2, 0.2, 0.2, 0.1, 0.1, 0.2, 0.1];
    closed(stepped("two at once", &[0.0, 0.5, 0.5, 0.500_01, 0.500_01, 1.0], &ordinates))
}

/// A pipe with a flange at its top: a ring that faces down.
fn flange() -> Outline {
    stepped("flange", &[0.0, 0.8, 0.8], &[0.1, 0.12, 0.1, 0.08, 0.3])
}

/// A bottle whose base is a ring about its punt.
fn punt() -> Outline {
    let ordinates = [0.06, 0.16, 0.2, 0.2, 0.16, 0.1, 0.02, 0.02];
    let ordinates = [ordinates.as_slice(), &[0.02, 0.02, 0.02]].concat();
    let outline = stepped("punt", &[0.0, 0.0, 0.6, 0.9, 1.2, 1.2], &[]);
    Outline { ordinates: [ordinates.as_slice(), &[0.01]].concat(), ..outline }
}

/// The outer wall of a glass with a foot, a stem and a rim.
fn glass() -> Outline {
    let ordinates = [0.09, 0.09, 0.09, 0.09, 0.004, 0.004, 0.004, 0.004, 0.1, 0.16, 0.14, 0.12];
    Outline { base_closed: true, ..stepped("glass", &[0.0, 0.03, 0.03, 0.5, 1.0, 1.0], &ordinates) }
}

/// Eight turns of a thread.
fn screw() -> Outline {
    let (mut knots, mut ordinates) = (vec![0.0], Vec::new());
    for turn in 1..=8_u8 {
        let z = f32::from(turn) / 8.0;
        knots.extend([z, z]);
        ordinates.extend([0.1, 0.1, 0.15, 0.2]);
    }
    knots.pop();
    closed(stepped("screw", &knots, &ordinates))
}

/// The outer half of a ring, round in section: its ends are open, its edges where the inner half joins it.
fn torus() -> Outline {
    stepped("torus", &[-0.25, 0.25], &[0.25, 0.62, 0.62, 0.25])
}

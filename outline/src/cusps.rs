//! Where the outline turns back on itself at a level tip, no step may cut it short.
//!
//! A step leads from the end of a segment on to the end of the drawn section. Where the drawing goes on in the
//! same direction the flat that the body has there covers the step; where it turns back the body would lose the
//! tip of a cusp.

use crate::{
    section::{Section, Tip},
    walls::{Run, Runs},
};

/// A tip by the indices of its run and its section, and whether it is the upper one.
#[derive(Clone, Copy)]
struct At {
    run: usize,
    section: usize,
    upper: bool,
}

/// What the outline goes along, in the order in which it is drawn.
enum Passed {
    /// A section: the tip where it is entered, and the one where it is left.
    Section(At, At),
    /// A flat, which leads outwards or inwards: +1 or −1.
    Flat(f64),
}

/// Takes from tips at cusps what allows a step. `sections` are those of each run.
pub(crate) fn keep(runs: &Runs, sections: &mut [Vec<Section>]) {
    let mut passed = Vec::new();
    for (run, of_run) in runs.runs.iter().enumerate() {
        match of_run {
            Run::Flat(flat) if flat.from != flat.to => {
                passed.push(Passed::Flat((flat.to - flat.from).signum()))
            }
            Run::Flat(_) => {}
            Run::Wall(wall) => {
                let through = |section: usize| {
                    let tip = |upper: bool| At { run, section, upper };
                    Passed::Section(tip(!wall.rises), tip(wall.rises))
                };
                let count = sections[run].len();
                passed.extend((0..count).map(|i| through(if wall.rises { i } else { count - 1 - i })));
            }
        }
    }
    let n = passed.len();
    for i in 0..if runs.closed { n } else { n.saturating_sub(1) } {
        match (&passed[i], &passed[(i + 1) % n]) {
            (Passed::Section(_, left), Passed::Flat(outwards)) => {
                turn_back(&runs.runs, sections, *left, *outwards);
            }
            (Passed::Flat(outwards), Passed::Section(entered, _)) => {
                turn_back(&runs.runs, sections, *entered, *outwards);
            }
            (Passed::Section(_, left), Passed::Section(entered, _)) => {
                let both = [*left, *entered];
                let levels = both.map(|at| tip(sections, at).level);
                if levels == [true; 2]
                    && drawn(&runs.runs, sections, *left) != drawn(&runs.runs, sections, *entered)
                {
                    both.into_iter().for_each(|at| tip(sections, at).step = false);
                }
            }
            (Passed::Flat(_), Passed::Flat(_)) => {}
        }
    }
}

fn turn_back(runs: &[Run], sections: &mut [Vec<Section>], at: At, outwards: f64) {
    if drawn(runs, sections, at) != outwards {
        tip(sections, at).step = false;
    }
}

fn tip(sections: &mut [Vec<Section>], at: At) -> &mut Tip {
    let section = &mut sections[at.run][at.section];
    if at.upper { &mut section.high } else { &mut section.low }
}

/// The sign with which the radius changes there as the outline is drawn.
fn drawn(runs: &[Run], sections: &mut [Vec<Section>], at: At) -> f64 {
    let rises = matches!(&runs[at.run], Run::Wall(wall) if wall.rises);
    let leans = tip(sections, at).leans;
    if rises { leans } else { -leans }
}

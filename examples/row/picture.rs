//! What is shown, and how.

use crate::plane::{PIXELS, Point, along, colors, outline, seen, silhouettes};
use crate::svg::Svg;
use embedded_graphics::prelude::*;

const CLEAR: &str = r##"fill="#ececec""##;
const CLEAR_RAY: &str = r##"stroke="#aaaaaa" stroke-width="0.8" stroke-dasharray="3 4""##;
const SECTION: &str = r##"fill="#f7e6da" stroke="#333333" stroke-width="1.6""##;
const RAY: &str = r##"stroke="#8a8a8a" stroke-width="0.8""##;
const TANGENT: &str = r##"stroke="#1f4e8c" stroke-width="1.3""##;
const ROOT: &str = r##"fill="#b02a10""##;
const MIRRORED: &str = r##"fill="white" stroke="#b02a10" stroke-width="1.2""##;
const SILHOUETTE: &str = r##"fill="white" stroke="#1f4e8c" stroke-width="2""##;
const EYE: &str = r##"fill="#222222""##;
const MIDDLE: &str = r#"text-anchor="middle""#;
const END: &str = r#"text-anchor="end""#;

/// The eye's rays are drawn as far as this, and the pixels here.
const FAR: f32 = 2.7;
const SCREEN: f32 = 0.7;

pub fn picture() -> String {
    let mut svg = Svg::new();
    let eye = [0.0, 0.0];
    let silhouettes = silhouettes();
    let beyond = silhouettes.map(|[away, across]| [FAR, across * FAR / away]);

    let edges = [along(0, FAR), along(PIXELS - 1, FAR)];
    for (edge, tangent) in edges.into_iter().zip(beyond) {
        svg.shape(&[eye, edge, tangent], CLEAR);
    }
    svg.shape(&outline(), SECTION);
    for i in (1..PIXELS).step_by(6) {
        match seen(i) {
            Some(root) => svg.line(&[eye, root], RAY),
            None => svg.line(&[eye, along(i, FAR)], CLEAR_RAY),
        }
    }
    for tangent in beyond {
        svg.line(&[eye, tangent], TANGENT);
    }

    let half = 0.5 * (along(1, SCREEN)[1] - along(0, SCREEN)[1]);
    for (i, color) in (0..).zip(colors()) {
        let [away, across] = along(i, SCREEN);
        let corners = [(0.0, -half), (0.03, -half), (0.03, half), (0.0, half)];
        let fill = format!("fill=\"#{:06x}\" stroke=\"white\" stroke-width=\"0.4\"", color.into_storage());
        svg.shape(&corners.map(|(x, y)| [away + x, across + y]), &fill);
    }
    for i in 0..PIXELS {
        if let Some(root) = seen(i) {
            svg.dot(root, 2.8, if i < PIXELS / 2 { MIRRORED } else { ROOT });
        }
    }
    for point in silhouettes {
        svg.dot(point, 4.5, SILHOUETTE);
    }
    svg.dot(eye, 4.5, EYE);
    words(&mut svg, silhouettes);
    svg.finish()
}

/// Those along the rays lie between two of them.
fn words(svg: &mut Svg, [_, silhouette]: [Point; 2]) {
    let last = PIXELS - 1;
    svg.words([0.0, 0.09], 0.0, MIDDLE, "eye");
    svg.words([SCREEN, -0.245], 0.0, MIDDLE, "pixel 0");
    svg.words([SCREEN, 0.28], 0.0, MIDDLE, &format!("pixel {last}"));
    svg.words([2.03, 0.485], 13.0, MIDDLE, "clear: one look tells");
    svg.words([1.87, -0.13], -4.4, END, "their mirror images");
    svg.words([1.87, 0.1], 2.6, END, "outwards, root by root");
    svg.words([silhouette[0], silhouette[1] + 0.09], 0.0, MIDDLE, "silhouette");
    svg.words([0.5 * (silhouette[0] + FAR) - 0.12, 0.015], 0.0, MIDDLE, "inside, g &gt; 0");
    svg.words([2.61, -0.245], 0.0, MIDDLE, "g = 0");
}

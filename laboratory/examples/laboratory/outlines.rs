//! Segments against tolerance: the paper's halving of the control polygon, the fit of `embedded-lathe-outline`, and what
//! theory expects, for a curve of degree 5 in radius and height. Both axes are logarithmic.

use embedded_lathe_outline::{Fit, Outline, Piece, body, point};
use laboratory::subdivision::{Curve, expected, parts};
use plotters::prelude::*;
use std::error::Error;

/// A vase's wall, 2 high: its height is not linear in the parameter.
const R: [f64; 6] = [0.5, 1.5, 1.2, 0.1, 0.2, 0.9];
const Z: [f64; 6] = [0.0, 0.15, 0.9, 1.1, 1.85, 2.0];

const HALVED: RGBColor = RGBColor(50, 90, 150);
const FITTED: RGBColor = RGBColor(200, 60, 30);
const EXPECTED: [RGBColor; 3] = [RGBColor(120, 120, 120), RGBColor(215, 140, 20), RGBColor(90, 140, 60)];

type Line = Vec<(f64, f64)>;

pub fn write() -> Result<(), Box<dyn Error>> {
    let curve = Curve { r: R.to_vec(), z: Z.to_vec() };
    let controls: Vec<_> = R.iter().zip(Z).map(|(r, z)| point(*r, z)).collect();
    let outline = Outline::open(vec![Piece::bezier(&controls)])?;
    let tolerances: Vec<f64> = (0..=12).map(|i| 10f64.powf(-1.5 - 0.25 * f64::from(i))).collect();
    let halved: Line = tolerances.iter().map(|t| (*t, parts(&curve, *t) as f64)).collect();
    let mut fitted = Line::new();
    for tolerance in &tolerances {
        fitted.push((*tolerance, body(&outline, &Fit::within(*tolerance))?.segments() as f64));
    }
    let expected =
        |per: f64| -> Line { tolerances.iter().map(|t| (*t, expected(&curve, *t, per))).collect() };
    let theory = [
        ("Hermite on the curve: h⁴M/384", expected(384.0)),
        ("values and slopes shared: h⁴M/768", expected(768.0)),
        ("unconstrained: h⁴M/3072", expected(3072.0)),
    ];
    println!("tolerance, halved, fitted, 384, 768, 3072");
    for (i, tolerance) in tolerances.iter().enumerate() {
        let of = |k: usize| theory[k].1[i].1;
        println!(
            "{tolerance:.1e}, {}, {}, {:.1}, {:.1}, {:.1}",
            halved[i].1,
            fitted[i].1,
            of(0),
            of(1),
            of(2)
        );
    }
    draw(&halved, &fitted, &theory)
}

fn draw(halved: &Line, fitted: &Line, theory: &[(&str, Line); 3]) -> Result<(), Box<dyn Error>> {
    let root = SVGBackend::new("docs/segments.svg", (860, 460)).into_drawing_area();
    root.fill(&WHITE)?;
    let (finest, coarsest) = (halved[halved.len() - 1].0, halved[0].0);
    let most = halved.iter().fold(1.0, |most: f64, (_, count)| most.max(*count));
    let mut chart = ChartBuilder::on(&root)
        .caption("Segments for a wall of degree 5, 2 high", ("sans-serif", 19))
        .margin(12)
        .x_label_area_size(42)
        .y_label_area_size(66)
        .build_cartesian_2d((0.8 * finest..1.3 * coarsest).log_scale(), (0.8..1.5 * most).log_scale())?;
    chart
        .configure_mesh()
        .x_desc("tolerance: distance between the curves")
        .y_desc("segments")
        .axis_desc_style(("sans-serif", 14))
        .label_style(("sans-serif", 13))
        .light_line_style(WHITE)
        .bold_line_style(RGBColor(225, 225, 225))
        .x_label_formatter(&|x| format!("{x:.0e}"))
        .y_label_formatter(&|y| format!("{y:.0}"))
        .draw()?;
    for ((label, line), style) in theory.iter().zip(EXPECTED) {
        chart
            .draw_series(LineSeries::new(line.clone(), style.stroke_width(1)))?
            .label(*label)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], style.stroke_width(1)));
    }
    for (label, line, color) in
        [("control polygon halved, as the paper does", halved, HALVED), ("fitted and proven", fitted, FITTED)]
    {
        chart
            .draw_series(LineSeries::new(line.clone(), color.stroke_width(2)).point_size(3))?
            .label(label)
            .legend(move |(x, y)| PathElement::new([(x, y), (x + 18, y)], color.stroke_width(2)));
    }
    chart
        .configure_series_labels()
        .position(SeriesLabelPosition::UpperRight)
        .background_style(WHITE.mix(0.9))
        .border_style(RGBColor(200, 200, 200))
        .label_font(("sans-serif", 14))
        .draw()?;
    root.present()?;
    Ok(())
}

//! What is no outline is refused, and the error names the place.

use embedded_lathe_outline::{
    Fit, Half, Outline, OutlineError, Piece, Warning, body, point,
    read::{self, Axis, Options, Reason, Unit},
};

fn svg(inside: &str) -> String {
    format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"20mm\" height=\"40mm\" viewBox=\"0 0 20 40\">\n{inside}\n</svg>"
    )
}

/// Line, column and message.
fn refused(text: &str, options: &Options) -> (u32, u32, Reason) {
    let error = read::svg(text, options).expect_err("refused");
    (error.line, error.column, error.reason)
}

#[test]
fn syntax_by_line_and_column() {
    let options = Options::default();
    let (line, column, reason) = refused(&svg("<path d=\"M 0 0 L 5 x 7\"/>"), &options);
    assert!((line, column) == (2, 20) && matches!(reason, Reason::Syntax(_)), "{line}:{column} {reason}");
    let (line, _, reason) = refused(&svg("<path d=\"M 0 0 L 5 5\">"), &options);
    assert!(line == 3 && matches!(reason, Reason::Syntax(_)), "{line} {reason}");
    let (line, column, reason) =
        refused(&svg("<g transform=\"rotate(1)scale(q)\"><path d=\"M0 0L5 5\"/></g>"), &options);
    assert!(line == 2 && column >= 15 && matches!(reason, Reason::Syntax(_)), "{line}:{column} {reason}");
    let (_, _, reason) = refused(&svg("<path d=\"M0 0\"/>"), &options);
    assert_eq!(reason, Reason::Outline(OutlineError::Empty));
    let (_, _, reason) = refused(&svg("<defs><path d=\"M0 0L5 5\"/></defs>"), &options);
    assert_eq!(reason, Reason::NoShape);
}

#[test]
fn several_paths_are_listed() {
    let text = svg(
        "<path id=\"body\" d=\"M0 0L5 5\"/>\n<rect id=\"frame\" width=\"3\" height=\"4\"/>\n<path d=\"M1 1L2 2\"/>",
    );
    let names = ["body", "frame", "path in line 4"].map(String::from).to_vec();
    assert_eq!(refused(&text, &Options::default()), (3, 1, Reason::Ambiguous(names.clone())));
    let options = |name: &str| Options { name: Some(name.into()), ..Options::default() };
    let (.., reason) = refused(&text, &options("lid"));
    assert_eq!(reason, Reason::NotFound { name: "lid".into(), names });
    let drawing = read::svg(&text, &options("frame")).unwrap();
    assert_eq!(drawing.warnings.len(), 2);
    assert_eq!(drawing.warnings[0], Warning::LeftOut { what: "body".into() });
}

#[test]
fn lines_of_one_path_are_joined_or_listed() {
    let read = |d: &str, name: Option<&str>| {
        let options = Options { name: name.map(String::from), ..Options::default() };
        read::svg(&svg(&format!("<path id=\"p\" d=\"{d}\"/>")), &options)
    };
    // Three strokes, the second one drawn backwards: a triangle.
    let joined = read("M0 0L5 5M3 9L5 5M3 9L0 0", None).unwrap().outline;
    assert!(joined.is_closed() && joined.pieces().len() == 3, "{joined:?}");
    // Two loops are two bodies, each with a name of its own.
    let loops = "M0 0L5 5L0 5z\nm10 0l5 5h-5z";
    let error = read(loops, None).unwrap_err();
    assert_eq!((error.line, error.column), (3, 6));
    assert_eq!(error.reason, Reason::Ambiguous(vec!["p#1".into(), "p#2".into()]));
    let second = read(loops, Some("p#2")).unwrap();
    assert_eq!(second.outline.bounds(), [point(10.0, 0.0), point(15.0, 5.0)]);
    assert_eq!(second.name.as_deref(), Some("p#2"));
    assert_eq!(second.warnings, [Warning::LeftOut { what: "p#1".into() }]);
}

#[test]
fn errors_of_outlines_name_the_place_in_the_file() {
    let refused = |drawing: Result<read::Drawing, read::ReadError>| {
        let drawing = drawing.unwrap();
        let error = body(&drawing.outline, &Fit::within(0.01)).unwrap_err();
        let error = drawing.error("file".as_ref(), error);
        (error.line, error.column, error.to_string())
    };
    // The axis is crossed by the command that begins the second line of the path.
    let (line, column, text) =
        refused(read::svg(&svg("<path d=\"M5 0 L5 5 3 7\nL-1 9H-2\"/>"), &Options::default()));
    assert_eq!((line, column), (3, 1), "{text}");
    assert!(text.starts_with("file:3:1: the outline crosses the axis at height 0.5"), "{text}");
    let straight = Options { straight: true, ..Options::default() };
    let table = read::table("height,radius\n0,1\n1,2\n2,1\n3,-1\n4,-1\n", &straight);
    let (line, column, text) = refused(table);
    assert_eq!((line, column), (4, 1), "{text}");
    let form = "{\"a\": {\"kind\": \"polygon\", \"points\": [[1, 0], [2, 1]]},\n \"b\": {\"kind\": \"polygon\", \"points\": [[1, 0], [2, 2],\n  [1, 2], [2, 0]]}}";
    let (line, column, text) =
        refused(read::json(form, &Options { name: Some("b".into()), ..Options::default() }));
    assert!((line, column) == (2, 38) || (line, column) == (3, 3), "{line}:{column} {text}");
    assert!(text.contains("crosses itself at height 1, radius 1.5"), "{text}");
}

#[test]
fn lengths_need_a_unit() {
    for size in ["", "width=\"100%\"", "width=\"540\"", "width=\"540px\" viewBox=\"0 0 540 120\""] {
        let text = format!("<svg xmlns=\"http://www.w3.org/2000/svg\" {size}><path d=\"M0 0L5 5\"/></svg>");
        assert_eq!(refused(&text, &Options::default()).2, Reason::NoUnit, "{size}");
        let options = Options { unit: Unit::from_name("0.5mm"), ..Options::default() };
        assert_eq!(read::svg(&text, &options).unwrap().outline.bounds(), [point(0.0, 0.0), point(2.5, 2.5)]);
    }
    let text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"540mm\" viewBox=\"0 0 540 120\"><path d=\"M0 0L5 5\"/></svg>";
    assert_eq!(read::svg(text, &Options::default()).unwrap().outline.bounds()[1], point(5.0, 5.0));
    let text = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"1in\" viewBox=\"0 0 10 10\"><path d=\"M0 0L5 5\"/></svg>";
    assert_eq!(read::svg(text, &Options::default()).unwrap().outline.bounds()[1].r, 12.7);
}

#[test]
fn transforms_in_their_order() {
    let right = |transform: &str| {
        let text = svg(&format!("<g transform=\"{transform}\"><path d=\"M1 1L2 3\"/></g>"));
        read::svg(&text, &Options::default()).unwrap().outline.bounds()[1].r
    };
    assert_eq!(right("translate(10,20) scale(2)"), 14.0);
    assert_eq!(right("scale(2) translate(10,20)"), 24.0);
    let nested = svg("<g transform=\"scale(2)\"><path transform=\"translate(10)\" d=\"M1 1L2 3\"/></g>");
    assert_eq!(read::svg(&nested, &Options::default()).unwrap().outline.bounds()[1].r, 24.0);
}

#[test]
fn every_command_and_arcs_with_flags_that_touch() {
    let bounds = |d: &str| {
        read::svg(&svg(&format!("<path d=\"{d}\"/>")), &Options::default()).unwrap().outline.bounds()
    };
    // A half circle about the axis, its flags and the number after them without blanks.
    for d in ["M0 2a1 1 0 01 0-2", "M0,2A1,1,0,0,1,0,0", "m0 2a1 1 0 0 1-0-2"] {
        let [low, high] = bounds(d);
        assert!(
            (low.z, high.z) == (0.0, 2.0) && (low.r.abs() - 1.0).abs().min((high.r - 1.0).abs()) < 1e-12,
            "{d}: {low:?} {high:?}"
        );
    }
    // Relative and absolute say the same.
    let absolute = "M1 1L3 2H5V4C6 5 6 6 5 7S3 9 4 10Q6 11 5 12T6 14A2 1 30 0 1 8 15Z";
    let relative = "m1 1l2 1h2v2c1 1 1 2 0 3s-2 2-1 3q2 1 1 2t1 2a2 1 30 0 1 2 1z";
    let [a, b] = [bounds(absolute), bounds(relative)];
    for i in 0..2 {
        assert!((a[i].r - b[i].r).abs() < 1e-12 && (a[i].z - b[i].z).abs() < 1e-12, "{a:?} {b:?}");
    }
}

#[test]
fn the_axis_by_element_number_or_edge() {
    let text = svg("<path d=\"M5 0L9 3L5 8\"/><line id=\"axis\" x1=\"5\" y1=\"0\" x2=\"5\" y2=\"40\"/>");
    let least = |options: &Options| read::svg(&text, options).unwrap().outline.bounds()[0].r;
    assert_eq!(least(&Options::default()), 0.0);
    assert_eq!(least(&Options { axis: Axis::At(4.0), ..Options::default() }), 1.0);
    assert_eq!(least(&Options { axis: Axis::LeftEdge, ..Options::default() }), 0.0);
    let slanted = svg("<path d=\"M5 0L9 3\"/>\n<line id=\"axis\" x1=\"5\" y1=\"0\" x2=\"6\" y2=\"40\"/>");
    assert_eq!(refused(&slanted, &Options::default()), (3, 1, Reason::Axis));
}

#[test]
fn tables_by_line_and_field() {
    let table = |text: &str, straight| read::table(text, &Options { straight, ..Options::default() });
    let error = table("height,radius\n0,1\n1,x\n", false).unwrap_err();
    assert_eq!((error.line, error.column), (3, 3));
    let error = table("0,1\n1,nan\n", false).unwrap_err();
    assert_eq!((error.line, error.column), (2, 3));
    let error = table("0,1\n1\n", false).unwrap_err();
    assert_eq!((error.line, error.column), (2, 1));
    assert_eq!(table("", false).unwrap_err().reason, Reason::Outline(OutlineError::Empty));
    let swapped = table("radius,height\n1,0\n2,3\n", true).unwrap();
    assert_eq!(swapped.outline.bounds(), [point(1.0, 0.0), point(2.0, 3.0)]);
    // A row that stands twice is a corner: straight lines on both sides of it.
    let corner = table("0,1\n1,2\n1,2\n2,1\n", false).unwrap();
    assert_eq!(body(&corner.outline, &Fit::within(0.1)).unwrap().segments(), 2);
}

#[test]
fn outlines_on_both_sides_of_the_axis() {
    let circle = |r: f64| {
        Outline::closed(Piece::arc(
            point(r, 2.0),
            point(1.0, 0.0),
            point(0.0, 1.0),
            0.0,
            std::f64::consts::TAU,
        ))
        .unwrap()
    };
    let fit = Fit::within(0.01);
    let Err(OutlineError::CrossesAxis { heights }) = body(&circle(0.0), &fit) else { panic!() };
    assert!(
        heights.len() == 2 && (heights[0] - 1.0).abs() < 1e-9 && (heights[1] - 3.0).abs() < 1e-9,
        "{heights:?}"
    );
    for half in [Half::Right, Half::Left] {
        let half = body(&circle(0.0), &Fit { half: Some(half), ..fit }).unwrap();
        assert_eq!(half.segments(), 1);
        let [Warning::HalvesDiffer { by }] = half.warnings.as_slice() else { panic!("{:?}", half.warnings) };
        assert!(*by < 1e-3, "{by}");
    }
    let mirrored = body(&circle(-3.0), &fit).unwrap();
    assert_eq!(mirrored.warnings, [Warning::Mirrored]);
    assert_eq!(mirrored.sheets.len(), 2);
}

#[test]
fn what_crosses_itself_is_torn_or_empty() {
    let fit = Fit::within(0.01);
    let bow = Outline::polygon(&[point(1.0, 0.0), point(2.0, 2.0), point(1.0, 2.0), point(2.0, 0.0)], true)
        .unwrap();
    assert_eq!(body(&bow, &fit), Err(OutlineError::CrossesItself { height: 1.0, radius: 1.5 }));
    let torn = Outline::open(vec![
        Piece::line(point(1.0, 0.0), point(1.0, 1.0)),
        Piece::line(point(1.0, 1.1), point(1.0, 2.0)),
    ]);
    assert_eq!(torn, Err(OutlineError::NotJoined { end: point(1.0, 1.0), start: point(1.0, 1.1) }));
    assert_eq!(Outline::open(vec![]), Err(OutlineError::Empty));
    let flat = Outline::polygon(&[point(0.0, 1.0), point(1.0, 1.0)], false).unwrap();
    assert_eq!(body(&flat, &fit), Err(OutlineError::NoWall));
    let endless = Outline::polygon(&[point(0.0, 1.0), point(f64::INFINITY, 2.0)], false);
    assert_eq!(endless, Err(OutlineError::NotFinite { piece: 0 }));
    let line = Outline::polygon(&[point(1.0, 0.0), point(1.0, 1.0)], false).unwrap();
    for tolerance in [0.0, -1.0, f64::INFINITY] {
        assert_eq!(body(&line, &Fit::within(tolerance)), Err(OutlineError::Tolerance(tolerance)));
    }
}

#[test]
fn heights_that_are_one_number_are_named() {
    let wall = [point(1.0, 1e6), point(1.2, 1e6 + 1e-3), point(1.2, 1e6 + 10.0)];
    let body = body(&Outline::polygon(&wall, false).unwrap(), &Fit::within(0.5)).unwrap();
    assert_eq!(body.warnings, [Warning::Merged { heights: [1e6, 1e6 + 1e-3] }]);
    assert_eq!(body.segments(), 1);
}

#[test]
fn shallow_turns_are_straightened_and_fins_are_not() {
    // A dip of 0.02, and a fin as thin that is 3 wide.
    let dip = [[1.0, 0.0], [1.0, 2.0], [1.5, 1.98], [1.5, 4.0]].map(|[r, z]| point(r, z));
    let body = |points: &[embedded_lathe_outline::Point]| {
        body(&Outline::polygon(points, false).unwrap(), &Fit::within(0.1)).unwrap()
    };
    let straight = body(&dip);
    assert_eq!((straight.sheets.len(), straight.segments()), (1, 2));
    assert!(
        matches!(straight.warnings[..], [Warning::Straightened { .. }])
            && (straight.error - 0.01).abs() < 1e-6
    );
    let fin =
        [[1.0, 0.0], [1.0, 2.0], [4.0, 1.99], [1.0, 1.98], [1.0, 1.0], [0.5, 1.0]].map(|[r, z]| point(r, z));
    assert!(body(&fin[..3]).warnings.len() == 1);
}

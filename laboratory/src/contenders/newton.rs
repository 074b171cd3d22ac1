/// Newton's method with nothing to hold it, from the left end of the interval, the nearest place to the root asked for: until a step is
/// below rounding, 32 at most.
pub fn first_root(&[c0, c1, c2, c3]: &[f32; 4], lo: f32, hi: f32) -> Option<f32> {
    let mut u = lo;
    for _ in 0..32 {
        let value = ((c3 * u + c2) * u + c1) * u + c0;
        let slope = (3.0 * c3 * u + 2.0 * c2) * u + c1;
        let step = value / slope;
        u -= step;
        if step.abs() <= f32::EPSILON * u.abs() {
            break;
        }
    }
    (lo <= u && u <= hi).then_some(u)
}

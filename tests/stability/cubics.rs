use crate::laboratory::families::FAMILIES;
use crate::laboratory::contenders::{EVERYWHERE, HOST};
use crate::laboratory::judge::Truth;

#[test]
fn look() {
    for family in FAMILIES {
        let start = std::time::Instant::now();
        let mut occurred = 0;
        let n = 300;
        let mut bad = std::collections::BTreeMap::<String, (usize, f64)>::new();
        for i in 0..n {
            let q = family.question(1, i);
            let truth = Truth::new(&q.c, q.lo, q.hi);
            occurred += (family.occurred)(&q, &truth) as usize;
            for c in EVERYWHERE.iter().chain(HOST) {
                let v = truth.judge((c.first_root)(&q.c, q.lo, q.hi).map(f64::from));
                let e = bad.entry(format!("{} {}", c.method, c.backend)).or_default();
                e.0 += (v.units > 64.0) as usize;
                e.1 = e.1.max(v.units);
            }
            for c in crate::laboratory::peers::PEERS {
                let v = truth.judge((c.first_root)(q.c.map(f64::from), q.lo.into(), q.hi.into()));
                let e = bad.entry(format!("{}", c.name)).or_default();
                e.0 += (v.units > 64.0) as usize;
                e.1 = e.1.max(v.units);
            }
        }
        println!("{} occurred {occurred}/{n} {:?}\n   {bad:?}", family.name, start.elapsed());
    }
}

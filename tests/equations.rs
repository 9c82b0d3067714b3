//! dump
#[test]
fn dump() {
    for f in jointproof::catalog::CATALOG {
        let show = |fs: &[jointproof::formula::Field]| fs.iter().map(|x| format!("{}={}:{}", x.name, x.quantity.latex, x.len())).collect::<Vec<_>>().join("  ");
        println!("## {}\n   {}\n   IN {}\n   OUT {}", f.spec().id, f.spec().latex, show(f.inputs()), show(f.outputs()));
    }
}

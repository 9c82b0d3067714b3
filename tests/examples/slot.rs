//! A SLOT connector: validated once, then evaluated. Needs no feature.
//!
//! ```sh
//! cargo run --example slot
//! ```

use jointproof::connector::slot::{ContactForce, CrossForces, Pose, Slot};
use jointproof::element::frame::Triad;
use jointproof::formula::value_and_jacobian;
use nalgebra::Vector3;

fn main() -> Result<(), jointproof::Error> {
    let start = Pose { triad: Triad::global(), xa: Vector3::zeros(), xb: Vector3::new(1.0, 2.0, 3.0) };
    let slot = Slot::new(&start)?.with_stops(0.0, 4.0)?.with_friction(0.25, 1.0)?;

    let moved = Pose { xb: Vector3::new(3.5, 2.0, 3.25), ..start };
    println!("off the slot by      {:?}", slot.constraint(&moved)?);
    println!("moved along it by    {:?}", slot.relative_motion(&moved)?.u1);
    println!("yield function       {:?}", slot.friction(-2.0, 3.0, 4.0)?.phi);

    let (contact, jac) = value_and_jacobian::<ContactForce>(&CrossForces { f2: 3.0, f3: 4.0 })?;
    println!("contact force        {:?}, with derivatives {:?} and {:?}", contact.fc, jac.fc.f2, jac.fc.f3);

    if let Err(error) = slot.with_friction(-0.25, 0.0) {
        println!("what is not allowed  {error}");
    }
    Ok(())
}

//! The quantities of this field. Temperatures are absolute; heat flows from side 1 to side 2.

use jointproof::formula::quantity::Domain::{NonNegative, Positive, Real};
use jointproof::formula::quantity::{Quantity, Unit};
use jointproof::formula::{Document, Source};

const TEXTBOOK: Document = Document::new("J. H. Lienhard, A Heat Transfer Textbook").link("https://ahtt.mit.edu/");
/// Where the flux across a gap is from.
pub const TWO_WAYS: Source = TEXTBOOK.ours(SECTION, "the conductance is written as the sum of gas and touching spots");
/// Where the flux through a wall is from.
pub const IN_SERIES: Source = TEXTBOOK.ours(SECTION, "resistances in series, written for two layers and their contact");
const SECTION: &str = "Thermal resistance and the electrical analogy";

const K: Unit = Unit::TEMPERATURE;
const CONDUCTIVITY: Unit = Unit::F.per(Unit::T.times(K));
const CONDUCTANCE: Unit = CONDUCTIVITY.per(Unit::L);
const PRESSURE: Unit = Unit::new(-2, 1, 0);

pub const T1: Quantity = Quantity::scalar("T_1", K, Positive, "temperature of side 1");
pub const T2: Quantity = Quantity::scalar("T_2", K, Positive, "temperature of side 2");
pub const Q: Quantity = Quantity::scalar("q", CONDUCTANCE.times(K), Real, "heat flux from side 1 to side 2");

pub const C: Quantity = Quantity::scalar("c", Unit::L, NonNegative, "clearance between the surfaces");
pub const G: Quantity = Quantity::scalar("g", Unit::L, Positive, "temperature jump distance of the gas");
pub const KG: Quantity = Quantity::scalar("k_g", CONDUCTIVITY, Positive, "conductivity of the gas");
pub const P: Quantity = Quantity::scalar("p", PRESSURE, NonNegative, "contact pressure");
pub const A: Quantity =
    Quantity::scalar("a", CONDUCTANCE.per(PRESSURE), NonNegative, "conductance of the touching spots per pressure");

pub const LA: Quantity = Quantity::scalar("L_a", Unit::L, Positive, "thickness of the first layer");
pub const KA: Quantity = Quantity::scalar("k_a", CONDUCTIVITY, Positive, "conductivity of the first layer");
pub const LB: Quantity = Quantity::scalar("L_b", Unit::L, Positive, "thickness of the second layer");
pub const KB: Quantity = Quantity::scalar("k_b", CONDUCTIVITY, Positive, "conductivity of the second layer");
pub const H: Quantity = Quantity::scalar("h", CONDUCTANCE, Positive, "conductance of the contact between the layers");

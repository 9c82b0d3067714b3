//! The elements, and sets of them.

use crate::Scalar;
use crate::error::Error;
use crate::formula::Formula;
use crate::slide_line::{
    ContactAreaLinear, ContactAreaParabolic, LinearNodes, LinearPressures, Nodes, ParabolicNodes, ParabolicPressures,
    TorqueLinear, TorqueParabolic,
};
use arrayvec::ArrayVec;
use nalgebra::Vector2;
use std::collections::BTreeSet;

/// An axisymmetric slide-line element: two or three nodes of the slave surface, each an integration point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Element {
    number: u32,
    nodes: ArrayVec<u32, 3>,
}

impl Element {
    /// ISL21A, for first-order elements: two nodes.
    ///
    /// # Errors
    /// [`Error::Element`]: a node that is given twice.
    pub fn isl21a(number: u32, nodes: [u32; 2]) -> Result<Self, Error> {
        Self::new(number, nodes.into_iter().collect())
    }

    /// ISL22A, for second-order elements: three nodes in sequence, the second of which is the midside node.
    ///
    /// # Errors
    /// [`Error::Element`]: a node that is given twice.
    pub fn isl22a(number: u32, nodes: [u32; 3]) -> Result<Self, Error> {
        Self::new(number, nodes.into())
    }

    fn new(number: u32, nodes: ArrayVec<u32, 3>) -> Result<Self, Error> {
        if nodes.iter().collect::<BTreeSet<_>>().len() < nodes.len() {
            let fault = "has a node twice";
            return Err(Error::Element { element: number, fault, allowed: "different nodes" });
        }
        Ok(Self { number, nodes })
    }

    /// Its number.
    pub fn number(&self) -> u32 {
        self.number
    }

    /// The numbers of its nodes in sequence.
    pub fn nodes(&self) -> &[u32] {
        &self.nodes
    }

    /// Where its nodes are.
    ///
    /// # Errors
    /// [`Error::UnknownNode`], [`Error::CoincidentNodes`].
    fn places<D: Scalar>(&self, nodes: &Nodes<D>) -> Result<ArrayVec<Vector2<D>, 3>, Error> {
        let mut places = ArrayVec::new();
        for &second in &self.nodes {
            let here = nodes.position(second)?;
            let same = |place: &Vector2<D>| place.map(|x| x.re()) == here.map(|x| x.re());
            if let Some((&first, _)) = self.nodes.iter().zip(&places).find(|(_, place)| same(place)) {
                return Err(Error::CoincidentNodes { first, second });
            }
            places.push(here);
        }
        Ok(places)
    }

    /// The contact area of each of its nodes in its current place, around the whole circumference
    /// ([`ContactAreaLinear`], [`ContactAreaParabolic`]).
    ///
    /// ```
    /// use jointproof::{isl::Element, slide_line::Nodes};
    /// let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [4.0, 4.0])])?;
    /// let areas = Element::isl21a(10, [1, 2])?.areas(&nodes)?;
    /// assert_eq!(areas[1], 20.0 * std::f64::consts::PI); // π ℓ r₂
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::UnknownNode`], [`Error::CoincidentNodes`], [`Error::Overflow`].
    pub fn areas<D: Scalar>(&self, nodes: &Nodes<D>) -> Result<ArrayVec<D, 3>, Error> {
        let areas: ArrayVec<D, 3> = match *self.places(nodes)?.as_slice() {
            [x1, x2, x3] => {
                let areas = ContactAreaParabolic::eval(&ParabolicNodes { x1, x2, x3 });
                [areas.a1, areas.a2, areas.a3].into()
            }
            [x1, x2] => {
                let areas = ContactAreaLinear::eval(&LinearNodes { x1, x2 });
                [areas.a1, areas.a2].into_iter().collect()
            }
            _ => ArrayVec::new(),
        };
        let finite = areas.iter().all(|area| area.re().is_finite());
        if finite { Ok(areas) } else { Err(Error::Overflow { name: "area" }) }
    }

    /// The greatest torque about the z axis that it transmits, from the pressures at its nodes
    /// ([`TorqueLinear`], [`TorqueParabolic`]).
    ///
    /// # Errors
    /// As [`Self::areas`], or whatever `pressure` of a node answers with.
    pub fn torque<D: Scalar>(&self, nodes: &Nodes<D>, pressure: impl Fn(u32) -> Result<D, Error>) -> Result<D, Error> {
        let places = self.places(nodes)?;
        let pressures = self.nodes.iter().map(|&node| pressure(node)).collect::<Result<ArrayVec<_, 3>, _>>()?;
        let t = match (places.as_slice(), pressures.as_slice()) {
            (&[x1, x2, x3], &[p1, p2, p3]) => TorqueParabolic::eval(&ParabolicPressures { x1, x2, x3, p1, p2, p3 }).t,
            (&[x1, x2], &[p1, p2]) => TorqueLinear::eval(&LinearPressures { x1, x2, p1, p2 }).t,
            _ => D::zero(),
        };
        if t.re().is_finite() { Ok(t) } else { Err(Error::Overflow { name: "torque" }) }
    }
}

/// A named set of elements, as \*SLIDE LINE refers to it (ELSET).
///
/// ```
/// use jointproof::isl::{Element, ElementSet};
/// let twice = [Element::isl21a(1, [1, 2])?, Element::isl21a(1, [2, 3])?];
/// let error = ElementSet::new("flank", twice).unwrap_err();
/// assert_eq!(error.to_string(), "element 1 is given twice; allowed are different numbers");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ElementSet {
    name: String,
    elements: Vec<Element>,
}

impl ElementSet {
    /// A set of at least one element, each with a number of its own.
    ///
    /// # Errors
    /// [`Error::EmptySet`], [`Error::Element`].
    pub fn new(name: impl Into<String>, elements: impl Into<Vec<Element>>) -> Result<Self, Error> {
        let (name, elements) = (name.into(), elements.into());
        if elements.is_empty() {
            return Err(Error::EmptySet { name });
        }
        let mut seen = BTreeSet::new();
        match elements.iter().find(|element| !seen.insert(element.number)) {
            None => Ok(Self { name, elements }),
            Some(element) => {
                let (fault, allowed) = ("is given twice", "different numbers");
                Err(Error::Element { element: element.number, fault, allowed })
            }
        }
    }

    /// Its name.
    pub fn name(&self) -> &str {
        &self.name
    }

    /// Its elements.
    pub fn elements(&self) -> &[Element] {
        &self.elements
    }

    /// The nodes of all its elements, each once, by number.
    pub fn nodes(&self) -> BTreeSet<u32> {
        self.elements.iter().flat_map(|element| element.nodes.iter().copied()).collect()
    }
}

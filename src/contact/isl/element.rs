//! The elements, and sets of them.

use crate::Scalar;
use crate::contact::slide_line::{
    ContactAreaLinear, ContactAreaParabolic, LinearNodes, LinearPressures, Nodes, ParabolicNodes, ParabolicPressures,
    TorqueLinear, TorqueParabolic,
};
use crate::formula::Formula;
use crate::formula::error::Error;
use arrayvec::ArrayVec;
use nalgebra::Vector2;
use std::collections::BTreeSet;

/// An axisymmetric slide-line element: two or three nodes of the slave surface, each an integration point.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct IslElement {
    number: u32,
    nodes: ElementNodes,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum ElementNodes {
    Isl21a([u32; 2]),
    Isl22a([u32; 3]),
}

impl IslElement {
    /// ISL21A, for first-order elements: two nodes.
    ///
    /// # Errors
    /// [`Error::Element`]: a node that is given twice.
    pub fn isl21a(number: u32, nodes: [u32; 2]) -> Result<Self, Error> {
        Self::new(number, ElementNodes::Isl21a(nodes))
    }

    /// ISL22A, for second-order elements: three nodes in sequence, the second of which is the midside node.
    ///
    /// # Errors
    /// [`Error::Element`]: a node that is given twice.
    pub fn isl22a(number: u32, nodes: [u32; 3]) -> Result<Self, Error> {
        Self::new(number, ElementNodes::Isl22a(nodes))
    }

    fn new(number: u32, nodes: ElementNodes) -> Result<Self, Error> {
        let element = Self { number, nodes };
        if element.nodes().iter().collect::<BTreeSet<_>>().len() < element.nodes().len() {
            let fault = "has a node twice";
            return Err(Error::Element { element: number, fault, allowed: "different nodes" });
        }
        Ok(element)
    }

    /// Its number.
    pub fn number(&self) -> u32 {
        self.number
    }

    /// The numbers of its nodes in sequence.
    pub fn nodes(&self) -> &[u32] {
        match &self.nodes {
            ElementNodes::Isl21a(nodes) => nodes,
            ElementNodes::Isl22a(nodes) => nodes,
        }
    }

    /// The contact area of each of its nodes at its current position, around the whole circumference ([`ContactAreaLinear`],
    /// [`ContactAreaParabolic`]).
    ///
    /// ```
    /// use jointproof::contact::{isl::IslElement, slide_line::Nodes};
    /// let nodes = Nodes::new([(1, [1.0, 0.0]), (2, [4.0, 4.0])])?;
    /// let areas = IslElement::isl21a(10, [1, 2])?.areas(&nodes)?;
    /// assert_eq!(areas[1], 20.0 * std::f64::consts::PI); // π ℓ r₂
    /// # Ok::<(), jointproof::Error>(())
    /// ```
    ///
    /// # Errors
    /// [`Error::UnknownNode`], [`Error::CoincidentNodes`], [`Error::Overflow`].
    pub fn areas<D: Scalar>(&self, nodes: &Nodes<D>) -> Result<ArrayVec<D, 3>, Error> {
        self.areas_by(|node| nodes.position(node))
    }

    /// The same, with positions provided by the caller.
    pub(super) fn areas_by<D: Scalar>(
        &self,
        position: impl Fn(u32) -> Result<Vector2<D>, Error>,
    ) -> Result<ArrayVec<D, 3>, Error> {
        let areas: ArrayVec<D, 3> = match self.nodes {
            ElementNodes::Isl21a(nodes) => {
                let [x1, x2] = places(nodes, position)?;
                let areas = ContactAreaLinear::eval(&LinearNodes { x1, x2 });
                [areas.a1, areas.a2].into_iter().collect()
            }
            ElementNodes::Isl22a(nodes) => {
                let [x1, x2, x3] = places(nodes, position)?;
                let areas = ContactAreaParabolic::eval(&ParabolicNodes { x1, x2, x3 });
                [areas.a1, areas.a2, areas.a3].into()
            }
        };
        let finite = areas.iter().all(|area| area.re().is_finite());
        if finite { Ok(areas) } else { Err(Error::Overflow { name: "area" }) }
    }

    /// The greatest torque about the z axis that the element transmits, from the pressures at its nodes ([`TorqueLinear`],
    /// [`TorqueParabolic`]).
    ///
    /// # Errors
    /// As [`Self::areas`], or any error returned by `pressure`.
    pub fn torque<D: Scalar>(&self, nodes: &Nodes<D>, pressure: impl Fn(u32) -> Result<D, Error>) -> Result<D, Error> {
        self.torque_by(|node| nodes.position(node), |k| pressure(self.nodes()[k]))
    }

    /// The same, with positions and pressures provided by the caller: positions by node number, pressures by the index of the
    /// node in the element.
    pub(super) fn torque_by<D: Scalar>(
        &self,
        position: impl Fn(u32) -> Result<Vector2<D>, Error>,
        pressure: impl Fn(usize) -> Result<D, Error>,
    ) -> Result<D, Error> {
        let t = match self.nodes {
            ElementNodes::Isl21a(nodes) => {
                let ([x1, x2], [p1, p2]) = (places(nodes, position)?, of_each([0, 1], pressure)?);
                TorqueLinear::eval(&LinearPressures { x1, x2, p1, p2 }).t
            }
            ElementNodes::Isl22a(nodes) => {
                let ([x1, x2, x3], [p1, p2, p3]) = (places(nodes, position)?, of_each([0, 1, 2], pressure)?);
                TorqueParabolic::eval(&ParabolicPressures { x1, x2, x3, p1, p2, p3 }).t
            }
        };
        if t.re().is_finite() { Ok(t) } else { Err(Error::Overflow { name: "torque" }) }
    }

    /// The formula of its areas.
    pub(crate) fn area_formula(&self) -> &'static str {
        match self.nodes {
            ElementNodes::Isl21a(_) => ContactAreaLinear::SPEC.id,
            ElementNodes::Isl22a(_) => ContactAreaParabolic::SPEC.id,
        }
    }

    /// The formula of its torque.
    pub(crate) fn torque_formula(&self) -> &'static str {
        match self.nodes {
            ElementNodes::Isl21a(_) => TorqueLinear::SPEC.id,
            ElementNodes::Isl22a(_) => TorqueParabolic::SPEC.id,
        }
    }
}

/// The positions of nodes that must be distinct.
fn places<D: Scalar, const N: usize>(
    nodes: [u32; N],
    position: impl Fn(u32) -> Result<Vector2<D>, Error>,
) -> Result<[Vector2<D>; N], Error> {
    let places = of_each(nodes, position)?;
    let at = |k: usize| places[k].map(|x: D| x.re());
    let mut pairs = (1..N).flat_map(|later| (0..later).map(move |earlier| (earlier, later)));
    match pairs.find(|&(earlier, later)| at(earlier) == at(later)) {
        Some((earlier, later)) => Err(Error::CoincidentNodes { first: nodes[earlier], second: nodes[later] }),
        None => Ok(places),
    }
}

/// The value for each of these keys, or the first error.
fn of_each<K, T: Copy, const N: usize>(these: [K; N], of: impl Fn(K) -> Result<T, Error>) -> Result<[T; N], Error> {
    let all = these.into_iter().map(of).collect::<Result<ArrayVec<T, N>, _>>()?;
    Ok(all.into_inner().unwrap_or_else(|_| unreachable!("each has one")))
}

/// A named set of elements, as \*SLIDE LINE refers to it (ELSET).
///
/// ```
/// use jointproof::contact::isl::{ElementSet, IslElement};
/// let twice = [IslElement::isl21a(1, [1, 2])?, IslElement::isl21a(1, [2, 3])?];
/// let error = ElementSet::new("flank", twice).unwrap_err();
/// assert_eq!(error.to_string(), "element 1 is given twice; allowed are different numbers");
/// # Ok::<(), jointproof::Error>(())
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct ElementSet {
    name: String,
    elements: Vec<IslElement>,
}

impl ElementSet {
    /// A set of at least one element, each with a number of its own.
    ///
    /// # Errors
    /// [`Error::EmptySet`], [`Error::Element`].
    pub fn new(name: impl Into<String>, elements: impl Into<Vec<IslElement>>) -> Result<Self, Error> {
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
    pub fn elements(&self) -> &[IslElement] {
        &self.elements
    }

    /// The nodes of all its elements, each once, by number.
    pub fn nodes(&self) -> BTreeSet<u32> {
        self.elements.iter().flat_map(|element| element.nodes().iter().copied()).collect()
    }
}

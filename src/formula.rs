//! The one definition of a formula, from which everything else follows.
//!
//! To add a formula: declare its inputs and outputs with [`fields!`](crate::fields), write a unit struct, implement
//! [`Formula`] for it, and name it in the catalog. The closed-form Jacobian has the type
//! `Outputs<Inputs<D>>`: the outputs, with every component replaced by its gradient, whose fields have the names of the
//! inputs. `jac.fc.f2` is ∂fc/∂f2.

#![expect(clippy::inline_always, reason = "a call for a component costs more than the component")]

use crate::error::Error;
use crate::measure::Way;
use crate::quantity::{Domain, Quantity};
use crate::{Octuple, Scalar};
use nalgebra::{SVector, Vector2, Vector3};
use std::fmt::Debug;

/// What a field may hold: a number, or a gradient of numbers.
pub trait Element: Copy + Debug + PartialEq + 'static {}
impl<T: Copy + Debug + PartialEq + 'static> Element for T {}

/// A named input or output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// The name, the same in Rust, golden files, book, reports and messages.
    pub name: &'static str,
    /// What it is.
    pub quantity: &'static Quantity,
}

impl Field {
    /// The field of this identifier; `r#fn` is named `fn`.
    pub const fn new(identifier: &'static str, quantity: &'static Quantity) -> Self {
        let name = match identifier.as_bytes() {
            [b'r', b'#', ..] => identifier.split_at(2).1,
            _ => identifier,
        };
        Self { name, quantity }
    }

    /// The number of components.
    #[expect(clippy::len_without_is_empty, reason = "a field is never empty")]
    pub const fn len(&self) -> usize {
        self.quantity.shape.len()
    }
}

/// A struct of named fields, each a scalar, a [`Vector2`] or a [`Vector3`] of `T`; made by [`fields!`](crate::fields).
pub trait Fields<T: Element>: Element {
    /// The fields in order.
    const FIELDS: &'static [Field];

    /// The number of components.
    const LEN: usize = components_of(Self::FIELDS);

    /// The components as an array.
    type Array: Element + AsRef<[T]> + AsMut<[T]>;

    /// Builds the struct from its components in order.
    fn from_components(next: &mut impl FnMut() -> T) -> Self;

    /// Hands out the components in order.
    fn for_each_component(&self, visit: &mut impl FnMut(T));

    /// An array with room for the components.
    fn array_of(value: T) -> Self::Array;

    /// The struct with every component equal to `value`.
    fn filled(value: T) -> Self {
        Self::from_components(&mut || value)
    }

    /// The components in order.
    fn components(&self) -> Vec<T> {
        let mut all = Vec::new();
        self.for_each_component(&mut |component| all.push(component));
        all
    }

    /// The number of components.
    fn len() -> usize {
        Self::LEN
    }

    /// The struct of these components; `None` where their number is not the struct's.
    fn from_slice(components: &[T]) -> Option<Self> {
        let fallback = *components.first()?;
        let mut rest = components.iter().copied();
        (components.len() == Self::len()).then(|| Self::from_components(&mut || rest.next().unwrap_or(fallback)))
    }
}

const fn components_of(fields: &[Field]) -> usize {
    match fields {
        [] => 0,
        [first, rest @ ..] => first.len() + components_of(rest),
    }
}

/// One field's worth of components: a scalar, or a short column.
pub trait Part<T> {
    /// How many.
    const LEN: usize;
    /// Builds the part from its components in order.
    fn from_components(next: &mut impl FnMut() -> T) -> Self;
    /// Hands out the components in order.
    fn for_each_component(&self, visit: &mut impl FnMut(T));
}

impl<T: Element> Part<T> for T {
    const LEN: usize = 1;
    #[inline(always)]
    fn from_components(next: &mut impl FnMut() -> T) -> Self {
        next()
    }
    #[inline(always)]
    fn for_each_component(&self, visit: &mut impl FnMut(T)) {
        visit(*self);
    }
}

impl<T: Element> Part<T> for Vector2<T> {
    const LEN: usize = 2;
    #[inline(always)]
    fn from_components(next: &mut impl FnMut() -> T) -> Self {
        Vector2::new(next(), next())
    }
    #[inline(always)]
    fn for_each_component(&self, visit: &mut impl FnMut(T)) {
        visit(self.x);
        visit(self.y);
    }
}

impl<T: Element> Part<T> for Vector3<T> {
    const LEN: usize = 3;
    #[inline(always)]
    fn from_components(next: &mut impl FnMut() -> T) -> Self {
        Vector3::new(next(), next(), next())
    }
    #[inline(always)]
    fn for_each_component(&self, visit: &mut impl FnMut(T)) {
        visit(self.x);
        visit(self.y);
        visit(self.z);
    }
}

/// Declares a struct of named fields, each tied to its [`Quantity`].
///
/// ```
/// use jointproof::{fields, formula::Fields, quantity};
/// fields! {
///     /// The force across a slot.
///     pub struct CrossForces<T> { f2: T = quantity::F2, f3: T = quantity::F3 }
/// }
/// assert_eq!(CrossForces::<f64>::FIELDS[1].name, "f3");
/// assert_eq!(CrossForces { f2: 3.0, f3: 4.0 }.components(), [3.0, 4.0]);
/// ```
#[macro_export]
macro_rules! fields {
    ($(#[$attribute:meta])* $visibility:vis struct $name:ident<$T:ident> {
        $($field:ident: $part:ty = $quantity:expr),* $(,)?
    }) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug, PartialEq)]
        $visibility struct $name<$T> {
            $(
                #[doc = concat!("[`", stringify!($quantity), "`]")]
                pub $field: $part,
            )*
        }

        impl<$T: $crate::formula::Element> $crate::formula::Fields<$T> for $name<$T> {
            const FIELDS: &'static [$crate::formula::Field] = {
                $(assert!(
                    <$part as $crate::formula::Part<$T>>::LEN == $quantity.shape.len(),
                    "the field's type has not the shape of its quantity"
                );)*
                &[$($crate::formula::Field::new(stringify!($field), &$quantity)),*]
            };
            type Array = [$T; <$name<f64> as $crate::formula::Fields<f64>>::LEN];
            #[inline(always)]
            fn from_components(next: &mut impl FnMut() -> $T) -> Self {
                Self { $($field: $crate::formula::Part::from_components(next)),* }
            }
            #[inline(always)]
            fn for_each_component(&self, visit: &mut impl FnMut($T)) {
                $($crate::formula::Part::for_each_component(&self.$field, visit);)*
            }
            #[inline(always)]
            fn array_of(value: $T) -> Self::Array {
                [value; <$name<f64> as $crate::formula::Fields<f64>>::LEN]
            }
        }
    };
}

/// A source document, and the place in it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Source {
    /// File name in `seeds/`.
    pub file: &'static str,
    /// The document's title.
    pub title: &'static str,
    /// The section, in the document's own headings.
    pub section: &'static str,
}

impl Source {
    /// Seed 000.
    pub const SLOT: Self = Self::document("000_f67952a2d71eaf8d.txt", "SLOT");
    /// Seed 001.
    pub const UJOINT: Self = Self::document("001_69130e2f034d4687.txt", "UJOINT");
    /// Seed 002.
    pub const SLIDER: Self = Self::document("002_6bb9a98555936a33.txt", "Sliding constraint");
    /// Seed 003.
    pub const TRANSLATOR: Self = Self::document("003_53198ccce638de3d.txt", "TRANSLATOR");
    /// Seed 004.
    pub const SLIDE_LINE: Self = Self::document("004_f1c84e5c7b815b42.txt", "Slide lines");

    /// A document as a whole.
    pub const fn document(file: &'static str, title: &'static str) -> Self {
        Self { file, title, section: "" }
    }

    /// A section of it.
    pub const fn section(self, section: &'static str) -> Self {
        Self { section, ..self }
    }
}

/// What is said about a formula, once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spec {
    /// The identifier, `family.name`.
    pub id: &'static str,
    /// A title of a few words.
    pub title: &'static str,
    /// The equation.
    pub latex: &'static str,
    /// Where it is documented.
    pub source: Source,
    /// The stated bound of the backward error η of the value in `f64`, on random and hard cases.
    pub eta: f64,
    /// The stated bound of η of every entry of the closed-form Jacobian in `f64`.
    pub eta_jacobian: f64,
    /// Whether moving and turning the whole model moves and turns the outputs with it (frame indifference). A formula
    /// that refers to the global axes is not objective.
    pub objective: bool,
}

/// The Jacobian of `F`: its outputs, every component replaced by its gradient.
pub type Jacobian<F, D> = <F as Formula>::Outputs<<F as Formula>::Inputs<D>>;

/// Value and Jacobian of `F`.
pub type ValueAndJacobian<F, D> = (<F as Formula>::Outputs<D>, Jacobian<F, D>);

/// A documented equation: value, closed-form Jacobian, and where it is hard.
pub trait Formula: Copy + Send + Sync + 'static {
    /// What is said about it.
    const SPEC: Spec;
    /// Its inputs, made by [`fields!`](crate::fields).
    type Inputs<T: Element>: Fields<T>;
    /// Its outputs, made by [`fields!`](crate::fields).
    type Outputs<T: Element>: Fields<T>;

    /// The equation.
    fn eval<D: Scalar>(i: &Self::Inputs<D>) -> Self::Outputs<D>;

    /// Its derivative, derived by hand: `jacobian(i).out.input` is ∂out/∂input.
    fn jacobian<D: Scalar>(i: &Self::Inputs<D>) -> Jacobian<Self, D>;

    /// Both at once; overridden where they share work. The value has the bits of [`eval`](Self::eval).
    #[inline]
    fn linearized<D: Scalar>(i: &Self::Inputs<D>) -> (Self::Outputs<D>, Jacobian<Self, D>) {
        (Self::eval(i), Self::jacobian(i))
    }

    /// What makes inputs invalid beyond the domains of the single fields.
    ///
    /// # Errors
    /// What is wrong with which input.
    fn validate(_: &Self::Inputs<f64>) -> Result<(), Error> {
        Ok(())
    }

    /// Hand-worked, limit and hard cases.
    fn cases() -> Vec<Case<Self::Inputs<f64>>> {
        Vec::new()
    }

    /// Inputs that [`validate`](Self::validate) rejects; what the domains reject is added by itself.
    fn invalid_cases() -> Vec<Case<Self::Inputs<f64>>> {
        Vec::new()
    }

    /// Where the formula has no derivative, and what is done there.
    fn kinks() -> Vec<Kink<Self>> {
        Vec::new()
    }

    /// What physics demands of it beyond frame indifference and homogeneity, which are checked for every formula.
    fn laws() -> Vec<Law<Self>> {
        Vec::new()
    }

    /// Other ways to compute the value, as textbooks have it or as the document words it, to be measured beside
    /// [`eval`](Self::eval).
    fn ways() -> Vec<Way> {
        Vec::new()
    }
}

/// Value of a formula at inputs that were checked.
///
/// # Errors
/// [`Error`] naming the input that is not finite or not in its domain, or the output that overflowed.
///
/// ```
/// use jointproof::{formula::value, slot::{ContactForce, CrossForces}};
/// assert_eq!(value::<ContactForce>(&CrossForces { f2: 3.0, f3: 4.0 })?.fc, 5.0);
/// let error = value::<ContactForce>(&CrossForces { f2: f64::NAN, f3: 4.0 }).unwrap_err();
/// assert_eq!(error.to_string(), "f2 is NaN; allowed is a finite number");
/// # Ok::<(), jointproof::Error>(())
/// ```
pub fn value<F: Formula>(i: &F::Inputs<f64>) -> Result<F::Outputs<f64>, Error> {
    check::<F>(i)?;
    let out = F::eval(i);
    finite::<F>(&out)?;
    Ok(out)
}

/// Value and closed-form Jacobian of a formula at inputs that were checked.
///
/// # Errors
/// As [`value`], or naming the output with a derivative that overflowed.
pub fn value_and_jacobian<F: Formula>(i: &F::Inputs<f64>) -> Result<ValueAndJacobian<F, f64>, Error> {
    check::<F>(i)?;
    let (out, jacobian) = F::linearized(i);
    finite::<F>(&out)?;
    let is_finite = |gradient: F::Inputs<f64>| {
        let mut all = true;
        Fields::for_each_component(&gradient, &mut |slope: f64| all &= slope.is_finite());
        all
    };
    match first_where(&jacobian, |gradient| !is_finite(gradient)) {
        Some(field) => Err(Error::DerivativeOverflow { name: field.name }),
        None => Ok((out, jacobian)),
    }
}

/// Whether the inputs are finite, in their domains, and valid together.
///
/// # Errors
/// The first input that is not.
pub fn check<F: Formula>(i: &F::Inputs<f64>) -> Result<(), Error> {
    check_domains(F::Inputs::<f64>::FIELDS, &i.components())?;
    F::validate(i)
}

fn check_domains(fields: &[Field], components: &[f64]) -> Result<(), Error> {
    let mut components = components.iter();
    for field in fields {
        for (component, &value) in components.by_ref().take(field.len()).enumerate() {
            let component = (field.len() > 1).then_some(component);
            Error::check(field.name, component, value, field.quantity.domain)?;
        }
    }
    Ok(())
}

fn finite<F: Formula>(out: &F::Outputs<f64>) -> Result<(), Error> {
    match first_where(out, |value| !value.is_finite()) {
        Some(field) => Err(Error::Overflow { name: field.name }),
        None => Ok(()),
    }
}

/// The first field with a component like this.
fn first_where<T: Element, I: Fields<T>>(fields: &I, is_so: impl Fn(T) -> bool) -> Option<&'static Field> {
    let (mut place, mut found) = (0, None);
    fields.for_each_component(&mut |component| {
        if found.is_none() && is_so(component) {
            found = Some(place);
        }
        place += 1;
    });
    let (found, mut end): (usize, _) = (found?, 0);
    I::FIELDS.iter().find(|field| {
        end += field.len();
        found < end
    })
}

/// What a case is for.
#[derive(
    Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash, serde::Serialize, serde::Deserialize, schemars::JsonSchema,
)]
#[serde(rename_all = "lowercase")]
pub enum Flag {
    /// Worked by hand.
    Hand,
    /// A limit that the source prints.
    Limit,
    /// Drawn by the sampler.
    Random,
    /// Numerically hard.
    Hard,
    /// On a kink: see the register of kinks.
    Kink,
    /// Rejected.
    Invalid,
}

impl Flag {
    /// The name in golden files.
    pub const fn name(self) -> &'static str {
        match self {
            Self::Hand => "hand",
            Self::Limit => "limit",
            Self::Random => "random",
            Self::Hard => "hard",
            Self::Kink => "kink",
            Self::Invalid => "invalid",
        }
    }
}

/// A named case.
#[derive(Clone, Debug, PartialEq)]
pub struct Case<I> {
    /// Identifier, unique within the formula.
    pub id: String,
    /// What it is for.
    pub flag: Flag,
    /// What is to be seen in it; may be empty.
    pub comment: &'static str,
    /// The inputs.
    pub inputs: I,
}

impl<I> Case<I> {
    /// A case worked by hand.
    pub fn hand(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Hand, id, comment, inputs)
    }
    /// A limit that the source prints.
    pub fn limit(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Limit, id, comment, inputs)
    }
    /// A numerically hard case.
    pub fn hard(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Hard, id, comment, inputs)
    }
    /// A case that is rejected.
    pub fn invalid(id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self::new(Flag::Invalid, id, comment, inputs)
    }
    /// Any case.
    pub fn new(flag: Flag, id: impl Into<String>, comment: &'static str, inputs: I) -> Self {
        Self { id: id.into(), flag, comment, inputs }
    }
}

/// What is done where a formula has no derivative.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Convention {
    /// The minimum-norm subgradient, 0, in the closed form and in automatic differentiation alike.
    Subgradient,
    /// The value is defined; the Jacobian is one of the one-sided ones and is left out of golden files.
    Switch,
    /// An angle jumps by a full turn; its derivative is the same on both sides and is given as anywhere else.
    Cut,
}

/// A place where a formula has no derivative.
#[derive(Clone, Copy)]
pub struct Kink<F: Formula> {
    /// The condition, in LaTeX.
    pub condition: &'static str,
    /// What is done there.
    pub convention: Convention,
    /// Whether inputs, exact in 237 bits, are on the kink.
    pub holds: fn(&F::Inputs<Octuple>) -> bool,
    /// A point on the kink.
    pub at: fn() -> F::Inputs<f64>,
    /// A direction that crosses it.
    pub across: fn() -> F::Inputs<f64>,
}

/// Something physics demands, as pairs of numbers that must be equal.
#[derive(Clone, Copy)]
pub struct Law<F: Formula> {
    /// The law in a few words.
    pub statement: &'static str,
    /// Both sides, evaluated in 237 bits at inputs drawn by the sampler.
    pub sides: fn(&F::Inputs<Octuple>) -> Vec<Equation>,
}

/// Two numbers that a [`Law`] says are equal, and the size of the terms they were summed from.
#[derive(Clone, Copy, Debug)]
pub struct Equation {
    /// One side.
    pub left: Octuple,
    /// The other.
    pub right: Octuple,
    /// The size of the terms, against which rounding is judged.
    pub scale: Octuple,
}

/// A unit vector of the i-th axis times `value`: the gradient of a product's i-th component.
#[inline]
pub fn along<D: Scalar, const N: usize>(i: usize, value: D) -> SVector<D, N> {
    SVector::from_fn(|k, _| if k == i { value } else { D::zero() })
}

/// Whether a field turns with the model.
pub fn turns(domain: Domain) -> bool {
    matches!(domain, Domain::Point | Domain::Vector | Domain::Direction | Domain::Triad(..))
}

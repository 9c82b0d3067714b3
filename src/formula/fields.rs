//! Structs of named fields: the inputs and outputs of formulas.

#![expect(clippy::inline_always, reason = "a call for a component costs more than the component")]

use crate::formula::quantity::Quantity;
use nalgebra::{SMatrix, Vector2, Vector3};
use std::fmt::Debug;
use std::ops::Range;

/// What a field may hold: a number, or a gradient of numbers.
pub trait Component: Copy + Debug + PartialEq + 'static {}
impl<T: Copy + Debug + PartialEq + 'static> Component for T {}

/// A named input or output.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Field {
    /// The name, the same in Rust, golden files, book, reports and messages.
    pub name: &'static str,
    /// The quantity it holds.
    pub quantity: &'static Quantity,
}

impl Field {
    /// The field named by this identifier; `r#fn` becomes `fn`.
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

    /// The components of each of these fields, in order.
    pub fn ranges(fields: &[Self]) -> impl Iterator<Item = Range<usize>> {
        fields.iter().scan(0, |end, field| {
            *end += field.len();
            Some(*end - field.len()..*end)
        })
    }
}

/// A struct of named fields, each a scalar, a [`Vector2`], a [`Vector3`] or a square matrix of `T`; made by [`fields!`](crate::fields).
pub trait Fields<T: Component>: Component {
    /// The fields in order.
    const FIELDS: &'static [Field];

    /// The number of components.
    const LEN: usize = components_of(Self::FIELDS);

    /// The components as an array.
    type Array: Component + AsRef<[T]> + AsMut<[T]>;

    /// Builds the struct from its components in order.
    fn from_components(next: &mut impl FnMut() -> T) -> Self;

    /// Hands out the components in order, each with the field that it belongs to.
    fn for_each_of_field(&self, visit: &mut impl FnMut(&'static Field, T));

    /// Shows a visitor the components in order.
    fn accept(&self, visitor: &mut impl Visitor<T>);

    /// Hands out the components in order.
    #[inline(always)]
    fn for_each_component(&self, visit: &mut impl FnMut(T)) {
        self.accept(&mut Each(visit));
    }

    /// An array of as many components, each equal to `value`.
    fn array_of(value: T) -> Self::Array;

    /// The struct with every component equal to `value`.
    fn filled(value: T) -> Self {
        Self::from_components(&mut || value)
    }

    /// The components in order.
    fn components(&self) -> Vec<T> {
        let mut all = Gathered(Vec::with_capacity(Self::LEN));
        self.accept(&mut all);
        all.0
    }

    /// The struct with these components; `None` if their number is wrong.
    #[inline]
    fn from_slice(components: &[T]) -> Option<Self> {
        (components.len() == Self::LEN).then(|| Self::from_components(&mut following(components)))
    }
}

const fn components_of(fields: &[Field]) -> usize {
    match fields {
        [] => 0,
        [first, rest @ ..] => first.len() + components_of(rest),
    }
}

/// Visits components; unlike a closure, its action on each can be inlined.
pub trait Visitor<T> {
    /// Visits one component.
    fn visit(&mut self, component: T);
}

/// Calls a closure.
struct Each<'f, F>(&'f mut F);

impl<T, F: FnMut(T)> Visitor<T> for Each<'_, F> {
    #[inline(always)]
    fn visit(&mut self, component: T) {
        (self.0)(component);
    }
}

/// Calls a closure with the field that the components belong to.
#[doc(hidden)]
pub struct OfField<'f, F> {
    pub field: &'static Field,
    pub visit: &'f mut F,
}

impl<T, F: FnMut(&'static Field, T)> Visitor<T> for OfField<'_, F> {
    #[inline(always)]
    fn visit(&mut self, component: T) {
        (self.visit)(self.field, component);
    }
}

// A closure is a type of its own for each struct in whose method it stands, with a copy of all that it is given to. What follows
// is compiled once for each type of number.

/// Components in order.
struct Gathered<T>(Vec<T>);

impl<T> Visitor<T> for Gathered<T> {
    fn visit(&mut self, component: T) {
        self.0.push(component);
    }
}

/// One component after the other.
#[inline(always)]
pub(super) fn following<T: Copy>(components: &[T]) -> impl FnMut() -> T {
    let mut k = 0;
    move || {
        k += 1;
        components[k - 1]
    }
}

/// The components of one field: a scalar, a short column, or a square matrix row by row.
pub trait Part<T> {
    /// The number of components.
    const LEN: usize;
    /// Builds the part from its components in order.
    fn from_components(next: &mut impl FnMut() -> T) -> Self;
    /// Shows a visitor the components in order.
    fn accept(&self, visitor: &mut impl Visitor<T>);
}

impl<T: Component> Part<T> for T {
    const LEN: usize = 1;
    #[inline(always)]
    fn from_components(next: &mut impl FnMut() -> T) -> Self {
        next()
    }
    #[inline(always)]
    fn accept(&self, visitor: &mut impl Visitor<T>) {
        visitor.visit(*self);
    }
}

impl<T: Component> Part<T> for Vector2<T> {
    const LEN: usize = 2;
    #[inline(always)]
    fn from_components(next: &mut impl FnMut() -> T) -> Self {
        Vector2::new(next(), next())
    }
    #[inline(always)]
    fn accept(&self, visitor: &mut impl Visitor<T>) {
        visitor.visit(self.x);
        visitor.visit(self.y);
    }
}

impl<T: Component> Part<T> for Vector3<T> {
    const LEN: usize = 3;
    #[inline(always)]
    fn from_components(next: &mut impl FnMut() -> T) -> Self {
        Vector3::new(next(), next(), next())
    }
    #[inline(always)]
    fn accept(&self, visitor: &mut impl Visitor<T>) {
        visitor.visit(self.x);
        visitor.visit(self.y);
        visitor.visit(self.z);
    }
}

/// Row by row.
impl<T: Component, const N: usize> Part<T> for SMatrix<T, N, N> {
    const LEN: usize = N * N;
    #[inline(always)]
    fn from_components(next: &mut impl FnMut() -> T) -> Self {
        let rows = [(); N].map(|()| [(); N].map(|()| next()));
        SMatrix::from_fn(|row, column| rows[row][column])
    }
    #[inline(always)]
    fn accept(&self, visitor: &mut impl Visitor<T>) {
        // In a loop the compiler would see neither the index of a component nor its use. For long gradients in the
        // plane, unrolling would generate too much code.
        if N == 2 && size_of::<T>() <= 8 * size_of::<f64>() {
            visitor.visit(self[(0, 0)]);
            visitor.visit(self[(0, 1)]);
            visitor.visit(self[(1, 0)]);
            visitor.visit(self[(1, 1)]);
            return;
        }
        if N == 3 {
            visitor.visit(self[(0, 0)]);
            visitor.visit(self[(0, 1)]);
            visitor.visit(self[(0, 2)]);
            visitor.visit(self[(1, 0)]);
            visitor.visit(self[(1, 1)]);
            visitor.visit(self[(1, 2)]);
            visitor.visit(self[(2, 0)]);
            visitor.visit(self[(2, 1)]);
            visitor.visit(self[(2, 2)]);
            return;
        }
        for row in 0..N {
            for column in 0..N {
                visitor.visit(self[(row, column)]);
            }
        }
    }
}

/// Declares a struct of named fields, each tied to its [`Quantity`].
///
/// ```
/// use jointproof::{fields, formula::{Fields, quantity}};
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

        impl<$T: $crate::formula::Component> $crate::formula::Fields<$T> for $name<$T> {
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
            fn for_each_of_field(&self, visit: &mut impl FnMut(&'static $crate::formula::Field, $T)) {
                $({
                    const FIELD: &$crate::formula::Field = &$crate::formula::Field::new(stringify!($field), &$quantity);
                    $crate::formula::Part::accept(&self.$field, &mut $crate::formula::OfField { field: FIELD, visit });
                })*
            }
            #[inline(always)]
            fn accept(&self, visitor: &mut impl $crate::formula::Visitor<$T>) {
                $($crate::formula::Part::accept(&self.$field, visitor);)*
            }
            #[inline(always)]
            fn array_of(value: $T) -> Self::Array {
                [value; <$name<f64> as $crate::formula::Fields<f64>>::LEN]
            }
        }
    };
}

#[cfg(feature = "verify")]
/// The entries of a Jacobian, output by output, each over all inputs.
pub(crate) fn entries<T: Component, I: Fields<T>>(jacobian: &impl Fields<I>) -> Vec<T> {
    let mut all = Gathered(Vec::new());
    for gradient in jacobian.components() {
        gradient.accept(&mut all);
    }
    all.0
}

/// The struct with these components.
///
/// # Panics
/// If their number is wrong, which would be a mistake of the caller.
#[cfg(feature = "verify")]
pub(crate) fn typed<T: Component, I: Fields<T>>(components: &[T]) -> I {
    I::from_slice(components)
        .unwrap_or_else(|| panic!("{} components were counted, {} are there", I::LEN, components.len()))
}

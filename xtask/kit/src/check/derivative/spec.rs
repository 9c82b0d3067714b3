//! The file that says what is differentiated, and where.

use crate::outcome::Usage;
use serde::Deserialize;
use std::path::Path;

/// Values and derivatives of somebody's routine at a state.
#[derive(Debug, Deserialize)]
#[serde(deny_unknown_fields)]
pub(super) struct Spec {
    /// What is called.
    pub(super) routine: Routine,
    /// The state: U of an element; DGAM and then PRESS of a friction model; the inputs of a program.
    pub(super) at: Vec<f64>,
    /// The number of outputs of a program.
    #[serde(default)]
    outputs: Option<usize>,
    /// The coordinates of each node.
    #[serde(default)]
    pub(super) coords: Vec<Vec<f64>>,
    #[serde(default)]
    pub(super) props: Vec<f64>,
    #[serde(default)]
    pub(super) jprops: Vec<i32>,
    /// SVARS, or STATEV, at the start of the increment.
    #[serde(default)]
    pub(super) svars: Vec<f64>,
    /// DU at the state; U if it is left out. The start of the increment does not change.
    #[serde(default)]
    pub(super) increment: Vec<f64>,
    /// TAU at the start of the increment.
    #[serde(default)]
    pub(super) tau: Vec<f64>,
    #[serde(default = "flags")]
    pub(super) lflags: Vec<i32>,
    #[serde(default = "one")]
    pub(super) jtype: i32,
    #[serde(default = "one_second")]
    pub(super) dtime: f64,
    /// Degrees of freedom, from 1 on, that are the three components of a rotation vector.
    #[serde(default)]
    rotations: Vec<[usize; 3]>,
    /// Whether a derivative with respect to a rotation is one with respect to a spin that follows it, or to the components of the rotation
    /// vector.
    #[serde(default)]
    pub(super) by: Turning,
    /// The size of each input, of which steps are a fraction.
    #[serde(default)]
    scales: Vec<f64>,
}

#[derive(Clone, Copy, Debug, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum Routine {
    Uel,
    Uelmat,
    Fric,
    Program,
}

/// How a rotation is varied.
#[derive(Clone, Copy, Debug, Default, Deserialize, PartialEq, Eq)]
#[serde(rename_all = "lowercase")]
pub(super) enum Turning {
    #[default]
    Spin,
    Vector,
}

fn flags() -> Vec<i32> {
    vec![1, 1, 1, 0, 0]
}

fn one() -> i32 {
    1
}

fn one_second() -> f64 {
    1.0
}

impl Spec {
    /// Reads and checks a file.
    ///
    /// # Errors
    /// What is missing or does not fit, by name.
    pub(super) fn read(path: &Path) -> anyhow::Result<Self> {
        let text = std::fs::read_to_string(path);
        let text = text.map_err(|error| Usage(format!("--derivative: {}: {error}", path.display())))?;
        let spec: Self =
            toml::from_str(&text).map_err(|error| Usage(format!("--derivative: {}: {error}", path.display())))?;
        spec.fault().map_or(Ok(()), |fault| Err(Usage(format!("--derivative: {}: {fault}", path.display()))))?;
        Ok(spec)
    }

    fn fault(&self) -> Option<String> {
        let n = self.at.len();
        let numbers = [&self.at, &self.props, &self.svars, &self.increment, &self.tau, &self.scales];
        let coordinates = self.coords.iter().flatten();
        if n == 0 {
            return Some("`at` is empty: it is the state, U of an element".into());
        }
        if numbers.into_iter().flatten().chain(coordinates).any(|x| !x.is_finite()) {
            return Some("a number is not finite".into());
        }
        if !self.scales.is_empty() && (self.scales.len() != n || self.scales.iter().any(|&scale| scale <= 0.0)) {
            return Some(format!("`scales` needs {n} numbers above 0, one for each of `at`"));
        }
        if let Some(triple) = self.rotations.iter().find(|triple| triple.iter().any(|dof| !(1..=n).contains(dof))) {
            return Some(format!("`rotations` has {triple:?}, and degrees of freedom are 1 to {n}"));
        }
        match self.routine {
            Routine::Program if self.outputs.is_none_or(|outputs| outputs == 0) => {
                Some("`outputs` is needed: how many numbers the program answers before the derivatives".into())
            }
            Routine::Uel | Routine::Uelmat if self.coords.is_empty() => {
                Some("`coords` is needed: a list of coordinates for each node".into())
            }
            Routine::Uel | Routine::Uelmat
                if self.coords.iter().any(|node| node.len() != self.coords[0].len() || node.is_empty()) =>
            {
                Some("`coords` has nodes with different numbers of coordinates".into())
            }
            Routine::Uel | Routine::Uelmat if self.lflags.len() != 5 => Some("`lflags` needs 5 numbers".into()),
            Routine::Uel | Routine::Uelmat if !self.increment.is_empty() && self.increment.len() != n => {
                Some(format!("`increment` needs {n} numbers, as `at`"))
            }
            Routine::Fric if n != 2 && n != 3 => {
                Some(format!("`at` has {n} numbers, and needs one or two of DGAM and then PRESS"))
            }
            Routine::Fric if self.tau.len() != n - 1 => Some(format!("`tau` needs {} numbers", n - 1)),
            _ => None,
        }
    }

    /// The number of outputs.
    pub(super) fn outputs(&self) -> usize {
        match self.routine {
            Routine::Uel | Routine::Uelmat => self.at.len(),
            Routine::Fric => self.at.len() - 1,
            Routine::Program => self.outputs.unwrap_or(1),
        }
    }

    /// The rotation that an input belongs to, with the input's number in it, both from 0 on.
    pub(super) fn rotation(&self, input: usize) -> Option<([usize; 3], usize)> {
        self.rotations.iter().find_map(|triple| {
            let place = triple.iter().position(|&dof| dof == input + 1)?;
            Some((triple.map(|dof| dof - 1), place))
        })
    }

    /// The size of each input.
    pub(super) fn sizes(&self) -> Vec<f64> {
        if !self.scales.is_empty() {
            return self.scales.clone();
        }
        let largest = |numbers: &[f64]| numbers.iter().fold(0.0_f64, |most, x| most.max(x.abs()));
        let or_one = |x: f64| if x > 0.0 { x } else { 1.0 };
        let n = self.at.len();
        let size = |input: usize| match self.routine {
            _ if self.rotation(input).is_some() => 1.0,
            Routine::Uel | Routine::Uelmat => or_one(self.extent()),
            Routine::Fric if input + 1 == n => or_one(self.at[input].abs()),
            Routine::Fric => or_one(largest(&self.at[..n - 1])),
            Routine::Program if self.at[input] != 0.0 => self.at[input].abs(),
            Routine::Program => or_one(largest(&self.at)),
        };
        (0..n).map(size).collect()
    }

    /// The largest difference of coordinates of two nodes.
    fn extent(&self) -> f64 {
        let along = |axis: usize| {
            let ends = self.coords.iter().fold([f64::INFINITY, f64::NEG_INFINITY], |[low, high], node| {
                [low.min(node[axis]), high.max(node[axis])]
            });
            ends[1] - ends[0]
        };
        (0..self.coords[0].len()).map(along).fold(0.0, f64::max)
    }

    /// The names of what is differentiated, of the inputs, and of the matrix: an entry of the last is `matrix(i,j)`.
    pub(super) fn names(&self) -> [&'static str; 3] {
        match self.routine {
            Routine::Uel | Routine::Uelmat => ["RHS", "U", "-AMATRX"],
            Routine::Fric => ["TAU", "(DGAM,PRESS)", "(DDTDDG,DDTDDP)"],
            Routine::Program => ["f", "x", "J"],
        }
    }
}

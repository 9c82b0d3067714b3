//! `report`: the speed and the error of every method of computing every formula.

pub(crate) mod against;
mod command;
pub(crate) mod data;
mod export;
mod measuring;
pub(crate) mod pareto;
pub(crate) mod plot;
pub(crate) mod price;
pub(crate) mod spread;
pub(crate) mod tables;
pub(crate) mod verdict;

pub(crate) use command::{Arguments, kept_or_quick, measure, run};
pub(crate) use measuring::OPTIMISED;

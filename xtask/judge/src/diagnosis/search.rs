//! Searches for the smallest set of known mistakes that explains the answers.

use super::mistakes::{by_two_results, fitted, mistakes};
use super::model::{Model, Textbook};
use super::sample::{Evidence, Sample};
use rayon::iter::{IndexedParallelIterator, IntoParallelIterator, IntoParallelRefIterator, ParallelIterator};

/// The samples on which mistakes are tried first.
const SCREEN: usize = 5;
/// Partial explanations that are combined with every other mistake.
const PARTIAL: usize = 24;
/// Exchanges of numbers that are combined with every other mistake.
const MOVES: usize = 10;
/// Operations that are computed at most for pairs of mistakes, to limit the time.
const OPERATIONS: usize = 20_000_000;

/// Mistakes, and how many of the samples they explain.
pub(super) struct Explanation {
    pub(super) what: Vec<String>,
    pub(super) explained: usize,
}

/// The mistakes that were tried one by one.
pub(super) struct Tried<'a> {
    trial: Trial<'a>,
    all: Vec<Model>,
    scores: Vec<Option<usize>>,
}

impl<'a> Tried<'a> {
    pub(super) fn new(evidence: &'a Evidence<'_>, book: Option<&'a Textbook>) -> Self {
        let trial = Trial { evidence, book, screen: screen(evidence) };
        let all = mistakes(evidence, book);
        let scores = all.par_iter().map(|model| trial.score(model)).collect();
        Self { trial, all, scores }
    }

    /// One mistake that explains nearly every sample.
    pub(super) fn one(&self) -> Option<Explanation> {
        let Self { trial, all, scores } = self;
        let whole = trial.screen.iter().map(|sample| Trial::off_in(sample)).sum::<usize>();
        let single = (0..all.len()).filter(|&k| scores[k] == Some(whole)).find_map(|k| trial.verified(&all[k]));
        single.or_else(|| {
            let fitted = fitted(trial.evidence, trial.book?);
            fitted.iter().filter(|model| trial.fits_screen(model)).find_map(|model| trial.verified(model))
        })
    }

    /// A product or a quotient of two results of the formula that is too much.
    pub(super) fn two_results(&self) -> Option<Explanation> {
        let models = by_two_results(self.trial.evidence, self.trial.book?);
        models.iter().find_map(|model| self.trial.verified(model))
    }

    /// Two mistakes that explain nearly every sample, or three.
    pub(super) fn several(&self) -> Option<Explanation> {
        let Self { trial, all, scores } = self;
        let mut partial: Vec<usize> = (0..all.len()).filter(|&k| scores[k].is_some_and(|score| score > 0)).collect();
        partial.sort_by_key(|&k| (std::cmp::Reverse(scores[k]), k));
        partial.truncate(PARTIAL);
        // What exchanges whole outputs explains nothing by itself where these are wrong, too.
        let moves = (0..all.len()).filter(|k| all[*k].is_of_numbers_alone() && scores[*k].is_none());
        partial.extend(moves.take(MOVES));
        let mut pairs = Vec::new();
        let most = OPERATIONS / trial.cost();
        for &first in &partial {
            if pairs.len() + all.len() > most.max(all.len()) {
                break;
            }
            pairs.extend((0..all.len()).filter(|second| *second != first).map(|second| (first, second)));
        }
        trial.together(all, &pairs).or_else(|| {
            // Three, if each explains something by itself.
            let mut triples = Vec::new();
            for (i, &a) in partial.iter().enumerate() {
                for (j, &b) in partial.iter().enumerate().skip(i + 1) {
                    triples.extend(partial[j + 1..].iter().map(|&c| [a, b, c]));
                }
            }
            triples.truncate(most / 4);
            let together = |[a, b, c]: [usize; 3]| all[a].and(&all[b])?.and(&all[c]);
            let models: Vec<_> = triples.into_par_iter().filter_map(together).collect();
            let fitting: Vec<_> = models.par_iter().map(|model| trial.fits_screen(model)).collect();
            models.iter().zip(fitting).filter(|(_, fits)| *fits).find_map(|(model, _)| trial.verified(model))
        })
    }
}

struct Trial<'a> {
    evidence: &'a Evidence<'a>,
    book: Option<&'a Textbook>,
    screen: Vec<&'a Sample>,
}

impl Trial<'_> {
    fn predicted(&self, model: &Model, sample: &Sample) -> Vec<f64> {
        model.predicted(self.book, self.evidence.court.formula, sample)
    }

    fn off_in(sample: &Sample) -> usize {
        (0..sample.right.len()).filter(|&place| sample.is_off(place)).count()
    }

    /// The operations of one trial.
    fn cost(&self) -> usize {
        let rows = if self.evidence.parts()[1].is_empty() { 0 } else { self.evidence.parts()[0].len() };
        self.book.map_or(10, |book| book.needed.len().max(10)) * (1 + rows)
    }

    /// How many wrong numbers a mistake explains on the screen; `None` if it explains none.
    fn score(&self, model: &Model) -> Option<usize> {
        let mut score = 0;
        for (k, sample) in self.screen.iter().enumerate() {
            let predicted = self.predicted(model, sample);
            // What is predicted right explains nothing.
            let is_explained = |place: &usize| sample.is_off(*place) && sample.fits(*place, predicted[*place]);
            score += (0..predicted.len()).filter(is_explained).count();
            if k == 1 && score == 0 {
                return None;
            }
            let is_against = |place: usize| !sample.is_off(place) && !sample.fits(place, predicted[place]);
            score = score.saturating_sub((0..predicted.len()).filter(|&place| is_against(place)).count());
        }
        (score > 0).then_some(score)
    }

    fn fits(&self, model: &Model, sample: &Sample) -> bool {
        let predicted = self.predicted(model, sample);
        (0..predicted.len()).all(|place| sample.fits(place, predicted[place]))
    }

    fn fits_screen(&self, model: &Model) -> bool {
        self.screen.iter().all(|sample| self.fits(model, sample))
    }

    /// The first of these pairs that explains nearly everything.
    fn together(&self, all: &[Model], pairs: &[(usize, usize)]) -> Option<Explanation> {
        let fits = |&(first, second): &(usize, usize)| {
            all[first].and(&all[second]).is_some_and(|model| self.fits_screen(&model))
        };
        let fitting: Vec<_> = pairs.par_iter().with_min_len(64).filter(|pair| fits(pair)).copied().collect();
        // The two that come first are the simplest.
        let mut fitting = fitting;
        fitting.sort_by_key(|&(first, second)| first + second);
        fitting.into_iter().find_map(|(first, second)| self.verified(&all[first].and(&all[second])?))
    }

    /// If a mistake explains nearly every sample, in words.
    fn verified(&self, model: &Model) -> Option<Explanation> {
        let samples = &self.evidence.samples;
        let explained = samples.iter().filter(|sample| self.fits(model, sample)).count();
        let off = samples.iter().filter(|sample| Self::off_in(sample) > 0);
        let of_off = off.clone().filter(|sample| self.fits(model, sample)).count();
        let is_enough = explained * 20 >= samples.len() * 19 && of_off * 20 >= off.count() * 19;
        is_enough.then(|| Explanation { what: model.what.clone(), explained })
    }
}

/// A few samples at which every number is wrong that is wrong anywhere, as far as possible.
fn screen<'a>(evidence: &'a Evidence<'_>) -> Vec<&'a Sample> {
    let mut open = evidence.off.clone();
    let mut screen: Vec<&Sample> = Vec::new();
    let off = evidence.off_samples(&evidence.off);
    for sample in &off {
        let before = open.len();
        open.retain(|place| !sample.is_off(*place));
        if open.len() < before && screen.len() < SCREEN - 1 {
            screen.push(sample);
        }
    }
    let more = off.into_iter().chain(evidence.samples.iter().rev());
    for sample in more {
        if screen.len() < SCREEN && !screen.iter().any(|other| std::ptr::eq(*other, sample)) {
            screen.push(sample);
        }
    }
    screen
}

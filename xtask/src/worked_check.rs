//! The worked example of the chapter on checking: the friction of a slot as a textbook writes it, and with two mistakes.

use anyhow::Context;
use jointproof::catalog::find;
use jointproof::connector::slot::Friction;
use jointproof::formula::Formula;
use jointproof::toolkit::verify::Options;
use judge::{Answer, Called};

// ANCHOR: textbook
/// Tangential force, normal force, yield function, and the derivatives of each.
fn textbook([f1, f2, f3, f_int, mu]: [f64; 5]) -> [[f64; 6]; 3] {
    let force = (f2 * f2 + f3 * f3).sqrt();
    let normal = (force + f_int).abs();
    let (s1, s) = (sign(f1), sign(force + f_int));
    let [n2, n3] = if force > 0.0 { [f2 / force, f3 / force] } else { [0.0, 0.0] };
    [
        [f1.abs(), s1, 0.0, 0.0, 0.0, 0.0],
        [normal, 0.0, s * n2, s * n3, s, 0.0],
        [f1.abs() - mu * normal, s1, -mu * s * n2, -mu * s * n3, -mu * s, -normal],
    ]
}
// ANCHOR_END: textbook

// ANCHOR: mistaken
/// The same, from a draft.
fn mistaken(inputs: [f64; 5]) -> [[f64; 6]; 3] {
    let [p, normal, mut phi] = textbook(inputs);
    phi[5] = -phi[5];
    (phi[2], phi[3]) = (0.0, 0.0);
    [p, normal, phi]
}
// ANCHOR_END: mistaken

fn sign(x: f64) -> f64 {
    f64::from(i8::from(x > 0.0) - i8::from(x < 0.0))
}

/// The reports on both.
pub(crate) fn outputs() -> anyhow::Result<Vec<(String, String)>> {
    let textbook = report("textbook", textbook)?;
    Ok(vec![("check".into(), textbook), ("check-mistaken".into(), report("mistaken", mistaken)?)])
}

fn report(name: &str, function: fn([f64; 5]) -> [[f64; 6]; 3]) -> anyhow::Result<String> {
    let formula = find(Friction::SPEC.id).context("the formula is in the catalog")?;
    let called = Called::new(formula, true, &Options { samples: 200, seed: 1 }, false);
    let answer = |inputs: &[f64]| {
        let rows = function(std::array::from_fn(|k| inputs[k]));
        let values = rows.iter().map(|row| row[0]);
        Answer::Numbers(values.chain(rows.iter().flat_map(|row| row[1..].iter().copied())).map(Some).collect())
    };
    let answers: Vec<_> = called.points().map(answer).collect();
    let judged =
        called.judge(name, &[answers.clone(), answers], false, Vec::new()).context("every point has an answer")?;
    Ok(judged.text)
}

#[cfg(test)]
mod tests {
    #[test]
    fn the_textbook_is_right_and_both_mistakes_are_named() {
        let [(_, textbook), (_, mistaken)] = super::outputs().unwrap().try_into().unwrap();
        assert!(textbook.starts_with("ok ") && textbook.contains("overflows"), "{textbook}");
        let causes = ["wrong sign: ∂phi/∂mu", "left out (always 0): ∂phi/∂f2, ∂phi/∂f3"];
        assert!(causes.iter().all(|cause| mistaken.contains(cause)), "{mistaken}");
    }
}

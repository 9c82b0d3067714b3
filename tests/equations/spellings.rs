//! What people write, in each spelling right, and wrong by a sign, a factor and an exchanged symbol.

use jointproof::catalog::{CATALOG, find};
use jointproof::toolkit::equation::Reading;
use jointproof::toolkit::verify::Options;
use rayon::prelude::*;

/// A formula, somebody's equation for it, and three changes of a piece of it that make it wrong.
type Written = (&'static str, &'static str, [(&'static str, &'static str); 3]);

const FORCE: &str = "slot.contact_force";
const FRICTION: &str = "slot.friction";
const NORMAL: &str = "slot.normal_force";
const YIELD: &str = "coulomb.yield";
const ANGLE: &str = "revolute.angle";
const LINE: &str = "slider.line";
const MOMENT: &str = "hinge.contact_moment";

const WRITTEN: &[Written] = &[
    // Bars, directed and not.
    (FRICTION, r"P = |f_1|", [("|f", "-|f"), ("|f", "2|f"), ("f_1", "f_2")]),
    (FRICTION, r"P = \left|f_1\right|", [(r"\left|", r"-\left|"), ("f_1", "2 f_1"), ("f_1", "f_2")]),
    (FRICTION, r"P = \|f_1\|", [(r"\|f", r"-\|f"), (r"\|f", r"2 \|f"), ("f_1", "f_2")]),
    (FRICTION, r"P = \bigl\lvert f_1\bigr\rvert", [("= ", "= -"), ("= ", "= 2 "), ("f_1", "f_2")]),
    (LINE, r"l = \left\|\mathbf{x}_n - \mathbf{x}_1\right\|", [("- ", "+ "), ("- ", "- 2 "), ("_n", "_1")]),
    (
        MOMENT,
        r"M_C = |f_1| R_a + R_p (f_2^2 + f_3^2)^{1/2} + \beta\sqrt{m_2^2 + m_3^2}",
        [("M_C = |", "M_C = -|"), ("|f_1|", "2|f_1|"), ("R_a", "R_p")],
    ),
    // Roots and powers.
    (FORCE, r"F_C = (f_2^2 + f_3^2)^{1/2}", [(" + ", " - "), ("(f", "(2 f"), ("f_3", "f_2")]),
    (FORCE, r"F_C = \left(f_2^2 + f_3^2\right)^{0.5}", [(" + ", " - "), ("+ f", "+ 3 f"), ("f_2", "f_3")]),
    (FORCE, r"F_C = (f_2^{2} + f_3^{2})^{\frac12}", [("+", "-"), ("(f", "(2 f"), ("f_3", "f_2")]),
    (FORCE, r"F_C = 2^{-2}\,4^{3/2}\,2^{-1} (f_2^2 + f_3^2)^{1/2}", [("+", "-"), ("^{-2}", "^2"), ("f_3", "f_2")]),
    (FORCE, r"F_C^2 = f_2^2 + f_3^2", [("+", "-"), ("= f", "= 2 f"), ("f_3", "f_2")]),
    (FORCE, r"\sqrt{F_C^2 - f_3^2} = |f_2|", [("- f", "+ f"), ("= |", "= 2 |"), ("|f_2", "|f_3")]),
    // Words in subscripts and superscripts, fonts.
    (NORMAL, r"F_N = \lvert F_C + F_C^{int}\rvert", [("+", "-"), ("+ F", "+ 2 F"), (r"F_C ", r"F_C^{int} ")]),
    (NORMAL, r"F_N = |F_C + F_C^{\text{int}}|", [("+", "-"), ("+ F", "+ 2 F"), ("|F_C ", r"|F_C^{\text{int}} ")]),
    (NORMAL, r"F_{\text{N}} = |F_{\mathrm{C}} + F_C^\text{int}|", [("+", "-"), ("+ F", "+ 2 F"), ("C^", "C -0F_C^")]),
    (YIELD, r"\mathit{\Phi} = \mathrm{P} - \mu\,F_\text{N}", [("- ", "+ "), (r"\mu", r"2\mu"), ("{P}", "{F}_N")]),
    (LINE, r"\vec{n} = \frac{\vec{x}_n - \vec{x}_1}{l}", [("- ", "+ "), (r"= \frac", r"= 2\frac"), ("x}_1", "x}_n")]),
    (
        LINE,
        r"\boldsymbol{n} = (\boldsymbol{x_n} - \boldsymbol{x}_1)/l",
        [("- ", "+ "), ("= (", "= 2 ("), ("x}_1", "x_n}")],
    ),
    (LINE, r"n = \dfrac{\bm x_n - \bm x_1}{|\bm x_n - \bm x_1|}", [("- ", "+ "), ("= ", "= 2 "), (r"x_1}{", r"x_n}{")]),
    (LINE, r"l^2 = (\mathbf{x}_n - \mathbf{x}_1)^2", [("- ", "+ "), ("= ", "= 2 "), ("_1", "_n")]),
    // Displays as they are pasted.
    (YIELD, r"$\Phi = P - \mu F_N$", [("- ", "+ "), (r"\mu", r"2\mu"), ("= P", "= F_N")]),
    (YIELD, r"\[ \Phi = P - \mu\cdot F_N. \]", [("- ", "+ "), (r"\mu", r"2\mu"), ("= P", "= F_N")]),
    (
        YIELD,
        r"\begin{equation}\label{yield} \Phi := P - \mu \, F_N \, , \end{equation}",
        [("- ", "+ "), (r"\mu", r"2\mu"), ("= P", "= F_N")],
    ),
    (
        FRICTION,
        "\\begin{align*}\n P &= |f_1|, \\\\\n F_N &= \\left|\\sqrt{f_2^2+f_3^2} + F_C^{int}\\right|, \\\\[2pt]\n \\Phi &= P \\\\ &- \\mu F_N % the limit\n\\end{align*}",
        [("- ", "+ "), (r"\mu", r"2\mu"), ("= P", "= F_N")],
    ),
    // Functions.
    (
        ANGLE,
        r"\alpha = -\operatorname{atan2}(\mathbf{e}_{2a}\cdot\mathbf{e}_{3b}, \mathbf{e}_{3a}\cdot\mathbf{e}_{3b})",
        [("-", ""), ("= -", "= -2"), ("{2a}", "{3a}")],
    ),
    (
        ANGLE,
        r"\tan\alpha = -\frac{\mathbf{e}_{2a}\cdot\mathbf{e}_{3b}}{\mathbf{e}_{3a}\cdot\mathbf{e}_{3b}}",
        [("-", ""), ("-", "-2"), ("{2a}", "{3a}")],
    ),
    (
        FORCE,
        r"\arctan F_C = \tan^{-1}\sqrt{f_2^2 + f_3^2}",
        [("+", "-"), (r"{-1}\sqrt", r"{-1}(2)\sqrt"), ("f_3", "f_2")],
    ),
    (
        FORCE,
        r"\sin^{-1}\frac{f_2}{1 + F_C} = \operatorname{atan2}\left(f_2, \sqrt{(1 + F_C)^2 - f_2^2}\right)",
        [("- f", "+ f"), ("1 +", "2 +"), ("{f_2}", "{f_3}")],
    ),
    (
        FORCE,
        r"F_C^2 = \max\left(|f_2|, |f_3|\right)^2 + \min\{|f_2|, |f_3|\}^2",
        [("+", "-"), ("+ ", "+ 2"), (r"\min", r"\max")],
    ),
    (
        MOMENT,
        r"M_C = |f_1| R_a + R_p\sqrt{f_2^2 + f_3^2} + \left\{\begin{array}{ll} 2 R_p/L_s & \text{if } L_s > 0, \\ 0 & \text{otherwise.} \end{array}\right. \sqrt{m_2^2 + m_3^2}",
        [("+ R_p", "- R_p"), ("2 R_p", "R_p"), ("R_a", "R_p")],
    ),
    // Characters beyond ASCII, as `formulas --show` prints them on a terminal.
    ("slot.friction", "P = |f₁|, F_N = |√(f₂²+f₃²) + F_C^int|, Φ = P − μ F_N", [("−", "+"), ("μ", "2μ"), ("f₂", "f₃")]),
    ("align.constraint", "u_r1 = α − α₀, u_r2 = β − β₀, u_r3 = γ − γ₀", [("−", "+"), ("= β", "= 2β"), ("γ −", "α −")]),
    (LINE, "l = |x_n−x₁|, n = (x_n−x₁)/l", [("(x_n−", "(x_n+"), ("= (", "= 2("), ("x₁)", "x_n)")]),
    (FORCE, "F_C = √(f₂² + f₃²)", [("+", "−"), ("= ", "= 2·"), ("f₃", "f₂")]),
    (FORCE, "F_C = √(f_2·f_2 + f_3⋅f_3)", [("+", "−"), ("= ", "= 2·"), ("f_3", "f_2")]),
    (YIELD, "Φ = P − μ·F_N", [("−", "+"), ("μ", "2μ"), ("P", "F_N")]),
    (ANGLE, "α = −atan2(e2a·e3b, e3a·e3b)", [("−", ""), ("−", "−2·"), ("e2a", "e3a")]),
    // Plain text, as in code.
    (FORCE, "F_C = sqrt(f_2^2 + f_3^2)", [("+", "-"), ("= ", "= 2 "), ("f_3", "f_2")]),
    (FORCE, "fc = sqrt(f2**2 + f3**2)", [("+", "-"), ("= ", "= 2*"), ("f3", "f2")]),
    (FORCE, "fc = (f2*f2 + f3*f3)**0.5", [("+", "-"), ("= ", "= 2*"), ("*f3", "*f2")]),
    (FORCE, "fc == (f2^2 + f3^2)^(1/2)", [("+", "-"), ("== ", "== 2*"), ("f3", "f2")]),
    (FORCE, "fc = hypot(f2, f3)", [("= ", "= -"), ("= ", "= 2*"), ("f3", "f2")]),
    (FORCE, "fc = abs(f2)/2*2 - abs(f2) + hypot(f2, f3)", [("- ", "+ "), ("= ", "= 2*"), (", f3", ", f2")]),
    (YIELD, "phi = p - mu*fn", [("-", "+"), ("mu", "2*mu"), ("= p", "= fn")]),
    (YIELD, "Phi = P - mu F_N", [("-", "+"), ("mu", "2 mu"), ("P ", "F_N ")]),
    (FRICTION, "P = abs(f1); F_N = abs(hypot(f2, f3) + fc_int)", [("+", "-"), ("+ ", "+ 2*"), ("f1", "f2")]),
    (ANGLE, "alpha = -atan2(dot(e2a, e3b), dot(e3a, e3b))", [("-", ""), ("-", "-2*"), ("e2a", "e3a")]),
    (LINE, "l = norm(xn - x1); n = (xn - x1)/l", [("(xn -", "(xn +"), ("= (", "= 2*("), ("x1)/", "xn)/")]),
    (
        MOMENT,
        "mc = abs(f1)*ra + rp*sqrt(f2^2 + f3^2) + beta*hypot(m2, m3)",
        [("+ rp", "- rp"), ("f1)", "f1)*2"), ("*ra", "*rp")],
    ),
];

fn is_held(id: &str, written: &str) -> Result<bool, String> {
    let formula = find(id).ok_or_else(|| format!("{id} is no formula"))?;
    let options = Options { samples: 10, seed: 1 };
    let reading = Reading::of(written, &[], &formula.signature()).map_err(|error| error.to_string())?;
    let claim = match &reading {
        Reading::Function(equation) => formula.trial(&options).compare(equation),
        Reading::Relation(claims) => formula.claims(claims, &options),
    };
    Ok(claim.held())
}

#[test]
fn each_spelling_is_read_and_its_mistakes_are_seen() {
    let wrong = WRITTEN.par_iter().flat_map(|(id, right, changes)| {
        let mut wrong = Vec::new();
        if is_held(id, right) != Ok(true) {
            wrong.push(format!("{right}: {:?}", is_held(id, right)));
        }
        for (old, new) in changes {
            let changed = right.replacen(old, new, 1);
            if changed == *right || is_held(id, &changed) != Ok(false) {
                wrong.push(format!("{changed}: {:?}", is_held(id, &changed)));
            }
        }
        wrong
    });
    let wrong: Vec<_> = wrong.collect();
    assert!(wrong.is_empty(), "{wrong:#?}");
}

/// The command `formulas --show` prints it.
#[test]
fn what_is_printed_is_read_and_is_the_same_function() {
    CATALOG.par_iter().for_each(|formula| {
        let (spec, options) = (formula.spec(), Options { samples: 3, seed: 4 });
        let reading = Reading::of(spec.latex, &[], &formula.signature());
        let Ok(Reading::Function(equation)) = reading else { panic!("{}: {reading:?}", spec.id) };
        let outputs: usize = formula.outputs().iter().map(jointproof::formula::Field::len).sum();
        assert_eq!(equation.places().len(), outputs, "{}", spec.id);
        let claim = formula.trial(&options).compare(&equation);
        assert!(claim.held() && claim.checks > 0, "{}: {claim:#?}", spec.id);
    });
}

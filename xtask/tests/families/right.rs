//! Right routines that look different.

use super::{Family, Member};

/// A name, and the texts of the right routine that are replaced.
type Variant = (&'static str, &'static [(&'static str, &'static str)]);

pub(super) fn members(family: &Family) -> Vec<Member> {
    let variants = match family.abi {
        "fric" => FRIC,
        "uinter" => UINTER,
        "mpc" => MPC,
        "mpc-node" => MPC_NODE,
        "umpc_user" => UMPC_USER,
        _ => UEL,
    };
    let mut members = vec![family.replaced("as it is", &[]), wrapped(family)];
    let textbook = if matches!(family.abi, "fric" | "uinter") { TEXTBOOK } else { &[] };
    members.extend(variants.iter().chain(textbook).map(|(name, texts)| family.replaced(name, texts)));
    if family.abi == "fric" {
        let text = include_str!("fric_fixed.f").to_owned();
        members.push(Member { name: "fixed form with ABA_PARAM.INC".into(), text, is_fixed_form: true });
    }
    members
}

/// A wrapper around another routine, which takes its properties in another order where there are some.
fn wrapped(family: &Family) -> Member {
    let count = match family.abi {
        "fric" => 2,
        "uinter" => 3,
        _ => 0,
    };
    let mut body = family.body().to_owned();
    let mut arguments = family.arguments().replace(['&', '\n'], "");
    let mut declared = String::from("    ! begin\n");
    if count > 0 {
        for k in 1..=count {
            body = body.replace(&format!("props({k})"), &format!("props(@{})", count + 1 - k));
        }
        body = body.replace("props(@", "props(");
        arguments = arguments.replace(" props", " turned");
        let turned: Vec<_> = (1..=count).rev().map(|k| format!("props({k})")).collect();
        declared = format!("    real(dp) :: turned({count})\n    turned = [{}]\n", turned.join(", "));
    }
    let inner = format!("{}    ! begin\n{body}", family.head("@_inner"));
    let text = format!(
        "{declared}    call @_inner({arguments})\nend subroutine\n\n{inner}end subroutine\n\nsubroutine @_unused()\n"
    );
    Member { name: "through a wrapper".into(), text, is_fixed_form: false }
}

const DECLARED: (&str, &str) = ("    ! begin\n", include_str!("textbook_declared.f90"));
const LINE_DECLARED: (&str, &str) = ("    ! begin\n", include_str!("textbook_line_declared.f90"));

/// The square root of a sum of squares, and the projector δ − n nᵀ in slip.
const TEXTBOOK: &[Variant] = &[
    ("the square root of a sum of squares", &[("hypot(t1, t2)", "sqrt(t1**2 + t2**2)")]),
    (
        "the projector",
        &[
            ("slope * n2 * n2", "slope * (1 - n1 * n1)"),
            ("slope * n1 * n1", "slope * (1 - n2 * n2)"),
            ("-slope * n1 * n2", "slope * (0 - n1 * n2)"),
            ("-slope * n2 * n1", "slope * (0 - n2 * n1)"),
        ],
    ),
    (
        "both",
        &[
            ("hypot(t1, t2)", "sqrt(t1*t1 + t2*t2)"),
            ("slope * n2 * n2", "slope * (1 - n1**2)"),
            ("slope * n1 * n1", "slope * (1 - n2**2)"),
        ],
    ),
];

const FRIC: &[Variant] = &[
    (
        "sticks by LM = 1",
        &[(
            "tau(1) = t1\n        tau(2) = t2\n        ddtddg(1, 1) = stick\n        ddtddg(1, 2) = 0\n        ddtddg(2, 1) = 0\n        \
         ddtddg(2, 2) = stick\n        ddtddp(1) = 0\n        ddtddp(2) = 0\n        dslip(1) = 0\n        dslip(2) = 0\n",
            "lm = 1\n        return\n",
        )],
    ),
    (
        "sticks by LM = 1 while TAULM is below the limit",
        &[
            (
                "    lm = 0\n",
                "    if (lm == 1 .and. hypot(taulm(1), taulm(2)) <= props(1) * press) return\n    lm = 0\n",
            ),
            ("t1 = tau(1) + stick * dgam(1)", "t1 = stick * dgam(1)"),
            ("t2 = tau(2) + stick * dgam(2)", "t2 = stick * dgam(2)"),
            ("if (length <= limit)", "if (.false.)"),
            ("(length - limit) / stick * n1", "dgam(1)"),
            ("(length - limit) / stick * n2", "dgam(2)"),
        ],
    ),
    (
        "DSLIP as it comes",
        &[
            ("dslip(1) = 0", "continue"),
            ("dslip(2) = 0", "continue"),
            ("dslip(1) = (length - limit) / stick * n1", "continue"),
            ("dslip(2) = (length - limit) / stick * n2", "continue"),
        ],
    ),
    (
        "history in STATEV",
        &[
            ("t1 = tau(1) +", "t1 = statev(1) +"),
            ("t2 = tau(2) +", "t2 = statev(2) +"),
            ("    end if\n", "    end if\n    statev(1) = tau(1)\n    statev(2) = tau(2)\n"),
        ],
    ),
    (
        "elastic slip in STATEV",
        &[
            ("t1 = tau(1) + stick * dgam(1)", "t1 = stick * (statev(3) + dgam(1))"),
            ("t2 = tau(2) + stick * dgam(2)", "t2 = stick * (statev(4) + dgam(2))"),
            ("    end if\n", "    end if\n    statev(3) = tau(1) / stick\n    statev(4) = tau(2) / stick\n"),
        ],
    ),
    (
        "initialises STATEV in the first increment",
        &[
            ("    lm = 0\n", "    lm = 0\n    if (kinc == 1) statev(1:3) = 0\n"),
            ("    end if\n", "    end if\n    statev(3) = statev(3) + hypot(dslip(1), dslip(2))\n    statev(1) = 1\n"),
        ],
    ),
    (
        "constants in COMMON",
        &[
            (
                "    ! begin\n",
                "    real(dp) :: of_common\n    common /constants_of_friction/ of_common(2)\n    ! begin\n    of_common = props(1:2)\n",
            ),
            ("stick = props(2)", "stick = of_common(2)"),
        ],
    ),
    (
        "the square root of a sum of squares, scaled",
        &[(
            "hypot(t1, t2)",
            "max(abs(t1), abs(t2), tiny(1.0_dp)) * sqrt((t1 / max(abs(t1), abs(t2), tiny(1.0_dp)))**2 &\n        \
         + (t2 / max(abs(t1), abs(t2), tiny(1.0_dp)))**2)",
        )],
    ),
    (
        "energies, and a limit that is not negative",
        &[
            ("limit = props(1) * press", "limit = props(1) * max(press, 0.0_dp)"),
            (
                "    end if\n",
                "    end if\n    sed = 0.5_dp * (tau(1)**2 + tau(2)**2) / stick\n    sfd = tau(1) * dslip(1) + tau(2) * dslip(2)\n",
            ),
        ],
    ),
];

const UINTER: &[Variant] = &[
    (
        "history in STRESS",
        &[
            ("t1 = statev(1)", "t1 = stress(2)"),
            ("t2 = statev(2)", "t2 = stress(3)"),
            ("    statev(1) = stress(2)\n    statev(2) = stress(3)\n", ""),
        ],
    ),
    (
        "elastic slip in STATEV",
        &[
            ("t1 = statev(1) + props(2) * drdisp(2)", "t1 = props(2) * (statev(1) + drdisp(2))"),
            ("t2 = statev(2) + props(2) * drdisp(3)", "t2 = props(2) * (statev(2) + drdisp(3))"),
            (
                "    statev(1) = stress(2)\n    statev(2) = stress(3)\n",
                "    statev(1) = stress(2) / props(2)\n    statev(2) = stress(3) / props(2)\n",
            ),
        ],
    ),
    (
        "slip that is not elastic in STATEV",
        &[
            ("t1 = statev(1) + props(2) * drdisp(2)", "t1 = stress(2) + props(2) * drdisp(2)"),
            ("t2 = statev(2) + props(2) * drdisp(3)", "t2 = stress(3) + props(2) * drdisp(3)"),
            (
                "    statev(1) = stress(2)\n    statev(2) = stress(3)\n",
                "    statev(1) = rdisp(2) - stress(2) / props(2)\n    statev(2) = rdisp(3) - stress(3) / props(2)\n",
            ),
        ],
    ),
    (
        "says whether it is open",
        &[(
            "    stress(1) = 0\n",
            "    stress(1) = 0\n    lopenclose = merge(1, 0, rdisp(1) > 0)\n    lstate = lopenclose\n",
        )],
    ),
    (
        "constants in COMMON",
        &[
            (
                "    ! begin\n",
                "    real(dp) :: of_common\n    common /constants_of_interaction/ of_common(3)\n    ! begin\n    of_common = props(1:3)\n",
            ),
            ("limit = props(3)", "limit = of_common(3)"),
        ],
    ),
    ("closed at exactly 0", &[("if (rdisp(1) > 0)", "if (rdisp(1) >= 0)")]),
    (
        "a whole array at once",
        &[(
            "    ddsddr(1, 1) = 0\n    ddsddr(1, 2) = 0\n    ddsddr(1, 3) = 0\n    ddsddr(2, 1) = 0\n    ddsddr(3, 1) = 0\n",
            "    ddsddr = 0\n",
        )],
    ),
    (
        "energies",
        &[(
            "    statev(1) = stress(2)\n",
            "    statev(1) = stress(2)\n    sed = 0.5_dp * stress(1) * rdisp(1)\n    sfd = sfd + 0\n",
        )],
    ),
    (
        "initialises STATEV in the first increment",
        &[("    ddsddr(1, 1) = 0\n", "    ddsddr(1, 1) = 0\n    if (kstep == 1 .and. kinc == 1) statev(1:10) = 0\n")],
    ),
];

const MPC: &[Variant] = &[
    (
        "the projector of a textbook",
        &[
            LINE_DECLARED,
            (
                "    code = jp_slider_eliminate_jacobian(x1, xn, kept, y(1), y(2), slope)\n",
                concat!("    chosen = axes(1:2)\n", include_str!("textbook_line.f90")),
            ),
        ],
    ),
    (
        "coefficients with the other sign",
        &[
            ("a(1) = 1", "a(1) = -1"),
            ("a(2) = -slope", "a(2) = slope"),
            ("a(3:5) = -slope", "a(3:5) = slope"),
            ("a(6:8) = -slope", "a(6:8) = slope"),
        ],
    ),
    (
        "coefficients scaled",
        &[
            ("a(1) = 1", "a(1) = 4"),
            ("-slope(jtype, 7)", "-4 * slope(jtype, 7)"),
            ("-slope(jtype, 1:3)", "-4 * slope(jtype, 1:3)"),
            ("-slope(jtype, 4:6)", "-4 * slope(jtype, 4:6)"),
        ],
    ),
    (
        "terms of a node in another order",
        &[("jdof(3:5) = [1, 2, 3]", "jdof(3:5) = [3, 2, 1]"), ("-slope(jtype, 1:3)", "-slope(jtype, 3:1:-1)")],
    ),
    (
        "positions of another term of the same node",
        &[("x(1:3, 3) + u(1:3, 3)", "x(1:3, 5) + u(1:3, 5)"), ("x(1:3, 6) + u(1:3, 6)", "x(1:3, 7) + u(1:3, 7)")],
    ),
    ("the kept coordinate of the first term", &[("x(k, 2) + u(k, 2)", "x(k, 1) + u(k, 1)")]),
    ("X of m of the second term", &[("x(e, 1)", "x(e, 2)")]),
    (
        "two calls by branches",
        &[(
            "ue(1) = y(jtype) - x(e, 1)",
            "if (jtype == 1) ue(1) = y(1) - x(e, 1)\n    if (jtype == 2) ue(1) = y(2) - x(e, 1)",
        )],
    ),
    ("switched on explicitly", &[("    x1 = ", "    lmpc = 1\n    x1 = ")]),
    ("constants in COMMON", &[("    ! begin\n", "    common /of_line/ x1, xn\n    ! begin\n")]),
    (
        "loops",
        &[(
            "jdof(3:5) = [1, 2, 3]\n    jdof(6:8) = [1, 2, 3]",
            "do p = 1, 3\n        jdof(2 + p) = p\n        jdof(5 + p) = p\n    end do",
        )],
    ),
];

const MPC_NODE: &[Variant] = &[
    (
        "the projector of a textbook",
        &[
            LINE_DECLARED,
            (
                "    code = jp_slider_eliminate_jacobian(x1, xn, kept, y(1), y(2), slope)\n",
                concat!("    chosen = [i, j]\n", include_str!("textbook_line.f90")),
            ),
        ],
    ),
    (
        "eliminated in the other order",
        &[
            ("ue(1) = y(1) - x(i, 1)", "ue(2) = y(1) - x(i, 1)"),
            ("ue(2) = y(2) - x(j, 1)", "ue(1) = y(2) - x(j, 1)"),
            ("jdof(1, 1) = i", "jdof(2, 1) = i"),
            ("jdof(2, 1) = j", "jdof(1, 1) = j"),
            ("a(1, 1, 2) = -slope(1, 7)", "a(2, 1, 2) = -slope(1, 7)"),
            ("a(2, 1, 2) = -slope(2, 7)", "a(1, 1, 2) = -slope(2, 7)"),
            ("a(1, 1:3, 3) = -slope(1, 1:3)", "a(2, 1:3, 3) = -slope(1, 1:3)"),
            ("a(2, 1:3, 3) = -slope(2, 1:3)", "a(1, 1:3, 3) = -slope(2, 1:3)"),
            ("a(1, 1:3, 4) = -slope(1, 4:6)", "a(2, 1:3, 4) = -slope(1, 4:6)"),
            ("a(2, 1:3, 4) = -slope(2, 4:6)", "a(1, 1:3, 4) = -slope(2, 4:6)"),
        ],
    ),
    (
        "the first row with the other sign",
        &[
            ("a(1, 1, 1) = 1", "a(1, 1, 1) = -1"),
            ("a(1, 1, 2) = -slope", "a(1, 1, 2) = slope"),
            ("a(1, 1:3, 3) = -slope", "a(1, 1:3, 3) = slope"),
            ("a(1, 1:3, 4) = -slope", "a(1, 1:3, 4) = slope"),
        ],
    ),
    (
        "the second row scaled",
        &[
            ("a(2, 2, 1) = 1", "a(2, 2, 1) = 2"),
            ("a(2, 1, 2) = -slope", "a(2, 1, 2) = -2 * slope"),
            ("a(2, 1:3, 3) = -slope", "a(2, 1:3, 3) = -2 * slope"),
            ("a(2, 1:3, 4) = -slope", "a(2, 1:3, 4) = -2 * slope"),
        ],
    ),
    (
        "degrees of freedom of node 1 in another order",
        &[
            ("jdof(1:3, 3) = [1, 2, 3]", "jdof(1:3, 3) = [3, 2, 1]"),
            ("-slope(1, 1:3)", "-slope(1, 3:1:-1)"),
            ("-slope(2, 1:3)", "-slope(2, 3:1:-1)"),
        ],
    ),
    (
        "everything that is 0 is set",
        &[("    x1 = ", "    ue(1:mdof) = 0\n    jdof(1:mdof, 1:n) = 0\n    a(1:mdof, 1:mdof, 1:n) = 0\n    x1 = ")],
    ),
    ("the kept coordinate of the first node", &[("x(k, 2) + u(k, 2)", "x(k, 1) + u(k, 1)")]),
    ("X of m of the second node", &[("x(i, 1)", "x(i, 2)"), ("x(j, 1)", "x(j, 2)")]),
    ("switched on explicitly", &[("    x1 = ", "    lmpc = 1\n    x1 = ")]),
    ("constants in COMMON", &[("    ! begin\n", "    common /of_line_in_space/ x1, xn\n    ! begin\n")]),
];

const UMPC_USER: &[Variant] = &[
    (
        "the projector of a textbook",
        &[
            DECLARED,
            (
                "    code = jp_slider_constraint_jacobian(x1, xn, xm, g(1), g(2), slope)\n",
                concat!(
                    "    with_first = 0\n    with_second = 0\n",
                    include_str!("textbook.f90"),
                    "    g = gaps\n    slope = of_gaps\n"
                ),
            ),
        ],
    ),
    (
        "the number of the equation as a branch",
        &[("equation = nint(x(1, 10))", "equation = 1\n    if (x(1, 10) > 1.5_dp) equation = 2")],
    ),
    (
        "the last free coefficient of the first node",
        &[("k = maxloc(abs(row(1:3)), 1)", "k = 3 - maxloc(abs(row(3:1:-1)), 1) + 1")],
    ),
    (
        "JDOF(1) as it is where it may be",
        &[
            (
                "k = maxloc(abs(row(1:3)), 1)",
                "k = jdof(1)\n    if (abs(row(k)) < 1e-3_dp * maxval(abs(row(1:3)))) k = maxloc(abs(row(1:3)), 1)",
            ),
            ("jdof(1:9) = [1, 2, 3, 1, 2, 3, 1, 2, 3]", "jdof(2:9) = [2, 3, 1, 2, 3, 1, 2, 3]"),
        ],
    ),
    ("JDOF of the last term as it is", &[("jdof(10) = 1", "continue")]),
    (
        "positions of other terms of a node",
        &[("xn = x(:, 7) + u(:, 7)", "xn = x(:, 8) + u(:, 8)"), ("x1 = x(:, 4) + u(:, 4)", "x1 = x(:, 5) + u(:, 5)")],
    ),
    ("a discontinuity is told", &[("    f = g(equation)", "    idiscon = 0\n    f = g(equation)")]),
    ("constants in COMMON", &[("    ! begin\n", "    common /of_sliding_line/ x1, xn, xm\n    ! begin\n")]),
    ("loops", &[("a(1:9) = row", "do k = 1, 9\n        a(k) = row(k)\n    end do")]),
    ("N from the call", &[("a(10) = 0", "a(n) = 0"), ("jdof(10) = 1", "jdof(n) = 1"), ("x(1, 10)", "x(1, n)")]),
    (
        "swapped by hand",
        &[(
            "    if (k /= 1) then\n        a(k) = row(1)\n        jdof(k) = 1\n    end if\n",
            "    swapped = row(1)\n    if (k /= 1) a(k) = swapped\n    if (k /= 1) jdof(k) = 1\n",
        )],
    ),
];

const UEL: &[Variant] = &[
    (
        "the projector of a textbook",
        &[
            DECLARED,
            (
                "    code = jp_slider_constraint_jacobian(x1, xn, xm, g(1), g(2), of_g)\n    \
                 code = jp_slider_nodal_forces_jacobian(x1, xn, xm, first, second, f(1:3), f(4:6), f(7:9), of_f)\n",
                concat!(
                    "    with_first = first\n    with_second = second\n",
                    include_str!("textbook.f90"),
                    "    g = gaps\n    of_g = of_gaps\n    f = loads\n    of_f = of_loads\n"
                ),
            ),
        ],
    ),
    (
        "always both, whatever LFLAGS(3) asks",
        &[
            ("if (lflags(3) == 1 .or. lflags(3) == 5)", "if (.true.)"),
            ("if (lflags(3) == 1 .or. lflags(3) == 2)", "if (.true.)"),
        ],
    ),
    (
        "LFLAGS(3) by what is not asked",
        &[
            ("lflags(3) == 1 .or. lflags(3) == 5", "lflags(3) /= 2"),
            ("lflags(3) == 1 .or. lflags(3) == 2", "lflags(3) /= 5"),
        ],
    ),
    ("everything is 0 at first", &[("    x1 = ", "    amatrx = 0\n    rhs(1:ndofel) = 0\n    x1 = ")]),
    (
        "added to what is 0",
        &[
            ("rhs(1:3) = f(1:3)", "rhs(1:3) = rhs(1:3) + f(1:3)"),
            ("amatrx(1:3, :) = -", "amatrx(1:3, :) = amatrx(1:3, :) - "),
        ],
    ),
    ("a state that counts nothing", &[("    x1 = ", "    svars(1) = u(10)\n    svars(2) = 0\n    x1 = ")]),
    ("an energy", &[("    x1 = ", "    energy(2) = u(10)\n    x1 = ")]),
    ("constants in COMMON", &[("    ! begin\n", "    common /of_element/ x1, xn, xm\n    ! begin\n")]),
    (
        "loops",
        &[(
            "amatrx(10, 1:9) = -of_g(1, :)",
            "do code = 1, 9\n            amatrx(10, code) = -of_g(1, code)\n        end do",
        )],
    ),
    ("its own copy of LFLAGS(3)", &[("    x1 = ", "    code = lflags(3)\n    x1 = ")]),
    (
        "unsymmetric blocks in another order",
        &[("        rhs(10:11) = g\n", "        rhs(10) = g(1)\n        rhs(11) = g(2)\n")],
    ),
];

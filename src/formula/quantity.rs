//! The vocabulary: every quantity of the documents, with symbol, shape, unit, allowed values and meaning, defined once.
//!
//! A formula's inputs and outputs are fields that refer to these constants (see [`fields!`](crate::fields)); the sampler, the
//! input check, the golden files, the book and the error messages all read them from here.

mod vocabulary;

pub use vocabulary::{Domain, Node, Quantity, Shape, Unit};

/// Generates each constant and its documentation from one row of the table below.
macro_rules! quantities {
    ($($name:ident: $latex:literal, $shape:ident, $unit:expr, $domain:expr, $meaning:literal;)*) => {
        $(
            #[doc = concat!("$", $latex, "$: ", $meaning, ".")]
            pub const $name: Quantity = Quantity {
                latex: $latex, shape: Shape::$shape, unit: $unit, domain: $domain, meaning: $meaning,
            };
        )*
    };
}

use Domain::{Angle, Between, Direction, HalfOpen, NonNegative, Point, Positive, Real, Triad, Vector, Within};

const ONE: Unit = Unit::ONE;
const L: Unit = Unit::L;
const F: Unit = Unit::F;
const FL: Unit = Unit::FL;
const PRESSURE_UNIT: Unit = Unit::new(-2, 1, 0);

quantities! {
    E1A: r"\mathbf{e}_{1a}", Vec3, ONE, Triad(Node::A, 1), "first unit vector of node a's triad, in the global frame";
    E2A: r"\mathbf{e}_{2a}", Vec3, ONE, Triad(Node::A, 2), "second unit vector of node a's triad, in the global frame";
    E3A: r"\mathbf{e}_{3a}", Vec3, ONE, Triad(Node::A, 3), "third unit vector of node a's triad, in the global frame";
    E1B: r"\mathbf{e}_{1b}", Vec3, ONE, Triad(Node::B, 1), "first unit vector of node b's triad, in the global frame";
    E2B: r"\mathbf{e}_{2b}", Vec3, ONE, Triad(Node::B, 2), "second unit vector of node b's triad, in the global frame";
    E3B: r"\mathbf{e}_{3b}", Vec3, ONE, Triad(Node::B, 3), "third unit vector of node b's triad, in the global frame";
    XA: r"\mathbf{x}_a", Vec3, L, Point, "position of node a, in the global frame";
    XB: r"\mathbf{x}_b", Vec3, L, Point, "position of node b, in the global frame";
    E2A_PLANE: r"\mathbf{e}_{2a}", Vec2, ONE, Triad(Node::A, 2), "second unit vector of node a's triad in the plane, in the global frame";
    XA_PLANE: r"\mathbf{x}_a", Vec2, L, Point, "position of node a in the plane, in the global frame";
    XB_PLANE: r"\mathbf{x}_b", Vec2, L, Point, "position of node b in the plane, in the global frame";

    X: r"x", Scalar, L, Real, "relative position of b along e1a, positive in its direction";
    Y: r"y", Scalar, L, Real, "relative position of b along e2a, positive in its direction";
    Z: r"z", Scalar, L, Real, "relative position of b along e3a, positive in its direction";
    X0: r"x_0", Scalar, L, Real, "initial relative position along e1a";
    Y0: r"y_0", Scalar, L, Real, "initial relative position along e2a: offset of the slot";
    Z0: r"z_0", Scalar, L, Real, "initial relative position along e3a: offset of the slot";
    GY: r"g_y", Scalar, L, Real, "constraint residual along e2a, zero when b is on the slot";
    GZ: r"g_z", Scalar, L, Real, "constraint residual along e3a, zero when b is on the slot";
    L1_REF: r"l_1^{\mathrm{ref}}", Scalar, L, Real, "constitutive reference length along e1a";
    L1_MIN: r"l_1^{\min}", Scalar, L, Real, "lower stop: least relative position along e1a";
    L1_MAX: r"l_1^{\max}", Scalar, L, Real, "upper stop: greatest relative position along e1a";
    U1: r"u_1", Scalar, L, Real, "available displacement along e1a, zero at the start";
    U1_MAT: r"u_1^{\mathrm{mat}}", Scalar, L, Real, "constitutive displacement along e1a, zero at the reference length";
    GAP_MIN: r"\mathit{gap}_{\min}", Scalar, L, Real, "distance to the lower stop, negative beyond it";
    GAP_MAX: r"\mathit{gap}_{\max}", Scalar, L, Real, "distance to the upper stop, negative beyond it";

    F1: r"f_1", Scalar, F, Real, "kinetic force along e1a, which acts on node a, and its opposite on node b: conjugate to u1";
    JOIN_F1: r"f_1", Scalar, F, Real, "constraint force along e1a on node b, its opposite on node a";
    F2: r"f_2", Scalar, F, Real, "constraint force along e2a on node b, its opposite on node a";
    F3: r"f_3", Scalar, F, Real, "constraint force along e3a on node b, its opposite on node a";
    FORCE: r"\mathbf{f}", Vec3, F, Vector, "constraint force on node b, its opposite on node a, in the global frame";
    KINETIC_FORCE: r"\mathbf{f}", Vec3, F, Vector, "kinetic force on node a, its opposite on node b, in the global frame";
    F_TRIAL: r"f^{\mathrm{trial}}", Scalar, F, Real, "trial force: the tangential force if the contact sticks";
    F_TANGENTIAL: r"f", Scalar, F, Real, "friction force, positive where it resists positive motion";
    F_TRIAL_SURFACE: r"\mathbf{f}^{\mathrm{trial}}", Vec2, F, Vector, "trial force on a surface: the tangential force if the contact sticks";
    F_TANGENTIAL_SURFACE: r"\mathbf{f}", Vec2, F, Vector, "friction force on a surface, in the direction of the motion that it resists";
    DU: r"\Delta u", Scalar, L, Real, "increment of the relative motion in the direction of the friction force";
    F_BEFORE: r"f^-", Scalar, F, Real, "friction force before the increment, positive where it resists positive motion";
    SLIP: r"\Delta s", Scalar, L, Real, "slip of the increment, 0 in stick";
    K_STICK: r"k_{\mathrm{stick}}", Scalar, F.per(L), Positive, "stiffness in stick";
    // ANCHOR: example
    FC: r"F_C", Scalar, F, NonNegative, "contact force that the connector's loads produce";
    // ANCHOR_END: example
    FC_INT: r"F_C^{\mathrm{int}}", Scalar, F, Real, "self-equilibrated internal contact force, for instance from a press fit";
    FN: r"F_N", Scalar, F, NonNegative, "normal force that produces friction";
    MU: r"\mu", Scalar, ONE, NonNegative, "friction coefficient";
    P: r"P", Scalar, F, NonNegative, "magnitude of the frictional tangential tractions";
    PHI: r"\Phi", Scalar, F, Real, "yield function: stick below 0, slip at 0";

    // ALIGN, TRANSLATOR
    ALPHA: r"\alpha", Scalar, ONE, Angle, "first Cardan angle of b's triad relative to a's, about e1a, from −π to below π";
    BETA: r"\beta", Scalar, ONE, Angle, "second Cardan angle of b's triad relative to a's, from −π/2 to π/2";
    GAMMA: r"\gamma", Scalar, ONE, Angle, "third Cardan angle of b's triad relative to a's, about e3b, from −π to below π";
    ALPHA0: r"\alpha_0", Scalar, ONE, Angle, "initial value of the first Cardan angle";
    BETA0: r"\beta_0", Scalar, ONE, Angle, "initial value of the second Cardan angle";
    GAMMA0: r"\gamma_0", Scalar, ONE, Angle, "initial value of the third Cardan angle";
    UR1: r"u_{r1}", Scalar, ONE, Angle, "constraint residual of the first Cardan angle, zero when it has its initial value";
    UR2: r"u_{r2}", Scalar, ONE, Angle, "constraint residual of the second Cardan angle, zero when it has its initial value";
    UR3: r"u_{r3}", Scalar, ONE, Angle, "constraint residual of the third Cardan angle, zero when it has its initial value";
    M1: r"m_1", Scalar, FL, Real, "constraint moment about e1a on node b, its opposite on node a";
    M2: r"m_2", Scalar, FL, Real, "constraint moment about e2a on node b, its opposite on node a";
    M3: r"m_3", Scalar, FL, Real, "constraint moment about e3a on node b, its opposite on node a";
    MOMENT: r"\mathbf{m}", Vec3, FL, Vector, "constraint moment on node b, its opposite on node a, in the global frame";
    KINETIC_MOMENT: r"\mathbf{m}", Vec3, FL, Vector, "kinetic moment on node a, its opposite on node b, in the global frame";
    RR: r"R_r", Scalar, L, NonNegative, "effective radius of the shaft normal to the slot; 0 omits the friction from torque";
    L_OVERLAP: r"L", Scalar, L, NonNegative, "characteristic overlap length along the slot; 0 omits the friction from bending";
    M_TORQ: r"M_{\mathrm{torq}}", Scalar, FL, NonNegative, "magnitude of the torque about the slot";
    F_TORQ: r"F_{\mathrm{torq}}", Scalar, F, NonNegative, "contact force that the torque produces";
    THETA1_MIN: r"\theta_1^{\min}", Scalar, ONE, Angle, "lower stop: least angle about e1a";
    THETA1_MAX: r"\theta_1^{\max}", Scalar, ONE, Angle, "upper stop: greatest angle about e1a";
    THETA3_MIN: r"\theta_3^{\min}", Scalar, ONE, Angle, "lower stop: least angle about e3b";
    THETA3_MAX: r"\theta_3^{\max}", Scalar, ONE, Angle, "upper stop: greatest angle about e3b";
    GAP1_MIN: r"\mathit{gap}_{1\min}", Scalar, ONE, Real, "angle to the lower stop about e1a, negative beyond it";
    GAP1_MAX: r"\mathit{gap}_{1\max}", Scalar, ONE, Real, "angle to the upper stop about e1a, negative beyond it";
    GAP3_MIN: r"\mathit{gap}_{3\min}", Scalar, ONE, Real, "angle to the lower stop about e3b, negative beyond it";
    GAP3_MAX: r"\mathit{gap}_{3\max}", Scalar, ONE, Real, "angle to the upper stop about e3b, negative beyond it";
    FR: r"F_r", Scalar, F, NonNegative, "magnitude of the radial constraint force, normal to the slot";
    M_BEND: r"M_{\mathrm{bend}}", Scalar, FL, NonNegative, "magnitude of the bending moment";
    F_BEND: r"F_{\mathrm{bend}}", Scalar, F, NonNegative, "contact force that bending produces";

    // JOIN, UNIVERSAL, UJOINT
    D0: r"\mathbf{d}_0", Vec3, L, Real, "initial position of b relative to a, as components in a's triad";
    G_JOIN: r"\mathbf{g}", Vec3, L, Real, "residual of JOIN as components in a's triad, zero when b is at its initial position";
    C0: r"c_0", Scalar, ONE, Real, "initial value of e1a·e3b, the sine of the second Cardan angle";
    G_UNIVERSAL: r"g", Scalar, ONE, Real, "residual of UNIVERSAL, zero when e1a and e3b have their initial angle";
    THETA1_REF: r"\theta_1^{\mathrm{ref}}", Scalar, ONE, Angle, "constitutive reference angle about e1a";
    THETA3_REF: r"\theta_3^{\mathrm{ref}}", Scalar, ONE, Angle, "constitutive reference angle about e3b";
    U_R1: r"u_{r1}", Scalar, ONE, Angle, "available rotation about e1a, zero at the start";
    U_R3: r"u_{r3}", Scalar, ONE, Angle, "available rotation about e3b, zero at the start";
    U_R1_MAT: r"u_{r1}^{\mathrm{mat}}", Scalar, ONE, Angle, "constitutive rotation about e1a, zero at the reference angle";
    U_R3_MAT: r"u_{r3}^{\mathrm{mat}}", Scalar, ONE, Angle, "constitutive rotation about e3b, zero at the reference angle";
    TWIST_M2: r"m_2", Scalar, FL, Real, "constraint moment of UNIVERSAL on node b, its opposite on node a, about the direction cos α e2a + sin α e3a";
    CROSS_M1: r"m_1", Scalar, FL, Real, "kinetic moment about e1a, which acts on node a, and its opposite on node b: conjugate to ur1";
    CROSS_M3: r"m_3", Scalar, FL, Real, "kinetic moment about e3b, which acts on node a, and its opposite on node b: conjugate to ur3";
    G_ROT: r"g_{\mathrm{rot}}", Scalar, ONE, Real, "residual of UNIVERSAL in UJOINT, zero when e1a and e3b have their initial angle";
    UJOINT_FR: r"F_r", Scalar, F, NonNegative, "reaction force: magnitude of the force that JOIN transmits";
    E_CROSS: r"\mathbf{e}_{\mathrm{cross}}", Vec3, ONE, Vector, "normal of the cross plane, e1a × e3b, in the global frame";
    RP: r"R_p", Scalar, L, Positive, "average radius of the pins at the ends of the cross";
    LA: r"L_a", Scalar, L, Positive, "length of a cross arm, from the centre to the pin";
    RA: r"R_a", Scalar, L, NonNegative, "effective friction arm of the axial force of a pin; 0 omits this force";
    LS: r"L_s", Scalar, L, NonNegative, "length over which pin and sleeve overlap; 0 omits the bending moments";
    ALPHA_TWIST: r"\alpha_{\mathrm{twist}}", Scalar, ONE, NonNegative, "share of the twisting moment that acts as bending moment on a hinge";
    BETA_TWIST: r"\beta_{\mathrm{twist}}", Scalar, ONE, NonNegative, "transverse force on a hinge, divided by the twisting moment over the arm length";
    ALPHA_AXIAL: r"\alpha_{\mathrm{axial}}", Scalar, ONE, NonNegative, "share of a force along an axis of the cross for each hinge on that axis";
    BETA_AXIAL: r"\beta_{\mathrm{axial}}", Scalar, ONE, NonNegative, "share of a force along an axis of the cross for each hinge on the other axis";
    F_AXIAL1: r"F_{\mathrm{axial1}}", Scalar, F, Real, "force along e1a at the centre of the cross";
    F_AXIAL3: r"F_{\mathrm{axial3}}", Scalar, F, Real, "force along e3b at the centre of the cross";
    CROSS_F_BEND: r"F_{\mathrm{bend}}", Scalar, F, Real, "force along e1a × e3b at the centre of the cross, which bends its arms";
    M_TWIST_HINGE: r"M_{\mathrm{twist}}^{\mathrm{hinge}}", Scalar, FL, NonNegative, "bending moment on each hinge from the twisting moment";
    F_TWIST_HINGE: r"F_{\mathrm{twist}}^{\mathrm{hinge}}", Scalar, F, NonNegative, "transverse force on each hinge from the twisting moment";
    F_AXIAL_HINGE1: r"F_{\mathrm{axial1}}^{\mathrm{hinge}}", Scalar, F, NonNegative, "axial force on each hinge along e1a";
    F_AXIAL_HINGE3: r"F_{\mathrm{axial3}}^{\mathrm{hinge}}", Scalar, F, NonNegative, "axial force on each hinge along e3b";
    F_TRANSV_HINGE1: r"F_{\mathrm{transv1}}^{\mathrm{hinge}}", Scalar, F, NonNegative, "transverse force on each hinge along e1a from the force along e3b";
    F_TRANSV_HINGE3: r"F_{\mathrm{transv3}}^{\mathrm{hinge}}", Scalar, F, NonNegative, "transverse force on each hinge along e3b from the force along e1a";
    F_TOTAL_HINGE1: r"F_{\mathrm{total1}}^{\mathrm{hinge}}", Scalar, F, NonNegative, "total transverse force on each hinge along e1a";
    F_TOTAL_HINGE3: r"F_{\mathrm{total3}}^{\mathrm{hinge}}", Scalar, F, NonNegative, "total transverse force on each hinge along e3b";
    M_BEND_HINGE: r"M_{\mathrm{bend}}^{\mathrm{hinge}}", Scalar, FL, NonNegative, "bending moment on each hinge from the force normal to the cross";
    M_TOTAL_HINGE: r"M_{\mathrm{total}}^{\mathrm{hinge}}", Scalar, FL, NonNegative, "total bending moment on each hinge";
    F_TOTAL_BEND: r"F_{\mathrm{total}}^{\mathrm{bend}}", Scalar, F, NonNegative, "contact force in a sleeve from the total bending moment";
    MC1: r"M_{C1}", Scalar, FL, Real, "contact moment of a hinge along e1a, which the connector's loads produce";
    MC3: r"M_{C3}", Scalar, FL, Real, "contact moment of a hinge along e3b, which the connector's loads produce";
    MC1_INT: r"M_{C1}^{\mathrm{int}}", Scalar, FL, Real, "self-equilibrated internal contact moment about e1a, for instance from a press fit";
    MC3_INT: r"M_{C3}^{\mathrm{int}}", Scalar, FL, Real, "self-equilibrated internal contact moment about e3b, for instance from a press fit";
    MN1: r"M_{N1}", Scalar, FL, NonNegative, "normal moment that produces friction about e1a";
    MN3: r"M_{N3}", Scalar, FL, NonNegative, "normal moment that produces friction about e3b";
    PHI1: r"\Phi_1", Scalar, FL, Real, "yield function about e1a: stick below 0, slip at 0";
    PHI3: r"\Phi_3", Scalar, FL, Real, "yield function about e3b: stick below 0, slip at 0";

    // Elements
    G1_UA: r"\mathbf{g}_{1,ua}", Vec3, ONE, Vector, "derivative of the first residual of JOIN with respect to the translation of node a";
    G1_TA: r"\mathbf{g}_{1,\theta a}", Vec3, L, Vector, "derivative of the first residual of JOIN with respect to the spin of node a";
    G1_UB: r"\mathbf{g}_{1,ub}", Vec3, ONE, Vector, "derivative of the first residual of JOIN with respect to the translation of node b";
    G2_UA: r"\mathbf{g}_{2,ua}", Vec3, ONE, Vector, "derivative of the second residual of JOIN with respect to the translation of node a";
    G2_TA: r"\mathbf{g}_{2,\theta a}", Vec3, L, Vector, "derivative of the second residual of JOIN with respect to the spin of node a";
    G2_UB: r"\mathbf{g}_{2,ub}", Vec3, ONE, Vector, "derivative of the second residual of JOIN with respect to the translation of node b";
    G3_UA: r"\mathbf{g}_{3,ua}", Vec3, ONE, Vector, "derivative of the third residual of JOIN with respect to the translation of node a";
    G3_TA: r"\mathbf{g}_{3,\theta a}", Vec3, L, Vector, "derivative of the third residual of JOIN with respect to the spin of node a";
    G3_UB: r"\mathbf{g}_{3,ub}", Vec3, ONE, Vector, "derivative of the third residual of JOIN with respect to the translation of node b";
    GY_UA: r"\mathbf{g}_{y,ua}", Vec3, ONE, Vector, "derivative of SLOT's residual along e2a with respect to the translation of node a";
    GY_TA: r"\mathbf{g}_{y,\theta a}", Vec3, L, Vector, "derivative of SLOT's residual along e2a with respect to the spin of node a";
    GY_UB: r"\mathbf{g}_{y,ub}", Vec3, ONE, Vector, "derivative of SLOT's residual along e2a with respect to the translation of node b";
    GZ_UA: r"\mathbf{g}_{z,ua}", Vec3, ONE, Vector, "derivative of SLOT's residual along e3a with respect to the translation of node a";
    GZ_TA: r"\mathbf{g}_{z,\theta a}", Vec3, L, Vector, "derivative of SLOT's residual along e3a with respect to the spin of node a";
    GZ_UB: r"\mathbf{g}_{z,ub}", Vec3, ONE, Vector, "derivative of SLOT's residual along e3a with respect to the translation of node b";
    GY_UA_PLANE: r"\mathbf{g}_{y,ua}", Vec2, ONE, Vector, "derivative of SLOT's residual in the plane with respect to the translation of node a";
    GY_TA_PLANE: r"g_{y,\theta a}", Scalar, L, Real, "derivative of SLOT's residual in the plane with respect to the spin of node a, positive from the first axis to the second";
    GY_UB_PLANE: r"\mathbf{g}_{y,ub}", Vec2, ONE, Vector, "derivative of SLOT's residual in the plane with respect to the translation of node b";
    G_ROT_TA: r"\mathbf{g}_{\mathrm{rot},\theta a}", Vec3, ONE, Vector, "derivative of the residual of UNIVERSAL with respect to the spin of node a";
    G_ROT_TB: r"\mathbf{g}_{\mathrm{rot},\theta b}", Vec3, ONE, Vector, "derivative of the residual of UNIVERSAL with respect to the spin of node b";
    UR1_TB: r"\mathbf{u}_{r1,\theta b}", Vec3, ONE, Vector, "derivative of the first residual of ALIGN with respect to the spin of node b; the derivative with respect to the spin of node a is its negative";
    UR2_TB: r"\mathbf{u}_{r2,\theta b}", Vec3, ONE, Vector, "derivative of the second residual of ALIGN with respect to the spin of node b; the derivative with respect to the spin of node a is its negative";
    UR3_TB: r"\mathbf{u}_{r3,\theta b}", Vec3, ONE, Vector, "derivative of the third residual of ALIGN with respect to the spin of node b; the derivative with respect to the spin of node a is its negative";
    LAMBDA_R1: r"\lambda_{r1}", Scalar, FL, Real, "multiplier of ALIGN's first residual: the moment on b about e1a";
    LAMBDA_R2: r"\lambda_{r2}", Scalar, FL, Real, "multiplier of ALIGN's second residual: the moment on b about the line of nodes";
    LAMBDA_R3: r"\lambda_{r3}", Scalar, FL, Real, "multiplier of ALIGN's third residual: the moment on b about e3b";
    LAMBDA_ROT: r"\lambda_{\mathrm{rot}}", Scalar, FL, Real, "multiplier of UNIVERSAL's residual e1a·e3b: m2 divided by the cosine of the second Cardan angle";
    FORCE_A: r"\mathbf{f}_a", Vec3, F, Vector, "force of the connector on node a, in the global frame";
    MOMENT_A: r"\mathbf{m}_a", Vec3, FL, Vector, "moment of the connector on node a, in the global frame";
    FORCE_B: r"\mathbf{f}_b", Vec3, F, Vector, "force of the connector on node b, in the global frame";
    MOMENT_B: r"\mathbf{m}_b", Vec3, FL, Vector, "moment of the connector on node b, in the global frame";
    TRANSLATION_A: r"\mathbf{u}_a", Vec3, L, Vector, "translation of node a, in the global frame";
    SPIN_A: r"\boldsymbol{\theta}_a", Vec3, ONE, Vector, "spin of node a by the right-hand rule, in the global frame";
    TRANSLATION_B: r"\mathbf{u}_b", Vec3, L, Vector, "translation of node b, in the global frame";
    SPIN_B: r"\boldsymbol{\theta}_b", Vec3, ONE, Vector, "spin of node b by the right-hand rule, in the global frame";
    TRANSLATION_A_PLANE: r"\mathbf{u}_a", Vec2, L, Vector, "translation of node a in the plane, in the global frame";
    SPIN_A_PLANE: r"\theta_a", Scalar, ONE, Real, "spin of node a in the plane, positive from the first axis to the second";
    TRANSLATION_B_PLANE: r"\mathbf{u}_b", Vec2, L, Vector, "translation of node b in the plane, in the global frame";
    SPIN_B_PLANE: r"\theta_b", Scalar, ONE, Real, "spin of node b in the plane, positive from the first axis to the second";
    MOMENT_B_PLANE: r"m_b", Scalar, FL, Real, "moment of the connector on node b in the plane, positive from the first axis to the second";
    TRANSLATION_1: r"\mathbf{u}_1", Vec3, L, Vector, "translation of node 1, in the global frame";
    TRANSLATION_N: r"\mathbf{u}_n", Vec3, L, Vector, "translation of node n, in the global frame";
    TRANSLATION_M: r"\mathbf{u}_m", Vec3, L, Vector, "translation of node m, in the global frame";
    TRANSLATION_1_PLANE: r"\mathbf{u}_1", Vec2, L, Vector, "translation of node 1 in the plane, in the global frame";
    TRANSLATION_N_PLANE: r"\mathbf{u}_n", Vec2, L, Vector, "translation of node n in the plane, in the global frame";
    TRANSLATION_M_PLANE: r"\mathbf{u}_m", Vec2, L, Vector, "translation of node m in the plane, in the global frame";
    FORCE_A_PLANE: r"\mathbf{f}_a", Vec2, F, Vector, "force of the connector on node a in the plane, in the global frame";
    MOMENT_A_PLANE: r"m_a", Scalar, FL, Real, "moment of the connector on node a in the plane, positive from the first axis to the second";
    FORCE_B_PLANE: r"\mathbf{f}_b", Vec2, F, Vector, "force of the connector on node b in the plane, in the global frame";
    K_UA_TA_PLANE: r"\mathbf{k}_{ua,\theta a}", Vec2, F, Vector, "derivative of the force on node a with respect to the spin of node a in the plane, at constant multipliers";
    K_TA_TA_PLANE: r"k_{\theta a,\theta a}", Scalar, FL, Real, "derivative of the moment on node a with respect to the spin of node a in the plane, at constant multipliers";
    K_UA_TA: r"\mathbf{K}_{ua,\theta a}", Mat3, F, Vector, "derivative of the force on node a with respect to the spin of node a, at constant multipliers";
    K_TA_TA: r"\mathbf{K}_{\theta a,\theta a}", Mat3, FL, Vector, "derivative of the moment on node a with respect to the spin of node a, at constant multipliers";
    K_TA_TB: r"\mathbf{K}_{\theta a,\theta b}", Mat3, FL, Vector, "derivative of the moment on node a with respect to the spin of node b, at constant multipliers";
    K_TB_TB: r"\mathbf{K}_{\theta b,\theta b}", Mat3, FL, Vector, "derivative of the moment on node b with respect to the spin of node b, at constant multipliers";
    ARM: r"\mathbf{r}", Vec3, L, Vector, "rigid arm from a node to the point of the connector, in the global frame";
    ARM_FORCE: r"\mathbf{f}", Vec3, F, Vector, "force at the end of a rigid arm, in the global frame";
    ARM_MOMENT: r"\mathbf{m}", Vec3, FL, Vector, "moment at the end of a rigid arm, in the global frame";
    NODE_MOMENT: r"\mathbf{m}_{\mathrm{node}}", Vec3, FL, Vector, "moment on the node from the force and the moment at the end of the arm, in the global frame";
    K_ARM: r"\mathbf{K}_{\mathrm{arm}}", Mat3, FL, Vector, "derivative of the moment of the force about the node with respect to its spin, at constant force";
    PSI: r"\boldsymbol{\psi}", Vec3, ONE, Vector, "rotation vector of a node: its direction is the axis of rotation, its length the angle in radians";
    SPIN_MOMENT: r"\mathbf{m}", Vec3, FL, Vector, "moment on the node, conjugate to its spin, in the global frame";
    PSI_MOMENT: r"\mathbf{m}_\psi", Vec3, FL, Vector, "generalised moment on the node, conjugate to the rotation vector";
    EULER_Q0: r"q_0", Scalar, ONE, Real, "first Euler parameter of a node: the cosine of half the angle of rotation";
    EULER_Q: r"\mathbf{q}", Vec3, ONE, Vector, "the other Euler parameters: the axis of rotation times the sine of half the angle";
    EULER_MOMENT0: r"m_{q0}", Scalar, FL, Real, "generalised moment on the node, conjugate to the first Euler parameter";
    EULER_MOMENT: r"\mathbf{m}_q", Vec3, FL, Vector, "generalised moment on the node, conjugate to the other Euler parameters";

    TURN1: r"u_{r1}", Scalar, ONE, Real, "rotation of b relative to a about e1a, continued beyond half a turn";
    TURN3: r"u_{r3}", Scalar, ONE, Real, "rotation of b relative to a about e3b, continued beyond half a turn";
    K_STICK_R1: r"k_{\mathrm{stick},1}", Scalar, FL, Positive, "stiffness about e1a in stick, moment per radian";
    K_STICK_R3: r"k_{\mathrm{stick},3}", Scalar, FL, Positive, "stiffness about e3b in stick, moment per radian";

    // SLIDER
    SLIDER_X1: r"\mathbf{x}_1", Vec3, L, Point, "position of node 1, where the line begins";
    SLIDER_XN: r"\mathbf{x}_n", Vec3, L, Point, "position of node n, where the line ends";
    SLIDER_XM: r"\mathbf{x}_m", Vec3, L, Point, "position of node m, which must lie on the line";
    SLIDER_XMK: r"x_{m,k}", Scalar, L, Real, "coordinate of node m along the retained axis k";
    SLIDER_XMI: r"x_{m,i}", Scalar, L, Real, "coordinate of node m along the first eliminated axis, i";
    SLIDER_XMJ: r"x_{m,j}", Scalar, L, Real, "coordinate of node m along the second eliminated axis, j";
    SLIDER_N: r"\mathbf{n}", Vec3, ONE, Direction, "direction of the line, from node 1 to node n";
    SLIDER_LENGTH: r"l", Scalar, L, Positive, "distance from node 1 to node n";
    SLIDER_T1: r"\mathbf{t}_1", Vec3, ONE, Vector, "first direction normal to the line";
    SLIDER_T2: r"\mathbf{t}_2", Vec3, ONE, Vector, "second direction normal to the line";
    SLIDER_G1: r"g_1", Scalar, L, Real, "distance of node m from the line along t1, zero when m is on the line";
    SLIDER_G2: r"g_2", Scalar, L, Real, "distance of node m from the line along t2, zero when m is on the line";
    SLIDER_DX1: r"\mathrm{d}\mathbf{x}_1", Vec3, L, Vector, "increment of the position of node 1";
    SLIDER_DXN: r"\mathrm{d}\mathbf{x}_n", Vec3, L, Vector, "increment of the position of node n";
    SLIDER_DXM: r"\mathrm{d}\mathbf{x}_m", Vec3, L, Vector, "increment of the position of node m";
    SLIDER_DXMK: r"\mathrm{d}x_{m,k}", Scalar, L, Real, "increment of the retained coordinate of node m";
    SLIDER_DXMI: r"\mathrm{d}x_{m,i}", Scalar, L, Real, "increment of the first eliminated coordinate of node m";
    SLIDER_DXMJ: r"\mathrm{d}x_{m,j}", Scalar, L, Real, "increment of the second eliminated coordinate of node m";
    SLIDER_DN: r"\mathrm{d}\mathbf{n}", Vec3, ONE, Vector, "variation of the direction of the line";
    SLIDER_DL: r"\mathrm{d}l", Scalar, L, Real, "variation of the distance from node 1 to node n";
    SLIDER_DT1: r"\mathrm{d}\mathbf{t}_1", Vec3, ONE, Vector, "variation of the first direction normal to the line";
    SLIDER_DT2: r"\mathrm{d}\mathbf{t}_2", Vec3, ONE, Vector, "variation of the second direction normal to the line";
    SLIDER_R1: r"r_1", Scalar, L, Real, "residual of the first incremental condition";
    SLIDER_R2: r"r_2", Scalar, L, Real, "residual of the second incremental condition";
    SLIDER_X1_PLANE: r"\mathbf{x}_1", Vec2, L, Point, "position of node 1 in the plane, where the line begins";
    SLIDER_XN_PLANE: r"\mathbf{x}_n", Vec2, L, Point, "position of node n in the plane, where the line ends";
    SLIDER_XM_PLANE: r"\mathbf{x}_m", Vec2, L, Point, "position of node m in the plane, which must lie on the line";
    SLIDER_DX1_PLANE: r"\mathrm{d}\mathbf{x}_1", Vec2, L, Vector, "increment of the position of node 1 in the plane";
    SLIDER_DXN_PLANE: r"\mathrm{d}\mathbf{x}_n", Vec2, L, Vector, "increment of the position of node n in the plane";
    SLIDER_DXM_PLANE: r"\mathrm{d}\mathbf{x}_m", Vec2, L, Vector, "increment of the position of node m in the plane";
    SLIDER_G: r"g", Scalar, L, Real, "distance of node m from the line along t, positive to the left of the line";
    SLIDER_R: r"r", Scalar, L, Real, "residual of the incremental condition in the plane, positive to the left of the line";
    SLIDER_XMI_PLANE: r"x_{m,i}", Scalar, L, Real, "coordinate of node m along the eliminated axis i in the plane";
    SLIDER_G1_U1: r"\mathbf{g}_{1,u1}", Vec3, ONE, Vector, "derivative of the first residual of SLIDER with respect to the translation of node 1, with m on the line";
    SLIDER_G1_UN: r"\mathbf{g}_{1,un}", Vec3, ONE, Vector, "derivative of the first residual of SLIDER with respect to the translation of node n, with m on the line";
    SLIDER_G1_UM: r"\mathbf{g}_{1,um}", Vec3, ONE, Vector, "derivative of the first residual of SLIDER with respect to the translation of node m, with m on the line";
    SLIDER_G2_U1: r"\mathbf{g}_{2,u1}", Vec3, ONE, Vector, "derivative of the second residual of SLIDER with respect to the translation of node 1, with m on the line";
    SLIDER_G2_UN: r"\mathbf{g}_{2,un}", Vec3, ONE, Vector, "derivative of the second residual of SLIDER with respect to the translation of node n, with m on the line";
    SLIDER_G2_UM: r"\mathbf{g}_{2,um}", Vec3, ONE, Vector, "derivative of the second residual of SLIDER with respect to the translation of node m, with m on the line";
    SLIDER_G_U1_PLANE: r"\mathbf{g}_{u1}", Vec2, ONE, Vector, "derivative of the residual of SLIDER in the plane with respect to the translation of node 1, with m on the line";
    SLIDER_G_UN_PLANE: r"\mathbf{g}_{un}", Vec2, ONE, Vector, "derivative of the residual of SLIDER in the plane with respect to the translation of node n, with m on the line";
    SLIDER_G_UM_PLANE: r"\mathbf{g}_{um}", Vec2, ONE, Vector, "derivative of the residual of SLIDER in the plane with respect to the translation of node m, with m on the line";
    SLIDER_LAMBDA1: r"\lambda_1", Scalar, F, Real, "multiplier of SLIDER's first residual: the force on node m along t1";
    SLIDER_LAMBDA2: r"\lambda_2", Scalar, F, Real, "multiplier of SLIDER's second residual: the force on node m along t2";
    SLIDER_LAMBDA: r"\lambda", Scalar, F, Real, "multiplier of SLIDER's residual in the plane: the force on node m along t";
    FORCE_1: r"\mathbf{f}_1", Vec3, F, Vector, "force of the constraint on node 1, in the global frame";
    FORCE_N: r"\mathbf{f}_n", Vec3, F, Vector, "force of the constraint on node n, in the global frame";
    FORCE_M: r"\mathbf{f}_m", Vec3, F, Vector, "force of the constraint on node m, in the global frame";
    FORCE_1_PLANE: r"\mathbf{f}_1", Vec2, F, Vector, "force of the constraint on node 1 in the plane, in the global frame";
    FORCE_N_PLANE: r"\mathbf{f}_n", Vec2, F, Vector, "force of the constraint on node n in the plane, in the global frame";
    FORCE_M_PLANE: r"\mathbf{f}_m", Vec2, F, Vector, "force of the constraint on node m in the plane, in the global frame";
    K_U1_U1: r"\mathbf{K}_{u1,u1}", Mat3, F.per(L), Vector, "derivative of the force on node 1 with respect to the translation of node 1, at constant multipliers";
    K_U1_UN: r"\mathbf{K}_{u1,un}", Mat3, F.per(L), Vector, "derivative of the force on node 1 with respect to the translation of node n, at constant multipliers";
    K_UN_UN: r"\mathbf{K}_{un,un}", Mat3, F.per(L), Vector, "derivative of the force on node n with respect to the translation of node n, at constant multipliers";
    K_UM_UN: r"\mathbf{K}_{um,un}", Mat3, F.per(L), Vector, "derivative of the force on node m with respect to the translation of node n, at constant multipliers";
    K_U1_U1_PLANE: r"\mathbf{K}_{u1,u1}", Mat2, F.per(L), Vector, "derivative of the force on node 1 with respect to the translation of node 1 in the plane, at constant multipliers";
    K_U1_UN_PLANE: r"\mathbf{K}_{u1,un}", Mat2, F.per(L), Vector, "derivative of the force on node 1 with respect to the translation of node n in the plane, at constant multipliers";
    K_UN_UN_PLANE: r"\mathbf{K}_{un,un}", Mat2, F.per(L), Vector, "derivative of the force on node n with respect to the translation of node n in the plane, at constant multipliers";
    K_UM_UN_PLANE: r"\mathbf{K}_{um,un}", Mat2, F.per(L), Vector, "derivative of the force on node m with respect to the translation of node n in the plane, at constant multipliers";

    // Slide lines
    XS: r"\mathbf{x}_s", Vec2, L, Point, "position of the slave point, in the plane (r, z)";
    X1: r"\mathbf{x}_1", Vec2, L, Point, "position of the first node in sequence, in the plane (r, z)";
    X2: r"\mathbf{x}_2", Vec2, L, Point, "position of the second node in sequence, in the plane (r, z)";
    X3: r"\mathbf{x}_3", Vec2, L, Point, "position of the third node in sequence, in the plane (r, z)";
    X4: r"\mathbf{x}_4", Vec2, L, Point, "position of the fourth node in sequence, in the plane (r, z)";
    X5: r"\mathbf{x}_5", Vec2, L, Point, "position of the fifth node in sequence, in the plane (r, z)";
    CURVE: r"\mathbf{X}", Vec2, L, Point, "point of the slide line, in the plane (r, z)";
    CURVE_RATE: r"\mathbf{X}'", Vec2, L, Vector, "derivative of the point with respect to its coordinate, along the tangent";
    TANGENT: r"\mathbf{t}", Vec2, ONE, Vector, "unit tangent of the slide line, in the sequence of its nodes";
    NORMAL: r"\mathbf{n}", Vec2, ONE, Vector, "unit normal of the slide line, 90° to the left of the tangent, towards the slave";
    SEGMENT_G: r"g", Scalar, ONE, Within(-1.0, 1.0), "coordinate along a segment, from -1 at its first node to 1 at its last";
    CORNER_T: r"t", Scalar, ONE, Within(0.0, 1.0), "coordinate along a smoothed corner, from 0 at its start to 1 at its end";
    FRACTION: r"f", Scalar, ONE, Between(0.0, 0.5), "smoothing fraction: the part of each segment that is replaced by a smoothed corner";
    SMOOTH: r"f", Scalar, ONE, HalfOpen(0.0, 0.5), "smoothing fraction: the part of each segment that is replaced by a smoothed corner; 0 for sharp corners";
    EXTENSION_ZONE: r"e", Scalar, ONE, Within(0.0, 0.2), "fraction of the end segment by which an open slide line is extended at either end";
    SEPARATION: r"E_{11}", Scalar, L, Real, "separation of the slave point from the slide line along its normal, positive when open";
    DXS: r"\Delta\mathbf{x}_s", Vec2, L, Vector, "displacement increment of the slave point";
    DX1: r"\Delta\mathbf{x}_1", Vec2, L, Vector, "displacement increment of the first node in sequence";
    DX2: r"\Delta\mathbf{x}_2", Vec2, L, Vector, "displacement increment of the second node in sequence";
    DX3: r"\Delta\mathbf{x}_3", Vec2, L, Vector, "displacement increment of the third node in sequence";
    DSLIP: r"\Delta E_{12}", Scalar, L, Real, "increment of the tangential displacement of the slave point relative to the slide line";
    A1: r"A_1", Scalar, Unit::new(2, 0, 0), NonNegative, "contact area of the first node, around the whole circumference";
    A2: r"A_2", Scalar, Unit::new(2, 0, 0), NonNegative, "contact area of the second node, around the whole circumference";
    A3: r"A_3", Scalar, Unit::new(2, 0, 0), NonNegative, "contact area of the third node, around the whole circumference";
    P1: r"p_1", Scalar, PRESSURE_UNIT, NonNegative, "contact pressure at the first node, positive in compression";
    P2: r"p_2", Scalar, PRESSURE_UNIT, NonNegative, "contact pressure at the second node, positive in compression";
    P3: r"p_3", Scalar, PRESSURE_UNIT, NonNegative, "contact pressure at the third node, positive in compression";
    TORQUE: r"T", Scalar, Unit::FL, Real, "largest torque about the z axis that the interface can transmit with friction coefficient 1";
    AREA: r"A", Scalar, Unit::new(2, 0, 0), NonNegative, "contact area of the slave node, around the whole circumference";
    S11: r"S_{11}", Scalar, PRESSURE_UNIT, Real, "contact pressure, positive where it pushes the slave point along the normal";
    S12: r"S_{12}", Scalar, PRESSURE_UNIT, Real, "shear stress, positive where it resists positive slip and pushes the slave point against the tangent";
    S12_BEFORE: r"S_{12}^{\mathrm{before}}", Scalar, PRESSURE_UNIT, Real, "shear stress before the increment";
    LINE_G: r"g", Scalar, ONE, Real, "coordinate along a straight segment and its straight continuation past the ends, from -1 at its first node to 1 at its last";
    LINE_G_BEFORE: r"g^{\mathrm{before}}", Scalar, ONE, Within(-1.0, 1.0), "coordinate on the segment before the increment, from -1 at its first node to 1 at its last";
    XO: r"\mathbf{x}_o", Vec2, L, Point, "position of the other node of the ISL21A element, in the plane (r, z)";
    LINE_FORCE_S: r"\mathbf{f}_s", Vec2, F, Vector, "force of the contact on the slave point, around the whole circumference";
    LINE_FORCE_1: r"\mathbf{f}_1", Vec2, F, Vector, "force of the contact on the first node, around the whole circumference";
    LINE_FORCE_2: r"\mathbf{f}_2", Vec2, F, Vector, "force of the contact on the second node, around the whole circumference";
    LINE_FORCE_3: r"\mathbf{f}_3", Vec2, F, Vector, "force of the contact on the third node, around the whole circumference";

    // Interaction laws
    OVERCLOSURE: r"h", Scalar, L, Real, "overclosure, the separation with the opposite sign: positive when the surfaces overlap";
    STIFFNESS: r"k", Scalar, Unit::new(-3, 1, 0), Positive, "contact stiffness, pressure per overclosure";
    CLEARANCE: r"c_0", Scalar, L, Positive, "clearance at which pressure or damping begins";
    PRESSURE_AT_TOUCH: r"p_0", Scalar, PRESSURE_UNIT, Positive, "contact pressure at zero overclosure";
    PRESSURE: r"p", Scalar, PRESSURE_UNIT, Real, "contact pressure, positive in compression";
    CLOSING_RATE: r"v", Scalar, Unit::new(1, 0, -1), Real, "rate of the overclosure, positive while the surfaces approach";
    MU0: r"\mu_0", Scalar, Unit::new(-3, 1, 1), NonNegative, "damping coefficient in full contact, pressure per closing rate";
    DAMPING_FRACTION: r"\eta", Scalar, ONE, HalfOpen(0.0, 1.0), "fraction of the clearance up to which the damping coefficient is constant";
}

// What the formulas call: lengths that neither overflow nor underflow, sums of products that lose
// nothing, the closest place of a curve, a product and a sum rounded once. Printed by jointproof;
// free of conditions (CC0-1.0).

// Where an input is not finite or not in its domain: its position from 1 as the only result.
export function refusalOf(inputs, i) {
    for (const [k, { name, length, allowed }] of inputs.entries()) {
        const all = length === 1 ? [i[name]] : i[name];
        if (!all.every((x) => Number.isFinite(x) && allowed.every((holds) => holds(x)))) {
            return { refusal: k + 1 };
        }
    }
    return undefined;
}

// Why inputs are refused: the name and the position from 1 of the first that is not finite or not
// in its domain; or what they must be together, by a position behind all inputs.
export function refused({ inputs, required, value, step = value }, i) {
    const { refusal } = step(i);
    if (!(refusal > 0)) return undefined;
    const name = inputs[refusal - 1]?.name ?? required[refusal - 1 - inputs.length];
    return { name, position: refusal };
}

// The square root of a sum of squares that is rescaled where it would leave the range of doubles.
function norm(all) {
    let sum = 0;
    for (const x of all) sum += x * x;
    if (sum > 2 ** -900 && sum < 2 ** 1000) return Math.sqrt(sum);
    const factor = all.some((x) => Math.abs(x) > 1) ? 2 ** -600 : 2 ** 600;
    sum = 0;
    for (const x of all) sum += (x * factor) * (x * factor);
    return Math.sqrt(sum) / factor;
}

export const norm2 = (x, y) => norm([x, y]);
export const norm3 = (x, y, z) => norm([x, y, z]);
export const norm4 = (x, y, z, w) => norm([x, y, z, w]);

const arcTangent = [
    -0.3333333333333333, 0.19999999999999804, -0.1428571428565978,
    0.11111111105150588, -0.09090908753259112, 0.07692296368042296,
    -0.0666642476020052, 0.05878927554473807, -0.05230443640686948,
    0.045515447340221615, -0.03456931506332609, 0.016284375050043393,
];

// z P(z), in parts that do not wait for each other.
function beyond(p, z) {
    const z2 = z * z;
    const z4 = z2 * z2;
    const four = (k) => (p[k] + p[k + 1] * z) + (p[k + 2] + p[k + 3] * z) * z2;
    return z * ((four(0) + four(4) * z4) + four(8) * (z4 * z4));
}

// The angle of (x, y): beside the nearest sixteenth of a turn the arc tangent is a polynomial.
export function angle(y, x) {
    const across = Math.abs(y);
    const along = Math.abs(x);
    const large = across > along ? across : along;
    const small = along < across ? along : across;
    if (!(large > 0 && large < 1e300)) return Math.atan2(y, x);
    const steep = across > along ? 1 : 0;
    const back = x < 0 ? 1 : 0;
    const wide = small > 0.41421356237309503 * large ? 1 : 0;
    const t = (small - large * wide) / (large + small * wide);
    const rest = t * beyond(arcTangent, t * t);
    const way = (1 - 2 * steep) * (1 - 2 * back);
    const eighths = (2 * steep + (4 * back) * (1 - steep)) + way * wide;
    const low = (way * eighths) * 3.061616997868383e-17;
    const turn = eighths * 0.7853981633974483 + way * (t + (rest + low));
    return y < 0 || Object.is(y, -0) ? -turn : turn;
}

const arcSine = [
    0.16666666666665653, 0.0750000000029469, 0.04464285685604654,
    0.030381958187905646, 0.022371777525770062, 0.017359447897278054,
    0.013887491270956195, 0.012155871500411723, 0.006580488107098665,
    0.01939632260033307, -0.016032766254421116, 0.03179011988382487,
];

// The arc sine: up to 1/2 a polynomial, beyond what twice another one leaves of a quarter turn.
export function asin(x) {
    const size = Math.abs(x);
    const missing = (1 - size) * 0.5;
    const wide = size > 0.5;
    const z = wide ? missing : size * size;
    const s = wide ? Math.sqrt(missing) : size;
    const [turn, low, way] = wide ? [1.5707963267948966, 3.061616997868383e-17, -2] : [0, 0, 1];
    const rest = s * beyond(arcSine, z) - low;
    const sum = turn + way * s;
    const lost = (turn - sum) + way * s;
    const angle = sum + (lost + way * rest);
    return x < 0 || Object.is(x, -0) ? -angle : angle;
}

const bits = new DataView(new ArrayBuffer(8));

const exponential = [
    0.5, 0.16666666666666666, 0.04166666666666667, 0.008333333333333333,
    0.0013888888888883748, 0.00019841269841266415, 2.4801587325547743e-05,
    2.7557319239957097e-06, 2.75572736431103e-07, 2.5052078002329456e-08,
    2.0914686968086876e-09, 1.6084327883952603e-10,
];

// e^x - 1: with x = k ln 2 + r it is 2^k (e^r - 1) + (2^k - 1), and e^r - 1 is r and a polynomial.
export function expm1(x) {
    if (!(Math.abs(x) > 1e-300 && Math.abs(x) < 700)) return Math.expm1(x);
    const shifted = x * 1.4426950408889634 + 6755399441055744;
    const k = shifted - 6755399441055744;
    const above = x - k * 0.6931471803691238;
    const below = k * 1.9082149292705877e-10;
    const r = above - below;
    bits.setUint32(0, (k + 1023) << 20);
    bits.setUint32(4, 0);
    const power = bits.getFloat64(0);
    const more = power * r;
    const most = power - 1;
    const sum = most + more;
    const lost = power * ((above - r) - below) + ((most - sum) + more);
    return sum + (more * beyond(exponential, r) + lost);
}

// The nearest integer; of two that are equally near, the one farther from 0.
export function nearestInteger(x) {
    const whole = Math.trunc(x);
    return Math.abs(x - whole) < 0.5 ? whole : whole + Math.sign(x);
}

// The largest power of two that is not above a positive number, within 2^-1022 and 2^1022.
export function powerOfTwo(x) {
    bits.setFloat64(0, x);
    const exponent = bits.getUint32(0) & 0x7ff00000;
    bits.setUint32(0, Math.min(exponent, 0x7fd00000));
    bits.setUint32(4, 0);
    return bits.getFloat64(0);
}

function sum(a, b) {
    const high = a + b;
    const part = high - a;
    return [high, a - (high - part) + (b - part)];
}

function halves(x) {
    const large = x * 134217728 + x;
    const high = large - (large - x);
    return [high, x - high];
}

function product(a, b) {
    const high = a * b;
    const [[a1, a2], [b1, b2]] = [halves(a), halves(b)];
    return [high, a2 * b2 - (high - a1 * b1 - a2 * b1 - a1 * b2)];
}

// An exact sum, kept as parts that do not overlap, smaller ones first, none of them 0 (Shewchuk).
function add(parts, x) {
    if (x === 0) return;
    let kept = 0;
    let carried = x;
    for (let k = 0; k < parts.length; ++k) {
        const [high, low] = sum(carried, parts[k]);
        carried = high;
        if (low !== 0) parts[kept++] = low;
    }
    parts.length = kept;
    if (carried !== 0) parts.push(carried);
}

function addProduct(parts, a, b) {
    if (a === 0 || b === 0) return;
    const [high, low] = product(a, b);
    add(parts, low);
    add(parts, high);
}

// A sum of products of four numbers each: nothing is rounded but the sum in the end.
export function exactSum(products) {
    const parts = [];
    for (const [a, b, c, d] of products) {
        const two = [];
        const three = [];
        addProduct(two, a, b);
        for (const part of two) addProduct(three, part, c);
        for (const part of three) addProduct(parts, part, d);
    }
    return parts.reduce((total, part) => total + part, 0);
}

// A polynomial, its constant term first, and its slope: Horner's scheme.
function polynomial(p, u) {
    let [value, slope] = [0, 0];
    for (let k = p.length - 1; k >= 0; --k) [value, slope] = [value * u + p[k], slope * u + value];
    return [value, slope];
}

function trimmed(p) {
    let n = p.length;
    while (n > 0 && p[n - 1] === 0) --n;
    return p.slice(0, n);
}

// The place between two others where a polynomial without an extremum there changes sign: by
// Newton's method where that halves the step, else by halving the interval.
function crossing(p, from, to, low, high) {
    if (high === 0) return to;
    const middle = () => from + (to - from) * 0.5;
    let u = middle();
    let step = to - from;
    let lookedForShort = false;
    for (let k = 0; k < 1200; ++k) {
        const [value, slope] = polynomial(p, u);
        if (value === 0) return u;
        if (value > 0 === low > 0) from = u;
        else to = u;
        const newton = u - value / slope;
        const halves = Math.abs(newton - u) <= Math.abs(step) * 0.5;
        const next = from < newton && newton < to && halves ? newton : middle();
        step = next - u;
        if (step === 0 || next === from || next === to) return next;
        u = next;
        if (!lookedForShort && Math.abs(step) < 2 ** -40) {
            lookedForShort = true;
            const short = (Math.sign(u) * Math.round(Math.abs(u) * 2 ** 20)) / 2 ** 20;
            if (polynomial(p, short)[0] === 0) return short;
        }
    }
    return u;
}

// The places between two others where a polynomial falls through zero, or changes sign either
// way; those of its derivative part them. Its values at the two are given.
function crossings(all, ends, values, falls) {
    const p = trimmed(all);
    let inner = [];
    if (p.length > 2) {
        const rate = trimmed(p.slice(1).map((c, k) => c * (k + 1)));
        const rates = ends.map((u) => polynomial(rate, u)[0]);
        inner = crossings(rate, ends, rates, false);
    }
    const places = [];
    let [from, low] = [ends[0], values[0]];
    for (let k = 0; k <= inner.length; ++k) {
        const isLast = k === inner.length;
        const to = isLast ? ends[1] : inner[k];
        const high = isLast ? values[1] : polynomial(p, to)[0];
        const sinks = low > 0 && (isLast ? high < 0 : high <= 0);
        if (falls ? sinks : low < 0 !== high < 0) places.push(crossing(p, from, to, low, high));
        [from, low] = [to, high];
    }
    return places;
}

// The closest place of a curve X(0) + c Y(u) between two coordinates, given the gap xs - X(0) and
// the residuals (xs - X).Y' at the two, by which either one of them counts or a root between them
// is found. A number before the first coordinate stands for that end, one behind the last for the
// other.
export function nearestPlace(gx, gy, factor, x1, y1, x2, y2, x3, y3, from, to, low, high) {
    const p = [
        gx * x1 + gy * y1,
        (gx * x2 + gy * y2) * 2 - factor * (x1 * x1 + y1 * y1),
        (gx * x3 + gy * y3 - factor * (x1 * x2 + y1 * y2)) * 3,
        -(factor * ((x1 * x3 + y1 * y3) * 2 + (x2 * x2 + y2 * y2)) * 2),
        -(factor * (x2 * x3 + y2 * y3) * 5),
        -(factor * (x3 * x3 + y3 * y3) * 3),
    ];
    const places = [];
    if (low <= 0) places.push({ u: from, end: from - 1 });
    for (const u of crossings(p, [from, to], [low, high], true)) places.push({ u });
    if (high >= 0 || places.length === 0) {
        places.push({ u: to, end: to === from ? from - 1 : to + 1 });
    }
    const reach = (a, b, c, u) => ((c * u + b) * u + a) * u * factor;
    let best = places[0];
    for (const place of places.slice(1)) {
        // |G_u|^2 - |G_v|^2 = (G_u - G_v).(G_u + G_v), against what rounding does to it.
        const [ux, uy] = [reach(x1, x2, x3, place.u), reach(y1, y2, y3, place.u)];
        const [vx, vy] = [reach(x1, x2, x3, best.u), reach(y1, y2, y3, best.u)];
        const [stepX, stepY, twiceX, twiceY] = [vx - ux, vy - uy, gx * 2, gy * 2];
        const excess = stepX * (twiceX - (ux + vx)) + stepY * (twiceY - (uy + vy));
        const sizeX = Math.abs(twiceX) + Math.abs(ux) + Math.abs(vx);
        const sizeY = Math.abs(twiceY) + Math.abs(uy) + Math.abs(vy);
        const blur = (Math.abs(stepX) * sizeX + Math.abs(stepY) * sizeY) * 2 ** -48;
        if (excess < -blur) best = place;
    }
    return best.end ?? best.u;
}

// The exact value of a finite double as an integer times 2^-1074.
function whole(x) {
    bits.setFloat64(0, x);
    const word = bits.getBigUint64(0);
    const exponent = (word >> 52n) & 0x7ffn;
    const fraction = word & 0xfffffffffffffn;
    const size = exponent === 0n ? fraction : (fraction | 0x10000000000000n) << (exponent - 1n);
    return word >> 63n === 1n ? -size : size;
}

// x y + z, rounded once, by whole numbers.
export function multiplyAdd(x, y, z) {
    if (!Number.isFinite(x * y + z)) return x * y + z;
    const exact = whole(x) * whole(y) + (whole(z) << 1074n);
    if (exact === 0n) return x * y + z;
    const size = exact < 0n ? -exact : exact;
    // In units of 2^-2148; 53 digits are kept, or as many as there are above 2^-1074.
    const length = BigInt(size.toString(2).length);
    const drop = length - 53n > 1074n ? length - 53n : 1074n;
    const half = 1n << (drop - 1n);
    let kept = size >> drop;
    const rest = size - (kept << drop);
    if (rest > half || (rest === half && (kept & 1n) === 1n)) kept += 1n;
    const rounded = Number(kept) * 2 ** Number(drop - 2148n);
    return exact < 0n ? -rounded : rounded;
}

// What the formulas call: lengths that neither overflow nor underflow, sums of products that lose nothing, a product and
// a sum rounded once. Printed by jointproof; free of conditions (CC0-1.0).

// The first input that is not finite or not in its domain: its name, and its position from 1.
export function refused({ inputs }, i) {
    for (const [k, { name, length, allowed }] of inputs.entries()) {
        const all = length === 1 ? [i[name]] : i[name];
        if (!all.every((x) => Number.isFinite(x) && allowed.every((holds) => holds(x)))) {
            return { name, position: k + 1 };
        }
    }
    return undefined;
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

const bits = new DataView(new ArrayBuffer(8));

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

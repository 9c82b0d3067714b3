// Numbers as people and programs write them.

// A decimal number, with e, d or q before its exponent, or a hexadecimal one as C prints it; undefined where it is none.
function parse(text) {
    const plain = text.trim().replaceAll('−', '-').toLowerCase();
    const word = /^([-+]?)(nan|inf|infinity)$/.exec(plain);
    if (word) return word[2] === 'nan' ? NaN : Number(`${word[1]}Infinity`);
    const hex = /^([-+]?)0x([0-9a-f]*)\.?([0-9a-f]*)(?:p([-+]?\d+))?$/.exec(plain);
    if (hex && hex[2] + hex[3]) return scaled(hex[1], hex[2] + hex[3], Number(hex[4] ?? 0) - 4 * hex[3].length);
    return /^[-+]?(\d+\.?\d*|\.\d+)([edq][-+]?\d+)?$/.test(plain) ? Number(plain.replace(/[dq]/, 'e')) : undefined;
}

// Whole hexadecimal digits times a power of two, which is taken in two steps lest it leaves the range alone.
function scaled(sign, digits, exponent) {
    const half = Math.trunc(exponent / 2);
    const size = Number(BigInt(`0x${digits}`)) * 2 ** half * 2 ** (exponent - half);
    return sign === '-' ? -size : size;
}

// The shortest digits that read back as the same number.
function show(x) {
    return Object.is(x, -0) ? '-0' : String(x);
}

// As Rust writes it in messages: 1.0, 1e-7, inf.
function asRust(x) {
    if (!Number.isFinite(x)) return String(x).replace('Infinity', 'inf');
    const size = Math.abs(x);
    if (size !== 0 && (size < 1e-4 || size >= 1e16)) return x.toExponential().replace('e+', 'e');
    return show(x) + (Number.isInteger(x) ? '.0' : '');
}

// In a few digits, for axes and sentences.
function short(x, digits = 4) {
    const rounded = Number(x.toPrecision(digits));
    const size = Math.abs(rounded);
    const text = size !== 0 && (size < 1e-3 || size >= 1e6) ? rounded.toExponential() : String(rounded);
    return text.replace('e+', 'e').replaceAll('-', '−');
}

// How many digits a text gives: of 0.0123 three.
function digitsOf(text) {
    if (/0x/i.test(text)) return 17;
    const digits = text.toLowerCase().replace(/[edq].*/, '').replace(/[^0-9]/g, '');
    return Math.max(1, digits.replace(/^0+/, '').length);
}

// How many leading digits of a number agree with those that a text gives: all, where it is the number rounded or cut.
function agreeing(x, text) {
    const given = parse(text);
    const digits = Math.min(17, digitsOf(text));
    if (given === x) return digits;
    if (!Number.isFinite(given) || given === 0 || x === 0) return 0;
    const unit = 10 ** (Math.floor(Math.log10(Math.abs(given))) - digits + 1);
    const off = Math.abs(given - x);
    const isCut = digits > 2 && Math.sign(x) * (x - given) > 0 && off < unit;
    if (off <= 0.5000001 * unit || isCut) return digits;
    for (let k = digits - 1; k > 0; --k) {
        if (x.toPrecision(k) === given.toPrecision(k)) return k;
    }
    return 0;
}

// Where the first digits of a shown number end in its text.
function endOfDigits(text, count) {
    let seen = 0;
    for (const [at, c] of [...text].entries()) {
        if (c === 'e') return at;
        if (/[0-9]/.test(c) && (seen > 0 || c !== '0')) ++seen;
        if (seen === count) return at + 1;
    }
    return text.length;
}

// Calls of the exported function with the numbers of a calculator, in the words of several languages.

const COPIES = {
    C: (call) => {
        const name = unlike(call, ['double', 'int', 'k', 'jacobian', 'const']);
        const inputs = call.inputs.map((field) => (field.length === 1 ? real(field.x[0]) : `(const double[]){${list(field.x)}}`));
        const outputs = call.outputs.map((field) => (field.length === 1 ? `&${name(field)}` : name(field)));
        const declared = call.outputs.map((field) => (field.length === 1 ? name(field) : `${name(field)}[${field.length}]`));
        if (call.entries > 0) {
            declared.push(`jacobian[${call.entries}]`);
            outputs.push('jacobian');
        }
        return `double ${declared.join(', ')};\n`
            + `int code = jp_${call.stem}_${largest(call)}(\n    ${[...inputs, ...outputs].join(',\n    ')});\n`;
    },
    Fortran: (call) => {
        const name = unlike(call, ['code', 'dp', 'jacobian', 'real', 'result', 'huge', 'abs']);
        const number = (x) => `${real(x).replace('e', 'e')}_dp`;
        const inputs = call.inputs.map(({ x, length }) =>
            (length === 1 ? number(x[0]) : `[ &\n        ${x.map(number).join(', &\n        ')}]`));
        const declared = call.outputs.map((field) => (field.length === 1 ? name(field) : `${name(field)}(${field.length})`));
        const outputs = call.outputs.map(name);
        if (call.entries > 0) {
            const rows = call.outputs.reduce((sum, { length }) => sum + length, 0);
            declared.push(`jacobian(${rows}, ${call.entries / rows})`);
            outputs.push('jacobian');
        }
        return `integer, parameter :: dp = kind(1.0d0)\ninteger :: code\n`
            + `${declared.map((one) => `real(dp) :: ${one}\n`).join('')}`
            + `code = jp_${call.stem}_${largest(call)}( &\n    ${[...inputs, ...outputs].join(', &\n    ')})\n`;
    },
    Rust: (call) => {
        const line = ({ name, x }) => `    ${x.map(asRust).join(', ')}, // ${name}\n`;
        return `let formula = jointproof::catalog::find("${call.id}").expect("it is in the catalog");\n`
            + `let (value, jacobian) = formula.value_and_jacobian(&[\n${call.inputs.map(line).join('')}])?;\n`;
    },
    JSON: (call) => `${point(call)}\n`,
    '--point': (call) => `cargo xtask audit --filter ${call.id} --point '${point(call)}'\n`,
};

// The exported function that gives most: there is one for the Jacobian where it is in closed form.
const largest = (call) => (call.entries > 0 ? 'jacobian' : 'value');

// A decimal that every language takes for a real number.
function real(x) {
    const text = show(x).replace('e+', 'e');
    return /[.e]/.test(text) ? text : `${text}.0`;
}

function list(numbers) {
    return numbers.map(real).join(', ');
}

// Names as the printers of the export write them.
function unlike(call, reserved) {
    return ({ name }) => (reserved.includes(name) ? `${name}_` : name);
}

// Inputs by name, matrices row by row, as golden files have them.
function point(call) {
    const rows = (x) => (x.length === 9 ? `[${[0, 3, 6].map((k) => `[${list(x.slice(k, k + 3))}]`).join(', ')}]` : `[${list(x)}]`);
    return `{${call.inputs.map(({ name, x, length }) => `"${name}": ${length === 1 ? real(x[0]) : rows(x)}`).join(', ')}}`;
}

// The calculator of one entry.

// An element with attributes and children; a class, a function for an event, and plain attributes are told by their names.
function element(make, name, attributes = {}, ...children) {
    const made = make(name);
    for (const [key, value] of Object.entries(attributes)) {
        if (typeof value === 'function') made.addEventListener(key, value);
        else if (value !== undefined) made.setAttribute(key, value);
    }
    made.append(...children);
    return made;
}

const html = (...parts) => element((name) => document.createElement(name), ...parts);
const svg = (...parts) => element((name) => document.createElementNS('http://www.w3.org/2000/svg', name), ...parts);

class Panel {
    constructor(box, formula, runtime, { cases, kinks }) {
        Object.assign(this, { box, formula, runtime, cases, kinks, id: box.dataset.formula });
        const rows = box.closest('.entry').querySelectorAll('.symbols tbody tr:not(.group)');
        const described = [...formula.inputs, ...formula.outputs].map((field, k) => {
            const { shape, unit, allowed } = rows[k].dataset;
            return { ...field, shape, unit, allowed, symbol: rows[k].cells[0] };
        });
        this.inputs = described.slice(0, formula.inputs.length);
        this.outputs = described.slice(formula.inputs.length);
        this.names = components(this.inputs);
        this.results = components(this.outputs);
        box.append(this.form());
        this.choose(0);
    }

    // Everything that is shown, in the order of the keyboard.
    form() {
        this.message = html('p', { class: 'refusal', role: 'status' });
        this.comment = html('p', { class: 'comment' });
        this.agreement = html('p', { class: 'agreement', role: 'status' });
        this.given = html('input', { type: 'text', placeholder: '0.3834462', input: () => this.compare(), ...PLAIN });
        const form = html('form', { class: 'panel', submit: (event) => event.preventDefault() },
            labelled('Start from', this.menu()), this.comment,
            this.table(), this.message,
            this.answers(), labelled('My program prints', this.given), this.agreement,
            this.plot(), this.copies());
        // Keys that turn the pages of the book belong to the field here.
        form.addEventListener('keydown', (event) => event.stopPropagation());
        return form;
    }

    menu() {
        const groups = new Map();
        this.cases.forEach(([name, flag], k) => {
            if (!groups.has(flag)) groups.set(flag, html('optgroup', { label: flag }));
            groups.get(flag).append(html('option', { value: k }, name));
        });
        this.select = html('select', { class: 'cases', change: () => this.choose(Number(this.select.value)) });
        this.select.append(...groups.values());
        return this.select;
    }

    // A row a field, a box a component.
    table() {
        this.boxes = [];
        const rows = this.inputs.map((field) => {
            const boxes = components([field]).map((name) => {
                const attributes = { type: 'text', 'aria-label': `${name}, unit ${field.unit}`, ...PLAIN };
                return html('input', { ...attributes, input: () => this.update() });
            });
            this.boxes.push(...boxes);
            const allowed = field.allowed === 'a finite number' ? '' : field.allowed;
            return html('div', { class: 'row' },
                html('span', { class: 'symbol' }, ...copied(field.symbol), ' ', html('code', {}, field.name)),
                html('span', { class: `boxes of-${field.length}` }, ...boxes),
                html('span', { class: 'unit' }, field.unit), html('span', { class: 'allowed' }, allowed));
        });
        return html('div', { class: 'inputs', role: 'group', 'aria-label': 'Inputs' }, ...rows);
    }

    // Every output as a block, a matrix by its rows; then the Jacobian, a block for each output and input.
    answers() {
        const [m, n] = [this.results.length, this.names.length];
        const shown = html('div', { class: 'answers' });
        const blocks = (label) => shown.appendChild(html('div', { class: 'blocks', role: 'group', 'aria-label': label }));
        const outputs = blocks('Outputs');
        const jacobian = this.formula.isClosed ? blocks('Jacobian') : undefined;
        let row = 0;
        for (const output of this.outputs) {
            const width = output.shape.startsWith('mat') ? Math.sqrt(output.length) : output.length;
            const first = row;
            const at = (i, j) => first + i * width + j;
            const name = [...copied(output.symbol), ' ', html('code', {}, output.name), ' ', html('span', { class: 'unit' }, output.unit)];
            outputs.append(block(name, output.length / width, width, at, (k) => this.name(k)));
            let column = 0;
            for (const input of jacobian ? this.inputs : []) {
                const start = m + first * n + column;
                const name = ['∂', html('code', {}, output.name), ' / ∂', html('code', {}, input.name)];
                jacobian.append(block(name, output.length, input.length, (i, j) => start + i * n + j, (k) => this.name(k)));
                column += input.length;
            }
            row += output.length;
        }
        this.cells = [...shown.querySelectorAll('[data-at]')].sort((a, b) => a.dataset.at - b.dataset.at);
        return shown;
    }

    plot() {
        const options = (names) => names.map((name, k) => html('option', { value: k }, name));
        const redraw = () => this.draw();
        this.output = html('select', { change: redraw }, ...options(this.results));
        const along = [...this.names, ...this.kinks.map((_, k) => `across kink ${k + 1}`)];
        this.along = html('select', { change: () => this.bend() }, ...options(along));
        this.reach = html('input', { type: 'text', placeholder: 'auto', input: redraw, ...PLAIN });
        this.figure = html('figure', {});
        this.plotted = html('details', { toggle: redraw }, html('summary', {}, 'Plot'),
            html('div', { class: 'choices' }, labelled('of', this.output), labelled('along', this.along), labelled('±', this.reach)),
            this.figure);
        addEventListener('resize', redraw);
        return this.plotted;
    }

    copies() {
        this.copied = html('pre', { tabindex: 0, hidden: '', 'aria-label': 'Copied' });
        this.told = html('span', { role: 'status' });
        const buttons = Object.keys(COPIES).map((name) => html('button', { type: 'button', click: () => this.copy(name) }, name));
        return html('div', { class: 'copies' }, html('span', {}, 'Copy as '), ...buttons, this.told, this.copied);
    }

    // The inputs of a golden case; each is told by what differs from the one before.
    choose(chosen) {
        const point = [];
        for (const [, , , changes] of this.cases.slice(0, chosen + 1)) Object.assign(point, changes);
        this.boxes.forEach((box, k) => (box.value = show(point[k] ?? 0)));
        this.select.value = chosen;
        this.comment.textContent = this.cases[chosen]?.[2] ?? '';
        this.update(true);
    }

    // Value and Jacobian at components in order, or why they are refused, in the words of Rust.
    evaluate(x) {
        const i = {};
        let at = 0;
        for (const { name, length } of this.inputs) {
            i[name] = length === 1 ? x[at] : x.slice(at, at + length);
            at += length;
        }
        const refused = this.runtime.refused(this.formula, i);
        if (refused?.position > this.inputs.length) return { refusal: `Refused; required is ${refused.name}` };
        if (refused) return this.refusal(refused.position - 1, i);
        // An automatic Jacobian is not computed here.
        const { value, jacobian = [] } = this.formula.value(i);
        const [m, n] = [this.results.length, this.names.length];
        const field = (k) => this.results[k].replace(/\[.*/, '');
        const output = value.findIndex((y) => !Number.isFinite(y));
        if (output >= 0) {
            const allowed = 'results below 1.8e308 (use units in which the inputs are closer to 1)';
            return { refusal: `${field(output)} is too large for a double; allowed are ${allowed}` };
        }
        const entry = jacobian.findIndex((y) => !Number.isFinite(y));
        if (entry >= 0 && entry < m * n) {
            const name = field(Math.floor(entry / n));
            return { refusal: `a derivative of ${name} is too large for a double; use units in which the inputs are closer to 1` };
        }
        return { value, jacobian };
    }

    refusal(position, i) {
        const { name, length, allowed } = this.formula.inputs[position];
        const all = [i[name]].flat();
        const bad = all.findIndex((x) => !(Number.isFinite(x) && allowed.every((holds) => holds(x))));
        const called = length === 1 ? name : `${name}[${bad}]`;
        return { refusal: `${called} is ${asRust(all[bad])}; allowed is ${this.inputs[position].allowed}`, at: called };
    }

    update(isCase = false) {
        if (!isCase) this.comment.textContent = '';
        this.point = this.boxes.map((box) => parse(box.value));
        const unread = this.point.indexOf(undefined);
        const found = unread < 0 ? this.evaluate(this.point) : this.unread(unread);
        this.message.textContent = found.refusal ?? '';
        this.boxes.forEach((box, k) => box.setAttribute('aria-invalid', String(this.names[k] === found.at)));
        this.found = found.refusal ? undefined : [...found.value, ...found.jacobian];
        this.cells.forEach((cell, k) => (cell.textContent = this.found ? show(this.found[k]) : ''));
        this.compare();
        this.draw();
        if (this.copied) this.copied.hidden = true;
    }

    unread(k) {
        return { refusal: `${this.names[k]} is ${JSON.stringify(this.boxes[k].value)}; allowed is a number`, at: this.names[k] };
    }

    // Marks the digits that agree with those of another program, in the cell that each of its numbers comes nearest.
    compare() {
        this.cells.forEach((cell, k) => (cell.textContent = this.found ? show(this.found[k]) : ''));
        const texts = this.given.value.split(/[\s,;()[\]{}]+/).filter((text) => text && parse(text) !== undefined);
        if (!this.found) return;
        this.agreement.replaceChildren(...texts.slice(0, 12).map((text) => html('span', {}, this.judge(text))));
    }

    judge(text) {
        const given = parse(text);
        const off = (x) => Math.abs(given - x) / (Math.abs(x) || 1);
        const better = (a, b) => b.digits - a.digits || off(a.x) - off(b.x);
        const [best] = this.found.map((x, k) => ({ k, x, digits: agreeing(x, text) })).sort(better);
        const [opposite] = this.found.map((x, k) => ({ k, x: -x, digits: agreeing(-x, text) })).sort(better);
        if (opposite.digits > Math.max(best.digits, 2)) {
            return `${text}: ${opposite.digits} digits agree with ${this.name(opposite.k)}, but not the sign. `;
        }
        if (best.digits < Math.min(2, digitsOf(text))) return `${text}: nothing here begins like this. `;
        const shown = show(best.x);
        const end = endOfDigits(shown, best.digits);
        this.cells[best.k].replaceChildren(html('mark', {}, shown.slice(0, end)), shown.slice(end));
        const all = digitsOf(text) <= best.digits ? 'all ' : '';
        const rest = all ? '' : `; relative difference ${short(off(best.x), 2)}`;
        return `${text}: ${all}${best.digits} digit${best.digits === 1 ? ' agrees' : 's agree'} with ${this.name(best.k)}${rest}. `;
    }

    name(k) {
        const [m, n] = [this.results.length, this.names.length];
        return k < m ? this.results[k] : `∂${this.results[Math.floor((k - m) / n)]}/∂${this.names[(k - m) % n]}`;
    }

    // What is plotted: along an input from the point of the fields, or across a kink of the register from a point on it.
    line() {
        const along = Number(this.along.value);
        const output = Number(this.output.value);
        const kink = this.kinks[along - this.names.length];
        if (kink) return { output, kink, from: kink.at, direction: kink.across, center: 0 };
        return { output, from: this.point, direction: this.point.map((_, k) => Number(k === along)), center: this.point[along] };
    }

    // Across a kink, the output that bends most is of interest.
    bend() {
        const kink = this.kinks[Number(this.along.value) - this.names.length];
        const jumps = kink?.sides.map(([below, above]) => Math.abs(above - below));
        if (kink) this.output.value = jumps.indexOf(Math.max(...jumps));
        this.draw();
    }

    draw() {
        if (!this.plotted?.open) return;
        const line = this.line();
        const { kink, output, center } = line;
        if (!kink && !this.found) return this.figure.replaceChildren();
        const size = Math.max(...line.from.map((x, k) => Math.abs(x * line.direction[k])));
        const reach = Math.abs(parse(this.reach.value)) || 1.6 * size || 1;
        const found = sampled(curve(this, line), reach);
        if (!found.points.some(Boolean)) return this.figure.replaceChildren();
        const value = found.points.find((point) => point?.t === 0)?.value;
        const cut = found.jumps.find(({ t }) => Math.abs(t) < 1e-6 * reach);
        const values = cut ? [cut.below.value, cut.above.value] : [value, value];
        const sides = kink ? kink.sides[output].map((slope, k) => ({ t: 0, value: values[k], slope }))
            : this.formula.isClosed ? found.jumps.flatMap(({ below, above }) => [below, above]) : [];
        const input = kink ? 't' : this.names[Number(this.along.value)];
        const tangents = sides.filter((one) => one.value !== undefined && Math.abs(one.slope) < UNBOUNDED);
        const names = { output: this.results[output], input, axis: kink ? 'step t across the kink' : input };
        const width = Math.min(600, this.figure.clientWidth || 300);
        const drawn = drawing(found, { names, center, reach, width, tangents, hasSlope: this.formula.isClosed });
        this.figure.replaceChildren(drawn, html('figcaption', {}, ...this.caption(line, found.jumps, reach)));
    }

    caption({ kink, output, center }, jumps, reach) {
        if (kink) {
            const registered = this.box.closest('.entry').querySelectorAll('.kinks > li')[this.kinks.indexOf(kink)];
            const [below, above] = kink.sides[output].map((x) => (Math.abs(x) < UNBOUNDED ? short(x) : 'without bound'));
            return [`Slope of ${this.results[output]} ${below} before and ${above} behind the kink: `, ...copied(registered)];
        }
        if (!this.formula.isClosed) return [];
        return jumps.slice(0, 4).map(({ t, below, above }) =>
            `At ${short(Math.abs(center + t) < 1e-9 * reach ? 0 : center + t)} the slope jumps from ${short(below.slope)} to ${short(above.slope)}. `);
    }

    async copy(name) {
        if (!this.found) return;
        let at = 0;
        const inputs = this.inputs.map(({ name, length }) => ({ name, length, x: this.point.slice(at, (at += length)) }));
        const entries = this.formula.isClosed ? this.results.length * this.names.length : 0;
        const stem = this.id.replaceAll('.', '_');
        const text = COPIES[name]({ id: this.id, stem, inputs, outputs: this.outputs, entries });
        this.copied.textContent = text;
        this.copied.hidden = false;
        try {
            await navigator.clipboard.writeText(text);
            this.told.textContent = 'copied';
        } catch {
            getSelection().selectAllChildren(this.copied);
            this.told.textContent = 'selected: copy it';
        }
    }
}

// What keeps browsers from correcting numbers.
const PLAIN = { autocomplete: 'off', autocapitalize: 'off', spellcheck: 'false' };

// A difference over a tiny step that is this large has no limit.
const UNBOUNDED = 1e15;

function labelled(text, field) {
    return html('label', {}, html('span', {}, text), field);
}

// `f`, or `f[0]`, `f[1]` of a vector.
function components(fields) {
    return fields.flatMap(({ name, length }) =>
        (length === 1 ? [name] : Array.from({ length }, (_, k) => `${name}[${k}]`)));
}

// Numbers in rows and columns, each with its name for the pointer and for screen readers.
function block(caption, rows, columns, at, name) {
    const cell = (k) => html('td', { class: 'number', 'data-at': k, title: name(k) });
    const line = (i) => html('tr', {}, ...Array.from({ length: columns }, (_, j) => cell(at(i, j))));
    const lines = Array.from({ length: rows }, (_, i) => line(i));
    return html('div', { class: 'table-wrapper', tabindex: 0 }, html('table', {}, html('caption', {}, ...caption), html('tbody', {}, ...lines)));
}

function copied(from) {
    return [...(from?.childNodes ?? [])].map((node) => node.cloneNode(true));
}

// The search of this book, in the place of mdBook's: a symbol is found in any spelling, and a whole name goes before words.

// Greek letters by their names, so that μ, \mu and mu are one.
const GREEK = 'alpha beta gamma delta epsilon zeta eta theta iota kappa lambda mu nu xi omicron pi rho sigma sigma tau upsilon phi chi psi omega'.split(' ');

// Commands of LaTeX that change how a letter looks, and not which it is.
const DRESS = /\\(mathrm|mathbf|mathsf|mathit|mathcal|text|operatorname|boldsymbol|bar|hat|tilde|dot|left|right|lvert|rvert|lVert|rVert)\b ?/g;

const OTHERS = { 'ϕ': 'phi', 'ϑ': 'theta', 'ϵ': 'epsilon', 'ϱ': 'rho', '∂': 'd', '²': '2', '³': '3', '₀': '0', '₁': '1', '₂': '2', '₃': '3', '′': '' };

function spelled(text) {
    const plain = text.replace(/\\var(?=[a-z])/g, '\\').replace(DRESS, '').normalize('NFC').toLowerCase();
    return plain.replace(/[α-ω]/g, (c) => GREEK[c.charCodeAt(0) - 0x3b1]).replace(/[ϕϑϵϱ∂²³₀₁₂₃′]/g, (c) => OTHERS[c]);
}

// One name, however it is written: F_C^{\mathrm{int}}, F_C^int and FCint are fcint.
function whole(text) {
    return spelled(text).replace(/[^\p{L}\p{N}]/gu, '');
}

// A word without the s of a plural.
function word(text) {
    return text.length > 3 && /[^s]s$/.test(text) ? text.slice(0, -1) : text;
}

// Names of formulas and fields are words as well as their parts.
function words(text) {
    return spelled(text).replace(/[_^\\{}]/g, ' ').split(/[^\p{L}\p{N}]+/u).filter(Boolean).map(word);
}

// Words that say nothing of what is asked for.
const EMPTY = new Set('a an and by can do doe for from how i in is it my of on or the to what when where which with'.split(' '));

// Abbreviations of the field, and words for the same thing.
const SAME = { dof: ['degree', 'freedom'], ad: ['automatic', 'differentiation'], bug: ['error'] };

// The words that are asked for; all of them if none says anything.
function asked(text) {
    const all = words(text);
    const telling = all.filter((one) => !EMPTY.has(one));
    return [...new Set((telling.length ? telling : all).flatMap((one) => SAME[one] ?? one))];
}

// So many words of a chapter are its opening.
const OPENING = 50;

class Page {
    constructor([url, title, breadcrumbs, body, names = {}], ref) {
        Object.assign(this, { ref, url, doc: { id: String(ref), title, breadcrumbs, body } });
        const all = (key) => new Set((names[key] ?? []).map(whole));
        this.is = all('is').add(whole(title));
        this.gives = all('gives');
        this.serves = all('serves');
        this.takes = all('takes');
        this.kind = names.kind ?? 'section';
        this.title = words(title).filter((one) => !EMPTY.has(one));
        this.named = new Set(['is', 'gives', 'serves', 'takes', 'has'].flatMap((key) => names[key] ?? []).flatMap(words));
        this.path = new Set(words(breadcrumbs));
        this.opening = words(body).slice(0, OPENING);
        this.chapter = new Set();
        this.body = new Map();
        for (const one of words(body)) this.body.set(one, (this.body.get(one) ?? 0) + 1);
    }

    // How well the page has a word; 0 where it has not.
    has(asked) {
        let best = 0;
        const better = (weight) => (best = Math.max(best, weight));
        if (this.title.includes(asked)) better(40);
        else if (this.title.some((one) => one.startsWith(asked))) better(20);
        if (this.named.has(asked)) better(24);
        if (this.path.has(asked)) better(12);
        const count = this.body.get(asked) ?? 0;
        if (count) better(4 + 6 * (1 - 1 / (1 + Math.log1p(count))) + 60 * count / (this.body.size + 100));
        else if (asked.length > 2) for (const one of this.body.keys()) if (one.startsWith(asked)) better(2);
        return best;
    }

    // How far the page is about a word: wholly if it has it, less if only its chapter opens with it.
    covers(asked, found) {
        if (found) return 1;
        return this.chapter.has(asked) ? 0.7 : 0;
    }
}

class Index {
    constructor({ pages }) {
        this.pages = pages.map((page, k) => new Page(page, k));
        // Where a chapter says what it is about, it says it for its formulas, too.
        const openings = new Map();
        for (const page of this.pages) {
            const chapter = page.url.split('#')[0];
            if (!openings.has(chapter)) openings.set(chapter, new Set(page.opening));
            if (page.kind === 'formula') page.chapter = openings.get(chapter);
        }
        this.givers = new Map();
        for (const { gives } of this.pages) for (const name of gives) this.givers.set(name, (this.givers.get(name) ?? 0) + 1);
    }

    // By a whole name: what is called so; of an output, the only formula that gives it, or else its line among the symbols.
    called(page, name) {
        if (page.is.has(name)) return { formula: 1000, symbol: 900 }[page.kind] ?? 940;
        if (page.gives.has(name)) return this.givers.get(name) === 1 ? 950 : 600;
        if (page.serves.has(name)) return 700;
        return page.takes.has(name) ? 300 : 0;
    }

    search(text) {
        const name = whole(text);
        const wanted = asked(text);
        if (!name) return [];
        const rows = this.pages.map((page) => ({ page, found: wanted.map((one) => page.has(one)) }));
        const rare = wanted.map((_, k) => Math.log1p(this.pages.length / (1 + rows.filter(({ found }) => found[k]).length)));
        const count = (found) => found.filter(Boolean).length;
        // One word may be missing, at a price; more where no page has as many.
        const most = Math.max(...rows.map(({ found }) => count(found)));
        const results = [];
        for (const { page, found } of rows) {
            const called = this.called(page, name);
            if (!called && (count(found) === 0 || count(found) < most - 1)) continue;
            const titled = page.title.filter((one) => wanted.includes(one)).length / Math.max(1, page.title.length);
            const covered = wanted.reduce((sum, one, k) => sum + page.covers(one, found[k]), 0) / Math.max(1, wanted.length);
            const sum = found.reduce((sum, weight, k) => sum + weight * rare[k], 0) / Math.max(1, wanted.length);
            const kind = { formula: 1.25, symbol: 0.6, list: 0.5 }[page.kind] ?? 1;
            const score = called + covered ** 2 * kind * (sum + 40 * titled);
            results.push({ ref: page.ref, score, doc: page.doc });
        }
        return results.sort((a, b) => b.score - a.score);
    }
}

// Pasted and dictated text comes without keys, for which alone mdBook's script listens.
const bar = document.getElementById('mdbook-searchbar');
bar?.addEventListener('input', () => bar.dispatchEvent(new KeyboardEvent('keyup')));

// What mdBook's own script calls.
window.elasticlunr = { Index: { load: (index) => new Index(index) }, stemmer: word };

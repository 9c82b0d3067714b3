// What is looked at in a page; evaluated in it by the check.

// Opens everything that is folded but calculators, which have a check of their own.
function unfold() {
    for (const folded of document.querySelectorAll('details:not(.calculator, [open])')) folded.open = true;
}

// What makes the page wider than the screen.
function wider() {
    const width = document.documentElement.clientWidth;
    // mdBook's page is a box that scrolls, within the document.
    const boxes = [document.scrollingElement, ...document.querySelectorAll('.page-wrapper, .page, .content, main')];
    const over = Math.max(...boxes.map((box) => box.scrollWidth - box.clientWidth));
    if (over <= 0) return [];
    const inBox = (one) => {
        for (let box = one.parentElement; box && !boxes.includes(box) && box !== document.body; box = box.parentElement) {
            if (!['visible', ''].includes(getComputedStyle(box).overflowX)) return true;
        }
        return false;
    };
    const out = [...document.querySelectorAll('main *')].filter((one) => one.getBoundingClientRect().right > width + 1 && !inBox(one));
    const first = out.find((one) => ![...one.children].some((child) => out.includes(child)));
    return [`the page is ${over} pixels wider than the screen: ${first ? first.outerHTML.slice(0, 160) : 'outside of the text'}`];
}

// Displayed equations that are wider than their column.
function cut() {
    const shown = [...document.querySelectorAll('main .math-block')].filter((one) => one.getClientRects().length);
    return shown.flatMap((one) => {
        const column = one.getBoundingClientRect();
        const pieces = [...one.querySelectorAll('math')].map((piece) => piece.getBoundingClientRect());
        const [left, right] = [Math.min(...pieces.map((piece) => piece.left)), Math.max(...pieces.map((piece) => piece.right))];
        if (left >= column.left - 1 && right <= column.right + 1) return [];
        return [`an equation is ${Math.round(right - left)} pixels wide in a column of ${Math.round(column.width)}: ${one.ariaLabel ?? one.textContent.slice(0, 120)}`];
    });
}

// Boxes that scroll to the side and do not show it.
function unmarked() {
    const boxes = [...document.querySelectorAll('main :is(.math-block, .table-wrapper, .plots, pre > code)')];
    const hidden = boxes.filter((box) => box.scrollWidth > box.clientWidth + 1 && !(getComputedStyle(box).overflowX === 'auto' && getComputedStyle(box).backgroundImage.includes('gradient')));
    return hidden.slice(0, 3).map((box) => `nothing shows that more is beside ${box.outerHTML.slice(0, 120)}`);
}

// Labels of drawings that are too small to be read, or that cover each other.
function illegible() {
    const faults = [];
    for (const drawing of document.querySelectorAll('main svg')) {
        const texts = [...drawing.querySelectorAll('text')].filter((text) => text.getClientRects().length && text.textContent.trim());
        const size = (text) => parseFloat(getComputedStyle(text).fontSize) * Math.hypot(text.getScreenCTM().a, text.getScreenCTM().b);
        const small = texts.filter((text) => size(text) < 10.95);
        faults.push(...small.slice(0, 1).map((text) => `the label ${text.textContent} has ${size(text).toFixed(1)} pixels`));
        const boxes = texts.map((text) => text.getBoundingClientRect());
        for (let k = 0; k < texts.length; k++) {
            for (let j = 0; j < k; j++) {
                const across = Math.min(boxes[k].right, boxes[j].right) - Math.max(boxes[k].left, boxes[j].left);
                const down = Math.min(boxes[k].bottom, boxes[j].bottom) - Math.max(boxes[k].top, boxes[j].top);
                // Lines of text have space above and below.
                if (across > 1 && down > 4) faults.push(`the labels ${texts[j].textContent} and ${texts[k].textContent} cover each other in ${drawing.querySelector('title')?.textContent}`);
            }
        }
    }
    return faults;
}

// Columns of tables that say the same words in every row.
function repeated() {
    const faults = [];
    for (const table of document.querySelectorAll('main table:not(.evidence)')) {
        const rows = [...table.querySelectorAll('tbody tr')].filter((row) => row.cells.length > 1);
        if (rows.length < 3) continue;
        [...rows[0].cells].forEach((cell, k) => {
            const text = cell.textContent.trim();
            const isWords = /\p{L}{2,} \p{L}{2,}/u.test(text);
            if (isWords && rows.every((row) => row.cells[k]?.textContent.trim() === text)) faults.push(`a table says "${text}" in each of ${rows.length} rows`);
        });
    }
    return faults;
}

// Code in which two signs are drawn as one.
function joined() {
    const code = [...document.querySelectorAll('main :is(code, pre)')].filter((one) => getComputedStyle(one).fontVariantLigatures !== 'none');
    return code.slice(0, 1).map((one) => `ligatures in ${one.outerHTML.slice(0, 80)}`);
}

// Characters of formulas.
function characters() {
    return [...new Set([...document.querySelectorAll('math')].flatMap(({ textContent }) => [...textContent]))];
}

// What the page has loaded: its scripts and style sheets, and its fonts by family, style and range.
async function loaded() {
    await document.fonts.ready;
    const files = [...document.querySelectorAll('link[rel=stylesheet], script[src]')].filter((one) => one.media !== 'print');
    const fonts = [...document.fonts].filter(({ status }) => status === 'loaded');
    return {
        files: files.map((one) => one.src || one.href),
        fonts: fonts.map(({ family, style, unicodeRange }) => [family.replaceAll('"', ''), style, unicodeRange]),
    };
}

// Serious and critical findings of axe, a line each. A formula counts as one word, else its parts would be
// most of the page.
async function barriers(options) {
    for (const formula of document.querySelectorAll('math')) {
        const text = document.createElementNS(formula.namespaceURI, 'mtext');
        text.textContent = formula.textContent;
        formula.replaceChildren(text);
    }
    const { violations } = await axe.run(document, { resultTypes: ['violations'], preload: false, ...options });
    const grave = violations.filter(({ impact }) => impact === 'serious' || impact === 'critical');
    return grave.map(({ id, impact, nodes }) => `${impact}: ${id}, ${nodes.length} times, first ${nodes[0].target.join(' ')} ${nodes[0].html.slice(0, 160)}`);
}

// The first address that search gives for each query, and how many it gives.
async function found(queries) {
    document.getElementById('mdbook-search-toggle').click();
    const bar = document.getElementById('mdbook-searchbar');
    const ready = () => document.querySelector('#mdbook-search-index') && !document.querySelector('.searchbar-outer.searching');
    for (let left = 500; !ready(); --left) {
        if (left === 0) throw new Error('search does not get ready');
        await new Promise((resolve) => setTimeout(resolve, 10));
    }
    return queries.map((query) => {
        bar.value = query;
        // As if it were pasted, without keys.
        bar.dispatchEvent(new InputEvent('input', { bubbles: true }));
        const links = [...document.querySelectorAll('#mdbook-searchresults a')];
        return links.slice(0, 3).map((link) => link.getAttribute('href').replace(/\?[^#]*/, ''));
    });
}

// What can be reached by the keyboard: every visible control in the page.
function controls() {
    const all = document.querySelectorAll('a[href], button, input, select, summary, [tabindex="0"], label[for]');
    return [...all].filter((one) => one.tabIndex >= 0 && one.checkVisibility({ visibilityProperty: true }) && one.getClientRects().length);
}

// Where the keyboard is: its place among the controls, whether that is to be seen, and whether anything marks it.
let reached = new Set();
function focused() {
    const one = document.activeElement;
    if (!one || one === document.body) return '';
    reached.add(one);
    const style = getComputedStyle(one);
    const marked = style.outlineStyle !== 'none' || style.boxShadow !== 'none';
    return marked ? '' : `nothing marks ${one.outerHTML.slice(0, 120)} when the keyboard is there`;
}
function unreached() {
    return controls().filter((one) => !reached.has(one)).map((one) => `the keyboard does not reach ${one.outerHTML.slice(0, 120)}`);
}

// Whatever still moves for a reader who wants less motion.
function moving() {
    const moves = (one) => {
        const { transitionDuration, animationName, animationDuration } = getComputedStyle(one);
        const lasts = (text) => text.split(',').some((part) => parseFloat(part) > 0.01);
        return lasts(transitionDuration) || (animationName !== 'none' && lasts(animationDuration));
    };
    return [...document.querySelectorAll('body, body *')].filter(moves).slice(0, 3).map((one) => `${one.outerHTML.slice(0, 100)} moves`);
}

// How many bytes a text has when compressed.
async function compressed(text) {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('gzip'));
    return (await new Response(stream).arrayBuffer()).byteLength;
}

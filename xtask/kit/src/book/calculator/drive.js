// Uses a calculator as a reader does: fills its fields, and reads what it shows. Evaluated in the page by the check.

// What a calculator shows at each point, whose components are texts; and where its own menu
// has the case of this name, the fields that it fills, and whether they give the same.
async function drive(id, points, names) {
    const box = document.querySelector(`.calculator[data-formula="${id}"]`);
    box.querySelector('summary').click();
    await until(() => box.querySelector('form'));
    const fields = [...box.querySelectorAll('.inputs input')];
    const menu = box.querySelector('.cases');
    return points.map((texts, k) => {
        texts.forEach((text, at) => {
            if (fields[at].value === text) return;
            fields[at].value = text;
            fields[at].dispatchEvent(new Event('input', { bubbles: true }));
        });
        const shown = read(box);
        const option = [...menu.options].find(({ text }) => text === names[k]);
        if (!option) return { ...shown, chosen: null };
        menu.value = option.value;
        menu.dispatchEvent(new Event('change', { bubbles: true }));
        return { ...shown, chosen: fields.map((field) => field.value), same: JSON.stringify(shown) === JSON.stringify(read(box)) };
    });
}

function read(box) {
    const refusal = box.querySelector('.refusal').textContent;
    const cells = [...box.querySelectorAll('[data-at]')].sort((a, b) => a.dataset.at - b.dataset.at);
    return { refusal, numbers: cells.map((cell) => cell.textContent) };
}

// What is copied for each language, with the numbers of a case.
async function copies(id, name) {
    const box = document.querySelector(`.calculator[data-formula="${id}"]`);
    box.querySelector('summary').click();
    await until(() => box.querySelector('form'));
    const menu = box.querySelector('.cases');
    menu.value = [...menu.options].find(({ text }) => text === name).value;
    menu.dispatchEvent(new Event('change', { bubbles: true }));
    const texts = {};
    for (const button of box.querySelectorAll('.copies button')) {
        button.click();
        texts[button.textContent] = box.querySelector('.copies pre').textContent;
    }
    return texts;
}

async function until(holds) {
    for (let left = 500; !holds(); --left) {
        if (left === 0) throw new Error('the calculator does not open');
        await new Promise((resolve) => setTimeout(resolve, 10));
    }
}

// What is wrong with the page on a phone, with every calculator and every plot open: what sticks out, and fields without a name.
async function faultsOnPhone() {
    for (const plot of document.querySelectorAll('.calculator details:not([open])')) plot.open = true;
    await new Promise((resolve) => setTimeout(resolve, 50));
    const fields = [...document.querySelectorAll('.calculator form :is(input, select, button)')];
    const hasName = (field) => field.labels?.length || field.ariaLabel || (field.matches('button') && field.textContent);
    const nameless = fields.filter((field) => !hasName(field)).map(({ outerHTML }) => `${outerHTML} has no name`);
    // What may be wider scrolls in a box of its own.
    const parts = [...document.querySelectorAll('.calculator form :not(:is(.table-wrapper, pre) *)')];
    // Every number is in view, or to the side in a box that scrolls and says so.
    const hidden = [...document.querySelectorAll('.calculator .answers, .calculator .answers *')].filter((box) => box.scrollHeight > box.clientHeight + 2 && getComputedStyle(box).overflowY !== 'visible');
    nameless.push(...hidden.slice(0, 1).map((box) => `numbers are hidden below in ${box.className}`));
    const end = document.querySelector('main').getBoundingClientRect().right;
    const out = Math.ceil(Math.max(...parts.map((part) => part.getBoundingClientRect().right)) - end);
    return out > 0 ? [`a calculator sticks out by ${out} pixels`, ...nameless] : nameless;
}

// How many bytes a text has when compressed.
async function compressed(text) {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('gzip'));
    return (await new Response(stream).arrayBuffer()).byteLength;
}

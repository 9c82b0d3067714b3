// Uses a calculator as a reader does: fills its fields, and reads what it shows. Evaluated in the page by the check.

// What a calculator shows at each point, whose components are texts; and where its own menu
// has the case of this name, whether that gives the same.
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
        if (!option) return { ...shown, chosen: false, same: true };
        menu.value = option.value;
        menu.dispatchEvent(new Event('change', { bubbles: true }));
        return { ...shown, chosen: true, same: JSON.stringify(shown) === JSON.stringify(read(box)) };
    });
}

function read(box) {
    const refusal = box.querySelector('.refusal').textContent;
    const cells = [...box.querySelectorAll('[data-at]')].sort((a, b) => a.dataset.at - b.dataset.at);
    return { refusal, numbers: cells.map((cell) => cell.textContent) };
}

async function until(holds) {
    for (let left = 500; !holds(); --left) {
        if (left === 0) throw new Error('the calculator does not open');
        await new Promise((resolve) => setTimeout(resolve, 10));
    }
}

// How many bytes a text has when compressed.
async function compressed(text) {
    const stream = new Blob([text]).stream().pipeThrough(new CompressionStream('gzip'));
    return (await new Response(stream).arrayBuffer()).byteLength;
}

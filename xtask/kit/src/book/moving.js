// Moves figures by their sliders. The positions of a figure are loaded when a slider of it is touched first.

const folder = document.currentScript.src.replace(/[^/]*$/, '');
const waiting = new Map();

// Called by the file of positions.
window.jointproofMoving = (name, positions) => waiting.get(name)?.forEach((show) => show(positions));

function start(box) {
    const name = box.dataset.figure;
    const drawing = box.parentElement.querySelector('.drawing');
    const sliders = [...box.querySelectorAll('input')];
    let positions;
    const show = () => {
        if (!positions) return load();
        const at = sliders.map(({ value }) => Number(value));
        const frame = positions.frames[at.reduce((index, value, k) => index * positions.values[k].length + value, 0)];
        const lines = [...positions.lines];
        positions.moved.forEach((line, k) => (lines[line] = frame[k]));
        drawing.innerHTML = lines.join('\n');
        sliders.forEach((slider, k) => {
            const text = positions.values[k][at[k]];
            slider.nextElementSibling.textContent = text;
            slider.setAttribute('aria-valuetext', text);
        });
    };
    const load = () => {
        if (waiting.has(name)) return;
        waiting.set(name, [(found) => { positions = found; show(); }]);
        const script = document.createElement('script');
        script.src = `${folder}${name}.js`;
        document.head.append(script);
    };
    // Keys that turn the pages of the book belong to the slider here.
    box.addEventListener('keydown', (event) => event.stopPropagation());
    for (const slider of sliders) slider.addEventListener('input', show);
    box.hidden = false;
}

document.querySelectorAll('.sliders').forEach(start);

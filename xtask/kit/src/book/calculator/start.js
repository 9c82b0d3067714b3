// Opens calculators: what they are made of is loaded when the first is opened, and a formula when its own is.

const folder = document.currentScript.src.replace(/[^/]*$/, '');
const defined = new Map();
const loading = new Map();

// Called by every script that is loaded.
window.jointproof = { define: (name, make, about) => defined.set(name, { make, about }) };

function load(name) {
    if (!loading.has(name)) {
        loading.set(name, new Promise((resolve, reject) => {
            const script = document.createElement('script');
            Object.assign(script, { src: `${folder}${name}.js`, onload: resolve, onerror: reject });
            document.head.append(script);
        }));
    }
    return loading.get(name);
}

async function open(box) {
    const id = box.dataset.formula;
    try {
        await Promise.all(['runtime', 'panel', id].map(load));
    } catch (event) {
        box.append(`${event.target.src} cannot be loaded.`);
        return;
    }
    const [runtime, Panel] = ['runtime', 'panel'].map((name) => defined.get(name).make());
    const { make, about } = defined.get(id);
    new Panel(box, make(runtime), runtime, about);
}

for (const box of document.querySelectorAll('details.calculator')) {
    box.addEventListener('toggle', () => open(box), { once: true });
}

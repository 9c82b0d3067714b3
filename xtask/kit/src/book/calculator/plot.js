// An output and its slope along one input, or across a kink: two drawings over one axis.

const STEPS = 240;

// What is drawn: value and slope at a step from the point, or nothing where the inputs are refused.
function curve(panel, { output, direction, from }) {
    const n = from.length;
    return (t) => {
        const at = from.map((x, k) => (direction[k] === 0 ? x : x + direction[k] * t));
        const found = panel.evaluate(at);
        if (found.refusal) return undefined;
        const entry = (k) => found.jacobian[output * n + k] ?? 0;
        const slope = direction.reduce((sum, by, k) => (by === 0 ? sum : sum + by * entry(k)), 0);
        const value = found.value[output];
        return Number.isFinite(value) && Number.isFinite(slope) ? { t, value, slope } : undefined;
    };
}

// Points from end to end, with every jump of value or slope between neighbours found by halving until two numbers are left.
function sampled(f, reach) {
    const points = [];
    for (let k = -STEPS / 2; k <= STEPS / 2; ++k) points.push(f((k / STEPS) * 2 * reach));
    const sizes = ['value', 'slope'].map((name) => {
        const all = points.filter(Boolean).map((point) => point[name]);
        return Math.max(...all) - Math.min(...all) || 1;
    });
    const gap = (a, b) =>
        Math.max(Math.abs(a.value - b.value) / sizes[0], Math.abs(a.slope - b.slope) / sizes[1]);
    const jumps = [];
    const all = [];
    for (const [k, point] of points.entries()) {
        const before = points[k - 1];
        if (point && before && gap(before, point) > 0.02) {
            const jump = halved(f, before, point, gap);
            if (jump) {
                jumps.push(jump);
                all.push(jump.below, undefined, jump.above);
            }
        }
        all.push(point);
    }
    return { points: all, jumps: merged(jumps, reach) };
}

// What is just below and above a jump, unless there is none and the function changes fast.
function halved(f, below, above, gap) {
    const [start, end] = [below, above];
    for (let k = 0; k < 60; ++k) {
        const middle = f((below.t + above.t) / 2);
        if (!middle || middle.t === below.t || middle.t === above.t) break;
        if (gap(below, above) < 1e-6) return undefined;
        if (gap(below, middle) >= gap(middle, above)) above = middle;
        else below = middle;
    }
    const width = Math.max((end.t - start.t) * 1e-7, Math.abs(below.t) * 1e-14);
    const [left, right] = [f(Math.max(start.t, below.t - width)), f(Math.min(end.t, above.t + width))];
    return left && right && gap(left, right) > 1e-5 ? { t: below.t, below: left, above: right } : undefined;
}

// A jump at a sample is found from both of its sides.
function merged(jumps, reach) {
    return jumps.reduce((kept, jump) => {
        const last = kept.at(-1);
        if (last && jump.t - last.t < reach * 1e-6) last.above = jump.above;
        else kept.push(jump);
        return kept;
    }, []);
}

// Some three to six round numbers between two.
function ticks(low, high) {
    const rough = (high - low) / 4;
    const power = 10 ** Math.floor(Math.log10(rough));
    const step = [1, 2, 5, 10].map((k) => k * power).find((step) => step >= rough * 0.99);
    const all = [];
    for (let k = Math.ceil(low / step); k * step <= high && all.length < 9; ++k) all.push(Number((k * step).toPrecision(12)));
    return all;
}

// The range of numbers, a little wider; around a constant one as wide as that is large.
function range(numbers) {
    const [low, high] = [Math.min(...numbers), Math.max(...numbers)];
    const room = high > low ? (high - low) * 0.08 : Math.max(Math.abs(high), 1) * 0.5;
    return [low - room, high + room];
}

// The SVG: the value above, the slope below where there is one. `center` is what the axis shows at the point itself.
function drawing(found, { names, center, reach, width, tangents, hasSlope }) {
    const height = 170;
    const left = 62;
    const right = 10;
    const points = found.points.filter(Boolean);
    const x = (t) => left + ((t + reach) / (2 * reach)) * (width - left - right);
    const parts = [];
    const frame = (top, name, values, title) => {
        const [low, high] = range(values);
        const y = (value) => top + height - ((value - low) / (high - low)) * height;
        for (const tick of ticks(low, high)) {
            parts.push(svg('path', { class: 'grid', d: `M${left} ${y(tick).toFixed(1)}H${width - right}` }));
            parts.push(svg('text', { class: 'tick end', x: left - 6, y: y(tick) + 4 }, short(tick)));
        }
        for (const tick of ticks(center - reach, center + reach)) {
            const at = x(tick - center).toFixed(1);
            parts.push(svg('path', { class: 'grid', d: `M${at} ${top}v${height}` }));
            if (top > height || !hasSlope) parts.push(svg('text', { class: 'tick middle', x: at, y: top + height + 16 }, short(tick)));
        }
        parts.push(svg('text', { class: 'name', x: left, y: top - 7 }, title));
        let d = '';
        let isDrawn = false;
        for (const point of found.points) {
            if (point) d += `${isDrawn ? 'L' : 'M'}${x(point.t).toFixed(1)} ${y(point[name]).toFixed(1)}`;
            isDrawn = Boolean(point);
        }
        parts.push(svg('path', { class: 'curve', d }));
        return y;
    };
    const y = frame(22, 'value', points.map((point) => point.value), names.output);
    const clip = [22, 22 + height];
    for (const { t, value, slope } of tangents) parts.push(tangent(x, y, { t, value, slope, reach, clip }));
    const slopeY = hasSlope
        && frame(height + 62, 'slope', points.map((point) => point.slope), `∂${names.output}/∂${names.input}`);
    const here = points.find((point) => point.t === 0);
    if (here) {
        parts.push(svg('circle', { class: 'here', cx: x(0), cy: y(here.value), r: 4 }));
        if (hasSlope) parts.push(svg('circle', { class: 'here', cx: x(0), cy: slopeY(here.slope), r: 4 }));
    }
    const foot = hasSlope ? 2 * height + 98 : height + 58;
    parts.push(svg('text', { class: 'name end', x: width - right, y: foot }, names.axis));
    const label = `${names.output}${hasSlope ? ' and its slope' : ''} over ${names.axis}`;
    return svg('svg', { viewBox: `0 0 ${width} ${foot + 8}`, width, height: foot + 8, role: 'img', 'aria-label': label }, ...parts);
}

// A third of the axis to both sides, shortened where it leaves the drawing.
function tangent(x, y, { t, value, slope, reach, clip }) {
    const end = (sign) => {
        let length = Math.max(0, Math.min(reach / 3, reach - sign * t));
        for (let k = 0; k < 40; ++k) {
            const at = y(value + sign * slope * length);
            if (at >= clip[0] && at <= clip[1]) break;
            length *= 0.85;
        }
        return `${x(t + sign * length).toFixed(1)} ${y(value + sign * slope * length).toFixed(1)}`;
    };
    return svg('path', { class: 'tangent', d: `M${end(-1)}L${end(1)}` });
}

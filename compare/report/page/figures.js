// What stands beside the pictures: figures, histograms, worst pixels, what wrong pixels have in common.
const FIGURES = [['rmse', 'RMSE', 4], ['mae', 'Mean absolute error', 4], ['bias', 'Bias', 4], ['max_abs', 'Largest difference', 1], ['psnr', 'PSNR [dB]', 2],
  ['within_1_pct', 'Within 1 [%]', 4], ['within_2_pct', 'Within 2 [%]', 4], ['ssim_mean', 'SSIM', 5], ['ssim_block_min', 'SSIM, worst 8×8 block', 5],
  ['solid_2_pixels', 'Wrong pixels in patches', 0], ['drift_max', 'Largest mean of 16×16', 4], ['one_sided_pixels', 'Connected, to one side', 0], ['leaning', 'More to one side', 4], ['flip_mean', 'LDR-FLIP', 5], ['hdr_flip_mean', 'HDR-FLIP', 5],
  ['ciede2000_mean', 'CIEDE2000, mean', 3], ['ciede2000_p95', 'CIEDE2000, 95 %', 3], ['edge_rmse', 'RMSE at edges', 4], ['interior_rmse', 'RMSE elsewhere', 4],
  ['alpha_max_abs', 'Alpha, largest difference', 1], ['nan_pixels', 'NaN or infinite pixels', 0]];
function figures(s) {
  const out = [], row = (name, value) => out.push(node('tr', {}, node('th', { scope: 'row' }, name), node('td', {}, value)));
  if (s.metrics) for (const [key, label, digits] of FIGURES) if (s.metrics[key] !== undefined) row(label, key === 'psnr' && s.metrics.psnr >= 999 ? '999' : fixed(s.metrics[key], digits));
  if (s.low_pass) for (const key of ['mad', 'bias', 'rmse']) row(`Blurred ${key}: ours, noise`, `${fixed(s.low_pass.native[key], 3)}, ${fixed(s.low_pass.noise[key], 3)}`);
  if (s.welch) row("Welch's test", `${s.welch.rejected ? 'rejected' : 'passed'}: p ${s.welch.pixel_p.toExponential(1)} (pixels), ${s.welch.mean_p.toExponential(1)} (mean ${fixed(s.welch.mean_difference, 3)})`);
  if (s.fit) row('Fitted', s.fit);
  for (const l of s.layers || []) row(`Layer ${l.name} (${l.kind})`, `${nameOf(l.status)}${l.reason ? `: ${l.reason}` : l.max_abs ? `: largest difference ${Number(l.max_abs.toPrecision(4))}` : ''}`);
  for (const l of s.likeness || []) row(`Verisimilitude: ${l.renderer || data.names.n}`, l.failed || `CIEDE2000 ${fixed(l.ciede2000_mean, 3)}, FLIP ${fixed(l.flip_mean, 4)}, RMSE ${fixed(l.rmse, 3)}`);
  row('Class', s.class); row('Size', `${s.width}×${s.height}${s.reduced > 1 ? `, shown at 1:${s.reduced}` : ''}`);
  if (s.oracle_seconds) row(`${WHO.o} [${s.cpu ? 'CPU s' : 's'}]`, fixed(s.oracle_seconds, 2) + (s.cached ? ' (kept)' : ''));
  if (s.native_seconds) row(`${WHO.n} [${s.cpu ? 'CPU s' : 's'}]`, fixed(s.native_seconds, 2));
  if (ratio(s)) row('Ratio', fixed(ratio(s), 1) + '×');
  for (const h of s.history || []) row(`RMSE of ${h.started.replace('T', ' ').replace('Z', '')}`, `${fixed(h.rmse, 4)} ${nameOf(h.status)}`);
  if (s.switches.length) row('Switches', s.switches.join(' '));
  if (s.features.length) row('Random elements', s.features.join(', '));
  for (const [kind, count] of Object.entries(s.rays)) row(`Rays: ${kind}`, count.toLocaleString('en'));
  $('figures').replaceChildren(...out);
}

const NS = 'http://www.w3.org/2000/svg';
const svgNode = (tag, attributes, text) => { const e = document.createElementNS(NS, tag); for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v); if (text) e.textContent = text; return e; };
// bars: [{ height 0..1, title, label }]
function bars(box, parts, note, label) {
  const svg = svgNode('svg', { viewBox: '0 0 330 130', preserveAspectRatio: 'none' }), w = 330 / parts.length;
  parts.forEach((part, i) => {
    const h = part.height ? Math.max(2, 92 * part.height) : 0, bar = svgNode('rect', { x: i * w + 0.1 * w, y: 100 - h, width: 0.8 * w, height: h });
    bar.append(svgNode('title', {}, part.title)); svg.append(bar);
    if (part.label) svg.append(svgNode('text', i === 0 ? { x: 0, y: 114 } : i === parts.length - 1 ? { x: 330, y: 114, 'text-anchor': 'end' } : { x: i * w + w / 2, y: 114, 'text-anchor': 'middle' }, part.label));
  });
  svg.append(svgNode('line', { x1: 0, x2: 330, y1: 100.5, y2: 100.5 }), svgNode('text', { x: 330, y: 128, 'text-anchor': 'end' }, note));
  box.replaceChildren(svg);
  box.setAttribute('aria-label', label);
}
function histogram(s) {
  const box = $('histogram');
  if (!s.histogram) { box.textContent = 'no figures'; return; }
  const edges = [0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 256], total = s.width * s.height, most = Math.log10(1 + total);
  const parts = edges.slice(0, -1).map((from, i) => {
    const to = edges[i + 1], n = s.histogram.slice(from, to).reduce((a, b) => a + b, 0), name = to - from === 1 ? `${from}` : `${from} to ${to - 1}`;
    return { n, name, height: n ? Math.log10(1 + n) / most : 0, label: i % 2 ? '' : String(from), title: `${n} pixels (${(100 * n / total).toFixed(3)} %) differ by ${name}` };
  });
  bars(box, parts, 'difference in code values; pixels on a logarithmic scale', 'Pixels by their largest difference: ' + parts.filter(p => p.n).map(p => `${p.name}: ${p.n}`).join('; '));
}
// Errors weighted by themselves, as the authors of FLIP show it: how much of the mean each size of error makes.
function flipHistogram(values) {
  const sums = new Array(33).fill(0);
  let total = 0;
  for (const v of values) { sums[Math.min(32, Math.floor(v * 33))] += v; total += v; }
  const top = Math.max(...sums, 1e-9);
  $('flip').hidden = !total;
  bars($('flip-histogram'), sums.map((v, i) => ({ height: v / top, label: i % 8 ? '' : fixed(i / 32, 2), title: `errors of ${fixed(i / 33, 2)} to ${fixed((i + 1) / 33, 2)} make ${(100 * v / Math.max(total, 1e-9)).toFixed(1)} % of the mean` })),
    `FLIP error, weighted; mean ${fixed(total / values.length, 4)}`, 'Part of the mean FLIP error by the size of the error');
}
function worst(s) {
  $('worst').replaceChildren(...(s.worst || []).map(([x, y, error]) => node('li', {}, node('button', { type: 'button', onclick: () => {
    if (eye.mode === 'slider') setMode('all');
    goTo(Math.floor(x / s.reduced), Math.floor(y / s.reduced), 40); canvas.focus({ preventScroll: false });
  } }, `${x}, ${y}: ${error < 10 ? fixed(error, 1) : fixed(error, 0)} apart`))));
  if (!s.worst || !s.worst.length) $('worst').replaceChildren(node('li', { className: 'none' }, s.metrics ? 'No pixel differs.' : 'Nothing was compared.'));
}

// What the wrong pixels have in common, and the objects they lie on.
const cells = (tag, ...texts) => texts.map(text => node(tag, tag === 'th' ? { scope: 'col' } : {}, text));
function blame(s) {
  const b = s.blame;
  $('blame').hidden = !b && !s.blame_failed;
  $('blame-note').textContent = b ? `${b.bad_pixels.toLocaleString('en')} of ${(b.bad_pixels + b.good_pixels).toLocaleString('en')} pixels differ by more than ${b.limit} code values.` : s.blame_failed || '';
  $('common').replaceChildren(); $('objects').replaceChildren();
  if (!b) return;
  const common = b.common.slice(0, 12).map(c => node('tr', {}, node('th', { scope: 'row' }, node('small', {}, c.kind), ' ', c.name), ...cells('td', `${fixed(c.bad_pct, 1)} %`, `${fixed(c.good_pct, 1)} %`, fixed(c.correlation, 2))));
  $('common').replaceChildren(...(common.length ? [node('tr', {}, ...cells('th', 'In common', 'wrong', 'right', 'phi')), ...common] : [node('tr', {}, ...cells('td', 'The wrong pixels have nothing in common that the right ones have not.'))]));
  const objects = b.objects.slice(0, 40).map(o => node('tr', {}, node('th', { scope: 'row' }, node('button', { type: 'button', onclick: () => goTo(Math.floor(o.worst[0] / s.reduced), Math.floor(o.worst[1] / s.reduced), 40) }, o.name)),
    ...cells('td', `${fixed(100 * o.share, 1)} %`, `${fixed(o.pixels_pct, 1)} %`, `${fixed(o.bad_pct, 1)} %`, fixed(o.rmse, 2), (o.bias > 0 ? '+' : '') + fixed(o.bias, 2))));
  $('objects').replaceChildren(node('tr', {}, ...cells('th', 'Object', 'of error', 'of picture', 'wrong', 'RMSE', 'bias')), ...objects);
}
// Both sides against mathematics.
function truth(s) {
  $('truth').hidden = !s.points;
  if (!s.points) return;
  const o = s.truth.oracle, n = s.truth.native, shown = v => v[0] === v[1] && v[1] === v[2] ? v[0].toFixed(5) : v.map(x => x.toFixed(5)).join(' ');
  const off = (v, t) => Math.max(...v.map((x, c) => Math.abs(x - t[c]))).toExponential(1);
  $('formula').textContent = `${s.formula} Largest error: ${WHO.o} ${o.max.toExponential(2)}, ${WHO.n} ${n.max.toExponential(2)}; allowed ${s.tolerance}.`;
  $('points').replaceChildren(node('tr', {}, ...cells('th', 'Pixel', 'true', WHO.o, 'off', WHO.n, 'off')),
    ...s.points.map((p, i) => node('tr', {}, node('th', { scope: 'row' }, `${p.x}, ${p.y}`), ...cells('td', shown(p.value), shown(o.values[i]), off(o.values[i], p.value), shown(n.values[i]), off(n.values[i], p.value)))));
}
// Suspected faults; one whose pixels are known is shown as an overlay.
function suspects(s) {
  $('suspects').replaceChildren(...s.suspects.map((v, k) => {
    const sure = v.sure ? `, ${(100 * v.sure).toFixed(0)} % sure` : '', text = [node('b', {}, v.what), `: ${v.detail} (explains ${(100 * v.explained).toFixed(0)} %${sure}) `];
    if (!v.pixels || s.reduced > 1) return node('li', {}, ...text);
    const button = node('button', { type: 'button', onclick: () => toggleOverlay(k, button) }, 'show its pixels');
    button.setAttribute('aria-pressed', 'false');
    return node('li', {}, ...text, button);
  }));
}
function toggleOverlay(k, button) {
  const on = button.getAttribute('aria-pressed') === 'true';
  for (const b of $('suspects').querySelectorAll('button')) b.setAttribute('aria-pressed', 'false');
  eye.overlay = on ? null : overlayOf(scenes[eye.index].suspects[k].pixels);
  button.setAttribute('aria-pressed', !on);
  draw();
}
// Runs of pixels, row by row: so many that do not belong, so many that do, and so on.
function overlayOf(runs) {
  const canvas = node('canvas', { width: eye.width, height: eye.height }), g = canvas.getContext('2d'), out = g.createImageData(eye.width, eye.height);
  let at = 0;
  runs.forEach((run, k) => { for (const end = at + run; at < end; at++) if (k % 2) out.data.set([0, 255, 220, 120], 4 * at); });
  g.putImageData(out, 0, 0);
  return { canvas };
}

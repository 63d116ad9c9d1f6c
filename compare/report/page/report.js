'use strict';
// The report's page. Pictures are kept as base64 text in inert script elements and decoded when they come into view.
(() => {
const $ = id => document.getElementById(id);
const data = JSON.parse($('data').textContent);
const scenes = data.scenes, WHO = { ...data.names };  // who made the two pictures: { o, n }
const node = (tag, props = {}, ...children) => { const e = Object.assign(document.createElement(tag), props); e.append(...children); return e; };
const store = { get(k) { try { return localStorage.getItem(k); } catch { return null; } }, set(k, v) { try { localStorage.setItem(k, v); } catch { /* a file may have no storage */ } } };
const ICON = { exact: '✓', match: '≈', differ: '✗', unsupported: '∅', error: '!', oracle_failed: '?', new: '+', removed: '−' };
const NAME = { exact: 'exact', match: 'match', differ: 'differ', unsupported: 'unsupported', error: 'error', oracle_failed: 'oracle failed', new: 'new', removed: 'removed' };
const fixed = (v, n) => v === null || v === undefined || !isFinite(v) ? '–' : v.toFixed(n);
const UNIT = scenes.some(s => s.cpu) ? 'CPU s' : 's';
const ratio = s => s.oracle_seconds > 0 && s.native_seconds > 0 ? s.oracle_seconds / s.native_seconds : null;
const source = id => { const e = $(id); return e ? 'data:image/png;base64,' + e.textContent : null; };
const thumb = (i, side) => source(`t${i}${side}`) || source(`p${i}${side}`);

for (const side of ['o', 'n']) for (const e of document.querySelectorAll('.who-' + side)) e.textContent = WHO[side];

// ---- theme ----
const setTheme = t => { if (t) document.documentElement.dataset.theme = t; else delete document.documentElement.dataset.theme; };
setTheme(store.get('verisim-theme'));
$('theme').onclick = () => {
  const dark = document.documentElement.dataset.theme ? document.documentElement.dataset.theme === 'dark' : matchMedia('(prefers-color-scheme: dark)').matches;
  setTheme(dark ? 'light' : 'dark'); store.set('verisim-theme', dark ? 'light' : 'dark');
};

// ---- overview ----
const metric = k => s => s.metrics ? s.metrics[k] : null;
const ORDER = ['error', 'differ', 'oracle_failed', 'removed', 'new', 'unsupported', 'match', 'exact'];
const COLUMNS = [
  { key: 'name', label: 'Scene', get: s => s.name.toLowerCase(), left: true },
  { key: 'status', label: 'Status', get: s => ORDER.indexOf(s.status), left: true },
  { key: 'rmse', label: 'RMSE', get: metric('rmse'), digits: 3, down: true },
  { key: 'psnr', label: 'PSNR', get: metric('psnr'), digits: 1, far: true },
  { key: 'ssim', label: 'SSIM', get: metric('ssim_mean'), digits: 4 },
  { key: 'flip', label: 'FLIP', get: metric('flip_mean'), digits: 4, down: true },
  { key: 'within', label: 'Within 1 %', get: metric('within_1_pct'), digits: 3 },
  { key: 'max', label: 'Max', get: metric('max_abs'), digits: 0, down: true },
  { key: 'oracle', label: `${WHO.o} ${UNIT}`, get: s => s.oracle_seconds || null, digits: 2, down: true, far: true },
  { key: 'native', label: `${WHO.n} ${UNIT}`, get: s => s.native_seconds || null, digits: 2, down: true, far: true },
  { key: 'ratio', label: 'Ratio', get: ratio, digits: 1, suffix: '×' },
];
const view = { sort: 'status', reverse: false, text: '', statuses: new Set(), order: [] };

const statusCell = s => {
  const cell = node('td', { className: 'l status' }, node('span', { className: 'st ' + s.status }, `${ICON[s.status]} ${NAME[s.status]}`));
  if (s.previous && s.previous !== s.status) cell.append(node('span', { className: 'was' }, ` was ${NAME[s.previous]}`));
  else if (s.metrics && s.previous_rmse !== null && Math.abs(s.metrics.rmse - s.previous_rmse) > 0.005)
    cell.append(node('span', { className: 'was' }, ` rmse ${s.metrics.rmse > s.previous_rmse ? '↑' : '↓'} from ${fixed(s.previous_rmse, 3)}`));
  return cell;
};
const observer = new IntersectionObserver(entries => {
  for (const e of entries) if (e.isIntersecting) { for (const img of e.target.querySelectorAll('img')) if (!img.src) img.src = thumb(+img.dataset.i, img.dataset.side); observer.unobserve(e.target); }
}, { rootMargin: '300px' });
const rows = scenes.map((s, i) => {
  const pics = node('td', { className: 'pics' });
  for (const [side, who] of [['o', WHO.o], ['n', WHO.n]]) {
    if (!$(`p${i}${side}`)) { pics.append(node('span', { title: `no picture of ${who}` })); continue; }
    const img = node('img', { alt: `${who}'s picture of ${s.name}`, width: 84, height: 63 }); img.dataset.i = i; img.dataset.side = side; pics.append(img);
  }
  const link = node('a', { href: `#${i}` }, s.name);
  const note = [s.reason, s.suspects.length && `suspect: ${s.suspects[0].what}`, s.blame && s.blame.common.length && `in common: ${s.blame.common[0].name}`].filter(Boolean).join('; ');
  const tr = node('tr', {}, pics, node('td', { className: 'scene' }, link, note ? node('small', {}, note) : ''), statusCell(s));
  for (const c of COLUMNS.slice(2)) {
    const v = c.get(s), td = node('td', { className: 'num' + (c.far ? ' far' : '') }, v === null ? '–' : fixed(v, c.digits) + (c.suffix || '')); td.dataset.label = c.label; tr.append(td);
  }
  tr.onclick = e => { if (e.target !== link) location.hash = i; };
  observer.observe(tr);
  return tr;
});
const heads = COLUMNS.map(c => {
  const th = node('th', { scope: 'col', className: c.left ? 'l' : '' }, node('button', { type: 'button', onclick: () => sortBy(c.key) }, c.label)); th.dataset.key = c.key; return th;
});
$('heads').append(node('th', { scope: 'col', className: 'l' }, node('button', { type: 'button', tabIndex: -1 }, 'Pictures')), ...heads);
$('sort').append(...COLUMNS.map(c => node('option', { value: c.key }, c.label)));
$('sort').onchange = e => sortBy(e.target.value);

function sortBy(key) {
  const column = COLUMNS.find(c => c.key === key);
  view.reverse = view.sort === key ? !view.reverse : !!column.down; view.sort = key; show();
}
function matches(s) {
  if (view.statuses.size && !view.statuses.has(s.status)) return false;
  const hay = `${s.name} ${s.status} ${s.class} ${s.reason} ${s.tags.join(' ')} ${s.features.join(' ')} ${s.suspects.map(v => v.what).join(' ')} ${s.blame ? s.blame.common.map(c => c.name).join(' ') : ''}`.toLowerCase();
  return view.text.toLowerCase().split(/\s+/).every(word => hay.includes(word));
}
function show() {
  const get = COLUMNS.find(c => c.key === view.sort).get, worst = metric('rmse');
  const compare = (a, b) => {
    const x = get(scenes[a]), y = get(scenes[b]);
    if (x === null || y === null) return (x === null) - (y === null) || a - b;  // nothing to say: last in either direction
    const d = (x < y ? -1 : x > y ? 1 : 0) * (view.reverse ? -1 : 1);
    return d || (worst(scenes[b]) || 0) - (worst(scenes[a]) || 0) || a - b;
  };
  view.order = scenes.map((s, i) => i).filter(i => matches(scenes[i])).sort(compare);
  $('rows').replaceChildren(...view.order.map(i => rows[i]));
  for (const th of heads) { if (th.dataset.key === view.sort) th.setAttribute('aria-sort', view.reverse ? 'descending' : 'ascending'); else th.removeAttribute('aria-sort'); }
  $('sort').value = view.sort;
  $('shown').textContent = `${view.order.length} of ${scenes.length} scenes`;
}
for (const status of ORDER.slice().reverse()) {
  const count = scenes.filter(s => s.status === status).length;
  if (!count) continue;
  const chip = node('button', { type: 'button', onclick: () => {
    if (!view.statuses.delete(status)) view.statuses.add(status);
    chip.setAttribute('aria-pressed', view.statuses.has(status)); show();
  } }, `${ICON[status]} ${count} ${NAME[status]}`);
  chip.setAttribute('aria-pressed', 'false'); chip.dataset.status = status; $('chips').append(chip);
}
let typing = 0;
$('filter').oninput = e => { clearTimeout(typing); typing = setTimeout(() => { view.text = e.target.value.trim(); show(); }, scenes.length > 1000 ? 150 : 0); };
const bad = scenes.filter(s => s.status !== 'exact' && s.status !== 'match').length;
$('verdict').textContent = bad ? `✗ ${bad} of ${scenes.length} scenes not the same` : `✓ ${scenes.length} ${scenes.length === 1 ? 'scene' : 'scenes'} the same`;
$('verdict').className = 'st ' + (bad ? 'differ' : 'exact');
$('about').textContent = [data.started.replace('T', ' ').replace('Z', ' UTC'), data.oracle_version && `against POV-Ray ${data.oracle_version}`, data.native_version && `verisim ${data.native_version}`,
  data.cancelled && 'broken off'].filter(Boolean).join(' · ');

// ---- one scene ----
const SCALE = [[0, 0, 4], [51, 10, 95], [120, 28, 109], [187, 55, 84], [237, 105, 37], [251, 181, 26], [252, 255, 164]];
const scaleColor = t => {
  const at = Math.min(Math.max(t, 0), 1) * (SCALE.length - 1), i = Math.min(Math.floor(at), SCALE.length - 2);
  return SCALE[i].map((v, c) => v + (at - i) * (SCALE[i + 1][c] - v));
};
const MODES = [['slider', 'Slider', 's'], ['blink', 'Blink', 'b'], ['both', 'Side by side', '2'], ['heat', 'Difference', 'd'], ['oracle', WHO.o, 'p'], ['native', WHO.n, 'v']];
const eye = { index: -1, mode: 'slider', split: 0.5, zoom: 1, x: 0, y: 0, cursor: null, flip: false, timer: 0, o: null, n: null, heat: null, width: 1, height: 1 };
const canvas = $('canvas'), paint = canvas.getContext('2d');

async function decode(id) {
  const src = source(id);
  if (!src) return null;
  const img = new Image(); img.src = src; await img.decode();
  const c = node('canvas', { width: img.naturalWidth, height: img.naturalHeight }), g = c.getContext('2d', { willReadFrequently: true });
  g.drawImage(img, 0, 0);
  return { canvas: c, pixels: g.getImageData(0, 0, c.width, c.height).data, width: c.width, height: c.height };
}
const different = i => { let d = 0; for (let c = 0; c < 3; c++) d = Math.max(d, Math.abs(eye.o.pixels[i + c] - eye.n.pixels[i + c])); return d; };
const level = d => $('scale').value === 'log' ? Math.log2(1 + d) / 8 : d / +$('scale').value;

function makeHeat() {
  eye.heat = null;
  if (!eye.o || !eye.n || eye.o.width !== eye.n.width || eye.o.height !== eye.n.height) return;
  const c = node('canvas', { width: eye.o.width, height: eye.o.height }), g = c.getContext('2d'), out = g.createImageData(c.width, c.height);
  const table = Array.from({ length: 256 }, (_, d) => scaleColor(level(d)));
  for (let i = 0; i < out.data.length; i += 4) { const k = table[different(i)]; out.data[i] = k[0]; out.data[i + 1] = k[1]; out.data[i + 2] = k[2]; out.data[i + 3] = 255; }
  g.putImageData(out, 0, 0);
  eye.heat = { canvas: c, pixels: out.data, width: c.width, height: c.height };
}
function makeLegend() {
  const g = $('legend-bar').getContext('2d'), top = $('scale').value === 'log' ? 255 : +$('scale').value;
  for (let x = 0; x < 256; x++) { g.fillStyle = `rgb(${scaleColor(x / 255).map(Math.round)})`; g.fillRect(x, 0, 1, 1); }
  const ticks = $('scale').value === 'log' ? [0, 1, 3, 15, 63, 255] : [0, 0.25, 0.5, 0.75, 1].map(t => Math.round(t * top));
  $('legend-ticks').replaceChildren(...ticks.map((t, i) => node('span', {}, i === ticks.length - 1 ? `${t}${top < 255 ? ' and more' : ''} code values` : String(t))));
}

const panes = () => {  // rectangles of the canvas (CSS pixels) and the picture each shows
  const w = canvas.clientWidth, h = canvas.clientHeight;
  if (eye.mode === 'both') { const half = Math.floor(w / 2) - 2; return [{ x: 0, w: half, h, pic: eye.o, label: WHO.o }, { x: half + 4, w: w - half - 4, h, pic: eye.n, label: WHO.n }]; }
  const pick = { slider: eye.o, blink: eye.flip ? eye.n : eye.o, heat: eye.heat, oracle: eye.o, native: eye.n }[eye.mode];
  return [{ x: 0, w, h, pic: pick, label: { blink: eye.flip ? WHO.n : WHO.o, heat: 'difference', oracle: WHO.o, native: WHO.n }[eye.mode] || '' }];
};
const origin = pane => ({ x: pane.x + pane.w / 2 - eye.x * eye.zoom, y: pane.h / 2 - eye.y * eye.zoom });

function draw() {
  const dpr = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  if (!w || eye.index < 0) return;
  if (canvas.width !== Math.round(w * dpr) || canvas.height !== Math.round(h * dpr)) { canvas.width = Math.round(w * dpr); canvas.height = Math.round(h * dpr); }
  paint.setTransform(dpr, 0, 0, dpr, 0, 0); paint.clearRect(0, 0, w, h);
  for (const pane of panes()) {
    paint.save(); paint.beginPath(); paint.rect(pane.x, 0, pane.w, h); paint.clip();
    place(pane, pane.pic);
    if (eye.mode === 'slider' && eye.n) {
      const at = pane.x + pane.w * eye.split;
      paint.save(); paint.beginPath(); paint.rect(at, 0, w, h); paint.clip(); paint.clearRect(at, 0, w, h); place(pane, eye.n); paint.restore();
      paint.fillStyle = '#000a'; paint.fillRect(at - 2, 0, 4, h); paint.fillStyle = '#fff'; paint.fillRect(at - 1, 0, 2, h);
      paint.beginPath(); paint.arc(at, h / 2, 12, 0, 7); paint.fill(); paint.strokeStyle = '#000'; paint.stroke();
      paint.fillStyle = '#000'; paint.font = 'bold 13px system-ui, sans-serif'; paint.textAlign = 'center'; paint.textBaseline = 'middle'; paint.fillText('↔', at, h / 2);
      tag(WHO.o, 8, 'left'); tag(WHO.n, w - 8, 'right');
    } else if (pane.label) tag(pane.label, pane.x + 8, 'left');
    paint.restore();
  }
  $('zoomed').textContent = `${Math.round(eye.zoom * 100)} %`;
}
function tag(text, x, align) {
  paint.font = '13px system-ui, sans-serif'; paint.textAlign = align; paint.textBaseline = 'top';
  const width = paint.measureText(text).width + 12;
  paint.fillStyle = '#000b'; paint.fillRect(align === 'left' ? x - 6 : x - width + 6, 6, width, 22); paint.fillStyle = '#fff'; paint.fillText(text, x, 10);
}
function place(pane, pic) {
  if (!pic) { paint.fillStyle = getComputedStyle(document.body).color; paint.font = '15px system-ui, sans-serif'; paint.textAlign = 'center'; paint.textBaseline = 'middle'; paint.fillText('no picture', pane.x + pane.w / 2, pane.h / 2); return; }
  const o = origin(pane), z = eye.zoom;
  paint.imageSmoothingEnabled = z < 1;
  paint.drawImage(pic.canvas, o.x, o.y, pic.width * z, pic.height * z);
  if (z >= 34) numbers(pane, pic, o, z);
  if (eye.cursor && z >= 3) { paint.strokeStyle = '#fff'; paint.lineWidth = 2; paint.strokeRect(o.x + eye.cursor.x * z, o.y + eye.cursor.y * z, z, z); paint.strokeStyle = '#000'; paint.lineWidth = 1; paint.strokeRect(o.x + eye.cursor.x * z - 1.5, o.y + eye.cursor.y * z - 1.5, z + 3, z + 3); }
}
function numbers(pane, pic, o, z) {
  const x0 = Math.max(0, Math.floor((pane.x - o.x) / z)), x1 = Math.min(pic.width - 1, Math.floor((pane.x + pane.w - o.x) / z));
  const y0 = Math.max(0, Math.floor(-o.y / z)), y1 = Math.min(pic.height - 1, Math.floor((pane.h - o.y) / z));
  paint.font = `${Math.min(15, Math.floor(z / 3.6))}px ui-monospace, monospace`; paint.textAlign = 'center'; paint.textBaseline = 'middle';
  for (let y = y0; y <= y1; y++) for (let x = x0; x <= x1; x++) {
    const i = 4 * (y * pic.width + x), p = pic.pixels, light = 0.3 * p[i] + 0.59 * p[i + 1] + 0.11 * p[i + 2];
    paint.fillStyle = light > 120 ? '#000' : '#fff';
    const lines = pic === eye.heat ? ['', String(different(i)), ''] : [p[i], p[i + 1], p[i + 2]];
    for (let c = 0; c < 3; c++) paint.fillText(lines[c], o.x + (x + 0.5) * z, o.y + (y + 0.2 + 0.3 * c) * z);
  }
}

function fit() { const p = panes()[0]; eye.zoom = Math.min(p.w / eye.width, p.h / eye.height); if (eye.zoom > 1) eye.zoom = Math.max(1, Math.floor(eye.zoom * 4) / 4); eye.x = eye.width / 2; eye.y = eye.height / 2; draw(); }
function zoomAt(factor, at) {
  const pane = panes().find(p => !at || (at.x >= p.x && at.x <= p.x + p.w)) || panes()[0];
  const zoom = Math.min(128, Math.max(0.05, eye.zoom * factor)), px = at ? at.x : pane.x + pane.w / 2, py = at ? at.y : pane.h / 2;
  const o = origin(pane), ix = (px - o.x) / eye.zoom, iy = (py - o.y) / eye.zoom;
  eye.zoom = zoom; eye.x = ix - (px - pane.x - pane.w / 2) / zoom; eye.y = iy - (py - pane.h / 2) / zoom;
  keepInside(); draw();
}
function keepInside() { eye.x = Math.min(Math.max(eye.x, 0), eye.width); eye.y = Math.min(Math.max(eye.y, 0), eye.height); }
function setMode(mode) {
  eye.mode = mode; clearInterval(eye.timer);
  if (mode === 'blink') eye.timer = setInterval(() => { eye.flip = !eye.flip; draw(); }, matchMedia('(prefers-reduced-motion: reduce)').matches ? 1500 : 600);
  for (const b of $('modes').children) b.setAttribute('aria-pressed', b.dataset.mode === mode);
  $('slide-row').hidden = mode !== 'slider'; $('legend').hidden = mode !== 'heat'; draw();
}
$('modes').append(...MODES.map(([mode, label, key]) => { const b = node('button', { type: 'button', title: `Key ${key.toUpperCase()}`, onclick: () => setMode(mode) }, label); b.dataset.mode = mode; return b; }));
$('scale').onchange = () => { makeHeat(); makeLegend(); setMode('heat'); };
$('in').onclick = () => zoomAt(2); $('out').onclick = () => zoomAt(0.5); $('fit').onclick = fit; $('one').onclick = () => { eye.zoom = 1; draw(); };
$('slide').oninput = e => { eye.split = e.target.value / 1000; draw(); };
new ResizeObserver(() => draw()).observe(canvas);

function readPixel(x, y) {
  if (x < 0 || y < 0 || x >= eye.width || y >= eye.height) return;
  eye.cursor = { x, y };
  const table = document.querySelector('.readout'), body = table.tBodies[0].rows, read = (pic, alpha) => {
    if (!pic || x >= pic.width || y >= pic.height) return null;
    const i = 4 * (y * pic.width + x); return [pic.pixels[i], pic.pixels[i + 1], pic.pixels[i + 2], alpha ? alpha.pixels[i] : 255];
  };
  const o = read(eye.o, eye.oa), n = read(eye.n, eye.na);
  const step = scenes[eye.index].reduced;
  $('where').textContent = step > 1 ? `mean of ${step}×${step} pixels at ${x * step}, ${y * step}` : `pixel ${x}, ${y}`;
  for (let c = 0; c < 4; c++) {
    body[0].cells[c + 1].textContent = o ? o[c] : '–'; body[1].cells[c + 1].textContent = n ? n[c] : '–';
    body[2].cells[c + 1].textContent = o && n ? (n[c] > o[c] ? '+' : '') + (n[c] - o[c]) : '–';
  }
  $('swatch-o').style.background = o ? `rgb(${o.slice(0, 3)})` : ''; $('swatch-n').style.background = n ? `rgb(${n.slice(0, 3)})` : '';
  const s = scenes[eye.index], command = `verisim explain ${quote(s.file)} ${x * step} ${y * step} +W${s.width} +H${s.height} ${s.switches.map(quote).join(' ')}`;
  $('explain').hidden = !s.file; $('explain').firstElementChild.textContent = command;
  const tree = (s.trees || []).find(t => Math.floor(t.x / step) === x && Math.floor(t.y / step) === y);
  $('tree').hidden = !tree; $('tree').querySelector('pre').textContent = tree ? tree.text : '';
}
const quote = t => /^[\w@%+=:,./-]+$/.test(t) ? t : `'${t.replaceAll("'", `'\\''`)}'`;
$('explain').querySelector('button').onclick = async e => {
  try { await navigator.clipboard.writeText($('explain').firstElementChild.textContent); e.target.textContent = 'Copied'; } catch { getSelection().selectAllChildren($('explain').firstElementChild); }
  setTimeout(() => { e.target.textContent = 'Copy'; }, 1500);
};

// Pointers: one drags the picture or the divider, two pinch.
const touches = new Map(); let dragging = null;
const local = e => { const r = canvas.getBoundingClientRect(); return { x: e.clientX - r.left, y: e.clientY - r.top }; };
const pixelAt = p => { const pane = panes().find(q => p.x >= q.x && p.x <= q.x + q.w) || panes()[0], o = origin(pane); return [Math.floor((p.x - o.x) / eye.zoom), Math.floor((p.y - o.y) / eye.zoom)]; };
canvas.onpointerdown = e => {
  const p = local(e); touches.set(e.pointerId, p); try { canvas.setPointerCapture(e.pointerId); } catch { /* a made-up event */ }
  dragging = eye.mode === 'slider' && Math.abs(p.x - canvas.clientWidth * eye.split) < 24 ? 'divider' : 'picture';
  readPixel(...pixelAt(p)); draw();
};
canvas.onpointermove = e => {
  const p = local(e), last = touches.get(e.pointerId);
  if (touches.size === 2 && last) {
    const other = [...touches].find(([id]) => id !== e.pointerId)[1], before = Math.hypot(last.x - other.x, last.y - other.y), after = Math.hypot(p.x - other.x, p.y - other.y);
    if (before > 0) zoomAt(after / before, { x: (p.x + other.x) / 2, y: (p.y + other.y) / 2 });
  } else if (last && dragging === 'divider') {
    eye.split = Math.min(1, Math.max(0, p.x / canvas.clientWidth)); $('slide').value = Math.round(eye.split * 1000); draw();
  } else if (last) {
    eye.x -= (p.x - last.x) / eye.zoom; eye.y -= (p.y - last.y) / eye.zoom; keepInside(); draw();
  } else { readPixel(...pixelAt(p)); draw(); }
  if (last) touches.set(e.pointerId, p);
};
canvas.onpointerup = canvas.onpointercancel = e => { touches.delete(e.pointerId); dragging = null; };
canvas.onwheel = e => { e.preventDefault(); zoomAt(Math.exp(-e.deltaY * (e.deltaMode ? 0.05 : 0.0018)), local(e)); };
canvas.ondblclick = e => zoomAt(2, local(e));
canvas.onkeydown = e => {
  const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
  if (!step || e.altKey || e.ctrlKey || e.metaKey) return;
  e.preventDefault(); e.stopPropagation();
  const c = eye.cursor || { x: Math.floor(eye.x), y: Math.floor(eye.y) }, k = e.shiftKey ? 10 : 1;
  goTo(Math.min(eye.width - 1, Math.max(0, c.x + step[0] * k)), Math.min(eye.height - 1, Math.max(0, c.y + step[1] * k)));
};
function goTo(x, y, zoom) {
  if (zoom) eye.zoom = zoom;
  readPixel(x, y);
  const p = panes()[0], mx = p.w / eye.zoom / 2 - 1, my = p.h / eye.zoom / 2 - 1;
  if (zoom || Math.abs(x + 0.5 - eye.x) > mx) eye.x = x + 0.5;
  if (zoom || Math.abs(y + 0.5 - eye.y) > my) eye.y = y + 0.5;
  draw();
}

const FIGURES = [['rmse', 'RMSE', 4], ['mae', 'Mean absolute error', 4], ['bias', 'Bias', 4], ['max_abs', 'Largest difference', 1], ['psnr', 'PSNR [dB]', 2], ['within_1_pct', 'Within 1 [%]', 4],
  ['within_2_pct', 'Within 2 [%]', 4], ['ssim_mean', 'SSIM', 5], ['ssim_block_min', 'SSIM, worst 8×8 block', 5], ['solid_2_pixels', 'Wrong pixels in patches', 0], ['drift_max', 'Largest mean of 16×16', 4], ['flip_mean', 'LDR-FLIP', 5], ['hdr_flip_mean', 'HDR-FLIP', 5], ['ciede2000_mean', 'CIEDE2000, mean', 3],
  ['ciede2000_p95', 'CIEDE2000, 95 %', 3], ['edge_rmse', 'RMSE at edges', 4], ['interior_rmse', 'RMSE elsewhere', 4], ['alpha_max_abs', 'Alpha, largest difference', 1], ['nan_pixels', 'NaN or infinite pixels', 0]];
function figures(s) {
  const out = [], row = (k, v) => out.push(node('tr', {}, node('th', { scope: 'row' }, k), node('td', {}, v)));
  if (s.metrics) for (const [key, label, digits] of FIGURES) if (s.metrics[key] !== undefined) row(label, key === 'psnr' && s.metrics.psnr >= 999 ? '999' : fixed(s.metrics[key], digits));
  if (s.low_pass) for (const key of ['mad', 'bias', 'rmse']) row(`Blurred ${key}: ours, noise`, `${fixed(s.low_pass.native[key], 3)}, ${fixed(s.low_pass.noise[key], 3)}`);
  if (s.welch) row("Welch's test", `${s.welch.rejected ? 'rejected' : 'passed'}: p ${s.welch.pixel_p.toExponential(1)} (pixels), ${s.welch.mean_p.toExponential(1)} (mean ${fixed(s.welch.mean_difference, 3)})`);
  if (s.fit) row('Fitted', s.fit);
  row('Class', s.class); row('Size', `${s.width}×${s.height}${s.reduced > 1 ? `, shown at 1:${s.reduced}` : ''}`);
  if (s.oracle_seconds) row(`${WHO.o} [${s.cpu ? 'CPU s' : 's'}]`, fixed(s.oracle_seconds, 2) + (s.cached ? ' (kept)' : ''));
  if (s.native_seconds) row(`${WHO.n} [${s.cpu ? 'CPU s' : 's'}]`, fixed(s.native_seconds, 2));
  if (ratio(s)) row('Ratio', fixed(ratio(s), 1) + '×');
  if (s.switches.length) row('Switches', s.switches.join(' '));
  if (s.features.length) row('Random elements', s.features.join(', '));
  for (const [kind, count] of Object.entries(s.rays)) row(`Rays: ${kind}`, count.toLocaleString('en'));
  $('figures').replaceChildren(...out);
}
function histogram(s) {
  const box = $('histogram');
  if (!s.histogram) { box.textContent = 'no figures'; return; }
  const ns = 'http://www.w3.org/2000/svg', make = (tag, attributes, text) => { const e = document.createElementNS(ns, tag); for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v); if (text) e.textContent = text; return e; };
  const edges = [0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 48, 64, 96, 128, 256], bins = edges.slice(0, -1).map((e, i) => s.histogram.slice(e, edges[i + 1]).reduce((a, b) => a + b, 0));
  const total = s.width * s.height, svg = make('svg', { viewBox: '0 0 330 130', preserveAspectRatio: 'none' }), top = Math.log10(1 + total), w = 330 / bins.length;
  bins.forEach((n, i) => {
    const h = n ? Math.max(2, 92 * Math.log10(1 + n) / top) : 0, name = edges[i + 1] - edges[i] === 1 ? `${edges[i]}` : `${edges[i]} to ${edges[i + 1] - 1}`;
    const bar = make('rect', { x: i * w + 1, y: 100 - h, width: w - 2, height: h }); bar.append(make('title', {}, `${n} pixels (${(100 * n / total).toFixed(3)} %) differ by ${name}`)); svg.append(bar);
    if (i % 2 === 0) svg.append(make('text', { x: i * w + w / 2, y: 114, 'text-anchor': 'middle' }, String(edges[i])));
  });
  svg.append(make('line', { x1: 0, x2: 330, y1: 100.5, y2: 100.5 }), make('text', { x: 330, y: 128, 'text-anchor': 'end' }, 'difference in code values; pixels on a logarithmic scale'));
  box.replaceChildren(svg);
  box.setAttribute('aria-label', 'Pixels by their largest difference: ' + bins.map((n, i) => n ? `${edges[i]}${edges[i + 1] - edges[i] > 1 ? ` to ${edges[i + 1] - 1}` : ''}: ${n}` : '').filter(Boolean).join('; '));
}
function worst(s) {
  $('worst').replaceChildren(...(s.worst || []).map(([x, y, error]) => node('li', {}, node('button', { type: 'button', onclick: () => { if (eye.mode === 'slider') setMode('both'); goTo(Math.floor(x / s.reduced), Math.floor(y / s.reduced), 40); canvas.focus({ preventScroll: false }); } }, `${x}, ${y}: ${fixed(error, 0)} apart`))));
  if (!s.worst || !s.worst.length) $('worst').replaceChildren(node('li', { style: 'list-style: none; margin-left: -26px' }, s.metrics ? 'No pixel differs.' : 'Nothing was compared.'));
}
// What the wrong pixels have in common, and the objects they lie on.
const cells = (tag, ...texts) => texts.map(text => node(tag, tag === 'th' ? { scope: 'col' } : {}, text));
function blame(s) {
  const b = s.blame;
  $('blame').hidden = !b && !s.blame_failed;
  if (!b) { $('blame-note').textContent = s.blame_failed || ''; $('common').replaceChildren(); $('objects').replaceChildren(); return; }
  $('blame-note').textContent = `${b.bad_pixels.toLocaleString('en')} of ${(b.bad_pixels + b.good_pixels).toLocaleString('en')} pixels differ by more than ${b.limit} code values.`;
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
  const o = s.truth.oracle, n = s.truth.native, show = v => v[0] === v[1] && v[1] === v[2] ? v[0].toFixed(5) : v.map(x => x.toFixed(5)).join(' ');
  const off = (v, t) => Math.max(...v.map((x, c) => Math.abs(x - t[c]))).toExponential(1);
  $('formula').textContent = `${s.formula} Largest error: ${WHO.o} ${o.max.toExponential(2)}, ${WHO.n} ${n.max.toExponential(2)}; allowed ${s.tolerance}.`;
  $('points').replaceChildren(node('tr', {}, ...cells('th', 'Pixel', 'true', WHO.o, 'off', WHO.n, 'off')),
    ...s.points.map((p, i) => node('tr', {}, node('th', { scope: 'row' }, `${p.x}, ${p.y}`), ...cells('td', show(p.value), show(o.values[i]), off(o.values[i], p.value), show(n.values[i]), off(n.values[i], p.value)))));
}
async function open(i) {
  const s = scenes[i], fresh = eye.index !== i;
  eye.index = i;
  $('overview').hidden = true; $('detail').hidden = false;
  $('name').textContent = s.name; $('status').className = 'st ' + s.status; $('status').textContent = `${ICON[s.status]} ${NAME[s.status]}`; $('reason').textContent = s.reason;
  $('suspects').replaceChildren(...s.suspects.map(v => node('li', {}, node('b', {}, v.what), `: ${v.detail} (explains ${(100 * v.explained).toFixed(0)} %)`)));
  WHO.o = s.reference || data.names.o;  // a photograph is not POV-Ray's
  document.title = `${s.name} – verisim report`;
  figures(s); histogram(s); worst(s); makeLegend(); blame(s); truth(s); $('explain').hidden = $('tree').hidden = true;
  if (!fresh) return;
  eye.cursor = null; eye.o = eye.n = eye.oa = eye.na = eye.heat = null; draw();
  const [o, n, oa, na] = await Promise.all(['o', 'n', 'oa', 'na'].map(k => decode(`p${i}${k}`).catch(() => null)));
  if (eye.index !== i) return;
  Object.assign(eye, { o, n, oa, na, width: (o || n || s).width, height: (o || n || s).height });
  document.querySelector('.readout').classList.toggle('with-alpha', !!(oa || na));
  canvas.setAttribute('aria-label', `${s.name}: the pictures of ${WHO.o} and ${WHO.n}, ${eye.width} by ${eye.height} pixels`);
  makeHeat(); setMode(o && n ? eye.mode : n ? 'native' : 'oracle'); fit();
  canvas.dataset.ready = i;
}
let lastScroll = 0;
function close() {
  clearInterval(eye.timer); const i = eye.index; eye.index = -1;
  $('detail').hidden = true; $('overview').hidden = false; document.title = 'verisim report'; window.scrollTo(0, lastScroll);
  if (i >= 0 && rows[i].isConnected) rows[i].querySelector('a').focus({ preventScroll: true });
}
function route() {
  const i = parseInt(location.hash.slice(1), 10);
  if (i >= 0 && i < scenes.length) { if (!$('overview').hidden) lastScroll = window.scrollY; open(i); window.scrollTo(0, 0); if (eye.mode === 'blink') setMode('blink'); }
  else if (!$('detail').hidden) close();
}
const neighbour = d => { const at = view.order.indexOf(eye.index), i = view.order[at + d]; if (i !== undefined) location.replace('#' + i); };
$('back').onclick = () => { location.hash = ''; }; $('previous').onclick = () => neighbour(-1); $('next').onclick = () => neighbour(1);
window.onhashchange = route;
window.onkeydown = e => {
  if (e.ctrlKey || e.metaKey || e.altKey) return;
  const field = /^(INPUT|SELECT|TEXTAREA)$/.test(e.target.tagName) && e.target.type !== 'range';
  if (e.key === 'Escape') { if (field) e.target.blur(); else if (!$('detail').hidden) location.hash = ''; return; }
  if (field) return;
  if ($('detail').hidden) {
    if (e.key === '/') { e.preventDefault(); $('filter').focus(); }
    const d = { ArrowDown: 1, ArrowUp: -1, j: 1, k: -1 }[e.key];
    if (d && view.order.length) {
      e.preventDefault();
      const at = view.order.findIndex(i => rows[i].contains(document.activeElement)), to = Math.min(view.order.length - 1, Math.max(0, at + d));
      rows[view.order[to]].querySelector('a').focus();
    }
    return;
  }
  const mode = MODES.find(m => m[2] === e.key.toLowerCase());
  if (mode) setMode(mode[0]);
  else if (e.key === 'j') neighbour(1);
  else if (e.key === 'k') neighbour(-1);
  else if (e.key === '+' || e.key === '=') zoomAt(2);
  else if (e.key === '-') zoomAt(0.5);
  else if (e.key === '0') fit();
};
show(); route();
})();

// The live picture: asks for what is new, draws it, tells the program what is looked at.
'use strict';
const $ = id => document.getElementById(id);
const canvas = $('picture'), context = canvas.getContext('2d', { willReadFrequently: true });
const state = { generation: 0, pieces: 0, state: 0, width: 0, height: 0, zoom: 1, left: 0, top: 0, about: {}, cursor: null, wanted: null };
let colors = null, coarse = null, layers = null, table = null, image = null, story = null, drawing = false;
window.verisim = { state, frames: 0 };  // for tests: what is shown, and how often it was drawn

// ---- what the program sends

const wait = seconds => new Promise(done => setTimeout(done, 1000 * seconds));

async function follow() {
  for (let failures = 0; ;) {
    try {
      const reply = await fetch(`update?generation=${state.generation}&pieces=${state.pieces}&state=${state.state}`, { signal: AbortSignal.timeout(15000) });
      if (!reply.ok) throw new Error(await reply.text());
      take(await reply.arrayBuffer());
      failures = 0;
    } catch (error) {
      $('status').className = 'lost';
      $('status').textContent = 'verisim view does not answer; trying again';
      state.state = -1;  // a new program counts from the start
      state.generation = 0;
      state.pieces = 0;
      state.state = 0;
      await wait(Math.min(2, 0.25 * ++failures));
    }
  }
}

function take(buffer) {
  const size = new DataView(buffer).getUint32(0, true);
  const head = JSON.parse(new TextDecoder().decode(new Uint8Array(buffer, 4, size)));
  let at = 4 + size;
  if (head.generation !== state.generation) {
    if (head.width !== state.width || head.height !== state.height) resize(head.width, head.height);
    // The same part of the picture: samples that did not change leave what is there, sharper as it is.
    const moved = head.zoom !== state.zoom || head.left !== state.left || head.top !== state.top;
    if (moved) shift(head);
    state.fresh = moved;
    layers = null;
  }
  Object.assign(state, { generation: head.generation, pieces: head.pieces, state: head.state, ready: head.layers, status: head.status, broken: head.broken, seconds: head.seconds });
  if (head.tiles.length) Object.assign(state, { zoom: head.zoom, left: head.left, top: head.top });
  for (const [x, y, width, height, cell] of head.tiles) {
    const values = new Float32Array(buffer, at, width * height * 4);
    at += values.byteLength;
    put(values, x, y, width, height, cell);
  }
  if (head.about && head.about.steps) encode(head.about);
  if (head.about) { state.about = head.about; knobs(head.about, head.clock); }
  state.clock = head.clock;
  $('scene').textContent = head.scene;
  document.title = head.scene + ' · verisim';
  $('status').className = '';
  $('status').textContent = head.status === 'done' ? `done in ${head.seconds.toFixed(2)} s, first picture after ${Math.round(1000 * head.first_seconds)} ms` : head.status;
  $('zoom').textContent = `${+state.zoom.toPrecision(3)} ×`;
  errors(head.messages, head.broken);
  if (head.status === 'done' && finished.generation !== head.generation) finish(head);
  $('film').hidden = !(head.about && head.about.clock);
  draw();
}

function resize(width, height) {
  state.width = canvas.width = width;
  state.height = canvas.height = height;
  colors = new Float32Array(width * height * 4);
  coarse = new Map();
  image = context.createImageData(width, height);
  $('rays').setAttribute('viewBox', `0 0 ${width} ${height}`);
}

// What is on the screen, where it is now: until something better comes.
function shift(head) {
  const old = colors.slice(), w = state.width, h = state.height, factor = state.zoom / head.zoom;
  for (let y = 0; y < h; y++)
    for (let x = 0; x < w; x++) {
      const from = [Math.floor((x + head.left + 0.5) * factor - state.left), Math.floor((y + head.top + 0.5) * factor - state.top)];
      const inside = from[0] >= 0 && from[1] >= 0 && from[0] < w && from[1] < h;
      for (let c = 0; c < 4; c++) colors[(y * w + x) * 4 + c] = inside ? old[(from[1] * w + from[0]) * 4 + c] : 0;
    }
  coarse.clear();
}

function put(values, left, top, width, height, cell) {
  const w = state.width, h = state.height, before = coarse.get(`${cell} ${left} ${top}`);
  for (let y = 0, i = 0; y < height; y++)
    for (let x = 0; x < width; x++, i += 4) {
      if (cell > 1 && before && before.length === values.length && !state.fresh &&
          before[i] === values[i] && before[i + 1] === values[i + 1] && before[i + 2] === values[i + 2] && before[i + 3] === values[i + 3]) continue;
      const right = Math.min(w, left + (x + 1) * cell), bottom = Math.min(h, top + (y + 1) * cell);
      for (let v = top + y * cell; v < bottom; v++)
        for (let u = left + x * cell, o = (v * w + u) * 4; u < right; u++, o += 4) {
          colors[o] = values[i]; colors[o + 1] = values[i + 1]; colors[o + 2] = values[i + 2]; colors[o + 3] = values[i + 3];
        }
    }
  if (cell > 1) coarse.set(`${cell} ${left} ${top}`, values.slice());
}

// ---- from colours to the screen

// The program says at which values the stored number goes up: what is shown is what a file would hold.
function encode(about) {
  const key = about.steps.join();
  if (state.steps === key) return;
  state.steps = key;
  table = Float32Array.from(about.steps);
  state.gamma = about.gamma;
}
function stored(value) {
  let low = 0, high = 255;
  while (low < high) { const middle = (low + high) >> 1; if (value >= table[middle]) low = middle + 1; else high = middle; }
  return low;
}

const factor = () => Math.pow(2, +$('exposure').value / (state.gamma || 1));

function hue(id) {
  const t = (id * 0.61803398875) % 1 * 6, part = k => 90 + 150 * Math.max(0, Math.min(1, Math.abs((t + k) % 6 - 3) - 1));
  return [part(0), part(4), part(2)];
}

function draw() {
  if (drawing) return;
  drawing = true;
  requestAnimationFrame(() => {
    drawing = false;
    if (!image || !table) return;
    const data = image.data, n = state.width * state.height, channel = $('channel').value;
    if (channel === 'rgb') {
      const scale = factor(), size = 1 << 13, lut = new Uint8Array(size + 1);
      for (let i = 0; i <= size; i++) lut[i] = stored((i / size) ** 2);  // by the root: dark colours need the finer steps
      for (let i = 0; i < 4 * n; i += 4) {
        for (let c = 0; c < 3; c++) { const v = colors[i + c] * scale; data[i + c] = v >= 1 ? lut[size] : v > 0 ? lut[Math.round(Math.sqrt(v) * size)] : 0; }
        data[i + 3] = 255;
      }
    } else {
      let near = Infinity, far = 0;
      if (channel === 'depth' && layers) for (let i = 0; i < n; i++) if (layers[i] < 1e10) { near = Math.min(near, layers[i]); far = Math.max(far, layers[i]); }
      for (let i = 0; i < n; i++) {
        let shown = [0, 0, 0];
        if (channel === 'alpha') shown = Array(3).fill(255 * (1 - colors[4 * i + 3]));
        else if (layers && channel === 'depth') shown = Array(3).fill(layers[i] < 1e10 ? 255 - 225 * (layers[i] - near) / (far - near || 1) : 0);
        else if (layers && channel === 'normal') shown = [0, 1, 2].map(c => { const v = layers[n + 3 * i + c]; return 127.5 * (v + 1); });
        else if (layers && channel === 'albedo') shown = [0, 1, 2].map(c => stored(layers[4 * n + 3 * i + c]));
        else if (layers && channel === 'id') { const id = layers[7 * n + i]; if (id > 0) shown = hue(id); }
        data[4 * i] = shown[0]; data[4 * i + 1] = shown[1]; data[4 * i + 2] = shown[2]; data[4 * i + 3] = 255;
      }
    }
    if (channel === 'rgb') beside(data);
    context.putImageData(image, 0, 0);
    window.verisim.frames++;
    readout();
    if (channel !== 'rgb' && channel !== 'alpha' && !layers && state.ready) fetchLayers();
  });
}

async function fetchLayers() {
  const generation = state.generation, reply = await fetch(`layers?generation=${generation}`), buffer = await reply.arrayBuffer();
  if (buffer.byteLength && generation === state.generation) { layers = new Float32Array(buffer); draw(); }
}

function readout() {
  if (!state.cursor || !colors || !table) return;
  const [x, y] = state.cursor, i = y * state.width + x, c = [0, 1, 2, 3].map(k => colors[4 * i + k]), n = state.width * state.height;
  let text = `pixel ${x + state.left}, ${y + state.top}: stored ${c.slice(0, 3).map(stored).join(' ')}, linear ${c.slice(0, 3).map(v => +v.toPrecision(5)).join(' ')}`;
  if (c[3]) text += `, see-through ${+c[3].toPrecision(4)}`;
  if (layers) text += layers[i] < 1e10 ? `, ${+layers[i].toPrecision(6)} away, normal ${[0, 1, 2].map(k => +layers[n + 3 * i + k].toFixed(3)).join(' ')}, object ${layers[7 * n + i]}` : ', nothing is hit';
  $('values').textContent = text;
}

// ---- held against another picture

const finished = { generation: -1, bytes: null };  // what a file would hold of the newest finished picture
let previous = null, other = null, flip = null, blink = false;
const same = () => state.zoom === 1 && state.left === 0 && state.top === 0;

function finish(head) {
  if (state.wanted || head.zoom !== 1 || head.quick) return;
  if (finished.bytes) previous = finished.bytes;
  const n = state.width * state.height, bytes = new Uint8Array(3 * n);
  for (let i = 0; i < n; i++) for (let c = 0; c < 3; c++) bytes[3 * i + c] = stored(colors[4 * i + c]);
  finished.generation = head.generation;
  finished.bytes = bytes;
  if ($('other').value) hold();
}

// Fetches the other picture, and says how far away it is.
async function hold() {
  const which = $('other').value, generation = finished.generation;
  $('split-label').hidden = !which || $('way').value !== 'split';
  other = flip = null;
  $('worst').replaceChildren();
  if (!which) { $('compared').textContent = ''; return draw(); }
  if (which === 'previous') {
    other = previous;
    $('compared').textContent = previous ? '' : 'There is no version before.';
  } else {
    $('compared').textContent = which === 'povray' ? 'POV-Ray renders …' : 'reading …';
    const reply = await fetch(which).catch(() => null);
    if (generation !== finished.generation || which !== $('other').value) return;
    if (!reply || !reply.ok) { $('compared').textContent = reply ? await reply.text() : 'verisim view does not answer'; return draw(); }
    other = new Uint8Array(await reply.arrayBuffer());
  }
  if (other && finished.bytes && other.length === finished.bytes.length) tellDifference();
  if ($('way').value === 'flip') await fetchFlip();
  draw();
}

function tellDifference() {
  const w = state.width, a = finished.bytes, errors = [];
  let most = 0, differ = 0;
  for (let i = 0; i < a.length; i += 3) {
    const e = Math.max(Math.abs(a[i] - other[i]), Math.abs(a[i + 1] - other[i + 1]), Math.abs(a[i + 2] - other[i + 2]));
    if (e) { differ++; errors.push([e, i / 3]); most = Math.max(most, e); }
  }
  $('compared').textContent = differ ? `${differ} pixels differ, by ${most} at most` : 'the same in every pixel';
  errors.sort((p, q) => q[0] - p[0]);
  const worst = [];
  for (const [e, i] of errors) {
    const x = i % w, y = (i - x) / w;
    if (worst.every(p => Math.hypot(p[1] - x, p[2] - y) > 3)) worst.push([e, x, y]);
    if (worst.length === 5) break;
  }
  $('worst').replaceChildren(...worst.map(([e, x, y]) => {
    const button = document.createElement('button');
    button.textContent = `${x}, ${y}: ${e}`;
    button.title = 'follow the ray of this pixel';
    button.onclick = () => { state.cursor = [x, y]; readout(); explain(x, y); };
    return button;
  }));
}

async function fetchFlip() {
  if (!other || $('other').value === 'previous') return;
  const reply = await fetch('flip').catch(() => null);
  if (reply && reply.ok) flip = new Float32Array(await reply.arrayBuffer());
  else if (reply) $('compared').textContent = await reply.text();
}

// What stands beside the picture goes over its bytes.
function beside(data) {
  if (!other || !same() || other.length * 4 !== data.length * 3) return;
  const way = $('way').value, w = state.width, n = w * state.height, edge = Math.round(+$('split').value * w);
  for (let i = 0; i < n; i++)
    for (let c = 0; c < 3; c++) {
      const o = other[3 * i + c], at = 4 * i + c;
      if (way === 'other' || (way === 'blink' && blink) || (way === 'split' && i % w >= edge)) data[at] = i % w === edge && way === 'split' ? 255 - o : o;
      else if (way === 'difference') data[at] = 16 * Math.abs(data[at] - o);
      else if (way === 'flip') data[at] = flip ? [255 * Math.min(1, 3 * flip[i]), 255 * Math.max(0, Math.min(1, 3 * flip[i] - 1)), 255 * Math.max(0, 3 * flip[i] - 2)][c] : 0;
    }
}
setInterval(() => { if (other && $('way').value === 'blink' && !document.hidden) { blink = !blink; draw(); } }, 600);
$('other').onchange = hold;
$('way').onchange = async () => { $('split-label').hidden = !$('other').value || $('way').value !== 'split'; if ($('way').value === 'flip' && !flip) await fetchFlip(); draw(); };
$('split').oninput = draw;
fetch('others').then(reply => reply.json()).then(told => { document.querySelector('#other option[value=stored]').hidden = !told.stored; }).catch(() => {});

// ---- playing an animation, coarse

let playing = false;
async function play() {
  playing = !playing;
  $('play').textContent = playing ? 'Stop' : 'Play';
  const about = state.about, frames = about.frames > 1 ? about.frames : 30, before = state.clock;
  for (let frame = 0; playing; frame = (frame + 1) % frames) {
    const clock = about.first + (about.last - about.first) * frame / Math.max(1, frames - 1), start = performance.now(), from = state.generation;
    await ask({ clock, quick: true });
    while (playing && !(state.generation > from && state.status === 'done') && !state.broken) await wait(0.01);
    await wait(Math.max(0, 0.04 - (performance.now() - start) / 1000));
    window.verisim.played = (window.verisim.played || 0) + 1;
  }
  ask({ clock: before, quick: false });
}
$('play').onclick = play;

// ---- messages of the scene

function errors(messages, broken) {
  const serious = messages.filter(m => m.severity !== 'warning'), box = $('errors'), key = JSON.stringify(serious);
  box.hidden = !broken;
  if (box.dataset.key === key) return;
  box.dataset.key = key;
  box.replaceChildren(...serious.flatMap(m => {
    const line = document.createElement('p'), kind = document.createElement('span');
    kind.className = 'kind';
    kind.textContent = m.severity + ': ';
    if (m.file) {
      const link = document.createElement('a');
      link.href = `vscode://file${m.file.startsWith('/') ? '' : '/'}${encodeURI(m.file)}:${m.line}:${m.column}`;
      link.title = 'open in the editor';
      link.textContent = `${m.file}:${m.line}:${m.column}`;
      line.append(link, ': ');
    }
    line.append(kind, m.message, m.advice ? ' ' + m.advice : '');
    if (!m.source) return [line];
    const source = document.createElement('pre');
    source.textContent = m.source + '\n' + ' '.repeat(Math.max(0, m.caret - 1)) + '^' + m.trail.map(t => '\n' + t).join('');
    return [line, source];
  }));
}

// ---- what is asked for

let asking = false;
async function ask(wish) {
  state.wanted = { ...state.wanted, ...wish };
  if (asking) return;
  asking = true;
  while (state.wanted) {
    const body = JSON.stringify(state.wanted);
    state.wanted = null;
    try { await fetch('wish', { method: 'POST', body }); } catch { /* follow() tells */ }
  }
  asking = false;
}

function look(zoom, left, top, focus) {
  zoom = Math.max(1, Math.min(4096, zoom));
  const clamp = (v, most) => Math.round(Math.max(0, Math.min(most, v)));
  endStory();
  const wish = { zoom, left: clamp(left, Math.floor(state.width * (zoom - 1))), top: clamp(top, Math.floor(state.height * (zoom - 1))) };
  if (focus) { wish.focus_x = Math.round(focus[0]); wish.focus_y = Math.round(focus[1]); }
  state.aim = wish;
  ask(wish);
}
const aim = () => state.aim || state;
function zoomBy(by, at) {
  const [x, y] = at || state.cursor || [state.width / 2, state.height / 2], from = aim();
  const zoom = Math.max(1, from.zoom * by), real = zoom / from.zoom;
  look(zoom, (from.left + x) * real - x, (from.top + y) * real - y, [x, y]);
}

const place = event => {
  const r = canvas.getBoundingClientRect();
  return [Math.max(0, Math.min(state.width - 1, Math.floor((event.clientX - r.left) / r.width * state.width))), Math.max(0, Math.min(state.height - 1, Math.floor((event.clientY - r.top) / r.height * state.height)))];
};
let drag = null;
canvas.addEventListener('pointerdown', e => { drag = { from: place(e), view: { ...aim() }, moved: false }; canvas.setPointerCapture(e.pointerId); });
canvas.addEventListener('pointermove', e => {
  state.cursor = place(e);
  readout();
  if (!drag) return;
  const dx = state.cursor[0] - drag.from[0], dy = state.cursor[1] - drag.from[1];
  if (Math.abs(dx) + Math.abs(dy) > 3) drag.moved = true;
  if (drag.moved && drag.view.zoom > 1) look(drag.view.zoom, drag.view.left - dx, drag.view.top - dy);
});
canvas.addEventListener('pointerup', e => { if (drag && !drag.moved) explain(...place(e)); drag = null; });
canvas.addEventListener('wheel', e => { e.preventDefault(); zoomBy(e.deltaY < 0 ? 1.5 : 1 / 1.5, place(e)); }, { passive: false });
$('in').onclick = () => zoomBy(2);
$('out').onclick = () => zoomBy(0.5);
$('whole').onclick = () => look(1, 0, 0);
$('channel').onchange = draw;
$('exposure').oninput = () => { $('stops').textContent = $('exposure').value; draw(); };

document.addEventListener('keydown', e => {
  if (e.ctrlKey || e.metaKey || e.altKey || /INPUT|SELECT/.test(e.target.tagName)) return;
  const step = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
  if (step && e.target === canvas) {
    const from = state.cursor || [state.width >> 1, state.height >> 1];
    state.cursor = [Math.max(0, Math.min(state.width - 1, from[0] + step[0] * (e.shiftKey ? 10 : 1))), Math.max(0, Math.min(state.height - 1, from[1] + step[1] * (e.shiftKey ? 10 : 1)))];
    readout();
  } else if (e.key === 'Enter' && e.target === canvas && state.cursor) explain(...state.cursor);
  else if (e.key === '+' || e.key === '=') zoomBy(2);
  else if (e.key === '-') zoomBy(0.5);
  else if (e.key === '0') look(1, 0, 0);
  else if (e.key === 'c') { $('channel').selectedIndex = ($('channel').selectedIndex + 1) % $('channel').length; draw(); }
  else if (e.key === '[' || e.key === ']') { $('exposure').value = +$('exposure').value + (e.key === ']' ? 0.5 : -0.5); $('exposure').oninput(); }
  else if (e.key === 'b') { const c = $('other').value ? $('way') : $('other'); c.selectedIndex = (c.selectedIndex + 1) % (c === $('other') ? 2 : c.length); c.onchange(); }
  else if (e.key === 'p' && !$('film').hidden) play();
  else if (e.key === 'Escape') endStory();
  else return;
  e.preventDefault();
});

function knobs(about, clock) {
  const all = [...(about.knobs || [])];
  if (about.clock) all.push({ name: 'clock', value: clock, low: 0, high: 1, step: 0, clock: true });
  const key = JSON.stringify(all.map(k => [k.name, k.low, k.high, k.step]));
  if ($('knobs').dataset.key === key) {
    for (const knob of all) { const input = $('knob-' + knob.name); if (input && document.activeElement !== input) { input.value = knob.value; input.nextElementSibling.textContent = +knob.value.toPrecision(5); } }
    return;
  }
  $('knobs').dataset.key = key;
  $('knobs').replaceChildren(...all.map(knob => {
    const label = document.createElement('label'), input = document.createElement('input'), value = document.createElement('output');
    Object.assign(input, { type: 'range', id: 'knob-' + knob.name, min: knob.low, max: knob.high, step: knob.step || (knob.high - knob.low) / 1000, value: knob.value });
    value.textContent = +knob.value.toPrecision(5);
    input.oninput = () => { value.textContent = input.value; ask(knob.clock ? { clock: +input.value } : { values: { ...(state.wanted || {}).values, [knob.name]: +input.value } }); };
    label.append(knob.name, input, value);
    return label;
  }));
}

// ---- following a ray

const from = { azimuth: 30, elevation: 25 };  // the way the drawing looks, in degrees

async function explain(x, y) {
  const reply = await fetch(`explain?x=${x}&y=${y}`);
  if (!reply.ok) { $('values').textContent = await reply.text(); return; }
  story = await reply.json();
  story.at = [x, y];
  story.number = (explain.count = (explain.count || 0) + 1);
  $('story').hidden = false;
  $('pixel').textContent = `Pixel ${story.x}, ${story.y}`;
  if (other && $('other').value === 'povray' && same()) { const i = 3 * (y * state.width + x); story.oracle = `POV-Ray: ${other[i]} ${other[i + 1]} ${other[i + 2]}`; }
  $('result').replaceChildren(resultOf(story));
  $('sum').replaceChildren(...story.rays.map(sumOf));
  $('tree').textContent = story.text;
  side();
  mark();
}
function endStory() { story = null; $('story').hidden = true; $('rays').replaceChildren(); }

const element = (name, attributes) => { const e = document.createElementNS('http://www.w3.org/2000/svg', name); for (const [k, v] of Object.entries(attributes)) e.setAttribute(k, v); return e; };

// One drawing at a time; where the eye moved meanwhile another follows.
async function side() {
  if (side.busy) { side.again = true; return; }
  side.busy = true;
  do {
    side.again = false;
    if (!story) break;
    try {
      const reply = await fetch(`drawing?azimuth=${from.azimuth}&elevation=${from.elevation}&width=480&height=360&of=${story.number}`);
      if (!reply.ok) { $('side').textContent = await reply.text(); continue; }
      const drawn = document.importNode(new DOMParser().parseFromString(await reply.text(), 'image/svg+xml').documentElement, true);
      const behind = drawn.querySelector('image');
      if (behind) await new Promise(done => { const image = new Image(); image.onload = image.onerror = done; image.src = behind.getAttribute('href'); });
      $('side').replaceChildren(drawn);
    } catch { /* follow() tells */ }
  } while (side.again);
  side.busy = false;
}
function turn(azimuth, elevation) {
  from.azimuth = ((azimuth % 360) + 360) % 360;
  from.elevation = Math.max(-90, Math.min(90, elevation));
  side();
}
let turning = null;
$('side').addEventListener('pointerdown', e => { turning = [e.clientX, e.clientY, from.azimuth, from.elevation]; $('side').setPointerCapture(e.pointerId); e.preventDefault(); $('side').focus(); });
$('side').addEventListener('pointermove', e => { if (turning) turn(turning[2] - (e.clientX - turning[0]) / 2, turning[3] + (e.clientY - turning[1]) / 2); });
$('side').addEventListener('pointerup', () => { turning = null; });
$('side').addEventListener('keydown', e => {
  const step = { ArrowLeft: [10, 0], ArrowRight: [-10, 0], ArrowUp: [0, 10], ArrowDown: [0, -10] }[e.key];
  if (step) { turn(from.azimuth + step[0], from.elevation + step[1]); e.preventDefault(); }
});
for (const button of document.querySelectorAll('[data-from]')) button.onclick = () => turn(...button.dataset.from.split(',').map(Number));

// The place of the pixel, and the rays as they lie in the picture.
async function mark() {
  const [x, y] = story.at.map(v => v + 0.5);
  $('rays').replaceChildren(element('circle', { class: 'ray camera', cx: x, cy: y, r: Math.max(4, state.width / 80) }), element('circle', { class: 'head camera', cx: x, cy: y, r: Math.max(1, state.width / 320) }));
  const reply = await fetch('overlay').catch(() => null), text = reply && reply.ok ? await reply.text() : '';
  if (!text || !story) return;
  const drawn = new DOMParser().parseFromString(text, 'image/svg+xml').documentElement;
  $('rays').append(...[...drawn.children].map(e => document.importNode(e, true)));
}

follow();

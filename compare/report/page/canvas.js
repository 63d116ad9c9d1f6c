// The canvas: one to three panes that show the same place of the pictures in step.
const eye = {
  index: -1, mode: 'all', split: 0.5, zoom: 1, x: 0, y: 0, cursor: null, flip: false, timer: 0, width: 1, height: 1,
  o: null, n: null, oa: null, na: null,  // the pictures
  map: null, overlay: null,
};
const MODES = [['all', 'Side by side', '2'], ['slider', 'Slider', 's'], ['blink', 'Blink', 'b'], ['heat', 'Map', 'd'], ['oracle', WHO.o, 'p'], ['native', WHO.n, 'v']];
const canvas = $('canvas'), paint = canvas.getContext('2d');
const GAP = 4;

// Rectangles of the canvas (CSS pixels) and the picture that each shows. Narrow canvases stack them.
function panes() {
  const w = canvas.clientWidth, h = canvas.clientHeight;
  if (eye.mode === 'all') {
    const parts = [[eye.o, WHO.o], [eye.n, WHO.n], ...(eye.map ? [[eye.map, eye.map.name]] : [])], stacked = w < h * 0.8, k = parts.length;
    const pw = stacked ? w : (w - GAP * (k - 1)) / k, ph = stacked ? (h - GAP * (k - 1)) / k : h;
    return parts.map(([pic, label], i) => ({ x: stacked ? 0 : i * (pw + GAP), y: stacked ? i * (ph + GAP) : 0, w: pw, h: ph, pic, label }));
  }
  const [pic, label] = { slider: [eye.o, ''], blink: eye.flip ? [eye.n, WHO.n] : [eye.o, WHO.o], heat: [eye.map, eye.map ? eye.map.name : 'map'], oracle: [eye.o, WHO.o], native: [eye.n, WHO.n] }[eye.mode];
  return [{ x: 0, y: 0, w, h, pic, label }];
}
const origin = pane => ({ x: pane.x + pane.w / 2 - eye.x * eye.zoom, y: pane.y + pane.h / 2 - eye.y * eye.zoom });
const inside = (pane, p) => p.x >= pane.x && p.x <= pane.x + pane.w && p.y >= pane.y && p.y <= pane.y + pane.h;

function draw() {
  const dpr = window.devicePixelRatio || 1, w = canvas.clientWidth, h = canvas.clientHeight;
  if (!w || eye.index < 0) return;
  if (canvas.width !== Math.round(w * dpr) || canvas.height !== Math.round(h * dpr)) { canvas.width = Math.round(w * dpr); canvas.height = Math.round(h * dpr); }
  paint.setTransform(dpr, 0, 0, dpr, 0, 0); paint.clearRect(0, 0, w, h);
  for (const pane of panes()) {
    paint.save(); paint.beginPath(); paint.rect(pane.x, pane.y, pane.w, pane.h); paint.clip();
    place(pane, pane.pic);
    if (eye.mode === 'slider' && eye.n) divider(pane);
    else if (pane.label) tag(pane.label, pane.x + 8, pane.y, 'left', pane.w - 16);
    paint.restore();
  }
  $('zoomed').textContent = `${Math.round(eye.zoom * 100)} %`;
  const p = panes()[0], o = origin(p);
  canvas.dataset.view = [p.x - o.x, p.y - o.y, p.x + p.w - o.x, p.y + p.h - o.y].map(v => (v / eye.zoom).toFixed(1)).join(' ');  // left, top, right, bottom
}
function divider(pane) {
  const at = pane.w * eye.split, w = pane.w, h = pane.h;
  paint.save(); paint.beginPath(); paint.rect(at, 0, w, h); paint.clip(); paint.clearRect(at, 0, w, h); place(pane, eye.n); paint.restore();
  paint.fillStyle = '#000a'; paint.fillRect(at - 2, 0, 4, h); paint.fillStyle = '#fff'; paint.fillRect(at - 1, 0, 2, h);
  paint.beginPath(); paint.arc(at, h / 2, 12, 0, 7); paint.fill(); paint.strokeStyle = '#000'; paint.stroke();
  paint.fillStyle = '#000'; paint.font = 'bold 13px system-ui, sans-serif'; paint.textAlign = 'center'; paint.textBaseline = 'middle'; paint.fillText('↔', at, h / 2);
  tag(WHO.o, 8, 0, 'left', w / 2 - 16); tag(WHO.n, w - 8, 0, 'right', w / 2 - 16);
}
function tag(text, x, y, align, room) {
  paint.font = '13px system-ui, sans-serif'; paint.textAlign = align; paint.textBaseline = 'top';
  while (text.length > 4 && paint.measureText(text).width > room) text = '…' + text.slice(2);
  const width = paint.measureText(text).width + 12;
  paint.fillStyle = '#000b'; paint.fillRect(align === 'left' ? x - 6 : x - width + 6, y + 6, width, 22); paint.fillStyle = '#fff'; paint.fillText(text, x, y + 10);
}
function place(pane, pic) {
  if (!pic) {
    paint.fillStyle = getComputedStyle(document.body).color; paint.font = '15px system-ui, sans-serif'; paint.textAlign = 'center'; paint.textBaseline = 'middle';
    paint.fillText('no picture', pane.x + pane.w / 2, pane.y + pane.h / 2);
    return;
  }
  const o = origin(pane), z = eye.zoom;
  paint.imageSmoothingEnabled = z < 1;
  paint.drawImage(pic.canvas, o.x, o.y, pic.width * z, pic.height * z);
  if (eye.overlay) paint.drawImage(eye.overlay.canvas, o.x, o.y, pic.width * z, pic.height * z);
  if (z >= 34) numbers(pane, pic, o, z);
  frame(o, z);
}
// The place where the errors are worst, and the cursor.
function frame(o, z) {
  const s = scenes[eye.index], box = (x, y, w, h, outer) => {
    paint.strokeStyle = '#000'; paint.lineWidth = 1; paint.strokeRect(x - 1.5 - outer, y - 1.5 - outer, w + 3 + 2 * outer, h + 3 + 2 * outer);
    paint.strokeStyle = '#fff'; paint.strokeRect(x - 0.5 - outer, y - 0.5 - outer, w + 1 + 2 * outer, h + 1 + 2 * outer);
  };
  if (s.place && !passed(s) && eye.mode !== 'blink') { const [x, y, w, h] = s.place; box(o.x + x * z, o.y + y * z, w * z, h * z, 2); }
  if (eye.cursor && z >= 3) box(o.x + eye.cursor.x * z, o.y + eye.cursor.y * z, z, z, 0);
}
function numbers(pane, pic, o, z) {
  const x0 = Math.max(0, Math.floor((pane.x - o.x) / z)), x1 = Math.min(pic.width - 1, Math.floor((pane.x + pane.w - o.x) / z));
  const y0 = Math.max(0, Math.floor((pane.y - o.y) / z)), y1 = Math.min(pic.height - 1, Math.floor((pane.y + pane.h - o.y) / z));
  paint.font = `${Math.min(15, Math.floor(z / 3.6))}px ui-monospace, monospace`; paint.textAlign = 'center'; paint.textBaseline = 'middle';
  for (let y = y0; y <= y1; y++) for (let x = x0; x <= x1; x++) {
    const at = y * pic.width + x, i = 4 * at, p = pic.pixels, light = 0.3 * p[i] + 0.59 * p[i + 1] + 0.11 * p[i + 2];
    paint.fillStyle = light > 120 ? '#000' : '#fff';
    const lines = pic.text ? ['', pic.text(at), ''] : [0, 1, 2].map(c => pic.fine ? pic.fine.text(3 * at + c) : p[i + c]);
    for (let c = 0; c < 3; c++) paint.fillText(lines[c], o.x + (x + 0.5) * z, o.y + (y + 0.2 + 0.3 * c) * z);
  }
}

function fit() {
  const p = panes()[0];
  eye.zoom = Math.min(p.w / eye.width, p.h / eye.height);
  if (eye.zoom > 1) eye.zoom = Math.max(1, Math.floor(eye.zoom * 4) / 4);
  eye.x = eye.width / 2; eye.y = eye.height / 2;
  draw();
}
// A rectangle of the picture and something around it, as large as the panes show it, but for lone pixels at most 24 times.
function fitTo([x, y, w, h]) {
  const p = panes()[0], around = 6 + 0.25 * Math.max(w, h), zoom = Math.min(24, p.w / (w + 2 * around), p.h / (h + 2 * around)), whole = Math.min(p.w / eye.width, p.h / eye.height);
  if (zoom <= whole) { fit(); return; }
  eye.zoom = zoom > 1 ? Math.floor(zoom * 4) / 4 : zoom;
  const kept = (centre, size, room) => room >= size * eye.zoom ? size / 2 : clamp(centre, room / 2 / eye.zoom, size - room / 2 / eye.zoom);
  eye.x = kept(x + w / 2, eye.width, p.w); eye.y = kept(y + h / 2, eye.height, p.h);
  draw();
}
function zoomAt(factor, at) {
  const pane = (at && panes().find(p => inside(p, at))) || panes()[0];
  const zoom = clamp(eye.zoom * factor, 0.05, 128), px = at ? at.x : pane.x + pane.w / 2, py = at ? at.y : pane.y + pane.h / 2;
  const o = origin(pane), ix = (px - o.x) / eye.zoom, iy = (py - o.y) / eye.zoom;
  eye.zoom = zoom; eye.x = ix - (px - pane.x - pane.w / 2) / zoom; eye.y = iy - (py - pane.y - pane.h / 2) / zoom;
  keepInside(); draw();
}
function keepInside() { eye.x = clamp(eye.x, 0, eye.width); eye.y = clamp(eye.y, 0, eye.height); }

// Pointers: one drags the picture or the divider, two pinch.
const touches = new Map();
let dragging = null;
const local = e => { const r = canvas.getBoundingClientRect(); return { x: e.clientX - r.left, y: e.clientY - r.top }; };
const pixelAt = p => { const pane = panes().find(q => inside(q, p)) || panes()[0], o = origin(pane); return [Math.floor((p.x - o.x) / eye.zoom), Math.floor((p.y - o.y) / eye.zoom)]; };
canvas.onpointerdown = e => {
  const p = local(e);
  touches.set(e.pointerId, p);
  try { canvas.setPointerCapture(e.pointerId); } catch { /* a made-up event */ }
  dragging = eye.mode === 'slider' && Math.abs(p.x - canvas.clientWidth * eye.split) < 24 ? 'divider' : 'picture';
  readPixel(...pixelAt(p)); draw();
};
canvas.onpointermove = e => {
  const p = local(e), last = touches.get(e.pointerId);
  if (touches.size === 2 && last) {
    const other = [...touches].find(([id]) => id !== e.pointerId)[1], before = Math.hypot(last.x - other.x, last.y - other.y), after = Math.hypot(p.x - other.x, p.y - other.y);
    if (before > 0) zoomAt(after / before, { x: (p.x + other.x) / 2, y: (p.y + other.y) / 2 });
  } else if (last && dragging === 'divider') {
    eye.split = clamp(p.x / canvas.clientWidth, 0, 1); $('slide').value = Math.round(eye.split * 1000); draw();
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
  goTo(clamp(c.x + step[0] * k, 0, eye.width - 1), clamp(c.y + step[1] * k, 0, eye.height - 1));
};
function goTo(x, y, zoom) {
  if (zoom) eye.zoom = zoom;
  readPixel(x, y);
  const p = panes()[0], mx = p.w / eye.zoom / 2 - 1, my = p.h / eye.zoom / 2 - 1;
  if (zoom || Math.abs(x + 0.5 - eye.x) > mx) eye.x = x + 0.5;
  if (zoom || Math.abs(y + 0.5 - eye.y) > my) eye.y = y + 0.5;
  draw();
}
new ResizeObserver(() => draw()).observe(canvas);

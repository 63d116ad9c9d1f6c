// Four corners of a render, picked in a photograph: the numbers that --corners and a manifest take.
'use strict';
(() => {
const $ = id => document.getElementById(id);
const data = JSON.parse($('data').textContent);
const NAMES = ['upper left', 'upper right', 'lower right', 'lower left'], UNIT = [[0, 0], [1, 0], [1, 1], [0, 1]];
const canvas = $('photograph'), g = canvas.getContext('2d'), photograph = new Image(), render = new Image();
const corners = [];  // in the photograph's own pixels
let held = -1;

const shown = point => point.map(v => v * data.scale);
const inPhotograph = e => {
  const box = canvas.getBoundingClientRect();
  return [(e.clientX - box.left) * canvas.width / box.width / data.scale, (e.clientY - box.top) * canvas.height / box.height / data.scale];
};
const nearest = p => corners.findIndex(c => Math.hypot(c[0] - p[0], c[1] - p[1]) * data.scale * canvas.getBoundingClientRect().width / canvas.width < 14);

// The unit square to a quadrilateral (Heckbert 1989): where lines of the render lie in the photograph.
function homography([[x0, y0], [x1, y1], [x2, y2], [x3, y3]]) {
  const sx = x0 - x1 + x2 - x3, sy = y0 - y1 + y2 - y3, dx1 = x1 - x2, dx2 = x3 - x2, dy1 = y1 - y2, dy2 = y3 - y2, d = dx1 * dy2 - dx2 * dy1;
  const a = (sx * dy2 - dx2 * sy) / d, b = (dx1 * sy - sx * dy1) / d;
  return (u, v) => {
    const w = a * u + b * v + 1;
    return [((x1 - x0 + a * x1) * u + (x3 - x0 + b * x3) * v + x0) / w, ((y1 - y0 + a * y1) * u + (y3 - y0 + b * y3) * v + y0) / w];
  };
}

function line(points, width) {
  for (const [color, extra] of [['#000', 2], ['#fd0', 0]]) {
    g.strokeStyle = color; g.lineWidth = width + extra;
    g.beginPath(); points.forEach((p, i) => g[i ? 'lineTo' : 'moveTo'](...shown(p))); g.stroke();
  }
}
function draw() {
  g.drawImage(photograph, 0, 0);
  line(corners.length === 4 ? [...corners, corners[0]] : corners, 2);
  if (corners.length === 4) {
    const at = homography(corners);
    for (const t of [1 / 3, 2 / 3]) { line([at(t, 0), at(t, 1)], 1); line([at(0, t), at(1, t)], 1); }
  }
  for (const c of corners) { g.fillStyle = '#fd0'; g.beginPath(); g.arc(...shown(c), 4, 0, 7); g.fill(); }
  const next = corners.length;
  $('ask').textContent = next < 4 ? `${data.reference}: click where the picture's ${NAMES[next]} corner is` : `${data.reference}: all four corners are there`;
  const r = $('render'), pen = r.getContext('2d');
  pen.drawImage(render, 0, 0, r.width, r.height);
  if (next < 4) {
    pen.strokeStyle = '#fd0'; pen.lineWidth = r.width / 60;
    pen.beginPath(); pen.arc(UNIT[next][0] * r.width, UNIT[next][1] * r.height, r.width / 14, 0, 7); pen.stroke();
  }
  $('result').hidden = next < 4;
  const numbers = corners.map(c => c.map(v => +v.toFixed(1)));
  $('command').textContent = data.command.replace('CORNERS', numbers.flat().join(','));
  $('manifest').textContent = `reference = ${JSON.stringify(data.reference)}\ncorners = [${numbers.map(c => `[${c.join(', ')}]`).join(', ')}]`;
}
function loupe([x, y]) {
  const pen = $('loupe').getContext('2d'), size = 30;
  pen.imageSmoothingEnabled = false; pen.clearRect(0, 0, 240, 240);
  pen.drawImage(photograph, x * data.scale - size / 2, y * data.scale - size / 2, size, size, 0, 0, 240, 240);
  pen.strokeStyle = '#fd0'; pen.beginPath(); pen.moveTo(120, 0); pen.lineTo(120, 240); pen.moveTo(0, 120); pen.lineTo(240, 120); pen.stroke();
}

canvas.onpointerdown = e => {
  const p = inPhotograph(e);
  held = nearest(p);
  if (held < 0 && corners.length < 4) held = corners.push(p) - 1;
  if (held >= 0) canvas.setPointerCapture(e.pointerId);
  draw();
};
canvas.onpointermove = e => {
  const p = inPhotograph(e);
  if (held >= 0 && e.buttons) { corners[held] = p; draw(); }
  loupe(p);
};
canvas.onkeydown = e => {
  const way = { ArrowLeft: [-1, 0], ArrowRight: [1, 0], ArrowUp: [0, -1], ArrowDown: [0, 1] }[e.key];
  if (!corners.length || !(way || e.key === 'Backspace')) return;
  e.preventDefault();
  if (held < 0 || held >= corners.length) held = corners.length - 1;
  if (way) corners[held] = corners[held].map((v, i) => v + way[i] * (e.shiftKey ? 0.1 : 1));
  else { corners.pop(); held = corners.length - 1; }
  if (held >= 0) loupe(corners[held]);
  draw();
};
for (const button of document.querySelectorAll('[data-copy]'))
  button.onclick = () => { const range = document.createRange(); range.selectNodeContents($(button.dataset.copy)); getSelection().removeAllRanges(); getSelection().addRange(range); document.execCommand('copy'); };

photograph.src = 'data:image/png;base64,' + data.photograph; render.src = 'data:image/png;base64,' + data.render;
Promise.all([photograph.decode(), render.decode()]).then(() => {
  canvas.width = photograph.naturalWidth; canvas.height = photograph.naturalHeight;
  $('render').width = render.naturalWidth; $('render').height = render.naturalHeight;
  draw();
  canvas.dataset.ready = '1';
});
})();

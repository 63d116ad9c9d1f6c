// The viewer of one scene: ways to look, zoom, values under the cursor.
function setMode(mode) {
  const stayed = panes()[0];
  eye.mode = mode; clearInterval(eye.timer);
  if (mode === 'blink') eye.timer = setInterval(() => { eye.flip = !eye.flip; draw(); }, matchMedia('(prefers-reduced-motion: reduce)').matches ? 1500 : 600);
  for (const b of $('modes').children) b.setAttribute('aria-pressed', b.dataset.mode === mode);
  $('slide-row').hidden = mode !== 'slider';
  makeLegend();
  if (panes()[0].w !== stayed.w) keepInside();
  draw();
}
$('modes').append(...MODES.map(([mode, label, key]) => {
  const b = node('button', { type: 'button', title: `Key ${key.toUpperCase()}: ${label}`, onclick: () => setMode(mode) }, label);
  b.dataset.mode = mode;
  return b;
}));
$('map').append(...Object.entries(MAPS).map(([value, m]) => node('option', { value }, m.label)));
$('map').onchange = () => { $('scale-row').hidden = !MAPS[$('map').value].scaled; if (!['all', 'heat'].includes(eye.mode)) setMode('heat'); makeMap(); };
$('scale').onchange = () => { if (!['all', 'heat'].includes(eye.mode)) setMode('heat'); makeMap(); };
$('exposure').oninput = $('offset').oninput = () => {
  $('stops').textContent = `${+$('exposure').value > 0 ? '+' : ''}${$('exposure').value}`;
  for (const pic of [eye.o, eye.n]) if (pic && pic.fine && pic.fine.floats) expose(pic);
  draw();
};
$('in').onclick = () => zoomAt(2); $('out').onclick = () => zoomAt(0.5); $('fit').onclick = fit;
$('one').onclick = () => { eye.zoom = 1; draw(); };
$('place').onclick = () => fitTo(scenes[eye.index].place);
$('slide').oninput = e => { eye.split = e.target.value / 1000; draw(); };

function readPixel(x, y) {
  if (x < 0 || y < 0 || x >= eye.width || y >= eye.height) return;
  eye.cursor = { x, y };
  const at = y * eye.width + x, body = document.querySelector('.readout').tBodies[0].rows;
  const read = (pic, alpha, c) => {
    if (!pic || x >= pic.width || y >= pic.height) return null;
    if (c === 3) return alpha ? alpha.pixels[4 * at] : 255;
    return pic.fine ? (pic.fine.floats ? pic.fine.linear : pic.fine.codes)[3 * at + c] : pic.pixels[4 * at + c];
  };
  const floats = eye.o && eye.o.fine && eye.o.fine.floats, text = v => floats ? String(+v.toPrecision(4)) : String(+v.toFixed(2));
  for (let c = 0; c < 4; c++) {
    const o = read(eye.o, eye.oa, c), n = read(eye.n, eye.na, c);
    body[0].cells[c + 1].textContent = o === null ? '–' : text(o);
    body[1].cells[c + 1].textContent = n === null ? '–' : text(n);
    body[2].cells[c + 1].textContent = o === null || n === null ? '–' : (n > o ? '+' : '') + text(n - o);
  }
  for (const [id, pic] of [['swatch-o', eye.o], ['swatch-n', eye.n]]) $(id).style.background = pic && pic.pixels ? `rgb(${[...pic.pixels.slice(4 * at, 4 * at + 3)]})` : '';
  const s = scenes[eye.index], step = s.reduced;
  $('where').textContent = step > 1 ? `mean of ${step}×${step} pixels at ${x * step}, ${y * step}` : `pixel ${x}, ${y}`;
  $('explain').hidden = !s.file;
  $('explain').firstElementChild.textContent = `verisim explain ${quote(s.file)} ${x * step} ${y * step} +W${s.width} +H${s.height} ${s.switches.map(quote).join(' ')}`;
  const tree = (s.trees || []).find(t => Math.floor(t.x / step) === x && Math.floor(t.y / step) === y);
  $('tree').hidden = !tree; $('tree').querySelector('pre').textContent = tree ? tree.text : '';
}
const quote = t => /^[\w@%+=:,./-]+$/.test(t) ? t : `'${t.replaceAll("'", `'\\''`)}'`;
$('explain').querySelector('button').onclick = async e => {
  try { await navigator.clipboard.writeText($('explain').firstElementChild.textContent); e.target.textContent = 'Copied'; } catch { getSelection().selectAllChildren($('explain').firstElementChild); }
  setTimeout(() => { e.target.textContent = 'Copy'; }, 1500);
};
